"""The next part that hangs below a touchdown: where the line leaves the bed again, and to where.

Below a touchdown the line lies on the bed as far as it is heavy. A buoyant part further down, or a
raised anchor, lifts it off. The further up it leaves the bed, the more of its weight hangs and the
higher is all that follows: it leaves the bed where what follows just clears the bed and just
reaches the anchor. Where it touches the bed again the next stretch begins.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.catenary.pieces import (
    GREATEST_FORCE,
    LineProblem,
    Pieces,
    piece_rise,
    tension_past_clump,
    total_length,
    total_weight,
)
from catopt.catenary.roots import bracket, is_closed, narrowed, trial
from catopt.catenary.suspended import (
    NO_PART,
    NO_TOUCHDOWN,
    TO_THE_ANCHOR,
    Part,
    at_clump,
    grounded_part,
    inside,
    is_inside,
    part_reach,
    piece_of,
)
from catopt.catenary.upper_part import (
    CLEARANCE,
    EXACT,
    MOST_TRIALS,
    WELL_HUNG,
    hung_from_lightest,
    rounding_of_V,
    to_touchdown,
)


class Touchdown(NamedTuple):
    """Where the line comes down on the bed, with horizontal force H (N) in what hangs above.

    The stretch on the bed begins in `piece`, `rest` (m) of which is below. `clump` is the joint of
    the clump weight at which it touches down (-1: none), `carried` what the bed has to carry of
    that clump weight if nothing lifts it from below, N.
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
    k = piece_of(part.touchdown)
    if is_inside(part.touchdown):
        return Touchdown(part.H, k, pieces.length[k] - part.bottom_length, -1, 0.0)
    return Touchdown(part.H, k - 1, pieces.length[k - 1], k, max(pieces.load[k] - V_bottom, 0.0))


def _last_heavy(pieces: Pieces, piece: int) -> int:
    """Lowest piece down to which everything from a given piece on is heavy enough to lie."""
    k = piece
    while k > 0 and pieces.load[k] >= 0.0 and pieces.weight[k - 1] >= 0.0:
        k -= 1
    return k


def lower_part(touchdown: Touchdown, problem: LineProblem) -> Part:
    """Find the part that leaves the bed below a touchdown.

    TO_THE_ANCHOR when the line lies from there on; NO_PART when the search stopped short.
    """
    pieces = problem.pieces
    first = _last_heavy(pieces, touchdown.piece)
    if pieces.weight[touchdown.piece] < 0.0:
        # Nothing lies here: the part leaves the bed at the clump weight or at the fairlead itself.
        first = touchdown.piece + 1
    elif first == 0 and problem.anchor_height == 0.0:
        return TO_THE_ANCHOR
    for j in range(first, touchdown.piece + 1):
        if j > 0 and pieces.load[j] > 0.0:
            part = _lifted(at_clump(j), pieces.load[j], touchdown, problem)
            if part.top >= 0:
                return part
        length = touchdown.rest if j == touchdown.piece else pieces.length[j]
        if pieces.weight[j] > 0.0 and length > 0.0:
            part = _lifted(inside(j), length, touchdown, problem)
            if part.top >= 0:
                return part
    if touchdown.clump >= 0:
        return _lifted(at_clump(touchdown.clump), touchdown.carried, touchdown, problem)
    return NO_PART


def _lifted(place: int, most: float, touchdown: Touchdown, problem: LineProblem) -> Part:
    """Leave the bed inside a piece, or at a clump weight; NO_PART if that does not lift enough.

    `most` is the length of the piece that may hang (m), or the weight that may be lifted (N).
    """
    tolerance = CLEARANCE * total_length(problem.pieces)
    low, high, f_low, f_high = _ends(place, most, touchdown, problem)
    if f_high < -tolerance:
        return NO_PART
    if f_low >= 0.0:
        return _part(place, low, touchdown, problem)
    around = bracket(low, high, f_low, max(f_high, 0.0))
    x = high
    for _ in range(MOST_TRIALS):
        if is_closed(around):
            break
        x = trial(around, math.nan)
        f = _cleared(place, x, touchdown, problem).least
        if abs(f) <= 1e-4 * tolerance:
            return _part(place, x, touchdown, problem)
        around = narrowed(around, x, f)
    return _at_the_last_digit(place, around.low, around.high, touchdown, problem)


