"""A line whose friction lets it slide: the spans between the two sides of a jump.

With much friction the span of a line that leaves the bed again (towards a raised anchor or under a
buoy) can jump as the horizontal force grows: at one force it rests with most of it on the bed and
nothing left of the force, and with most of it lifted and nothing lost. Between the two it has an
equilibrium at every span; under a constant force it would slide out of it, between ends that are
held it stays. Followed from the anchor, the tension grows along the bed: so there the span is
sought over the force at the anchor.

The spans between that of no force at all and that of no force at the anchor are sought over a place
on the bed. Either the tension begins there and all below lies loose, or the line leaves the bed
there towards the anchor, with the one force with which it just clears it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.catenary.equilibrium import in_parts
from catopt.catenary.lower_part import Touchdown, just_clear, lower_part, touchdown_of
from catopt.catenary.pieces import (
    LineProblem,
    Pieces,
    above,
    bed_friction,
    below,
    reversed_pieces,
    total_length,
)
from catopt.catenary.roots import bracket, is_closed, narrowed, trial
from catopt.catenary.state import (
    CONVERGED,
    GROUNDED,
    GROUNDED_BETWEEN,
    GROUNDED_IN_PARTS,
    LOOSE,
    NO_DERIVATIVES,
    NOT_CONVERGED,
    ON_BED,
    TURNED,
    State,
    failed,
)
from catopt.catenary.suspended import (
    NO_PART,
    NO_TOUCHDOWN,
    Part,
    at_clump,
    inside,
    is_inside,
    part_reach,
    piece_of,
)
from catopt.catenary.upper_part import WELL_HUNG, lying_end, upper_part


class Onset(NamedTuple):
    """Where the tight part of a line begins, on the bed.

    place is `inside` a piece, `at_clump` below one, or -1: nowhere;
    x how much of the piece lies below the place (m), or the part of the clump weight's friction
    that does not act; `part` what leaves the bed there, or further down if its horizontal force is
    0.
    """

    place: int
    x: float
    part: Part


NOWHERE = Onset(-1, 0.0, NO_PART)


def from_its_anchor(problem: LineProblem) -> LineProblem:
    """Return the line with its ends exchanged: friction adds to its tension on the way down."""
    return LineProblem(
        reversed_pieces(problem.pieces),
        problem.fairlead_height,
        problem.anchor_height,
        -problem.friction,
    )


def reversed_state(state: State) -> State:
    """Return the state of a line that was solved with its ends exchanged."""
    return State(
        state.status,
        state.regime,
        TURNED,
        state.H_anchor,
        -state.V_anchor,
        state.span,
        -state.height_error,
        state.grounded,
        state.H,
        -state.V,
        *NO_DERIVATIVES,
    )


def onset_of(span: float, problem: LineProblem) -> Onset:
    """Find where the tight part begins of a line with a known span.

    Without force the line hangs straight and lies in stretches on the bed. From the uppermost place
    of these downwards the span grows with the length that is tight.
    """
    pieces = problem.pieces
    part = upper_part(0.0, problem)
    while part.top >= 0 and part.touchdown != NO_TOUCHDOWN:
        down = touchdown_of(part, part_reach(part, pieces).V_bottom, pieces)
        part = lower_part(down, problem)
        onset = _where_it_lies(span, problem, down, part)
        if onset.place < 0 <= part.bottom:
            onset = _where_it_leaves(span, problem, down, part)
        if onset.place >= 0:
            return onset
    return NOWHERE


def _where_it_lies(span: float, problem: LineProblem, down: Touchdown, part: Part) -> Onset:
    """Look for the onset in a stretch on the bed, from its upper end down; or NOWHERE."""
    pieces = problem.pieces
    for k in range(down.piece, max(part.top, 0) - 1, -1):
        rest = down.rest if k == down.piece else pieces.length[k]
        if rest == pieces.length[k] and k + 1 < len(pieces.length):
            onset = _between(span, problem, at_clump(k + 1), 1.0, 0.0, part)
            if onset.place >= 0:
                return onset
        end = part.top_length if k == part.top else 0.0
        onset = _between(span, problem, inside(k), rest, end, part)
        if onset.place >= 0:
            return onset
    return NOWHERE


def _where_it_leaves(span: float, problem: LineProblem, down: Touchdown, part: Part) -> Onset:
    """Look for a place where the line leaves a stretch, from its lower end up; or NOWHERE."""
    pieces = problem.pieces
    for k in range(part.top, down.piece + 1):
        low = part.top_length if k == part.top else 0.0
        rest = down.rest if k == down.piece else pieces.length[k]
        onset = _between(span, problem, inside(k), low, rest, NO_PART)
        if onset.place < 0 and rest == pieces.length[k] and k + 1 < len(pieces.length):
            lifted = _lifted_at(k + 1, part, pieces)
            onset = _between(span, problem, at_clump(k + 1), lifted, pieces.load[k + 1], NO_PART)
        if onset.place >= 0:
            return onset
    return NOWHERE


def _between(
    span: float, problem: LineProblem, place: int, first: float, last: float, part: Part
) -> Onset:
    """Find the onset with a span between two places, of which the last has the larger; or NOWHERE.

    `part` is that which leaves the bed further down; NO_PART where it does so at the onset.
    """
    onset = _onset(place, last, part, problem)
    f = _beyond(span, onset, problem)
    if first == last or f < 0.0:
        return NOWHERE
    sense = 1.0 if first < last else -1.0
    around = bracket(sense * first, sense * last, -math.inf, f)
    while abs(f) > 1e-15 * span and not is_closed(around):
        x = trial(around, math.nan)
        onset = _onset(place, sense * x, part, problem)
        f = _beyond(span, onset, problem)
        around = narrowed(around, x, f)
    return onset if abs(f) <= WELL_HUNG * max(span, total_length(problem.pieces)) else NOWHERE


def _beyond(span: float, onset: Onset, problem: LineProblem) -> float:
    """By how much an onset's span is larger, m; infinite where the line does not lie there."""
    reached: float = loose(onset, problem).span
    return math.inf if math.isnan(reached) else reached - span


