"""Equilibrium of one line under a known horizontal force, and ways to close in on that force.

1. Without buoyant parts and with the anchor on the bed, the height of the fairlead rises with the
   vertical force V there and the suspended part ends where V falls to 0: one safeguarded
   scalar root gives the line.
2. Any other line is a chain of parts: what hangs from the fairlead down to its touchdown or to the
   anchor (upper_part.py), then stretches on the bed and further parts in turn (lower_part.py).
   So are those of the first kind whose weights differ so much that V at the fairlead does not tell
   how the lightest piece hangs.

When the span or the tension is known instead, Newton's method on H and V serves the plain line and
settles in a few steps. What it does not settle goes to a bracketed search over H, which every line
has. Last, what the rounding of the input alone leaves open of the forces.
"""

from __future__ import annotations

import math

from catopt.catenary.lower_part import lower_part, on_bed, touchdown_of
from catopt.catenary.pieces import (
    LineProblem,
    Pieces,
    bed_friction,
    is_inextensible,
    is_plain,
    length_between,
    tension_past_clump,
    total_length,
    total_weight,
)
from catopt.catenary.roots import bracket, is_closed, narrowed, trial
from catopt.catenary.state import (
    BELOW_ANCHOR,
    CONVERGED,
    GROUNDED,
    GROUNDED_BETWEEN,
    GROUNDED_IN_PARTS,
    IN_PARTS,
    NO_DERIVATIVES,
    NOT_CONVERGED,
    ON_BED,
    SLACK,
    SUSPENDED,
    TOO_SHORT,
    State,
    failed,
)
from catopt.catenary.suspended import (
    FIRST_TOUCHDOWN,
    LAST_STEP,
    NO_TOUCHDOWN,
    Part,
    grounded_guess,
    grounded_part,
    is_inside,
    part_reach,
    suspended_part,
    vertical_force,
)
from catopt.catenary.upper_part import MOST_TRIALS, upper_part
from catopt.compiled import inlined

WELL_LAID = 1e-11
"""How far rounding of V may move an end of the line, as a part of its length."""


def given_force(H: float, problem: LineProblem) -> State:
    """Solve a line whose horizontal force at the fairlead is known, N, above 0."""
    pieces = problem.pieces
    rise = problem.fairlead_height - problem.anchor_height
    length = total_length(pieces)
    if abs(rise) >= length and is_inextensible(pieces):
        return failed(TOO_SHORT)
    if is_plain(problem):
        state = _plain(H, pieces, rise, problem.friction, length)
        if state.status == CONVERGED and is_certain(state, pieces, length):
            return state
    return in_parts(upper_part(H, problem), problem)


def hang_slack(problem: LineProblem) -> State:
    """State of a line that carries no horizontal force; its span is the largest of such a line."""
    rise = problem.fairlead_height - problem.anchor_height
    if is_inextensible(problem.pieces) and abs(rise) >= total_length(problem.pieces):
        return failed(TOO_SHORT)
    return in_parts(upper_part(0.0, problem), problem)


def without_force(state: State, span: float) -> State:
    """Return the state of a slack line with its ends closer together."""
    return State(
        state.status,
        SLACK,
        state.touchdown,
        0.0,
        state.V,
        span,
        state.height_error,
        state.grounded,
        0.0,
        state.V_anchor,
        *NO_DERIVATIVES,
    )


@inlined
def is_certain(state: State, pieces: Pieces, length: float) -> bool:
    """Whether the rounding of V at the fairlead moves the ends of the line by next to nothing.

    V at any joint is V at the fairlead less the weight above, with an error of as many roundings
    as there are pieces; the derivatives by V tell what that does to the height and the span.
    """
    rounding = 2.0**-52 * (len(pieces.length) + 1) * (abs(state.V) + state.H)
    moved = rounding * max(state.z_V, abs(state.x_V))
    return moved <= WELL_LAID * length


