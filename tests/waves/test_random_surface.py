"""A random sea: what it carries, how it is cut, and how its statistics come out."""

from __future__ import annotations

import math
from typing import get_args

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.waves import (
    Sea,
    Waves,
    frequency_range,
    jonswap,
    pierson_moskowitz,
    random_waves,
    regular_wave,
    s4_range_pierson_moskowitz,
)
from catopt.waves.random_surface import Bands

SPECTRUM = jonswap(8.48, 12.965)
ENERGY = np.diff(SPECTRUM.energy_below(np.array(frequency_range(SPECTRUM))))[0]


def draw(count: int, seed: int, **options: object) -> Waves:
    return random_waves(SPECTRUM, count, np.random.default_rng(seed), **options)  # type: ignore[arg-type]


@pytest.mark.parametrize("bands", get_args(Bands))
def test_same_seed_same_digits(bands: Bands) -> None:
    one, two, other = (draw(30, seed, bands=bands, spreading=4.0) for seed in (7, 7, 8))
    for name in ("amplitude", "omega", "phase", "direction"):
        assert getattr(one, name).tobytes() == getattr(two, name).tobytes()
    assert one.omega.tobytes() != other.omega.tobytes()


@pytest.mark.parametrize("bands", ["equal-energy", "equal-width"])
@pytest.mark.parametrize("count", [1, 20, 200])
def test_the_waves_carry_the_energy_of_the_range(bands: Bands, count: int) -> None:
    """Band by band exact: what differs is the rounding of the sum."""
    waves = draw(count, 3, bands=bands)
    assert waves.variance == pytest.approx(ENERGY, rel=1e-12)
    assert waves.significant_height == pytest.approx(8.48, rel=0.5 * 1e-3)  # 0.1 % of energy left


def test_equal_energy_gives_equal_amplitudes_and_one_wave_in_each_band() -> None:
    """The energy below a frequency tells its band. The edges are found to 1e-15 of omega."""
    waves = draw(50, 1)
    np.testing.assert_allclose(waves.amplitude, waves.amplitude[0], rtol=1e-10)
    start = SPECTRUM.energy_below(frequency_range(SPECTRUM)[0])
    band = (SPECTRUM.energy_below(waves.omega) - start) / ENERGY * 50
    assert np.floor(band).tolist() == list(range(50))


@pytest.mark.parametrize("bands", ["equal-width", "S4"])
def test_equal_width_puts_one_wave_in_each_band(bands: Bands) -> None:
    low, high = frequency_range(SPECTRUM)
    band = (draw(50, 1, bands=bands).omega - low) / (high - low) * 50
    assert np.floor(band).tolist() == list(range(50))


def test_s4_amplitudes() -> None:
    """Amplitudes sqrt(2 S(omega) domega), S4 [2.72], in Table 4.4's range with its 20 waves.

    Rounding only for each; Hs is not kept: its mean square is, over seeds, since a frequency is
    anywhere in its band: 400 seas, whose Hs² scatters by 30 % each at most, give it to 5 %.
    """
    spectrum = pierson_moskowitz(8.48, 12.965)
    between = s4_range_pierson_moskowitz(12.965 / 1.408)
    width = (between[1] - between[0]) / 20
    generator = np.random.default_rng(2)
    seas = [random_waves(spectrum, 20, generator, bands="S4", between=between) for _ in range(400)]
    wanted = np.sqrt(2.0 * spectrum.density(seas[0].omega) * width)
    np.testing.assert_allclose(seas[0].amplitude, wanted, rtol=1e-12)
    variances = np.array([sea.variance for sea in seas])
    assert 0.01 < variances.std() / variances.mean() < 0.3
    energy = np.diff(spectrum.energy_below(np.array(between)))[0]
    assert variances.mean() == pytest.approx(energy, rel=0.05)


def test_a_long_run_has_the_significant_height() -> None:
    """Three hours at half a second, 300 waves, mean of 8 seeds.

    The variance of a run scatters by sqrt(pi/(sigma_w T)) of itself, sigma_w the spectrum's width
    of about 0.1 rad/s: 5 %; that of 8 runs 2 %, half of that in Hs: 1 %. Three times that is
    allowed. Gaussian: the fourth moment of the same surfaces is 3 to within a few times 5 %.
    """
    t = np.arange(0.0, 10800.0, 0.5)
    heights, kurtosis = [], []
    for seed in range(8):
        eta = Sea(100.0, draw(300, seed)).elevation(t)
        heights.append(4.0 * eta.std())
        kurtosis.append((eta**4).mean() / (eta**2).mean() ** 2)
    assert np.mean(heights) == pytest.approx(8.48, rel=0.03)
    assert np.mean(kurtosis) == pytest.approx(3.0, abs=0.15)


