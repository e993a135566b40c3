"""Gusts: the spectrum by hand, and series that have its energy."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.loads.environment import gust_series, npd_spectrum


def test_spectrum_by_hand() -> None:
    """20 m/s, 0.01 Hz, 10 m: F = 172 0.01 2^-0.75 = 1.0227; 320 4 / (1 + F^0.468)^3.5613."""
    F = 1.72 * 2.0**-0.75
    expected = 1280.0 / (1.0 + F**0.468) ** (5.0 / 1.404)
    assert npd_spectrum(np.array([0.01]), 20.0)[0] == pytest.approx(expected, rel=1e-12)
    assert expected == pytest.approx(106.4, abs=0.1)


def test_a_series_has_the_energy_of_its_band() -> None:
    series = gust_series(25.0, 7200, 1.0, np.random.default_rng(3))
    frequency = np.linspace(1.0 / 7200.0, 0.5, 200_000)
    density = npd_spectrum(frequency, 25.0)
    energy = float(((density[1:] + density[:-1]) * 0.5).sum() * (frequency[1] - frequency[0]))
    assert series.mean() == pytest.approx(0.0, abs=1e-9)
    assert series.std() == pytest.approx(math.sqrt(energy), rel=0.02)
    again = gust_series(25.0, 7200, 1.0, np.random.default_rng(3))
    assert np.array_equal(series, again)


def test_refused() -> None:
    with pytest.raises(InputError, match="speed"):
        npd_spectrum(np.ones(1), 0.0)
