"""Solve a moored body in closed form; the answer as a value."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Literal, overload

from catopt.catenary.equilibrium import BY_SPAN
from catopt.catenary.layout import end_of
from catopt.catenary.pieces import LineProblem, cut
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solution_of
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED
from catopt.display import Displayable
from catopt.errors import NotConvergedError
from catopt.largest import first_largest
from catopt.model.kinds import Angle, Moment, NotNegative, Place, SomeForce, Stiffness
from catopt.model.network import Network
from catopt.model.system import Leg, System
from catopt.mooring.network_rest import LinesAtRest, PlacedLoad, Position
from catopt.mooring.zero_load import BodyRest, Lines, ZeroLoadPosition, zero_load_position
from catopt.records import Counted, From, Record
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.mooring.restoring import WatchCircle


__all__ = ["LegState", "Position", "SystemResidual", "SystemSolution"]


@dataclass(frozen=True)
class SystemResidual:
    """What is left unbalanced on the body."""

    force: SomeForce
    """Force left unbalanced."""
    moment: float
    """Where it is free to turn, N m."""


@dataclass(frozen=True)
class LegState:
    """One line of the system under load."""

    leg: Leg
    """The line and where it is moored."""
    solution: Solution
    """Its equilibrium in its own vertical plane, from the anchor to the fairlead."""
    fairlead: tuple[Place, Place]
    """x and y of the fairlead."""
    direction: Angle
    """From the fairlead to the anchor, counter-clockwise from x: that of its pull."""

    @property
    def horizontal_force(self) -> float:
        """With which the line pulls on the body, N."""
        return self.solution.horizontal_force

    @property
    def tension(self) -> float:
        """At the fairlead, N."""
        return self.solution.fairlead.tension

    @property
    def touchdown(self) -> tuple[float, float] | None:
        """X and y of the place where the line leaves the bed towards the fairlead, m.

        None where nothing lies on the bed.
        """
        lying = [stretch for stretch in self.solution.stretches if stretch.on_bed]
        if not lying:
            return None
        distance, _ = end_of(lying[-1], lying[-1].length)
        return self.at(distance)

    def at(self, distance: float) -> tuple[float, float]:
        """X and y of the place at a horizontal distance from the anchor along the line, m."""
        x, y = self.leg.anchor
        return (x - distance * math.cos(self.direction), y - distance * math.sin(self.direction))

    @property
    def placed_loads(self) -> tuple[PlacedLoad, ...]:
        """Its clump weights and buoys, by position from the anchor."""
        loads = self.solution.point_loads
        return tuple(PlacedLoad(each, (*self.at(each.x), each.z)) for each in loads)

    def utilisation(self, safety_factor: float = 1.0) -> float | None:
        """Largest tension times the safety factor over MBL; None where no MBL is known."""
        found = [segment.utilisation(safety_factor) for segment in self.solution.segments]
        known = [value for value in found if value is not None]
        return max(known) if known else None


@dataclass(frozen=True)
class NumberedLine(Record):
    """What a line carries."""

    DOCUMENT = (
        "number=line state.leg.name state.leg.azimuth state.direction "
        "state.solution.horizontal_force "
        "state.solution.fairlead.horizontal_force=fairlead_horizontal_force_N "
        "state.solution.fairlead.tension=fairlead_tension_N "
        "state.solution.fairlead.vertical_force=fairlead_vertical_force_N "
        "state.solution.anchor.tension=anchor_tension_N "
        "state.solution.anchor.horizontal_force=anchor_horizontal_force_N "
        "state.solution.anchor.vertical_force=anchor_vertical_force_N state.solution.span "
        "state.solution.grounded_length state.solution.lowest_point "
        "state.solution.touchdowns state.solution.sag "
        "placed=point_loads(state.name state.position place state.seabed_reaction) utilisation"
    )

    number: Counted
    """Its number."""
    state: LegState
    utilisation: NotNegative | None
    """Largest over the segments of tension times safety factor over MBL, a pure number; None where
    no MBL is known."""

    @property
    def placed(self) -> tuple[PlacedLoad, ...]:
        """Clump weights and buoys, by position from the anchor."""
        return self.state.placed_loads


@dataclass(frozen=True, repr=False)
class SystemSolution(Displayable, Record):
    """A body moored by several lines, at rest, by closed form.

    Directions are counter-clockwise from x. In documents lines count from 1, in Python from 0, in
    the order of the case.
    """

    SCHEMA = "catopt.system/1"
    DOCUMENT = (
        "title method status system.force system.moment system.turns=yaw_is_free position "
        "neutral=zero_load_position offset numbered=lines most_loaded+1=most_loaded_line stiffness "
        "stiffness_with_yaw residual.force=residual_N residual_moment warnings"
    )

    system: System
    """What was solved."""
    position: Position
    """The body under the load."""
    neutral: Position
    """The body under no load."""
    lines: tuple[LegState, ...]
    """In the order of `system.legs`."""
    full_stiffness: tuple[tuple[float, float, float], ...]
    """-d(Fx, Fy, M)/d(x, y, yaw) of the lines there: N/m, N/rad, N m/rad."""
    residual: SystemResidual
    """How exactly the balance is met."""
    steps: int
    """Newton steps from the zero-load position."""
    warnings: tuple[str, ...] = ()
    """What an engineer should know before using the answer."""
    safety_factor: float = 1.0
    """For utilisations; 1 when none was asked for."""
    title: str = ""
    """Title of the case; empty when it has none."""

    @cached_property
    def method(self) -> Literal["closed-form"]:
        """How it was solved."""
        return "closed-form"

    @cached_property
    def status(self) -> Literal["converged"]:
        """What did not converge is never written."""
        return "converged"

    @property
    def numbered(self) -> Annotated[tuple[NumberedLine, ...], From(1)]:
        """What each line carries."""
        return tuple(
            NumberedLine(number, each, each.utilisation(self.safety_factor))
            for number, each in enumerate(self.lines, start=1)
        )

    @property
    def offset(self) -> tuple[Place, Place]:
        """Way of the body's origin from the zero-load position, along x and y."""
        return self.position.x - self.neutral.x, self.position.y - self.neutral.y

    def watch_circle(self, *, force: float, directions: int = 120) -> WatchCircle:
        """Let a force (N) go round the body, from so many directions, instead of the load.

        Examples
        --------
        >>> from catopt import read_case, solve_system
        >>> body = solve_system(read_case("cases/fso-rang-dong/case.toml").system)
        >>> circle = body.watch_circle(force=4281e3, directions=12)
        >>> len(circle.responses)
        12
        """
        from catopt.mooring.restoring import watch_circle

        return watch_circle(self.system, force=force, directions=directions)

    @property
    def stiffness(self) -> tuple[tuple[Stiffness, Stiffness], tuple[Stiffness, Stiffness]]:
        """-d(Fx, Fy)/d(x, y) of all lines, the yaw held."""
        rows = self.full_stiffness
        return (rows[0][0], rows[0][1]), (rows[1][0], rows[1][1])

    @property
    def most_loaded(self) -> int:
        """The line of the largest tension at its fairlead; the first of several."""
        return first_largest([line.tension for line in self.lines])

    @property
    def stiffness_with_yaw(self) -> tuple[tuple[float, float, float], ...] | None:
        """N/m, N/rad (N m/m) and N m/rad: -d(Fx, Fy, M)/d(x, y, yaw).

        None where the body does not turn.
        """
        return self.full_stiffness if self.system.turns else None

    @property
    def residual_moment(self) -> Moment | None:
        """Moment left unbalanced; None where the body does not turn."""
        return self.residual.moment if self.system.turns else None


