"""One run of a line in motion, as a value, and statistics over several runs."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType

import numpy as np

from catopt.arrays import Array, Flags
from catopt.checks.fatigue import Cycles
from catopt.fem.extremes import (
    GumbelFit,
    SeriesStatistics,
    TailFit,
    power_spectrum,
    series_statistics,
)
from catopt.fem.history import History
from catopt.floater.alone import HullHistory
from catopt.model import Case
from catopt.model.network import Network
from catopt.verify.convergence_check import (
    Again,
    ConvergenceCheck,
    Damped,
)

SERIES: Mapping[str, Callable[[History], Array]] = MappingProxyType(
    {
        "fairlead_tension": lambda history: history.fairlead_tension[:, 0],
        "anchor_tension": lambda history: history.anchor_tension[:, 0],
        "grounded_length": lambda history: history.grounded_length[:, 0],
        "offset": lambda history: history.offset[:, 0],
    }
)
"""What statistics are made of; offset is the fairlead's horizontal way from its place at rest."""


TRACK: Mapping[str, Callable[[Array], Array]] = MappingProxyType(
    {
        "body_x": lambda track: track[:, 0],
        "body_y": lambda track: track[:, 1],
        "body_offset": lambda track: np.hypot(*(track - track[0])[:, :2].T),
    }
)
"""Statistics of a body; offset is the horizontal way of its origin from its place at rest."""


_OF_FAIRLEAD = MappingProxyType(
    {"body_x": "fairlead_x", "body_y": "fairlead_y", "body_offset": "offset"}
)
"""What of a fairlead moves as a body does that does not turn."""


HULL: Mapping[str, tuple[Callable[[HullHistory], Array], int]] = MappingProxyType(
    {
        "floater_x": (lambda hull: hull.place[:, 0] - hull.place[0, 0], 0),
        "floater_y": (lambda hull: hull.place[:, 1] - hull.place[0, 1], 1),
        "floater_z": (lambda hull: hull.place[:, 2], 2),
        "floater_roll": (lambda hull: hull.place[:, 3], 3),
        "floater_pitch": (lambda hull: hull.place[:, 4], 4),
        "floater_yaw": (lambda hull: hull.place[:, 5], 5),
        "floater_wet": (lambda hull: hull.wet / hull.volume, 6),
    }
)
"""Statistics of a floating buoy, with the row of its extremes at every step."""


_WAYS = ("floater_x", "floater_y")
"""Counted from where the buoy is at rest."""
_UNITS = MappingProxyType(
    dict.fromkeys(("grounded_length", "offset", *TRACK, *_WAYS, "floater_z"), "m")
    | dict.fromkeys(("floater_roll", "floater_pitch", "floater_yaw"), "rad")
    | {"floater_wet": ""}
)


@dataclass(frozen=True)
class OverRuns:
    """Statistics of one quantity over all runs of a load case, SI.

    `quantity`: a key of `SERIES`, or of where a body is; `mean` to `minimum`: of all runs together;
    `tail`: of the peaks of all runs, with the most probable maximum in the duration of interest;
    None where the quantity is not random, or for too few peaks; `gumbel`: the same by the maxima of
    the runs; None for fewer than five.
    """

    quantity: str
    mean: float
    std: float
    maximum: float
    minimum: float
    tail: TailFit | None = None
    gumbel: GumbelFit | None = None

    @property
    def unit(self) -> str:
        """SI unit."""
        return _UNITS.get(self.quantity, "N")

    @property
    def most_probable_maximum(self) -> float | None:
        """In the duration of interest, by the tail; None without one."""
        return None if self.tail is None else self.tail.extreme.most_probable


