"""The part that hangs from the fairlead, down to the anchor or to its touchdown.

Of all places at which the line could touch down so that what hangs above clears the bed, the one
nearest to the anchor is right: the line lies above every such candidate between the candidate's
touchdown and the fairlead (docs/theory.md, "Which touchdown").
"""

from __future__ import annotations

import math

from catopt.catenary.pieces import LineProblem, Pieces, is_plain, total_length, total_weight
from catopt.catenary.roots import bracket, is_closed, narrowed, trial
from catopt.catenary.suspended import (
    NO_PART,
    NO_TOUCHDOWN,
    Part,
    PartReach,
    inside,
    is_inside,
    part_reach,
    piece_of,
    share,
    with_force,
    with_slope,
)

CLEARANCE = 1e-12
"""How far below the bed, as a part of the length, a hanging line may seem to pass by rounding."""

WELL_HUNG = 1e-9
"""By how much of its length a part may miss its end, where rounding leaves no more."""

LOOSE = 2.0**-49
"""Part of the length that rounding leaves of a height; loose pieces take up what is more.

An inclination of sqrt(2 e) takes up the part e of a piece's length: 1e-12 of it, let pass as
rounding, would hide a span of 1e-6 of the length.
"""

CONTACT = 2.0**-48
"""Part of the length by which rounding may part two places of touchdown that meet: where a line
just touches the bed, neither reaches the other, and the height is met by both."""

MOST_TRIALS = 300
EXACT = 2.0**-52


def upper_part(H: float, problem: LineProblem) -> Part:
    """Find the part that hangs from the fairlead; H is 0 for a line that hangs straight down.

    NO_PART when the search stopped short.
    """
    pieces, height = problem.pieces, problem.fairlead_height
    tolerance = CLEARANCE * total_length(pieces)
    if H == 0.0 and is_plain(problem):
        slack = _lying_slack(problem)
        if slack.top >= 0:
            return slack
    free = _to_anchor(H, problem)
    pulled_down = math.inf
    if free.top >= 0:
        reach = part_reach(free, pieces)
        is_held = problem.anchor_height > 0.0 or pieces.weight[0] <= 0.0
        if problem.anchor_height + reach.low >= -tolerance:
            pulled_down = 0.0 if is_held else max(-reach.V_bottom, 0.0)
            if pulled_down == 0.0:
                return free
    start = _from_fairlead(H, pieces, 0, pieces.length[0], 0, 0.0, NO_TOUCHDOWN)
    for place in range(inside(len(pieces.length))):
        part = to_touchdown(start, height, pieces, place)
        if part.top >= 0 and part_reach(part, pieces).low >= -tolerance:
            return part
    if pulled_down <= 4.0 * rounding_of_V(free, pieces):
        return free
    if height == 0.0 and pieces.weight[len(pieces.length) - 1] >= 0.0:
        return lying_end(H, pieces)
    return NO_PART


def _lying_slack(problem: LineProblem) -> Part:
    """Find the part that hangs straight of a plain line that is longer than its fairlead is high.

    What it would hang as above its anchor cannot be it, for the rest hung below the bed; nor can a
    touchdown above which more hangs, before its stretch, than the height. NO_PART where a piece
    weighs nothing, or the line is hardly longer.
    """
    pieces, height = problem.pieces, problem.fairlead_height
    reaches = (1.0 + WELL_HUNG) * height
    above = 0.0
    first = len(pieces.length)
    for k in range(len(pieces.length) - 1, -1, -1):
        if pieces.weight[k] <= 0.0:
            return NO_PART
        if above <= reaches:
            first = k
        above += pieces.length[k]
    if height <= 0.0 or above <= reaches:
        return NO_PART
    start = _from_fairlead(0.0, pieces, 0, pieces.length[0], 0, 0.0, NO_TOUCHDOWN)
    for place in range(inside(first), inside(len(pieces.length))):
        part = to_touchdown(start, height, pieces, place)
        if part.top >= 0 and part_reach(part, pieces).low >= -CLEARANCE * above:
            return part
    return NO_PART


def lying_end(H: float, pieces: Pieces) -> Part:
    """Return the part without length of a line that lies on the bed from its fairlead on."""
    top = len(pieces.length) - 1
    return Part(H, 0.0, top, pieces.length[top], top, 0.0, top, 0.0, inside(top))


