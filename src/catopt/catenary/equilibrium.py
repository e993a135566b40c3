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

from catopt.catenary.lift import SETTLED, grounded_guess, suspended_guess, vertical_force
from catopt.catenary.pieces import (
    Pieces,
    flip,
    has_buoyancy,
    is_inextensible,
    length_below,
    total_length,
    total_weight,
)
from catopt.catenary.state import (
    BELOW_ANCHOR,
    CONVERGED,
    GROUNDED,
    GROUNDED_BETWEEN,
    NOT_CONVERGED,
    ON_BED,
    SUSPENDED,
    TOO_SHORT,
    TOUCHES_TWICE,
    State,
)
from catopt.catenary.touchdown import next_touchdown
from catopt.catenary.walk import FIRST_TOUCHDOWN, NO_TOUCHDOWN, Walk, lie, lowest, walk

__all__ = ["failed", "given_force", "hung_state"]

CLEARANCE = 1e-9
"""How far below the bed, as a part of the length, a hanging line may seem to pass by rounding."""


def failed(status: int) -> State:
    """Return a state that carries no answer."""
    nan = math.nan
    return State(status, 0, nan, nan, nan, nan, nan, nan, nan, 0, 0, nan, nan, nan, nan)


def given_force(
    H: float, pieces: Pieces, anchor_height: float, fairlead_height: float, friction: float
) -> State:
    """Solve a line whose horizontal force is known.

    Parameters
    ----------
    H : float
        Horizontal force at the fairlead, N, above 0.
    pieces : Pieces
        The line.
    anchor_height, fairlead_height : float
        Above the bed, m.
    friction : float
        Coulomb coefficient of the bed.
    """
    rise = fairlead_height - anchor_height
    length = total_length(pieces)
    if is_inextensible(pieces) and abs(rise) >= length:
        return failed(TOO_SHORT)
    if anchor_height == 0.0 and not has_buoyancy(pieces):
        return _plain(H, pieces, fairlead_height, friction)
    guess = suspended_guess(H, pieces, rise)
    V = vertical_force(H, rise, pieces, NO_TOUCHDOWN, guess, -math.inf, 0.0)
    if math.isnan(V):
        return failed(NOT_CONVERGED)
    if fairlead_height + lowest(H, V, pieces, NO_TOUCHDOWN) >= -CLEARANCE * length:
        return hung_state(H, V, pieces, rise, friction, NO_TOUCHDOWN)
    return _touching(H, pieces, anchor_height, fairlead_height, friction)


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


def _touching(
    H: float, pieces: Pieces, anchor_height: float, fairlead_height: float, friction: float
) -> State:
    """State of a line that would pass through the bed if it hung free."""
    rise = fairlead_height - anchor_height
    tolerance = CLEARANCE * total_length(pieces)
    touchdown, V = next_touchdown(H, fairlead_height, pieces, -1)
    while touchdown >= 0:
        if fairlead_height + lowest(H, V, pieces, touchdown) >= -tolerance:
            if anchor_height > 0.0:
                state = _between(H, V, pieces, anchor_height, fairlead_height, friction, touchdown)
                if state.status == CONVERGED:
                    return state
            elif _lies(pieces, walk(H, V, pieces, touchdown).piece, 0):
                return hung_state(H, V, pieces, rise, friction, touchdown)
        touchdown, V = next_touchdown(H, fairlead_height, pieces, touchdown)
    return failed(TOUCHES_TWICE)


def hung_state(
    H: float, V: float, pieces: Pieces, rise: float, friction: float, touchdown: int
) -> State:
    """State of a line that hangs from the anchor, or from a touchdown beyond which all lies."""
    if math.isnan(V):
        return failed(NOT_CONVERGED)
    hung = walk(H, V, pieces, touchdown)
    if hung.touchdown == NO_TOUCHDOWN:
        regime = BELOW_ANCHOR if hung.V < 0.0 else SUSPENDED
        grounded, bed_x, bed_x_H, H_anchor, V_anchor = 0.0, 0.0, 0.0, H, hung.V
    else:
        regime = GROUNDED if V > 0.0 else ON_BED
        grounded = length_below(pieces, hung.piece, hung.rest)
        reaction = _clump_weight(pieces, hung.touchdown) - hung.V
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


