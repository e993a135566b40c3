"""One run of a line in motion, as a value, and statistics over several runs."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import Literal

import numpy as np

from catopt.arrays import Array, Flags
from catopt.checks.fatigue import Cycles
from catopt.fem.extremes import (
    Extreme,
    GumbelFit,
    SeriesStatistics,
    TailFit,
    power_spectrum,
    series_statistics,
)
from catopt.fem.history import History
from catopt.floater.alone import HullHistory
from catopt.model import Case
from catopt.model.kinds import Duration, NotNegative, SomeForce
from catopt.model.network import Network
from catopt.records import Record
from catopt.verify.convergence_check import Again, ConvergenceCheck, Damped

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

_WAYS = ("floater_x", "floater_y")
"""Counted from where the buoy is at rest."""
_IN_METRES = ("grounded_length", "offset", *TRACK, *_WAYS, "floater_z")
_IN_RADIANS = ("floater_roll", "floater_pitch", "floater_yaw")

HULL = (*_WAYS, "floater_z", *_IN_RADIANS, "floater_wet")
"""Statistics of a floating buoy, in the order of its freedoms and of its extremes."""


@dataclass(frozen=True)
class OverRuns(Record):
    """Statistics of one quantity over all runs of a load case, SI."""

    DOCUMENT = (
        "quantity unit mean std maximum=max minimum=min most_probable_maximum=most_probable_max "
        "tail gumbel"
    )

    quantity: str
    """A key of `SERIES` such as fairlead_tension, or of where a body is."""
    mean: float
    """In unit, of all runs together, as all others."""
    std: NotNegative
    """In unit: standard deviation."""
    maximum: float
    """In unit."""
    minimum: float
    """In unit."""
    tail: TailFit | None = None
    """Weibull's distribution of the highest peaks of all runs; None where the quantity is not
    random, or for too few peaks."""
    gumbel: GumbelFit | None = None
    """Gumbel's distribution of the maxima of the runs; None for fewer than five, or what is not
    random."""
    storm: Extreme | None = None
    """What checks are held against: that of the tail, of a line that goes slack by Gumbel's
    distribution of the maxima of equal blocks of the runs."""

    @cached_property
    def unit(self) -> Literal["N", "m", "rad", ""]:
        """SI, of the numbers below; empty for a part of a whole."""
        if self.quantity in _IN_METRES:
            return "m"
        if self.quantity in _IN_RADIANS:
            return "rad"
        return "" if self.quantity == "floater_wet" else "N"

    @property
    def most_probable_maximum(self) -> float | None:
        """In unit, in the duration of interest, as `storm` has it; None without a tail."""
        return None if self.storm is None else self.storm.most_probable


@dataclass(frozen=True, eq=False)
class DynamicRun(Record):
    """One run of one line."""

    DOCUMENT = (
        "number+1=run history.is_complete reached history.since history.step=time_step_s "
        "history.shortest_step history.steps history.iterations history.halvings "
        "max_fairlead_tension time_of_max slack_time longest_slack history.refinements "
        "history.balance=energy(put_in=put_in_J ends=ends_J water=water_J kinetic=kinetic_J "
        "elastic=elastic_J potential=potential_J drag=drag_J bed=bed_J friction=friction_J "
        "damping=line_damping_J numerical=numerical_J) again"
    )

    history: History
    """What it did."""
    quasi_static: Array
    """Tension at the fairlead in closed form for each of its places, without current, (samples,),
    N; nan where the closed form has none."""
    number: int = 0
    """Number; with the case's seed it gives the sea."""
    again: tuple[Again, ...] = ()
    """The same run again, at half the step and then with twice the bars, too; empty when it was run
    once."""
    damped: tuple[Damped, ...] = ()
    """With other dampings, where a line snaps."""
    track: Array | None = None
    """Place of the origin of the body that the line moors with others, shape (samples, 3), m."""
    cycles: tuple[Cycles, ...] = ()
    """Of each bar's tension, from the anchor; empty unless they were asked for."""
    hull: HullHistory | None = None
    """How the buoy moved that floats at its end."""

    @property
    def reached(self) -> Duration:
        """Where it ended, s."""
        return float(self.history.time[-1])

    @property
    def max_fairlead_tension(self) -> SomeForce:
        """Largest tension at the fairlead, N."""
        return self.statistics("fairlead_tension").maximum

    @property
    def time_of_max(self) -> Duration:
        """When that was, s."""
        return self.statistics("fairlead_tension").time_of_maximum

    @property
    def slack_time(self) -> Duration:
        """That a bar of the line had no tension, in all, s."""
        return self.history.line_slack_time()

    @property
    def longest_slack(self) -> Duration:
        """The same at a stretch, s."""
        return self.history.line_longest_slack()

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
    storm: Extreme | None = None,
) -> OverRuns:
    """Put the statistics of several runs together."""
    means = np.array([one.mean for one in each])
    std = math.sqrt(float(np.mean([one.std**2 for one in each]) + means.var()))
    ends = max(one.maximum for one in each), min(one.minimum for one in each)
    return OverRuns(quantity, float(means.mean()), std, *ends, tail, gumbel, storm)


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
    """Which of `HULL` it has: those in which it is free, and how far it is under, if known."""
    return tuple(
        key
        for row, key in enumerate(HULL)
        if (hull.volume > 0.0 if key == "floater_wet" else hull.free[row])
    )


def of_hull(quantity: str, run: DynamicRun, hull: HullHistory) -> SeriesStatistics:
    """Say how a floating buoy moved: mean and deviation by the samples, the ends of every step."""
    row = HULL.index(quantity)
    if quantity == "floater_wet":
        values, (least, most) = hull.wet / hull.volume, hull.extreme[row] / hull.volume
    else:
        at_rest = hull.place[0, row] if quantity in _WAYS else 0.0
        values, (least, most) = hull.place[:, row] - at_rest, hull.extreme[row] - at_rest
    found = series_statistics(run.history.time[run.counted], values[run.counted])
    if not run.history.counts or not math.isfinite(least):
        return found
    return replace(found, minimum=float(least), maximum=float(most))
