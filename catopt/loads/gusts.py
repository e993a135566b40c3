"""Gusts: the spectrum of the wind's speed, and a series of it."""

from __future__ import annotations

import math
from typing import Final, Literal

import numpy as np

from catopt.arrays import Array
from catopt.model.validity import Findings

GustSpectrum = Literal["none", "NPD"]
"""Steady wind, or that of the Norwegian Petroleum Directorate, which API and ISO 19901-1 have."""

_N: Final = 0.468
_HEIGHT: Final = 10.0


def npd_spectrum(frequency: Array, speed: float, height: float = _HEIGHT) -> Array:
    """Spectral density of the wind's speed along its direction, m2/s (B).

    S = 320 (U/10)^2 (z/10)^0.45 / (1 + F^n)^(5/(3 n)), F = 172 f (z/10)^(2/3) (U/10)^-0.75, n =
    0.468: f in Hz, U the mean of one hour at 10 m, m/s, z the height, m. Read in two programs that
    have it.
    """
    found = Findings("npd_spectrum")
    found.number("speed", speed, "m/s", above=0.0)
    found.number("height", height, "m", above=0.0)
    found.raise_if_any()
    over, up = speed / 10.0, height / _HEIGHT
    F = 172.0 * frequency * up ** (2.0 / 3.0) * over**-0.75
    return np.asarray(320.0 * over**2 * up**0.45 / (1.0 + F**_N) ** (5.0 / (3.0 * _N)))


def gust_series(speed: float, samples: int, step: float, generator: np.random.Generator) -> Array:
    """Draw the wind's speed beside its mean at 10 m, m/s: so many samples, a step (s) apart.

    The sum of waves of the spectrum's energy at all frequencies that fit into the series, each with
    a random phase.
    """
    frequency = np.arange(1, samples // 2 + 1) / (samples * step)
    size = np.sqrt(2.0 * npd_spectrum(frequency, speed) / (samples * step))
    phase = generator.uniform(0.0, 2.0 * math.pi, frequency.size)
    parts = np.zeros(samples // 2 + 1, dtype=complex)
    parts[1:] = 0.5 * samples * size * np.exp(1j * phase)
    return np.fft.irfft(parts, samples)
