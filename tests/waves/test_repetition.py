"""When a sum of waves repeats itself, and how many waves a run needs."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.waves import (
    Waves,
    jonswap,
    random_waves,
    regular_wave,
    repetition_warning,
    strongest_return,
    waves_needed,
)

SPECTRUM = jonswap(8.48, 12.965)


def draw(count: int, seed: int) -> Waves:
    return random_waves(SPECTRUM, count, np.random.default_rng(seed))


def evenly_spaced(count: int, step: float) -> Waves:
    omega = 0.4 + step * np.arange(count, dtype=float)
    return Waves(np.ones(count), omega, np.zeros(count), np.zeros(count))


def test_even_frequencies_repeat_after_two_pi_by_their_step() -> None:
    """The lag is found to within one sample, 2 pi/(8 times the range); R there is 1."""
    waves = evenly_spaced(50, 0.02)
    found = strongest_return(waves, 400.0)
    assert found.lag == pytest.approx(2.0 * math.pi / 0.02, abs=2.0 * math.pi / (8.0 * 49 * 0.02))
    assert found.correlation == pytest.approx(1.0, abs=0.1)
    assert strongest_return(waves, 300.0).correlation < 0.3


def test_random_frequencies_follow_the_rule() -> None:
    """R about sqrt(ln(m)/n) in three hours: the mean of 10 seas within 15 % of it."""
    for count in (50, 200):
        seas = [draw(count, seed) for seed in range(10)]
        m = 10800.0 / seas[0].mean_period
        mean = np.mean([strongest_return(sea, 10800.0).correlation for sea in seas])
        assert mean == pytest.approx(math.sqrt(math.log(m) / count), rel=0.15)


def test_number_of_waves_for_three_hours() -> None:
    """ln(1080)/0.25² = 111.8."""
    assert waves_needed(10800.0, 10.0) == 112
    assert waves_needed(5.0, 10.0) == 1
    worst = strongest_return(draw(waves_needed(10800.0, 10.5), 3), 10800.0).correlation
    assert worst < 0.3


def test_twenty_waves_are_few_and_two_hundred_enough() -> None:
    text = repetition_warning(draw(20, 1), 10800.0)
    assert text is not None
    assert text.startswith("20 waves nearly repeat within the run of 10800 s: after ")
    assert repetition_warning(draw(200, 1), 10800.0) is None


def test_a_regular_wave_is_meant_to_repeat_and_a_short_run_tells_nothing() -> None:
    assert repetition_warning(regular_wave(2.0, 8.0), 1000.0) is None
    assert strongest_return(regular_wave(2.0, 8.0), 1000.0).correlation == pytest.approx(1.0)
    assert strongest_return(draw(20, 1), 50.0) == strongest_return(draw(20, 2), 60.0)


def test_wrong_input_is_named_all_at_once() -> None:
    with pytest.raises(InputError, match="duration"):
        strongest_return(draw(5, 1), 0.0)
    with pytest.raises(InputError) as caught:
        waves_needed(-1.0, 0.0, 2.0)
    keys = ["duration", "mean_period", "correlation"]
    assert [p.key for p in caught.value.problems] == keys