@inlined
def _plain(H: float, pieces: Pieces, height: float, friction: float, length: float) -> State:
    """State of a line without buoyant parts, anchored on the bed."""
    if height == 0.0:
        return hung_state(H, 0.0, pieces, 0.0, friction, FIRST_TOUCHDOWN)
    weight = total_weight(pieces)
    guess = grounded_guess(H, pieces, height, length, weight)
    V = vertical_force(H, height, pieces, length, weight, guess, LAST_STEP)
    state = hung_state(H, V, pieces, height, friction, FIRST_TOUCHDOWN)
    if abs(state.height_error) <= 1e-14 * length:
        return state
    V = vertical_force(H, height, pieces, length, weight, V, 0.0)
    return hung_state(H, V, pieces, height, friction, FIRST_TOUCHDOWN)


@inlined
def hung_state(
    H: float, V: float, pieces: Pieces, rise: float, friction: float, touchdown: int
) -> State:
    """State of a line that hangs from the anchor, or from a touchdown beyond which all lies."""
    if math.isnan(V):
        return failed(NOT_CONVERGED)
    hung = suspended_part(H, V, pieces, touchdown)
    bottom = hung.bottom
    if hung.touchdown == NO_TOUCHDOWN:
        # An anchor pulled down by less than the rounding of V is not pulled down.
        regime = BELOW_ANCHOR if hung.V < -1e-12 * (H + abs(V)) else SUSPENDED
        grounded, bed_x, bed_x_H, H_anchor, V_anchor = 0.0, 0.0, 0.0, H, hung.V
    else:
        regime = GROUNDED if V > 0.0 else ON_BED
        piece, rest, H_bed = bottom, pieces.length[bottom] - hung.bottom_length, H
        if not is_inside(hung.touchdown):
            piece, rest = bottom - 1, pieces.length[bottom - 1]
            H_bed = tension_past_clump(H, pieces, bottom, friction, pieces.load[bottom] - hung.V)
        grounded = length_between(pieces, piece, rest, 0, 0.0)
        bed_x, bed_x_H, H_anchor = grounded_part(H_bed, pieces, friction, piece, rest, 0, 0.0)
        V_anchor = 0.0
    return State(
        CONVERGED,
        regime,
        hung.touchdown,
        H,
        V,
        hung.x + bed_x,
        hung.z - rise,
        grounded,
        H_anchor,
        V_anchor,
        hung.x_H + bed_x_H,
        hung.z_H + friction * bed_x_H,
        hung.z_H,
        hung.z_V,
    )


def in_parts(upper: Part, problem: LineProblem) -> State:
    """State of any line, part after part; H may be 0."""
    pieces, anchor_height, height, friction = problem
    if upper.top < 0:
        return failed(NOT_CONVERGED)
    reach = part_reach(upper, pieces)
    error = reach.z - (height if upper.touchdown != NO_TOUCHDOWN else height - anchor_height)
    V = reach.V_top
    x, x_H, x_V = reach.x, reach.x_H, reach.z_H
    z_H, z_V = reach.z_H, reach.z_V
    # How the horizontal force of a part, and the weight that it lifts off the bed above its
    # touchdown, follow H and V at the fairlead.
    H_by_H, H_by_V, lift_by_H, lift_by_V = 1.0, 0.0, 0.0, 1.0
    grounded, stretches, lies = 0.0, 0, False
    H_anchor, V_anchor = upper.H, reach.V_bottom
    part = upper
    while part.touchdown != NO_TOUCHDOWN:
        down = touchdown_of(part, reach.V_bottom, pieces)
        hold = bed_friction(pieces, down.clump, friction) if down.clump >= 0 else friction
        H_by_H, H_by_V = H_by_H + hold * lift_by_H, H_by_V + hold * lift_by_V
        stretches += 1
        part = lower_part(down, problem)
        if part.top < 0 or stretches > len(pieces.length):
            return failed(NOT_CONVERGED)
        end, end_rest = part.top, part.top_length
        bed = grounded_part(
            on_bed(down, problem), pieces, friction, down.piece, down.rest, end, end_rest
        )
        grounded += length_between(pieces, down.piece, down.rest, end, end_rest)
        x += bed.x
        x_H += bed.x_H * H_by_H
        x_V += bed.x_H * H_by_V
        lies = part.bottom < 0
        if lies:
            H_anchor, V_anchor = bed.H, 0.0
            break
        reach = part_reach(part, pieces)
        # The part's height is held: what it lifts follows its horizontal force by `gain`, and
        # friction passes on what that takes off the bed.
        gain = reach.z_H / reach.z_V if reach.z_V > 0.0 else 0.0
        passed = 1.0 / (1.0 - hold * gain) if part.H > 0.0 else 0.0
        H_by_H, H_by_V = H_by_H * passed, H_by_V * passed
        lift_by_H, lift_by_V = -gain * H_by_H, -gain * H_by_V
        x += reach.x
        x_H += (reach.x_H - reach.z_H * gain) * H_by_H
        x_V += (reach.x_H - reach.z_H * gain) * H_by_V
        H_anchor, V_anchor = part.H, reach.V_bottom
    regime = GROUNDED_BETWEEN
    if stretches == 0:
        # An anchor pulled down by less than the rounding of V is not pulled down.
        below = V_anchor < -1e-12 * (upper.H + abs(V) + abs(V_anchor))
        regime = BELOW_ANCHOR if below else SUSPENDED
    elif stretches > 1:
        regime = GROUNDED_IN_PARTS
    elif lies:
        regime = GROUNDED if V > 0.0 else ON_BED
    if upper.H == 0.0:
        x_H = x_V = z_H = z_V = 0.0
    return State(
        CONVERGED,
        regime,
        IN_PARTS,
        upper.H,
        V,
        x,
        error,
        grounded,
        H_anchor,
        V_anchor,
        x_H,
        x_V,
        z_H,
        z_V,
    )


