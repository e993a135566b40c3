"""Equilibrium of one line whose fairlead tension is known instead of its horizontal force."""

from __future__ import annotations

import math

from catopt.catenary.equilibrium import given_force, hang_slack
from catopt.catenary.lift import grounded_guess, top_weight
from catopt.catenary.pieces import (
    LEAST_FORCE,
    LineProblem,
    is_inextensible,
    is_plain,
    total_length,
    total_weight,
)
from catopt.catenary.root_search import BY_TENSION, bracketed_search, newton, tension_of
from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_HEAVY, TOO_SHORT, State, failed

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
    least = tension_of(hang_slack(problem))
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
