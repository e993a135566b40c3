"""Restoring curves, and the watch circle: where a force of one size takes the body."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

from catopt.display import Tabled
from catopt.errors import refused
from catopt.largest import first_largest
from catopt.model.kinds import Angle, Findings, Force, Height, Place, SomeForce, Strength
from catopt.model.network import Network
from catopt.model.system import System
from catopt.mooring.fixed_body import WithoutLoad, at_rest, without_load
from catopt.mooring.joints import pulls_of
from catopt.mooring.network_rest import FloatingBody, LinesAtRest
from catopt.mooring.zero_load import BodyRest, Lines, ZeroLoadPosition, zero_load_position
from catopt.old_names import old_function
from catopt.progress import paced
from catopt.records import Counted, Record
from catopt.words import Message

Plane = tuple[tuple[float, float], tuple[float, float]]


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
    ends = rest.at_ends
    tensions = [max(each.first, each.second) for each in ends]
    anchored = [each for k, each in enumerate(ends) if rest.is_anchored(k)]
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
        largest_anchor_tension=max((each.first for each in anchored), default=0.0),
        largest_uplift=max((each.uplift for each in anchored), default=0.0),
        least_grounded=min(each.grounded for each in ends),
    )


def response_of(
    zero_load: ZeroLoadPosition, rest: BodyRest, lines: Lines, zero: BodyRest | None = None
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


class Loaded(NamedTuple):
    """A body that is pushed or held, what its lines pull with (N), and -d(Fx, Fy)/d(x, y) (N/m)."""

    response: Response
    pull: tuple[float, float]
    stiffness: Plane
    floating: FloatingBody | None = None
    """How it floats; None of a body on lines of its own, or one that is held."""


class Unloaded(Protocol):
    """A mooring at rest without load on its body: from there every load is followed."""

    @property
    def neutral(self) -> tuple[float, float]:
        """Where the body is then, m."""

    def under(self, force: Sequence[float], moment: float = 0.0) -> Loaded:
        """Push the body, N and N m."""

    def own(self) -> Loaded:
        """Push it by its own load."""

    def held(self, x: float, y: float) -> Loaded:
        """Hold it so far off, m; it turns where it is free to."""


@dataclass(frozen=True)
class _OnLines:
    """A body on lines of its own."""

    start: ZeroLoadPosition

    @property
    def neutral(self) -> tuple[float, float]:
        return self.start.neutral.x, self.start.neutral.y

    def under(self, force: Sequence[float], moment: float = 0.0) -> Loaded:
        return self._of(*self.start.under(force, moment))

    def own(self) -> Loaded:
        return self.under(self.start.system.force, self.start.system.moment)

    def held(self, x: float, y: float) -> Loaded:
        neutral = self.neutral
        return self._of(*self.start.held(neutral[0] + x, neutral[1] + y))

    def _of(self, rest: BodyRest, lines: Lines) -> Loaded:
        (x, y, _), ((xx, xy, _), (yx, yy, _), _) = rest.pull, rest.stiffness
        return Loaded(response_of(self.start, rest, lines), (x, y), ((xx, xy), (yx, yy)))


@dataclass(frozen=True)
class _BetweenPoints:
    """The one free body of lines between points, or without one all that is held."""

    network: Network
    start: WithoutLoad | None

    @property
    def neutral(self) -> tuple[float, float]:
        if self.start is None:
            return 0.0, 0.0
        (body,), (pose,) = self.network.bodies, self.start.found.poses
        return body.x + pose[0], body.y + pose[1]

    def under(self, force: Sequence[float], moment: float = 0.0) -> Loaded:
        assert self.start is not None
        (body,) = self.network.bodies
        along, across = force
        return self._of(self.start.under((replace(body, force=(along, across), moment=moment),)))

    def own(self) -> Loaded:
        if self.start is None:
            rest = at_rest(self.network)
            return self._of(rest, None if rest.bodies else (0.0, 0.0))
        (body,) = self.network.bodies
        return self.under(body.force, body.moment)

    def held(self, x: float, y: float) -> Loaded:
        if self.start is None:
            return self._of(at_rest(self.network, (x, y, 0.0, 0.0, 0.0, 0.0)), (x, y))
        return self._of(self.start.held_at(x, y))

    def _of(self, rest: LinesAtRest, moved: tuple[float, float] | None = None) -> Loaded:
        ends = {
            k
            for k, point in enumerate(self.network.points)
            if point.kind == "fairlead" and bool(point.body) == bool(rest.bodies)
        }
        pulls = [force for k, force in pulls_of(rest.runs, rest.joints.ends) if k in ends]
        x, y = (math.fsum(force[i] for force in pulls) for i in (0, 1))
        plane = rest.bodies[0].stiffness if rest.bodies else ((math.nan,) * 3,) * 3
        stiffness = ((plane[0][0], plane[0][1]), (plane[1][0], plane[1][1]))
        floating = rest.bodies[0].floating if rest.bodies else None
        return Loaded(network_response(rest, moved), (x, y), stiffness, floating)


def unloaded(
    mooring: System | Network, asked: str, *, may_be_held: bool = False, by_own_load: bool = False
) -> Unloaded:
    """Bring a mooring to rest without load on its one body; `asked`: for what.

    InputError for lines between points where free bodies are several; or none, unless
    `may_be_held`: then all fairleads are held. `by_own_load`: no other is followed, so that a
    current may act, and nothing need be moored.
    """
    if not isinstance(mooring, Network):
        return _OnLines(zero_load_position(mooring))
    count = len(mooring.bodies)
    if by_own_load and (not count or (count == 1 and mooring.current_at_rest is not None)):
        return _BetweenPoints(mooring, None)
    ends = {point.kind for point in mooring.points}
    if count != 1 and not (may_be_held and not count and {"anchor", "fairlead"} <= ends):
        found = ", ".join(body.name for body in mooring.bodies) or Message("refused.none")
        allowed = Message(f"refused_motion.{asked}_is_of_one_body")
        raise refused("bodies", found, allowed, "mooring")
    return _BetweenPoints(mooring, without_load(mooring) if count else None)


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
    system: System | Network, *, direction: float, offsets: Sequence[float]
) -> RestoringCurve:
    """Force that holds a body at offsets along a direction.

    `direction`: counter-clockwise from x, rad; `offsets`: from the zero-load position along it, m.
    The system's own load plays no part. Of lines between points it is the one body that is free,
    or without one all that is held, from where it is given.

    Raises
    ------
    NoEquilibriumError
        When a line that does not stretch is too short for an offset.
    InputError
        Free bodies are several, or nothing moves; as for `solve_system`.
    NotConvergedError
        As for `solve_system`.
    """
    _check(direction, offsets, "offsets", "m")
    start = unloaded(system, "curve", may_be_held=True)
    cosine, sine = math.cos(direction), math.sin(direction)
    points = []
    for value in paced(Message("words.offsets", total=len(offsets)), offsets):
        loaded = start.held(value * cosine, value * sine)
        x, y = loaded.pull
        along, across = -x * cosine - y * sine, x * sine - y * cosine
        points.append((float(value), 0.0, along, across, loaded.response))
    columns = zip(*points, strict=True) if points else [()] * 5
    return RestoringCurve(system, direction, True, *columns)


network_curve = old_function("network_curve", restoring_curve)


def offset_curve(
    system: System | Network, *, direction: float, forces: Sequence[float]
) -> RestoringCurve:
    """Offset of a free body under forces along a direction.

    `direction`: counter-clockwise from x, rad; `forces`: on the body along it, N. The system's own
    load plays no part.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As for `solve_system`; InputError for lines between points without one free body.
    """
    _check(direction, forces, "forces", "N")
    start = unloaded(system, "curve")
    cosine, sine = math.cos(direction), math.sin(direction)
    points = []
    for value in paced(Message("words.offsets", total=len(forces)), forces):
        response = start.under((value * cosine, value * sine)).response
        x, y = response.x - start.neutral[0], response.y - start.neutral[1]
        points.append((x * cosine + y * sine, y * cosine - x * sine, float(value), 0.0, response))
    columns = zip(*points, strict=True) if points else [()] * 5
    return RestoringCurve(system, direction, False, *columns)


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


def watch_circle(system: System | Network, *, force: float, directions: int = 120) -> WatchCircle:
    """Let a force go round a body.

    `force`: its size, N; `directions`: how many, evenly from 0, at least 3. The system's own load
    plays no part.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As for `solve_system`; InputError for lines between points without one free body.
    """
    angles = _angles(force, directions)
    start = unloaded(system, "circle")
    responses = tuple(
        start.under((force * math.cos(angle), force * math.sin(angle))).response
        for angle in paced(Message("words.directions", total=directions), angles)
    )
    return WatchCircle(system, force, angles, responses, start.neutral)


def _angles(force: float, directions: int) -> tuple[float, ...]:
    """Check what goes round, and say in which directions."""
    found = Findings("watch circle")
    found.number("force", force, "N", above=0.0)
    found.number("directions", directions, "", at_least=3, at_most=3600)
    found.raise_if_any()
    return tuple(2.0 * math.pi * k / directions for k in range(directions))
