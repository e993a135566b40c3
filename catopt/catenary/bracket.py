"""Closing in on the root of a rising function: false position, Newton's steps and bisection.

Plain numbers, because compiled code takes no function as argument: whoever seeks a root keeps a
`Bracket`, asks it for the next `trial`, evaluates there and has it `narrowed`.
"""

from __future__ import annotations

import math
from typing import NamedTuple


class Bracket(NamedTuple):
    """Two places with the root between them: the function is below 0 at `low`, above 0 at `high`.

    f_low and f_high are its values there: halved while the same end stays (the Illinois rule),
    infinite when only the sign is known. Of the last step `stayed` is the end that stayed (-1 the
    lower, 1 the upper, 0 none yet), `last` the size of the function, `is_slow` if that did not
    halve.
    """

    low: float
    high: float
    f_low: float
    f_high: float
    stayed: int
    last: float
    is_slow: bool


def bracket(low: float, high: float, f_low: float, f_high: float) -> Bracket:
    """Start between two places."""
    return Bracket(low, high, f_low, f_high, 0, math.inf, False)


def narrowed(around: Bracket, x: float, f: float) -> Bracket:
    """Take in the value `f` at `x`."""
    size = abs(f)
    is_slow = size > 0.5 * around.last
    if f > 0.0:
        f_low = 0.5 * around.f_low if around.stayed < 0 else around.f_low
        return Bracket(around.low, x, f_low, f, -1, size, is_slow)
    f_high = 0.5 * around.f_high if around.stayed > 0 else around.f_high
    return Bracket(x, around.high, f, f_high, 1, size, is_slow)


def trial(around: Bracket, guess: float) -> float:
    """Next place to look at: the guess (nan: none) while guesses serve, else a bracketing one."""
    low, high = around.low, around.high
    if not around.is_slow:
        if low < guess < high:
            return guess
        if math.isfinite(around.f_low) and math.isfinite(around.f_high):
            x = low - around.f_low * ((high - low) / (around.f_high - around.f_low))
            if low < x < high:
                return x
    return low + 0.5 * (high - low)


def is_closed(around: Bracket) -> bool:
    """Whether no number is left between the two ends."""
    middle = around.low + 0.5 * (around.high - around.low)
    return not around.low < middle < around.high
