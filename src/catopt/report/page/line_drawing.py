"""The line in the water, drawn to scale, with its dimensions."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from catopt.quantities import QUANTITIES
from catopt.report.page.figure import (
    WIDTH,
    Figure,
    Frame,
    Legend,
    Point,
    Shape,
    breadth,
    line,
    path,
    shape,
    text,
)
from catopt.report.page.note import Note
from catopt.report.page.table import called
from catopt.report.texts import Words

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution

__all__ = ["along", "drawing_of", "grounded_ends", "line_drawing", "loads_and_ends", "touchdowns"]

_LEFT, _RIGHT, _TOP = 88.0, 88.0, 44.0
_TALLEST = 460.0
"""Room for dimensions at the sides and above, and the greatest height of water drawn."""
_BED = 16.0
_ROW = 34.0
"""Thickness of the bed, and height of a row of dimensions below it."""
_ARROW = 7.0
_SHORTEST = 60.0
"""Length of an arrow, and the least length that has room for its dimension."""
_POINTS = 161


def line_drawing(note: Note, words: Words) -> dict[str, Any]:
    """Build the drawing of the line."""
    return {"figure": drawing_of(note.solution, note.case.site.water_depth, words)}


def drawing_of(solution: Solution, depth: float, words: Words) -> Figure:
    """Draw a line in water of a depth (m), to scale."""
    frame, height = _frame(solution, depth)
    shapes = [
        *_water(frame, depth, words),
        *_bed(frame),
        *_line(solution, frame),
        *_dimensions(solution, frame, depth),
        *_marks(solution, frame),
    ]
    title = words("line.alt", span=QUANTITIES["span"].format(solution.span, unit=True))
    return Figure(
        "line",
        title,
        height,
        tuple(shapes),
        tuple(_points(solution, frame, words)),
        tuple(_legend(solution, words)),
    )


def _frame(solution: Solution, depth: float) -> tuple[Frame, float]:
    """Find the scale, the same for both directions, and the height of the figure."""
    shape_ = solution.profile(_POINTS)
    low, high = min(*shape_.x, 0.0), max(*shape_.x, solution.span)
    top = max(depth, solution.fairlead_height, *shape_.z)
    wide = WIDTH - _LEFT - _RIGHT
    scale = min(wide / (high - low) if high > low else math.inf, _TALLEST / top)
    spare = (wide / scale - (high - low)) / 2.0
    tall = top * scale
    frame = Frame(_LEFT, WIDTH - _RIGHT, _TOP, _TOP + tall, (low - spare, high + spare), (0.0, top))
    rows = 2 if _dimensioned(solution, frame) else 1
    return frame, _TOP + tall + _BED + _ROW * rows + 18.0


def _water(frame: Frame, depth: float, words: Words) -> Iterator[Shape]:
    surface = frame.up(depth)
    yield shape("rect", "water", x=0.0, y=surface, width=WIDTH, height=frame.bottom - surface)
    yield line("surface", 0.0, surface, WIDTH, surface)
    # The sign of a water level: a triangle on the surface, and its name beside it.
    yield shape("path", "level", d=f"M 108 {surface - 1:.2f} l -7 -11 h 14 z")
    yield text(words("line.surface"), 122.0, surface - 6, anchor="start", style="tick")


def _bed(frame: Frame) -> Iterator[Shape]:
    yield shape("rect", "bed", x=0.0, y=frame.bottom, width=WIDTH, height=_BED)
    yield line("bed-edge", 0.0, frame.bottom, WIDTH, frame.bottom)


def _line(solution: Solution, frame: Frame) -> Iterator[Shape]:
    ends = [stretch.x for stretch in solution.stretches[1:]] + [solution.span]
    for stretch, end in zip(solution.stretches, ends, strict=True):
        if stretch.on_bed and stretch.length > 0.0:
            yield path("grounded", [frame.at(stretch.x, 0.0), frame.at(end, 0.0)])
    shape_ = solution.profile(_POINTS)
    yield path("mooring", [frame.at(x, z) for x, z in zip(shape_.x, shape_.z, strict=True)])


def _dimensions(solution: Solution, frame: Frame, depth: float) -> Iterator[Shape]:
    """Draw the span, the grounded part, the heights at the fairlead and the water depth."""
    row = frame.bottom + _BED + _ROW - 8.0
    left, right = frame.across(0.0), frame.across(solution.span)
    for start, end in _dimensioned(solution, frame):
        a, b = frame.across(start), frame.across(end)
        yield from _across(a, b, row, frame.bottom, QUANTITIES["span"].format(end - start))
    if _dimensioned(solution, frame):
        row += _ROW
    yield from _across(left, right, row, frame.bottom, _metres("S", solution.span))
    fairlead = solution.fairlead_height
    yield from _upright(
        frame.up(fairlead), frame.bottom, WIDTH - 36.0, right, _metres("", fairlead)
    )
    if not math.isclose(depth, fairlead, rel_tol=1e-9):
        yield from _upright(frame.up(depth), frame.bottom, 30.0, None, _metres("", depth))
    if solution.anchor_height > 0.0:
        top = frame.up(solution.anchor_height)
        yield from _upright(
            top, frame.bottom, left - 24.0, left, _metres("", solution.anchor_height)
        )


def _metres(symbol: str, value: float) -> str:
    words = QUANTITIES["span"].format(value, unit=True)
    return f"{symbol} = {words}" if symbol else words


def _across(left: float, right: float, y: float, above: float, words: str) -> Iterator[Shape]:
    """Draw a dimension between two places, with lines down to it."""
    for x in (left, right):
        yield line("thin", x, above, x, y + 5)
    yield line("dimension", left, y, right, y)
    if right - left > 3 * _ARROW:
        yield shape("path", "arrow", d=f"M {left:.2f} {y:.2f} l {_ARROW} -3.5 v 7 z")
        yield shape("path", "arrow", d=f"M {right:.2f} {y:.2f} l -{_ARROW} -3.5 v 7 z")
    half = breadth(words) / 2
    middle = min(max((left + right) / 2, half), WIDTH - half)
    yield text(words, middle, y - 6, style="measure")


def _upright(
    top: float, bottom: float, x: float, start: float | None, words: str
) -> Iterator[Shape]:
    """Draw a height, with a line from where it is measured."""
    if start is not None:
        yield line("thin", start, top, x + (5 if x > start else -5), top)
    yield line("dimension", x, top, x, bottom)
    if bottom - top > 3 * _ARROW:
        yield shape("path", "arrow", d=f"M {x:.2f} {top:.2f} l -3.5 {_ARROW} h 7 z")
        yield shape("path", "arrow", d=f"M {x:.2f} {bottom:.2f} l -3.5 -{_ARROW} h 7 z")
    if bottom - top > breadth(words):
        yield text(words, x - 6, (top + bottom) / 2, style="measure", turn=-90)
    else:
        # From the edge of the figure inwards, so that large type stays inside.
        if x > WIDTH / 2:
            yield text(words, WIDTH - 2, top - 15, anchor="end", style="measure")
        else:
            yield text(
                words, 2.0 if start is None else x - 14, top - 15, anchor="start", style="measure"
            )


def grounded_ends(solution: Solution) -> list[tuple[float, float]]:
    """Find where the line lies on the bed: from and to, m; parts that touch are one."""
    ends = [stretch.x for stretch in solution.stretches[1:]] + [solution.span]
    found: list[tuple[float, float]] = []
    for stretch, end in zip(solution.stretches, ends, strict=True):
        if stretch.on_bed and end > stretch.x:
            start = stretch.x
            if found and math.isclose(found[-1][1], start, abs_tol=1e-9 * max(end, 1.0)):
                start = found.pop()[0]
            found.append((start, end))
    return found


def _dimensioned(solution: Solution, frame: Frame) -> list[tuple[float, float]]:
    """Find the parts on the bed that are long enough on the drawing for a dimension."""
    return [
        (start, end)
        for start, end in grounded_ends(solution)
        if frame.across(end) - frame.across(start) > _SHORTEST
    ]


def touchdowns(solution: Solution) -> list[tuple[float, float]]:
    """Find where the line leaves the bed: x and arc length, m."""
    real = [stretch for stretch in solution.stretches if stretch.length > 0.0]
    return [
        (upper.x, upper.start) for lower, upper in pairwise(real) if lower.on_bed != upper.on_bed
    ]


def _marks(solution: Solution, frame: Frame) -> Iterator[Shape]:
    for x, _ in touchdowns(solution):
        at = frame.across(x)
        yield line("touchdown", at, frame.bottom - 11, at, frame.bottom + 11)
    yield from loads_and_ends(solution, frame)


def loads_and_ends(solution: Solution, frame: Frame) -> Iterator[Shape]:
    """Draw what hangs on the line, its anchor and its fairlead."""
    for load, weight in _weights(solution):
        x, z = frame.at(load.x, load.z)
        if weight >= 0.0:
            yield shape("rect", "clump", x=x - 7, y=z - 7, width=14.0, height=14.0)
        else:
            yield shape("circle", "buoy", cx=x, cy=z, r=7.0)
    x, z = frame.at(0.0, solution.anchor_height)
    yield shape("path", "anchor", d=f"M {x:.2f} {z - 9:.2f} l 9 16 h -18 z")
    x, z = frame.at(solution.span, solution.fairlead_height)
    yield shape("circle", "fairlead", cx=x, cy=z, r=6.0)


def _weights(solution: Solution) -> list[tuple[Any, float]]:
    loads = solution.line.point_loads
    return [
        (state, load.submerged_weight)
        for state, load in zip(solution.point_loads, loads, strict=True)
    ]


def along(words: Words, s: float, x: float, z: float, tension: float) -> str:
    """Say what is known at a point of the line."""
    shown = QUANTITIES
    return words(
        "line.point",
        s=shown["s"].format(s, unit=True),
        x=shown["x"].format(x, unit=True),
        z=shown["z"].format(z, unit=True),
        T=shown["tension"].format(tension, unit=True),
    )


def _points(solution: Solution, frame: Frame, words: Words) -> Iterator[Point]:
    shape_ = solution.profile(_POINTS)
    for s, x, z, tension in zip(shape_.s, shape_.x, shape_.z, shape_.tension, strict=True):
        yield Point(*frame.at(x, z), along(words, s, x, z, tension))


def _legend(solution: Solution, words: Words) -> Iterator[Legend]:
    angle = QUANTITIES["angle"].format(solution.anchor.angle, unit=True)
    yield Legend("anchor", words("line.anchor", angle=angle))
    yield Legend("fairlead", words("line.fairlead"))
    yield Legend("mooring", words("line.hangs"))
    if any(stretch.on_bed and stretch.length > 0.0 for stretch in solution.stretches):
        yield Legend("grounded", words("line.lies"))
    for x, _ in touchdowns(solution):
        yield Legend("touchdown", words("line.touchdown", x=QUANTITIES["x"].format(x, unit=True)))
    for load, weight in _weights(solution):
        shown = QUANTITIES["point_weight"].format(abs(weight), unit=True)
        place = QUANTITIES["position"].format(load.position, unit=True)
        key = "line.clump" if weight >= 0.0 else "line.buoy"
        style = "clump" if weight >= 0.0 else "buoy"
        name = called(words, weight, load.name)
        yield Legend(style, words(key, name=name, weight=shown, s=place))
