"""The next part that hangs below a touchdown: where the line leaves the bed again, and to where.

Below a touchdown the line lies on the bed as far as it is heavy. A buoyant part further down, or a
raised anchor, lifts it off. The further up it leaves the bed, the more of its weight hangs and the
higher is all that follows: it leaves the bed where what follows just clears the bed and just
reaches the anchor. Where it touches the bed again the next stretch begins.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.catenary.bracket import bracket, is_closed, narrowed, trial
from catopt.catenary.part import NO_PART, NO_TOUCHDOWN, Part, part_reach, with_force
from catopt.catenary.piece import piece_rise
from catopt.catenary.pieces import Pieces, grip, total_length
from catopt.catenary.setting import Setting
from catopt.catenary.upper_part import (
    CLEARANCE,
    EXACT,
    MOST_TRIALS,
    WELL_HUNG,
    force_at_piece,
    hung_between,
    to_touchdown,
)
from catopt.catenary.walk import lie

__all__ = [
    "Touchdown",
    "last_heavy",
    "lower_part",
    "touchdown_of",
]


class Touchdown(NamedTuple):
    """Where the line comes down on the bed.

    Attributes
    ----------
    H : float
        Horizontal force of what hangs above, N.
    piece, rest : int, float
        Piece in which the stretch on the bed begins, and how much of it is below, m.
    clump : int
        Joint of the clump weight at which it touches down; -1 when there is none.
    carried : float
        What the bed has to carry of that clump weight if nothing lifts it from below, N.
    """

    H: float
    piece: int
    rest: float
    clump: int
    carried: float


class _Clearance(NamedTuple):
    """How far the rest of the line clears the bed, or the anchor's height: the least of it, m.

    `touchdown`, `piece` and `length` say where, as `touchdown`, `bottom` and `bottom_length` of
    Part.
    """

    least: float
    touchdown: int
    piece: int
    length: float


def touchdown_of(part: Part, V_bottom: float, pieces: Pieces) -> Touchdown:
    """Say where a part touches down, V_bottom being the vertical force at its lower end."""
    k = part.touchdown // 2
    if part.touchdown % 2 == 0:
        return Touchdown(part.H, k, pieces.length[k] - part.bottom_length, -1, 0.0)
    return Touchdown(part.H, k - 1, pieces.length[k - 1], k, max(pieces.load[k] - V_bottom, 0.0))


def last_heavy(pieces: Pieces, piece: int) -> int:
    """Lowest piece down to which everything from a given piece on is heavy enough to lie."""
    k = piece
    while k > 0 and pieces.load[k] >= 0.0 and pieces.weight[k - 1] >= 0.0:
        k -= 1
    return k


def lower_part(touchdown: Touchdown, setting: Setting) -> Part:
    """Find the part that leaves the bed below a touchdown.

    Returns
    -------
    Part
        NO_PART when the search stopped short. Only to be called when the line does not lie from
        the touchdown all the way to the anchor.
    """
    pieces = setting.pieces
    first = last_heavy(pieces, touchdown.piece)
    if pieces.weight[touchdown.piece] < 0.0:
        # Nothing lies here: the part leaves the bed at the clump weight or at the fairlead itself.
        first = touchdown.piece + 1
    for j in range(first, touchdown.piece + 1):
        if j > 0 and pieces.load[j] > 0.0:
            part = _lifted(2 * j + 1, pieces.load[j], touchdown, setting)
            if part.top >= 0:
                return part
        length = touchdown.rest if j == touchdown.piece else pieces.length[j]
        if pieces.weight[j] > 0.0 and length > 0.0:
            part = _lifted(2 * j, length, touchdown, setting)
            if part.top >= 0:
                return part
    if touchdown.clump >= 0:
        return _lifted(2 * touchdown.clump + 1, touchdown.carried, touchdown, setting)
    return NO_PART


def _lifted(code: int, most: float, touchdown: Touchdown, setting: Setting) -> Part:
    """Leave the bed inside a piece, or at a clump weight; NO_PART if that does not lift enough.

    `most` is the length of the piece that may hang (m), or the weight that may be lifted (N).
    """
    tolerance = CLEARANCE * total_length(setting.pieces)
    highest = _cleared(code, most, touchdown, setting)
    if highest.least < -tolerance:
        return NO_PART
    low, high = 0.0, most
    f_low, f_high = _cleared(code, low, touchdown, setting).least, highest.least
    if f_low >= 0.0:
        return _part(code, low, touchdown, setting)
    # Where friction leaves no force, the line hangs straight; that root is the first to be met.
    straight = _straight_up_to(code, most, touchdown, setting)
    if 0.0 < straight < most:
        f = _cleared(code, straight, touchdown, setting).least
        if f >= 0.0:
            high, f_high = straight, f
        else:
            low, f_low = straight, f
    around = bracket(low, high, f_low, max(f_high, 0.0))
    x = high
    for _ in range(MOST_TRIALS):
        if is_closed(around):
            break
        x = trial(around, math.nan)
        f = _cleared(code, x, touchdown, setting).least
        if abs(f) <= 1e-4 * tolerance:
            return _part(code, x, touchdown, setting)
        around = narrowed(around, x, f)
    for x in (around.high, around.low):
        left = abs(_cleared(code, x, touchdown, setting).least)
        if left <= WELL_HUNG * total_length(setting.pieces):
            return _part(code, x, touchdown, setting)
    return _loose(code, around.low, touchdown, setting)


def _left(code: int, x: float, touchdown: Touchdown, setting: Setting) -> float:
    """Horizontal force that friction leaves where the line leaves the bed, N."""
    pieces, friction = setting.pieces, setting.friction
    k = code // 2
    if code % 2 == 1 and k == touchdown.clump:
        return max(touchdown.H - grip(pieces, k, friction) * (touchdown.carried - x), 0.0)
    T = touchdown.H
    if touchdown.clump >= 0:
        T = max(T - grip(pieces, touchdown.clump, friction) * touchdown.carried, 0.0)
    if code % 2 == 1:
        T = lie(T, pieces, friction, touchdown.piece, touchdown.rest, k, 0.0).H
        return float(max(T - grip(pieces, k, friction) * (pieces.load[k] - x), 0.0))
    return float(lie(T, pieces, friction, touchdown.piece, touchdown.rest, k, x).H)


def _straight_up_to(code: int, most: float, touchdown: Touchdown, setting: Setting) -> float:
    """Bound of x below which friction leaves no horizontal force; 0 when it always leaves some."""
    if _left(code, 0.0, touchdown, setting) > 0.0:
        return 0.0
    if _left(code, most, touchdown, setting) == 0.0:
        return most
    low, high = 0.0, most
    for _ in range(60):
        middle = 0.5 * (low + high)
        if _left(code, middle, touchdown, setting) > 0.0:
            high = middle
        else:
            low = middle
    return low


def _start(code: int, x: float, pieces: Pieces) -> tuple[int, float, float]:
    """Piece, length of it and vertical force at the upper end of a part that leaves the bed."""
    k = code // 2
    if code % 2 == 0:
        return k, x, 0.0
    return k - 1, pieces.length[k - 1], -x


def _cleared(code: int, x: float, touchdown: Touchdown, setting: Setting) -> _Clearance:
    """Follow the line down from where it leaves the bed to the anchor."""
    pieces = setting.pieces
    H = _left(code, x, touchdown, setting)
    top, top_length, V = _start(code, x, pieces)
    return _followed(H, top, top_length, V, 0.0, setting)


def _followed(
    H: float, top: int, top_length: float, V: float, slope: float, setting: Setting
) -> _Clearance:
    pieces = setting.pieces
    z = 0.0
    least, touchdown, piece, end_length = math.inf, NO_TOUCHDOWN, 0, pieces.length[0]
    for k in range(top, -1, -1):
        length = top_length if k == top else pieces.length[k]
        weight, compliance = pieces.weight[k], pieces.compliance[k]
        V1 = V - weight * length
        if V1 < 0.0 < V:
            hanging = V / weight
            lowest = z - piece_rise(H, 0.0, V, hanging, compliance, 0.0)
            if lowest < least:
                least, touchdown, piece, end_length = lowest, 2 * k, k, min(hanging, length)
        z -= piece_rise(H, V1, V, length, compliance, slope)
        V = V1 - pieces.load[k]
        if k > 0 and V1 >= 0.0 >= V and (V1 > 0.0 or pieces.load[k] > 0.0) and z < least:
            least, touchdown, piece, end_length = z, 2 * k + 1, k, pieces.length[k]
    if z - setting.anchor_height <= least:
        return _Clearance(z - setting.anchor_height, NO_TOUCHDOWN, 0, pieces.length[0])
    return _Clearance(least, touchdown, piece, end_length)


def _part(code: int, x: float, touchdown: Touchdown, setting: Setting) -> Part:
    """Return the part that leaves the bed at a place found."""
    pieces = setting.pieces
    H = _left(code, x, touchdown, setting)
    top, top_length, V = _start(code, x, pieces)
    end = _followed(H, top, top_length, V, 0.0, setting)
    V_low = V - pieces.weight[top] * top_length
    part = Part(H, 0.0, top, top_length, end.piece, end.length, top, V_low, end.touchdown)
    rise = -setting.anchor_height if end.touchdown == NO_TOUCHDOWN else 0.0
    return _closed(part, rise, pieces)


def _closed(part: Part, rise: float, pieces: Pieces) -> Part:
    """Close what rounding leaves open of a part, counted from its touchdown or lightest place."""
    reach = part_reach(part, pieces)
    if abs(reach.z - rise) <= CLEARANCE * total_length(pieces):
        return part
    if part.touchdown != NO_TOUCHDOWN:
        closed = to_touchdown(part, 0.0, pieces, part.touchdown)
    else:
        V = force_at_piece(part, pieces, reach.smallest)
        rounding = EXACT * (part.H + abs(part.V))
        closed = hung_between(with_force(part, reach.smallest, V), rounding, rise, pieces)
    if closed.top < 0:
        return part
    left = abs(part_reach(closed, pieces).z - rise)
    return closed if left < abs(reach.z - rise) else part


def _loose(code: int, x: float, touchdown: Touchdown, setting: Setting) -> Part:
    """Incline pieces without weight or force so that a part that hangs straight fits."""
    pieces = setting.pieces
    if _left(code, x, touchdown, setting) > 0.0:
        return NO_PART
    top, top_length, V = _start(code, 0.0, pieces)
    flat = _followed(0.0, top, 0.0 if code % 2 == 0 else top_length, V, 0.0, setting)
    steep = _followed(0.0, top, 0.0 if code % 2 == 0 else top_length, V, -1.0, setting)
    if not flat.least < 0.0 < steep.least:
        return NO_PART
    slope = flat.least / (steep.least - flat.least)
    length = 0.0 if code % 2 == 0 else top_length
    end = _followed(0.0, top, length, V, slope, setting)
    return Part(0.0, slope, top, length, end.piece, end.length, top, V, end.touchdown)
