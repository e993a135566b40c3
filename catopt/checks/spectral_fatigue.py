"""Fatigue from a spectrum: dual narrow band, of slow motion and of the waves' together.

Of two normally distributed narrow bands, a slow one (L) and a fast one (W), with the parts l of the
variance and the rates n of crossing the mean upwards, Jiao and Moan (1990) add the damage of the
fast one to that of the envelope of both:

    n_P = l_L n_L sqrt(1 + (l_W/l_L) (d n_W/n_L)^2)
    rho = (n_P/n) (l_L^(m/2+2) (1 - sqrt(l_W/l_L)) + sqrt(pi l_L l_W) m G(m/2+1/2)/G(m/2+1))
          + (n_W/n) l_W^(m/2)

times the damage of one narrow band with the whole variance and n^2 = l_L n_L^2 + l_W n_W^2. The
width d of the fast band is taken as 0.1, as recalled from DNV-OS-E301. The form of rho is for a
slow band that is not the smaller part; where it is, it is taken as it stands.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np

from catopt.arrays import Array

_WIDTH: Final = 0.1
"""Vanmarcke's width of the fast band."""

_NONE: Final = 1e-6
"""Part of the variance below which a band is none."""


class Band(NamedTuple):
    """A band of a spectrum: its variance, and the rate of crossing the mean upwards, 1/s."""

    variance: float
    rate: float


def bands(values: Array, time: float, split: float) -> tuple[Band, Band]:
    """Part a series at equal steps into what is slower than a frequency, rad/s, and what is faster.

    `time`: that it lasts, s.
    """
    power: Array = np.abs(np.fft.rfft(values - values.mean())) ** 2
    power[1:] *= 2.0 / values.size**2
    whole = time * values.size / (values.size - 1)
    omega = np.arange(power.size, dtype=float) * (2.0 * math.pi / whole)
    parts = (omega > 0.0) & (omega < split), omega >= split
    slow, fast = (_band(power[part], omega[part]) for part in parts)
    return slow, fast


def _band(power: Array, omega: Array) -> Band:
    variance = float(power.sum())
    if not variance > 0.0:
        return Band(0.0, 0.0)
    return Band(variance, math.sqrt(float(power @ omega**2) / variance) / (2.0 * math.pi))


def range_moment(slow: Band, fast: Band, slope: float) -> float:
    """Sum of the ranges to the power of a curve's slope m, in a second, by dual narrow band.

    `slow`, `fast`: of a tension, N2 and 1/s.

    Examples
    --------
    >>> one = range_moment(Band(0.0, 0.0), Band(2.0, 0.1), 3.0)
    >>> round(one, 6) == round(0.1 * (2.0 * 2.0) ** 3 * math.gamma(2.5), 6)
    True
    """
    total = slow.variance + fast.variance
    if not total > 0.0:
        return 0.0
    l_L, l_W = slow.variance / total, fast.variance / total
    if min(l_L, l_W) < _NONE:
        return _narrow(max(slow, fast), slope)
    rate = math.sqrt(l_L * slow.rate**2 + l_W * fast.rate**2)
    both = _narrow(Band(total, rate), slope)
    return _rho(slow, fast, l_L, l_W, rate, slope) * both


def _narrow(band: Band, m: float) -> float:
    """Sum for one narrow band: ranges of twice an amplitude after Rayleigh."""
    size = 2.0 * math.sqrt(2.0 * band.variance)
    return float(band.rate * size**m * math.gamma(1.0 + 0.5 * m))


def _rho(slow: Band, fast: Band, l_L: float, l_W: float, rate: float, m: float) -> float:
    envelope = l_L * slow.rate
    envelope *= math.sqrt(1.0 + l_W / l_L * (_WIDTH * fast.rate / slow.rate) ** 2)
    own = l_L ** (0.5 * m + 2.0) * (1.0 - math.sqrt(l_W / l_L))
    crossed = math.sqrt(math.pi * l_L * l_W) * m
    crossed *= math.exp(math.lgamma(0.5 * m + 0.5) - math.lgamma(0.5 * m + 1.0))
    alone = fast.rate / rate * math.pow(l_W, 0.5 * m)
    return float(envelope / rate * (own + crossed) + alone)
