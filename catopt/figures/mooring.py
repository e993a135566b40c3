"""A body on its lines, and lines between points: from above, from the side, restoring curves."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain, cycle
from typing import TYPE_CHECKING

from catopt.figures.chart import (
    IN_TONNES,
    Arrow,
    Axis,
    Chart,
    Level,
    Mark,
    Place,
    Point,
    Series,
    axis,
    pointed,
)
from catopt.figures.line import FAR, grounded_ends, room_around, surface_and_bed, water
from catopt.largest import first_largest, largest
from catopt.quantities import QUANTITIES
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.layout import Profile
    from catopt.mooring.joints import Vector
    from catopt.mooring.network_rest import LinesAtRest, Position
    from catopt.mooring.restoring import RestoringCurve, WatchCircle
    from catopt.mooring.solution import SystemSolution

_ALONG = 21
"""Places of a line that answer to the pointer."""
_ROOM, _BEYOND = 0.06, 0.05
"""Round a plan, and from an anchor to its number, over the plan's size."""
_NUMBER = 0.055
"""Room that a number takes on the circle that it is on, over the same."""
_CLEAR = 0.11
"""An offset over the plan's size that is seen well enough without a second drawing."""
_ARMS = 1.35
"""Radius of what is drawn round a body, over that of its fairleads."""
_ROLES = ("first", "second", "third", "fourth")
_LENGTH = replace(QUANTITIES["offset"], symbol="")


def plan(solution: SystemSolution) -> Chart:
    """Draw anchors, lines and the body under its load from above, to scale."""
    anchors = [line.leg.anchor for line in solution.lines]
    places = [*anchors, *(line.fairlead for line in solution.lines)]
    size = size_of(places) or 1.0
    arrows = tuple(_push(solution, 0.17 * size, 0.02 * size))
    numbers = numbered(beyond(anchors, size), solution.most_loaded)
    lines = list(_lines(solution))
    numbers += [_beside(_force(solution), each.start, each.end, size, lines) for each in arrows]
    drawn = [*places, *((mark.x, mark.y) for mark in numbers), *(each.end for each in arrows)]
    points: list[Point] = []
    for k, line in enumerate(solution.lines):
        profile = line.solution.profile(_ALONG)
        points += _along(k, map(line.at, profile.x), profile)
    return Chart(
        "system_plan",
        Message("figures.plan", count=len(solution.lines)),
        *from_above(drawn, _ROOM * size),
        series=(*lines, *_arms(solution)),
        marks=(*_ends(solution), *_body(solution), *numbers),
        arrows=arrows,
        points=(*points, _body_said(solution)),
        to_scale=1.0,
    )


def size_of(places: Sequence[Place]) -> float:
    """Return the larger side of what holds places, m."""
    x, y = zip(*places, strict=True)
    return float(max(max(x) - min(x), max(y) - min(y)))


def from_above(places: Sequence[Place], room: float) -> tuple[Axis, Axis]:
    """Make axes of a drawing from above that hold places with room (m) around them."""
    ends = [(min(each) - room, max(each) + room) for each in zip(*places, strict=True)]
    least = 0.5 * max(high - low for low, high in ends)
    spare = [max(0.0, least - (high - low)) / 2.0 for low, high in ends]
    ends = [(low - more, high + more) for (low, high), more in zip(ends, spare, strict=True)]
    return Axis("x", _LENGTH, *ends[0]), Axis("y", _LENGTH, *ends[1])


def _lines(solution: SystemSolution) -> Iterator[Series]:
    for line in solution.lines:
        yield _path("leg", (line.leg.anchor, line.fairlead), Message("figures.mooring_line"))
        for start, end in grounded_ends(line.solution):
            yield _path("lying", (line.at(start), line.at(end)), Message("figures.lies"))


def _path(role: str, places: Sequence[Place], label: str = "") -> Series:
    x, y = zip(*places, strict=True)
    return Series(role, x, y, label)


def _arms(solution: SystemSolution) -> Iterator[Series]:
    for line in solution.lines:
        if line.leg.fairlead_radius > 0.0:
            yield _path("arm", (_at(solution.position), line.fairlead))