BY_SPAN = 0
BY_TENSION = 1
BY_FORCE = 2

HALF_A_DIGIT = 2.0**-53
"""Part of a number by which its nearest double misses it at most."""

LEFT_BY_SOLVER = 2.0**-49
"""Part of the length by which the solver itself may miss the span or the height by rounding."""


def newton(known: int, wanted: float, problem: LineProblem, H: float, V: float) -> State:
    """Newton's method on (span or tension, height); a failed state when it does not settle."""
    pieces, height, friction = problem.pieces, problem.fairlead_height, problem.friction
    length = total_length(pieces)
    size = wanted if known == BY_TENSION else length
    is_near = False
    for _ in range(26):
        state = hung_state(H, V, pieces, height, friction, FIRST_TOUCHDOWN)
        z_error = state.height_error
        if known == BY_TENSION:
            T = tension_of(state)
            error, by_H, by_V = T - wanted, H / T, V / T
        else:
            error, by_H, by_V = state.span - wanted, state.x_H, state.x_V
        if is_near and abs(error) <= 1e-14 * size and abs(z_error) <= 1e-14 * size:
            return state if is_certain(state, pieces, length) else failed(NOT_CONVERGED)
        determinant = by_H * state.z_V - by_V * state.z_H
        if determinant == 0.0 or math.isnan(determinant):
            break
        dH = (by_V * z_error - state.z_V * error) / determinant
        dV = (state.z_H * error - by_H * z_error) / determinant
        steps = max(abs(dH) / H, abs(dV) / max(V, H))
        if steps <= 1e-15:
            return state if is_certain(state, pieces, length) else failed(NOT_CONVERGED)
        H = min(max(H + dH, 0.1 * H), 10.0 * H)
        V = max(V + dV, 0.1 * V)
        is_near = steps <= LAST_STEP
    return failed(NOT_CONVERGED)


def bracketed_search(
    known: int, wanted: float, problem: LineProblem, below: float, above: float
) -> State:
    """Close in on H between two forces, on a logarithmic scale.

    The known quantity (m or N) is too small at `below` and too large at `above`, N; either may be
    the larger force. NOT_CONVERGED when it jumps over the wanted value, or the search stopped
    short.
    """
    size = wanted if known == BY_TENSION else max(wanted, total_length(problem.pieces))
    sense = 1.0 if below < above else -1.0
    around = bracket(sense * math.log(below), sense * math.log(above), -math.inf, math.inf)
    best = failed(NOT_CONVERGED)
    best_error = math.inf
    guess = math.nan
    for _ in range(MOST_TRIALS):
        if is_closed(around):
            break
        x = trial(around, guess)
        H = math.exp(sense * x)
        state = given_force(H, problem)
        if state.status != CONVERGED:
            return state
        error = _reached(known, state) - wanted
        if abs(error) < best_error:
            best, best_error = state, abs(error)
        if abs(error) <= 1e-15 * size:
            break
        around = narrowed(around, x, error)
        slope = sense * state.H * _by_force(known, state)
        guess = x - error / slope if slope > 0.0 else math.nan
    if known == BY_TENSION and best_error > 1e-15 * size and best.H < wanted:
        best, best_error = _with_tension(best, wanted, best_error, total_length(problem.pieces))
    if best_error <= 1e-9 * size:
        return best
    return failed(NOT_CONVERGED)


