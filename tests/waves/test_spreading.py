"""Short-crested seas: what cos^n spreads over the direction."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.waves import (
    CosineSpreading,
    Waves,
    frequency_range,
    jonswap,
    random_waves,
    wave_number,
)

SPECTRUM = jonswap(3.0, 8.0, 3.3)
DEPTH = 40.0


def sea(exponent: float, *, count: int = 2000, directions: int = 40, main: float = 0.6) -> Waves:
    spread = CosineSpreading(exponent, directions)
    return random_waves(SPECTRUM, count, np.random.default_rng(3), direction=main, spreading=spread)


@pytest.mark.parametrize("exponent", [1.0, 2.0, 4.0, 7.5])
def test_each_strip_has_the_same_part_of_the_integral(exponent: float) -> None:
    """Between two medians lies 1/directions of the integral of cos^n, by the trapezoidal rule.

    20,001 points: off by (pi/2e4)² n/12, and more where cos^1 has its kink at a right angle.
    """
    angles = CosineSpreading(exponent, 8).deviations
    b = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 20001)
    density = np.cos(b) ** exponent
    below = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]))])
    parts = np.interp(angles, b, below / below[-1])
    np.testing.assert_allclose(parts, (np.arange(8) + 0.5) / 8.0, atol=1e-7)


def test_spreading_moves_no_energy_over_the_frequency() -> None:
    """Amplitudes and frequencies are those of the long-crested sea of the same seed."""
    spread = sea(2.0)
    plain = random_waves(SPECTRUM, 2000, np.random.default_rng(3), direction=0.6)
    for name in ("amplitude", "omega", "phase"):
        assert getattr(spread, name).tobytes() == getattr(plain, name).tobytes()
    low, high = SPECTRUM.energy_below(np.array(frequency_range(SPECTRUM)))
    assert spread.variance == pytest.approx(high - low, rel=1e-12)


def test_the_mean_direction_is_the_main_one() -> None:
    """Strips are symmetric, and each has as many waves of the same amplitude: rounding only."""
    waves = sea(3.0, main=-2.2)
    vector = (waves.amplitude**2 * np.exp(1j * waves.direction)).sum()
    assert float(np.angle(vector)) == pytest.approx(-2.2, abs=1e-12)


@pytest.mark.parametrize("exponent", [1.0, 2.0, 6.0])
def test_moments_over_the_direction(exponent: float) -> None:
    """Under cos^n the mean of sin² is 1/(n + 2), by parts.

    Medians in place of strips: second order in their width, with cos^1 flat at its ends the most.
    """
    errors = []
    for directions in (40, 80):
        b = CosineSpreading(exponent, directions).deviations
        errors.append(abs(float((np.sin(b) ** 2).mean()) - 1.0 / (exponent + 2.0)))
    assert errors[0] < 0.002
    assert errors[1] < 0.5 * errors[0]


def test_the_cross_spectrum_of_two_places_is_the_integral() -> None:
    """Covariance of the surfaces at two places: the double integral of S D cos(k . r).

    2000 waves in 50 hands of 40 directions: which direction a frequency gets is drawn, so that a
    sum over 2000 terms of size 1 scatters by less than 1/sqrt(2000) = 0.022 of the variance.
    """
    n, main = 2.0, 0.6
    waves = sea(n, main=main)
    b = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 721)
    D = np.cos(b) ** n * math.gamma(1.0 + n / 2.0) / (math.sqrt(math.pi) * math.gamma(0.5 + n / 2))
    omega = np.linspace(*frequency_range(SPECTRUM), 1500)
    S = SPECTRUM.density(omega)
    k = np.array([wave_number(float(w), DEPTH) for w in omega])
    own_k = np.array([wave_number(float(w), DEPTH) for w in waves.omega])
    for r in (15.0, 40.0):
        for bearing in (0.6, 0.6 + 0.5 * math.pi):
            ahead = np.cos(b + main - bearing)
            inside = D * np.cos(np.outer(k, r * ahead))
            wanted = np.trapezoid(S * np.trapezoid(inside, b, axis=1), omega)
            along = own_k * r * np.cos(waves.direction - bearing)
            found = (0.5 * waves.amplitude**2 * np.cos(along)).sum()
            assert found == pytest.approx(wanted, abs=0.022 * waves.variance)


def test_a_large_exponent_is_a_long_crested_sea() -> None:
    """cos^n is about a Gaussian of the width 1/sqrt(n): 40 medians reach 2.24 widths."""
    for exponent in (1e4, 1e6):
        widest = float(np.abs(CosineSpreading(exponent, 40).deviations).max())
        assert widest == pytest.approx(2.2414 / math.sqrt(exponent), rel=1e-3)


def test_each_direction_has_as_many_waves() -> None:
    found, counts = np.unique(sea(2.0, count=60, directions=6).direction, return_counts=True)
    assert (found.size, set(counts)) == (6, {10})


def test_wrong_input_is_refused() -> None:
    with pytest.raises(InputError, match="a multiple of 7 directions"):
        sea(2.0, count=20, directions=7)
    with pytest.raises(InputError) as caught:
        CosineSpreading(0.0, 0)
    assert [p.key for p in caught.value.problems] == ["exponent", "directions"]