def _from_fairlead(
    H: float, pieces: Pieces, bottom: int, length: float, piece: int, V: float, touchdown: int
) -> Part:
    """Part from the fairlead down, with `length` of the piece in which it ends."""
    top = len(pieces.length) - 1
    return Part(H, 0.0, top, pieces.length[top], bottom, length, piece, V, touchdown)


# ------------------------------------------------------------------ to the anchor


def _to_anchor(H: float, problem: LineProblem) -> Part:
    """Hang the whole line between its ends, whatever it passes through."""
    pieces = problem.pieces
    length = total_length(pieces)
    rise = problem.fairlead_height - problem.anchor_height
    slope = max(-0.999, min(0.999, rise / length))
    V = H * slope / math.sqrt(1.0 - slope * slope) - 0.5 * total_weight(pieces)
    start = _from_fairlead(H, pieces, 0, pieces.length[0], 0, V, NO_TOUCHDOWN)
    part = hung_between(start, 0.1 * (H + abs(V)), rise, pieces)
    for _ in range(2):
        if part.top < 0:
            return part
        # Once more from where the vertical force is smallest, and so known to the last digit.
        if part_reach(part, pieces).smallest == part.piece:
            break
        part = hung_from_lightest(part, rise, pieces)
    scale = max(length, abs(rise))
    left = abs(part_reach(part, pieces).z - rise)
    if H == 0.0 and left > LOOSE * scale:
        inclined = _with_loose_pieces(part, rise, pieces)
        if inclined.top >= 0:
            return inclined
    return part if left <= WELL_HUNG * scale else NO_PART


def force_at_piece(part: Part, pieces: Pieces, piece: int) -> float:
    """Count the vertical force at the lower end of a piece from the one where it is known, N."""
    V = part.V
    for k in range(part.piece, piece):
        V += pieces.weight[k] * share(part, pieces, k) + pieces.load[k + 1]
    for k in range(piece, part.piece):
        V -= pieces.weight[k] * share(part, pieces, k) + pieces.load[k + 1]
    return V


def rounding_of_V(part: Part, pieces: Pieces) -> float:
    """Bound of what counting from one end of a part to the other leaves open of V, N.

    A rounding for each piece and load passed, of no more than all of them together.
    """
    gross = abs(part.V)
    for k in range(part.bottom, part.top + 1):
        gross += abs(pieces.weight[k]) * share(part, pieces, k) + abs(pieces.load[k])
    return EXACT * (part.top - part.bottom + 2) * gross


def hung_from_lightest(part: Part, rise: float, pieces: Pieces) -> Part:
    """Hang a part once more with its force counted from where that is smallest.

    There its last digit moves the ends the least.
    """
    piece = part_reach(part, pieces).smallest
    V = force_at_piece(part, pieces, piece)
    rounding = EXACT * (part.H + abs(part.V) + abs(V))
    return hung_between(with_force(part, piece, V), rounding, rise, pieces)


def hung_between(start: Part, stride: float, rise: float, pieces: Pieces) -> Part:
    """Find the vertical force with which a part between two fixed ends rises by `rise` (m).

    The search goes from the part's own force in strides (N); NO_PART when they do not enclose one.
    """
    scale = max(total_length(pieces), abs(rise))
    low, high, f_low, f_high = -math.inf, math.inf, -math.inf, math.inf
    stride = max(stride, 1e-300)
    part, reach = _tried(start, start.V, pieces)
    # The guess, and from there Newton's way or ever longer strides until the root is enclosed.
    for _ in range(MOST_TRIALS):
        f = reach.z - rise
        if abs(f) <= EXACT * scale:
            return part
        if f > 0.0:
            high, f_high = part.V, f
        else:
            low, f_low = part.V, f
        if low > -math.inf and high < math.inf:
            break
        step = max(stride, abs(f) / reach.z_V if reach.z_V > 0.0 else 0.0)
        stride *= 8.0
        part, reach = _tried(start, part.V - math.copysign(step, f), pieces)
    if not (low > -math.inf and high < math.inf):
        return NO_PART
    around = bracket(low, high, f_low, f_high)
    guess = math.nan
    for _ in range(MOST_TRIALS):
        if is_closed(around):
            break
        part, reach = _tried(start, trial(around, guess), pieces)
        f = reach.z - rise
        if abs(f) <= EXACT * scale:
            return part
        around = narrowed(around, part.V, f)
        guess = part.V - f / reach.z_V if reach.z_V > 0.0 else math.nan
    below, reach_below = _tried(start, around.low, pieces)
    above, reach_above = _tried(start, around.high, pieces)
    return below if abs(reach_below.z - rise) < abs(reach_above.z - rise) else above


