"""A line in motion, as values: statistics over its runs, and what it does beyond quasi-statics."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, Literal, NamedTuple, TypedDict

import numpy as np

from catopt.arrays import Array
from catopt.checks.result import ChecksInMotion
from catopt.display import Displayable
from catopt.fem.extremes import (
    Extreme,
    GumbelFit,
    SeriesStatistics,
    TailFit,
    taken_together,
    weibull_tail,
)
from catopt.fem.extremes import gumbel as gumbel_of
from catopt.largest import largest
from catopt.model import Case, Line
from catopt.model.dynamics import InitialFriction
from catopt.model.kinds import Duration, Height, NotNegative, SomeForce
from catopt.model.network import Network
from catopt.old_names import OldName
from catopt.records import Counted, From, Record
from catopt.verify.convergence_check import (
    LEAST_CYCLES,
    LEAST_TENSION,
    LIMIT,
    Again,
    Change,
    ConvergenceCheck,
    Way,
    added,
    largest_changes,
)
from catopt.verify.dynamic_run import (
    SERIES,
    TRACK,
    DynamicRun,
    OverRuns,
    of_hull,
    of_track,
    over_runs,
    quantities_of_hull,
)
from catopt.verify.dynamic_setup import Excitation
from catopt.verify.snap_rerun import BLOCK, LEAST_BLOCKS, paired_changes, storm_of_blocks
from catopt.words import Message

Verdict = Literal["converged", "not converged", "not proven"]
_VERDICTS: tuple[Verdict, ...] = ("not converged", "not proven", "converged")


def worst_verdict(verdicts: Iterable[Verdict]) -> Verdict:
    """Return the one that outweighs the others."""
    return min(verdicts, key=_VERDICTS.index, default="converged")


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


class BeyondMBL(NamedTuple):
    """A segment that carries more than its MBL in motion."""

    segment: int
    """Which, from 1 at the anchor."""
    tension: float
    """Largest, N."""
    MBL: float

    @property
    def times(self) -> float:
        """How many times its MBL that is."""
        return self.tension / self.MBL


class Between(NamedTuple):
    """A line between points."""

    name: str
    """Of the line, of points joined by lines."""
    start: str
    """Point at which a line between points begins; its forces are the anchor's."""
    end: str
    """And at which it ends; its forces are the fairlead's."""
    is_anchored: bool
    """Whether the first is an anchor."""


class AnchorAtRest(TypedDict):
    """Tension at the anchor at rest by the past of the bed."""

    pulled_N: SomeForce
    """N: the line was last pulled towards the fairlead; one bound of any past."""
    none_N: SomeForce
    """N: without friction."""
    laid_N: SomeForce
    """N: it was laid under more tension; the other bound."""


