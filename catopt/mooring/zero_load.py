"""A body on lines of its own, as the kernel takes it: at rest without load, from there under any.

It moves along x and y, and in yaw, counted as the way of its longest arm; what it does not move by
is pinned. The first point of line k is its anchor, point 2 k, the second its fairlead.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Final, NamedTuple

from catopt.catenary.pieces import Pieces, cut
from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_SHORT
from catopt.errors import CatoptError, NoEquilibriumError, NotConvergedError
from catopt.model.system import System
from catopt.mooring.heading import next_heading, rest_at_heading
from catopt.mooring.net import FREE, PINNED, TURNS, Known, Net, hang, room_for, state_of
from catopt.mooring.rest import TURNS_OVER, Found, remember
from catopt.progress import expect
from catopt.words import Message

Matrix = tuple[tuple[float, float, float], ...]

_SHORT_OF_TAUT: Final = 0.999
"""Part of its length over which a line that does not stretch may reach at the start."""

_HANGS_OF_A_TURN: Final = 300
"""How often the lines are solved as a body goes round, roughly: 36 strides, some steps in each."""

_SAME_YAW: Final = 1e-3
"""rad, within which two headings are one, at its largest moment a body being all but loose in yaw.
"""

_LOOSE: Final = 1e-9
"""Of the largest stiffness: less is rounding."""


class Lines(NamedTuple):
    """What is known of each line where the body is at rest.

    H and V at the fairlead (N), span and length on the bed (m), forces on the anchor (N).
    """

    H: list[float]
    V: list[float]
    span: list[float]
    grounded: list[float]
    H_anchor: list[float]
    V_anchor: list[float]


class BodyRest(NamedTuple):
    """Where the body came to rest (m, m, rad; the yaw above -pi and up to pi), in so many steps.

    The errors are what is left unbalanced, N and N m; `pull` is the force of all lines on the body
    (N, N, N m), `stiffness` minus its derivatives by x, y and yaw: N/m, N/rad, N m/rad.
    """

    x: float
    y: float
    yaw: float
    steps: int
    force_error: float
    moment_error: float
    pull: tuple[float, float, float]
    stiffness: Matrix


def net_of(system: System) -> Net:
    """Lay out a system without its load as lists of plain numbers."""
    legs, count = system.legs, len(system.legs)
    piece, columns = [0], Pieces([], [], [], [])
    for leg in legs:
        pieces, _ = cut(leg.line)
        piece.append(piece[-1] + len(pieces.length))
        for column, own in zip(columns, pieces, strict=True):
            column.extend(own)
    heights = [(float(leg.anchor_height), float(leg.fairlead_height)) for leg in legs]
    ends = zip(legs, heights, strict=True)
    return Net(
        used=[count],
        first=list(range(0, 2 * count, 2)),
        second=list(range(1, 2 * count, 2)),
        piece=piece,
        length=columns.length,
        weight=columns.weight,
        compliance=columns.compliance,
        load=columns.load,
        friction=[float(system.seabed_friction)] * count,
        base=[x for leg, (low, high) in ends for x in (*leg.anchor, low, 0.0, 0.0, high)],
        freedom=[-1, -1, -1, -1, 0, 1, -1, 2] * count,
        arm=[x for leg in legs for x in (0.0, 0.0, *leg.fairlead)],
        pull=[0.0] * 3,
        scale=[1.0, 1.0, max(leg.fairlead_radius for leg in legs) or 1.0],
        kind=[FREE, FREE, TURNS if system.turns else PINNED],
        group=[0, 3],
        surface=[math.inf] * 3,
        buoyancy=[0.0] * 3,
        height=[0.0] * 3,
    )


@dataclass(frozen=True)
class ZeroLoadPosition:
    """A system (its load plays no part), and its lines as numbers, at rest in `neutral`."""

    system: System
    net: Net
    known: Known
    neutral: BodyRest

    def under(self, force: Sequence[float], moment: float = 0.0) -> tuple[BodyRest, Lines]:
        """Bring the body to rest under a load, N and N m; errors as for `solve_system`."""
        net, known = self.as_numbers(force, moment)
        found = rest_at_heading(net, known, (CONVERGED, -1))
        if found.status == TURNS_OVER:
            raise _turns_over(moment, found.left * net.scale[2])
        return _checked(found, self.system, net, known), lines_of(net, known)

    def as_numbers(
        self, force: Sequence[float] = (0.0, 0.0), moment: float = 0.0
    ) -> tuple[Net, Known]:
        """Copy its lines as numbers, with a load on the body, and what is known of them."""
        pull = [float(force[0]), float(force[1]), float(moment) / self.net.scale[2]]
        return self.net._replace(pull=pull, kind=[*self.net.kind]), _copied(self.known)

    def other_headings(
        self, rest: BodyRest, force: Sequence[float], moment: float = 0.0
    ) -> tuple[BodyRest, ...]:
        """Find where else the body would rest, at another yaw, under the load it rests under.

        None is looked for where the lines do not hold the body.
        """
        if not self.system.turns or not self.is_held(rest):
            return ()
        net, known = self.as_numbers(force, moment)
        arm, total = net.scale[2], len(self.system.legs)
        known.q[:] = [rest.x, rest.y, rest.yaw * arm]
        began = perf_counter()
        hang(net, known, False)
        expect(
            Message("words.other_headings", total=total),
            _HANGS_OF_A_TURN * (perf_counter() - began),
        )
        others: list[BodyRest] = []
        at, end = rest.yaw, rest.yaw + 2.0 * math.pi - _SAME_YAW
        while True:
            found = next_heading(net, known, end - at)
            at = known.q[2] / arm
            if found.status != CONVERGED or at >= end:
                return tuple(others)
            other = _read(found, net, known)
            if at > rest.yaw + _SAME_YAW and self.is_held(other):
                others.append(other)

    def held(self, x: float, y: float) -> tuple[BodyRest, Lines]:
        """Hold the body at a place, m; it still turns where it is free to, under no moment.

        An error when a line does not reach there, or has no answer.
        """
        net, known = self.as_numbers()
        net.kind[:2] = PINNED, PINNED
        known.q[:2] = x, y
        found = rest_at_heading(net, known, hang(net, known, False))
        return _checked(found, self.system, net, known), lines_of(net, known)

    def is_held(self, rest: BodyRest) -> bool:
        """Whether the lines hold the body against a push from any side, and a turn if it is free.

        The yaw's stiffness is that with x and y following.
        """
        return holds(rest.stiffness, self.net.scale[2] if self.system.turns else None)


def holds(stiffness: Sequence[Sequence[float]], arm: float | None) -> bool:
    """Whether a stiffness by x, y and yaw holds a body; its yaw where it has an arm, m.

    Of the largest stiffness there, and of that on the arm, less than 1e-9 holds nothing.
    """
    (xx, xy, xm), (_, yy, ym), (_, _, mm) = stiffness
    trace, plane = xx + yy, xx * yy - xy * xy
    least = _LOOSE * max(trace, 1e-300)
    if plane <= least * trace:
        return False
    by_following = (yy * xm * xm - 2.0 * xy * xm * ym + xx * ym * ym) / plane
    return arm is None or mm - by_following > least * arm**2


def lines_of(net: Net, known: Known) -> Lines:
    """Read what is known of each line."""
    states = [state_of(k, known) for k in range(net.used[0])]
    return Lines(*([getattr(state, name) for state in states] for name in Lines._fields))


def _read(found: Found, net: Net, known: Known) -> BodyRest:
    """Say where the body is at rest."""
    scale, left, rows = net.scale, known.left, known.stiffness
    # What is left over has the load in it, and what is pinned carries what there is.
    pull = [(left[i] - known.laid[i] - net.pull[i]) * scale[i] for i in range(3)]
    stiffness = tuple(
        tuple(rows[3 * i + j] * scale[i] * scale[j] for j in range(3)) for i in range(3)
    )
    return BodyRest(
        known.q[0],
        known.q[1],
        within_half_a_turn(known.q[2] / scale[2]),
        found.steps,
        math.hypot(left[0], left[1]),
        abs(left[2]) * scale[2],
        tuple(pull),
        stiffness,
    )


def within_half_a_turn(yaw: float) -> float:
    """Name a yaw by one above -pi and up to pi, rad."""
    if not (yaw <= -math.pi or yaw > math.pi):
        return yaw
    return yaw - 2.0 * math.pi * math.ceil((yaw - math.pi) / (2.0 * math.pi))


def _checked(found: Found, system: System, net: Net, known: Known) -> BodyRest:
    """Say where the body is at rest, or what stops it from coming to rest."""
    if found.status == CONVERGED:
        return _read(found, net, known)
    number, (x, y, _) = found.number, known.q
    if number < 0 or found.status == NOT_CONVERGED:
        key = "mooring.not_at_rest" if number < 0 else "mooring.not_at_rest_for_line"
        values = {"steps": found.steps, "x": x, "y": y, "number": number + 1}
        raise NotConvergedError(Message(key, **values))
    assert found.status == TOO_SHORT
    anchor, fairlead = (known.place[at : at + 3] for at in (6 * number, 6 * number + 3))
    missing = math.dist(anchor, fairlead) - system.legs[number].line.length
    values = {"number": number + 1, "span": math.dist(anchor[:2], fairlead[:2]), "missing": missing}
    raise NoEquilibriumError(Message("mooring.too_short", **values), "length", missing)


def _turns_over(moment: float, missing: float) -> CatoptError:
    """Say that the lines cannot carry a moment (N m), and the largest that they carry."""
    # Over a full turn the moment of the lines has a mean of zero: below that is rounding.
    largest = max(abs(moment) - missing, 0.0)
    values = {"moment": moment, "largest": largest, "missing": missing}
    return NoEquilibriumError(Message("mooring.turns_over", **values), "moment", missing)


def zero_load_position(system: System) -> ZeroLoadPosition:
    """Find the zero-load position, starting from the origin with yaw 0.

    NoEquilibriumError when lines that do not stretch are too short to reach the body together.
    """
    net = net_of(system)
    known = room_for(net)
    known.q[:2] = _reachable(system)
    neutral = _checked(rest_at_heading(net, known, hang(net, known, False)), system, net, known)
    remember(net, known)
    return ZeroLoadPosition(system, net, known, neutral)


def _copied(known: Known) -> Known:
    return Known(*(list(column) for column in known))


def _reachable(system: System) -> tuple[float, float]:
    """Find a place that every line which does not stretch can reach, at or near the origin; m.

    The reach of each is a disc round its anchor; projecting on one after the other leads into
    what they share, if they share anything.
    """
    discs = []
    for index, leg in enumerate(system.legs):
        if all(segment.is_inextensible for segment in leg.line.segments):
            rise = leg.fairlead_height - leg.anchor_height
            left = leg.line.length**2 - rise**2
            if left <= 0.0:
                length, missing = leg.line.length, abs(rise) - leg.line.length
                values = {"length": length, "rise": abs(rise), "missing": missing}
                said = Message("mooring.too_short_to_hang", number=index + 1, **values)
                raise NoEquilibriumError(said, "length", missing)
            centre = (leg.anchor[0] - leg.fairlead[0], leg.anchor[1] - leg.fairlead[1])
            discs.append((index, centre, math.sqrt(left)))
    x, y = 0.0, 0.0
    for _ in range(1000):
        worst, worst_line = 0.0, -1
        for index, (cx, cy), reach in discs:
            distance = math.hypot(x - cx, y - cy)
            if distance >= reach:
                if distance - reach >= worst:
                    worst, worst_line = distance - reach, index
                share = _SHORT_OF_TAUT * reach / distance
                x, y = cx + share * (x - cx), cy + share * (y - cy)
        if worst_line < 0:
            return x, y
    said = Message("mooring.none_reach", number=worst_line + 1, missing=worst)
    raise NoEquilibriumError(said, "length", worst)
