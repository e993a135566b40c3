"""A root between two places where a function has different signs, by Brent's method."""

from __future__ import annotations

from collections.abc import Callable

from catopt.errors import NotConvergedError
from catopt.words import Message

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
