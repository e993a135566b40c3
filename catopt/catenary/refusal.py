"""Words for a line that cannot hang as asked."""

from __future__ import annotations

import math

from catopt.catenary.line_problem import LineProblem
from catopt.catenary.state import NOT_CONVERGED, TOO_HEAVY, TOO_SHORT
from catopt.catenary.tension import least_tension
from catopt.errors import (
    CatoptError,
    NoEquilibriumError,
    NotConvergedError,
)
from catopt.model import Line, Load
from catopt.words import Message


def refusal(status: int, line: Line, load: Load, problem: LineProblem) -> CatoptError:
    """Say what stops a line, and by how much."""
    rise = abs(problem.fairlead_height - problem.anchor_height)
    if status == TOO_SHORT:
        distance = math.hypot(load.span or 0.0, rise)
        return NoEquilibriumError(
            _too_short(line.length, distance, load), "length", distance - line.length
        )
    if status == TOO_HEAVY:
        assert load.fairlead_tension is not None
        least = least_tension(problem, load.fairlead_tension)
        missing = least - load.fairlead_tension
        return NoEquilibriumError(
            Message(
                "catenary.too_heavy", tension=load.fairlead_tension, missing=missing, least=least
            ),
            "force",
            missing,
        )
    assert status == NOT_CONVERGED
    return NotConvergedError(Message("catenary.not_converged"))


def _too_short(length: float, distance: float, load: Load) -> Message:
    missing = distance - length
    way = Message("catenary.way_up" if load.span is None else "catenary.way_across")
    key = "catenary.too_short" if missing > 0.0 else "catenary.just_as_long"
    return Message(key, length=length, way=way, distance=distance, missing=missing)
