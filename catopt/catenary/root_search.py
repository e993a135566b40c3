"""Two ways to close in on the horizontal force when the span or the tension is known.

Newton's method on H and V serves the plain line and settles in a few steps. What it does not
settle goes to a bracketed search over H, which every line has. Last, what the rounding of the input
alone leaves open of the forces.
"""

from __future__ import annotations

import math

from catopt.catenary.equilibrium import given_force, hung_state, is_certain
from catopt.catenary.pieces import LineProblem, total_length
from catopt.catenary.roots import bracket, is_closed, narrowed, trial
from catopt.catenary.state import BELOW_ANCHOR, CONVERGED, NOT_CONVERGED, SUSPENDED, State, failed
from catopt.catenary.suspended import FIRST_TOUCHDOWN, LAST_STEP
from catopt.catenary.upper_part import MOST_TRIALS
from catopt.compiled import inlined

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
