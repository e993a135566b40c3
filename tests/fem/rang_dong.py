"""FSO Rang Dong as its source ran it: nine legs on a turret (S4, chapter 4)."""

from __future__ import annotations

import math

from catopt.constants import STANDARD_GRAVITY
from catopt.fem import Leg, RestrainedBed, SystemSolution, solve_system
from catopt.model import Line, Segment

ANCHOR_RADIUS = 1056.0
TURRET_HEIGHT = 71.4
FORCE = (-4281e3, 0.0)
AZIMUTHS = (-3.0, 0.0, 3.0, 117.0, 120.0, 123.0, 237.0, 240.0, 243.0)
"""Degrees; the printed ones are 5 apart, the printed node coordinates give 3."""

AS_RUN = RestrainedBed(grounded_length=750.0 + 194.0, EA_multiplier=100.0)
"""Nodes from the second joint to the anchor held at z = 0 both ways, EA a hundredfold."""


def leg_line() -> Line:
    """Wire, then three lengths of studless chain, from the anchor; length, kg/m in water, kN."""
    figures = ((750.0, 30.4, 382090.0), (194.0, 137.2, 721980.0), (80.0, 155.4, 801200.0),
               (58.0, 155.4, 801200.0))  # fmt: skip
    return Line([Segment(L, m * STANDARD_GRAVITY, EA=1e3 * EA) for L, m, EA in figures])


def legs() -> list[Leg]:
    """Nine of them round the turret."""
    line = leg_line()
    angles = [math.radians(azimuth) for azimuth in AZIMUTHS]
    return [
        Leg(line, (ANCHOR_RADIUS * math.cos(a), ANCHOR_RADIUS * math.sin(a), 0.0)) for a in angles
    ]


def as_run() -> SystemSolution:
    """Solve with the choices under which the source's printed figures come out."""
    return solve_system(legs(), height=TURRET_HEIGHT, force=FORCE, elements=[5] * 4, bed=AS_RUN)
