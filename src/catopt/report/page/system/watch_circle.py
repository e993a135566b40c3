"""The watch circle: where the force takes the body as it goes round, and what the lines carry."""

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
from catopt.report.page.system.from_above import cross
from catopt.report.page.system.note import SystemNote
from catopt.report.page.system.surroundings import HEIGHT, disc, round_body
from catopt.report.page.table import Cell, Heading, Table, in_unit, measured, number_heading
from catopt.report.page.tension_figure import FAR
from catopt.report.texts import Words

if TYPE_CHECKING:
    from catopt.mooring.response import Response
    from catopt.mooring.watch_circle import WatchCircle

__all__ = ["allowed_at_fairlead", "watch_circle"]

_ROUND = [60.0 * k for k in range(7)]
_HEIGHT = 356.0
_ROOM = 1.25
"""Radius of the drawing over the largest offset."""
_EVERY = 10
"""One direction in so many stands in the table: 30 degrees of 120 directions."""
TENSION, OFFSET, ANGLE = QUANTITIES["tension"], QUANTITIES["offset"], QUANTITIES["angle"]


def watch_circle(note: SystemNote, words: Words) -> dict[str, Any] | None:
    """Build both figures and the table; None without a force or where it could not be computed."""
    circle = note.report.circle
    if circle is None:
        return None
    return {
        "track": _track(note, circle, words),
        "tension": _tension(note, circle, words),
        "table": _table(circle, words),
        "force": QUANTITIES["horizontal_force"].format(circle.force, unit=True),
        "turns": note.solution.system.turns,
    }


def _track(note: SystemNote, circle: WatchCircle, words: Words) -> Figure:
    """Draw where the body goes, to scale."""
    largest = circle.responses[circle.farthest].offset
    frame = disc(note.solution, _ROOM * largest)
    places = [frame.at(each.x, each.y) for each in circle.responses]
    here = frame.at(note.solution.position.x, note.solution.position.y)
    shapes = [
        *round_body(note.solution, frame),
        path("curve first", [*places, places[0]]),
        *cross("neutral", *frame.at(*circle.neutral)),
        shape("circle", "reference", cx=here[0], cy=here[1], r=6.0),
    ]
    points = [
        Point(x, y, point_words(direction, each, words))
        for (x, y), direction, each in zip(places, circle.directions, circle.responses, strict=True)
    ]
    return Figure(
        "system_watch",
        words("system_watch_circle.alt", offset=OFFSET.format(largest, unit=True)),
        HEIGHT,
        tuple(shapes),
        tuple(points),
        (
            Legend("curve first", words("system_watch_circle.track")),
            Legend("neutral", words("system_plan.neutral")),
            Legend("reference", words("curve.reference")),
            Legend("leg", words("system_plan.hangs")),
        ),
    )


def _tension(note: SystemNote, circle: WatchCircle, words: Words) -> Figure:
    """Draw the largest tension over the direction of the force."""
    values = [each.largest_tension for each in circle.responses]
    largest = max(values)
    allowed = allowed_at_fairlead(note)
    drawn = allowed if allowed is not None and allowed <= FAR * largest else None
    top = 1.08 * TENSION.to_field(max(largest, drawn or 0.0)) or 1.0
    frame = frame_in(_HEIGHT, (0.0, 360.0), (0.0, top))
    label = in_unit(words("system_watch_circle.largest"), TENSION)
    degrees = [ANGLE.to_field(direction) for direction in circle.directions]
    places = [
        frame.at(angle, TENSION.to_field(value))
        for angle, value in zip([*degrees, 360.0], [*values, values[0]], strict=True)
    ]
    shapes = axes(frame, words("system_watch_circle.direction"), label, _ROUND)
    shapes.append(path("curve first", places))
    shapes += _capacity(frame, drawn)
    force = note.solution.system.force
    shapes += _here(
        frame, math.degrees(math.atan2(force[1], force[0])) % 360.0, note.loaded.tension
    )
    legend = [
        Legend("curve first", words("system_watch_circle.largest")),
        Legend("reference", words("curve.reference")),
    ]
    if drawn is not None:
        legend.append(Legend("capacity", words("tension.capacity")))
    notes: tuple[str, ...] = ()
    if allowed is not None and drawn is None:
        notes = (words("system_watch_circle.off_scale", T=TENSION.format(allowed, unit=True)),)
    return Figure(
        "system_round",
        words("system_watch_circle.tension_alt", tension=TENSION.format(largest, unit=True)),
        _HEIGHT,
        tuple(shapes),
        tuple(
            Point(*place, point_words(direction, each, words))
            for place, direction, each in zip(
                places, circle.directions, circle.responses, strict=False
            )
        ),
        tuple(legend),
        notes,
    )


