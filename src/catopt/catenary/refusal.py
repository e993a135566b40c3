"""Words for a line that cannot hang as asked."""

from __future__ import annotations

import math

from catopt.catenary.setting import Setting
from catopt.catenary.state import NOT_CONVERGED, TOO_HEAVY, TOO_SHORT
from catopt.catenary.tension import least_tension
from catopt.errors import (
    CatoptError,
    NoEquilibriumError,
    NotConvergedError,
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
        least = least_tension(setting, load.fairlead_tension)
        missing = least - load.fairlead_tension
        return NoEquilibriumError(
            f"the fairlead tension of {load.fairlead_tension:.6g} N is {missing:.6g} N too small: "
            f"with this line it is never below {least:.6g} N, which the part that hangs from the "
            "fairlead weighs. Give at least that much, or a lighter line.",
            "force",
            missing,
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
