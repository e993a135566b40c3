"""Why a body has no place of rest, in words."""

from __future__ import annotations

import math

from catopt.catenary.state import NOT_CONVERGED, TOO_SHORT
from catopt.errors import (
    CatoptError,
    NoEquilibriumError,
    NotConvergedError,
)
from catopt.model.system import System
from catopt.mooring.descent import Rest

__all__ = ["refusal", "turns_over"]


def refusal(rest: Rest, system: System) -> CatoptError:
    """Say what stops the body from coming to rest.

    Parameters
    ----------
    rest : Rest
        Where the search ended.
    system : System
        Whose lines they are.
    """
    if rest.line < 0 or rest.status == NOT_CONVERGED:
        of_line = "" if rest.line < 0 else f"line {rest.line + 1} has no solution there, and "
        return NotConvergedError(
            f"{of_line}the body did not come to rest: after {rest.steps} steps it is at "
            f"({rest.x:.6g}, {rest.y:.6g}) m; please report this case"
        )
    return _of_line(rest, system)


def turns_over(moment: float, rest: Rest) -> CatoptError:
    """Say that the lines cannot carry a moment, and the largest that they carry under the force.

    Parameters
    ----------
    moment : float
        N m.
    rest : Rest
        Where the least of it is left.
    """
    missing = rest.moment_error
    # Over a full turn the moment of the lines has a mean of zero: below that is rounding.
    largest = max(abs(moment) - missing, 0.0)
    return NoEquilibriumError(
        f"the lines cannot carry the moment of {moment:.6g} N m on the body: they hold it up to "
        f"{largest:.6g} N m in that sense, {missing:.4g} N m less; beyond that it turns "
        "over. Give it more pretension, a larger fairlead radius or fairleads whose lines cross.",
        "moment",
        missing,
    )


def _of_line(rest: Rest, system: System) -> CatoptError:
    leg = system.legs[rest.line]
    fairlead = leg.fairlead
    cosine, sine = math.cos(rest.yaw), math.sin(rest.yaw)
    span = math.hypot(
        leg.anchor[0] - rest.x - cosine * fairlead[0] + sine * fairlead[1],
        leg.anchor[1] - rest.y - sine * fairlead[0] - cosine * fairlead[1],
    )
    assert rest.status == TOO_SHORT
    missing = math.hypot(span, leg.fairlead_height - leg.anchor_height) - leg.line.length
    return NoEquilibriumError(
        f"line {rest.line + 1} is too short: it does not stretch (no EA) and misses its fairlead, "
        f"{span:.6g} m from its anchor, by {missing:.6g} m. Give it more length or its EA.",
        "length",
        missing,
    )
