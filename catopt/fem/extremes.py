"""Statistics and extremes of random series: the largest value in a storm, and its interval.

A sample every so often misses what comes and goes between two. So every step is followed: of each
quantity its turning points are kept, from which peaks, crossings and cycles are those of all steps
whatever the samples; only turns by less than a ten-thousandth of its largest size are passed over.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Final

import numpy as np

from catopt.arrays import Array, Codes
from catopt.errors import refused
from catopt.model.kinds import Positive, Share, Time
from catopt.records import Counted, From, Record
from catopt.words import Message


@dataclass(frozen=True)
class SeriesStatistics:
    """What a series does."""

    mean: float  # in the series' unit, as the next three
    std: float
    maximum: float
    minimum: float
    time_of_maximum: float  # s
    duration: float  # s
    peaks: int  # maxima between one upward crossing of the mean and the next


def series_statistics(time: Array, values: Array) -> SeriesStatistics:
    """Statistics of one series.

    Parameters
    ----------
    time, values : ndarray, shape (n,)
        Evenly spaced, s, and the series; two or more.
    """
    if time.size < 2:
        allowed = Message("refused_motion.two_or_more_are_wanted")
        samples = Message("refused_motion.samples", count=time.size)
        raise refused("time", samples, allowed, "series_statistics")
    return SeriesStatistics(
        mean=float(values.mean()),
        std=float(values.std()),
        maximum=float(values.max()),
        minimum=float(values.min()),
        time_of_maximum=float(time[values.argmax()]),
        duration=float(time[-1] - time[0]),
        peaks=peaks_above_mean(values).size,
    )


def peaks_above_mean(values: Array, mean: float | None = None) -> Array:
    """Largest value between each upward crossing of the mean (its own by default) and the next."""
    above = values > (values.mean() if mean is None else mean)
    ups = np.flatnonzero(above[1:] & ~above[:-1]) + 1
    if ups.size < 2:
        return np.empty(0)
    return np.asarray(np.maximum.reduceat(values[: ups[-1]], ups[:-1]))


def power_spectrum(time: Array, values: Array, *, pieces: int = 8) -> tuple[Array, Array]:
    """One-sided spectrum over the angular frequency, by Welch's method.

    Parameters
    ----------
    time, values : ndarray, shape (n,)
        Evenly spaced, s, and the series.
    pieces : int
        Half-overlapping pieces of about 2/(pieces + 1) of the length, with Hann's window.

    Returns
    -------
    omega, S : ndarray
        rad/s, and the series' unit squared times s/rad; the area under S is the variance.
    """
    from scipy.signal import welch

    rate = (time.size - 1) / float(time[-1] - time[0])
    size = max(8, 2 * time.size // (pieces + 1))
    f, S = welch(values, rate, nperseg=min(size, time.size), detrend="constant")
    return 2.0 * math.pi * f, S / (2.0 * math.pi)


CONFIDENCE: Final = 0.9
"""Part of repeated draws in which an interval is to hold the true most probable maximum."""

LEAST_RUNS: Final = 5
"""Maxima of runs from which Gumbel's distribution is fitted."""

_LEAST_PEAKS = 20
_LEAST_CLUSTERS = 5
_UPPER = 0.3
"""Part of the peaks above the threshold: `benchmarks/results/extremes.md` compares others."""
_FEW = 30
"""Peaks above the threshold where that part is fewer, or half of them all."""
_STEP = 0.05
_SHAPES = np.arange(0.4, 6.0, _STEP)
"""Between which the shape is sought: snaps have less than 1, saturating responses more than 3."""
_DRAWS = 1000
_SEED = 20250
_EULER = float(np.euler_gamma)


@dataclass(frozen=True)
class Extreme(Record):
    """Largest value in a time; values in the unit of the series."""

    duration: Time
    """Of interest, s."""
    most_probable: float
    """In unit."""
    expected: float
    """In unit: mean of the largest value."""
    low: float
    """In unit: where the interval of the most probable maximum begins."""
    high: float
    """In unit: where it ends."""
    confidence: Share = CONFIDENCE
    """Part of repeated draws in which the interval is to hold the true value."""


_OF_EXTREME: Final = (
    "extreme.duration extreme.most_probable=most_probable_max extreme.low extreme.high "
    "extreme.confidence extreme.expected=expected_max "
)


