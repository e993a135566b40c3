"""Equilibrium of one line whose span or whose fairlead tension is known instead of H.

Two Newton unknowns, H and V, serve the plain line (anchor on the bed, nothing buoyant). Whatever
they do not settle in a few steps goes to a bracketed search over H, which every line has: both the
span and the tension rise with H. Below the least horizontal force worth the name the line hangs
straight down and is called slack.
"""

from __future__ import annotations

import math

from catopt.catenary.equilibrium import failed, given_force, hung_state
from catopt.catenary.lift import SETTLED, grounded_guess, top_weight
from catopt.catenary.pieces import (
    Pieces,
    has_buoyancy,
    is_inextensible,
    total_length,
    total_weight,
)
from catopt.catenary.state import (
    CONVERGED,
    NOT_CONVERGED,
    SLACK,
    TOO_HEAVY,
    TOO_SHORT,
    TOUCHES_TWICE,
    State,
)
from catopt.catenary.walk import FIRST_TOUCHDOWN

__all__ = ["BY_SPAN", "BY_TENSION", "given_span", "given_tension", "hang_slack"]

BY_SPAN = 0
BY_TENSION = 1

NEARLY_NO_FORCE = 1e-13
"""H as a part of the weight at which a line hangs straight down to double precision."""


def given_span(
    span: float,
    pieces: Pieces,
    anchor_height: float,
    fairlead_height: float,
    friction: float,
    H_guess: float,
    V_guess: float,
) -> State:
    """Solve a line whose span is known.

    Parameters
    ----------
    span : float
        Horizontal distance from the anchor to the fairlead, m, above 0.
    pieces, anchor_height, fairlead_height, friction
        As for `given_force`.
    H_guess, V_guess : float
        Where to start, N; nan to have them estimated.
    """
    length = total_length(pieces)
    rise = fairlead_height - anchor_height
    if is_inextensible(pieces) and math.sqrt(span * span + rise * rise) >= length:
        return failed(TOO_SHORT)
    if span < length - _least_hanging(pieces, fairlead_height, anchor_height):
        slack = hang_slack(pieces, anchor_height, fairlead_height, friction)
        if slack.status == CONVERGED and span <= slack.span:
            return _without_force(slack, SLACK, span)
    if math.isnan(H_guess):
        H_guess, V_guess = _guess(span, rise, pieces)
    if anchor_height == 0.0 and fairlead_height > 0.0 and not has_buoyancy(pieces):
        state = _newton(BY_SPAN, span, pieces, fairlead_height, friction, H_guess, V_guess)
        if state.status == CONVERGED:
            return state
    low, high = _bracket(span, pieces, anchor_height, fairlead_height, friction, H_guess)
    if not low < high:
        return failed(NOT_CONVERGED)
    state = _close_in(BY_SPAN, span, pieces, anchor_height, fairlead_height, friction, low, high)
    if state.status != TOUCHES_TWICE:
        return state
    # It may touch twice between two ranges of force in which it does not: look at each range.
    low, high = _bracket_by_scan(span, pieces, anchor_height, fairlead_height, friction)
    if not low < high:
        return state
    return _close_in(BY_SPAN, span, pieces, anchor_height, fairlead_height, friction, low, high)


def given_tension(
    tension: float,
    pieces: Pieces,
    anchor_height: float,
    fairlead_height: float,
    friction: float,
) -> State:
    """Solve a line whose effective tension at the fairlead is known; arguments as `given_span`.

    A line that hangs below a raised anchor, or carries a buoy, can have the same tension at two
    horizontal forces. The larger one is taken: there the tension rises with the force.
    """
    rise = fairlead_height - anchor_height
    if is_inextensible(pieces) and abs(rise) >= total_length(pieces):
        return failed(TOO_SHORT)
    if anchor_height == 0.0 and fairlead_height > 0.0 and not has_buoyancy(pieces):
        weight = total_weight(pieces)
        if tension <= weight:
            slack = hang_slack(pieces, anchor_height, fairlead_height, friction)
            if slack.status == CONVERGED and tension < slack.V:
                return failed(TOO_HEAVY)
        H = max(tension - top_weight(pieces, rise), 0.05 * tension)
        V = grounded_guess(H, pieces, rise)
        state = _newton(BY_TENSION, tension, pieces, fairlead_height, friction, H, V)
        if state.status == CONVERGED:
            return state
    least, high = least_tension(tension, pieces, anchor_height, fairlead_height, friction)
    if least.status != CONVERGED:
        return least
    if _tension(least) > tension:
        return failed(TOO_HEAVY)
    return _close_in(
        BY_TENSION, tension, pieces, anchor_height, fairlead_height, friction, least.H, high
    )


