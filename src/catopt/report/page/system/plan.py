"""The body from above, drawn to scale: anchors, lines, where they lie, the offset and the force."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from catopt.quantities import QUANTITIES
from catopt.report.page.figure import WIDTH, Figure, Frame, Legend, Point, Shape, path, shape, text
from catopt.report.page.line_drawing import grounded_ends
from catopt.report.page.system.from_above import (
    arrow,
    axes_mark,
    beside,
    cross,
    force_size,
    scale_bar,
    scaled,
    spread,
)
from catopt.report.page.system.note import SystemNote
from catopt.report.page.system.surroundings import body_words, surroundings
from catopt.report.texts import Words

if TYPE_CHECKING:
    from catopt.mooring.solution import LegState, SystemSolution

__all__ = ["plan", "plan_of"]

_EDGE = 54.0
_TALLEST = 440.0
_LEAST_TALL = 200.0
_FOOT = 112.0
"""Room around the drawing, its greatest and least height, and room for axes and scale bar."""
_BEYOND = 24.0
"""From an anchor to its number."""
_PUSH = 0.2
"""Length of the arrow of the force, over the size of the drawing."""
_ALONG = 21
"""Places of a line that answer to the pointer."""
_CLEAR = 60.0
"""An offset that is drawn as long as this is seen well enough without a second drawing."""


def plan(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the plan of the body under the note's load: as `plan_of`."""
    return plan_of(note.solution, words)


def plan_of(solution: SystemSolution, words: Words) -> dict[str, Any]:
    """Build the plan, and the surroundings of the body larger where the offset is small on it."""
    frame = _frame(solution)
    height = frame.bottom + _FOOT
    shapes = [
        *_lines(solution, frame),
        *_numbers(solution, frame),
        *_body(solution, frame),
        *_push(solution, frame),
        *axes_mark(34.0, height - 18.0),
        *scale_bar(frame, WIDTH - 30.0, height - 18.0),
    ]
    figure = Figure(
        "system_plan",
        words("system_plan.alt", count=len(solution.lines)),
        height,
        tuple(shapes),
        tuple(_points(solution, frame, words)),
        tuple(_legend(solution, words)),
    )
    offset = math.hypot(*solution.offset)
    drawn = frame.across(offset) - frame.across(0.0)
    near = surroundings(solution, words) if 0.0 < drawn < _CLEAR else None
    return {"figure": figure, "near": near}


def _frame(solution: SystemSolution) -> Frame:
    """Find the scale: everything that is drawn lies inside."""
    places = [
        *(line.leg.anchor for line in solution.lines),
        *(line.fairlead for line in solution.lines),
        (solution.neutral.x, solution.neutral.y),
    ]
    x = (min(x for x, _ in places), max(x for x, _ in places))
    y = (min(y for _, y in places), max(y for _, y in places))
    wide = WIDTH - 2.0 * _EDGE
    tall = min(max(wide * (y[1] - y[0]) / max(x[1] - x[0], 1e-9), _LEAST_TALL), _TALLEST)
    return scaled(x, y, (_EDGE, WIDTH - _EDGE, _EDGE, _EDGE + tall))


def _lines(solution: SystemSolution, frame: Frame) -> Iterator[Shape]:
    """Draw what hangs and what lies of every line, its anchor and its touchdown."""
    for line in solution.lines:
        yield path("leg", [frame.at(*line.leg.anchor), frame.at(*line.fairlead)])
        for start, end in grounded_ends(line.solution):
            yield path("lying", [frame.at(*line.at(start)), frame.at(*line.at(end))])
        if line.touchdown is not None:
            x, y = frame.at(*line.touchdown)
            yield shape("circle", "touchdown-spot", cx=x, cy=y, r=3.2)
    for line in solution.lines:
        x, y = frame.at(*line.leg.anchor)
        yield shape("path", "anchor", d=f"M {x:.2f} {y - 6:.2f} l 6 11 h -12 z")