def test_phases_are_uniform() -> None:
    """Mean of exp(j phi) over 4000 phases: 1/sqrt(4000) = 0.016; four times that is allowed."""
    phase = draw(4000, 5, bands="S4").phase
    assert phase.min() >= 0.0
    assert phase.max() < 2.0 * math.pi
    assert abs(np.exp(1j * phase).mean()) < 0.064


@pytest.mark.parametrize("s", [1.0, 2.5, 15.0])
def test_spreading(s: float) -> None:
    """Of cos^2s(b/2) the mean of cos b is s/(s + 1), of cos 2b s (s - 1)/((s + 1)(s + 2)).

    Over 20,000 directions, whose cosines scatter by less than 1: 0.007 each; four times is allowed.
    """
    spread = draw(20000, 6, spreading=s, direction=1.0, bands="S4").direction - 1.0
    assert np.abs(spread).max() <= math.pi
    assert np.cos(spread).mean() == pytest.approx(s / (s + 1.0), abs=0.028)
    assert np.sin(spread).mean() == pytest.approx(0.0, abs=0.028)
    second = s * (s - 1.0) / ((s + 1.0) * (s + 2.0))
    assert np.cos(2.0 * spread).mean() == pytest.approx(second, abs=0.028)


def test_one_direction() -> None:
    assert set(draw(5, 1, direction=0.4).direction) == {0.4}


def test_waves_cannot_be_changed() -> None:
    given = np.array([1.0])
    waves = Waves(given, given, given, given)
    given[0] = 5.0
    assert waves.amplitude[0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        waves.amplitude[0] = 2.0


def test_regular_wave() -> None:
    wave = regular_wave(3.0, 8.0, direction=1.0, phase=2.0)
    assert (wave.count, wave.amplitude[0], wave.direction[0], wave.phase[0]) == (1, 1.5, 1.0, 2.0)
    assert wave.omega[0] == 2.0 * math.pi / 8.0
    assert wave.mean_period == pytest.approx(8.0, rel=1e-15)
    assert float(Sea(20.0, regular_wave(3.0, 8.0)).elevation(8.0)) == pytest.approx(1.5, rel=1e-14)


@pytest.mark.parametrize(
    ("options", "keys"),
    [
        ({"count": 0, "direction": math.inf}, ["count", "direction"]),
        ({"count": 2.5}, ["count"]),
        ({"spreading": 0.0, "bands": "equal"}, ["spreading", "bands"]),
        ({"between": (0.0, 2.0)}, ["between[0]"]),
        ({"between": (2.0, 1.0)}, ["between[1]"]),
    ],
)
def test_wrong_input_is_named_all_at_once(options: dict[str, object], keys: list[str]) -> None:
    given: dict[str, object] = {"count": 10, "seed": 1, **options}
    with pytest.raises(InputError) as caught:
        draw(**given)  # type: ignore[arg-type]
    assert [p.key for p in caught.value.problems] == keys


@pytest.mark.parametrize(
    ("waves", "keys"),
    [
        (([1.0, 2.0], [1.0], [0.0], [0.0]), ["amplitude"]),
        (([-1.0], [0.0], [math.nan], [0.0]), ["phase", "omega", "amplitude"]),
        (([], [], [], []), ["omega"]),
    ],
)
def test_wrong_waves_are_refused(waves: tuple[list[float], ...], keys: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        Waves(*(np.array(values) for values in waves))
    assert [p.key for p in caught.value.problems] == keys


def test_wrong_regular_wave_and_sea_are_refused() -> None:
    with pytest.raises(InputError) as caught:
        regular_wave(0.0, -8.0, phase=math.nan)
    assert [p.key for p in caught.value.problems] == ["height", "period", "phase"]
    with pytest.raises(InputError) as caught:
        Sea(0.0, 3.0, stretching="linear", reach="deep", ramp_time=-1.0)  # type: ignore[arg-type]
    keys = ["depth", "ramp_time", "waves", "stretching", "reach"]
    assert [p.key for p in caught.value.problems] == keys
