"""Equilibrium of one line whose span, or whose fairlead tension, is known instead of its force."""

from __future__ import annotations

import math

from catopt.catenary.equilibrium import (
    BY_SPAN,
    BY_TENSION,
    bracketed_search,
    given_force,
    hang_slack,
    newton,
    tension_of,
    without_force,
)
from catopt.catenary.pieces import (
    GREATEST_FORCE,
    LEAST_FORCE,
    LineProblem,
    Pieces,
    is_inextensible,
    is_plain,
    total_length,
    total_weight,
)
from catopt.catenary.sliding import from_its_anchor, loose, onset_of, reversed_state
from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_HEAVY, TOO_SHORT, State, failed
from catopt.catenary.suspended import grounded_guess, top_weight

PLUMB = 2.0**-40
"""Span of a plumb line, as a part of its length, at which it is solved: the forces differ from
those of span 0 by the square of it, which is no digit of theirs."""


def given_span(span: float, problem: LineProblem, H_guess: float, V_guess: float) -> State:
    """Solve a line whose span (m) is known; guesses of H and V in N, nan for none."""
    if span > 0.0:
        return _spread(span, problem, H_guess, V_guess)
    state = _spread(PLUMB * total_length(problem.pieces), problem, math.nan, math.nan)
    if state.status != CONVERGED:
        return state
    return State(
        state.status,
        state.regime,
        state.touchdown,
        0.0,
        state.V,
        0.0,
        state.height_error,
        state.grounded,
        0.0,
        state.V_anchor,
        state.x_H,
        state.x_V,
        state.z_H,
        state.z_V,
    )


def _spread(span: float, problem: LineProblem, H_guess: float, V_guess: float) -> State:
    """Solve a line whose span is above 0."""
    pieces = problem.pieces
    length = total_length(pieces)
    rise = problem.fairlead_height - problem.anchor_height
    if is_inextensible(pieces) and math.sqrt(span * span + rise * rise) >= length:
        return failed(TOO_SHORT)
    if span <= (1.0 + 2.0**-50) * length - _least_hanging(problem):
        slack = hang_slack(problem)
        if slack.status == CONVERGED and span <= slack.span + 2.0**-50 * length:
            return without_force(slack, span)
    if math.isnan(H_guess):
        H_guess, V_guess = _guess(span, rise, pieces)
    if is_plain(problem):
        if rise > 0.0:
            state = newton(BY_SPAN, span, problem, H_guess, V_guess)
        else:
            state = _lying(span, problem, H_guess)
        if state.status == CONVERGED:
            return state
    return _bracketed(span, problem, H_guess)


def _bracketed(span: float, problem: LineProblem, H_guess: float) -> State:
    """Solve a line of any kind between two forces with a smaller and a larger span."""
    below, above = _enclosed(span, problem, H_guess)
    if math.isnan(above):
        return failed(NOT_CONVERGED)
    if math.isnan(below):
        return given_force(above, problem)
    state = bracketed_search(BY_SPAN, span, problem, below, above)
    if state.status == NOT_CONVERGED and problem.friction > 0.0:
        return _while_sliding(span, problem)
    return state


def _lying(span: float, problem: LineProblem, H: float) -> State:
    """Newton's method on the force of a line that lies on the bed from end to end.

    It stretches by a sum that is linear in the force, but for what friction leaves of that.
    """
    size = max(span, total_length(problem.pieces))
    for _ in range(25):
        state = given_force(H, problem)
        error = state.span - span
        if state.status != CONVERGED or not state.x_H > 0.0:
            break
        if abs(error) <= 1e-15 * size:
            return state
        H = max(H - error / state.x_H, 0.1 * H)
    return failed(NOT_CONVERGED)


def _while_sliding(span: float, problem: LineProblem) -> State:
    """Solve a line for a span that its equilibria under a rising force leave out."""
    other_way = from_its_anchor(problem)
    below, above = _enclosed(span, other_way, math.nan)
    if not math.isnan(below + above):
        state = bracketed_search(BY_SPAN, span, other_way, below, above)
        if state.status == CONVERGED:
            return reversed_state(state)
    return loose(onset_of(span, problem), problem)


