"""A random sea: spectra, and waves of random frequency and phase cut out of them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from typing import Any, Final, Literal, get_args

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array
from catopt.constants import STANDARD_GRAVITY
from catopt.model.kinds import Findings
from catopt.waves.components import Waves
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


def wave_numbers(omega: Array, depth: float) -> Array:
    """Wave number of each frequency, rad/m, as plain Python."""
    k = np.empty(omega.size)
    fill_wave_numbers(omega, depth, k)
    return k


def depth_factor(wave_number: float, depth: float) -> float:
    """1 + 2 k h/sinh(2 k h): what shallow water adds; 1 in deep water, 2 in shallow (C).

    DTOcean has it for a fixed cylinder. It is the ratio of twice the group to the phase velocity,
    which the momentum in any wave is multiplied with. k in rad/m, h in m.
    """
    double = 2.0 * wave_number * depth
    return 1.0 + (double / math.sinh(double) if double < 700.0 else 0.0)


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
            wanted = Message("refused_motion.must_be_computed_or_s4")
            found.add("normalisation", repr(self.normalisation), wanted)
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
    return np.asarray(5.0 * r**-5 * np.exp(-1.25 * r**-4))


def _check_height_and_period(source: str, height: float, period: float) -> Findings:
    found = Findings(source)
    found.number("significant_height", height, "m", above=0.0)
    found.number("peak_period", period, "s", above=0.0)
    return found


@dataclass(frozen=True)
class CosineSpreading:
    """D(b) = C cos^n(b), b up to a right angle to either side of the main direction.

    C = Gamma(1 + n/2)/(sqrt(pi) Gamma(1/2 + n/2)), DNV-RP-C205: the same at every frequency. It is
    not cos^2s(b/2), which spreads over the full circle; of narrow seas s is about 2 n.
    """

    exponent: float  # n, above 0
    directions: int = 20  # into how many it is cut, each with the same energy

    def __post_init__(self) -> None:
        found = Findings("CosineSpreading")
        found.number("exponent", self.exponent, "", above=0.0)
        found.number("directions", self.directions, "", at_least=1)
        found.raise_if_any()

    @property
    def deviations(self) -> Array:
        """Angles from the main direction, rad: the median of each strip of equal energy.

        With u = sin²(b) the part of the energy within b to either side is the incomplete beta
        function of u with 1/2 and (n + 1)/2.
        """
        from scipy.special import betaincinv

        place = (2.0 * np.arange(self.directions) + 1.0) / self.directions - 1.0
        square = betaincinv(0.5, 0.5 * (self.exponent + 1.0), np.abs(place))
        angles: Array = np.sign(place) * np.arcsin(np.sqrt(square))
        return angles


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
    _check("s4_range_pierson_moskowitz", "zero_crossing_period", zero_crossing_period)
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


Bands = Literal["equal-energy", "equal-width", "S4"]
"""How the range is cut.

