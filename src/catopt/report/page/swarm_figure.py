"""How the best run of a swarm converged: its best objective over the iterations."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.page.figure import (
    Figure,
    Frame,
    Legend,
    Point,
    Shape,
    axis_titles,
    frame_in,
    line,
    path,
    shape,
    text,
    ticks,
)
from catopt.report.tables.summary import named
from catopt.report.texts import Words

if TYPE_CHECKING:
    from catopt.catenary.solution import SwarmReport

__all__ = ["swarm_figure"]

_HEIGHT = 400.0
_FOOT = 24.0
"""Of the figure, and from its frame down to where an exact 0 stands."""
_CONVERGED = 1e-9
_ROUNDING = 1e-9
"""Of a power of ten, so that 1e-9 is on the mark of -9 whatever a logarithm's last digit."""
_MOST_DECADES = 8
"""Marks of the axis that are written."""
_MOST_POINTS = 400
_POWERS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class _Scale:
    """Where an objective stands: by its power of ten, and an exact 0 below all of them."""

    frame: Frame
    foot: float | None

    def up(self, f: float) -> float:
        if f > 0.0:
            return self.frame.up(math.log10(f))
        assert self.foot is not None
        return self.foot


def swarm_figure(report: SwarmReport, words: Words) -> Figure:
    """Draw the best objective over the iterations, on a logarithmic scale.

    What is exactly 0 has no logarithm and stands on a line of its own at the foot.

    Parameters
    ----------
    report : SwarmReport
        With the history of its best run.
    words : Words
        Language.
    """
    history = report.best_objective_history
    flown = len(history)
    scale = _scale(history)
    shapes = [*_axes(scale, flown, words)]
    limit = scale.up(_CONVERGED)
    shapes.append(line("capacity", scale.frame.left, limit, scale.frame.right, limit))
    places = [(scale.frame.across(n), scale.up(f)) for n, f in enumerate(history, start=1)]
    shapes.append(path("curve first", places))
    x, y = places[-1]
    shapes.append(shape("circle", "reference", cx=x, cy=y, r=5.0))
    best = _text(words, flown, report)
    legend = (
        Legend("curve first", words("swarm.curve", run=report.best_run)),
        Legend("capacity", words("swarm.limit")),
        Legend("reference", words("swarm.end", at=best)),
    )
    notes = []
    if flown < report.iterations:
        notes.append(words("swarm.stopped", flown=flown, iterations=report.iterations))
    if scale.foot is not None:
        notes.append(words("swarm.zeros"))
    title = words("swarm.alt", f=QUANTITIES["objective"].format(history[-1], unit=True))
    points = tuple(_points(report, places, words))
    return Figure("swarm", title, _HEIGHT, tuple(shapes), points, legend, tuple(notes))


def _scale(history: Sequence[float]) -> _Scale:
    """Lay the axis out so that all of the history and the limit are in it, with whole decades."""
    powers = [math.log10(f) for f in (*history, _CONVERGED) if f > 0.0]
    low, high = math.floor(min(powers) + _ROUNDING), math.ceil(max(powers) - _ROUNDING)
    has_zero = any(f == 0.0 for f in history)
    frame = frame_in(
        _HEIGHT - (_FOOT + 10.0 if has_zero else 0.0),
        (0.0, float(max(len(history), 2))),
        (float(low), float(max(high, low + 1))),
    )
    return _Scale(frame, frame.bottom + _FOOT if has_zero else None)


def _axes(scale: _Scale, flown: int, words: Words) -> Iterator[Shape]:
    frame = scale.frame
    bottom = frame.bottom if scale.foot is None else scale.foot + 10.0
    height = bottom - frame.top
    yield shape(
        "rect", "frame", x=frame.left, y=frame.top, width=frame.right - frame.left, height=height
    )
    for n in ticks(0.0, float(max(flown, 2))):
        if n == int(n):
            at = frame.across(n)
            yield line("grid", at, frame.top, at, bottom)
            yield text(f"{n:.0f}", at, bottom + 20, style="tick")
    low, high = (int(each) for each in frame.y)
    step = max(1, math.ceil((high - low) / _MOST_DECADES))
    for power in range(high, low - 1, -step):
        at = frame.up(power)
        yield line("grid", frame.left, at, frame.right, at)
        shown = "1" if power == 0 else f"10{str(power).translate(_POWERS)}"
        yield text(shown, frame.left - 7, at + 5, anchor="end", style="tick")
    if scale.foot is not None:
        yield line("joint", frame.left, scale.foot, frame.right, scale.foot)
        yield text("0", frame.left - 7, scale.foot + 5, anchor="end", style="tick")
    quantity = named("objective", "Best objective")
    label = f"{words.name(quantity.name)} f ({quantity.field_unit})"
    yield from axis_titles(frame, words.name("Iteration"), label, below=bottom - frame.bottom)


def _points(
    report: SwarmReport, places: Sequence[tuple[float, float]], words: Words
) -> Iterator[Point]:
    """Yield iterations that answer to the pointer: all of a few, some of many, the last in any."""
    step = max(1, math.ceil(len(places) / _MOST_POINTS))
    for index in sorted({*range(0, len(places), step), len(places) - 1}):
        x, y = places[index]
        yield Point(x, y, _text(words, index + 1, report))


def _text(words: Words, iteration: int, report: SwarmReport) -> str:
    return words(
        "swarm.point",
        iteration=iteration,
        f=QUANTITIES["objective"].format(report.best_objective_history[iteration - 1], unit=True),
        T=QUANTITIES["tension"].format(report.tension_history[iteration - 1], unit=True),
    )