def _onset(place: int, x: float, part: Part, problem: LineProblem) -> Onset:
    if part.top >= 0:
        return Onset(place, x, part)
    return Onset(place, x if is_inside(place) else 0.0, just_clear(place, x, problem))


def loose(onset: Onset, problem: LineProblem) -> State:
    """State of a line whose tight part begins at a place on the bed."""
    if onset.place < 0 or onset.part.top < 0:
        return failed(NOT_CONVERGED)
    other_way = tight_above(onset, problem)
    tight = in_parts(lying_end(onset.part.H, other_way.pieces), other_way)
    below = loose_below(onset, problem)
    rest = in_parts(start_below(onset, below), below)
    if tight.status != CONVERGED or rest.status != CONVERGED:
        return failed(NOT_CONVERGED)
    leaves = onset.part.H > 0.0
    regime = GROUNDED_BETWEEN
    if GROUNDED_IN_PARTS in (tight.regime, rest.regime):
        regime = GROUNDED_IN_PARTS
    elif rest.regime in (GROUNDED, ON_BED, GROUNDED_BETWEEN):
        lies_to_anchor = rest.regime != GROUNDED_BETWEEN
        regime = GROUNDED_IN_PARTS if leaves else GROUNDED if lies_to_anchor else GROUNDED_BETWEEN
    return State(
        CONVERGED,
        regime,
        LOOSE,
        tight.H_anchor,
        -tight.V_anchor,
        tight.span + rest.span,
        rest.height_error - tight.height_error,
        tight.grounded + rest.grounded,
        rest.H_anchor,
        rest.V_anchor,
        *NO_DERIVATIVES,
    )


def tight_above(onset: Onset, problem: LineProblem) -> LineProblem:
    """Return what lies and hangs above an onset, counted from there."""
    k = piece_of(onset.place)
    if is_inside(onset.place):
        pieces = above(problem.pieces, k, onset.x)
    else:
        # On the bed by a piece without length, with what is not lifted from below of its weight.
        pieces = above(problem.pieces, k - 1, problem.pieces.length[k - 1])
        pieces.weight[0] = 0.0
        pieces.load[1] -= _lifted_at(k, onset.part, problem.pieces)
        own = bed_friction(problem.pieces, k, problem.friction)
        pieces.load[len(pieces.length) + 2] = (1.0 - onset.x) * own
    return from_its_anchor(LineProblem(pieces, 0.0, problem.fairlead_height, problem.friction))


def loose_below(onset: Onset, problem: LineProblem) -> LineProblem:
    """Return what lies and hangs below an onset; a clump weight belongs to both parts."""
    k = piece_of(onset.place)
    if onset.part.H > 0.0:
        pieces = below(problem.pieces, onset.part.top, onset.part.top_length)
    else:
        pieces = below(problem.pieces, k, onset.x if is_inside(onset.place) else 0.0)
        if not is_inside(onset.place):
            pieces.weight[k] = 0.0
    return LineProblem(pieces, problem.anchor_height, 0.0, problem.friction)


def start_below(onset: Onset, below: LineProblem) -> Part:
    """Return the first part of what lies and hangs below an onset."""
    return onset.part if onset.part.H > 0.0 else lying_end(0.0, below.pieces)


def _lifted_at(joint: int, part: Part, pieces: Pieces) -> float:
    """Weight that a part takes off the clump weight on a joint, N."""
    if part.bottom < 0 or part.top != joint - 1 or part.top_length < pieces.length[joint - 1]:
        return 0.0
    return max(-part_reach(part, pieces).V_top, 0.0)
