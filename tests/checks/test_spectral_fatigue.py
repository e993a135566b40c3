"""Dual narrow band beside rainflow counting of simulated tensions."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

from catopt.checks.fatigue import (
    CURVES,
    Band,
    Cycles,
    FatigueStrength,
    bands,
    count_cycles,
    range_moment,
)

STEP, COUNT = 0.5, 2**17
FAST = 0.1


def drawn(parts: Sequence[tuple[float, float]], seed: int) -> np.ndarray:
    """Draw a normally distributed series of bands: their variance and rate, 1/s."""
    rng = np.random.default_rng(seed)
    frequency = np.fft.rfftfreq(COUNT, STEP)
    power = np.zeros(frequency.size)
    for variance, rate in parts:
        bell = np.exp(-0.5 * ((frequency - rate) / (0.1 * rate)) ** 2)
        power += variance * bell / bell.sum()
    white = rng.normal(size=frequency.size) + 1j * rng.normal(size=frequency.size)
    return np.asarray(np.fft.irfft(white * np.sqrt(power), COUNT)) * 0.5 * COUNT


def parted(values: np.ndarray, gap: float) -> tuple[float, tuple[Band, Band]]:
    time = (values.size - 1) * STEP
    return time, bands(values, time, 2.0 * math.pi * FAST / math.sqrt(gap))


@pytest.mark.parametrize("slow", [0.2, 0.35, 0.5, 0.65, 0.8])
@pytest.mark.parametrize("gap", [5.0, 15.0])
def test_ten_spectra_of_two_bands(slow: float, gap: float) -> None:
    """Within 15 % of rainflow; the two bands added up fall short, up to a third is left."""
    pytest.importorskip("rainflow")
    values = drawn(((slow, FAST / gap), (1.0 - slow, FAST)), seed=3)
    time, (low, high) = parted(values, gap)
    assert low.rate == pytest.approx(FAST / gap, rel=0.05)
    assert high.rate == pytest.approx(FAST, rel=0.05)
    counted = count_cycles(values, time)
    for slope in (3.0, 4.8):
        found = float(counted.counts @ counted.ranges**slope) / time
        assert range_moment(low, high, slope) == pytest.approx(found, rel=0.15)
        none = Band(0.0, 0.0)
        added = range_moment(low, none, slope) + range_moment(none, high, slope)
        assert 0.25 * found < added < 0.97 * found


def test_one_band_is_rayleighs_ranges() -> None:
    """Drawn from Rayleigh's distribution by another way: numpy's."""
    ranges = 2.0 * np.random.default_rng(1).rayleigh(3.0, 2_000_000)
    found = range_moment(Band(9.0, 0.2), Band(0.0, 0.0), 3.0)
    assert found == pytest.approx(0.2 * float((ranges**3).mean()), rel=0.01)


def test_the_variance_of_the_bands_is_that_of_the_series() -> None:
    values = drawn(((2.0, 0.01), (1.0, FAST)), seed=7) + 40.0
    _, (low, high) = parted(values, 10.0)
    assert low.variance + high.variance == pytest.approx(values.var(), rel=1e-9)
    assert low.variance > high.variance


@pytest.mark.parametrize("name", ["E301 studless", "API six-strand"])
def test_the_damage_of_a_year_is_in_proportion(name: str) -> None:
    """The curve's factor, its fall with the mean and its reference are those of the counted one."""
    pytest.importorskip("rainflow")
    values = 2e5 * drawn(((1.0, FAST),), seed=2) + 1.5e6
    time, _ = parted(values, 10.0)
    counted = count_cycles(values, time, 2.0 * math.pi * 0.03)
    strength = FatigueStrength(CURVES[name], 9e-3 if name.startswith("E301") else 6e6, 0.076)
    quick = strength.damage_by_spectrum([counted, counted])
    assert quick == pytest.approx(strength.damage([counted, counted]), rel=0.1)
    alone = Cycles(counted.ranges, counted.counts, counted.mean, counted.time)
    assert strength.damage_by_spectrum([counted, alone]) is None


