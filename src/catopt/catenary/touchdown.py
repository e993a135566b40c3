"""Where a line touches down when it has buoyant parts: one candidate after the other.

For every place at which the line could touch down, V at the fairlead is known within the weight of
that piece or clump weight, and the height of the fairlead rises with V. So each piece and each
clump weight holds at most one touchdown that lifts the fairlead to its height.
"""

from __future__ import annotations

import math

from catopt.catenary.lift import vertical_force
from catopt.catenary.pieces import Pieces
from catopt.catenary.walk import drop
from catopt.compiled import inlined

__all__ = ["CLEARANCE", "clump_weight", "is_heavy", "next_touchdown"]

CLEARANCE = 1e-9
"""How far below the bed, as a part of the length, a hanging line may seem to pass by rounding."""

_NONE = (-1, math.nan)


def next_touchdown(H: float, height: float, pieces: Pieces, after: int) -> tuple[int, float]:
    """Next touchdown, counted from the anchor, that lifts the fairlead to `height` above the bed.

    Parameters
    ----------
    H, height, pieces
        As for `walk.drop`.
    after : int
        Touchdown code after which to look; -1 to begin.

    Returns
    -------
    touchdown, V : int, float
        Its code and the vertical force at the fairlead (N); -1 and nan when there is none left.
    """
    for code in range(after + 1, 2 * len(pieces.length)):
        k = code // 2
        carried = pieces.load[k] if code % 2 == 1 else pieces.weight[k] * pieces.length[k]
        if carried <= 0.0:
            continue
        low = _weight_above(pieces, code)
        if height == 0.0:
            if code == 2 * len(pieces.length) - 2:
                return code, 0.0
            continue
        if (
            drop(H, low, pieces, code)[0] > height
            or drop(H, low + carried, pieces, code)[0] < height
        ):
            continue
        V = vertical_force(H, height, pieces, code, low + 0.5 * carried, low, 0.0)
        if not math.isnan(V):
            return code, V
    return _NONE


def _weight_above(pieces: Pieces, code: int) -> float:
    """Submerged weight above the piece or the clump weight of a touchdown code, N."""
    k = code // 2
    weight = pieces.weight[k] * pieces.length[k] if code % 2 == 1 else 0.0
    for j in range(k + 1, len(pieces.length)):
        weight += pieces.load[j] + pieces.weight[j] * pieces.length[j]
    return weight


@inlined
def clump_weight(pieces: Pieces, touchdown: int) -> float:
    """Weight of the clump weight at a touchdown, N; 0 when the touchdown is inside a piece."""
    return pieces.load[touchdown // 2] if touchdown % 2 == 1 else 0.0


def is_heavy(pieces: Pieces, upper: int, lower: int) -> bool:
    """Whether everything between two pieces that lie on the bed is heavy enough to lie there."""
    for k in range(lower, upper + 1):
        if pieces.weight[k] < 0.0 or (k > lower and pieces.load[k] < 0.0):
            return False
    return True
