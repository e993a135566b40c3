"""Waves that would break are named."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.waves import (
    Sea,
    breaking_height,
    breaking_warning,
    jonswap,
    random_waves,
    regular_wave,
    wavelength,
)


def test_limits_of_miche() -> None:
    """Deep: 0.142 of the length. Shallow: 0.142 · 2 pi = 0.892 of the depth."""
    assert breaking_height(6.0, 500.0) == pytest.approx(0.142 * wavelength(6.0, 500.0), rel=1e-14)
    shallow = breaking_height(1000.0, 2.0)
    assert shallow == pytest.approx(
        0.142 * 2.0 * math.pi * 2.0, rel=1e-5
    )  # (k d)²/3 = 8e-6 is left


def test_regular_wave() -> None:
    limit = breaking_height(8.0, 20.0)
    assert breaking_warning(Sea(20.0, regular_wave(0.999 * limit, 8.0))) is None
    text = breaking_warning(Sea(20.0, regular_wave(1.5 * limit, 8.0)))
    assert text is not None
    assert text.startswith(f"the wave height {1.5 * limit:.3g} m is more than the {limit:.3g} m")


def test_random_sea_and_still_water() -> None:
    def sea(height: float) -> Sea:
        return Sea(56.0, random_waves(jonswap(height, 9.0), 50, np.random.default_rng(1)))

    assert breaking_warning(sea(6.0)) is None
    text = breaking_warning(sea(16.0))
    assert text is not None
    assert text.startswith("the significant wave height 16 m")
    assert breaking_warning(Sea(56.0)) is None


def test_wrong_input_is_named_all_at_once() -> None:
    with pytest.raises(InputError) as caught:
        breaking_height(0.0, -1.0)
    assert [p.key for p in caught.value.problems] == ["period", "depth"]