_AGAINST_X = -math.pi + 1e-12
"""rad: up to here a direction is that against x, which is given as pi."""
LINE_LIMIT = 1e-9
"""How far a laid-out line may miss its fairlead, as a part of its length."""


@overload
def solve_system(system: System) -> SystemSolution: ...


@overload
def solve_system(system: Network) -> LinesAtRest: ...


def solve_system(system: System | Network) -> SystemSolution | LinesAtRest:
    """Find where a moored body comes to rest under its load, and what each line carries.

    Newton's method on x, y and, where the body turns, yaw, with the stiffness of the lines, from
    the zero-load position (docs/system.md).

    Parameters
    ----------
    system : System or Network
        Lines, force and moment; or points, lines and bodies.

    Returns
    -------
    SystemSolution or LinesAtRest
        With its residuals; the latter of a network, as `catopt.mooring.fixed_body.at_rest`.

    Raises
    ------
    NoEquilibriumError
        When a line that does not stretch is too short, or the lines cannot carry the moment.
    NotConvergedError
        When the solver stopped short of its tolerance.

    Examples
    --------
    >>> from math import radians
    >>> from catopt import Line, Segment, System, solve_system
    >>> chain = Line([Segment(600.0, 1000.0, EA=8e8)])
    >>> four = System.around(chain, azimuths=[radians(90.0 * k) for k in range(4)],
    ...                      anchor_radius=560.0, fairlead_height=50.0, force=(1e6, 0.0))
    >>> solution = solve_system(four)
    >>> solution.most_loaded, round(solution.offset[0], 2)
    (2, 35.53)
    """
    if isinstance(system, Network):
        from catopt.mooring.fixed_body import at_rest

        return at_rest(system)
    zero_load = zero_load_position(system)
    return solution_at(zero_load, *zero_load.under(system.force, system.moment))


