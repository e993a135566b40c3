"""A line in motion, as values: statistics over its runs, and what it does beyond quasi-statics."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType
from typing import Any, Literal, NamedTuple

import numpy as np

from catopt.arrays import Array, Flags
from catopt.checks.fatigue import Cycles
from catopt.fem.extremes import GumbelFit, TailFit, weibull_tail
from catopt.fem.extremes import gumbel as gumbel_of
from catopt.fem.history import History
from catopt.fem.statistics import SeriesStatistics, power_spectrum, series_statistics
from catopt.model import Case
from catopt.model.dynamics import InitialFriction
from catopt.shown import Shown
from catopt.ties import largest
from catopt.verify.dynamic_setup import Drive
from catopt.verify.proof import LEAST_TENSION, LIMIT, Again, Change, Proof, added, largest_changes
from catopt.words import Message

SERIES: Mapping[str, Callable[[History], Array]] = MappingProxyType(
    {
        "fairlead_tension": lambda history: history.fairlead_tension[:, 0],
        "anchor_tension": lambda history: history.anchor_tension[:, 0],
        "grounded_length": lambda history: history.grounded_length[:, 0],
        "offset": lambda history: history.offset[:, 0],
    }
)
"""What statistics are made of; offset is the fairlead's horizontal way from its place at rest."""

_ENDS = MappingProxyType({"anchor_tension": 0, "fairlead_tension": 1})
"""Column of each tension at an end in the largest forces of every step."""

Verdict = Literal["converged", "not converged", "not proven"]
_VERDICTS: tuple[Verdict, ...] = ("not converged", "not proven", "converged")


def worst_verdict(verdicts: Iterable[Verdict]) -> Verdict:
    """Return the one that outweighs the others."""
    return min(verdicts, key=_VERDICTS.index, default="converged")


_TRACK: Mapping[str, Callable[[Array], Array]] = MappingProxyType(
    {
        "body_x": lambda track: track[:, 0],
        "body_y": lambda track: track[:, 1],
        "body_offset": lambda track: np.hypot(*(track - track[0])[:, :2].T),
    }
)
"""Statistics of a body; offset is the horizontal way of its origin from its place at rest."""

