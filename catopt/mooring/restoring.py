"""Restoring curves, and the watch circle: where a force of one size takes the body."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from catopt.errors import refused
from catopt.model.kinds import Angle, Findings, Force, Height, Place, SomeForce, Strength
from catopt.model.network import Network
from catopt.model.system import System
from catopt.mooring.balance import Lines
from catopt.mooring.descent import Rest
from catopt.mooring.held import at_rest, without_load
from catopt.mooring.joints import pulls_of
from catopt.mooring.network_rest import LinesAtRest
from catopt.mooring.static_equilibrium import ZeroLoadPosition, zero_load_position
from catopt.patience import paced
from catopt.records import Counted, Record
from catopt.shown import Tabled
from catopt.ties import first_largest
from catopt.words import Message


@dataclass(frozen=True)
class Response(Record):
    """One place of rest of the body; in Python lines count from 0."""

    DOCUMENT = (
        "x y yaw offset largest_tension most_loaded+1=most_loaded_line largest_anchor_tension "
        "largest_uplift=largest_anchor_vertical_force_N least_grounded=least_grounded_length_m"
    )

    x: Place
    """Position of the body."""
    y: Place
    """Position of the body."""
    yaw: Angle
    """Counter-clockwise."""
    offset: Height
    """Distance from the zero-load position."""
    largest_tension: SomeForce
    """At a fairlead."""
    most_loaded: int
    """The line that carries it, the first of several alike, in the system as given."""
    largest_anchor_tension: SomeForce
    """Of any line."""
    largest_uplift: Force
    """Largest on an anchor; 0 or less where none is pulled up."""
    least_grounded: Height
    """Shortest on the bed of any line, unstretched."""


def network_response(rest: LinesAtRest, moved: tuple[float, float] | None = None) -> Response:
    """Sum a network up; tensions are those at either end of a line.

    `moved`: by how much what is held is, m; None: of its one free body.
    """
    ends = rest.joints.ends
    tensions = [max(math.hypot(*each.first), math.hypot(*each.second)) for each in ends]
    anchored = [each.first for k, each in enumerate(ends) if rest.is_anchored(k)]
    if moved is None:
        (body,) = rest.bodies
        place, offset = (body.position.x, body.position.y, body.position.yaw), body.offset
    else:
        place, offset = (*moved, 0.0), moved
    return Response(
        *place,
        offset=math.hypot(*offset),
        largest_tension=max(tensions),
        most_loaded=first_largest(tensions),
        largest_anchor_tension=max((math.hypot(*each) for each in anchored), default=0.0),
        largest_uplift=max((each[2] for each in anchored), default=0.0),
        least_grounded=min(each.state.grounded for each in ends),
    )


def response_of(
    zero_load: ZeroLoadPosition, rest: Rest, lines: Lines, zero: Rest | None = None
) -> Response:
    """Sum a place of rest up; the offset is from `zero`, by default the zero-load position."""
    start = zero_load.neutral if zero is None else zero
    tensions = [math.hypot(H, V) for H, V in zip(lines.H, lines.V, strict=True)]
    return Response(
        x=rest.x,
        y=rest.y,
        yaw=rest.yaw,
        offset=math.hypot(rest.x - start.x, rest.y - start.y),
        largest_tension=max(tensions),
        most_loaded=first_largest(tensions),
        largest_anchor_tension=max(map(math.hypot, lines.H_anchor, lines.V_anchor)),
        largest_uplift=max(lines.V_anchor),
        least_grounded=min(lines.grounded),
    )


@dataclass(frozen=True)
class RestoringCurve(Record):
    """Force and offset of a body along one direction."""

    DOCUMENT = "direction offset force force_across largest_tension most_loaded_line"

    system: System | Network
    """The lines; its own load plays no part."""
    direction: Angle
    """Counter-clockwise from x."""
    is_held: bool
    """Whether the body is held on the line along the direction (`restoring_curve`), or free and
    pushed along it (`offset_curve`)."""
    offset: tuple[Place, ...]
    """Of the body along the direction, from the zero-load position; of what is held between points
    from where it is given."""
    across: tuple[Place, ...]
    """Across it, a quarter turn counter-clockwise; all 0 where it is held."""
    force: tuple[Force, ...]
    """On the body along the direction."""
    force_across: tuple[Force, ...]
    """That it takes across to hold it, a quarter turn counter-clockwise; all 0 where it is free."""
    responses: tuple[Response, ...]
    """The body and its lines at each point."""

    @property
    def largest_tension(self) -> tuple[SomeForce, ...]:
        """At a fairlead, of lines between points at either end."""
        return tuple(each.largest_tension for each in self.responses)

    @property
    def most_loaded_line(self) -> tuple[Counted, ...]:
        """The line that carries it."""
        return tuple(each.most_loaded + 1 for each in self.responses)


def restoring_curve(
    system: System, *, direction: float, offsets: Sequence[float]
) -> RestoringCurve:
    """Force that holds a body at offsets along a direction.

    `direction`: counter-clockwise from x, rad; `offsets`: from the zero-load position along it, m.
    The system's own load plays no part.

    Raises
    ------
    NoEquilibriumError
        When a line that does not stretch is too short for an offset.
    InputError, NotConvergedError
        As for `solve_system`.
    """
    return _curve(system, direction, offsets, is_held=True)


def network_curve(
    network: Network, *, direction: float, offsets: Sequence[float]
) -> RestoringCurve:
    """Force that holds the one free body of a network at offsets, or all that is held without one.

    As `restoring_curve`; InputError, too, where bodies are several, or nothing moves.
    """
    _check(direction, offsets, "offsets", "m")
    is_free = bool(network.bodies)
    own = network.bodies[0].name if is_free else ""
    moves = {p.name for p in network.points if p.kind == "fairlead" and p.body == own}
    if len(network.bodies) > 1 or not moves:
        found = ", ".join(body.name for body in network.bodies) or Message("refused.none")
        allowed = Message("refused_motion.curve_is_of_one_body")
        raise refused("bodies", found, allowed, "restoring curve")
    start = without_load(network) if is_free else None
    cosine, sine = math.cos(direction), math.sin(direction)
    points = []
    for value in paced(Message("words.offsets", total=len(offsets)), offsets):
        way = (value * cosine, value * sine)
        at = (*way, 0.0, 0.0, 0.0, 0.0)
        rest = at_rest(network, at) if start is None else start.held_at(*way)
        forces = [
            force
            for point, force in pulls_of(rest.runs, rest.joints.ends)
            if network.points[point].name in moves
        ]
        x, y = (math.fsum(force[i] for force in forces) for i in (0, 1))
        numbers = (float(value), 0.0, -x * cosine - y * sine, x * sine - y * cosine)
        points.append((*numbers, network_response(rest, None if is_free else way)))
    columns = zip(*points, strict=True) if points else [()] * 5
    return RestoringCurve(network, direction, True, *columns)


def offset_curve(system: System, *, direction: float, forces: Sequence[float]) -> RestoringCurve:
    """Offset of a free body under forces along a direction.

    `direction`: counter-clockwise from x, rad; `forces`: on the body along it, N. The system's own
    load plays no part.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As for `solve_system`.
    """
    return _curve(system, direction, forces, is_held=False)


def _curve(
    system: System, direction: float, values: Sequence[float], *, is_held: bool
) -> RestoringCurve:
    _check(direction, values, *(("offsets", "m") if is_held else ("forces", "N")))
    zero_load = zero_load_position(system)
    start = zero_load.neutral
    cosine, sine = math.cos(direction), math.sin(direction)
    points = []
    for value in paced(Message("words.offsets", total=len(values)), values):
        if is_held:
            rest, lines = zero_load.held(start.x + value * cosine, start.y + value * sine)
            x, y = rest.pull.x, rest.pull.y
        else:
            rest, lines = zero_load.under((value * cosine, value * sine))
            x, y = rest.x - start.x, rest.y - start.y
        along, across = x * cosine + y * sine, y * cosine - x * sine
        known = (float(value), 0.0)
        numbers = (*known, -along, -across) if is_held else (along, across, *known)
        points.append((*numbers, response_of(zero_load, rest, lines)))
    columns = zip(*points, strict=True) if points else [()] * 5
    return RestoringCurve(system, direction, is_held, *columns)


def _check(direction: float, values: Sequence[float], key: str, unit: str) -> None:
    found = Findings("restoring curve")
    found.number("direction", direction, "rad")
    for index, value in enumerate(values):
        found.number(f"{key}[{index}]", float(value), unit)
    found.raise_if_any()


@dataclass(frozen=True)
class WatchCircle(Tabled, Record):
    """Offsets of a body under a force that goes round."""

    DOCUMENT = "force directions responses"

    system: System | Network
    """The lines; the load on the body plays no part."""
    force: Strength
    """Its size."""
    directions: tuple[Angle, ...]
    """Towards which the force acts, counter-clockwise from x."""
    responses: tuple[Response, ...]
    """The body and its lines at each direction."""
    neutral: tuple[Place, Place]
    """Zero-load position."""

    @property
    def farthest(self) -> int:
        """Index of the direction of the largest offset."""
        return first_largest([each.offset for each in self.responses])

    @property
    def hardest(self) -> int:
        """Index of the direction of the largest tension in any line."""
        return first_largest([each.largest_tension for each in self.responses])


def watch_circle(system: System, *, force: float, directions: int = 120) -> WatchCircle:
    """Let a force go round a body.

    `force`: its size, N; `directions`: how many, evenly from 0, at least 3. The system's own load
    plays no part.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As for `solve_system`.
    """
    angles = _angles(force, directions)
    zero_load = zero_load_position(system)
    responses = []
    for angle in paced(Message("words.directions", total=directions), angles):
        rest, lines = zero_load.under((force * math.cos(angle), force * math.sin(angle)))
        responses.append(response_of(zero_load, rest, lines))
    neutral = (zero_load.neutral.x, zero_load.neutral.y)
    return WatchCircle(system, force, angles, tuple(responses), neutral)


def network_circle(network: Network, *, force: float, directions: int = 120) -> WatchCircle:
    """Let a force go round the one free body of a network; as `watch_circle`.

    InputError, too, where it has none or several; what `at_rest` raises.
    """
    angles = _angles(force, directions)
    if len(network.bodies) != 1:
        found = ", ".join(body.name for body in network.bodies) or Message("refused.none")
        allowed = Message("refused_motion.circle_is_of_one_body")
        raise refused("bodies", found, allowed, "watch circle")
    (body,) = network.bodies
    start = without_load(network)
    responses = []
    for angle in paced(Message("words.directions", total=directions), angles):
        push = (force * math.cos(angle), force * math.sin(angle))
        responses.append(network_response(start.under((replace(body, force=push, moment=0.0),))))
    x, y, _ = start.found.poses[0]
    return WatchCircle(network, force, angles, tuple(responses), (body.x + x, body.y + y))


def _angles(force: float, directions: int) -> tuple[float, ...]:
    """Check what goes round, and say in which directions."""
    found = Findings("watch circle")
    found.number("force", force, "N", above=0.0)
    found.number("directions", directions, "", at_least=3, at_most=3600)
    found.raise_if_any()
    return tuple(2.0 * math.pi * k / directions for k in range(directions))
