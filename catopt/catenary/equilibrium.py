"""Equilibrium of one line under a known horizontal force.

1. Without buoyant parts and with the anchor on the bed, the height of the fairlead rises with the
   vertical force V there and the suspended part ends where V falls to 0: one safeguarded
   scalar root gives the line.
2. Any other line is a chain of parts: what hangs from the fairlead down to its touchdown or to the
   anchor (upper_part.py), then stretches on the bed and further parts in turn (lower_part.py).
   So are those of the first kind whose weights differ so much that V at the fairlead does not tell
   how the lightest piece hangs.
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
from catopt.catenary.upper_part import upper_part
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
