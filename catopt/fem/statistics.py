"""Statistics of a series in time: moments, peaks and spectrum."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from catopt.arrays import Array
from catopt.model.validity import Findings
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
        found = Findings("series_statistics")
        found.add("time", f"{time.size} samples", Message("refused_motion.two_or_more_are_wanted"))
        found.raise_if_any()
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
    peaks: Array = np.maximum.reduceat(values[: ups[-1]], ups[:-1])
    return peaks


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
