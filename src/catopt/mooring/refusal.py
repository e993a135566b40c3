"""Why a body has no place of rest, in words."""

from __future__ import annotations

import math

from catopt.catenary.pieces import cut
from catopt.catenary.refusal import refusal as line_refusal
from catopt.catenary.setting import Setting
from catopt.catenary.state import JUMPS, NOT_CONVERGED, TOO_SHORT, TOUCHES_TWICE
from catopt.errors import (
    CatoptError,
    NoAnswerError,
    NoEquilibriumError,
    NotConvergedError,
    TouchesTwiceError,
)
from catopt.model.load import Load
from catopt.model.system import System
from catopt.mooring.settle import TURNS_OVER, Rest

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
    if rest.line < 0 or rest.status in (NOT_CONVERGED, TURNS_OVER):
        of_line = "" if rest.line < 0 else f"line {rest.line + 1} has no solution there, and "
        return NotConvergedError(
            f"{of_line}the body did not come to rest: after {rest.steps} steps it is at "
            f"({rest.x:.6g}, {rest.y:.6g}) m; please report this case"
        )
    return _of_line(rest, system)


def turns_over(moment: float, largest: float) -> CatoptError:
    """Say that the lines cannot carry a moment; N m, and the largest that they carry.

    Parameters
    ----------
    moment, largest : float
        N m.
    """
    missing = abs(moment) - largest
    return NoEquilibriumError(
        f"the lines cannot carry the moment of {moment:.6g} N m on the body: they hold it up to "
        f"about {largest:.4g} N m in that sense, {missing:.4g} N m less; beyond that it turns "
        "over. Give it more pretension, a larger fairlead radius or fairleads whose lines cross.",
        "moment",
        missing,
    )


def _of_line(rest: Rest, system: System) -> CatoptError:
    leg = system.legs[rest.line]
    pieces, _ = cut(leg.line)
    setting = Setting(pieces, leg.anchor_height, leg.fairlead_height, system.seabed_friction)
    fairlead = leg.fairlead
    cosine, sine = math.cos(rest.yaw), math.sin(rest.yaw)
    span = math.hypot(
        leg.anchor[0] - rest.x - cosine * fairlead[0] + sine * fairlead[1],
        leg.anchor[1] - rest.y - sine * fairlead[0] - cosine * fairlead[1],
    )
    head = f"line {rest.line + 1}"
    if rest.status == TOO_SHORT:
        missing = math.hypot(span, leg.fairlead_height - leg.anchor_height) - leg.line.length
        return NoEquilibriumError(
            f"{head} is too short: it does not stretch (no EA) and misses its fairlead, "
            f"{span:.6g} m from its anchor, by {missing:.6g} m. Give it more length or its EA.",
            "length",
            missing,
        )
    cause = line_refusal(rest.status, leg.line, Load(span=max(span, 1e-9)), setting)
    message = f"{head}, {span:.6g} m from its anchor: {cause}"
    if rest.status == TOUCHES_TWICE:
        return TouchesTwiceError(message)
    assert rest.status == JUMPS
    return NoAnswerError(message)