def _with_tension(state: State, wanted: float, error: float, length: float) -> tuple[State, float]:
    """Give a line the very tension wanted where that moves its fairlead by less than rounding.

    A line that does not stretch and hangs nearly straight: the last digit of its height moves the
    tension by more than its own last digits.
    """
    V = math.copysign(math.sqrt((wanted - state.H) * (wanted + state.H)), state.V)
    shift = V - state.V
    if state.regime not in (SUSPENDED, BELOW_ANCHOR) or abs(shift) * state.z_V > 1e-12 * length:
        return state, error
    shifted = State(
        state.status,
        state.regime,
        state.touchdown,
        state.H,
        V,
        state.span + state.x_V * shift,
        state.height_error + state.z_V * shift,
        state.grounded,
        state.H_anchor,
        state.V_anchor + shift,
        state.x_H,
        state.x_V,
        state.z_H,
        state.z_V,
    )
    return shifted, 0.0


def _reached(known: int, state: State) -> float:
    return tension_of(state) if known == BY_TENSION else state.span


def _by_force(known: int, state: State) -> float:
    """Return the derivative of tension or span by H at a fixed height; nan where there is none."""
    if state.z_V <= 0.0:
        # A fairlead that lies on the bed stays there.
        return state.x_H if known == BY_SPAN and state.x_H > 0.0 else math.nan
    V_H = -state.z_H / state.z_V
    if known == BY_TENSION:
        return (state.H + state.V * V_H) / tension_of(state)
    return state.x_H + state.x_V * V_H


def tension_of(state: State) -> float:
    """Tension at the fairlead, N."""
    return math.sqrt(state.H * state.H + state.V * state.V)


@inlined
def force_uncertainty(state: State, problem: LineProblem, known: int) -> float:
    """Bound of the change of the forces at the fairlead when every input is off by its rounding, N.

    The lengths, the span and the heights are moved by half a unit in their last place, all in the
    worst sense, with what rounding leaves of the solver's own residual, and the forces follow by
    the line's derivatives. A line that does not stretch and is nearly taut magnifies this by as
    much as it is stiff. What is `known` is BY_SPAN, BY_TENSION, or else the horizontal force.
    """
    T = math.sqrt(state.H * state.H + state.V * state.V)
    own = HALF_A_DIGIT * T
    if state.H == 0.0 or state.z_V <= 0.0:
        return own
    length = total_length(problem.pieces)
    left = LEFT_BY_SOLVER * length
    dz = left + HALF_A_DIGIT * (length + problem.fairlead_height + problem.anchor_height)
    if known == BY_SPAN:
        dx = left + HALF_A_DIGIT * (length + state.span)
        determinant = state.x_H * state.z_V - state.x_V * state.z_H
        if determinant <= 0.0:
            return own
        dH = (state.z_V * dx + abs(state.x_V) * dz) / determinant
        dV = (abs(state.z_H) * dx + abs(state.x_H) * dz) / determinant
    elif known == BY_TENSION:
        # With the tension and the height held H dH + V dV = T dT, z_H dH + z_V dV = dz.
        determinant = state.H * state.z_V - state.V * state.z_H
        if determinant == 0.0:
            return own
        dH = (state.z_V * T * own + abs(state.V) * dz) / abs(determinant)
        dV = (abs(state.z_H) * T * own + state.H * dz) / abs(determinant)
    else:
        dH = own
        dV = (dz + abs(state.z_H) * dH) / state.z_V
    return own + max(dH, dV)