@dataclass(frozen=True)
class TailFit(Record):
    """Weibull's distribution of what lies above a threshold.

    P(X > x) / P(X > threshold) = exp(((threshold - mean)/scale)^shape - ((x - mean)/scale)^shape)
    """

    DOCUMENT = f"{_OF_EXTREME}mean threshold scale shape peaks peaks_above time"

    extreme: Extreme
    """That follows."""
    mean: float
    """In unit: of the series, from which scale and threshold count."""
    threshold: float
    """In unit: above it peaks are fitted."""
    scale: Positive
    """In unit: Weibull's scale above the mean."""
    shape: Positive
    """Weibull's shape, a pure number; 2 for Rayleigh's peaks."""
    clusters: tuple[float, ...]
    """Largest peak of each group that stays above the threshold, falling: what is fitted."""
    peaks: Counted
    """Peaks between upward crossings of the mean."""
    time: Time
    """Of all runs, s, after the ramps."""

    @property
    def peaks_above(self) -> Counted:
        """Largest peaks of the groups above the threshold."""
        return len(self.clusters)

    def expected_above(self, value: float) -> float:
        """Give the clusters expected above a value in the duration; it is the threshold or more."""
        a = ((self.threshold - self.mean) / self.scale) ** self.shape
        b = ((value - self.mean) / self.scale) ** self.shape
        return len(self.clusters) * self.extreme.duration / self.time * math.exp(a - b)


@dataclass(frozen=True)
class GumbelFit(Record):
    """Gumbel's distribution of the maxima of runs."""

    DOCUMENT = f"{_OF_EXTREME}mode scale runs run"

    extreme: Extreme
    """That follows: the mode moves by scale ln(duration/run)."""
    mode: float
    """In unit: most probable maximum of one run."""
    scale: Positive
    """In unit: of the maxima of runs."""
    runs: Annotated[int, From(5)]
    """Whose maxima they are."""
    run: Time
    """Of each, s, after the ramp."""


