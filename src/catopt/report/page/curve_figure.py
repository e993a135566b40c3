"""Horizontal force and fairlead tension over the span: the load curve of the line."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from catopt.quantities import QUANTITIES
from catopt.report.page.figure import (
    Figure,
    Frame,
    Legend,
    Point,
    Shape,
    axes,
    frame_in,
    line,
    path,
    shape,
    text,
    tick_words,
    ticks,
)
from catopt.report.page.note import Note
from catopt.report.page.table import Cell, Heading, Table, measured, said, units
from catopt.report.tables.load_curve import FAIRLEAD_TENSION, FORCE, at_marks, at_points
from catopt.report.texts import Words

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve

__all__ = ["curve_figure"]

_ROWS = 15
"""Points of the curve in the table, about."""
_HEIGHT, _TOP, _OFFSETS = 420.0, 90.0, 44.0
"""Of the figure, the room above its frame, and in that room the scale of offsets."""


def curve_figure(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the figure and its tables; None where there is no curve."""
    curve = note.curve
    if curve is None:
        return None
    spans, forces, tensions = curve.outline()
    frame = _frame(spans, tensions)
    label = f"{words('curve.force')} ({FORCE.field_unit})"
    shapes = axes(frame, f"{words.name('Span')} S (m)", label, above=_OFFSETS)
    shapes += _offsets(frame, curve.reference.span, words)
    for style, values in (("curve first", forces), ("curve second", tensions)):
        places = zip(spans, values, strict=True)
        shapes.append(path(style, [frame.at(s, FORCE.to_field(v)) for s, v in places]))
    shapes += _marks(curve, frame)
    shapes += _reference(curve, frame)
    figure = Figure(
        "curve",
        words("curve.alt"),
        _HEIGHT,
        tuple(shapes),
        tuple(_points(spans, forces, tensions, frame, curve, words)),
        (
            Legend("curve first", words("curve.horizontal")),
            Legend("curve second", words("curve.tension")),
            Legend("reference", words("curve.reference")),
        ),
    )
    return {
        "figure": figure,
        "marks": _mark_table(curve, words) if curve.curve.marks else None,
        "points": _point_table(curve, words),
    }


def _frame(spans: Sequence[float], tensions: Sequence[float]) -> Frame:
    low, high = spans[0], spans[-1]
    spare = 0.03 * (high - low) or 0.01 * abs(high) or 1.0
    top = 1.06 * FORCE.to_field(max(tensions)) or 1.0
    return frame_in(_HEIGHT, (low - spare, high + spare), (0.0, top), top=_TOP)


def _offsets(frame: Frame, zero: float, words: Words) -> Iterator[Shape]:
    """Draw a second scale above: the offset from the case."""
    values = ticks(frame.x[0] - zero, frame.x[1] - zero)
    for value, shown in zip(values, tick_words(values), strict=True):
        at = frame.across(value + zero)
        yield line("thin", at, frame.top - 5, at, frame.top)
        yield text(shown, at, frame.top - 10, style="tick")
    middle = (frame.left + frame.right) / 2
    yield text(words("curve.offset"), middle, frame.top - 38, style="axis")


def _marks(curve: CaseCurve, frame: Frame) -> Iterator[Shape]:
    for number, mark in enumerate(curve.curve.marks, start=1):
        at = frame.across(mark.span)
        yield line("joint", at, frame.top, at, frame.bottom)
        level = frame.top + 14 + 24 * ((number - 1) % 5)
        yield shape("circle", "number", cx=at, cy=level, r=11.0)
        yield text(str(number), at, level + 5, style="tick")


def _reference(curve: CaseCurve, frame: Frame) -> Iterator[Shape]:
    reference = curve.reference
    if frame.x[0] <= reference.span <= frame.x[1]:
        for value in (reference.horizontal_force, reference.fairlead.tension):
            x, y = frame.at(reference.span, FORCE.to_field(value))
            yield shape("circle", "reference", cx=x, cy=y, r=6.0)


def _points(
    spans: Sequence[float],
    forces: Sequence[float],
    tensions: Sequence[float],
    frame: Frame,
    curve: CaseCurve,
    words: Words,
) -> Iterator[Point]:
    zero = curve.reference.span
    for span, force, tension in zip(spans, forces, tensions, strict=True):
        said = words(
            "curve.point",
            S=QUANTITIES["span"].format(span, unit=True),
            offset=QUANTITIES["offset"].format(span - zero, unit=True),
            H=FORCE.format(force, unit=True),
            T=FAIRLEAD_TENSION.format(tension, unit=True),
        )
        yield Point(*frame.at(span, FORCE.to_field(force)), said)


def _mark_table(curve: CaseCurve, words: Words) -> Table:
    columns = at_marks(curve)
    rows = []
    for index, mark in enumerate(curve.curve.marks):
        numbers = (measured(quantity, values[index]) for quantity, values in columns)
        rows.append((Cell(str(index + 1)), said(words.sentence(mark.event), "words"), *numbers))
    headings = (
        Heading(words("components.number")),
        Heading(words("curve.event")),
        *(units(words, quantity) for quantity, _ in columns),
    )
    return Table("marks", headings, tuple(rows), words("curve.marks"))


def _point_table(curve: CaseCurve, words: Words) -> Table:
    """Tabulate some points of the curve, both ends among them."""
    columns = at_points(curve)
    count = len(columns[0][1])
    step = max(1, round(count / _ROWS))
    chosen = sorted({*range(0, count, step), count - 1})
    rows = tuple(
        tuple(
            measured(quantity, None if values[i] != values[i] else values[i])
            for quantity, values in columns
        )
        for i in chosen
    )
    headings = tuple(units(words, quantity) for quantity, _ in columns)
    return Table("curve", headings, rows, words("curve.points"))
