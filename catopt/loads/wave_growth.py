"""Sea that a steady wind raises over a fetch of one depth, as Breugem and Holthuijsen have it.

H~ = 0.24 [tanh(0.343 d~^1.14) tanh(4.41e-4 F~^0.79 / tanh(0.343 d~^1.14))]^0.572
T~ = 7.69 [tanh(0.10 d~^2.01) tanh(2.77e-7 F~^1.45 / tanh(0.10 d~^2.01))]^0.187

with H~ = g Hs/U^2, T~ = g Tp/U, d~ = g d/U^2, F~ = g F/U^2; U is the mean of 10 minutes at 10 m.
W. A. Breugem and L. H. Holthuijsen, "Generalized shallow water wave growth from Lake George", J.
Waterway, Port, Coastal, Ocean Eng. 133 (2007); the constants were read in a program that has them
(B). In deep water they are the law of Kahma and Calkoen (1992), which raises more sea over short
fetches than JONSWAP's.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from catopt.constants import STANDARD_GRAVITY
from catopt.model.kinds import Findings

GROWING_MEAN: Final = 600.0
"""s: the wind is a mean over this."""


class GrownSea(NamedTuple):
    """A sea that a wind has raised."""

    hs: float  # significant height, m
    peak_period: float  # s


def grown_sea(wind: float, fetch: float, depth: float) -> GrownSea:
    """Find the sea that a steady wind raises over a fetch, once it does not grow any more.

    Parameters
    ----------
    wind : float
        Speed at 10 m, mean of 10 minutes, m/s.
    fetch : float
        Length of water over which it blows, m.
    depth : float
        Mean depth over the fetch, m.

    Raises
    ------
    InputError
        A number is not above 0.

    Examples
    --------
    >>> sea = grown_sea(wind=20.0, fetch=10e3, depth=5.0)
    >>> round(sea.hs, 2), round(sea.peak_period, 1)
    (1.18, 4.1)
    """
    found = Findings("grown_sea")
    found.number("wind", wind, "m/s", above=0.0)
    found.number("fetch", fetch, "m", above=0.0)
    found.number("depth", depth, "m", above=0.0)
    found.raise_if_any()
    by_wind = STANDARD_GRAVITY / (wind * wind)
    d, F = by_wind * depth, by_wind * fetch
    height = 0.24 * _grown(0.343 * d**1.14, 4.41e-4 * F**0.79) ** 0.572
    period = 7.69 * _grown(0.10 * d**2.01, 2.77e-7 * F**1.45) ** 0.187
    return GrownSea(height / by_wind, period * wind / STANDARD_GRAVITY)


def _grown(by_depth: float, by_fetch: float) -> float:
    """Part of the sea that depth and fetch leave of one that neither limits."""
    limit = math.tanh(by_depth)
    return limit * math.tanh(by_fetch / limit)