def _ends(solution: SystemSolution) -> Iterator[Mark]:
    for line in solution.lines:
        if line.touchdown is not None:
            yield Mark("touchdown-spot", *line.touchdown, Message("figures.touchdown"))
    for line in solution.lines:
        yield Mark("anchor-spot", *line.leg.anchor, Message("figures.anchor"))


def _body(solution: SystemSolution) -> Iterator[Mark]:
    yield Mark("fairlead", *_at(solution.position), Message("figures.body"))
    yield Mark("neutral", *_at(solution.neutral), Message("figures.neutral"))


def _at(position: Position) -> Place:
    return position.x, position.y


def numbered(places: Sequence[Place], loaded: int | None = None) -> list[Mark]:
    """Write the number of each line at a place; `loaded`: the most loaded one, from 0."""
    return [
        Mark("most-loaded" if k == loaded else "number", *place, words=f"{k + 1}")
        for k, place in enumerate(places)
    ]


def beyond(anchors: Sequence[Place], size: float) -> list[Place]:
    """Find places for numbers beyond anchors, clear of each other; `size` is the drawing's."""
    radii = [math.hypot(*anchor) + _BEYOND * size for anchor in anchors]
    azimuths = [math.atan2(y, x) for x, y in anchors]
    angles = spread(azimuths, _NUMBER * size / min(radii))
    return [(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)]


def _push(solution: SystemSolution, length: float, away: float) -> Iterator[Arrow]:
    """Draw the force on the body as an arrow that begins somewhat away from it."""
    force = solution.system.force
    size = math.hypot(*force)
    if size > 0.0:
        ux, uy = force[0] / size, force[1] / size
        x, y = _at(solution.position)
        start, end = ((x + way * ux, y + way * uy) for way in (away, away + length))
        yield Arrow("push", start, end, Message("figures.force_on_body"))


def _force(solution: SystemSolution) -> str:
    """Write the size of the force in four digits or so: ``"4281 kN"``."""
    size = math.hypot(*solution.system.force)
    digits = 0 if size >= 1e5 else 1
    return Message("sizing.measure", value=Measure("horizontal_force", size, digits=digits))


