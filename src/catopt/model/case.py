"""A whole case: site, line, load and the settings of its solvers and checks."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal, get_args

from catopt.model.find import Find, misfits
from catopt.model.line import Line
from catopt.model.load import Load
from catopt.model.site import Site
from catopt.model.validity import Findings

__all__ = ["BOUNDARY_HANDLINGS", "Boundary", "Case", "Checks", "SwarmSettings"]

Boundary = Literal["nearest", "reflective", "shrink", "random", "intermediate", "periodic"]
BOUNDARY_HANDLINGS: tuple[str, ...] = get_args(Boundary)


@dataclass(frozen=True)
class Checks:
    """Limits a design has to keep.

    Attributes
    ----------
    safety_factor : float
        Tension times this factor may reach the MBL. 1 when none is asked for.
    max_anchor_uplift_angle : float or None
        Largest inclination of the line at the anchor, rad; None when not checked.
    """

    safety_factor: float = 1.0
    max_anchor_uplift_angle: float | None = None

    def __post_init__(self) -> None:
        found = Findings("Checks")
        found.number("safety_factor", self.safety_factor, "", at_least=1.0)
        if self.max_anchor_uplift_angle is not None:
            found.number(
                "max_anchor_uplift_angle",
                self.max_anchor_uplift_angle,
                "rad",
                at_least=0.0,
                at_most=math.pi / 2.0,
            )
        found.raise_if_any()


@dataclass(frozen=True)
class SwarmSettings:
    """Settings of the particle swarm.

    The defaults are the article's numbers (S1) with the coefficients and the boundary handling
    under which its problem does not stall (docs/theory.md).

    Attributes
    ----------
    particles, iterations, runs : int
        Size of the swarm, iterations a run, independent runs.
    seed : int
        Run k draws from the generator seeded with (seed, k).
    cognitive, social, inertia : float
        c1, c2 and w of the velocity rule.
    boundary : str
        What happens to a particle beyond a bound; the names are those of pyswarms.
    """

    particles: int = 200
    iterations: int = 200
    runs: int = 1
    seed: int = 1
    cognitive: float = 1.5
    social: float = 1.5
    inertia: float = 0.4
    boundary: Boundary = "reflective"

    def __post_init__(self) -> None:
        found = Findings("SwarmSettings")
        for key in ("particles", "iterations", "runs"):
            found.number(key, getattr(self, key), "", at_least=2 if key == "particles" else 1)
        found.number("seed", self.seed, "", at_least=0)
        for key in ("cognitive", "social"):
            found.number(key, getattr(self, key), "", at_least=0.0, at_most=4.0)
        found.number("inertia", self.inertia, "", at_least=0.0, at_most=1.0)
        if self.boundary not in BOUNDARY_HANDLINGS:
            found.add("boundary", repr(self.boundary), "one of " + ", ".join(BOUNDARY_HANDLINGS))
        found.raise_if_any()


@dataclass(frozen=True)
class Case:
    """Everything a case file says.

    Attributes
    ----------
    site : Site
        Water and seabed.
    line : Line
        The mooring line.
    load : Load or None
        What is known at the fairlead; None only where `find` seeks the force itself.
    fairlead_height, anchor_height : float
        Above the seabed, m.
    checks : Checks
        Limits.
    swarm : SwarmSettings
        Settings of ``--method pso``.
    title, source : str
        Free text.
    find : Find or None
        What is sought instead, if anything.
    """

    site: Site
    line: Line
    load: Load | None
    fairlead_height: float
    anchor_height: float = 0.0
    checks: Checks = field(default_factory=Checks)
    swarm: SwarmSettings = field(default_factory=SwarmSettings)
    title: str = ""
    source: str = ""
    find: Find | None = None

    def __post_init__(self) -> None:
        found = Findings("Case")
        found.number("fairlead_height", self.fairlead_height, "m", at_least=0.0)
        found.number("anchor_height", self.anchor_height, "m", at_least=0.0)
        found.problems += misfits(
            self.find,
            load=None if self.load is None else self.load.given,
            MBL_known=[segment.MBL is not None for segment in self.line.segments],
            point_loads=len(self.line.point_loads),
            anchor_height=self.anchor_height,
        )
        found.raise_if_any()
