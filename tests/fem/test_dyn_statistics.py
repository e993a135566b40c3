"""Statistics of series whose distribution is known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.fem.extremes import peaks_above_mean, power_spectrum, series_statistics


def test_sine() -> None:
    t = np.linspace(0.0, 100.0, 10001)
    found = series_statistics(t, 5.0 + 2.0 * np.sin(2.0 * math.pi * t / 10.0 - 0.1))
    # A hundredth of a period from sample to sample: 1 - cos of 1/2000 of a turn.
    assert found.mean == pytest.approx(5.0, abs=1e-3)
    assert found.std == pytest.approx(math.sqrt(2.0), rel=1e-3)
    assert (found.maximum, found.minimum) == pytest.approx((7.0, 3.0), abs=1e-4)
    assert found.peaks == 9


def test_peaks_lie_between_upward_crossings() -> None:
    values = np.array([-1.0, 2.0, 3.0, -1.0, 1.0, 0.5, -4.0, 5.0, -6.0])
    # Mean -0.06: upward at 2, at 1 and at 5; the last peak has no end.
    assert peaks_above_mean(values).tolist() == [3.0, 1.0]
    assert peaks_above_mean(values, 0.9).tolist() == [3.0, 1.0]
    assert peaks_above_mean(values, 2.5).tolist() == [3.0]


def test_spectrum_holds_the_variance() -> None:
    rng = np.random.default_rng(1)
    t = np.arange(0.0, 1000.0, 0.1)
    values = np.convolve(rng.standard_normal(t.size), np.ones(20) / 20, mode="same")
    omega, S = power_spectrum(t, values)
    # Chance of nine pieces of noise with about 100 independent frequencies.
    assert np.trapezoid(S, omega) == pytest.approx(values.var(), rel=0.1)
    values = np.sin(1.5 * t)
    omega, S = power_spectrum(t, values)
    assert omega[S.argmax()] == pytest.approx(1.5, abs=omega[1])


def test_nothing_to_count() -> None:
    with pytest.raises(InputError, match="since"):
        series_statistics(np.zeros(1), np.zeros(1))
