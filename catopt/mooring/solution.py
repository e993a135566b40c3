"""The answer for a moored body, as a value."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from catopt.catenary.layout import end_of
from catopt.catenary.solution import Solution
from catopt.model.kinds import Angle, Moment, NotNegative, Place, SomeForce, Stiffness
from catopt.model.system import Leg, System
from catopt.mooring.position import Position
from catopt.records import Counted, From, Record
from catopt.shown import Displayable
from catopt.ties import first_largest

__all__ = ["LegState", "Position", "SystemResidual", "SystemSolution"]

if TYPE_CHECKING:
    from catopt.mooring.restoring import WatchCircle


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
        "state.solution.horizontal_force state.solution.fairlead.tension=fairlead_tension_N "
        "state.solution.fairlead.vertical_force=fairlead_vertical_force_N "
        "state.solution.anchor.tension=anchor_tension_N "
        "state.solution.anchor.horizontal_force=anchor_horizontal_force_N "
        "state.solution.anchor.vertical_force=anchor_vertical_force_N state.solution.span "
        "state.solution.grounded_length utilisation"
    )

    number: Counted
    """Its number."""
    state: LegState
    utilisation: NotNegative | None
    """Largest over the segments of tension times safety factor over MBL, a pure number; None where
    no MBL is known."""


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

    @property
    def method(self) -> Literal["closed-form"]:
        """How it was solved."""
        return "closed-form"

    @property
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
