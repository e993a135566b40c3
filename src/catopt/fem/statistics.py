"""Statistics of a series in time: moments, spectrum, and the most probable maximum."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from catopt.model.validity import Findings

__all__ = [
    "SeriesStatistics",
    "gumbel_most_probable",
    "peaks_above_mean",
    "power_spectrum",
    "series_statistics",
    "weibull_most_probable",
]

Array = npt.NDArray[np.float64]

_EULER = 0.5772156649015329
_FEW_PEAKS = 20


@dataclass(frozen=True)
class SeriesStatistics:
    """What a series does.

    Attributes
    ----------
    mean, std, maximum, minimum : float
        In the series' unit.
    time_of_maximum : float
        s.
    duration : float
        s.
    peaks : int
        Maxima between one upward crossing of the mean and the next.
    most_probable_maximum : float or None
        Of a run of this length, by Weibull's distribution fitted to the peaks; None for fewer than
        20 of them.
    """

    mean: float
    std: float
    maximum: float
    minimum: float
    time_of_maximum: float
    duration: float
    peaks: int
    most_probable_maximum: float | None


def series_statistics(time: Array, values: Array) -> SeriesStatistics:
    """Statistics of one series.

    Parameters
    ----------
    time, values : ndarray, shape (n,)
        Evenly spaced, s, and the series; two or more.
    """
    if time.size < 2:
        found = Findings("series_statistics")
        found.add("time", f"{time.size} samples", "two or more are wanted: is `since` too late?")
        found.raise_if_any()
    peaks = peaks_above_mean(values)
    probable = None
    if peaks.size >= _FEW_PEAKS:
        probable = weibull_most_probable(peaks, float(values.mean()))
    return SeriesStatistics(
        mean=float(values.mean()),
        std=float(values.std()),
        maximum=float(values.max()),
        minimum=float(values.min()),
        time_of_maximum=float(time[values.argmax()]),
        duration=float(time[-1] - time[0]),
        peaks=peaks.size,
        most_probable_maximum=probable,
    )


def peaks_above_mean(values: Array) -> Array:
    """Largest value between each upward crossing of the mean and the next.

    Parameters
    ----------
    values : ndarray, shape (n,)
        The series.
    """
    above = values > values.mean()
    ups = np.flatnonzero(above[1:] & ~above[:-1]) + 1
    if ups.size < 2:
        return np.empty(0)
    peaks: Array = np.maximum.reduceat(values[: ups[-1]], ups[:-1])
    return peaks


def weibull_most_probable(peaks: Array, mean: float, count: int | None = None) -> float:
    """Most probable largest of a number of peaks, by Weibull's distribution of their height.

    P(peak - mean > x) = exp(-(x/a)^b); a and b from the mean and the standard deviation of the
    peaks; the largest of n is most probably near mean + a (ln n)^(1/b), where one in n is higher.
    Narrow-banded linear response has b = 2 (Rayleigh); snatching lines have less.

    Parameters
    ----------
    peaks : ndarray, shape (n,)
        As of `peaks_above_mean`.
    mean : float
        Of the series.
    count : int, optional
        Peaks in the time asked about; as many as given by default.
    """
    heights = peaks - mean
    m, s = float(heights.mean()), float(heights.std())
    number = peaks.size if count is None else count
    if s <= 1e-9 * m:
        return mean + m
    shape = _weibull_shape(s / m)
    scale = m / math.gamma(1.0 + 1.0 / shape)
    return float(mean + scale * math.log(number) ** (1.0 / shape))


def gumbel_most_probable(maxima: Sequence[float]) -> float:
    """Most probable maximum from the maxima of several runs: the mode of Gumbel's distribution.

    By moments: mode = mean - 0.5772 s sqrt(6)/pi.

    Parameters
    ----------
    maxima : sequence of float
        Of runs that differ in their seed; two or more.
    """
    values = np.asarray(maxima, dtype=float)
    if values.size < 2:
        found = Findings("gumbel_most_probable")
        found.add("maxima", str(values.size), "the maxima of two runs or more are wanted")
        found.raise_if_any()
    return float(values.mean() - _EULER * values.std(ddof=1) * math.sqrt(6.0) / math.pi)


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


def _weibull_shape(variation: float) -> float:
    """Shape b whose standard deviation over mean is given, between 0.2 and 50."""
    low, high = math.log(0.2), math.log(50.0)
    for _ in range(60):
        middle = 0.5 * (low + high)
        b = math.exp(middle)
        first, second = math.gamma(1.0 + 1.0 / b), math.gamma(1.0 + 2.0 / b)
        if math.sqrt(max(second / first**2 - 1.0, 0.0)) > variation:
            low = middle
        else:
            high = middle
    return math.exp(0.5 * (low + high))