def _numbers(solution: SystemSolution, frame: Frame) -> Iterator[Shape]:
    """Write the number of every line beyond its anchor."""
    x0, y0 = frame.at(0.0, 0.0)
    lines = solution.lines
    radii = [math.dist(frame.at(*line.leg.anchor), (x0, y0)) + _BEYOND for line in lines]
    angles = spread([line.leg.azimuth for line in lines], min(radii))
    for number, (angle, radius) in enumerate(zip(angles, radii, strict=True), start=1):
        x, y = x0 + radius * math.cos(angle), y0 - radius * math.sin(angle)
        yield text(str(number), x, y + 5.0, style=_bold(solution, number))


def _bold(solution: SystemSolution, number: int) -> str:
    return "measure loaded" if number == solution.most_loaded + 1 else "measure"


def _body(solution: SystemSolution, frame: Frame) -> Iterator[Shape]:
    """Draw the body under the load, its arms, and where it is without load."""
    x, y = frame.at(solution.position.x, solution.position.y)
    for line in solution.lines:
        if line.leg.fairlead_radius > 0.0:
            yield path("arm", [(x, y), frame.at(*line.fairlead)])
    yield shape("circle", "fairlead", cx=x, cy=y, r=6.5)
    yield from cross("neutral", *frame.at(solution.neutral.x, solution.neutral.y))


def _push(solution: SystemSolution, frame: Frame) -> Iterator[Shape]:
    """Draw the force from the body, with its size."""
    force = solution.system.force
    if not any(force):
        return
    size = math.hypot(*force)
    ux, uy = force[0] / size, -force[1] / size
    x, y = frame.at(solution.position.x, solution.position.y)
    reach = min(
        _PUSH * min(frame.right - frame.left, frame.bottom - frame.top),
        _way(x, ux, WIDTH),
        _way(y, uy, frame.bottom + _FOOT),
    )
    start = (x + 9.0 * ux, y + 9.0 * uy)
    end = (x + (reach + 9.0) * ux, y + (reach + 9.0) * uy)
    yield from arrow("push", start, end)
    yield from beside(force_size(force), start, end)


def _way(place: float, along: float, end: float) -> float:
    """Say how far an arrow may go before it leaves the paper, in one direction of it."""
    if along == 0.0:
        return math.inf
    room = end - place if along > 0.0 else place
    return (room - 20.0) / abs(along)


def _points(solution: SystemSolution, frame: Frame, words: Words) -> Iterator[Point]:
    """Say along every line what is known there, and where the body is."""
    for number, line in enumerate(solution.lines, start=1):
        yield from _along(number, line, frame, words)
    position = solution.position
    yield Point(*frame.at(position.x, position.y), body_words(solution, words))


def _along(number: int, line: LegState, frame: Frame, words: Words) -> Iterator[Point]:
    profile = line.solution.profile(_ALONG)
    for s, x, z, tension in zip(profile.s, profile.x, profile.z, profile.tension, strict=True):
        told = words(
            "system_plan.point",
            line=number,
            s=QUANTITIES["s"].format(s, unit=True),
            z=QUANTITIES["z"].format(z, unit=True),
            T=QUANTITIES["tension"].format(tension, unit=True),
        )
        yield Point(*frame.at(*line.at(x)), told)


def _legend(solution: SystemSolution, words: Words) -> Iterator[Legend]:
    lines = solution.lines
    yield Legend("anchor", words("system_plan.anchor"))
    yield Legend("leg", words("system_plan.hangs"))
    if _any_lies(lines):
        yield Legend("lying", words("line.lies"))
        yield Legend("touchdown-spot", words("tension.touchdown"))
    yield Legend("fairlead", words("system_plan.body"))
    yield Legend("neutral", words("system_plan.neutral"))
    if any(solution.system.force):
        yield Legend("push", words("system_plan.force"))


def _any_lies(lines: Sequence[LegState]) -> bool:
    return any(line.touchdown is not None for line in lines)
