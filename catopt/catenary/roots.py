"""Closing in on a root: of a rising function in compiled code, and by Brent's method.

Of a rising function by false position, Newton's steps and bisection. Plain numbers, because
compiled code takes no function as argument: whoever seeks a root keeps a `Bracket`, asks it for the
next `trial`, evaluates there and has it `narrowed`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from catopt.errors import NotConvergedError
from catopt.words import Message


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


LIMIT = 100
"""Evaluations: bisection alone takes some 60 to the last digit."""


def root(
    function: Callable[[float], float], low: float, high: float, *, xtol: float, rtol: float
) -> float:
    """Find a root between two places of different sign, to `xtol` and to `rtol` as a part of it.

    Each step is inverse quadratic, linear, or else a bisection (R. P. Brent, Algorithms for
    Minimization without Derivatives, 1973, chapter 4). NotConvergedError: the function jumps.

    Examples
    --------
    >>> round(root(lambda x: x * x - 2.0, 0.0, 2.0, xtol=1e-12, rtol=1e-12), 9)
    1.414213562
    """
    before, now = low, high
    f_before, f_now = function(before), function(now)
    if f_before == 0.0:
        return before
    beyond, f_beyond, last, step = before, f_before, now - before, now - before
    for _ in range(LIMIT):
        if (f_now > 0.0) == (f_beyond > 0.0):
            beyond, f_beyond = before, f_before
            last = step = now - before
        if abs(f_beyond) < abs(f_now):
            before, now, beyond = now, beyond, now
            f_before, f_now, f_beyond = f_now, f_beyond, f_now
        delta = 0.5 * (xtol + rtol * abs(now))
        half = 0.5 * (beyond - now)
        if f_now == 0.0 or abs(half) < delta:
            return now
        wanted = half
        if abs(last) > delta and abs(f_now) < abs(f_before):
            if before == beyond:
                wanted = -f_now * (now - before) / (f_now - f_before)
            else:
                slope = (f_before - f_now) / (before - now)
                other = (f_beyond - f_now) / (beyond - now)
                bent = f_beyond * other - f_before * slope
                wanted = -f_now * bent / (other * slope * (f_beyond - f_before))
        is_short = 2.0 * abs(wanted) < min(abs(last), 3.0 * abs(half) - delta)
        last, step = (step, wanted) if is_short else (half, half)
        before, f_before = now, f_now
        now += step if abs(step) > delta else (delta if half > 0.0 else -delta)
        f_now = function(now)
    raise NotConvergedError(Message("refused_motion.no_root", within=abs(beyond - now), about=now))