def least_tension(
    tension: float,
    pieces: Pieces,
    anchor_height: float,
    fairlead_height: float,
    friction: float,
) -> tuple[State, float]:
    """Look down from H = `tension` for a fairlead tension that small; arguments as `given_tension`.

    Returns
    -------
    state : State
        The first one found with no more than `tension`, else the one with the least.
    above : float
        A horizontal force above it at which the tension is larger, N.
    """
    floor = NEARLY_NO_FORCE * max(abs(total_weight(pieces)), tension)
    least = failed(TOUCHES_TWICE)
    above = tension
    H = tension
    touched = False
    while H > floor:
        state = given_force(H, pieces, anchor_height, fairlead_height, friction)
        touches = state.status == TOUCHES_TWICE
        if state.status == CONVERGED:
            if _falls(state) and above > H:
                state = _valley(
                    tension, pieces, anchor_height, fairlead_height, friction, H, above, state
                )
            if least.status != CONVERGED or _tension(state) < _tension(least):
                least = state
            if _tension(state) <= tension:
                return state, above
            above = H
        elif not touches:
            return state, above
        elif least.status == CONVERGED and not touched:
            state = _valley(
                tension, pieces, anchor_height, fairlead_height, friction, H, above, least
            )
            if _tension(state) <= tension:
                return state, above
            least = state
        touched = touches
        H *= 0.5
    return least, above


def _valley(
    tension: float,
    pieces: Pieces,
    anchor_height: float,
    fairlead_height: float,
    friction: float,
    low: float,
    high: float,
    least: State,
) -> State:
    """Bisect towards the least tension between two horizontal forces.

    At the lower one the tension falls with H, or the line touches the bed twice.
    """
    for _ in range(60):
        H = math.sqrt(low * high)
        state = given_force(H, pieces, anchor_height, fairlead_height, friction)
        if state.status == CONVERGED:
            if _tension(state) < _tension(least):
                least = state
            if _tension(least) <= tension:
                break
        if state.status != CONVERGED or _falls(state):
            low = H
        else:
            high = H
    return least


def _tension(state: State) -> float:
    return math.sqrt(state.H * state.H + state.V * state.V)


def _falls(state: State) -> bool:
    """Whether the fairlead tension falls as H grows at a fixed height."""
    return state.H * state.z_V < state.V * state.z_H


def hang_slack(
    pieces: Pieces, anchor_height: float, fairlead_height: float, friction: float
) -> State:
    """State of a line that carries no horizontal force; its span is the largest of such a line."""
    scale = abs(total_weight(pieces))
    for k in range(len(pieces.length)):
        scale = max(scale, abs(pieces.weight[k]) * pieces.length[k], abs(pieces.load[k]))
        if scale == 0.0 and pieces.compliance[k] > 0.0:
            # Without weight only the stretch sets a force by which to call another one small.
            scale = 1e-3 / pieces.compliance[k]
    state = given_force(NEARLY_NO_FORCE * scale, pieces, anchor_height, fairlead_height, friction)
    return _without_force(state, state.regime, state.span) if state.status == CONVERGED else state


def _without_force(state: State, regime: int, span: float) -> State:
    """Return the state with no horizontal force, at a span that needs none."""
    return State(
        state.status,
        regime,
        0.0,
        state.V,
        span,
        state.height_error,
        state.grounded,
        0.0,
        state.V_anchor,
        state.touchdown,
        state.anchor_touchdown,
        state.x_H,
        state.x_V,
        state.z_H,
        state.z_V,
    )


def _least_hanging(pieces: Pieces, fairlead_height: float, anchor_height: float) -> float:
    """Return a length that surely hangs when the line is slack, stretch allowed for, m."""
    weight = 0.0
    softest = 0.0
    for k in range(len(pieces.length)):
        weight += abs(pieces.length[k] * pieces.weight[k]) + abs(pieces.load[k])
        softest = max(softest, pieces.compliance[k])
    return (fairlead_height + anchor_height) / (1.0 + softest * weight) * (1.0 - 1e-12)


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
    return H, grounded_guess(H, pieces, max(rise, 0.0))