def _least_hanging(problem: LineProblem) -> float:
    """Return a length that surely hangs straight when the line is slack, before its stretch, m."""
    pieces = problem.pieces
    weight = 0.0
    softest = 0.0
    for k in range(len(pieces.length)):
        weight += abs(pieces.length[k] * pieces.weight[k]) + abs(pieces.load[k])
        softest = max(softest, pieces.compliance[k])
        if pieces.weight[k] == 0.0:
            return 0.0  # what weighs nothing may hang at any slope
    return (
        (problem.fairlead_height + problem.anchor_height) / (1.0 + softest * weight) * (1.0 - 1e-12)
    )


def _guess(span: float, rise: float, pieces: Pieces) -> tuple[float, float]:
    """Estimate H and V: from the length to spare, from the sag, or from the stretch if taut."""
    length = total_length(pieces)
    weight = abs(total_weight(pieces))
    chord = math.sqrt(span * span + rise * rise)
    stretch = 0.0
    for k in range(len(pieces.length)):
        stretch += pieces.compliance[k] * pieces.length[k]
    # A catenary from the bed up spares L - S = d. For a uniform one d/h depends on a/h alone,
    # sqrt(1 + 2 a/h) - (a/h) acosh(1 + h/a); this inverts it to a few percent.
    spare = (length - span) / rise if rise > 0.0 else 0.0
    if 0.0 < spare < 1.0:
        ratio = 2.0 / 9.0 * (1.0 - spare * spare) / (spare * spare)
        hanging = rise * math.sqrt(1.0 + 2.0 * ratio)
        carried = top_weight(pieces, hanging)
        if hanging < length and carried > 0.0:
            lifted = carried / hanging * rise
            H = ratio * lifted
            return H, math.sqrt(lifted * (lifted + 2.0 * H))
    H = 0.0
    excess = (length * length - rise * rise) / (span * span) - 1.0
    if excess > 0.0:
        H = 0.5 * weight / length * span / math.sqrt(3.0 * excess)
    if stretch > 0.0 and (H == 0.0 or chord > length):
        sagging = (weight * weight * length / 24.0 / stretch) ** (1.0 / 3.0)
        H = max(max(chord - length, 0.0) / stretch, sagging) * span / chord
    elif H == 0.0:
        H = weight
    return H, grounded_guess(H, pieces, max(rise, 0.0), length, total_weight(pieces))


def _enclosed(span: float, problem: LineProblem, guess: float) -> tuple[float, float]:
    """Horizontal forces with a smaller and with a larger span, by growing strides, N.

    The lower one is nan where the span is the largest one without force, but for rounding; the
    upper one is nan where none is found.
    """
    scale = max(abs(total_weight(problem.pieces)), 1e-9)
    H = guess if LEAST_FORCE < guess < GREATEST_FORCE else scale
    below, above = math.nan, math.nan
    factor = 2.0
    while math.isnan(below) or math.isnan(above):
        state = given_force(H, problem)
        if state.status != CONVERGED:
            return math.nan, math.nan
        if state.span >= span:
            above = H
            if H == LEAST_FORCE:
                return math.nan, above
            H = max(H / factor, LEAST_FORCE)
        else:
            below = H
            if H == GREATEST_FORCE:
                return below, math.nan
            H = min(H * factor, GREATEST_FORCE)
        factor = min(factor * factor, 1e8)
    return below, above


STRIDE = 0.5
"""Ratio of neighbouring forces of the search down from H = tension."""

FAR_DOWN = 1e-12
"""Part of the tension below which a horizontal force changes nothing any more."""

ROUNDING = 1e-14


def given_tension(tension: float, problem: LineProblem) -> State:
    """Solve a line whose effective tension at the fairlead is known, N, above 0.

    A line that hangs below a raised anchor, or carries a buoy, can have the same tension at several
    horizontal forces. The largest one is taken: there the tension rises with the force.
    """
    pieces = problem.pieces
    rise = problem.fairlead_height - problem.anchor_height
    length = total_length(pieces)
    if abs(rise) >= length and is_inextensible(pieces):
        return failed(TOO_SHORT)
    if rise > 0.0 and is_plain(problem):
        weight = total_weight(pieces)
        if tension <= weight and tension < tension_of(hang_slack(problem)):
            return failed(TOO_HEAVY)
        H = max(tension - top_weight(pieces, rise), 0.05 * tension)
        guess = grounded_guess(H, pieces, rise, length, weight)
        state = newton(BY_TENSION, tension, problem, H, guess)
        if state.status == CONVERGED:
            return state
    state = given_force(tension, problem)
    if state.status == CONVERGED and tension_of(state) <= tension * (1.0 + ROUNDING):
        return state
    below, above = _crossing(tension, problem, tension, True)
    if above <= 0.0:
        return failed(NOT_CONVERGED)
    if below < 0.0:
        return failed(TOO_HEAVY)
    return _between(tension, problem, below, above)


