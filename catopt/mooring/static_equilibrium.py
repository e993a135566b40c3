"""Where the body comes to rest under a load: downhill from where it is, or else round in yaw."""

from __future__ import annotations

from typing import Final

from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_SHORT
from catopt.mooring.balance import RestoringForce, pull_at
from catopt.mooring.descent import (
    BodyProblem,
    Rest,
    by_parts,
    is_stable,
    newton,
    within_half_a_turn,
)
from catopt.mooring.heading import first_heading

NUDGE: Final = 0.01
"""rad by which a body that balances on a ridge is turned off it."""


def static_equilibrium(
    x: float, y: float, yaw: float, pull: RestoringForce, problem: BodyProblem
) -> Rest:
    """Find the place of rest under a load, its yaw within half a turn either way; as `newton`."""
    freedom = problem.freedom
    rest = newton(x, y, yaw, pull, problem)
    if rest.status in (NOT_CONVERGED, TOO_SHORT) and pull.status == CONVERGED:
        rest = by_parts(x, y, yaw, problem)
    if not freedom.in_yaw or pull.status != CONVERGED:
        return rest
    if rest.status == CONVERGED and not is_stable(rest.pull, freedom):
        nudged = rest.yaw + NUDGE
        at = pull_at(rest.x, rest.y, nudged, problem.arrangement, problem.lines, True)
        rest = newton(rest.x, rest.y, nudged, at, problem)
    if rest.status != CONVERGED or not is_stable(rest.pull, freedom):
        rest = first_heading(x, y, yaw, problem)
    return within_half_a_turn(rest)
