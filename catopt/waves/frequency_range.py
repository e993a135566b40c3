"""Between which frequencies a spectrum is cut into components."""

from __future__ import annotations

import math
from typing import Final

from catopt.model.validity import Findings
from catopt.waves.spectrum import Spectrum

_LOWEST, _HIGHEST = 0.5, 6.0
"""In peak frequencies: leaves out 1e-9 of the energy below and 0.1 % above."""

_S4_LOWEST, _S4_HIGHEST = 0.58, 5.1101

_WIDEST_GAMMA: Final = 19.0


def frequency_range(spectrum: Spectrum) -> tuple[float, float]:
    """Range that holds 99.9 % of the energy of any of these spectra: 0.5 to 6 peak frequencies.

    In rad/s, as those of S4.
    """
    peak = spectrum.peak_frequency
    return _LOWEST * peak, _HIGHEST * peak


def s4_range_pierson_moskowitz(zero_crossing_period: float) -> tuple[float, float]:
    """0.58 to 5.1101 times 2 pi/Tz, S4 [2.62].

    As factors of the *peak* frequency these are AQWA's start for gamma = 1 and the frequency at
    which S has fallen to 1/1000 of its peak. On 2 pi/Tz = 1.408 omega_p, as S4 has them, they leave
    out the lowest 6 % of the energy.

    Parameters
    ----------
    zero_crossing_period : float
        Tz, s; InputError unless above 0.
    """
    found = Findings("s4_range_pierson_moskowitz")
    found.number("zero_crossing_period", zero_crossing_period, "s", above=0.0)
    found.raise_if_any()
    frequency = 2.0 * math.pi / zero_crossing_period
    return _S4_LOWEST * frequency, _S4_HIGHEST * frequency


def s4_range_jonswap(spectrum: Spectrum) -> tuple[float, float]:
    """Range of S4's Table 4.4 for JONSWAP, for which S4 prints figures and no rule.

    The lower end is AQWA's start frequency, omega_p (0.58 + 0.05 (gamma - 1)/19) (Aqwa Reference
    Manual, the JONS data record), and meets the printed digits. The upper end is where S has fallen
    to 1/1000 of its peak, as 5.1101 omega_p is for gamma = 1; it comes 0.14 % below the printed
    one.
    """
    lowest = _S4_LOWEST + 0.05 * (spectrum.gamma - 1.0) / _WIDEST_GAMMA
    return lowest * spectrum.peak_frequency, thousandth(spectrum)


def thousandth(spectrum: Spectrum) -> float:
    """Frequency above the peak at which S is 1/1000 of its value there, rad/s."""
    low, high = 1.0, 10.0
    limit = float(spectrum.density(spectrum.peak_frequency)) / 1000.0
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return middle * spectrum.peak_frequency
        if float(spectrum.density(middle * spectrum.peak_frequency)) > limit:
            low = middle
        else:
            high = middle