@pytest.mark.parametrize(
    ("slow", "fast", "slope", "by_hand"),
    [
        # l = 1/2 each, d n_W/n_L = 1, m = 3: n_P = 0.5 x 0.01 sqrt 2, 1 - sqrt 1 = 0,
        # sqrt(pi/4) 3 G(2)/G(2.5) = 2 and n_W l_W^1.5 = 0.1 x 0.353553:
        # (0.0141421 + 0.0353553) x (2 sqrt 4)^3 G(2.5) = 0.0494975 x 64 x 1.329340
        (Band(1.0, 0.01), Band(1.0, 0.1), 3.0, 4.21114),
        # l = 0.8 and 0.2, m = 4: n_P = 0.8 x 0.02 sqrt(1 + 0.25 x 0.5^2) = 0.0164924;
        # 0.8^4 (1 - 0.5) + sqrt(0.16 pi) 4 G(2.5)/G(3) = 0.2048 + 1.884956 = 2.089756;
        # 0.0344651 + 0.1 x 0.2^2 = 0.0384651, x (2 sqrt 2)^4 G(3) = 128
        (Band(0.8, 0.02), Band(0.2, 0.1), 4.0, 4.92353),
        # l = 0.96 and 0.04, m = 2: n_P = 0.96 x 0.02 sqrt(1 + 0.0416667 x 0.25) = 0.0192997;
        # 0.96^3 (1 - 0.204124) + sqrt(0.0384 pi) 2 G(1.5)/G(2) = 0.704140 + 0.615624 = 1.319764;
        # 0.0254711 + 0.1 x 0.04 = 0.0294711, x 8
        (Band(0.96, 0.02), Band(0.04, 0.1), 2.0, 0.235769),
    ],
)
def test_jiao_and_moan_by_hand(slow: Band, fast: Band, slope: float, by_hand: float) -> None:
    """The formula of 1990 at the head of `catopt.checks.fatigue`."""
    assert range_moment(slow, fast, slope) == pytest.approx(by_hand, rel=2e-6)  # printed digits


def test_a_band_of_a_millionth_of_the_variance_is_none() -> None:
    """Then the other alone is left: n (2 sqrt(2 s))^m G(1 + m/2), whichever of the two it is."""
    alone = 0.1 * (2.0 * math.sqrt(4.0)) ** 3 * math.gamma(2.5)
    whole, trace = Band(2.0, 0.1), Band(1e-6, 0.01)
    for pair in ((whole, trace), (trace, whole)):
        assert range_moment(*pair, 3.0) == pytest.approx(alone, rel=1e-12)
    assert range_moment(Band(0.0, 0.0), Band(0.0, 0.0), 3.0) == 0.0


@pytest.mark.parametrize("size", [1.0, 0.01])
def test_the_bands_of_two_sinusoids_by_hand(size: float) -> None:
    """2 cos 0.01 t and 3 cos t over one period and a hundred: variances 2 and 4.5, rates w/2 pi."""
    steps = 5000
    t = np.arange(steps) * (200.0 * math.pi / steps)
    time = 200.0 * math.pi * (steps - 1) / steps
    values = 5.0 + size * (2.0 * np.cos(0.01 * t) + 3.0 * np.cos(t))
    slow, fast = bands(values, time, 0.5)
    assert slow == pytest.approx((2.0 * size**2, 0.01 / math.tau), rel=1e-9)
    assert fast == pytest.approx((4.5 * size**2, 1.0 / math.tau), rel=1e-9)
    none, both = bands(values, time, 0.005)
    assert none.variance == pytest.approx(0.0, abs=1e-9)
    assert both.variance == pytest.approx(6.5 * size**2, rel=1e-9)


def test_a_frequency_at_the_split_is_in_one_of_the_bands() -> None:
    """Of 99 samples, so that no frequency is alone; the whole variance is parted at each."""
    values = np.random.default_rng(5).normal(size=99)
    time, whole = 98.0, 98.0 * 99 / 98
    for k in (1, 7, 49):
        low, high = bands(values, time, k * (2.0 * math.pi / whole))
        assert low.variance + high.variance == pytest.approx(values.var(), rel=1e-9)
