"""A random sea: a spectrum cut into bands, one wave of random frequency and phase in each.

Between which frequencies a spectrum is cut into components.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Final, Literal, get_args

import numpy as np

from catopt.arrays import Array
from catopt.model.kinds import Findings
from catopt.waves.components import Waves
from catopt.waves.spectrum import Spectrum
from catopt.words import Message


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
        How many waves; see `repetition` for how many a run needs.
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
    _check(count, direction, spreading, bands, low, high)
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


def _check(
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
