"""Equilibrium of one line whose span is known instead of its horizontal force."""

from __future__ import annotations

import math

from catopt.catenary.closing import BY_SPAN, close_in, newton
from catopt.catenary.equilibrium import given_force
from catopt.catenary.lift import grounded_guess, top_weight
from catopt.catenary.pieces import Pieces, is_inextensible, total_length, total_weight
from catopt.catenary.setting import Setting, is_plain
from catopt.catenary.slack import hang_slack, without_force
from catopt.catenary.state import (
    CONVERGED,
    NOT_CONVERGED,
    SLACK,
    TOO_SHORT,
    TOUCHES_TWICE,
    State,
    failed,
)

__all__ = ["given_span"]


def given_span(
    span: float,
    setting: Setting,
    H_guess: float,
    V_guess: float,
) -> State:
    """Solve a line whose span is known.

    Parameters
    ----------
    span : float
        Horizontal distance from the anchor to the fairlead, m, above 0.
    setting : Setting
        The line and where it is moored; for the rest as for `given_force`.
    H_guess, V_guess : float
        Where to start, N; nan to have them estimated.
    """
    pieces = setting.pieces
    length = total_length(pieces)
    rise = setting.fairlead_height - setting.anchor_height
    if is_inextensible(pieces) and math.sqrt(span * span + rise * rise) >= length:
        return failed(TOO_SHORT)
    if span < length - _least_hanging(setting):
        slack = hang_slack(setting)
        if slack.status == CONVERGED and span <= slack.span:
            return without_force(slack, SLACK, span)
    if math.isnan(H_guess):
        H_guess, V_guess = _guess(span, rise, pieces)
    if rise > 0.0 and is_plain(setting):
        state = newton(BY_SPAN, span, setting, H_guess, V_guess)
        if state.status == CONVERGED:
            return state
    low, high = _bracket(span, setting, H_guess)
    if not low < high:
        return failed(NOT_CONVERGED)
    state = close_in(BY_SPAN, span, setting, low, high)
    if state.status != TOUCHES_TWICE:
        return state
    # It may touch twice between two ranges of force in which it does not: look at each range.
    low, high = _bracket_by_scan(span, setting)
    if not low < high:
        return state
    return close_in(BY_SPAN, span, setting, low, high)


def _least_hanging(setting: Setting) -> float:
    """Return a length that surely hangs when the line is slack, stretch allowed for, m."""
    pieces = setting.pieces
    weight = 0.0
    softest = 0.0
    for k in range(len(pieces.length)):
        weight += abs(pieces.length[k] * pieces.weight[k]) + abs(pieces.load[k])
        softest = max(softest, pieces.compliance[k])
    return (
        (setting.fairlead_height + setting.anchor_height) / (1.0 + softest * weight) * (1.0 - 1e-12)
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
    return H, grounded_guess(H, pieces, max(rise, 0.0))


def _bracket(
    span: float,
    setting: Setting,
    guess: float,
) -> tuple[float, float]:
    """Horizontal forces below and above the one that gives a span, by growing strides; N."""
    H = guess if guess > 0.0 else max(abs(total_weight(setting.pieces)), 1e-9)
    low, high = 0.0, math.inf
    factor = 2.0
    while low == 0.0 or math.isinf(high):
        if not 1e-200 < H < 1e200:
            return math.nan, math.nan
        state = given_force(H, setting)
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
    setting: Setting,
) -> tuple[float, float]:
    """Neighbouring forces of a scan, both with an answer, whose spans lie on both sides; or nan."""
    H = 1e-6 * max(abs(total_weight(setting.pieces)), 1e-9)
    below = math.nan
    for _ in range(150):
        state = given_force(H, setting)
        if state.status != CONVERGED:
            below = math.nan
        elif state.span < span:
            below = H
        elif not math.isnan(below):
            return below, H
        H *= 1.25
    return math.nan, math.nan
