"""Linear dispersion: omega² = g k tanh(k d), S4 [2.52].

With y = omega² d/g and x = k d it reads x tanh x = y. Plain functions of floats: they serve one
wave as they are and many compiled.
"""

from __future__ import annotations

import math
from typing import Any, Final

from catopt.constants import STANDARD_GRAVITY
from catopt.model.validity import Findings

_DEEP: Final = 20.0
"""tanh is 1 in double precision from 19.1 on, and k d is omega² d/g."""

_NEWTON_STEPS: Final = 3
"""Guo's start is good to 1 %, and each step squares the error: 1e-4, 1e-8, below 1e-15."""


def wave_number(omega: float, depth: float) -> float:
    """Wave number of a wave of small height, to double precision; a kernel that checks nothing.

    Parameters
    ----------
    omega, depth : float
        Angular frequency, rad/s, and water depth, m, both above 0. The wave number is in rad/m.

    Notes
    -----
    Newton's method on x tanh x = y from the start x = y (1 - exp(-y^1.25))^-0.4 of Guo (2002,
    "Simple and explicit solution of wave dispersion equation", Coastal Engineering 45).
    """
    y = omega * omega * depth / STANDARD_GRAVITY
    if y > _DEEP:
        return y / depth
    x = y / math.pow(-math.expm1(-math.pow(y, 1.25)), 0.4)
    for _ in range(_NEWTON_STEPS):
        th = math.tanh(x)
        x -= (x * th - y) / (th + x * (1.0 - th * th))
    return x / depth


def fill_wave_numbers(omega: Any, depth: float, k: Any) -> None:
    """Write the wave number of each frequency, rad/m, into `k`; meant to be compiled."""
    for i in range(omega.shape[0]):
        k[i] = wave_number(omega[i], depth)


def wavelength(period: float, depth: float) -> float:
    """Length of a wave of small height.

    Parameters
    ----------
    period, depth : float
        s, and water depth, m; InputError unless above 0. The length is from crest to crest, m.
    """
    found = Findings("wavelength")
    found.number("period", period, "s", above=0.0)
    found.number("depth", depth, "m", above=0.0)
    found.raise_if_any()
    return 2.0 * math.pi / wave_number(2.0 * math.pi / period, depth)
