"""Lines between points: from above, and all from the side."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.figures.chart import Axis, Chart, Mark, Place, Point, Series, axis, pointed
from catopt.figures.line import grounded_ends, room_around, surface_and_bed, water
from catopt.figures.mooring import from_above, size_of
from catopt.quantities import QUANTITIES
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.mooring.held import LinesAtRest
    from catopt.mooring.line_ends import Vector

_LENGTH = replace(QUANTITIES["offset"], symbol="")
_ALONG = 41
_ROOM, _AWAY = 0.08, 0.03
"""Round a drawing, and from a line to its number, over the drawing's size."""
_SIGNS = {"anchor": "anchor-spot", "fairlead": "fairlead", "joint": "joint-spot"}
_LABELS = {
    "anchor": "figures.anchor",
    "fairlead": "figures.fairlead",
    "joint": "figures.free_joint",
}


def network_plan(rest: LinesAtRest, loaded: int) -> Chart:
    """Draw points and lines from above, to scale; `loaded`: the most loaded line, from 0."""
    places = [(x, y) for x, y, _ in rest.joints.places]
    size = size_of(places) or 1.0
    middles = [((x1 + x2) / 2.0, (y1 + y2) / 2.0) for (x1, y1, _), (x2, y2, _) in _ends(rest)]
    ways = [math.atan2(y2 - y1, x2 - x1) for (x1, y1, _), (x2, y2, _) in _ends(rest)]
    beside = [
        (x - _AWAY * size * math.sin(way), y + _AWAY * size * math.cos(way))
        for (x, y), way in zip(middles, ways, strict=True)
    ]
    return Chart(
        "network_plan",
        Message("figures.network_plan", count=len(rest.runs)),
        *from_above([*places, *beside], _ROOM * size),
        series=tuple(_from_above(rest)),
        marks=(*_points(rest, places), *_numbers(beside, loaded)),
        points=tuple(_said(rest, lambda x, y, _: (x, y))),
        to_scale=1.0,
    )


def network_side(rest: LinesAtRest, loaded: int) -> Chart:
    """Draw all lines as seen across the longer side of their plan, to scale."""
    wide, deep = (size_of([(place[k], 0.0) for place in rest.joints.places]) for k in (0, 1))
    k = 0 if wide >= deep else 1
    depth = rest.network.site.water_depth
    places = [(place[k], place[2]) for place in rest.joints.places]
    drawn = [_profile(rest, number) for number in range(len(rest.runs))]
    across = [place[k] for line in drawn for place in line]
    heights = [place[2] for line in drawn for place in line]
    top, left, right = max(depth, *heights), min(across), max(across)
    unit = room_around(right - left, top)
    middles = [line[len(line) // 2] for line in drawn]
    beside = [(place[k], place[2] + 14.0 * unit) for place in middles]
    lines = (
        Series(
            "mooring",
            [place[k] for place in line],
            [place[2] for place in line],
            Message("figures.mooring_line"),
        )
        for line in drawn
    )
    return Chart(
        "network_side",
        Message("figures.network_side", axis="xy"[k]),
        Axis("xy"[k], _LENGTH, left - 40.0 * unit, right + 40.0 * unit),
        axis("z", (-24.0 * unit, top + 30.0 * unit), within=(0.0, top)),
        series=tuple(lines),
        marks=(*_points(rest, places), *_numbers(beside, loaded)),
        levels=surface_and_bed(depth),
        areas=water(depth, 16.0 * unit),
        points=tuple(_said(rest, lambda x, y, z: ((x, y)[k], z))),
        to_scale=1.0,
    )


def _ends(rest: LinesAtRest) -> Iterator[tuple[Vector, Vector]]:
    """Yield the places of both ends of each line."""
    for run in rest.runs:
        yield rest.joints.places[run.first], rest.joints.places[run.second]


def _laid(rest: LinesAtRest, number: int, x: Sequence[float]) -> list[Place]:
    """Find x and y of places of a line at horizontal distances from its first end."""
    run = rest.runs[number]
    (x1, y1, _), (x2, y2, _) = rest.joints.places[run.first], rest.joints.places[run.second]
    span = math.hypot(x2 - x1, y2 - y1)
    ux, uy = ((x2 - x1) / span, (y2 - y1) / span) if span > 0.0 else (1.0, 0.0)
    return [(x1 + way * ux, y1 + way * uy) for way in x]


def _profile(rest: LinesAtRest, number: int) -> list[Vector]:
    """Find places along a line."""
    profile = rest.lines[number].profile(_ALONG)
    plan = _laid(rest, number, profile.x)
    return [(x, y, z) for (x, y), z in zip(plan, profile.z, strict=True)]


def _from_above(rest: LinesAtRest) -> Iterator[Series]:
    for number, ((x1, y1, _), (x2, y2, _)) in enumerate(_ends(rest)):
        yield Series("leg", (x1, x2), (y1, y2), Message("figures.mooring_line"))
        for ends in grounded_ends(rest.lines[number]):
            x, y = zip(*_laid(rest, number, ends), strict=True)
            yield Series("lying", x, y, Message("figures.lies"))


def _points(rest: LinesAtRest, places: Sequence[Place]) -> Iterator[Mark]:
    for point, place in zip(rest.network.points, places, strict=True):
        yield Mark(_SIGNS[point.kind], *place, Message(_LABELS[point.kind]))


def _numbers(places: Sequence[Place], loaded: int) -> list[Mark]:
    """Write the number of each line at a place."""
    return [
        Mark("most-loaded" if k == loaded else "number", *place, words=f"{k + 1}")
        for k, place in enumerate(places)
    ]


def _said(rest: LinesAtRest, seen: Callable[[float, float, float], Place]) -> Iterator[Point]:
    """Say what is known along every line, at where its places are seen."""
    for number, line in enumerate(rest.lines):
        profile = line.profile(_ALONG)
        x, y = zip(*(seen(*place) for place in _profile(rest, number)), strict=True)
        along = {"s": ("s", profile.s), "z": ("z", profile.z), "T": ("tension", profile.tension)}
        numbers = [number + 1] * len(x)
        yield from pointed("figures.along_numbered", x, y, line=("", numbers), **along)
