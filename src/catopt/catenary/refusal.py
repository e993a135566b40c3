"""Words for a line that cannot hang as asked."""

from __future__ import annotations

import math

from catopt.catenary.setting import Setting
from catopt.catenary.state import JUMPS, NOT_CONVERGED, TOO_HEAVY, TOO_SHORT, TOUCHES_TWICE
from catopt.catenary.tension import least_tension
from catopt.errors import (
    CatoptError,
    NoAnswerError,
    NoEquilibriumError,
    NotConvergedError,
    TouchesTwiceError,
)
from catopt.model import Line, Load

__all__ = ["refusal"]


def refusal(status: int, line: Line, load: Load, setting: Setting) -> CatoptError:
    """Say what stops a line, and by how much.

    Parameters
    ----------
    status : int
        Of the kernel's failed state.
    line, load, setting
        What was to be solved.
    """
    rise = abs(setting.fairlead_height - setting.anchor_height)
    if status == TOO_SHORT:
        distance = math.hypot(load.span or 0.0, rise)
        return NoEquilibriumError(
            _too_short(line.length, distance, load), "length", distance - line.length
        )
    if status == TOO_HEAVY:
        assert load.fairlead_tension is not None
        at_least, _ = least_tension(load.fairlead_tension, setting)
        least = math.hypot(at_least.H, at_least.V)
        missing = least - load.fairlead_tension
        return NoEquilibriumError(
            f"the fairlead tension of {load.fairlead_tension:.6g} N is {missing:.6g} N too small: "
            f"with this line it is never below {least:.6g} N, which the part that hangs from the "
            "fairlead weighs. Give at least that much, or a lighter line.",
            "force",
            missing,
        )
    if status == TOUCHES_TWICE:
        return TouchesTwiceError(
            f"{_first_buoyant(line)} lifts the line off the bed between two stretches that lie on "
            "it. The closed form holds for one stretch on the bed; move the buoyant part towards "
            "the fairlead, make it smaller, or pull harder."
        )
    if status == JUMPS:
        return NoAnswerError(
            "no equilibrium has just this "
            f"{'span' if load.span is not None else 'fairlead tension'}: with a seabed friction of "
            f"{setting.friction:g} the line between its raised anchor and the bed slides from one "
            "side of it to the other. Give the horizontal force, or a friction below 1."
        )
    assert status == NOT_CONVERGED
    return NotConvergedError("the closed form did not converge; please report this case")


def _too_short(length: float, distance: float, load: Load) -> str:
    missing = distance - length
    where = "up to the fairlead" if load.span is None else "from the anchor to the fairlead"
    head = f"the line is {length:.6g} m long and the straight way {where} is {distance:.6g} m"
    if missing > 0.0:
        return f"{head}: it is {missing:.6g} m too short. Give it more than that."
    return f"{head}: just as long, so that no finite force draws it straight. Give it some slack."


def _first_buoyant(line: Line) -> str:
    for index, load in enumerate(line.point_loads):
        if load.submerged_weight < 0.0:
            name = f" ({load.name})" if load.name else ""
            return f"the buoy line.point_loads[{index}]{name} at {load.position:g} m"
    for index, segment in enumerate(line.segments):
        if segment.submerged_weight < 0.0:
            name = f" ({segment.name})" if segment.name else ""
            return f"the buoyant segment line.segments[{index}]{name}"
    return "a buoyant part"