def allowed_at_fairlead(note: SystemNote) -> float | None:
    """Find the tension that the weakest line is allowed at its fairlead: MBL over the factor, N."""
    known = [leg.line.segments[-1].MBL for leg in note.solution.system.legs]
    if any(each is None for each in known):
        return None
    return min(each for each in known if each is not None) / note.solution.safety_factor


def _capacity(frame: Frame, allowed: float | None) -> Iterator[Shape]:
    if allowed is not None:
        level = frame.up(TENSION.to_field(allowed))
        yield line("capacity", frame.left, level, frame.right, level)


def _here(frame: Frame, degrees: float, tension: float) -> Iterator[Shape]:
    x, y = frame.at(degrees, TENSION.to_field(tension))
    yield shape("circle", "reference", cx=x, cy=y, r=6.0)


def point_words(direction: float, response: Response, words: Words) -> str:
    """Say what a force in a direction does."""
    return words(
        "system_watch_circle.point",
        angle=ANGLE.format(direction, unit=True),
        offset=OFFSET.format(response.offset, unit=True),
        x=OFFSET.format(response.x, unit=True),
        y=OFFSET.format(response.y, unit=True),
        T=TENSION.format(response.largest_tension, unit=True),
        line=response.most_loaded + 1,
    )


def _table(circle: WatchCircle, words: Words) -> Table:
    """Tabulate some directions, and those of the largest offset and the largest tension."""
    chosen = sorted({*range(0, len(circle.directions), _EVERY), circle.farthest, circle.hardest})
    rows = tuple(
        (measured(ANGLE, circle.directions[index]), *response_cells(circle.responses[index]))
        for index in chosen
    )
    headings = (
        number_heading(words("system_watch_circle.towards"), ANGLE),
        *response_headings(words),
    )
    return Table("watch_circle", headings, rows, words("system_watch_circle.some"))


def response_cells(response: Response | None) -> tuple[Cell, ...]:
    """Lay out where the body is and what its lines carry; dashes where it has no place of rest."""
    if response is None:
        return (*(measured(OFFSET, None) for _ in range(3)), measured(TENSION, None), Cell("–"),
                measured(QUANTITIES["grounded_length"], None))  # fmt: skip
    return (
        measured(OFFSET, response.x),
        measured(OFFSET, response.y),
        measured(OFFSET, response.offset),
        measured(TENSION, response.largest_tension),
        Cell(str(response.most_loaded + 1)),
        measured(QUANTITIES["grounded_length"], response.least_grounded),
    )


def response_headings(words: Words) -> tuple[Heading, ...]:
    """Head what `response_cells` lays out."""
    length, tension = OFFSET.field_unit, TENSION.field_unit
    return (
        Heading(f"x ({length})", is_number=True),
        Heading(f"y ({length})", is_number=True),
        Heading(f"{words('system_results.offset')} ({length})", is_number=True),
        Heading(f"{words('system_watch_circle.largest')} ({tension})", is_number=True),
        Heading(words("system_lines.in_line"), is_number=True),
        Heading(f"{words('system_line_out.least_grounded')} ({length})", is_number=True),
    )
