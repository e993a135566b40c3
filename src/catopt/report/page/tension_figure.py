"""Tension along the line, beside what each segment may carry."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from catopt.quantities import QUANTITIES
from catopt.report.page.capacity import allowed_tensions
from catopt.report.page.figure import (
    Figure,
    Frame,
    Legend,
    Point,
    Shape,
    axes,
    breadth,
    frame_in,
    line,
    path,
    text,
)
from catopt.report.page.line_drawing import along, touchdowns
from catopt.report.page.note import Note
from catopt.report.texts import Words

__all__ = ["FAR", "capacities", "tension_figure"]

FAR = 2.5
"""A capacity above this multiple of the largest tension would press the curve to the axis."""
_POINTS = 161
_HEIGHT = 376.0


def capacities(note: Note) -> list[float | None]:
    """Find the least tension that each segment is allowed in the load case drawn, N."""
    return allowed_tensions(note.checks, note.solution, note.load_case)


def tension_figure(note: Note, words: Words) -> dict[str, Any]:
    """Build the figure."""
    solution, quantity = note.solution, QUANTITIES["tension"]
    profile = solution.profile(_POINTS)
    allowed = capacities(note)
    largest = max(profile.tension)
    drawn = [each for each in allowed if each is not None and each <= FAR * largest]
    top = 1.08 * quantity.to_field(max([largest, *drawn])) or 1.0
    frame = frame_in(_HEIGHT, (0.0, solution.line.length), (0.0, top))
    label = f"{words.name(quantity.name)} {quantity.symbol} ({quantity.field_unit})"
    shapes = axes(frame, f"{words.name('Arc length')} s (m)", label)
    shapes += _places(note, frame)
    shapes += _capacities(note, frame, allowed, FAR * largest)
    shapes.append(
        path("curve first", [
            frame.at(s, quantity.to_field(tension))
            for s, tension in zip(profile.s, profile.tension, strict=True)
        ])
    )  # fmt: skip
    points = tuple(
        Point(*frame.at(s, quantity.to_field(tension)), along(words, s, x, z, tension))
        for s, x, z, tension in zip(profile.s, profile.x, profile.z, profile.tension, strict=True)
    )
    figure = Figure(
        "tension",
        words("tension.alt", tension=quantity.format(largest, unit=True)),
        _HEIGHT,
        tuple(shapes),
        points,
        tuple(_legend(note, words, bool(drawn))),
        tuple(_notes(words, allowed, FAR * largest)),
    )
    return {"figure": figure}


def _places(note: Note, frame: Frame) -> Iterator[Shape]:
    """Draw where one segment ends, where the line leaves the bed, and what hangs on it."""
    solution = note.solution
    start = 0.0
    for segment in solution.segments[:-1]:
        start += segment.length
        yield _upright("joint", frame, start)
    for _, s in touchdowns(solution):
        yield _upright("touchdown-at", frame, s)
    for load in solution.point_loads:
        yield _upright("load-at", frame, load.position)


def _upright(style: str, frame: Frame, s: float) -> Shape:
    return line(style, frame.across(s), frame.top, frame.across(s), frame.bottom)


def _capacities(
    note: Note, frame: Frame, allowed: list[float | None], most: float
) -> Iterator[Shape]:
    start = 0.0
    quantity = QUANTITIES["tension"]
    for segment, capacity in zip(note.solution.segments, allowed, strict=True):
        end = start + segment.length
        if capacity is not None and capacity <= most:
            left, right, level = (
                frame.across(start), frame.across(end), frame.up(quantity.to_field(capacity))
            )  # fmt: skip
            yield line("capacity", left, level, right, level)
            words = quantity.format(capacity, unit=True)
            if right - left > breadth(words):
                yield text(words, (left + right) / 2, level + 17, style="tick")
        start = end


def _notes(words: Words, allowed: list[float | None], most: float) -> Iterator[str]:
    for index, capacity in enumerate(allowed, start=1):
        if capacity is None:
            yield words("tension.unknown", number=index)
        elif capacity > most:
            shown = QUANTITIES["tension"].format(capacity, unit=True)
            yield words("tension.off_scale", number=index, capacity=shown)


def _legend(note: Note, words: Words, has_capacity: bool) -> Iterator[Legend]:
    yield Legend("curve first", words.name("Tension"))
    if has_capacity:
        yield Legend("capacity", words("tension.capacity"))
    if len(note.solution.segments) > 1:
        yield Legend("joint", words("tension.joint"))
    if touchdowns(note.solution):
        yield Legend("touchdown-at", words("tension.touchdown"))
    if note.solution.point_loads:
        yield Legend("load-at", words("tension.load"))
