"""Spectra of the sea's surface, linear dispersion and the periods of a sea."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, Final, Literal, get_args

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array
from catopt.constants import STANDARD_GRAVITY
from catopt.model.kinds import Findings
from catopt.words import Message

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


Normalisation = Literal["computed", "S4"]
"""C from the integral of the spectrum, or 1 - 0.287 ln gamma, S4 [2.67]."""

_WIDTH_BELOW: Final = 0.07
_WIDTH_ABOVE: Final = 0.09
_REACH: Final = 9.0
"""In widths: how far from the peak gamma^G still differs from 1 by what double precision shows."""

_GREATEST_GAMMA: Final = 20.0


@cache
def _gauss() -> tuple[Array, Array]:
    """Nodes and weights of Gauss and Legendre's rule: made when first used, and once."""
    nodes, weights = np.polynomial.legendre.leggauss(64)
    return nodes, weights


def pierson_moskowitz(significant_height: float, peak_period: float) -> Spectrum:
    """Pierson-Moskowitz spectrum of a given height and period, S4 [2.59].

    Parameters
    ----------
    significant_height, peak_period : float
        Hs, m, and Tp, s; InputError unless above 0.
    """
    return Spectrum(significant_height, peak_period, 1.0)


def jonswap(
    significant_height: float,
    peak_period: float,
    gamma: float | None = None,
    *,
    normalisation: Normalisation = "computed",
) -> Spectrum:
    """JONSWAP spectrum, S4 [2.65].

    Parameters
    ----------
    significant_height, peak_period : float
        Hs, m, and Tp, s, above 0.
    gamma : float, optional
        Peak enhancement, 1 to 20, InputError beyond; by the rule of `peak_enhancement` when it is
        not given.
    normalisation : {"computed", "S4"}
        "computed" keeps 4 sqrt(m0) = Hs; "S4" is [2.67], 1 - 0.287 ln gamma, which nearly does.
    """
    if gamma is None:
        gamma = peak_enhancement(significant_height, peak_period)
    return Spectrum(significant_height, peak_period, gamma, normalisation)


def peak_enhancement(significant_height: float, peak_period: float) -> float:
    """Give gamma by the rule on x = Tp/sqrt(Hs), S4 [2.68]-[2.70].

    5 up to x = 3.6, exp(5.75 - 1.15 x) up to x = 5, and 1 beyond; x in s/sqrt(m).

    Parameters
    ----------
    significant_height, peak_period : float
        Hs, m, and Tp, s; InputError unless above 0.
    """
    _check_height_and_period("peak_enhancement", significant_height, peak_period).raise_if_any()
    x = peak_period / math.sqrt(significant_height)
    if x <= 3.6:
        return 5.0
    return math.exp(5.75 - 1.15 * x) if x < 5.0 else 1.0


@dataclass(frozen=True)
class Spectrum:
    """A JONSWAP spectrum; with gamma 1, a Pierson-Moskowitz one."""

    significant_height: float  # Hs, m
    peak_period: float  # Tp, s
    gamma: float = 1.0  # peak enhancement, 1 to 20
    normalisation: Normalisation = "computed"  # how the enhanced peak is paid for, see `jonswap`

    def __post_init__(self) -> None:
        found = _check_height_and_period("Spectrum", self.significant_height, self.peak_period)
        found.number("gamma", self.gamma, "", at_least=1.0, at_most=_GREATEST_GAMMA)
        if self.normalisation not in get_args(Normalisation):
            found.add(
                "normalisation",
                repr(self.normalisation),
                Message("refused_motion.must_be_computed_or_s4"),
            )
        found.raise_if_any()

    @property
    def peak_frequency(self) -> float:
        """omega_p, rad/s."""
        return 2.0 * math.pi / self.peak_period

    @cached_property
    def factor(self) -> float:
        """C, by which the enhanced spectrum is multiplied."""
        if self.normalisation == "S4":
            return 1.0 - 0.287 * math.log(self.gamma)
        return 1.0 / (1.0 + float(self._added(np.inf)))

    def density(self, omega: npt.ArrayLike) -> Array:
        """S(omega) in m² s/rad; `omega` in rad/s, of any shape, above 0."""
        r = np.asarray(omega, dtype=float) / self.peak_frequency
        return self._scale / self.peak_frequency * _plain(r) * np.exp(self._log_peak(r))

    def energy_below(self, omega: npt.ArrayLike) -> Array:
        """Integral of S from 0 to each of `omega` (rad/s, above 0), m²: exact to rounding.

        The Pierson-Moskowitz part has the closed form exp(-1.25 r^-4). What the peak adds is smooth
        on either side of it and nil far from it, so that Gauss's rule leaves rounding only.
        """
        r = np.asarray(omega, dtype=float) / self.peak_frequency
        return self._scale * (np.exp(-1.25 * r**-4) + self._added(r))

    def moment(self, order: int) -> float:
        """m_n = integral of omega^n S, m² (rad/s)^n, for n from -4 to 3.

        From n = 4 on the integral has no bound: it depends on where the spectrum is cut off.
        """
        found = Findings("Spectrum.moment")
        found.number("order", order, "", at_least=-4, at_most=3)
        found.raise_if_any()
        plain = math.pow(1.25, order / 4.0) * math.gamma(1.0 - order / 4.0)
        added = float(self._added(np.inf, order))
        scale = self._scale * math.pow(self.peak_frequency, order)
        return scale * (plain + added)

    @property
    def mean_period(self) -> float:
        """Tm = 2 pi m0/m1, s."""
        return 2.0 * math.pi * self.moment(0) / self.moment(1)

    @property
    def zero_crossing_period(self) -> float:
        """Tz = 2 pi sqrt(m0/m2), s."""
        return 2.0 * math.pi * math.sqrt(self.moment(0) / self.moment(2))

    @property
    def _scale(self) -> float:
        return self.factor * self.significant_height**2 / 16.0

    def _log_peak(self, r: Array) -> Array:
        """Logarithm of gamma^G."""
        width = np.where(r <= 1.0, _WIDTH_BELOW, _WIDTH_ABOVE)
        result: Array = math.log(self.gamma) * np.exp(-0.5 * ((r - 1.0) / width) ** 2)
        return result

    def _added(self, r: npt.ArrayLike, order: int = 0) -> Array:
        """Integral up to `r` of r^order times what gamma^G adds to the plain shape."""
        r = np.asarray(r, dtype=float)
        start, end = 1.0 - _REACH * _WIDTH_BELOW, 1.0 + _REACH * _WIDTH_ABOVE
        below = self._added_between(start, np.clip(r, start, 1.0), order)
        return below + self._added_between(1.0, np.clip(r, 1.0, end), order)

    def _added_between(self, start: float, end: Array, order: int) -> Array:
        """Gauss-Legendre over an interval that does not pass the peak."""
        half = 0.5 * (end - start)
        nodes, weights = _gauss()
        r = start + half[..., np.newaxis] * (1.0 + nodes)
        result: Array = half * ((r**order * _plain(r) * np.expm1(self._log_peak(r))) @ weights)
        return result


def _plain(r: Array) -> Array:
    """Pierson-Moskowitz shape over r = omega/omega_p, of unit area."""
    result: Array = 5.0 * r**-5 * np.exp(-1.25 * r**-4)
    return result


def _check_height_and_period(source: str, height: float, period: float) -> Findings:
    found = Findings(source)
    found.number("significant_height", height, "m", above=0.0)
    found.number("peak_period", period, "s", above=0.0)
    return found