``"equal-energy"``: every band holds the same energy and every wave has the same amplitude; where in
its band's energy a wave lies is random. ``"equal-width"``: bands of equal width, a frequency
anywhere in its band, and amplitudes that carry the band's energy. ``"S4"``: such bands, but with
the amplitude sqrt(2 S(omega_i) domega) of S4 [2.72], so that Hs varies from seed to seed.
"""

_HALVINGS: Final = 60
"""Enough to bring any range down to neighbouring numbers of double precision."""


def random_waves(
    spectrum: Spectrum,
    count: int,
    generator: np.random.Generator,
    *,
    direction: float = 0.0,
    spreading: float | CosineSpreading | None = None,
    bands: Bands = "equal-energy",
    between: tuple[float, float] | None = None,
) -> Waves:
    """Draw a random sea.

    Parameters
    ----------
    count : int
        How many waves; see `waves_needed` for how many a run needs.
    generator : numpy.random.Generator
        Where the random numbers come from: frequencies, then phases, then directions. The same
        seed gives the same sea to the last digit.
    direction : float
        Where the sea travels to, rad from the x axis.
    spreading : float or CosineSpreading, optional
        A number is s of the spreading function cos^2s((b - direction)/2), above 0; each wave is
        given one direction b drawn from it. A `CosineSpreading` has directions of its own: of each
        as many waves that follow one another in frequency, every one gets another. Without, all
        waves have the one direction.
    bands : {"equal-energy", "equal-width", "S4"}
        How the range is cut, see `Bands`.
    between : tuple of float, optional
        Lowest and highest angular frequency, rad/s; `frequency_range` when not given. The energy
        outside is left out, and the waves' Hs is smaller by that.

    Raises
    ------
    InputError
        For a count below 1 or not a multiple of the directions, a range that is empty or not above
        0, a spreading not above 0.
    """
    low, high = frequency_range(spectrum) if between is None else between
    _surface_check(count, direction, spreading, bands, low, high)
    position = np.arange(count) + generator.random(count)
    phase = generator.uniform(0.0, 2.0 * math.pi, count)
    cut = _cut_by_energy if bands == "equal-energy" else _cut_by_width
    edges, omega = cut(spectrum, low, high, position)
    if bands == "S4":
        energy = spectrum.density(omega) * np.diff(edges)
    else:
        energy = np.diff(spectrum.energy_below(edges))
    directions = direction + _deviations(count, spreading, generator)
    return Waves(np.sqrt(2.0 * energy), omega, phase, directions)


def _cut_by_width(_: Spectrum, low: float, high: float, position: Array) -> tuple[Array, Array]:
    """Edges of bands of equal width, and frequencies at `position`, in bands from the lowest."""
    width = (high - low) / position.size
    edges: Array = low + width * np.arange(position.size + 1, dtype=float)
    return edges, low + width * position


def _cut_by_energy(
    spectrum: Spectrum, low: float, high: float, position: Array
) -> tuple[Array, Array]:
    """Edges of bands of equal energy, and frequencies at `position`, in bands from the lowest."""
    start, end = spectrum.energy_below(np.array([low, high]))
    band = (end - start) / position.size
    edges = np.array(_edges(spectrum, low, high, position.size))
    return edges, _with_energy(spectrum, low, high, start + band * position)


@lru_cache(maxsize=16)
def _edges(spectrum: Spectrum, low: float, high: float, count: int) -> tuple[float, ...]:
    """Edges of bands of equal energy: the same for every seed."""
    start, end = spectrum.energy_below(np.array([low, high]))
    band = (end - start) / count
    inside = _with_energy(spectrum, low, high, start + band * np.arange(count + 1))
    return (low, *inside[1:-1].tolist(), high)


def _with_energy(spectrum: Spectrum, low: float, high: float, energy: Array) -> Array:
    """Frequencies below which the spectrum has these energies, by halving."""
    below, above = np.full_like(energy, low), np.full_like(energy, high)
    for _ in range(_HALVINGS):
        middle = 0.5 * (below + above)
        is_short = spectrum.energy_below(middle) < energy
        below, above = np.where(is_short, middle, below), np.where(is_short, above, middle)
    result: Array = 0.5 * (below + above)
    return result


def _deviations(
    count: int, spreading: float | CosineSpreading | None, generator: np.random.Generator
) -> Array:
    """Deal out the directions of a `CosineSpreading`, or draw from the density cos^2s(b/2).

    With B = cos²(b/2), |b| < pi, that density is B^s db, and db is dB/sqrt(B (1 - B)): a beta
    distribution.
    """
    if spreading is None:
        return np.zeros(count)
    if isinstance(spreading, CosineSpreading):
        angles = spreading.deviations
        hands = [generator.permutation(angles) for _ in range(count // angles.size)]
        return np.concatenate(hands)
    cos2 = generator.beta(spreading + 0.5, 0.5, count)
    side = np.where(generator.random(count) < 0.5, -1.0, 1.0)
    result: Array = side * 2.0 * np.arccos(np.sqrt(cos2))
    return result


def _surface_check(
    count: int,
    direction: float,
    spreading: float | CosineSpreading | None,
    bands: str,
    low: float,
    high: float,
) -> None:
    found = Findings("random_waves")
    if isinstance(count, bool) or not isinstance(count, (int, np.integer)) or count < 1:
        found.add("count", repr(count), Message("refused_motion.whole_number"))
    found.number("direction", direction, "rad")
    if isinstance(spreading, CosineSpreading):
        if not found.problems and count % spreading.directions:
            wanted = Message("refused_motion.multiple_of_directions", count=spreading.directions)
            found.add("count", repr(count), wanted)
    elif spreading is not None:
        found.number("spreading", spreading, "", above=0.0)
    if bands not in get_args(Bands):
        wanted = Message("refused.one_of", words=", ".join(get_args(Bands)))
        found.add("bands", repr(bands), wanted)
    found.number("between[0]", low, "rad/s", above=0.0)
    found.number("between[1]", high, "rad/s", above=max(low, 0.0))
    found.raise_if_any()