def _tried(start: Part, V: float, pieces: Pieces) -> tuple[Part, PartReach]:
    part = with_force(start, start.piece, V)
    return part, part_reach(part, pieces)


def _with_loose_pieces(part: Part, rise: float, pieces: Pieces) -> Part:
    """Incline the pieces that have neither weight nor force so that the part rises by `rise`."""
    gross = abs(part.V)
    for k in range(len(pieces.length)):
        gross += abs(pieces.weight[k]) * pieces.length[k] + abs(pieces.load[k])
    for k in range(part.bottom, part.top + 1):
        V = force_at_piece(part, pieces, k)
        if pieces.weight[k] == 0.0 and pieces.length[k] > 0.0 and abs(V) <= 16.0 * EXACT * gross:
            inclined = _inclined(with_force(part, k, 0.0), rise, pieces)
            if inclined.top >= 0:
                return inclined
    return NO_PART


def _inclined(part: Part, rise: float, pieces: Pieces) -> Part:
    """Incline the loose pieces of a part that hangs straight, so that it rises by `rise`.

    NO_PART when they are too short for it.
    """
    flat = part_reach(part, pieces).z
    steep = part_reach(with_slope(part, 1.0), pieces).z
    if steep <= flat:
        return NO_PART
    slope = (rise - flat) / (steep - flat)
    return with_slope(part, slope) if abs(slope) <= 1.0 else NO_PART


# ------------------------------------------------------------------ to a touchdown


def to_touchdown(start: Part, height: float, pieces: Pieces, place: int) -> Part:
    """Hang a part from its upper end, `height` above the bed, down to one place of touchdown.

    NO_PART if it cannot touch down there.
    """
    k = piece_of(place)
    most = pieces.load[k] if not is_inside(place) else pieces.length[k]
    if most <= 0.0 or (is_inside(place) and pieces.weight[k] <= 0.0):
        return NO_PART
    lying = _touching(start, pieces, place, 0.0)
    f_low = part_reach(lying, pieces).z - height
    whole = _touching(start, pieces, place, most)
    f_high = part_reach(whole, pieces).z - height
    scale = max(total_length(pieces), height)
    if f_low > CONTACT * scale or f_high < -CONTACT * scale:
        return NO_PART
    if f_high <= 0.0 or f_low >= -EXACT * scale:
        return whole if f_high <= 0.0 else lying
    by_V = pieces.weight[k] if is_inside(place) else 1.0
    around = bracket(0.0, most, f_low, f_high)
    guess = math.nan
    part = lying
    for _ in range(MOST_TRIALS):
        if is_closed(around):
            break
        x = trial(around, guess)
        part = _touching(start, pieces, place, x)
        reach = part_reach(part, pieces)
        f = reach.z - height
        if abs(f) <= EXACT * scale:
            return part
        around = narrowed(around, x, f)
        guess = x - f / (by_V * reach.z_V) if reach.z_V > 0.0 else math.nan
    left = abs(part_reach(part, pieces).z - height)
    if start.H == 0.0 and left > LOOSE * scale:
        inclined = _inclined(lying, height, pieces)
        if inclined.top >= 0:
            return inclined
    if left <= CLEARANCE * scale:
        return part
    closed = _within_rounding(part, height, pieces)
    return part if closed.top < 0 and left <= WELL_HUNG * scale else closed


def _within_rounding(part: Part, rise: float, pieces: Pieces) -> Part:
    """Move V within its rounding until the part fits; NO_PART where that is not enough.

    Next to the last digit of the place of touchdown a light piece further up may turn over.
    """
    closed = hung_from_lightest(part, rise, pieces)
    if closed.top < 0:
        return NO_PART
    moved = abs(force_at_piece(closed, pieces, part.piece) - part.V)
    left = abs(part_reach(closed, pieces).z - rise)
    fits = left <= WELL_HUNG * max(total_length(pieces), abs(rise))
    return closed if fits and moved <= rounding_of_V(part, pieces) else NO_PART


def _touching(start: Part, pieces: Pieces, place: int, x: float) -> Part:
    """Touch down inside a piece, x m of which hang, or at a clump weight lifted by x N."""
    k = piece_of(place)
    length, V = (pieces.length[k], x) if not is_inside(place) else (x, 0.0)
    return Part(start.H, 0.0, start.top, start.top_length, k, length, k, V, place)