@dataclass(frozen=True)
class DynamicPart(Record):
    """A line in motion under one load."""

    DOCUMENT = (
        "name=load_case line is_complete elements between.name? between.start=from? "
        "between.end=to? quantities max_tension quasi_static_max=quasi_static_max_tension_N "
        "dynamic_amplification=amplification slack_time longest_slack verdict "
        "convergence_check=proof changes tension_at_rest=anchor_at_rest numerical_part runs remarks"
    )

    name: str
    """Its name; load where the case has only that."""
    drive: Excitation
    """What drove it."""
    runs: Annotated[tuple[DynamicRun, ...], From(1)]
    """One a seed."""
    own_line: Line
    convergence_check: ConvergenceCheck
    """none: run once (--once); step: again at half the step, and with twice the bars where the line
    goes slack; bars: with both in any case."""
    remarks: tuple[str, ...] = ()
    """What to know before the figures are used."""
    line: Counted | None = None
    """Of several lines, which one; None where there is one."""
    anchor_at_rest: Mapping[InitialFriction, float] = field(default_factory=dict)
    """Tension at the anchor at rest, N, by the initial friction; empty where nothing rubs."""
    undecided: tuple[str, ...] = ()
    """Checks whose verdict is another when it is run again."""
    governs: bool = False
    """Whether it is the line of a body that is used furthest."""
    beyond_MBL: BeyondMBL | None = None
    between: Between | None = None

    @property
    def tension_at_rest(self) -> Annotated[Mapping[str, float], AnchorAtRest] | None:
        """Tension at the anchor at rest by initial_friction; None where nothing rubs."""
        return {f"{key}_N": value for key, value in self.anchor_at_rest.items()} or None

    @property
    def is_anchored(self) -> bool:
        """Whether its lower end, or first one, is at an anchor."""
        return self.between is None or self.between.is_anchored

    @property
    def shown(self) -> str:
        """Number of the line, or its name where it is one between points."""
        return f"{self.line or ''}" if self.between is None else self.between.name

    @property
    def is_complete(self) -> bool:
        """Whether none of its runs was stopped, nor its convergence check."""
        return all(run.is_complete(self.convergence_check) for run in self.runs)

    @property
    def where(self) -> str:
        """What it is of, for sentences: a load case, or a line of a body."""
        if self.line is None:
            return Message("motion.of_load_case", name=self.name)
        return Message("motion.of_line", number=self.shown)

    @cached_property
    def levels(self) -> list[tuple[Way | None, tuple[DynamicRun, ...]]]:
        """All runs, and all of them again by each way in which all have an answer."""
        levels: list[tuple[Way | None, tuple[DynamicRun, ...]]] = [(None, self.runs)]
        for again in zip(*(run.again for run in self.runs), strict=False):
            runs = tuple(each.run for each in again if each.run is not None)
            if len(runs) == len(self.runs):
                levels.append((again[0].way, runs))
        return levels

    def _typical(self, quantity: str, runs: Sequence[DynamicRun]) -> float | None:
        """Return what of all runs must not hang on step and bars; None where there is none.

        In periodic motion the mean peak of a cycle, in a random sea the most probable maximum.
        """
        if quantity not in SERIES:
            return None
        peaks = self.cycle_peaks(quantity, runs)
        if peaks.size > 1:
            return float(peaks.mean())
        tail = self.tail(quantity, runs)
        return None if tail is None else tail.extreme.most_probable

    def _chance(self, quantity: str) -> float | None:
        """Half the interval over seeds of what is typical; None where that is no matter of seeds.

        By the tail of the runs as they were asked for, as it is printed.
        """
        if quantity not in SERIES or self.cycle_peaks(quantity).size > 1:
            return None
        tail = self.tail(quantity, self.runs)
        return None if tail is None else 0.5 * (tail.extreme.high - tail.extreme.low)

    def _is_paired(self, quantity: str) -> bool:
        """Whether minutes are compared: of a line that snaps in a random sea, for long enough."""
        by = "fairlead_tension" if quantity == "largest_tension" else quantity
        if not self.varies_at_random(by) or not self.goes_slack:
            return False
        every = [run for _, runs in self.levels for run in runs]
        if not all(run.history.counts for run in every):
            return False
        time = sum(run.history.course(by).duration for run in self.runs)
        return time >= LEAST_BLOCKS * BLOCK

    @cached_property
    def goes_slack(self) -> bool:
        """Whether a bar of the line has no tension at some time."""
        return any(run.history.line_slack_time() > 0.0 for run in self.runs)

    def _changes_of(self, quantity: str) -> Iterator[list[Change]]:
        """Yield how far a quantity moved from one level to the next, for the runs or each run.

        It is what is typical of the runs where every level has that, else the largest of each run;
        of a line that goes slack in a random sea the mean of the minutes' maxima.
        """
        if self._is_paired(quantity):
            yield paired_changes(quantity, self.levels)
            return
        typical = [self._typical(quantity, runs) for _, runs in self.levels]
        values = [[each] for each in typical if each is not None]
        chance = self._chance(quantity)
        if len(values) < len(typical):
            chance = None
            values = [[run.maxima[quantity] for run in runs] for _, runs in self.levels]
        for of_run in zip(*values, strict=True):
            found = []
            for (old, new), (way, runs) in zip(
                itertools.pairwise(of_run), self.levels[1:], strict=True
            ):
                over = new or old
                if quantity.endswith("tension"):
                    largest = max(run.maxima["largest_tension"] for run in runs)
                    over = max(over, LEAST_TENSION * largest)
                elif quantity == "grounded_length":
                    over = self.own_line.length
                if over > 0.0 and way is not None:
                    amount = abs(new - old)
                    found.append(Change(quantity, way, amount / over, amount, chance))
            yield found

    @cached_property
    def _moved(self) -> list[list[Change]]:
        """How far every judged value moved from one level to the next."""
        return [each for quantity in self.runs[0].maxima for each in self._changes_of(quantity)]

    @cached_property
    def changes(self) -> tuple[Change, ...]:
        """Largest change of each judged value, by the way in which it was run again."""
        return tuple(largest_changes(change for each in self._moved for change in each))

    @cached_property
    def added_changes(self) -> tuple[Change, ...]:
        """Largest change of each judged value, by all ways in which it was run again."""
        return tuple(largest_changes(change for each in self._moved for change in added(each)))

    @property
    def MBL(self) -> float | None:
        """Least of the line's segments, N; None where one has none."""
        known = [each.MBL for each in self.own_line.segments]
        return min(filter(None, known), default=None) if all(known) else None

    @property
    def has_parted(self) -> bool:
        """Whether it is the line that parts: how it falls decides nothing."""
        is_own = self.drive.dynamics.broken_line == (self.line or 1)
        return is_own and any(run.history.parted is not None for run in self.runs)

    def decides(self, change: Change) -> bool:
        """Whether a change is too large: by 5 % of its own maximum and by 2 % of the line's MBL.

        Of a most probable maximum by its interval over seeds in place of the first. The line of a
        body that governs meets 5 % always.
        """
        return not self.has_parted and (
            change.size > LIMIT if self.governs else change.decides(self.MBL)
        )

    def scatter_of(self, quantity: str) -> float | None:
        """Return the standard error of the mean peak of a cycle; None where there is none."""
        peaks = self.cycle_peaks(quantity)
        return None if peaks.size < 2 else float(peaks.std(ddof=1) / math.sqrt(peaks.size))

    def cycle_peaks(self, quantity: str, runs: Sequence[DynamicRun] | None = None) -> Array:
        """Peaks of the whole cycles of a periodic motion in all runs; none of any other."""
        period, of = self.drive.period, runs or self.runs
        if period is None or not all(run.history.counts for run in of):
            return np.zeros(0)
        return np.concatenate([run.cycle_peaks(quantity, period) for run in of])

    @property
    def is_scattered(self) -> bool:
        """Whether the peaks of a periodic motion differ by more from cycle to cycle than may be.

        Their standard error is judged as a change is, at the fairlead and at the anchor; of fewer
        than `LEAST_CYCLES` it is too uncertain itself.
        """
        for quantity in ("fairlead_tension", "anchor_tension"):
            error = self.scatter_of(quantity)
            if error is not None and self.cycle_peaks(quantity).size >= LEAST_CYCLES:
                mean = float(self.cycle_peaks(quantity).mean())
                over = max(mean, LEAST_TENSION * self.max_tension)
                if self.decides(Change(quantity, "step", error / over, error)):
                    return True
        return False

    def damping_range(self, quantity: str) -> tuple[float, float] | None:
        """Least and largest maximum with half, the given and twice the damping, of the worst run.

        None where the line was not run so.
        """
        found = [
            [run.maxima[quantity], *(each.maxima[quantity] for each in run.damped if each.maxima)]
            for run in self.runs
            if run.damped
        ]
        by_damping = [max(each) for each in zip(*found, strict=False)]
        return (min(by_damping), max(by_damping)) if found else None

    @property
    def worst_change(self) -> Change | None:
        """The largest of those that decide, or else of all; None where nothing was run again."""
        deciding = [each for each in self.added_changes if self.decides(each)]
        return max(deciding or self.added_changes, key=lambda each: each.size, default=None)

    def change_of(self, quantity: str) -> float | None:
        """Largest change of the maximum of a quantity, all ways added; None where run once."""
        found = (each.size for each in self.added_changes if each.quantity == quantity)
        return max(found, default=None)

    @property
    def failure(self) -> Again | None:
        """A run again that did not converge itself."""
        return next((a for run in self.runs for a in run.again if a.failure), None)

    @property
    def numerical_part(self) -> NotNegative:
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
    def is_unclear(self) -> bool:
        """Whether chance moves a maximum so far that runs again prove nothing."""
        return any(
            each.is_too_uncertain and not each.is_small_beside(self.MBL)
            for each in self.added_changes
        )

    @cached_property
    def verdict(self) -> Verdict:
        """Whether what decides hangs on the step or the bars: by `decides`, and by no check."""
        worst = self.worst_change
        if self.failure is not None or self.numerical_part > LIMIT:
            return "not converged"
        if worst is not None and (self.decides(worst) or self.undecided or self.is_scattered):
            return "not converged"
        if self.is_unclear:
            return "not proven"
        return "converged" if worst is not None and self.is_complete else "not proven"

    @cached_property
    def quantities(self) -> tuple[OverRuns, ...]:
        """Statistics of every one of `SERIES`."""
        found = []
        for quantity in SERIES:
            each = [run.statistics(quantity) for run in self.runs]
            tail, gumbel = self.tail(quantity, self.runs), self._gumbel(quantity, each)
            found.append(over_runs(quantity, each, tail, gumbel, self.storm(quantity, self.runs)))
        return tuple(found)

    def of(self, quantity: str) -> OverRuns:
        """Look a quantity up."""
        return next(each for each in self.quantities if each.quantity == quantity)

    @property
    def max_tension(self) -> SomeForce:
        """Largest tension, at an end or anywhere along the line, N."""
        return max(run.maxima["largest_tension"] for run in self.runs)

    @property
    def at_ends(self) -> tuple[OverRuns, ...]:
        """Tension at the fairlead, of a line between points at either end."""
        ends = ("fairlead_tension", "anchor_tension")[: 2 if self.between else 1]
        return tuple(map(self.of, ends))

    @property
    def pull(self) -> float:
        """Tension by which the part is compared with others, N: of a line between points any."""
        return self.max_tension if self.between else self.of("fairlead_tension").maximum

    @property
    def slack_time(self) -> Duration:
        """Time in all that a bar of the line had no tension in one run, after the ramp, s."""
        return max(run.slack_time for run in self.runs)

    @property
    def longest_slack(self) -> Duration:
        """Longest time at a stretch that a bar of the line had no tension, after the ramp, s."""
        return max(run.longest_slack for run in self.runs)

    @property
    def quasi_static_max(self) -> SomeForce | None:
        """Largest at the fairlead in closed form at the same places of it, N; None without any."""
        known = [run.quasi_static_max for run in self.runs]
        found = [value for value in known if value is not None]
        return max(found) if len(found) == len(known) else None

    amplification = OldName("dynamic_amplification")
    proof = OldName("convergence_check")

    @property
    def dynamic_amplification(self) -> float | None:
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
    def elements(self) -> Counted:
        """Bars of the line."""
        return self.drive.dynamics.bars

    @property
    def duration_of_interest(self) -> float:
        """Of the storm for which extremes are given, s."""
        return self.drive.dynamics.duration_of_interest

    def tail(self, quantity: str, runs: Sequence[DynamicRun]) -> TailFit | None:
        """Fit the highest peaks of a followed quantity in some runs; None where that says nothing.

        That is where it is not random, or has too few peaks (`weibull_tail`).
        """
        if not self.varies_at_random(quantity) or not all(run.history.counts for run in runs):
            return None
        courses = [run.history.course(quantity) for run in runs]
        values, time = [one.value for one in courses], sum(one.duration for one in courses)
        mean = taken_together(courses)
        return weibull_tail(values, time, self.duration_of_interest, mean=mean)

    def storm(self, quantity: str, runs: Sequence[DynamicRun]) -> Extreme | None:
        """Find the largest value in the storm that checks are held against; None as for `tail`.

        Of a line that goes slack, with two kinds of peaks, by Gumbel's distribution of blocks.
        """
        tail = self.tail(quantity, runs)
        if tail is None or not any(run.history.line_slack_time() > 0.0 for run in runs):
            return None if tail is None else tail.extreme
        return storm_of_blocks(quantity, runs, self.duration_of_interest) or tail.extreme

    def worst_storm(self, quantity: str) -> Extreme | None:
        """Find what the runs, or one of the times they were made again, come to at most."""
        found = [self.storm(quantity, runs) for _, runs in self.levels]
        known = [each for each in found if each is not None]
        return largest(known, lambda each: each.most_probable) if known else None

    def _gumbel(self, quantity: str, each: list[SeriesStatistics]) -> GumbelFit | None:
        whole = [one for one, run in zip(each, self.runs, strict=True) if run.history.is_complete]
        if not whole or not self.varies_at_random(quantity):
            return None
        maxima = [one.maximum for one in whole]
        return gumbel_of(maxima, whole[0].duration, self.duration_of_interest)


