"""Equilibrium of a line that rests on the bed between a raised anchor and its fairlead."""

from __future__ import annotations

import math

from catopt.catenary.pieces import Pieces, flip, length_below, total_length, total_weight
from catopt.catenary.setting import Setting
from catopt.catenary.state import (
    CONVERGED,
    GROUNDED_BETWEEN,
    TOUCHES_TWICE,
    State,
    failed,
)
from catopt.catenary.touchdown import CLEARANCE, clump_weight, is_heavy, next_touchdown
from catopt.catenary.walk import Bed, Walk, lie, lowest, walk

__all__ = ["between_state"]


def between_state(H: float, V: float, setting: Setting, touchdown: int) -> State:
    """State of a line that lies on the bed between a known touchdown and its raised anchor.

    Parameters
    ----------
    H, V : float
        Forces at the fairlead, N.
    setting : Setting
        The line and where it is moored.
    touchdown : int
        Touchdown code on the fairlead's side (walk.py).

    Returns
    -------
    State
        A failed one when the anchor's side cannot come down to meet that touchdown.
    """
    pieces, friction = setting.pieces, setting.friction
    n = len(pieces.length)
    flipped = flip(pieces)
    hung = walk(H, V, pieces, touchdown)
    rank = 0
    while True:
        H_anchor, V_down, other = _anchor_side(H, V, setting, flipped, rank)
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
        elif gap < 0.0 or not is_heavy(pieces, hung.piece, end):
            continue
        reaction = clump_weight(pieces, touchdown) - hung.V
        if shared:
            reaction -= side.V
            if reaction < 0.0:
                continue
        bed = lie(H, pieces, friction, hung.piece, hung.rest, reaction, end, end_rest)
        height = setting.fairlead_height
        return _joined(H, V, hung, side, bed, H_anchor, V_down, gap, friction, height)


def _hanging_force(H: float, V: float) -> float:
    """Horizontal force with which to lay out a side that friction has left without any."""
    return max(H, 1e-12 * abs(V))


def _anchor_side(
    H: float, V: float, setting: Setting, flipped: Pieces, rank: int
) -> tuple[float, float, int]:
    """Find the forces at a raised anchor and the touchdown there, after friction on the bed.

    The bed carries what neither end does, R = W - V - V_down, so H_anchor = H - mu R, not below 0.
    What H_anchor exceeds that by is below 0 at no force and above 0 at H: a bracketed root.

    Returns
    -------
    H_anchor, V_down, touchdown
        N, N (downwards on the anchor), code counted from the fairlead; -1 when there is none.
    """
    height, friction = setting.anchor_height, setting.friction
    weight = total_weight(setting.pieces) - V
    low, high = 1e-12 * max(H, abs(weight)), H
    V_down, other = _ranked_touchdown(high, height, flipped, rank)
    excess_high = friction * max(weight - V_down, 0.0)
    if other < 0 or excess_high == 0.0:
        return H, V_down, other
    V_down, other = _ranked_touchdown(low, height, flipped, rank)
    excess_low = low - H + friction * max(weight - V_down, 0.0)
    if other < 0 or excess_low >= 0.0:
        return 0.0, V_down, other
    # False position; the end that stays where it is counts half (Illinois).
    stayed = 0
    H_anchor = low
    for _ in range(200):
        H_anchor = high - excess_high * (high - low) / (excess_high - excess_low)
        if not low < H_anchor < high:
            H_anchor = 0.5 * (low + high)
        V_down, other = _ranked_touchdown(H_anchor, height, flipped, rank)
        excess = H_anchor - H + friction * max(weight - V_down, 0.0)
        if other < 0 or abs(excess) <= 2.3e-16 * H or high - low <= 2.3e-16 * H:
            break
        if excess > 0.0:
            high, excess_high = H_anchor, excess
            excess_low *= 0.5 if stayed > 0 else 1.0
            stayed = 1
        else:
            low, excess_low = H_anchor, excess
            excess_high *= 0.5 if stayed < 0 else 1.0
            stayed = -1
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


def _joined(
    H: float,
    V: float,
    hung: Walk,
    side: Walk,
    bed: Bed,
    H_anchor: float,
    V_down: float,
    gap: float,
    friction: float,
    height: float,
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
        hung.x + bed.x + side.x,
        hung.z - height,
        gap,
        H_anchor,
        -V_down,
        hung.touchdown,
        side.touchdown,
        hung.x_H + bed.x_H + side_x_H,
        hung.z_H + friction * (bed.x_H + side_x_H),
        hung.z_H,
        hung.z_V,
    )
