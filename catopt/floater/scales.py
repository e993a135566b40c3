"""A quantity in motion on two time scales: its slow part, and what the waves add."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from catopt.arrays import Array
from catopt.records import Record


@dataclass(frozen=True)
class Scales(Record):
    """Parts of a quantity: of slow motion, and what the waves add.

    Deviations are standard ones. The largest of each part, beside the mean, is that of the runs, or
    what is most probable in the storm of a normal process, if that is more.
    """

    DOCUMENT = "mean slow_deviation slow_largest fast_deviation fast_largest seen combined"

    mean: float
    """In the unit of the quantity, as all others."""
    slow_deviation: float
    """Of slow motion."""
    slow_largest: float
    """Largest slow part beside the mean: of the runs, or most probable in the storm."""
    fast_deviation: float
    """Of what the waves add."""
    fast_largest: float
    """Largest of what the waves add, likewise."""
    seen: float
    """Largest of the sum in the runs."""

    @property
    def combined(self) -> float:
        """Largest by API RP 2SK's rule.

        Mean and the larger of: largest slow part with the significant part of the waves; largest
        part of the waves with the significant slow one. Significant are two standard deviations.
        """
        first = self.slow_largest + 2.0 * self.fast_deviation
        second = self.fast_largest + 2.0 * self.slow_deviation
        return self.mean + max(first, second)

    @property
    def judged(self) -> float:
        """By which it is judged: the combined largest, or what a run reached if that is more."""
        return max(self.combined, self.seen)


def scales_of(slow: Sequence[Array], whole: Sequence[Array], time: Array, storm: float) -> Scales:
    """Take a quantity of several runs apart: its slow part, and what the waves add.

    `storm`, s: for what is most probable of a normal process.
    """
    mean = float(np.mean(slow))
    fast = [b - a for a, b in zip(slow, whole, strict=True)]
    slow_dev, fast_dev = float(np.std(slow)), float(np.std(fast))
    slow_most = max(_rayleigh(each - mean, time, storm, slow_dev) for each in slow)
    fast_most = max(_rayleigh(each, time, storm, fast_dev) for each in fast)
    slow_seen = float(np.mean([each.max() for each in slow])) - mean
    fast_seen = float(np.mean([each.max() for each in fast]))
    return Scales(
        mean,
        slow_dev,
        max(slow_seen, slow_most),
        fast_dev,
        max(fast_seen, fast_most),
        float(max(each.max() for each in whole)),
    )


def _rayleigh(series: Array, time: Array, storm: float, deviation: float) -> float:
    """Most probable largest of a normal process with so many cycles."""
    crossings = int(((series[:-1] < 0.0) & (series[1:] >= 0.0)).sum())
    cycles = max(crossings, 1) * storm / float(time[-1] - time[0])
    return deviation * math.sqrt(2.0 * math.log(max(cycles, math.e)))