def _at_the_last_digit(
    place: int, low: float, high: float, touchdown: Touchdown, problem: LineProblem
) -> Part:
    """Choose between two neighbouring numbers of which neither clears the bed to the last digit."""
    for x in (high, low):
        left = abs(_cleared(place, x, touchdown, problem).least)
        if left <= WELL_HUNG * total_length(problem.pieces):
            return _part(place, x, touchdown, problem)
    loose = _loose(place, low, touchdown, problem)
    if loose.top >= 0:
        return loose
    # V is known to its rounding alone; what is loose leans of itself and has been tried before.
    for x in (high, low):
        part = _part(place, x, touchdown, problem)
        if _is_closed(part, _start(place, x, problem.pieces)[2], problem):
            return part
    return NO_PART


def _ends(
    place: int, most: float, touchdown: Touchdown, problem: LineProblem
) -> tuple[float, float, float, float]:
    """Two places between which the line leaves the bed, if it does, and its clearance from them.

    Where friction leaves no force, the line hangs straight; that root is the first to be met.
    Further on it may hang lower again, for what has left the bed takes less off the force.
    """
    f_low = _cleared(place, 0.0, touchdown, problem).least
    f_high = _cleared(place, most, touchdown, problem).least
    straight = _straight_up_to(place, most, touchdown, problem)
    if f_low < 0.0 < straight < most:
        f = _cleared(place, straight, touchdown, problem).least
        if f >= 0.0:
            return 0.0, straight, f_low, f
        return straight, most, f, f_high
    return 0.0, most, f_low, f_high


def on_bed(touchdown: Touchdown, problem: LineProblem) -> float:
    """Tension with which the stretch on the bed begins, N."""
    if touchdown.clump < 0:
        return touchdown.H
    return tension_past_clump(
        touchdown.H, problem.pieces, touchdown.clump, problem.friction, touchdown.carried
    )


def _left(place: int, x: float, touchdown: Touchdown, problem: LineProblem) -> float:
    """Horizontal force that friction leaves where the line leaves the bed, N."""
    pieces, friction = problem.pieces, problem.friction
    k = piece_of(place)
    if not is_inside(place) and k == touchdown.clump:
        return tension_past_clump(touchdown.H, pieces, k, friction, touchdown.carried - x)
    T = on_bed(touchdown, problem)
    if not is_inside(place):
        T = grounded_part(T, pieces, friction, touchdown.piece, touchdown.rest, k, 0.0).H
        return tension_past_clump(T, pieces, k, friction, pieces.load[k] - x)
    return float(grounded_part(T, pieces, friction, touchdown.piece, touchdown.rest, k, x).H)


def _straight_up_to(place: int, most: float, touchdown: Touchdown, problem: LineProblem) -> float:
    """Bound of x below which friction leaves no horizontal force; 0 when it always leaves some."""
    if _left(place, 0.0, touchdown, problem) > 0.0:
        return 0.0
    if _left(place, most, touchdown, problem) == 0.0:
        return most
    low, high = 0.0, most
    for _ in range(60):
        middle = 0.5 * (low + high)
        if _left(place, middle, touchdown, problem) > 0.0:
            high = middle
        else:
            low = middle
    return low


def _start(place: int, x: float, pieces: Pieces) -> tuple[int, float, float]:
    """Piece, length of it and vertical force at the upper end of a part that leaves the bed."""
    k = piece_of(place)
    if is_inside(place):
        return k, x, 0.0
    return k - 1, pieces.length[k - 1], -x


def just_clear(place: int, x: float, problem: LineProblem) -> Part:
    """Find the part that leaves the bed at a given place with the force that just clears the bed.

    Inside a piece the length `x` (m) of it hangs; at a clump weight `x` (N) of that is lifted.
    NO_PART where it does not clear the bed even without force, or does so with any.
    """
    H, f = 0.0, _cleared(place, x, _leaving(0.0, place, x, problem.pieces), problem).least
    low, f_low = H, f
    stride = abs(total_weight(problem.pieces)) + 1e-9
    while f > 0.0:
        low, f_low = H, f
        H = H + stride
        if H > GREATEST_FORCE:
            return NO_PART
        f = _cleared(place, x, _leaving(H, place, x, problem.pieces), problem).least
        stride *= 4.0
    if f_low < 0.0:
        return NO_PART
    around = bracket(low, H, -f_low, -f)
    while abs(f) > EXACT * total_length(problem.pieces) and not is_closed(around):
        H = trial(around, math.nan)
        f = _cleared(place, x, _leaving(H, place, x, problem.pieces), problem).least
        around = narrowed(around, H, -f)
    return _part(place, x, _leaving(H, place, x, problem.pieces), problem)


