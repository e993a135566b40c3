"""Two ways to close in on the horizontal force when the span or the tension is known.

Newton's method on H and V serves the plain line and settles in a few steps. What it does not
settle goes to a bracketed search over H, which every line has: span and tension rise with H.
"""

from __future__ import annotations

import math

from catopt.catenary.equilibrium import given_force, hung_state
from catopt.catenary.lift import SETTLED
from catopt.catenary.pieces import total_length
from catopt.catenary.setting import Setting
from catopt.catenary.state import CONVERGED, JUMPS, NOT_CONVERGED, TOUCHES_TWICE, State, failed
from catopt.catenary.walk import FIRST_TOUCHDOWN

__all__ = ["BY_SPAN", "BY_TENSION", "close_in", "newton", "tension_of"]

BY_SPAN = 0
BY_TENSION = 1


def newton(known: int, wanted: float, setting: Setting, H: float, V: float) -> State:
    """Newton's method on (span or tension, height); a failed state when it does not settle."""
    pieces, height, friction = setting.pieces, setting.fairlead_height, setting.friction
    size = wanted if known == BY_TENSION else total_length(pieces)
    for _ in range(25):
        state = hung_state(H, V, pieces, height, friction, FIRST_TOUCHDOWN)
        z_error = state.height_error
        if known == BY_TENSION:
            T = tension_of(state)
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
            reached = tension_of(state) if known == BY_TENSION else state.span
            if abs(reached - wanted) <= 1e-14 * size and abs(state.height_error) <= 1e-14 * size:
                return state
    return failed(NOT_CONVERGED)


def close_in(
    known: int,
    wanted: float,
    setting: Setting,
    low: float,
    high: float,
) -> State:
    """Close in on H between two bounds, by false position (Illinois) and bisection.

    A line that touches the bed twice at some H has too little of it: lines lift as H grows.
    """
    size = wanted if known == BY_TENSION else max(wanted, total_length(setting.pieces))
    error_low, error_high = -math.inf, math.inf
    best = failed(NOT_CONVERGED)
    best_error = math.inf
    twice = False
    kept = 0
    H = math.sqrt(low) * math.sqrt(high)
    for step in range(300):
        state = given_force(H, setting)
        if state.status == TOUCHES_TWICE:
            twice = True
            error = -math.inf
        elif state.status != CONVERGED:
            return state
        else:
            reached = tension_of(state) if known == BY_TENSION else state.span
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
    if twice:
        return failed(TOUCHES_TWICE)
    return failed(JUMPS if high - low <= 1e-12 * high else NOT_CONVERGED)


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


def tension_of(state: State) -> float:
    """Tension at the fairlead, N."""
    return math.sqrt(state.H * state.H + state.V * state.V)
