"""Equilibrium of one line whose fairlead tension is known instead of its horizontal force."""

from __future__ import annotations

import math

from catopt.catenary.closing import BY_TENSION, close_in, newton, tension_of
from catopt.catenary.equilibrium import given_force
from catopt.catenary.lift import grounded_guess, top_weight
from catopt.catenary.pieces import is_inextensible, total_length, total_weight
from catopt.catenary.setting import Setting, is_plain
from catopt.catenary.slack import NEARLY_NO_FORCE, hang_slack
from catopt.catenary.state import (
    CONVERGED,
    TOO_HEAVY,
    TOO_SHORT,
    TOUCHES_TWICE,
    State,
    failed,
)

__all__ = ["given_tension", "least_tension"]


def given_tension(
    tension: float,
    setting: Setting,
) -> State:
    """Solve a line whose effective tension at the fairlead is known; arguments as `given_span`.

    A line that hangs below a raised anchor, or carries a buoy, can have the same tension at two
    horizontal forces. The larger one is taken: there the tension rises with the force.
    """
    pieces = setting.pieces
    rise = setting.fairlead_height - setting.anchor_height
    if is_inextensible(pieces) and abs(rise) >= total_length(pieces):
        return failed(TOO_SHORT)
    if rise > 0.0 and is_plain(setting):
        weight = total_weight(pieces)
        if tension <= weight:
            slack = hang_slack(setting)
            if slack.status == CONVERGED and tension < slack.V:
                return failed(TOO_HEAVY)
        H = max(tension - top_weight(pieces, rise), 0.05 * tension)
        V = grounded_guess(H, pieces, rise)
        state = newton(BY_TENSION, tension, setting, H, V)
        if state.status == CONVERGED:
            return state
    least, high = least_tension(tension, setting)
    if least.status != CONVERGED:
        return least
    if tension_of(least) > tension:
        return failed(TOO_HEAVY)
    return close_in(BY_TENSION, tension, setting, least.H, high)


def least_tension(
    tension: float,
    setting: Setting,
) -> tuple[State, float]:
    """Look down from H = `tension` for a fairlead tension that small; arguments as `given_tension`.

    Returns
    -------
    state : State
        The first one found with no more than `tension`, else the one with the least.
    above : float
        A horizontal force above it at which the tension is larger, N.
    """
    floor = NEARLY_NO_FORCE * max(abs(total_weight(setting.pieces)), tension)
    least = failed(TOUCHES_TWICE)
    above = tension
    H = tension
    touched = False
    while H > floor:
        state = given_force(H, setting)
        touches = state.status == TOUCHES_TWICE
        if state.status == CONVERGED:
            if _falls(state) and above > H:
                state = _valley(tension, setting, H, above, state)
            if least.status != CONVERGED or tension_of(state) < tension_of(least):
                least = state
            if tension_of(state) <= tension:
                return state, above
            above = H
        elif not touches:
            return state, above
        elif least.status == CONVERGED and not touched:
            state = _valley(tension, setting, H, above, least)
            if tension_of(state) <= tension:
                return state, above
            least = state
        touched = touches
        H *= 0.5
    return least, above


def _valley(
    tension: float,
    setting: Setting,
    low: float,
    high: float,
    least: State,
) -> State:
    """Bisect towards the least tension between two horizontal forces.

    At the lower one the tension falls with H, or the line touches the bed twice.
    """
    for _ in range(60):
        H = math.sqrt(low * high)
        state = given_force(H, setting)
        if state.status == CONVERGED:
            if tension_of(state) < tension_of(least):
                least = state
            if tension_of(least) <= tension:
                break
        if state.status != CONVERGED or _falls(state):
            low = H
        else:
            high = H
    return least


def _falls(state: State) -> bool:
    """Whether the fairlead tension falls as H grows at a fixed height."""
    return state.H * state.z_V < state.V * state.z_H