def _leaving(H: float, place: int, x: float, pieces: Pieces) -> Touchdown:
    """Return a touchdown in the very place where the line leaves the bed."""
    k = piece_of(place)
    if is_inside(place):
        return Touchdown(H, k, x, -1, 0.0)
    return Touchdown(H, k - 1, pieces.length[k - 1], k, x)


def _cleared(place: int, x: float, touchdown: Touchdown, problem: LineProblem) -> _Clearance:
    """Follow the line down from where it leaves the bed to the anchor."""
    pieces = problem.pieces
    H = _left(place, x, touchdown, problem)
    top, top_length, V = _start(place, x, pieces)
    return _followed(H, top, top_length, V, 0.0, problem)


def _followed(
    H: float, top: int, top_length: float, V: float, slope: float, problem: LineProblem
) -> _Clearance:
    pieces = problem.pieces
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
                least, touchdown, piece, end_length = lowest, inside(k), k, min(hanging, length)
        z -= piece_rise(H, V1, V, length, compliance, slope)
        V = V1 - pieces.load[k]
        if k > 0 and V1 >= 0.0 >= V and (V1 > 0.0 or pieces.load[k] > 0.0) and z < least:
            least, touchdown, piece, end_length = z, at_clump(k), k, pieces.length[k]
    if z - problem.anchor_height <= least:
        return _Clearance(z - problem.anchor_height, NO_TOUCHDOWN, 0, pieces.length[0])
    return _Clearance(least, touchdown, piece, end_length)


def _part(place: int, x: float, touchdown: Touchdown, problem: LineProblem) -> Part:
    """Return the part that leaves the bed at a place found."""
    pieces = problem.pieces
    H = _left(place, x, touchdown, problem)
    top, top_length, V = _start(place, x, pieces)
    end = _followed(H, top, top_length, V, 0.0, problem)
    V_low = V - pieces.weight[top] * top_length
    part = Part(H, 0.0, top, top_length, end.piece, end.length, top, V_low, end.touchdown)
    return _closed(part, _rise(end.touchdown, problem), pieces)


def _closed(part: Part, rise: float, pieces: Pieces) -> Part:
    """Close what rounding leaves open of a part, counted from its touchdown or lightest place."""
    reach = part_reach(part, pieces)
    if abs(reach.z - rise) <= CLEARANCE * total_length(pieces):
        return part
    if part.touchdown != NO_TOUCHDOWN:
        closed = to_touchdown(part, 0.0, pieces, part.touchdown)
    else:
        closed = hung_from_lightest(part, rise, pieces)
    if closed.top < 0:
        return part
    left = abs(part_reach(closed, pieces).z - rise)
    return closed if left < abs(reach.z - rise) else part


def _is_closed(part: Part, V: float, problem: LineProblem) -> bool:
    """Whether a part fits with a force at its upper end that is V but for rounding."""
    pieces = problem.pieces
    reach = part_reach(part, pieces)
    left = abs(reach.z - _rise(part.touchdown, problem))
    is_near = abs(reach.V_top - V) <= rounding_of_V(part, pieces)
    return is_near and left <= WELL_HUNG * total_length(pieces)


def _rise(touchdown: int, problem: LineProblem) -> float:
    """Height of the upper end of a part above its lower end, m."""
    return -problem.anchor_height if touchdown == NO_TOUCHDOWN else 0.0


def _loose(place: int, x: float, touchdown: Touchdown, problem: LineProblem) -> Part:
    """Incline pieces without weight or force so that a part that hangs straight fits."""
    pieces = problem.pieces
    if _left(place, x, touchdown, problem) > 0.0:
        return NO_PART
    top, top_length, V = _start(place, 0.0, pieces)
    flat = _followed(0.0, top, top_length, V, 0.0, problem)
    steep = _followed(0.0, top, top_length, V, -1.0, problem)
    if not flat.least < 0.0 < steep.least:
        return NO_PART
    slope = flat.least / (steep.least - flat.least)
    end = _followed(0.0, top, top_length, V, slope, problem)
    return Part(0.0, slope, top, top_length, end.piece, end.length, top, V, end.touchdown)
