"""A recorded surface: its waves are the record again."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest

from catopt.errors import InputError
from catopt.waves import ElevationRecord, Sea, repetition_warning

Array = npt.NDArray[np.float64]

STEP = 0.5
EPS = float(np.finfo(float).eps)


def noise(count: int, seed: int = 1) -> Array:
    return np.random.default_rng(seed).normal(0.3, 1.0, count)


def times(count: int) -> Array:
    return 7.0 + STEP * np.arange(count, dtype=float)


@pytest.mark.parametrize("count", [64, 65, 997])
def test_all_waves_together_are_the_record_again(count: int) -> None:
    """Every sample, to the rounding of a sum of so many waves; even and odd numbers of samples."""
    eta = noise(count)
    record = ElevationRecord(times(count), eta)
    waves = record.waves(shortest_period=2.0 * STEP)
    again = Sea(20.0, waves).elevation(STEP * np.arange(count)) + record.mean
    assert np.abs(again - eta).max() < 50.0 * EPS * count
    assert record.left_out(waves) == pytest.approx(0.0, abs=1e-13)
    assert record.mean == pytest.approx(eta.mean(), rel=1e-12)


def test_two_waves_come_back_with_their_figures() -> None:
    """400 samples of waves of 20 and 8 s, whole numbers of which fit into 200 s."""
    t = STEP * np.arange(400, dtype=float)
    eta = 1.5 * np.cos(2.0 * math.pi / 20.0 * t - 0.4) + 0.5 * np.cos(2.0 * math.pi / 8.0 * t + 1.0)
    waves = ElevationRecord(t, 3.0 + eta).waves(direction=2.0)
    largest = np.argsort(waves.amplitude)[:-3:-1]
    assert (2.0 * math.pi / waves.omega[largest]).tolist() == pytest.approx([20.0, 8.0])
    assert waves.amplitude[largest].tolist() == pytest.approx([1.5, 0.5], rel=1e-12)
    # eta = a cos(-omega t + phi): cos(omega t - 0.4) has phi = 0.4, cos(omega t + 1) has -1.
    assert waves.phase[largest].tolist() == pytest.approx([0.4, -1.0], abs=1e-12)
    assert set(waves.direction) == {2.0}
    assert waves.variance == pytest.approx(0.5 * (1.5**2 + 0.5**2), rel=1e-12)


def test_what_is_left_out_is_told() -> None:
    """Waves of 2, 1 and 0.02 m: variances 2, 0.5 and 0.0002, of which the last is 8e-5."""
    t = STEP * np.arange(400, dtype=float)
    periods, amplitudes = np.array([20.0, 8.0, 2.0]), np.array([2.0, 1.0, 0.02])
    eta = np.cos(2.0 * math.pi * np.outer(t, 1.0 / periods)) @ amplitudes
    record = ElevationRecord(t, eta)
    usual = record.waves()
    assert 2.0 * math.pi / usual.omega[-1] == pytest.approx(8.0)
    assert record.left_out(usual) == pytest.approx(0.0002 / 2.5002, rel=1e-9)
    slow = record.waves(shortest_period=10.0)
    assert 2.0 * math.pi / slow.omega[-1] == pytest.approx(10.0)
    assert record.left_out(slow) == pytest.approx(0.5002 / 2.5002, rel=1e-9)


def test_uneven_times_are_evened_out_along_straight_lines() -> None:
    """A saw of straight sides, sampled at its corners and between them: the same at even steps."""
    t = np.array([0.0, 1.0, 2.5, 3.0, 4.0, 5.5, 6.0, 7.0, 8.0])
    saw = np.interp(t, [0.0, 4.0, 8.0], [0.0, 2.0, 0.0])
    record = ElevationRecord(t, saw)
    assert record.is_resampled
    even = ElevationRecord(np.arange(9.0), np.interp(np.arange(9.0), t, saw))
    assert not even.is_resampled
    a, b = (each.waves(shortest_period=2.0) for each in (record, even))
    assert a.amplitude.tolist() == b.amplitude.tolist()


def test_rounded_times_are_even() -> None:
    t = np.round(np.arange(0.0, 40.0, 1.0 / 3.0), 3)
    assert not ElevationRecord(t, noise(t.size)).is_resampled


def test_it_begins_anew_after_its_own_length_and_that_is_said() -> None:
    waves = ElevationRecord(times(100), noise(100)).waves(shortest_period=1.0)
    sea = Sea(20.0, waves)
    assert float(sea.elevation(3.0)) == pytest.approx(float(sea.elevation(53.0)), abs=1e-12)
    assert repetition_warning(waves, 50.0) is None
    assert repetition_warning(waves, 51.0) == (
        "the waves are those of a record of 50 s and repeat within the run of 51 s"
    )


@pytest.mark.parametrize(
    ("t", "eta", "message"),
    [
        (times(7), noise(7), "8 times or more"),
        (times(9), noise(8), "with as many elevations"),
        (times(9)[::-1], noise(9), "must rise"),
        (np.append(times(9), 60.0), noise(10), "a gap of 49 s after 11 s"),
        (times(9), np.full(9, 2.0), "a surface that moves is required"),
        (times(9), np.append(noise(8), math.nan), "finite numbers"),
    ],
)
def test_a_wrong_record_is_refused(t: Array, eta: Array, message: str) -> None:
    with pytest.raises(InputError, match=message):
        ElevationRecord(t, eta)


def test_no_wave_is_so_slow() -> None:
    with pytest.raises(InputError, match="the record has no wave of such a long period"):
        ElevationRecord(times(20), noise(20)).waves(shortest_period=11.0)