def _newton(
    known: int,
    wanted: float,
    pieces: Pieces,
    height: float,
    friction: float,
    H: float,
    V: float,
) -> State:
    """Newton's method on (span or tension, height); a failed state when it does not settle."""
    size = wanted if known == BY_TENSION else total_length(pieces)
    for _ in range(25):
        state = hung_state(H, V, pieces, height, friction, FIRST_TOUCHDOWN)
        z_error = state.height_error
        if known == BY_TENSION:
            T = _tension(state)
            error, by_H, by_V = T - wanted, H / T, V / T
        else:
            error, by_H, by_V = state.span - wanted, state.x_H, state.x_V
        determinant = by_H * state.z_V - by_V * state.z_H
        if determinant == 0.0 or math.isnan(determinant):
            break
        dH = (by_V * z_error - state.z_V * error) / determinant
        dV = (state.z_H * error - by_H * z_error) / determinant
        steps = max(abs(dH) / H, abs(dV) / max(V, H))
        if steps <= 1e-15:
            return state
        H = min(max(H + dH, 0.1 * H), 10.0 * H)
        V = max(V + dV, 0.1 * V)
        if steps <= SETTLED:
            state = hung_state(H, V, pieces, height, friction, FIRST_TOUCHDOWN)
            reached = _tension(state) if known == BY_TENSION else state.span
            if abs(reached - wanted) <= 1e-14 * size and abs(state.height_error) <= 1e-14 * size:
                return state
    return failed(NOT_CONVERGED)


def _bracket(
    span: float,
    pieces: Pieces,
    anchor_height: float,
    fairlead_height: float,
    friction: float,
    guess: float,
) -> tuple[float, float]:
    """Horizontal forces below and above the one that gives a span, by growing strides; N."""
    H = guess if guess > 0.0 else max(abs(total_weight(pieces)), 1e-9)
    low, high = 0.0, math.inf
    factor = 2.0
    while low == 0.0 or math.isinf(high):
        if not 1e-200 < H < 1e200:
            return math.nan, math.nan
        state = given_force(H, pieces, anchor_height, fairlead_height, friction)
        if state.status == CONVERGED and state.span >= span:
            high = H
            H /= factor
        elif state.status in (CONVERGED, TOUCHES_TWICE):
            low = H
            H *= factor
        else:
            return math.nan, math.nan
        factor = min(factor * factor, 1e8)
    return low, high


def _bracket_by_scan(
    span: float,
    pieces: Pieces,
    anchor_height: float,
    fairlead_height: float,
    friction: float,
) -> tuple[float, float]:
    """Neighbouring forces of a scan, both with an answer, whose spans lie on both sides; or nan."""
    H = 1e-6 * max(abs(total_weight(pieces)), 1e-9)
    below = math.nan
    for _ in range(150):
        state = given_force(H, pieces, anchor_height, fairlead_height, friction)
        if state.status != CONVERGED:
            below = math.nan
        elif state.span < span:
            below = H
        elif not math.isnan(below):
            return below, H
        H *= 1.25
    return math.nan, math.nan


def _close_in(
    known: int,
    wanted: float,
    pieces: Pieces,
    anchor_height: float,
    fairlead_height: float,
    friction: float,
    low: float,
    high: float,
) -> State:
    """Close in on H between two bounds, by false position (Illinois) and bisection.

    A line that touches the bed twice at some H has too little of it: lines lift as H grows.
    """
    size = wanted if known == BY_TENSION else max(wanted, total_length(pieces))
    error_low, error_high = -math.inf, math.inf
    best = failed(NOT_CONVERGED)
    best_error = math.inf
    twice = False
    kept = 0
    H = math.sqrt(low) * math.sqrt(high)
    for step in range(300):
        state = given_force(H, pieces, anchor_height, fairlead_height, friction)
        if state.status == TOUCHES_TWICE:
            twice = True
            error = -math.inf
        elif state.status != CONVERGED:
            return state
        else:
            reached = _tension(state) if known == BY_TENSION else state.span
            error = reached - wanted
            if abs(error) < best_error:
                best, best_error = state, abs(error)
        if error == 0.0:
            break
        if error > 0.0:
            high, error_high = H, error
            error_low = 0.5 * error_low if kept > 0 else error_low
            kept = 1
        else:
            low, error_low = H, error
            error_high = 0.5 * error_high if kept < 0 else error_high
            kept = -1
        H = _between_bounds(low, high, error_low, error_high, step % 3 == 2)
        if not low < H < high:
            break
    if best_error <= 1e-9 * size:
        return best
    return failed(TOUCHES_TWICE if twice else NOT_CONVERGED)


def _between_bounds(
    low: float, high: float, error_low: float, error_high: float, bisect: bool
) -> float:
    """Next H to try: on a logarithmic scale as long as the bounds are far apart; N."""
    is_wide = high > 2.0 * low
    middle = math.sqrt(low) * math.sqrt(high) if is_wide else low + 0.5 * (high - low)
    if bisect or math.isinf(error_low) or math.isinf(error_high):
        return middle
    share = error_low / (error_low - error_high)
    new = low * (high / low) ** share if is_wide else low + share * (high - low)
    return new if low < new < high else middle
