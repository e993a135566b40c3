"""Which line holds in its own sea: those that pass at rest are run afloat, as few as will do.

Lines are sizes by lengths. Three things spare runs: a line that fails at rest without any allowance
for motion is not run; of one size a line is taken to pass where a shorter one does, so that the
shortest that passes is found by halving; and a size whose shortest line at rest would not be chosen
before one that passes is left out. The second is how the peaks of a line that is lifted off the bed
behave, no theorem: what is recommended was run itself, in every load case.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final, NamedTuple

from catopt.catalogue.in_words import chain_words
from catopt.catenary.solution import Solution
from catopt.checks.case import check_case
from catopt.checks.result import CheckReport, CheckResult
from catopt.design.evaluation import sinker_of
from catopt.design.near_miss import NoFeasibleDesignError
from catopt.design.result import DesignPoint, NearMiss
from catopt.errors import InputError, NoAnswerError, NotConvergedError, Problem
from catopt.loads.sinker import SinkerSize
from catopt.model import Anchor, Case
from catopt.patience import expect
from catopt.sizing.afloat import run_in_still_water
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.in_motion import (
    Counted,
    InMotion,
    LineTried,
    NoLineInMotionError,
    RunsAfloat,
)
from catopt.sizing.line_choice import LineChoice, sold
from catopt.sizing.settle import Settled, best_of
from catopt.ties import largest
from catopt.verify.case import load_states
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicPart
from catopt.verify.dynamic_setup import read_drive
from catopt.verify.effort import SECONDS_PER_BAR_AND_STEP
from catopt.verify.judged import check_parts, line_in_motion, solutions_at_rest
from catopt.words import Message

_RUNG: Final = 1.08
"""Lengths that are looked at are at least this times the one before."""
_BEYOND: Final = 2.0
"""Times the line that is best at rest: how long a line is looked at beyond the scope."""
_PROBES: Final = 5
"""Lines that a search runs in every load case, about: for its announcement."""
_RADIATION: Final = 8.0
"""s, about, that it takes to find the radiation of a buoy under a size of chain."""

SettleLine = Callable[[LineChoice], Settled]


class Moved(NamedTuple):
    """The line that a sizing recommends in motion."""

    settled: Settled
    in_motion: InMotion
    sinker: SinkerSize


@dataclass(frozen=True)
class _Judged:
    """What the runs of a line came to."""

    tried: LineTried
    settled: Settled  # with the sinker that motion asks for
    case: Case
    parts: tuple[DynamicPart, ...] = ()
    at_rest: tuple[Solution, ...] = ()
    checks: CheckReport | None = None


@dataclass(frozen=True)
class _Size:
    component: str
    diameter: float
    shortest: DesignPoint  # at rest
    first: int  # place of its shortest length among those that are looked at


def search_in_motion(request: BuoyRequest, best_at_rest: Settled, settle_line: SettleLine) -> Moved:
    """Find the line that the preference chooses among those that pass in motion.

    `settle_line` settles the loads on what a choice leaves of lines. InputError: the buoy or the
    sea is none that can be run. NoLineInMotionError: no line passes.
    """
    how = request.in_motion
    assert how is not None
    _check_afloat(best_at_rest, request)
    found = _Search(request, how, best_at_rest, settle_line)
    chosen: _Judged | None = None
    sizes = list(found.sizes())
    expect(Message("sizing.running_afloat", sizes=len(sizes)), found.seconds(len(sizes)))
    for size in sizes:
        if chosen is not None:
            points = [chosen.settled.point, size.shortest]
            if best_of(points, request.line) is chosen.settled.point:
                continue
        passes = found.shortest_that_passes(size)
        if passes is not None:
            points = [passes.settled.point, *([chosen.settled.point] if chosen else [])]
            if best_of(points, request.line) is passes.settled.point:
                chosen = passes
    counted = found.counted(sizes)
    if chosen is None:
        raise _nothing_passes(found, counted)
    return Moved(
        replace(chosen.settled, choice=request.line),
        _in_motion(chosen, how, request.line.allowance, counted, found.tried),
        _sinker_size(request, chosen),
    )


def _check_afloat(settled: Settled, request: BuoyRequest) -> None:
    if run_in_still_water(settled.case, request) is not None:
        return
    allowed = Message("refused.not_afloat")
    raise InputError([Problem("in_motion", "true", allowed)], "BuoyRequest")


class _Search:
    """Lines that were tried, and those that are left."""

    def __init__(
        self, request: BuoyRequest, how: RunsAfloat, start: Settled, settle_line: SettleLine
    ) -> None:
        self.request, self.how, self._settle = request, how, settle_line
        self._start = start
        self.judged: dict[tuple[str, float, int], _Judged | None] = {}
        design = start.posed.case.design
        assert design is not None
        every = design.segments[0].lengths
        self._depth = request.environment.levels.high
        self._step = every[1] - every[0] if len(every) > 1 else every[0]
        scope = request.line.scope[1] * self._depth
        most = _BEYOND * start.point.line.length
        self.lengths = _ladder(every, most if math.isinf(scope) else max(scope, most))

    @property
    def tried(self) -> tuple[LineTried, ...]:
        """What was run."""
        return tuple(each.tried for each in self.judged.values() if each is not None)

    def sizes(self) -> Iterator[_Size]:
        """List the sizes of which a line passes at rest without an allowance, the thin ones first.

        A size of which none does is looked at no more.
        """
        density = self.request.environment.water_density
        every = sold(self.request.line, density)
        for each in sorted(every, key=lambda one: one.submerged_weight):
            assert each.nominal_diameter is not None
            least = self.request.line.scope[0]
            limits = (min(least, self.lengths[-1] / self._depth), self.lengths[-1] / self._depth)
            try:
                rest = self._settled(each.component, each.nominal_diameter, limits)
            except (NoFeasibleDesignError, InputError):
                continue
            length = rest.point.line.length
            first = next(k for k, one in enumerate(self.lengths) if one >= length * (1.0 - 1e-9))
            yield _Size(each.component, each.nominal_diameter, rest.point, first)

    def _settled(self, component: str, size: float, scope: tuple[float, float]) -> Settled:
        only = self.request.line.only(component, size)
        return self._settle(replace(only, dynamic_factor=1.0, scope=scope, length_step=self._step))

    def seconds(self, sizes: int) -> float:
        """Foretell what the search takes, roughly, on one core."""
        case = run_in_still_water(self._start.case, self.request)
        assert case is not None
        states = load_states(case, None)
        drive = read_drive(states[0][1])
        step = drive.stepping(drive.sea(0), []).step
        one = self.how.duration / step * self.how.elements * SECONDS_PER_BAR_AND_STEP
        return sizes * (one + _RADIATION) + _PROBES * len(states) * self.how.seeds * one

    def counted(self, sizes: Sequence[_Size]) -> Counted:
        """Count the lines by what became of them."""
        every = len(sold(self.request.line, self.request.environment.water_density))
        considered = every * len(self.lengths)
        open_ones = sum(len(self.lengths) - each.first for each in sizes)
        run, runs = len(self.tried), sum(each.runs for each in self.tried)
        unsettled = len(self.judged) - run
        at_rest = considered - open_ones + unsettled
        return Counted(considered, at_rest, considered - at_rest - run, run, runs)

    def shortest_that_passes(self, size: _Size) -> _Judged | None:
        """Run the longest line of a size, and halve from there to the shortest that passes."""
        low, high = size.first, len(self.lengths) - 1
        best = self._tried(size, high)
        if best is None or not best.tried.passes:
            return None
        while low < high:
            middle = (low + high) // 2
            found = self._tried(size, middle)
            if found is not None and found.tried.passes:
                best, high = found, middle
            else:
                low = middle + 1
        return best

    def _tried(self, size: _Size, rung: int) -> _Judged | None:
        """Run a line; None where it fails at rest."""
        key = (size.component, size.diameter, rung)
        if key not in self.judged:
            scope = self.lengths[rung] / self._depth
            try:
                settled = self._settled(size.component, size.diameter, (scope, scope))
            except NoFeasibleDesignError:
                self.judged[key] = None
            else:
                self.judged[key] = _run(settled, self.request, self.how)
        return self.judged[key]


def _ladder(every: Sequence[float], most: float) -> tuple[float, ...]:
    """Thin lengths out up to the most, m, which the last one reaches."""
    within = [each for each in every if each <= most * (1.0 + 1e-9)] or [every[0]]
    kept = [within[0]]
    for each in within[1:]:
        if each >= _RUNG * kept[-1]:
            kept.append(each)
    return tuple(kept if kept[-1] == within[-1] else [*kept, within[-1]])


# ------------------------------------------------------------------ one line


def _run(settled: Settled, request: BuoyRequest, how: RunsAfloat) -> _Judged:
    """Run a line in every load case until one fails: first one seed, by its largest values.

    The largest value of a run is never above what all of them are judged by.
    """
    case = run_in_still_water(settled.case, request)
    assert case is not None
    assert case.dynamics is not None
    first, runs = replace(case.dynamics, runs=1, judged_by="largest"), 1
    names = [each.name for each in case.load_cases]
    try:
        found = _judge(replace(case, dynamics=first), settled, names[:1], ())
        parts: tuple[DynamicPart, ...] = ()
        while found.tried.passes and len(parts) < len(names):
            runs += how.seeds
            found = _judge(case, settled, names[len(parts) : len(parts) + 1], parts)
            parts = found.parts
    except (NoAnswerError, NotConvergedError) as error:
        tried = _line_tried(settled, runs, (), error.message)
        return _Judged(tried, settled, case)
    return replace(found, tried=replace(found.tried, runs=runs))


def _judge(
    case: Case, settled: Settled, names: Sequence[str], before: tuple[DynamicPart, ...]
) -> _Judged:
    """Run load cases, and check them with those that were run before; the sinker is sized."""
    parts = before
    for name in names:
        run = verify_dynamic(case, load_case=name, proof="none", compares_at_rest=False)
        if not run.is_complete:
            raise KeyboardInterrupt
        parts = (*parts, *run.parts)
    solved = solutions_at_rest(case, parts)
    at_rest = tuple(each for each in solved if each is not None)
    checks = check_parts(case, parts, solved)
    anchor = _held(settled, checks)
    if anchor is not settled.point.anchor:
        case = replace(case, anchor=anchor)
        checks = check_parts(case, parts, solved)
        still = check_case(replace(settled.case, anchor=anchor, design=None))
        point = replace(settled.point, anchor=anchor, checks=still)
        settled = replace(settled, point=point)
    failing = sorted((each for each in checks.results if not each.passes), key=_worst)
    return _Judged(_line_tried(settled, 0, tuple(failing)), settled, case, parts, at_rest, checks)


def _worst(check: CheckResult) -> float:
    return -check.excess


def _line_tried(
    settled: Settled, runs: int, failing: tuple[CheckResult, ...], reason: str = ""
) -> LineTried:
    line = settled.point.line
    (segment, *_) = line.segments
    return LineTried(
        segment.component,
        segment.nominal_diameter or 0.0,
        line.length,
        line.mass or 0.0,
        runs,
        failing,
        reason,
    )


def _held(settled: Settled, checks: CheckReport) -> Anchor | None:
    """Take the least sinker that does not slide in motion, no less than that at rest.

    What the line pulls does not hang on it. The heaviest where none holds.
    """
    own, case = settled.point.anchor, settled.posed.case
    needed = [each.demand for each in checks.results if each.kind == "sliding"]
    if own is None or not needed or case.design is None or case.design.sinker is None:
        return own
    weight = max(needed)
    if (own.submerged_weight or 0.0) >= weight:
        return own
    choice = case.design.sinker
    every = [sinker_of(case, choice, k) for k in range(len(choice.masses))]
    return next((each for each in every if (each.submerged_weight or 0.0) >= weight), every[-1])


# ------------------------------------------------------------------ the answer


def _in_motion(
    of: _Judged,
    how: RunsAfloat,
    allowance: float,
    counted: Counted,
    tried: tuple[LineTried, ...],
) -> InMotion:
    assert of.checks is not None

    def tension(pair: tuple[DynamicPart, Solution]) -> float:
        found = pair[0].of("fairlead_tension")
        return found.most_probable_maximum or found.maximum

    part, at_rest = largest(list(zip(of.parts, of.at_rest, strict=True)), tension)
    fairlead = part.of("fairlead_tension")
    extreme = None if fairlead.tail is None else fairlead.tail.extreme
    return InMotion(
        how,
        of.case,
        of.checks,
        part.name,
        max(each.of("fairlead_tension").maximum for each in of.parts),
        None if extreme is None else extreme.most_probable,
        None if extreme is None else extreme.low,
        None if extreme is None else extreme.high,
        at_rest.fairlead.tension,
        allowance,
        counted,
        tried,
    )


def _sinker_size(request: BuoyRequest, of: _Judged) -> SinkerSize:
    """Size the sinker for the pull in motion, with its sources."""
    carried = [
        line_in_motion(of.case, part, part.runs, solution).carried
        for part, solution in zip(of.parts, of.at_rest, strict=True)
    ]
    pulls = [each.anchor for each in carried if each is not None]
    return request.ground.sized(
        max(each.horizontal_force for each in pulls),
        max(0.0, *(each.vertical_force for each in pulls)),
        request.environment.water_density,
    )


def _nothing_passes(found: _Search, counted: Counted) -> NoLineInMotionError:
    """Say which line fails by the least."""
    every = [each for each in found.judged.values() if each is not None]

    def miss(of: _Judged) -> float:
        return of.tried.failing[0].excess if of.tried.failing else math.inf

    nearest = min(every, key=miss)
    (first, *_) = nearest.settled.point.line.segments
    chain = chain_words(first.component, first.nominal_diameter)
    tried = nearest.tried
    near = NearMiss(nearest.settled.point.line, tried.failing, tried.reason)
    return NoLineInMotionError(near, chain, counted)