@dataclass(frozen=True)
class JointInMotion(Record):
    """Where a joint was in all runs."""

    DOCUMENT = "name rest=rest_m least=least_m largest=largest_m way"

    name: str
    """Of the point."""
    rest: tuple[float, float, float]
    """m: x, y and height where it rests."""
    least: tuple[float, float, float]
    """m: least x, y and height, each by itself."""
    largest: tuple[float, float, float]
    """m: largest x, y and height, each by itself."""
    way: Height
    """Farthest from where it rests, in any direction, m."""


@dataclass(frozen=True, repr=False)
class DynamicVerification(Displayable, Record):
    """A case in motion. Series are in the files of ``--out``."""

    DOCUMENT = (
        "is_complete verdict drag_axial_area initial_friction body joints? parts=load_cases checks?"
    )

    case: Case | Network
    parts: Annotated[tuple[DynamicPart, ...], From(1)]
    """Every load case that was run; of several lines, every line."""
    is_complete: bool
    """False: it was stopped (Ctrl-C); what is here was computed until then: the last run is short,
    and others may be missing."""
    checks: ChecksInMotion | None = None
    """In motion, by the factors for dynamic analysis; None where they were not made."""

    @cached_property
    def drag_axial_area(self) -> Literal["D"]:
        """Area per length that drag along the line goes with: pi D of a file is converted."""
        return "D"

    @cached_property
    def initial_friction(self) -> InitialFriction | None:
        """Of the bed at rest: the line was last pulled, or laid under more tension, or neither."""
        return None if self.case.dynamics is None else self.case.dynamics.initial_friction

    @cached_property
    def verdict(self) -> Verdict:
        """That of the load cases together."""
        return worst_verdict(part.verdict for part in self.parts)

    @property
    def governing(self) -> DynamicPart:
        """The part of the largest tension by which they compare; of those alike the first."""
        return largest(self.parts, lambda part: part.pull)

    @property
    def beyond_MBL(self) -> tuple[DynamicPart, ...]:
        """The parts with a segment that exceeds its MBL, the one that does so by most first."""
        beyond = [(part.beyond_MBL.times, part) for part in self.parts if part.beyond_MBL]
        return tuple(part for _, part in sorted(beyond, key=lambda each: -each[0]))

    @property
    def least_proven(self) -> DynamicPart:
        """The part that says most against the answer: not converged, or changed most."""
        bad = [part for part in self.parts if part.verdict == "not converged"]
        return largest(bad or self.parts, lambda p: p.worst_change.size if p.worst_change else 0.0)

    @cached_property
    def joints(self) -> tuple[JointInMotion, ...]:
        """Of points and lines: where joints were in all runs, after the ramp."""
        names, runs = [joint.name for _, joint in self.case.keyed_joints], self.parts[0].runs
        if not names:
            return ()
        places = np.concatenate([run.history.nodes[run.counted] for run in runs])
        rest = runs[0].history.nodes[0]
        ways = np.linalg.norm(places - rest, axis=2).max(axis=0)
        where = zip(*(each.tolist() for each in (rest, places.min(0), places.max(0))), strict=True)
        return tuple(
            JointInMotion(name, (*at,), (*least,), (*most,), way)
            for name, (at, least, most), way in zip(names, where, ways.tolist(), strict=True)
        )

    @cached_property
    def body(self) -> tuple[OverRuns, ...]:
        """Where a moored body or a buoy was in all runs, after the ramp; empty without one."""
        part, found = self.parts[0], []
        tracks = [(run, run.track) for run in part.runs if run.track is not None]
        for quantity in TRACK if tracks else ():
            each = [of_track(quantity, run, track, self.case) for run, track in tracks]
            found.append(over_runs(quantity, each))
        hulls = [(run, run.hull) for run in part.runs if run.hull is not None]
        found += [
            over_runs(quantity, [of_hull(quantity, *each) for each in hulls])
            for quantity in (quantities_of_hull(hulls[0][1]) if hulls else ())
        ]
        return tuple(found)