def _clump_weight(pieces: Pieces, touchdown: int) -> float:
    """Weight of the clump weight at a touchdown, N; 0 when the touchdown is inside a piece."""
    return pieces.load[touchdown // 2] if touchdown % 2 == 1 else 0.0


def _lies(pieces: Pieces, upper: int, lower: int) -> bool:
    """Whether everything between two pieces that lie on the bed is heavy enough to lie there."""
    for k in range(lower, upper + 1):
        if pieces.weight[k] < 0.0 or (k > lower and pieces.load[k] < 0.0):
            return False
    return True


def _between(
    H: float,
    V: float,
    pieces: Pieces,
    anchor_height: float,
    fairlead_height: float,
    friction: float,
    touchdown: int,
) -> State:
    """State of a line that lies on the bed between a known touchdown and its raised anchor."""
    n = len(pieces.length)
    flipped = flip(pieces)
    hung = walk(H, V, pieces, touchdown)
    rank = 0
    while True:
        H_anchor, V_down, other = _anchor_side(H, V, pieces, flipped, anchor_height, friction, rank)
        if other < 0:
            return failed(TOUCHES_TWICE)
        rank += 1
        side = walk(_hanging_force(H_anchor, V_down), V_down, flipped, other)
        end = n - 1 - side.piece
        end_rest = flipped.length[side.piece] - side.rest
        gap = length_below(pieces, hung.piece, hung.rest) - length_below(pieces, end, end_rest)
        shared = touchdown % 2 == 1 and other % 2 == 1 and touchdown // 2 == n - other // 2
        if shared:
            gap = 0.0
        elif gap < 0.0 or not _lies(pieces, hung.piece, end):
            continue
        reaction = _clump_weight(pieces, touchdown) - hung.V
        if shared:
            reaction -= side.V
            if reaction < 0.0:
                continue
        bed = lie(H, pieces, friction, hung.piece, hung.rest, reaction, end, end_rest)
        return _between_state(
            H, V, hung, side, bed.x, bed.x_H, H_anchor, V_down, gap, friction, fairlead_height
        )


def _hanging_force(H: float, V: float) -> float:
    """Horizontal force with which to lay out a side that friction has left without any."""
    return max(H, 1e-12 * abs(V))


def _anchor_side(
    H: float,
    V: float,
    pieces: Pieces,
    flipped: Pieces,
    anchor_height: float,
    friction: float,
    rank: int,
) -> tuple[float, float, int]:
    """Find the forces at a raised anchor and the touchdown there, after friction on the bed.

    The bed carries what neither end does, R = W - V - V_down, so H_anchor = H - mu R, not below 0.
    V_down rises with H_anchor: a bracketed root.

    Returns
    -------
    H_anchor, V_down, touchdown
        N, N (downwards on the anchor), code counted from the fairlead; -1 when there is none.
    """
    weight = total_weight(pieces)
    floor = 1e-12 * max(H, abs(weight))
    low, high = floor, H
    V_down, other = _ranked_touchdown(high, anchor_height, flipped, rank)
    if other < 0 or friction == 0.0:
        return H, V_down, other
    for _ in range(200):
        middle = 0.5 * (low + high)
        V_down, other = _ranked_touchdown(middle, anchor_height, flipped, rank)
        if other < 0:
            return H, V_down, other
        if middle > H - friction * max(weight - V - V_down, 0.0):
            high = middle
        else:
            low = middle
        if high - low <= 2.3e-16 * H:
            break
    H_anchor = high if high > 2.0 * floor else 0.0
    return H_anchor, V_down, other


def _ranked_touchdown(H: float, height: float, pieces: Pieces, rank: int) -> tuple[float, int]:
    """V and touchdown code of the touchdown number `rank` whose hanging part clears the bed."""
    touchdown = -1
    tolerance = CLEARANCE * total_length(pieces)
    while True:
        touchdown, V = next_touchdown(H, height, pieces, touchdown)
        if touchdown < 0:
            return math.nan, -1
        if height + lowest(H, V, pieces, touchdown) >= -tolerance:
            if rank == 0:
                return V, touchdown
            rank -= 1


def _between_state(
    H: float,
    V: float,
    hung: Walk,
    side: Walk,
    bed_x: float,
    bed_x_H: float,
    H_anchor: float,
    V_down: float,
    gap: float,
    friction: float,
    fairlead_height: float,
) -> State:
    """Put the three parts of a line with a raised anchor together, derivatives included."""
    # At the anchor the height is held: dV_down/dH_anchor = -z_H/z_V, and friction passes on
    # dH_anchor = dH + mu (dV + dV_down).
    gain = -side.z_H / side.z_V
    passed = 1.0 / (1.0 - friction * gain) if H_anchor > 0.0 else 0.0
    side_x_H = (side.x_H + side.z_H * gain) * passed
    return State(
        CONVERGED,
        GROUNDED_BETWEEN,
        H,
        V,
        hung.x + bed_x + side.x,
        hung.z - fairlead_height,
        gap,
        H_anchor,
        -V_down,
        hung.touchdown,
        side.touchdown,
        hung.x_H + bed_x_H + side_x_H,
        hung.z_H + friction * (bed_x_H + side_x_H),
        hung.z_H,
        hung.z_V,
    )