def solution_at(
    zero_load: ZeroLoadPosition, rest: BodyRest, lines: Lines, *, looks_round: bool = True
) -> SystemSolution:
    """Lay out every line with the body at a place of rest; `looks_round` for other headings."""
    system, neutral = zero_load.system, zero_load.neutral
    others: tuple[BodyRest, ...] = ()
    if looks_round:
        others = zero_load.other_headings(rest, system.force, system.moment)
    states = tuple(
        _leg_state(leg, rest, system.seabed_friction, (lines.H[k], lines.V[k]), k)
        for k, leg in enumerate(system.legs)
    )
    return SystemSolution(
        system=system,
        position=Position(rest.x, rest.y, rest.yaw),
        neutral=Position(neutral.x, neutral.y, neutral.yaw),
        lines=states,
        full_stiffness=rest.stiffness,
        residual=SystemResidual(rest.force_error, rest.moment_error),
        steps=rest.steps,
        warnings=_warnings(zero_load, rest, states, others),
    )


def _leg_state(
    leg: Leg, rest: BodyRest, friction: float, known: tuple[float, float], index: int
) -> LegState:
    cosine, sine = math.cos(rest.yaw), math.sin(rest.yaw)
    arm_x, arm_y = leg.fairlead
    x = rest.x + cosine * arm_x - sine * arm_y
    y = rest.y + sine * arm_x + cosine * arm_y
    to_x, to_y = leg.anchor[0] - x, leg.anchor[1] - y
    span = math.hypot(to_x, to_y)
    pieces, segment_of = cut(leg.line)
    problem = LineProblem(pieces, float(leg.anchor_height), float(leg.fairlead_height), friction)
    H, V = known if known[0] > 0.0 else (math.nan, math.nan)
    state = given_span(max(span, 1e-9), problem, H, V)
    if state.status != CONVERGED:
        raise NotConvergedError(Message("mooring.line_not_converged", number=index + 1))
    own = solution_of(
        state._replace(span=max(span, 1e-9)),
        leg.line,
        problem,
        segment_of,
        method="closed-form",
        known=BY_SPAN,
    )
    worst = max(abs(own.residual.height), abs(own.residual.span))
    if not worst <= LINE_LIMIT * max(leg.line.length, span):
        raise NotConvergedError(Message("mooring.misses_fairlead", number=index + 1, missing=worst))
    # Above -pi and up to pi, whichever side of both rounding leaves it on.
    angle = math.atan2(to_y, to_x)
    return LegState(leg, own, (x, y), angle if angle > _AGAINST_X else math.pi)


def _warnings(
    zero_load: ZeroLoadPosition,
    rest: BodyRest,
    states: tuple[LegState, ...],
    others: tuple[BodyRest, ...],
) -> tuple[str, ...]:
    found = [
        of_line(index + 1, warning)
        for index, state in enumerate(states)
        for warning in state.solution.warnings
    ]
    if not zero_load.is_held(rest):
        found.insert(0, Message("mooring.drifts"))
    for other in others:
        x, y = (f"{round(each, 3) + 0.0:.3f}" for each in (other.x, other.y))
        yaw = math.degrees(other.yaw)
        yaw = 180.0 if round(yaw, 2) == -180.0 else yaw  # the same heading
        found.append(Message("mooring.other_heading", yaw=yaw, x=x, y=y))
    return tuple(found)


def of_line(number: int, said: str) -> Message:
    """Say of which line something is said, counted from 1."""
    return Message("mooring.of_line", number=number, warning=said)