@dataclass(frozen=True, eq=False)
class DynamicRun:
    """One run of one line.

    `history`: what it did; `quasi_static` (samples,): tension at the fairlead in closed form for
    each of its places, without current, N; nan where the closed form has none; `number`: from 0;
    with the case's seed it gives the sea; `again`: the same run again, at half the step and then
    with twice the bars, too; empty when it was run once; `damped`: with other dampings, where a
    line snaps; `track`: place of the origin of the body that the line moors with others, shape
    (samples, 3), m; `cycles`: of each bar's tension, from the anchor; empty unless they were asked
    for; `hull`: how the buoy moved that floats at its end.
    """

    history: History
    quasi_static: Array
    number: int = 0
    again: tuple[Again, ...] = ()
    damped: tuple[Damped, ...] = ()
    track: Array | None = None
    cycles: tuple[Cycles, ...] = ()
    hull: HullHistory | None = None

    def is_complete(self, convergence_check: ConvergenceCheck) -> bool:
        """Whether neither it nor its check was stopped."""
        return self.history.is_complete and (convergence_check == "none" or bool(self.again))

    @cached_property
    def counted(self) -> Flags:
        """Which samples count: those after the ramp; all, if hardly any are."""
        counted = self.history.counted
        return counted if self.history.counts else np.ones(counted.size, dtype=bool)

    def statistics(self, quantity: str) -> SeriesStatistics:
        """Statistics of one of `SERIES`, of every step; of the samples where hardly any counts."""
        if self.history.counts:
            return self.history.course(quantity).statistics()
        values = SERIES[quantity](self.history)[self.counted]
        return series_statistics(self.history.time[self.counted], values)

    @cached_property
    def maxima(self) -> dict[str, float]:
        """Largest value of each of `SERIES`, and the largest tension anywhere along the line."""
        maxima = {quantity: self.statistics(quantity).maximum for quantity in SERIES}
        along = float(np.fmax.reduce(self.history.max_tension, initial=0.0))
        ends = (maxima["fairlead_tension"], maxima["anchor_tension"])
        return {**maxima, "largest_tension": max(along, *ends)}

    def cycle_peaks(self, quantity: str, period: float) -> Array:
        """Largest value in each whole period of the motion."""
        course = self.history.course(quantity)
        edges = course.time[0] + period * np.arange(1.0 + course.duration / period * (1.0 + 1e-9))
        at_edges = np.interp(edges, course.time, course.value)
        inside = np.searchsorted(course.time, edges)
        pieces = itertools.pairwise(zip(at_edges, inside, strict=True))
        return np.array(
            [max(old, new, course.value[a:b].max(initial=-np.inf)) for (old, a), (new, b) in pieces]
        )

    def tension_spectrum(self) -> tuple[Array, Array]:
        """Spectrum of the tension at the fairlead: rad/s, and N^2 s/rad."""
        counted, history = self.counted, self.history
        return power_spectrum(history.time[counted], history.fairlead_tension[counted, 0])

    @property
    def quasi_static_max(self) -> float | None:
        """Largest quasi-static tension, N; None where the closed form has none at all."""
        values = self.quasi_static[self.counted]
        known = values[np.isfinite(values)]
        return float(known.max()) if known.size else None


def over_runs(
    quantity: str,
    each: Sequence[SeriesStatistics],
    tail: TailFit | None = None,
    gumbel: GumbelFit | None = None,
) -> OverRuns:
    """Put the statistics of several runs together."""
    means = np.array([one.mean for one in each])
    std = math.sqrt(float(np.mean([one.std**2 for one in each]) + means.var()))
    ends = max(one.maximum for one in each), min(one.minimum for one in each)
    return OverRuns(quantity, float(means.mean()), std, *ends, tail, gumbel)


def of_track(
    quantity: str, run: DynamicRun, track: Array, case: Case | Network
) -> SeriesStatistics:
    """Say where a body was: a free one at every step, one that is led at the samples."""
    history, values = run.history, TRACK[quantity](track)
    if case.body is None or not history.counts:
        return series_statistics(history.time[run.counted], values[run.counted])
    found = history.course(_OF_FAIRLEAD[quantity]).statistics()
    if quantity == "body_offset":
        return found
    away = float((track[0] - history.fairlead[0, 0])[("body_x", "body_y").index(quantity)])
    moved = {key: getattr(found, key) + away for key in ("mean", "maximum", "minimum")}
    return replace(found, **moved)


def quantities_of_hull(hull: HullHistory) -> tuple[str, ...]:
    """Which of `HULL` a buoy has: those in which it is free, and how far it is under."""
    return tuple(key for key, (_, row) in HULL.items() if row == 6 or hull.free[row])


def of_hull(quantity: str, run: DynamicRun, hull: HullHistory) -> SeriesStatistics:
    """Say how a floating buoy moved: mean and deviation by the samples, the ends of every step."""
    series, row = HULL[quantity]
    values = series(hull)
    found = series_statistics(run.history.time[run.counted], values[run.counted])
    least, most = hull.extreme[row]
    if not run.history.counts or not math.isfinite(least):
        return found
    if quantity == "floater_wet":
        least, most = least / hull.volume, most / hull.volume
    elif quantity in _WAYS:
        at_rest = hull.place[0, row]
        least, most = least - at_rest, most - at_rest
    return replace(found, minimum=float(least), maximum=float(most))
