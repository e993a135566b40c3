"""Equilibrium of one line under a known horizontal force.

For a known H the height of the fairlead rises with the vertical force V there, so one safeguarded
scalar root gives the line. Which root is decided by the bed:

1. Without buoyant parts and with the anchor on the bed, the walk down from the fairlead simply
   stops where V falls to 0.
2. Otherwise the line is hung free of the bed first. When that passes through the bed, the line
   lies on it somewhere, and a touchdown is sought from the fairlead and, for a raised anchor, from
   the anchor. Each candidate is held against the conditions that define the equilibrium: nothing
   hangs below the bed, nothing buoyant lies on it. At fixed H the potential is convex, so at most
   one candidate keeps them; when none does, the line touches the bed in more than one place.
"""

from __future__ import annotations

import math

from catopt.catenary.between import between_state
from catopt.catenary.lift import SETTLED, grounded_guess, suspended_guess, vertical_force
from catopt.catenary.pieces import (
    Pieces,
    is_inextensible,
    length_below,
    total_length,
    total_weight,
)
from catopt.catenary.setting import Setting, is_plain
from catopt.catenary.state import (
    BELOW_ANCHOR,
    CONVERGED,
    GROUNDED,
    NOT_CONVERGED,
    ON_BED,
    SUSPENDED,
    TOO_SHORT,
    TOUCHES_TWICE,
    State,
    failed,
)
from catopt.catenary.touchdown import CLEARANCE, clump_weight, is_heavy, next_touchdown
from catopt.catenary.walk import FIRST_TOUCHDOWN, NO_TOUCHDOWN, lie, lowest, walk
from catopt.compiled import inlined

__all__ = ["given_force", "hung_state"]


def given_force(H: float, setting: Setting) -> State:
    """Solve a line whose horizontal force is known.

    Parameters
    ----------
    H : float
        Horizontal force at the fairlead, N, above 0.
    setting : Setting
        The line and where it is moored.
    """
    pieces = setting.pieces
    rise = setting.fairlead_height - setting.anchor_height
    length = total_length(pieces)
    if is_inextensible(pieces) and abs(rise) >= length:
        return failed(TOO_SHORT)
    if is_plain(setting):
        return _plain(H, pieces, rise, setting.friction)
    guess = suspended_guess(H, pieces, rise)
    V = vertical_force(H, rise, pieces, NO_TOUCHDOWN, guess, -math.inf, 0.0)
    if math.isnan(V):
        return failed(NOT_CONVERGED)
    is_clear = setting.fairlead_height + lowest(H, V, pieces, NO_TOUCHDOWN) >= -CLEARANCE * length
    dips = setting.anchor_height == 0.0 and V < total_weight(pieces)
    state = failed(TOUCHES_TWICE) if is_clear and not dips else _touching(H, setting)
    if state.status == TOUCHES_TWICE and is_clear:
        # Clear of the bed; or so little below it, next to the anchor, that nothing lies there.
        return hung_state(H, V, pieces, rise, setting.friction, NO_TOUCHDOWN)
    return state


@inlined
def _plain(H: float, pieces: Pieces, height: float, friction: float) -> State:
    """State of a line without buoyant parts, anchored on the bed."""
    if height == 0.0:
        return hung_state(H, 0.0, pieces, 0.0, friction, FIRST_TOUCHDOWN)
    guess = grounded_guess(H, pieces, height)
    V = vertical_force(H, height, pieces, FIRST_TOUCHDOWN, guess, 0.0, SETTLED)
    state = hung_state(H, V, pieces, height, friction, FIRST_TOUCHDOWN)
    if abs(state.height_error) <= 1e-14 * total_length(pieces):
        return state
    V = vertical_force(H, height, pieces, FIRST_TOUCHDOWN, V, 0.0, 0.0)
    return hung_state(H, V, pieces, height, friction, FIRST_TOUCHDOWN)


def _touching(H: float, setting: Setting) -> State:
    """State of a line that would pass through the bed if it hung free."""
    pieces, anchor_height, fairlead_height, friction = setting
    tolerance = CLEARANCE * total_length(pieces)
    touchdown, V = next_touchdown(H, fairlead_height, pieces, -1)
    while touchdown >= 0:
        if fairlead_height + lowest(H, V, pieces, touchdown) >= -tolerance:
            if anchor_height > 0.0:
                state = between_state(H, V, setting, touchdown)
                if state.status == CONVERGED:
                    return state
            elif is_heavy(pieces, walk(H, V, pieces, touchdown).piece, 0):
                return hung_state(H, V, pieces, fairlead_height, friction, touchdown)
        touchdown, V = next_touchdown(H, fairlead_height, pieces, touchdown)
    return failed(TOUCHES_TWICE)


@inlined
def hung_state(
    H: float, V: float, pieces: Pieces, rise: float, friction: float, touchdown: int
) -> State:
    """State of a line that hangs from the anchor, or from a touchdown beyond which all lies."""
    if math.isnan(V):
        return failed(NOT_CONVERGED)
    hung = walk(H, V, pieces, touchdown)
    if hung.touchdown == NO_TOUCHDOWN:
        # An anchor pulled down by less than the rounding of V is not pulled down.
        regime = BELOW_ANCHOR if hung.V < -1e-12 * (H + abs(V)) else SUSPENDED
        grounded, bed_x, bed_x_H, H_anchor, V_anchor = 0.0, 0.0, 0.0, H, hung.V
    else:
        regime = GROUNDED if V > 0.0 else ON_BED
        grounded = length_below(pieces, hung.piece, hung.rest)
        reaction = clump_weight(pieces, hung.touchdown) - hung.V
        bed_x, bed_x_H, H_anchor = lie(H, pieces, friction, hung.piece, hung.rest, reaction, 0, 0.0)
        V_anchor = 0.0
    return State(
        CONVERGED,
        regime,
        H,
        V,
        hung.x + bed_x,
        hung.z - rise,
        grounded,
        H_anchor,
        V_anchor,
        hung.touchdown,
        NO_TOUCHDOWN,
        hung.x_H + bed_x_H,
        hung.z_H + friction * bed_x_H,
        hung.z_H,
        hung.z_V,
    )
