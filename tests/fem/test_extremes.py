"""Extremes of samples whose distribution is known."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest

from catopt.fem.extremes import CONFIDENCE, TailFit, block_maxima, gumbel, weibull_tail

Array = npt.NDArray[np.float64]

EULER = 0.57721566490


def swinging(heights: Array, mean: float = 0.0) -> Array:
    """Build a series with these peaks: up and down by each, so that its mean is `mean`."""
    return mean + np.column_stack([-heights, heights]).ravel()


def spread_evenly(shape: float, scale: float, count: int) -> Array:
    """Weibull's heights, evenly spaced in probability; no two of the upper third are neighbours."""
    p = (np.arange(count) + 0.5) / count
    heights = scale * (-np.log1p(-p)) ** (1.0 / shape)
    low, high = np.array_split(heights, 2)
    return np.column_stack([low, high[::-1]]).ravel()[:count]


def apart(heights: Array) -> Array:
    """Put a low peak after each."""
    return np.column_stack([heights, np.full(heights.size, 1e-3)]).ravel()


def fitted(series: list[Array], time: float, duration: float) -> TailFit:
    found = weibull_tail(series, time, duration)
    assert found is not None
    return found


@pytest.mark.slow
@pytest.mark.parametrize("longer", [1.0, 18.0])
@pytest.mark.parametrize("shape", [2.0, 1.3])
def test_the_largest_of_weibulls_peaks(shape: float, longer: float) -> None:
    """Most probable: a (ln n)^(1/b), for Rayleigh s sqrt(2 ln n); the mean 0.577 of the scale more.

    The scale of the largest of n is a/b (ln n)^(1/b - 1), for Rayleigh s/sqrt(2 ln n).
    """
    count, scale, mean = 20000, 3.0, 10.0
    series = swinging(spread_evenly(shape, scale, count), mean)
    found = fitted([series], 2.0e5, 2.0e5 * longer)
    number = math.log(count * longer)
    probable = mean + scale * number ** (1.0 / shape)
    expected = probable + EULER * scale / shape * number ** (1.0 / shape - 1.0)
    # What lies beyond 1/40000 is not in the sample.
    assert found.shape == pytest.approx(shape, rel=0.02)
    assert found.extreme.most_probable == pytest.approx(probable, rel=5e-3)
    assert found.extreme.expected == pytest.approx(expected, rel=5e-3)
    assert found.expected_above(found.extreme.most_probable) == pytest.approx(1.0, rel=1e-9)
    assert found.peaks == count - 1
    assert found.mean == pytest.approx(mean)
    assert found.extreme.low < probable < found.extreme.high


@pytest.mark.slow
def test_the_interval_holds_the_truth_as_often_as_it_says() -> None:
    """200 draws of 400 peaks, three of ten of them above the threshold, carried 20 times as far."""
    draw = np.random.default_rng(3)
    held = 0
    for _ in range(200):
        heights = apart(2.0 * draw.weibull(1.3, 200))
        found = fitted([swinging(heights)], 1.0, 20.0)
        # Half of the peaks are none of Weibull's: those above the threshold are all that counts.
        truth = 2.0 * math.log(20.0 * 200) ** (1.0 / 1.3)
        held += found.extreme.low <= truth <= found.extreme.high
    # Binomial deviation of 200 draws: 2.1 %.
    assert held / 200 == pytest.approx(CONFIDENCE, abs=0.065)


def test_runs_are_taken_together() -> None:
    """Peaks that follow each other are one; the end of a run parts them."""
    draw = np.random.default_rng(1)
    high, low = 5.0 + draw.weibull(2.0, 60), 1.0 + 0.1 * draw.weibull(2.0, 140)
    series = swinging(np.concatenate([low, high]))
    # 60 of 200 in a row are one cluster, and nothing to fit.
    assert weibull_tail([series], 1.0, 10.0) is None
    one_each = [swinging(np.array([low[2 * k], low[2 * k + 1], high[k], 0.5])) for k in range(60)]
    found = fitted(one_each, 1.0, 10.0)
    assert len(found.clusters) > 40


def test_groups_count_once() -> None:
    draw = np.random.default_rng(2)
    alone = apart(draw.weibull(2.0, 500))
    twice = np.repeat(alone, 2)
    one, two = (fitted([swinging(each)], 1.0, 10.0) for each in (alone, twice))
    assert len(two.clusters) == len(one.clusters)
    assert two.extreme.most_probable == pytest.approx(one.extreme.most_probable, rel=1e-6)


def test_the_same_digits_again_and_a_narrower_interval_with_more() -> None:
    draw = np.random.default_rng(4)
    series = [swinging(apart(draw.weibull(2.0, 60))) for _ in range(20)]
    few, more = (fitted(series[:n], float(n), 20.0).extreme for n in (2, 20))
    assert fitted(series[:2], 2.0, 20.0).extreme == few
    assert more.high - more.low < 0.5 * (few.high - few.low)