def _beside(words: str, start: Place, end: Place, size: float, lines: Sequence[Series]) -> Mark:
    """Write words beside a way, on the side that is farther from lines; `size` is the drawing's."""
    x, y = (start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0
    is_steep = abs(end[1] - start[1]) > abs(end[0] - start[0])
    dx, dy = (0.14 * size, 0.0) if is_steep else (0.0, 0.045 * size)
    spots = [
        (line.x[0] + k * (line.x[1] - line.x[0]) / 20, line.y[0] + k * (line.y[1] - line.y[0]) / 20)
        for line in lines
        for k in range(21)
    ]
    places = [(x + side * dx, y + side * dy) for side in (1.0, -1.0)]
    place = largest(places, lambda each: min(math.dist(each, spot) for spot in spots))
    return Mark("beside", *place, words=words)


def _along(number: int, places: Iterable[Place], profile: Profile) -> tuple[Point, ...]:
    """Say at places what is known along a line, by its number from 0."""
    x, y = zip(*places, strict=True)
    return pointed(
        "figures.along_numbered",
        x,
        y,
        line=("", [number + 1] * len(x)),
        s=("s", profile.s),
        z=("z", profile.z),
        T=("tension", profile.tension),
    )


def _body_said(solution: SystemSolution) -> Point:
    place, offset = _at(solution.position), Measure("offset", math.hypot(*solution.offset))
    x, y = (Measure("offset", each) for each in place)
    return Point(*place, Message("figures.body_at", x=x, y=y, offset=offset))


# ------------------------------------------------------------------ round the body


def near(solution: SystemSolution) -> Chart | None:
    """Draw the body and its offset larger; None where the plan shows it, or there is none."""
    offset = math.hypot(*solution.offset)
    if not 0.0 < offset < _CLEAR * size_of([line.leg.anchor for line in solution.lines]):
        return None
    reach = _reach(solution, 1.8 * offset)
    neutral, here = _at(solution.neutral), _at(solution.position)
    lines = list(_round_body(solution, reach))
    arrows = list(_push(solution, 0.36 * reach, 0.05 * reach))
    said = [(f"{Measure('offset', offset)}", neutral, here)]
    said += [(_force(solution), each.start, each.end) for each in arrows]
    beside = [_beside(*each, 2.0 * reach, lines) for each in said]
    return Chart(
        "system_near",
        Message("figures.near"),
        *_square(solution, reach),
        series=(*lines, _path("offset-mark", (neutral, here), Message("figures.way"))),
        marks=(*_body(solution), *beside, *_round_numbers(solution, reach)),
        arrows=tuple(arrows),
        points=(_body_said(solution), Point(*neutral, Message("figures.neutral"))),
        to_scale=1.0,
    )


def _reach(solution: SystemSolution, reach: float) -> float:
    """Return the radius of what is drawn round a body, m: beyond all its arms."""
    arms = max(leg.fairlead_radius for leg in solution.system.legs)
    return max(reach, _ARMS * (arms + math.hypot(*solution.offset)) if arms > 0.0 else 0.0)


def _square(solution: SystemSolution, reach: float) -> tuple[Axis, Axis]:
    x, y = _at(solution.neutral)
    return from_above([(x - reach, y - reach), (x + reach, y + reach)], 0.14 * reach)


def _round_body(solution: SystemSolution, reach: float) -> Iterator[Series]:
    """Draw what of the lines is within reach, and the arms."""
    for line, end in zip(solution.lines, _rims(solution, reach), strict=True):
        yield _path("leg", (line.fairlead, end), Message("figures.mooring_line"))
    yield from _arms(solution)


def _rims(solution: SystemSolution, reach: float) -> list[Place]:
    """Find where each line leaves the circle round the zero-load position."""
    x, y = _at(solution.neutral)
    found = []
    for line in solution.lines:
        ux, uy = math.cos(line.direction), math.sin(line.direction)
        dx, dy = line.fairlead[0] - x, line.fairlead[1] - y
        along = dx * ux + dy * uy
        way = math.sqrt(max(along * along - dx * dx - dy * dy + reach * reach, 0.0)) - along
        found.append((line.fairlead[0] + way * ux, line.fairlead[1] + way * uy))
    return found


def _round_numbers(solution: SystemSolution, reach: float) -> list[Mark]:
    """Write the numbers of the lines beyond the places where these leave the circle."""
    x, y = _at(solution.neutral)
    angles = [math.atan2(each[1] - y, each[0] - x) for each in _rims(solution, reach)]
    radius, apart = 1.07 * reach, spread(angles, 2.4 * _NUMBER)
    places = [(x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in apart]
    return numbered(places, solution.most_loaded)


def watch_track(solution: SystemSolution, circle: WatchCircle) -> Chart:
    """Draw where the body goes as the force goes round, to scale."""
    largest = circle.responses[circle.farthest].offset
    reach = _reach(solution, 1.25 * largest)
    x, y = [each.x for each in circle.responses], [each.y for each in circle.responses]
    return Chart(
        "system_watch",
        Message("figures.watch_track", offset=Measure("offset", largest)),
        *_square(solution, reach),
        series=(
            *_round_body(solution, reach),
            Series("first", [*x, x[0]], [*y, y[0]], Message("figures.places")),
        ),
        marks=(
            Mark("neutral", *circle.neutral, Message("figures.neutral")),
            Mark("reference", *_at(solution.position), Message("figures.case")),
            *_round_numbers(solution, reach),
        ),
        points=_round(circle, x, y),
        to_scale=1.0,
    )


def _round(circle: WatchCircle, x: Sequence[float], y: Sequence[float]) -> tuple[Point, ...]:
    """Say at places what is known of each direction of the force."""
    found = circle.responses
    return pointed(
        "figures.force_towards",
        x,
        y,
        angle=("angle", circle.directions),
        offset=("offset", [each.offset for each in found]),
        x=("offset", [each.x for each in found]),
        y=("offset", [each.y for each in found]),
        T=("tension", [each.largest_tension for each in found]),
        line=("", [each.most_loaded + 1 for each in found]),
    )


def watch_round(
    solution: SystemSolution, circle: WatchCircle, allowed: float | None = None
) -> Chart:
    """Draw the largest tension over the direction of the force.

    `allowed` is the tension that the weakest line may have at its fairlead, N.
    """
    values = [each.largest_tension for each in circle.responses]
    largest = max(values)
    levels, notes = [], []
    if allowed is not None and allowed <= FAR * largest:
        levels.append(Level("capacity", "y", allowed, Message("figures.allowed")))
    elif allowed is not None:
        notes.append(Message("figures.allowed_off_scale", T=Measure("tension", allowed)))
    top = 1.08 * max([largest, *(each.at for each in levels)])
    force, turn = solution.system.force, 2.0 * math.pi
    here = math.atan2(force[1], force[0]) % turn
    tension = solution.lines[solution.most_loaded].tension
    any_line = Message("figures.largest_tension_any")
    directions = tuple(math.radians(60.0 * k) for k in range(7))
    return Chart(
        "system_round",
        Message("figures.watch_round", tension=Measure("tension", largest)),
        axis("angle", (0.0, turn), Message("figures.direction"), ticks=directions),
        axis("tension", (0.0, top or 1.0), Message("figures.largest_tension"), second=IN_TONNES),
        series=(Series("first", (*circle.directions, turn), (*values, values[0]), any_line),),
        marks=(Mark("reference", here, tension, Message("figures.case")),),
        levels=tuple(levels),
        points=_round(circle, circle.directions, values),
        notes=tuple(notes),
    )


# ------------------------------------------------------------------ restoring curves


def restoring(
    curves: Sequence[RestoringCurve], solution: SystemSolution, most: float = math.inf
) -> Chart:
    """Draw the force that holds the body over its offset, a curve a direction.

    Up to `most` times the case's force.
    """
    force = math.hypot(*solution.system.force)
    limit = most * force if force > 0.0 else math.inf
    drawn = [_held(curve, limit) for curve in curves]
    points = tuple(chain.from_iterable(drawn))
    wide = 1.03 * max(abs(each.x) for each in points) or 1.0
    tall = 1.05 * max(abs(each.y) for each in points) or 1.0
    is_whole = len(points) == sum(len(curve.offset) for curve in curves)
    marks: tuple[Mark, ...] = ()
    if force > 0.0:
        (x, y), (fx, fy) = solution.offset, solution.system.force
        along = (x * fx + y * fy) / force
        marks = (Mark("reference", along, force, Message("figures.case")),)
    return Chart(
        "system_restoring",
        Message("figures.restoring"),
        axis("offset", (-wide, wide), Message("figures.offset_along")),
        axis("horizontal_force", (-tall, tall), Message("figures.force_along")),
        series=tuple(
            Series(role, [each.x for each in held], [each.y for each in held], _towards(curve))
            for role, curve, held in zip(cycle(_ROLES), curves, drawn, strict=False)
        ),
        marks=marks,
        levels=(Level("zero", "x", 0.0), Level("zero", "y", 0.0)),
        points=points,
        notes=() if is_whole else (Message("figures.beyond", times=most),),
    )


def _towards(curve: RestoringCurve) -> str:
    return Message("figures.towards", angle=Measure("angle", curve.direction))


def _held(curve: RestoringCurve, limit: float) -> tuple[Point, ...]:
    """Say what is known at the places of a curve whose force is within a limit."""
    ks = [k for k, force in enumerate(curve.force) if abs(force) <= limit]
    offsets, forces = [curve.offset[k] for k in ks], [curve.force[k] for k in ks]
    return pointed(
        "figures.held",
        offsets,
        forces,
        towards=("", [_towards(curve)] * len(ks)),
        offset=("offset", offsets),
        along=("horizontal_force", forces),
        across=("horizontal_force", [curve.force_across[k] for k in ks]),
        T=("tension", [curve.responses[k].largest_tension for k in ks]),
        line=("", [curve.responses[k].most_loaded + 1 for k in ks]),
    )


# ------------------------------------------------------------------ numbers on a circle


def spread(angles: Sequence[float], room: float) -> list[float]:
    """Move directions apart until numbers on a circle do not cover each other.

    All in rad; each stays in its place in the row, as near its own as the others let it.
    """
    if not angles:
        return []
    whole = 2.0 * math.pi
    turned = [angle % whole for angle in angles]
    order = sorted(range(len(angles)), key=turned.__getitem__)
    gaps = [(turned[k] - turned[order[place - 1]]) % whole for place, k in enumerate(order)]
    # Counter-clockwise from behind the widest gap.
    start = first_largest(gaps)
    order = order[start:] + order[:start]
    rising = [turned[k] + (whole if turned[k] < turned[order[0]] else 0.0) for k in order]
    moved = dict(zip(order, _apart(rising, min(room, whole / len(angles))), strict=True))
    return [moved[k] for k in range(len(angles))]


def _apart(values: Sequence[float], room: float) -> list[float]:
    """Move rising values apart, as little as can be: those that crowd share a mean."""
    # Less their places in the row they have to rise; what falls is pooled into its mean.
    pools: list[tuple[float, int]] = []
    for place, value in enumerate(values):
        mean, size = value - place * room, 1
        while pools and pools[-1][0] > mean:
            other, count = pools.pop()
            mean, size = (mean * size + other * count) / (size + count), size + count
        pools.append((mean, size))
    level = [mean for mean, size in pools for _ in range(size)]
    return [mean + place * room for place, mean in enumerate(level)]


_NETWORK_ALONG = 41
_NETWORK_ROOM, _AWAY = 0.08, 0.03
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
    beside = []
    for (x1, y1, _), (x2, y2, _) in _network_ends(rest):
        way = math.atan2(y2 - y1, x2 - x1)
        x = (x1 + x2) / 2.0 - _AWAY * size * math.sin(way)
        beside.append((x, (y1 + y2) / 2.0 + _AWAY * size * math.cos(way)))
    return Chart(
        "network_plan",
        Message("figures.network_plan", count=len(rest.runs)),
        *from_above([*places, *beside], _NETWORK_ROOM * size),
        series=tuple(_from_above(rest)),
        marks=(*_network_points(rest, places), *numbered(beside, loaded)),
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
        marks=(*_network_points(rest, places), *_joined(numbered(beside, loaded), unit)),
        levels=surface_and_bed(depth),
        areas=water(depth, 16.0 * unit),
        points=tuple(_said(rest, lambda x, y, z: ((x, y)[k], z))),
        to_scale=1.0,
    )


def _joined(numbers: Iterable[Mark], unit: float) -> list[Mark]:
    """Put numbers that would stand on each other, of lines behind each other, into one: "2, 4"."""
    found: list[Mark] = []
    for mark in numbers:
        for k, other in enumerate(found):
            if abs(mark.x - other.x) < 20.0 * unit and abs(mark.y - other.y) < 16.0 * unit:
                role = max(mark.role, other.role, key=lambda name: name == "most-loaded")
                found[k] = other._replace(role=role, words=f"{other.words}, {mark.words}")
                break
        else:
            found.append(mark)
    return found


def _network_ends(rest: LinesAtRest) -> Iterator[tuple[Vector, Vector]]:
    """Yield the places of both ends of each line."""
    for run in rest.runs:
        yield rest.joints.places[run.first], rest.joints.places[run.second]


def _laid(rest: LinesAtRest, number: int, x: Sequence[float]) -> list[Place]:
    """Find x and y of places of a line at horizontal distances from its first end."""
    return [rest.at(number, way) for way in x]


def _profile(rest: LinesAtRest, number: int) -> list[Vector]:
    """Find places along a line."""
    profile = rest.lines[number].profile(_NETWORK_ALONG)
    plan = _laid(rest, number, profile.x)
    return [(x, y, z) for (x, y), z in zip(plan, profile.z, strict=True)]


def _from_above(rest: LinesAtRest) -> Iterator[Series]:
    for number, (first, second) in enumerate(_network_ends(rest)):
        yield _path("leg", (first[:2], second[:2]), Message("figures.mooring_line"))
        for ends in grounded_ends(rest.lines[number]):
            yield _path("lying", _laid(rest, number, ends), Message("figures.lies"))


def _network_points(rest: LinesAtRest, places: Sequence[Place]) -> Iterator[Mark]:
    for point, place in zip(rest.network.points, places, strict=True):
        yield Mark(_SIGNS[point.kind], *place, Message(_LABELS[point.kind]))


def _said(rest: LinesAtRest, seen: Callable[[float, float, float], Place]) -> Iterator[Point]:
    """Say what is known along every line, at where its places are seen."""
    for number, line in enumerate(rest.lines):
        places = (seen(*place) for place in _profile(rest, number))
        yield from _along(number, places, line.profile(_NETWORK_ALONG))
