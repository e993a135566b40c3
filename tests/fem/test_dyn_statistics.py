"""Statistics of series whose distribution is known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.fem.statistics import (
    gumbel_most_probable,
    peaks_above_mean,
    power_spectrum,
    series_statistics,
    weibull_most_probable,
)


def test_sine() -> None:
    t = np.linspace(0.0, 100.0, 10001)
    found = series_statistics(t, 5.0 + 2.0 * np.sin(2.0 * math.pi * t / 10.0 - 0.1))
    # A hundredth of a period from sample to sample: 1 - cos of 1/2000 of a turn.
    assert found.mean == pytest.approx(5.0, abs=1e-3)
    assert found.std == pytest.approx(math.sqrt(2.0), rel=1e-3)
    assert (found.maximum, found.minimum) == pytest.approx((7.0, 3.0), abs=1e-4)
    assert found.peaks == 9
    assert found.most_probable_maximum is None


def test_peaks_lie_between_upward_crossings() -> None:
    values = np.array([-1.0, 2.0, 3.0, -1.0, 1.0, 0.5, -4.0, 5.0, -6.0])
    # Mean -0.06: upward at 2, at 1 and at 5; the last peak has no end.
    assert peaks_above_mean(values).tolist() == [3.0, 1.0]


def test_rayleigh_peaks() -> None:
    """Weibull with b = 2: the most probable largest of n is s sqrt(2 ln n)."""
    s, n = 3.0, 20000
    # Evenly spaced in probability: no chance in it.
    p = (np.arange(n) + 0.5) / n
    peaks = 10.0 + s * np.sqrt(-2.0 * np.log(1.0 - p))
    for count in (100, 1000):
        expected = 10.0 + s * math.sqrt(2.0 * math.log(count))
        # The tail beyond 1/20000 is cut off.
        assert weibull_most_probable(peaks, 10.0, count) == pytest.approx(expected, rel=2e-3)


def test_equal_peaks() -> None:
    assert weibull_most_probable(np.full(30, 7.0), 5.0) == pytest.approx(7.0)


def test_gumbel_mode() -> None:
    """Maxima evenly spaced in Gumbel's probability with mode 4 and scale 0.5."""
    p = (np.arange(20000) + 0.5) / 20000
    maxima = 4.0 - 0.5 * np.log(-np.log(p))
    assert gumbel_most_probable(maxima.tolist()) == pytest.approx(4.0, abs=5e-3)
    with pytest.raises(InputError, match="two runs"):
        gumbel_most_probable([1.0])


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