def weibull_tail(
    series: Sequence[Array], time: float, duration: float, *, mean: float | None = None
) -> TailFit | None:
    """Fit Weibull's distribution to the highest peaks of a random series.

    Peaks are taken between upward crossings of the mean; the threshold leaves the upper 30 % of
    them, or 30 where that is fewer. Of peaks that follow each other above it the largest counts
    (declustering: Coles, An Introduction to Statistical Modeling of Extreme Values, 2001, 5.3.2).
    Scale and shape are the most likely ones. The most probable maximum is the value that one
    cluster is expected above in the duration, and the expected maximum Euler's constant times the
    tail's local scale more. The interval is a parametric bootstrap of the studentised logarithm.

    Parameters
    ----------
    series : sequence of ndarray
        Without transients; evenly spaced values or, so that no peak is lost, turning points
        (`Course.value`). Several runs of the same process are taken together.
    time, duration : float
        Of all of them, and of interest, s.
    mean : float, optional
        Over time, of all of them; that of the values when left out, as of evenly spaced ones.

    Returns
    -------
    TailFit or None
        None for fewer than 20 peaks or 5 clusters, where they are all alike, or where less than
        one cluster is expected in the duration.
    """
    mean = float(np.concatenate(series).mean()) if mean is None else mean
    runs = [peaks_above_mean(values, mean) - mean for values in series]
    heights = np.sort(np.concatenate(runs))[::-1]
    if heights.size < _LEAST_PEAKS:
        return None
    above = max(int(_UPPER * heights.size), min(_FEW, heights.size // 2))
    threshold = float(heights[above])
    clusters = np.sort(np.concatenate([_clusters(each, threshold) for each in runs]))[::-1]
    often = clusters.size * duration / time
    if clusters.size < _LEAST_CLUSTERS or often <= 1.0:
        return None
    if clusters[0] - threshold <= 1e-9 * clusters[0]:
        return None
    fitted = _fit(np.log(clusters / threshold)[None, :], np.array([clusters.size]))
    shape, steep = float(fitted[0][0]), float(fitted[1][0])
    ratio, spread = (float(each[0]) for each in _largest(*fitted, np.array([often])))
    low, high = _bootstrap(clusters.size, shape, steep, ratio, spread, duration / time)
    figures = (ratio, ratio + _EULER * spread, low, high)
    return TailFit(
        Extreme(duration, *(mean + threshold * each for each in figures)),
        mean,
        mean + threshold,
        scale=threshold / steep ** (1.0 / shape),
        shape=shape,
        clusters=tuple(float(each) + mean for each in clusters),
        peaks=heights.size,
        time=time,
    )


def gumbel(maxima: Sequence[float], run: float, duration: float) -> GumbelFit | None:
    """Fit Gumbel's distribution to the maxima of runs, by moments, and carry it to a duration.

    scale = s sqrt(6)/pi and mode = mean - 0.5772 scale; the maximum of D/t runs is most probably
    scale ln(D/t) higher. The interval is a parametric bootstrap of (estimate - truth)/scale, whose
    distribution does not hang on what the truth is.

    Parameters
    ----------
    maxima : sequence of float
        Of runs of the same length that differ in their seed.
    run, duration : float
        What of each run counts, and of interest, s.

    Returns
    -------
    GumbelFit or None
        None for fewer than five maxima, or where all are alike.
    """
    values = np.asarray(maxima, dtype=float)
    if values.size < LEAST_RUNS or values.std() <= 1e-12 * abs(values.mean()):
        return None
    mode, scale = (float(each[0]) for each in _moments(values[None, :]))
    shift = math.log(duration / run)
    drawn = np.random.default_rng(_SEED).gumbel(size=(4 * _DRAWS, values.size))
    modes, scales = _moments(drawn)
    low, high = _between((modes + scales * shift - shift) / scales)
    probable = mode + scale * shift
    mean, interval = probable + _EULER * scale, (probable - high * scale, probable - low * scale)
    extreme = Extreme(duration, probable, mean, *interval)
    return GumbelFit(extreme, mode, scale, values.size, run)


def block_maxima(time: Array, values: Array, block: float) -> Array:
    """Largest value in each of the equal blocks, about so long, s, that a series is cut into.

    `time`, `values` (n,): rising times, s, and values or turning points there. Blocks of which none
    is known are left out.
    """
    whole = float(time[-1] - time[0])
    count = max(1, round(whole / block))
    which = np.minimum(((time - time[0]) / whole * count).astype(np.int64), count - 1)
    found = np.full(count, -np.inf)
    np.maximum.at(found, which, values)
    return np.asarray(found[np.isfinite(found)])


def _clusters(heights: Array, threshold: float) -> Array:
    """Largest of each group of peaks that follow each other above a threshold."""
    above = np.concatenate([[False], heights > threshold, [False]])
    starts = np.flatnonzero(above[1:] & ~above[:-1])
    ends = np.flatnonzero(~above[1:] & above[:-1])
    return np.array([heights[a:b].max() for a, b in zip(starts, ends, strict=True)], dtype=float)


def _fit(logs: Array, counts: Codes) -> tuple[Array, Array]:
    """Find the most likely tails, one a row: shape b and steepness A.

    P(X > x) = exp(-A ((x/threshold)^b - 1)): for a shape given, 1/A is the mean of the brackets;
    the shape is where the likelihood is highest, by a parabola between three of `_SHAPES`.

    `logs` (rows, most): ln(x/threshold), padded by zeros, which add nothing; `counts` (rows,): how
    many of a row are there.
    """
    mean_log = logs.sum(axis=1) / counts
    power, factor = np.exp(_SHAPES[0] * logs), np.exp(_STEP * logs)
    sums = []
    for _ in _SHAPES:
        sums.append((power.sum(axis=1) - logs.shape[1]) / counts)
        power *= factor
    inverse = np.log(np.stack(sums, axis=1))
    likelihood = np.log(_SHAPES) - inverse + (_SHAPES - 1.0) * mean_log[:, None]
    at = np.clip(likelihood.argmax(axis=1), 1, _SHAPES.size - 2)
    rows = np.arange(at.size)
    first, second, third = (likelihood[rows, at + k] for k in (-1, 0, 1))
    off = np.clip(0.5 * (first - third) / (first - 2.0 * second + third), -1.0, 1.0)
    shape = _SHAPES[at] + _STEP * off
    first, second, third = (inverse[rows, at + k] for k in (-1, 0, 1))
    bent = second + 0.5 * off * (third - first) + 0.5 * off**2 * (third + first - 2.0 * second)
    return shape, np.exp(-bent)


def _largest(shape: Array, steep: Array, often: Array) -> tuple[Array, Array]:
    """Most probable largest of so many, and its Gumbel scale, over the threshold."""
    rise = 1.0 + np.maximum(np.log(often), 0.0) / steep
    ratio = rise ** (1.0 / shape)
    return ratio, ratio / (shape * steep * rise)


def _bootstrap(
    count: int, shape: float, steep: float, ratio: float, spread: float, over: float
) -> tuple[float, float]:
    """Interval of the most probable largest over the threshold, by samples drawn from the fit."""
    draw = np.random.default_rng(_SEED)
    counts = np.maximum(draw.poisson(count, _DRAWS), 3)
    there = np.arange(counts.max()) < counts[:, None]
    logs = np.log1p(draw.exponential(size=there.shape) / steep) / shape * there
    ratios, spreads = _largest(*_fit(logs, counts), counts * over)
    low, high = _between(np.log(ratios / ratio) * ratios / spreads)
    return ratio * math.exp(-high * spread / ratio), ratio * math.exp(-low * spread / ratio)


def _moments(values: Array) -> tuple[Array, Array]:
    """Mode and scale of Gumbel's distribution by moments, one a row."""
    scale = values.std(axis=1, ddof=1) * math.sqrt(6.0) / math.pi
    return values.mean(axis=1) - _EULER * scale, scale


def _between(drawn: Array) -> tuple[float, float]:
    low, high = np.quantile(drawn, [0.5 - 0.5 * CONFIDENCE, 0.5 + 0.5 * CONFIDENCE])
    return float(low), float(high)


FOLLOWED: Final = (
    "fairlead_tension",
    "anchor_tension",
    "grounded_length",
    "offset",
    "fairlead_x",
    "fairlead_y",
    "span",
    "anchor_horizontal",
    "uplift_force",
    "uplift_angle",
    "fairlead_vertical",
)
"""Quantities of each line: sizes of the forces at its ends, N; unstretched length on the bed, m;
horizontal way of its fairlead from rest, its place, and its horizontal distance from the lower end,
m; horizontal pull on its anchor and that upwards, N, and their angle, rad; pull down on its
fairlead, N."""

LEAST_TURN: Final = 1e-4
"""Of a quantity, over its largest size: turns by less are no turning points."""

STATE: Final = 14
"""Figures of `follow` for each quantity: 0 direction, 1 candidate for a turning point and 2 its
time, 3 largest size, 4 maximum, 5 its time, 6 minimum, 7 first value and 8 its time, 9 last value
and 10 its time, 11 and 12 integrals of the value less the first one and of its square, 13 whether
anything was followed."""


def follow(course: int, t: float, value: float, state: Any, turns: Any, count: Any) -> None:
    """Follow a quantity to its value at t, s.

    `state` (quantities, STATE), `turns` (quantities, room, 2): time and value of its turning
    points, of which `count` are there; a step adds one at most.
    """
    at = state[course]
    if at[13] == 0.0:
        at[1] = at[4] = at[6] = at[7] = at[9] = value
        at[2] = at[5] = at[8] = at[10] = t
        at[3], at[13] = abs(value), 1.0
        return
    h = t - at[10]
    old, new = at[9] - at[7], value - at[7]
    at[11] += 0.5 * h * (old + new)
    at[12] += 0.5 * h * (old * old + new * new)
    at[9], at[10] = value, t
    at[3] = max(at[3], abs(value))
    if value > at[4]:
        at[4], at[5] = value, t
    at[6] = min(at[6], value)
    least, way = LEAST_TURN * at[3], at[0]
    if way == 0.0:
        if abs(value - at[7]) > least:
            at[0] = 1.0 if value > at[7] else -1.0
            at[1], at[2] = value, t
    elif way * (value - at[1]) >= 0.0:
        at[1], at[2] = value, t
    elif way * (at[1] - value) > least:
        n = count[course]
        turns[course, n, 0], turns[course, n, 1] = at[2], at[1]
        count[course] = n + 1
        at[0], at[1], at[2] = -way, value, t


@dataclass(frozen=True, eq=False)
class Course:
    """One quantity over all steps from where statistics begin, in its own unit."""

    time: Array  # (n,): s, of the first value, the turning points and the last value
    value: Array  # (n,)
    mean: float  # over time
    std: float
    maximum: float
    minimum: float
    time_of_maximum: float  # s

    @property
    def duration(self) -> float:
        """From the first value to the last, s."""
        return float(self.time[-1] - self.time[0]) if self.time.size else 0.0

    def statistics(self) -> SeriesStatistics:
        """Say what it does; refused where nothing was followed."""
        if self.duration <= 0.0:
            allowed = Message("refused_motion.two_steps_or_more_are")
            raise refused("time", Message("refused_motion.nothing"), allowed, "statistics")
        return SeriesStatistics(
            mean=self.mean,
            std=self.std,
            maximum=self.maximum,
            minimum=self.minimum,
            time_of_maximum=self.time_of_maximum,
            duration=self.duration,
            peaks=peaks_above_mean(self.value, self.mean).size,
        )


def course_of(state: Array, turns: Array, count: int) -> Course:
    """Make a value of what `follow` kept of one quantity."""
    if state[13] == 0.0:
        none = np.empty(0)
        return Course(none, none, *[math.nan] * 5)
    time, value = turns[:count].T
    ends = [state[8:9], time], [state[7:8], value]
    if state[0] != 0.0 and state[2] < state[10]:
        ends[0].append(state[2:3])
        ends[1].append(state[1:2])
    if state[10] > state[8]:
        ends[0].append(state[10:11])
        ends[1].append(state[9:10])
    duration = max(float(state[10] - state[8]), 1e-300)
    mean = float(state[11]) / duration
    square = max(float(state[12]) / duration - mean * mean, 0.0)
    return Course(
        np.concatenate(ends[0]),
        np.concatenate(ends[1]),
        mean=float(state[7]) + mean,
        std=math.sqrt(square),
        maximum=float(state[4]),
        minimum=float(state[6]),
        time_of_maximum=float(state[5]),
    )


def taken_together(courses: list[Course]) -> float:
    """Mean over the time of all of them."""
    times = np.array([each.duration for each in courses])
    return float(np.average([each.mean for each in courses], weights=times))
