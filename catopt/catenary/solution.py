"""The answer for one line, as a value."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

from catopt.catenary.layout import Profile, Stretch, sample
from catopt.catenary.state import Regime
from catopt.model import Line
from catopt.shown import Shown

__all__ = [
    "EndState",
    "FoundQuantity",
    "PointLoadState",
    "Residual",
    "SegmentState",
    "Solution",
    "SwarmReport",
]


@dataclass(frozen=True)
class EndState:
    """Effective forces at one end of the line.

    The vertical force is positive where the line rises towards the fairlead (at the anchor: where
    the line pulls the anchor up).
    """

    tension: float  # N
    horizontal_force: float  # N
    vertical_force: float  # N
    angle: float  # above the horizontal, rad, with the sign of the vertical force

    def to_dict(self) -> dict[str, float]:
        """Lay it out as the documents have it, in SI."""
        return {
            "tension_N": self.tension,
            "horizontal_force_N": self.horizontal_force,
            "vertical_force_N": self.vertical_force,
            "angle_rad": self.angle,
        }


@dataclass(frozen=True)
class SegmentState:
    """One segment of the line under load: its largest effective tension, N."""

    name: str
    length: float
    max_tension: float
    MBL: float | None

    def utilisation(self, safety_factor: float = 1.0) -> float | None:
        """Largest tension times the safety factor over MBL; None when MBL is not known."""
        return None if self.MBL is None else self.max_tension * safety_factor / self.MBL


@dataclass(frozen=True)
class PointLoadState:
    """One clump weight or buoy under load: where it is (m) and what the bed carries of it (N)."""

    name: str
    position: float
    x: float
    z: float
    seabed_reaction: float


@dataclass(frozen=True)
class Residual:
    """How exactly the equilibrium is met: the line is laid out piece by piece from its anchor.

    The rounding of the input to double precision leaves more of the forces open on a nearly taut
    line that does not stretch.
    """

    height: float  # by how much it misses the fairlead, m
    span: float  # m
    force_uncertainty: float = 0.0  # what rounding may move the forces at the fairlead by, N


@dataclass(frozen=True)
class SwarmReport:
    """How the swarm got to its answer."""

    objective: float  # smallest f, m
    evaluations: int  # of f, over all runs
    iterations: int  # that a run may take
    runs: int
    seed: int
    converged_runs: int  # those that ended with f < 1e-9 m
    best_run: int  # counted from 1
    objectives: tuple[float, ...]  # f at the end of each run, m
    span_consistency: float  # S1 (11): |S - span of equation (5)|, m; to stay below 1e-3
    # Swarm less closed form: angle_rad or grounded_length_m, span_m, tension_N.
    closed_form_difference: dict[str, float]
    best_objective_history: tuple[float, ...]  # after each iteration of the best run, m
    tension_history: tuple[float, ...]  # at the fairlead, in those places, N
    iterations_flown: tuple[int, ...] = ()  # by each run: fewer where f could not fall any more

    def to_dict(self) -> dict[str, Any]:
        """Lay it out as the documents have it."""
        keys = (
            *("objective", "evaluations", "iterations", "runs", "seed"),
            *("converged_runs", "best_run"),
        )
        return {
            **{key: getattr(self, key) for key in keys},
            "span_consistency_m": self.span_consistency,
            "closed_form_difference": dict(self.closed_form_difference),
        }


@dataclass(frozen=True)
class FoundQuantity:
    """An unknown that meets a condition."""

    quantity: Literal["length", "clump_weight", "horizontal_force"]
    value: float  # m or N
    condition: str  # what it has to give, in words
    residual: float  # what the condition is missed by, as a part of the quantity it is put on
    number: int | None = None  # of segment or point load, from 1 at the anchor; None for a force

    @property
    def unit(self) -> str:
        """Unit of the value."""
        return "m" if self.quantity == "length" else "N"


@dataclass(frozen=True, repr=False)
class Solution(Shown):
    """Equilibrium of one line."""

    line: Line
    method: Literal["closed-form", "pso", "shooting"]
    regime: Regime  # how the line hangs (docs/regimes.md)
    fairlead_height: float  # above the seabed, m
    anchor_height: float  # above the seabed, m
    seabed_friction: float  # Coulomb coefficient
    span: float  # horizontal distance from the anchor to the fairlead, m
    fairlead: EndState
    anchor: EndState  # beyond what friction of the seabed takes
    grounded_length: float  # unstretched, m
    suspended_length: float  # unstretched, m
    stretched_length: float  # of the whole line under its tension, m
    segments: tuple[SegmentState, ...]
    point_loads: tuple[PointLoadState, ...]
    stretches: tuple[Stretch, ...]  # from the anchor up, cut where anything changes
    residual: Residual
    warnings: tuple[str, ...] = ()  # what an engineer should know before using the answer
    safety_factor: float = 1.0  # for utilisations; 1 when none was asked for
    title: str = ""  # of the case
    swarm: SwarmReport | None = None  # only for ``method == "pso"``
    found: FoundQuantity | None = None  # what was sought, if anything was

    @property
    def horizontal_force(self) -> float:
        """Horizontal force at the fairlead, N; the same along everything that hangs from it."""
        return self.fairlead.horizontal_force

    def profile(self, points: int = 101) -> Profile:
        """Sample the shape and the tension at about so many points, evenly along the arc.

        Every joint and touchdown is always among them.
        """
        return sample(self.stretches, points)

    def to_dict(self, *, profile: bool = False) -> dict[str, Any]:
        """Build the document that ``catopt solve --json`` prints (schema catopt.solution/1)."""
        document: dict[str, Any] = {
            "schema": "catopt.solution/1",
            "title": self.title,
            "method": self.method,
            "status": "converged",
            "regime": self.regime,
            "horizontal_force_N": self.horizontal_force,
            "span_m": self.span,
            "fairlead_height_m": self.fairlead_height,
            "anchor_height_m": self.anchor_height,
            "seabed_friction": self.seabed_friction,
            "fairlead": self.fairlead.to_dict(),
            "anchor": self.anchor.to_dict(),
            "grounded_length_m": self.grounded_length,
            "suspended_length_m": self.suspended_length,
            "stretched_length_m": self.stretched_length,
            "line_mass_kg": self.line.mass,
            "safety_factor": self.safety_factor,
            "segments": [
                {
                    "name": segment.name,
                    "length_m": segment.length,
                    "max_tension_N": segment.max_tension,
                    "utilisation": segment.utilisation(self.safety_factor),
                }
                for segment in self.segments
            ],
            "point_loads": [
                {
                    "name": load.name,
                    "position_m": load.position,
                    "x_m": load.x,
                    "z_m": load.z,
                    "seabed_reaction_N": load.seabed_reaction,
                }
                for load in self.point_loads
            ],
            "residual": {
                "height_m": self.residual.height,
                "span_m": self.residual.span,
                "force_uncertainty_N": self.residual.force_uncertainty,
            },
            "warnings": list(self.warnings),
        }
        if self.found is not None:
            document["found"] = asdict(self.found) | {"unit": self.found.unit}
        if self.swarm is not None:
            document["pso"] = self.swarm.to_dict()
        if profile:
            at = self.profile()
            document["profile"] = {
                "s_m": list(at.s),
                "x_m": list(at.x),
                "z_m": list(at.z),
                "tension_N": list(at.tension),
            }
        return document

    def with_found(self, found: FoundQuantity) -> Solution:
        """Return the same answer with what was sought."""
        return replace(self, found=found)

    def with_warnings(self, warnings: tuple[str, ...]) -> Solution:
        """Return the same answer with warnings added."""
        return replace(self, warnings=(*self.warnings, *warnings)) if warnings else self
