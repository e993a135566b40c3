"""A flat line from the side with its heights magnified, so that its shape can be seen."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

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
from catopt.report.page.line_drawing import along, grounded_ends, loads_and_ends, touchdowns
from catopt.report.texts import Words

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution

__all__ = ["magnified"]

_FLAT = 0.2
"""Height over span below which a line to scale shows little of its shape."""
_HEIGHT = 402.0
_POINTS = 161
_BED = 0.06
"""Depth of the bed that is drawn, over the height."""


def magnified(solution: Solution, depth: float, words: Words) -> Figure | None:
    """Draw a line with its heights magnified; None for one that is steep enough.

    Parameters
    ----------
    solution : Solution
        The line.
    depth : float
        Of the water, m.
    words : Words
        Language.
    """
    profile = solution.profile(_POINTS)
    top = max(depth, *profile.z)
    low, high = min(*profile.x, 0.0), max(*profile.x, solution.span)
    if top > _FLAT * (high - low):
        return None
    spare = 0.02 * (high - low)
    frame = frame_in(_HEIGHT, (low - spare, high + spare), (-_BED * top, 1.06 * top))
    factor = (frame.up(0.0) - frame.up(1.0)) / (frame.across(1.0) - frame.across(0.0))
    x, z = QUANTITIES["x"], QUANTITIES["z"]
    shapes = [
        *_water(frame, depth),
        *axes(frame, f"{words.name(x.name)} x (m)", f"{words.name(z.name)} z (m)"),
        *_line(solution, frame),
    ]
    points = tuple(
        Point(*frame.at(x, z), along(words, s, x, z, tension))
        for s, x, z, tension in zip(profile.s, profile.x, profile.z, profile.tension, strict=True)
    )
    return Figure(
        "system_magnified",
        words("system_elevation.magnified", factor=f"{factor:.1f}"),
        _HEIGHT,
        tuple(shapes),
        points,
        tuple(_legend(solution, words)),
    )


def _water(frame: Frame, depth: float) -> Iterator[Shape]:
    surface, bed = frame.up(depth), frame.up(0.0)
    wide = frame.right - frame.left
    yield shape("rect", "water", x=frame.left, y=surface, width=wide, height=bed - surface)
    yield shape("rect", "bed", x=frame.left, y=bed, width=wide, height=frame.bottom - bed)
    yield line("surface", frame.left, surface, frame.right, surface)
    yield line("bed-edge", frame.left, bed, frame.right, bed)


def _line(solution: Solution, frame: Frame) -> Iterator[Shape]:
    for start, end in grounded_ends(solution):
        yield path("grounded", [frame.at(start, 0.0), frame.at(end, 0.0)])
    profile = solution.profile(_POINTS)
    yield path("mooring", [frame.at(x, z) for x, z in zip(profile.x, profile.z, strict=True)])
    for x, _ in touchdowns(solution):
        at, bed = frame.across(x), frame.up(0.0)
        yield line("touchdown", at, bed - 11, at, bed + 11)
    joint = 0.0
    for segment in solution.segments[:-1]:
        joint += segment.length
        x, z = place_at(solution, joint)
        across, up = frame.at(x, z)
        yield shape("circle", "joint-spot", cx=across, cy=up, r=4.0)
    yield from loads_and_ends(solution, frame)


def place_at(solution: Solution, s: float) -> tuple[float, float]:
    """Find x and z at an arc length, between the points of a fine profile; m."""
    profile = solution.profile(4 * _POINTS)
    for index, upper in enumerate(profile.s):
        if upper >= s and index:
            lower = profile.s[index - 1]
            share = (s - lower) / (upper - lower) if upper > lower else 0.0
            x = profile.x[index - 1] + share * (profile.x[index] - profile.x[index - 1])
            z = profile.z[index - 1] + share * (profile.z[index] - profile.z[index - 1])
            return x, z
    return profile.x[-1], profile.z[-1]


def _legend(solution: Solution, words: Words) -> Iterator[Legend]:
    yield Legend("mooring", words("line.hangs"))
    if grounded_ends(solution):
        yield Legend("grounded", words("line.lies"))
    if touchdowns(solution):
        yield Legend("touchdown", words("tension.touchdown"))
    if len(solution.segments) > 1:
        yield Legend("joint-spot", words("tension.joint"))
