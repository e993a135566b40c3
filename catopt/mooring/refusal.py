"""Why a body has no place of rest, in words."""

from __future__ import annotations

import math

from catopt.catenary.state import NOT_CONVERGED, TOO_SHORT
from catopt.errors import CatoptError, NoEquilibriumError, NotConvergedError
from catopt.model.system import System
from catopt.mooring.descent import Rest
from catopt.words import Message


def refusal(rest: Rest, system: System) -> CatoptError:
    """Say what stops the body from coming to rest."""
    if rest.line < 0 or rest.status == NOT_CONVERGED:
        key = "mooring.not_at_rest" if rest.line < 0 else "mooring.not_at_rest_for_line"
        values = {"steps": rest.steps, "x": rest.x, "y": rest.y, "number": rest.line + 1}
        return NotConvergedError(Message(key, **values))
    leg = system.legs[rest.line]
    fairlead = leg.fairlead
    cosine, sine = math.cos(rest.yaw), math.sin(rest.yaw)
    span = math.hypot(
        leg.anchor[0] - rest.x - cosine * fairlead[0] + sine * fairlead[1],
        leg.anchor[1] - rest.y - sine * fairlead[0] - cosine * fairlead[1],
    )
    assert rest.status == TOO_SHORT
    missing = math.hypot(span, leg.fairlead_height - leg.anchor_height) - leg.line.length
    values = {"number": rest.line + 1, "span": span, "missing": missing}
    return NoEquilibriumError(Message("mooring.too_short", **values), "length", missing)


def turns_over(moment: float, rest: Rest) -> CatoptError:
    """Say that the lines cannot carry a moment (N m), and the largest that they carry."""
    missing = rest.moment_error
    # Over a full turn the moment of the lines has a mean of zero: below that is rounding.
    largest = max(abs(moment) - missing, 0.0)
    values = {"moment": moment, "largest": largest, "missing": missing}
    return NoEquilibriumError(Message("mooring.turns_over", **values), "moment", missing)
