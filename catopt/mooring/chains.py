"""Lines that meet two by two in joints: each row of them is one line with point loads.

A joint in which two lines end and which no force pulls hangs in one line: so the row is solved as
that one line, and its joints lie where the line has them. What is left of a network has joints of
three lines and more, or of one line.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from catopt.catenary.layout import highest_afloat
from catopt.errors import FloatsUpError, NoEquilibriumError
from catopt.model import Line, PointLoad, Segment
from catopt.model.network import LineBetween, Network
from catopt.mooring.joints import (
    Ends,
    JointsAtRest,
    Run,
    Vector,
    friction_of,
    laid_out,
    pulls_of,
    reversed_line,
    run_of,
    solved,
)
from catopt.words import Message

_LEFT = 1e-6
"""Part of the largest pull that lines of a row may leave over where friction is at work."""

_IN_WATER = 1e-9
"""Part of a line's length by which it may be above the surface from rounding."""

JOINT = "joint: "
"""Before the name of the point load that a joint of a row is."""


class Row(NamedTuple):
    """Lines that follow each other from `start` to `end`, and the joints between them, by name.

    `lines`: the number of each, from 0, and whether it was given the other way round.
    """

    start: str
    end: str
    lines: tuple[tuple[int, bool], ...]
    joints: tuple[str, ...] = ()

    def turned(self) -> Row:
        """Return the same row from its other end."""
        lines = tuple((number, not is_turned) for number, is_turned in reversed(self.lines))
        return Row(self.end, self.start, lines, self.joints[::-1])


def rows_of(network: Network, *, floats_apart: bool = False) -> tuple[Row, ...]:
    """Put lines in rows; one that ends where it began is left in two.

    `floats_apart`: floats stay joints, which they must where they come up to the surface.
    """
    rows = [Row(line.start, line.end, ((k, False),)) for k, line in enumerate(network.lines)]
    for point in network.points:
        ending = [row for row in rows if point.name in (row.start, row.end)]
        if point.kind != "joint" or len(ending) != 2 or any(point.force):
            continue
        if point.is_float and floats_apart:
            continue
        one, other = ending
        one = one if one.end == point.name else one.turned()
        other = other if other.start == point.name else other.turned()
        if one.start == other.end:
            continue
        joints = (*one.joints, point.name, *other.joints)
        first, second = (rows.index(row) for row in ending)
        rows[first] = Row(one.start, other.end, (*one.lines, *other.lines), joints)
        del rows[second]
    kinds = {point.name: point.kind for point in network.points}
    # From the anchor, where there is one: friction takes off tension towards it.
    return tuple(
        row.turned() if kinds[row.end] == "anchor" != kinds[row.start] else row for row in rows
    )


def in_rows(network: Network, rows: tuple[Row, ...]) -> Network:
    """Return the network with every row as one line."""
    between = {name for row in rows for name in row.joints}
    weights = {point.name: point.submerged_weight for point in network.points}
    lines = []
    for row in rows:
        segments: list[Segment] = []
        loads: list[PointLoad] = []
        start = 0.0
        for k, (number, is_turned) in enumerate(row.lines):
            given = network.lines[number].line
            line = reversed_line(given) if is_turned else given
            segments += line.segments
            loads += [replace(each, position=each.position + start) for each in line.point_loads]
            start += line.length
            if k < len(row.joints):
                name = row.joints[k]
                loads.append(PointLoad(start, weights[name], name=f"{JOINT}{name}"))
        names = [network.lines[number].name or f"{number + 1}" for number, _ in row.lines]
        lines.append(LineBetween(Line(segments, loads), row.start, row.end, " + ".join(names)))
    points = tuple(point for point in network.without_motion().points if point.name not in between)
    return Network(network.site, points, tuple(lines), bodies=network.bodies)


def apart(
    network: Network,
    rows: tuple[Row, ...],
    whole: Network,
    found: JointsAtRest,
    runs: Sequence[Run],
) -> tuple[tuple[Run, ...], JointsAtRest]:
    """Part rows at rest into their lines again: those of the network, in its order.

    `found` and `runs` are those of `whole`, the network in rows.
    """
    places = dict(zip((point.name for point in whole.points), found.places, strict=True))
    up = dict(zip(places, found.reactions, strict=True))
    kinds = {point.name: point.kind for point in network.points}
    parted: dict[int, tuple[Run, Ends]] = {}
    for row, run, ends in zip(rows, runs, found.ends, strict=True):
        if not row.joints:
            ((number, _),) = row.lines
            first, second = (network.numbers[whole.points[k].name] for k in (run.first, run.second))
            parted[number] = run._replace(first=first, second=second), ends
            continue
        _lay(row, run, ends, places, up)
        names = (row.start, *row.joints, row.end)
        for (number, is_turned), start, end in zip(row.lines, names, names[1:], strict=False):
            given = network.lines[number].line
            if kinds[end] == "anchor" != kinds[start] and not network.site.seabed_friction:
                start, end, is_turned = end, start, not is_turned  # every line from its anchor
            own = run_of(
                network.lines[number].name or f"{number + 1}",
                network.numbers[start],
                network.numbers[end],
                reversed_line(given) if is_turned else given,
            )
            at = {own.first: places[start], own.second: places[end]}
            parted[number] = own, solved(own, at, friction_of(whole, run), ends)
    own_runs = tuple(parted[k][0] for k in range(len(network.lines)))
    own_ends = tuple(parted[k][1] for k in range(len(network.lines)))
    everywhere = tuple(places[point.name] for point in network.points)
    check_afloat(network, places, [name for row in rows for name in row.joints])
    for run, ends in zip(own_runs, own_ends, strict=True):
        _check_in_water(network, run, ends)
    left, where = _left(network, rows, own_runs, own_ends, up)
    _check_rows(network, own_ends, left, where)
    residual = max(found.residual, left)
    reactions = tuple(up[point.name] for point in network.points)
    lost = dict(zip((point.name for point in whole.points), found.lost, strict=True))
    parted_at = found._replace(
        places=everywhere,
        ends=own_ends,
        reactions=reactions,
        residual=residual,
        lost=tuple(lost.get(point.name, 0.0) for point in network.points),
    )
    return own_runs, parted_at