@pytest.mark.parametrize(
    ("heights", "duration"),
    [
        (np.linspace(1.0, 2.0, 10), 10.0),  # 19 with the low ones
        (np.full(300, 2.0), 10.0),  # all alike
        (np.random.default_rng(1).weibull(2.0, 300), 1e-3),  # not one expected
    ],
)
def test_where_there_is_no_tail(heights: Array, duration: float) -> None:
    assert weibull_tail([swinging(apart(heights))], 1.0, duration) is None


def test_gumbels_mode_moves_with_the_duration() -> None:
    """Maxima evenly spaced in Gumbel's probability with mode 4 and scale 0.5."""
    p = (np.arange(2000) + 0.5) / 2000
    maxima = (4.0 - 0.5 * np.log(-np.log(p))).tolist()
    found = gumbel(maxima, 600.0, 10800.0)
    assert found is not None
    assert (found.mode, found.scale) == pytest.approx((4.0, 0.5), abs=5e-3)
    probable = 4.0 + 0.5 * math.log(18.0)
    assert found.extreme.most_probable == pytest.approx(probable, abs=0.01)
    assert found.extreme.expected == pytest.approx(probable + EULER * 0.5, abs=0.01)
    assert gumbel(maxima[:4], 600.0, 10800.0) is None
    assert gumbel([3.0] * 9, 600.0, 10800.0) is None


@pytest.mark.slow
@pytest.mark.parametrize("runs", [5, 20])
def test_gumbels_interval_holds_the_truth_as_often_as_it_says(runs: int) -> None:
    draw = np.random.default_rng(8)
    truth = 4.0 + 0.5 * math.log(18.0)
    held = 0
    for _ in range(1000):
        found = gumbel(draw.gumbel(4.0, 0.5, runs).tolist(), 600.0, 10800.0)
        assert found is not None
        held += found.extreme.low <= truth <= found.extreme.high
    # The pivot is exact; binomial deviation of 1000 draws 0.95 %, and of 4000 of the bootstrap's.
    assert held / 1000 == pytest.approx(CONFIDENCE, abs=0.03)


def test_the_largest_value_of_each_minute() -> None:
    """Twelve minutes whose largest values are known; a minute without a value is left out."""
    time = np.array([0.0, 10.0, 59.0, 61.0, 130.0, 179.0, 241.0, 300.0])
    values = np.array([1.0, 7.0, 2.0, 5.0, 3.0, 4.0, 9.0, 8.0])
    assert block_maxima(time, values, 60.0).tolist() == [7.0, 5.0, 4.0, 9.0]


def test_snaps_among_other_peaks_come_to_what_long_runs_do() -> None:
    """Two kinds of peaks: by every minute's largest as in 1,000 storms."""
    draw = np.random.default_rng(7)

    def run(minutes: int) -> Array:  # 15 peaks a minute, three in ten of them snaps
        calm = 10.0 + 3.0 * draw.rayleigh(size=(minutes, 15))
        snaps = 60.0 + 12.0 * draw.exponential(size=(minutes, 15)) ** 0.7
        return np.where(draw.random((minutes, 15)) < 0.3, snaps, calm)

    truth = float(np.median([run(180).max() for _ in range(1000)]))
    found = []
    for _ in range(40):
        peaks = run(27).ravel()
        turns = np.stack([peaks, np.zeros(peaks.size)], axis=1).ravel()
        time = np.linspace(0.0, 1620.0, turns.size)
        fit = gumbel(block_maxima(time, turns, 60.0).tolist(), 60.0, 10800.0)
        assert fit is not None
        found.append(fit.extreme.most_probable / truth)
    assert 0.9 < np.mean(found) < 1.1


def test_means_lie_eulers_constant_of_a_scale_above_what_is_most_probable() -> None:
    """Gumbel by moments, by hand: scale = s sqrt(6)/pi, mode = mean - 0.5772 scale.

    Of 1 to 6 the mean is 3.5 and the variance 17.5/5 = 3.5.
    """
    found = gumbel([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 600.0, 6000.0)
    assert found is not None
    scale = math.sqrt(3.5 * 6.0) / math.pi
    assert found.mode == pytest.approx(3.5 - EULER * scale, rel=1e-10)
    assert found.extreme.expected - found.extreme.most_probable == pytest.approx(
        EULER * scale, rel=1e-10
    )
    heights = spread_evenly(2.0, 3.0, 2000)
    tail = fitted([swinging(heights)], 2.0e4, 2.0e4)
    # Of Weibull's largest of n the local scale is the derivative of a (ln n)^(1/b) by ln n.
    above = tail.extreme.most_probable / tail.scale
    local = tail.extreme.most_probable / (tail.shape * above**tail.shape)
    over = tail.extreme.expected - tail.extreme.most_probable
    assert over == pytest.approx(EULER * local, rel=1e-6)