def other_forces(tension: float, problem: LineProblem, found: State) -> list[float]:
    """Return the smaller horizontal forces that give the line the same tension, N."""
    others = []
    # Where the tension rises with the force it is smaller just below the force found.
    H = found.H * (1.0 - 1e-6)
    wants_less = False
    while H > 0.0:
        last = H
        H, above = _crossing(tension, problem, last, wants_less)
        if H < 0.0:
            break
        pair = (H, above) if wants_less else (above, H)
        state = _between(tension, problem, *pair)
        if state.status == CONVERGED and not 0.999 < state.H / found.H < 1.001:
            others.append(state.H)
        wants_less = not wants_less
    return others


def least_tension(problem: LineProblem, tension: float) -> float:
    """Return the smallest fairlead tension that the line has at a horizontal force, N.

    Forces up to `tension` are looked at.
    """
    upright = hang_slack(problem)
    if upright.status != CONVERGED:  # without weight, but stretched upright
        upright = given_span(0.0, problem, math.nan, math.nan)
    least = tension_of(upright)
    H = above = tension
    rose = False
    while FAR_DOWN * tension < H:
        state = given_force(H, problem)
        if state.status == CONVERGED:
            falls = _falls(state)
            least = min(least, tension_of(state))
            if falls and rose:
                least = min(least, tension_of(_turning(problem, H, above, True)))
            rose = not falls
        above = H
        H *= STRIDE
    return least


def _between(tension: float, problem: LineProblem, below: float, above: float) -> State:
    """State between a force with too little tension, which may be 0, and one with too much."""
    if min(below, above) == 0.0:
        # Without force the tension is on the other side of the one wanted, or the very one.
        state = given_force(max(below, above), problem)
        if abs(tension_of(state) - tension) <= ROUNDING * tension:
            return state
        below, above = max(below, LEAST_FORCE), max(above, LEAST_FORCE)
    return bracketed_search(BY_TENSION, tension, problem, below, above)


def _crossing(
    tension: float, problem: LineProblem, start: float, wants_less: bool
) -> tuple[float, float]:
    """Look down from a horizontal force for a fairlead tension on the other side of the one wanted.

    Returns the horizontal force on that side, 0 among them, and the one before it, N; -1 for the
    first when there is none, for both when a line has no answer.
    """
    above = H = start
    # Whether the last tension looked at turns towards the side wanted further down.
    turned = False
    while FAR_DOWN * tension < H:
        state = given_force(H, problem)
        if state.status != CONVERGED:
            return -1.0, -1.0
        if turned and _falls(state) == wants_less:
            # Between the last two forces there is a valley, or a hill.
            turning = _turning(problem, H, above, wants_less)
            if (tension_of(turning) <= tension) == wants_less:
                return turning.H, above
        if (tension_of(state) <= tension) == wants_less:
            return H, above
        turned = _falls(state) != wants_less
        above = H
        H *= STRIDE
    slack = tension_of(hang_slack(problem))
    if (slack <= tension * (1.0 + ROUNDING)) == wants_less:
        return 0.0, above
    return -1.0, above


def _turning(problem: LineProblem, low: float, high: float, is_valley: bool) -> State:
    """Bisect towards the least or the largest tension between two horizontal forces."""
    state = given_force(low, problem)
    for _ in range(60):
        H = math.sqrt(low * high)
        if not low < H < high:
            break
        state = given_force(H, problem)
        if _falls(state) == is_valley:
            low = H
        else:
            high = H
    return state


def _falls(state: State) -> bool:
    """Whether the fairlead tension falls as H grows at a fixed height."""
    return state.H * state.z_V < state.V * state.z_H