def check_afloat(network: Network, places: Mapping[str, Vector], names: Iterable[str]) -> None:
    """Refuse floats of rows above the surface: they are to be joints."""
    for name in names:
        point, above = network.points[network.numbers[name]], places[name][2]
        above += (point.float_height or 0.0) - network.site.water_depth
        if point.is_float and above > 0.0:
            raise FloatsUpError(Message("mooring.joint_floats_up", name=name, above=above))


def _check_in_water(network: Network, run: Run, ends: Ends) -> None:
    """Refuse a line that its own buoyancy takes above the surface, and above what holds it."""
    line = run.line
    weights = [part.submerged_weight for part in line.segments]
    weights += [load.submerged_weight for load in line.point_loads]
    if min(weights) >= 0.0:
        return
    laid, points = laid_out(run, ends), network.points
    heights = [highest_afloat(laid.stretches)]
    loads = zip(run.line.point_loads, laid.point_loads, strict=True)
    heights += [at.z for load, at in loads if load.submerged_weight < 0.0]
    ends_at = [end for each in network.lines for end in (each.start, each.end)]
    held = [
        height
        for k, height in ((run.first, laid.anchor_height), (run.second, laid.fairlead_height))
        if any(points[k].hung) or points[k].kind != "joint" or ends_at.count(points[k].name) > 1
    ]
    above = max(heights) - max((network.site.water_depth, *held))
    if above > _IN_WATER * run.line.length:
        raise FloatsUpError(Message("mooring.line_floats_up", number=run.name, above=above))


def check_floats(
    network: Network,
    rows: tuple[Row, ...],
    whole: Network,
    found: JointsAtRest,
    runs: Sequence[Run],
) -> None:
    """Refuse rows at rest with floats above the surface; as for `apart`."""
    floats = {point.name for point in network.points if point.is_float}
    places = dict(zip((point.name for point in whole.points), found.places, strict=True))
    for row, run, ends in zip(rows, runs, found.ends, strict=True):
        if floats & {*row.joints}:
            _lay(row, run, ends, places, {})
            check_afloat(network, places, row.joints)


def _lay(row: Row, run: Run, ends: Ends, places: dict[str, Vector], up: dict[str, float]) -> None:
    """Add where the joints of a row lie and what the bed carries of them, from its line."""
    laid = laid_out(run, ends)
    at, to = places[row.start], places[row.end]
    span = math.hypot(to[0] - at[0], to[1] - at[1])
    way = ((to[0] - at[0]) / span, (to[1] - at[1]) / span) if span > 0.0 else (1.0, 0.0)
    # A joint hangs where one line ends: loads of the lines themselves hang strictly between.
    joints = [load for load in laid.point_loads if load.name.startswith(JOINT)]
    for name, load in zip(row.joints, joints, strict=True):
        x, y = at[0] + load.x * way[0], at[1] + load.x * way[1]
        places[name], up[name] = (x, y, max(load.z, 0.0)), load.seabed_reaction


def _left(
    network: Network,
    rows: tuple[Row, ...],
    runs: Sequence[Run],
    ends: Sequence[Ends],
    up: dict[str, float],
) -> tuple[float, str]:
    """Say what lines of rows leave over at the joints between them, beside bed and friction, N.

    The most, and at which joint.
    """
    left, at = 0.0, ""
    for name in (name for row in rows for name in row.joints):
        k = network.numbers[name]
        pulls = [pull for point, pull in pulls_of(runs, ends) if point == k]
        x, y, z = (math.fsum(each) for each in zip(*pulls, strict=True))
        over_bed = z - network.points[k].submerged_weight  # joints of rows have no force
        rubbed = network.site.seabed_friction * up[name]
        here = math.hypot(max(math.hypot(x, y) - rubbed, 0.0), over_bed + up[name])
        left, at = max((left, at), (here, name))
    return left, at


def _check_rows(network: Network, ends: Sequence[Ends], left: float, at: str) -> None:
    """Refuse rows whose lines, each by itself, rub on the bed otherwise than in the row.

    A load that touches the bed between two hanging parts does: what it holds is open.
    """
    largest = max(math.hypot(*pull) for each in ends for pull in (each.first, each.second))
    if network.site.seabed_friction > 0.0 and left > _LEFT * largest:
        raise NoEquilibriumError(Message("mooring.row_rubs", name=at, left=left), "force", left)
