"""The load curve: horizontal force and fairlead tension over the span."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.figures.chart import (
    IN_TONNES,
    Chart,
    Level,
    Mark,
    Scale,
    Series,
    axis,
    pointed,
    span_of,
)
from catopt.quantities import QUANTITIES
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.curve import Mark as Event
    from catopt.catenary.solution import Solution

_STEEP = 0.35
"""Part of the largest tension above which the curves are in the way of what stands at the top."""


def load_curve(curve: CaseCurve) -> Chart:
    """Draw the curve, what happens along it, and the case itself."""
    spans, forces, tensions = curve.outline()
    zero, most = curve.reference.span, max(tensions)
    offset = Message("figures.offset")
    return Chart(
        "curve",
        Message("figures.curve"),
        axis("span", span_of(spans, 0.03, 0.03), second=Scale(offset, QUANTITIES["offset"], zero)),
        axis("tension", (0.0, 1.06 * most or 1.0), Message("figures.force"), second=IN_TONNES),
        series=(
            Series("first", spans, forces, Message("figures.horizontal")),
            Series("second", spans, tensions, Message("figures.fairlead_tension")),
        ),
        marks=tuple(_reference(curve)),
        levels=tuple(_events(curve.curve.marks, most)),
        points=pointed(
            "figures.on_curve",
            spans,
            forces,
            S=("span", spans),
            offset=("offset", [span - zero for span in spans]),
            H=("horizontal_force", forces),
            T=("tension", tensions),
        ),
        notes=tuple(
            Message("figures.event", number=number, event=mark.event, H=_force(mark))
            for number, mark in enumerate(curve.curve.marks, start=1)
        ),
    )


def _force(of: Event | Solution) -> Measure:
    return Measure("horizontal_force", of.horizontal_force)


def _reference(curve: CaseCurve) -> Iterator[Mark]:
    """Mark the case itself, if it is in the range."""
    case = curve.reference
    if curve.curve.span[0] <= case.span <= curve.curve.span[-1]:
        said = Message("figures.case_at", H=_force(case))
        for value in (case.horizontal_force, case.fairlead.tension):
            yield Mark("reference", case.span, value, said)


def _events(marks: Sequence[Event], most: float) -> Iterator[Level]:
    """Yield the events by their numbers, staggered and clear of the curves."""
    above = below = 0
    for number, mark in enumerate(marks, start=1):
        if mark.fairlead_tension > _STEEP * most:
            share, below = 0.06 + 0.08 * (below % 6), below + 1
        else:
            share, above = 0.94 - 0.08 * (above % 6), above + 1
        yield Level("joint", "x", mark.span, words=str(number), share=share)
