"""The restoring curves: what it takes to hold the body at offsets along the force and across it."""

from __future__ import annotations

import math
from collections.abc import Iterator
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
)
from catopt.report.page.note import MOST_FORCE
from catopt.report.page.system.note import SystemNote
from catopt.report.page.table import Cell, Heading, Table, in_unit, measured, number_heading
from catopt.report.texts import Words

if TYPE_CHECKING:
    from catopt.mooring.restoring import RestoringCurve

__all__ = ["restoring"]

_STYLES = ("curve first", "curve second")
_HEIGHT = 422.0
_EVERY = 4
"""One point in so many stands in the table; both ends and the middle are among them."""
FORCE, OFFSET, TENSION = (QUANTITIES[key] for key in ("horizontal_force", "offset", "tension"))


def restoring(note: SystemNote, words: Words) -> dict[str, Any] | None:
    """Build the figure and its tables; None where no curve could be computed."""
    curves = note.report.curves
    if not curves:
        return None
    frame = _frame(note)
    label = in_unit(words("system_restoring.force"), FORCE)
    shapes = axes(frame, in_unit(words("system_restoring.offset"), OFFSET), label)
    shapes += _zero(frame)
    for curve, style in zip(curves, _STYLES, strict=False):
        shapes.append(path(style, [_place(curve, index, frame) for index in _drawn(note, curve)]))
    shapes += _here(note, frame)
    points = [
        Point(*_place(curve, index, frame), _point(curve, index, words))
        for curve in curves
        for index in _drawn(note, curve)
    ]
    is_whole = all(len(_drawn(note, curve)) == len(curve.offset) for curve in curves)
    notes = () if is_whole else (words("system_restoring.beyond", times=f"{MOST_FORCE:g}"),)
    figure = Figure(
        "system_restoring",
        words("system_restoring.alt"),
        _HEIGHT,
        tuple(shapes),
        tuple(points),
        tuple(_legend(note, words)),
        notes,
    )
    return {
        "figure": figure,
        "tables": [_table(curve, words) for curve in curves],
        "turns": note.solution.system.turns,
    }


def _frame(note: SystemNote) -> Frame:
    curves = note.report.curves
    drawn = [(curve, index) for curve in curves for index in _drawn(note, curve)]
    offsets = [OFFSET.to_field(curve.offset[index]) for curve, index in drawn]
    forces = [FORCE.to_field(curve.force[index]) for curve, index in drawn]
    wide, tall = max(map(abs, offsets)) or 1.0, max(map(abs, forces)) or 1.0
    return frame_in(_HEIGHT, (-1.03 * wide, 1.03 * wide), (-1.05 * tall, 1.05 * tall), left=90.0)


def _zero(frame: Frame) -> Iterator[Shape]:
    yield line("thin", frame.across(0.0), frame.top, frame.across(0.0), frame.bottom)
    yield line("thin", frame.left, frame.up(0.0), frame.right, frame.up(0.0))


def _drawn(note: SystemNote, curve: RestoringCurve) -> list[int]:
    """Choose the points that are drawn: where a line is taut, the others would be pressed flat."""
    most = MOST_FORCE * math.hypot(*note.solution.system.force) or math.inf
    return [index for index, force in enumerate(curve.force) if abs(force) <= most]


def _place(curve: RestoringCurve, index: int, frame: Frame) -> tuple[float, float]:
    return frame.at(OFFSET.to_field(curve.offset[index]), FORCE.to_field(curve.force[index]))


def _here(note: SystemNote, frame: Frame) -> Iterator[Shape]:
    """Mark the load of the case: the offset along the force, and the force."""
    force = note.solution.system.force
    size = math.hypot(*force)
    if size > 0.0:
        x, y = note.solution.offset
        along = (x * force[0] + y * force[1]) / size
        at = frame.at(OFFSET.to_field(along), FORCE.to_field(size))
        yield shape("circle", "reference", cx=at[0], cy=at[1], r=6.0)


def _towards(curve: RestoringCurve, words: Words) -> str:
    angle = QUANTITIES["angle"].format(curve.direction, unit=True)
    return words("system_restoring.towards", angle=angle)


def _point(curve: RestoringCurve, index: int, words: Words) -> str:
    response = curve.responses[index]
    return words(
        "system_restoring.point",
        towards=_towards(curve, words),
        offset=OFFSET.format(curve.offset[index], unit=True),
        along=FORCE.format(curve.force[index], unit=True),
        across=FORCE.format(curve.force_across[index], unit=True),
        T=TENSION.format(response.largest_tension, unit=True),
        line=response.most_loaded + 1,
    )


def _legend(note: SystemNote, words: Words) -> Iterator[Legend]:
    for curve, style in zip(note.report.curves, _STYLES, strict=False):
        yield Legend(style, _towards(curve, words))
    if any(note.solution.system.force):
        yield Legend("reference", words("curve.reference"))


def _table(curve: RestoringCurve, words: Words) -> Table:
    rows = tuple(
        (
            measured(OFFSET, curve.offset[index]),
            measured(FORCE, curve.force[index]),
            measured(FORCE, curve.force_across[index]),
            measured(TENSION, curve.responses[index].largest_tension),
            Cell(str(curve.responses[index].most_loaded + 1)),
        )
        for index in range(0, len(curve.offset), _EVERY)
    )
    headings = (
        number_heading(words("system_restoring.offset"), OFFSET),
        number_heading(words("system_restoring.along"), FORCE),
        number_heading(words("system_restoring.across"), FORCE),
        number_heading(words("system_watch_circle.largest"), FORCE),
        Heading(words("system_lines.in_line"), is_number=True),
    )
    return Table("restoring", headings, rows, _towards(curve, words))
