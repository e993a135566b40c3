"""The answer for a moored body, as a value."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from catopt.catenary.layout import end_of
from catopt.catenary.solution import Solution
from catopt.model.system import Leg, System
from catopt.mooring.position import Position
from catopt.shown import Displayable
from catopt.ties import first_largest

if TYPE_CHECKING:
    from catopt.mooring.circle import WatchCircle

__all__ = ["LegState", "Position", "SystemResidual", "SystemSolution"]


@dataclass(frozen=True)
class SystemResidual:
    """What is left unbalanced on the body: force (N) and, where it is free to turn, moment."""

    force: float
    moment: float


@dataclass(frozen=True)
class LegState:
    """One line of the system under load.

    Attributes
    ----------
    leg : Leg
        The line and where it is moored.
    solution : Solution
        Its equilibrium in its own vertical plane, from the anchor to the fairlead.
    fairlead : (float, float)
        x and y of the fairlead, m.
    direction : float
        From the fairlead to the anchor, counter-clockwise from x, rad: that of its pull.
    """

    leg: Leg
    solution: Solution
    fairlead: tuple[float, float]
    direction: float

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
        return (
            x - distance * math.cos(self.direction),
            y - distance * math.sin(self.direction),
        )

    def utilisation(self, safety_factor: float = 1.0) -> float | None:
        """Largest tension times the safety factor over MBL; None where no MBL is known."""
        found = [segment.utilisation(safety_factor) for segment in self.solution.segments]
        known = [value for value in found if value is not None]
        return max(known) if known else None

    def to_dict(self, safety_factor: float = 1.0) -> dict[str, Any]:
        """Lay it out as the documents have it."""
        own = self.solution
        return {
            "name": self.leg.name,
            "azimuth_rad": self.leg.azimuth,
            "direction_rad": self.direction,
            "horizontal_force_N": self.horizontal_force,
            "fairlead_tension_N": self.tension,
            "fairlead_vertical_force_N": own.fairlead.vertical_force,
            "anchor_tension_N": own.anchor.tension,
            "anchor_horizontal_force_N": own.anchor.horizontal_force,
            "anchor_vertical_force_N": own.anchor.vertical_force,
            "span_m": own.span,
            "grounded_length_m": own.grounded_length,
            "utilisation": self.utilisation(safety_factor),
        }


@dataclass(frozen=True, repr=False)
class SystemSolution(Displayable):
    """Equilibrium of a moored body.

    Attributes
    ----------
    system : System
        What was solved.
    position, neutral : Position
        Under the load, and under no load.
    lines : tuple of LegState
        In the order of `system.legs`.
    full_stiffness : tuple of 3 tuples of 3 float
        -d(Fx, Fy, M)/d(x, y, yaw) of the lines there: N/m, N/rad, N m/rad.
    residual : SystemResidual
        How exactly the balance is met.
    steps : int
        Newton steps from the zero-load position.
    warnings : tuple of str
        What an engineer should know before using the answer.
    safety_factor : float
        For utilisations; 1 when none was asked for.
    title : str
        Of the case.
    """

    system: System
    position: Position
    neutral: Position
    lines: tuple[LegState, ...]
    full_stiffness: tuple[tuple[float, float, float], ...]
    residual: SystemResidual
    steps: int
    warnings: tuple[str, ...] = ()
    safety_factor: float = 1.0
    title: str = ""

    @property
    def offset(self) -> tuple[float, float]:
        """Way of the body's origin from the zero-load position, m."""
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
        from catopt.mooring.circle import watch_circle

        return watch_circle(self.system, force=force, directions=directions)

    @property
    def stiffness(self) -> tuple[tuple[float, float], ...]:
        """-d(Fx, Fy)/d(x, y), yaw held, N/m."""
        rows = self.full_stiffness
        return (rows[0][0], rows[0][1]), (rows[1][0], rows[1][1])

    @property
    def most_loaded(self) -> int:
        """The line of the largest tension at the fairlead, counted from 0; the first of several."""
        return first_largest([line.tension for line in self.lines])

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt system --json`` prints (schema catopt.system/1)."""
        return {
            "schema": "catopt.system/1",
            "title": self.title,
            "method": "closed-form",
            "status": "converged",
            "force_N": list(self.system.force),
            "moment_Nm": self.system.moment,
            "yaw_is_free": self.system.turns,
            "position": self.position.to_dict(),
            "zero_load_position": self.neutral.to_dict(),
            "offset_m": list(self.offset),
            "lines": [
                {"line": number} | line.to_dict(self.safety_factor)
                for number, line in enumerate(self.lines, start=1)
            ],
            "most_loaded_line": self.most_loaded + 1,
            "stiffness_N_per_m": [list(row) for row in self.stiffness],
            "stiffness_with_yaw": (
                [list(row) for row in self.full_stiffness] if self.system.turns else None
            ),
            "residual_N": self.residual.force,
            "residual_moment_Nm": self.residual.moment if self.system.turns else None,
            "warnings": list(self.warnings),
        }
