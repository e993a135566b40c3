"""How the periods of a Pierson-Moskowitz sea hang together, as S4 rounds them.

Tm is the mean period 2 pi m0/m1, Tz the zero-crossing period 2 pi sqrt(m0/m2), Tp the period of the
spectrum's peak. For other spectra take the periods from its moments (`Spectrum.mean_period`,
`Spectrum.zero_crossing_period`).
"""

from __future__ import annotations

from typing import Final

from catopt.model.validity import Findings

_MEAN_BY_ZERO_CROSSING: Final = 1.086
_PEAK_BY_ZERO_CROSSING: Final = 1.408


def zero_crossing_from_mean(mean_period: float) -> float:
    """Tz = Tm / 1.086, S4 [2.61]; s."""
    _check("zero_crossing_from_mean", "mean_period", mean_period)
    return mean_period / _MEAN_BY_ZERO_CROSSING


def peak_from_zero_crossing(zero_crossing_period: float) -> float:
    """Tp = 1.408 Tz, S4 [2.60]; s."""
    _check("peak_from_zero_crossing", "zero_crossing_period", zero_crossing_period)
    return _PEAK_BY_ZERO_CROSSING * zero_crossing_period


def peak_from_mean(mean_period: float) -> float:
    """Tp from Tm by both of S4's rules; s."""
    return peak_from_zero_crossing(zero_crossing_from_mean(mean_period))


def _check(source: str, name: str, period: float) -> None:
    found = Findings(source)
    found.number(name, period, "s", above=0.0)
    found.raise_if_any()