_UNITS = MappingProxyType(dict.fromkeys(("grounded_length", "offset", *_TRACK), "m"))


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
    with twice the bars, too; empty when it was run once; `track`: place of the origin of the body
    that the line moors with others, shape (samples, 3), m; `cycles`: of each bar's tension, from
    the anchor; empty unless they were asked for.
    """

    history: History
    quasi_static: Array
    number: int = 0
    again: tuple[Again, ...] = ()
    track: Array | None = None
    cycles: tuple[Cycles, ...] = ()

    def is_complete(self, proof: Proof) -> bool:
        """Whether neither it nor its proof was stopped."""
        return self.history.is_complete and (proof == "none" or bool(self.again))

    @cached_property
    def counted(self) -> Flags:
        """Which samples count: those after the ramp; all, if hardly any are."""
        counted = self.history.counted
        return counted if counted.sum() > 1 else np.ones(counted.size, dtype=bool)

    def statistics(self, quantity: str) -> SeriesStatistics:
        """Statistics of one of `SERIES`; the largest tension at an end is that of every step."""
        history = self.history
        found = series_statistics(
            history.time[self.counted], SERIES[quantity](history)[self.counted]
        )
        at = _ENDS.get(quantity)
        if at is None or history.max_end_force[0, at] <= found.maximum:
            return found
        return replace(
            found,
            maximum=float(history.max_end_force[0, at]),
            time_of_maximum=float(history.time_of_max_end_force[0, at]),
        )

    @cached_property
    def maxima(self) -> dict[str, float]:
        """Largest value of each of `SERIES`, and the largest tension anywhere along the line."""
        maxima = {quantity: self.statistics(quantity).maximum for quantity in SERIES}
        along = float(np.fmax.reduce(self.history.max_tension, initial=0.0))
        ends = (maxima["fairlead_tension"], maxima["anchor_tension"])
        return {**maxima, "largest_tension": max(along, *ends)}

    def changes(self, line_length: float) -> Iterator[Change]:
        """Yield how far each maximum moved from one run to the next that has an answer."""
        before: Mapping[str, float] = self.maxima
        for again in self.again:
            for quantity, value in again.maxima.items():
                over = value or before[quantity]
                if quantity.endswith("tension"):
                    over = max(over, LEAST_TENSION * again.maxima["largest_tension"])
                elif quantity == "grounded_length":
                    over = line_length
                if over > 0.0:
                    yield Change(quantity, again.way, abs(value - before[quantity]) / over)
            before = again.maxima or before

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


def _over_runs(
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


class Envelope(NamedTuple):
    """What the bars of a line see over all runs.

    `arc` (bars,): unstretched arc length of each, m; `largest`, `smallest` (bars,): tensions, N;
    `slack`, `longest_slack` (bars,): time without tension of a run in all, and at a stretch, s.
    """

    arc: Array
    largest: Array
    smallest: Array
    slack: Array
    longest_slack: Array


@dataclass(frozen=True)
class DynamicPart:
    """A line in motion under one load.

    `name`: of the load case; `drive`: what drove it; `runs`: one a seed; `line_length`:
    unstretched, m; `proof`: how the runs were to be proven; `remarks`: what to know before the
    figures are used; `line`: of a body with several lines, which one, from 1; `anchor_at_rest`:
    tension at the anchor at rest, N, by the initial friction; empty where nothing rubs.
    """

    name: str
    drive: Drive
    runs: tuple[DynamicRun, ...]
    line_length: float
    proof: Proof
    remarks: tuple[str, ...] = ()
    line: int | None = None
    anchor_at_rest: Mapping[InitialFriction, float] = field(default_factory=dict)

    @property
    def is_complete(self) -> bool:
        """Whether no run was stopped, nor its proof."""
        return all(run.is_complete(self.proof) for run in self.runs)

    @property
    def where(self) -> str:
        """What it is of, for sentences: a load case, or a line of a body."""
        if self.line is None:
            return Message("motion.of_load_case", name=self.name)
        return Message("motion.of_line", number=self.line)

    @cached_property
    def changes(self) -> tuple[Change, ...]:
        """Largest change of each maximum in any run, by the way in which it was run again."""
        found = (each for run in self.runs for each in run.changes(self.line_length))
        return tuple(largest_changes(found))

    @cached_property
    def added_changes(self) -> tuple[Change, ...]:
        """Largest change of each maximum in any run, by all ways in which it was run again."""
        found = (each for run in self.runs for each in added(run.changes(self.line_length)))
        return tuple(largest_changes(found))

    @property
    def worst_change(self) -> Change | None:
        """The largest of them; None where nothing was run again."""
        return max(self.added_changes, key=lambda each: each.size, default=None)

    def change_of(self, quantity: str) -> float | None:
        """Largest change of the maximum of a quantity, all ways added; None where run once."""
        found = (each.size for each in self.added_changes if each.quantity == quantity)
        return max(found, default=None)

    @property
    def failure(self) -> Again | None:
        """A run again that did not converge itself."""
        return next((a for run in self.runs for a in run.again if a.failure), None)

    @property
    def numerical_part(self) -> float:
        """Largest part of the work put into a run that its steps lost."""
        return max(run.history.balance.numerical_part for run in self.runs)

    @cached_property
    def envelope(self) -> Envelope:
        """Largest and smallest tension of each bar over all runs, and how long it was slack."""
        of = [run.history for run in self.runs]
        return Envelope(
            of[0].arc,
            np.fmax.reduce([each.max_tension for each in of]),
            np.fmin.reduce([each.min_tension for each in of]),
            np.max([each.slack_time for each in of], axis=0),
            np.max([each.longest_slack for each in of], axis=0),
        )

    @property
    def verdict(self) -> Verdict:
        """Whether the maxima hang on the step or the bars by no more than `LIMIT`."""
        worst = self.worst_change
        if self.failure is not None or self.numerical_part > LIMIT:
            return "not converged"
        if worst is not None and worst.size > LIMIT:
            return "not converged"
        return "converged" if worst is not None and self.is_complete else "not proven"

    @cached_property
    def quantities(self) -> tuple[OverRuns, ...]:
        """Statistics of every one of `SERIES`."""
        found = []
        for quantity in SERIES:
            each = [run.statistics(quantity) for run in self.runs]
            tail, gumbel = self._tail(quantity, each), self._gumbel(quantity, each)
            found.append(_over_runs(quantity, each, tail, gumbel))
        return tuple(found)

    def of(self, quantity: str) -> OverRuns:
        """Look a quantity up."""
        return next(each for each in self.quantities if each.quantity == quantity)

    @property
    def max_tension(self) -> float:
        """Largest tension, at an end or anywhere along the line, N."""
        return max(run.maxima["largest_tension"] for run in self.runs)

    @property
    def slack_time(self) -> float:
        """Time in all that a bar of the line had no tension in one run, after the ramp, s."""
        return max(run.history.line_slack_time() for run in self.runs)

    @property
    def longest_slack(self) -> float:
        """Longest time at a stretch that a bar of the line had no tension, after the ramp, s."""
        return max(run.history.line_longest_slack() for run in self.runs)

    @property
    def quasi_static_max(self) -> float | None:
        """Largest tension at the fairlead, had the line moved infinitely slowly, N."""
        known = [run.quasi_static_max for run in self.runs]
        found = [value for value in known if value is not None]
        return max(found) if len(found) == len(known) else None

    @property
    def amplification(self) -> float | None:
        """Largest tension at the fairlead over the largest quasi-static one."""
        still = self.quasi_static_max
        return None if still is None else self.of("fairlead_tension").maximum / still

    @property
    def governing(self) -> DynamicRun:
        """The run with the largest tension at the fairlead."""
        return largest(self.runs, lambda run: run.statistics("fairlead_tension").maximum)

    def varies_at_random(self, quantity: str) -> bool:
        """Whether a quantity has extremes: not the grounded length, which ends with the line."""
        if quantity == "grounded_length":
            return False
        return self.drive.is_led_at_random if quantity == "offset" else self.drive.is_random

    @property
    def elements(self) -> int:
        """Bars of a line."""
        return self.drive.dynamics.bars

    @property
    def duration_of_interest(self) -> float:
        """Of the storm for which extremes are given, s."""
        return self.drive.dynamics.duration_of_interest

    def _tail(self, quantity: str, each: list[SeriesStatistics]) -> TailFit | None:
        if not self.varies_at_random(quantity):
            return None
        series = [SERIES[quantity](run.history)[run.counted] for run in self.runs]
        time = sum(one.duration for one in each)
        return weibull_tail(series, time, self.duration_of_interest)

    def _gumbel(self, quantity: str, each: list[SeriesStatistics]) -> GumbelFit | None:
        whole = [one for one, run in zip(each, self.runs, strict=True) if run.history.is_complete]
        if not whole or not self.varies_at_random(quantity):
            return None
        maxima = [one.maximum for one in whole]
        return gumbel_of(maxima, whole[0].duration, self.duration_of_interest)


@dataclass(frozen=True, repr=False)
class DynamicVerification(Shown):
    """A case in motion.

    `case`: what was run; `parts`: one a load case; of a body with several lines, one a line;
    `is_complete`: False when it was stopped (Ctrl-C): the last run is short, and others may be
    missing.
    """

    case: Case
    parts: tuple[DynamicPart, ...]
    is_complete: bool

    @property
    def verdict(self) -> Verdict:
        """That of the load cases together."""
        return worst_verdict(part.verdict for part in self.parts)

    @property
    def governing(self) -> DynamicPart:
        """The part with the largest tension at the fairlead; of those alike the first."""
        return largest(self.parts, lambda part: part.of("fairlead_tension").maximum)

    @property
    def least_proven(self) -> DynamicPart:
        """The part that says most against the answer: not converged, or changed most."""
        bad = [part for part in self.parts if part.verdict == "not converged"]
        return largest(bad or self.parts, lambda p: p.worst_change.size if p.worst_change else 0.0)

    @cached_property
    def body(self) -> tuple[OverRuns, ...]:
        """Where the origin of a moored body was, m; empty without one."""
        tracks = [(run, run.track) for run in self.parts[0].runs if run.track is not None]
        found = []
        for quantity, of in _TRACK.items() if tracks else ():
            each = [
                series_statistics(run.history.time[run.counted], of(track)[run.counted])
                for run, track in tracks
            ]
            found.append(_over_runs(quantity, each))
        return tuple(found)

    def to_dict(self) -> dict[str, Any]:
        """Build what ``catopt verify --dynamic --json`` has under ``dynamic``."""
        from catopt.verify.document import dynamic_document

        return dynamic_document(self)
