"""Which line holds in its own sea: those that pass at rest are run afloat, as few as will do.

Lines are sizes by lengths. Three things spare runs: a line that fails at rest without any allowance
for motion is not run; lines are run in the order in which they are preferred, so that no line need
be run that would not be chosen before one that passes; and where a line fails, lengths of its size
are leapt over, as if a line failed between two that fail. The last is no theorem. What is
recommended was run itself, in every load case.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Final, NamedTuple

from catopt.catenary.solution import Solution
from catopt.design.evaluation import sinker_of
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.design.result import DesignPoint
from catopt.errors import InputError, refused
from catopt.largest import largest
from catopt.loads.ship import neighbours
from catopt.loads.sinker import SinkerSize
from catopt.model import Anchor, Case
from catopt.progress import Progress, expect, watcher
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.converge import ConvergedSizing, best_of
from catopt.sizing.in_motion import (
    Counted,
    InMotion,
    LengthRun,
    LineTried,
    NoLineInMotionError,
    RunsAfloat,
    SinkerSlide,
    Storm,
    in_sea,
    sea_of,
)
from catopt.sizing.line_choice import LineChoice, sold
from catopt.sizing.motion_verdicts import Judged, NoAnswer, judged, largest_heel
from catopt.sizing.pattern import HEAVY_SINKERS
from catopt.sizing.quick import MOST_LINES, shared_out
from catopt.sizing.ship_afloat import run_in_still_water
from catopt.verify.case import load_states
from catopt.verify.convergence_check import largest_changes
from catopt.verify.dynamic import Wanted, processes_for, run_again, run_once
from catopt.verify.dynamic_result import DynamicPart, worst_verdict
from catopt.verify.dynamic_setup import read_drive
from catopt.verify.hulls import hull_of
from catopt.verify.side_by_side import SECONDS_PER_BAR_AND_STEP, Crew, Threads
from catopt.verify.verdicts import (
    line_in_motion,
    mean_heel,
    way_of,
    with_more_runs,
    with_settings,
    with_verdicts,
)
from catopt.words import Message, Several

_RUNG: Final = 1.08
"""Lengths that are looked at are at least this times the one before."""
_BEYOND: Final = 2.0
"""Times the line that is best at rest: how long a line is looked at beyond the scope."""
_LINES: Final = 1.5
"""Lines that a search runs in every load case, about: for its announcement."""
_SNAPS: Final = 3.0
"""Steps of a line that snaps over those of one that does not, about."""
_START: Final = 10.0
"""s, about, until processes run."""

SettleLine = Callable[[LineChoice], ConvergedSizing]


class Moved(NamedTuple):
    """The line that a sizing recommends in motion."""

    settled: ConvergedSizing
    in_motion: InMotion
    sinker: SinkerSize


@dataclass(frozen=True)
class _Size:
    component: str
    diameter: float
    shortest: DesignPoint  # at rest
    first: int  # place of its shortest length among those that are looked at


def search_in_motion(
    request: BuoyRequest, best_at_rest: ConvergedSizing, settle_line: SettleLine
) -> Moved:
    """Find the line that the preference chooses among those that pass in motion.

    `settle_line` settles the loads on what a choice leaves of lines. InputError: the buoy or the
    sea is none that can be run. NoLineInMotionError: no line passes.
    """
    how = request.in_motion
    assert how is not None
    _check_afloat(best_at_rest, request)
    if how.quick:
        case = run_in_still_water(best_at_rest.case, request)
        assert case is not None
        how = shared_out(how, len(load_states(case, None)))
        request = replace(request, in_motion=how)
    found = _Search(request, how, best_at_rest, settle_line)
    sizes = list(found.sizes())
    if not how.quick:
        expect(Message("sizing.running_afloat", count=len(sizes)), found.seconds)
    with Threads() if how.quick else Crew(processes_for(found.work, None)) as crew:
        chosen = found.best(sizes, crew)
        by_length = found.by_length(sizes, chosen, crew) if chosen and how.other_lengths else ()
    counted = found.counted(sizes)
    if chosen is None:
        every = [each for each in found.judged.values() if each is not None]
        near = next((each for each in every if each.tried.fails_by_margin(how.margin)), None)
        if near is not None:
            full = _search_in_full(near.tried, request, best_at_rest, settle_line)
            return full._replace(in_motion=replace(full.in_motion, fast=found.tried))
        tried = [(each.settled.point.line, each.tried) for each in every]
        raise NoLineInMotionError(tried, counted)
    assert chosen.checks is not None
    return Moved(
        replace(chosen.settled, choice=request.line),
        InMotion(
            how,
            _run_in_full(chosen.case) if how.quick else chosen.case,
            chosen.checks,
            _storm(chosen, how),
            request.line.allowance,
            counted,
            found.tried,
            by_length,
            len(chosen.case.load_cases),
            seas=chosen.seas,
            heel=largest_heel(chosen.parts),
            mean_heel=mean_heel([run for part in chosen.parts for run in part.runs]),
            slides=_slides(chosen),
            proof=chosen.verdict,
            changes=tuple(largest_changes(e for p in chosen.parts for e in p.added_changes)),
        ),
        _sinker_size(request, chosen),
    )


def _search_in_full(
    of: LineTried, request: BuoyRequest, best_at_rest: ConvergedSizing, settle_line: SettleLine
) -> Moved:
    """Search the size of a line in the full way, where the margin of the fast one leaves none."""
    line = replace(
        request.line,
        components=(of.component,),
        diameter_min=of.diameter,
        diameter_max=of.diameter,
    )
    asked = replace(request, line=line, in_motion=RunsAfloat())
    found = search_in_motion(asked, best_at_rest, settle_line)
    return found._replace(settled=replace(found.settled, choice=request.line))


def _run_in_full(case: Case) -> Case:
    """Give a case the usual runs, by which it is verified."""
    assert case.dynamics is not None
    usual = RunsAfloat()
    dynamics = replace(case.dynamics, duration=usual.duration, runs=usual.seeds)
    return replace(case, dynamics=dynamics)


def can_be_run(settled: ConvergedSizing, request: BuoyRequest) -> bool:
    """Whether buoy and sea can be run in motion."""
    try:
        _check_afloat(settled, request)
    except InputError:
        return False
    return True


def _check_afloat(settled: ConvergedSizing, request: BuoyRequest) -> None:
    if request.marine_growth:
        allowed = Message("refused.growth_in_motion")
        raise refused("marine_growth", f"{request.marine_growth:g} m", allowed, "BuoyRequest")
    case, allowed = run_in_still_water(settled.case, request), Message("refused.not_afloat")
    if case is not None:
        try:
            hull_of(case)
            return
        except InputError:
            allowed = Message("refused.not_upright")
    raise refused("in_motion", "true", allowed, "BuoyRequest")


class _Search:
    """Lines that were tried, and those that are left."""

    def __init__(
        self, request: BuoyRequest, how: RunsAfloat, start: ConvergedSizing, settle_line: SettleLine
    ) -> None:
        self.request, self.how, self._settle = request, how, settle_line
        self._start = start
        self.judged: dict[tuple[str, float, int], Judged | None] = {}
        self._at_rest: dict[tuple[str, float, int], ConvergedSizing | None] = {}
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
        every = sold(self.request.line, self.request.environment.water_density)
        most = self.lengths[-1] / self._depth
        limits = (min(self.request.line.scope[0], most), most)
        for each in sorted(every, key=lambda one: one.submerged_weight):
            assert each.nominal_diameter is not None
            try:
                rest = self._settled(each.component, each.nominal_diameter, limits)
            except (NoFeasibleDesignError, InputError):
                continue
            length = rest.point.line.length
            first = next(k for k, one in enumerate(self.lengths) if one >= length * (1.0 - 1e-9))
            yield _Size(each.component, each.nominal_diameter, rest.point, first)

    def _settled(self, component: str, size: float, scope: tuple[float, float]) -> ConvergedSizing:
        only = self.request.line.only(component, size)
        return self._settle(replace(only, dynamic_factor=1.0, scope=scope, length_step=self._step))

    @cached_property
    def work(self) -> float:
        """Bars times steps of all runs of a line."""
        case = run_in_still_water(self._start.case, self.request)
        assert case is not None
        states = load_states(case, None)
        drive = read_drive(states[0][1])
        steps = self.how.duration / drive.stepping(drive.sea(0), []).step
        runs = self.how.seeds * len(states) * max(1, len(self.how.periods))
        return _SNAPS * steps * self.how.elements * runs

    @property
    def seconds(self) -> float:
        """Foretell what the search takes, roughly."""
        side = processes_for(self.work, None)
        lines = _LINES + self.how.other_lengths
        return _START + lines * self.work * SECONDS_PER_BAR_AND_STEP / side

    def counted(self, sizes: Sequence[_Size]) -> Counted:
        """Count the lines by what became of them."""
        every = len(sold(self.request.line, self.request.environment.water_density))
        considered = every * len(self.lengths)
        open_ones = sum(len(self.lengths) - each.first for each in sizes)
        run, runs = len(self.tried), sum(each.runs for each in self.tried)
        unsettled = len(self.judged) - run
        at_rest = considered - open_ones + unsettled
        return Counted(considered, at_rest, considered - at_rest - run, run, runs)

    def best(self, sizes: Sequence[_Size], crew: Crew) -> Judged | None:
        """Find the line that is preferred of all that pass, the most preferred ones first.

        Of every size the shortest line that is not known to fail stands for all longer ones, than
        which it is lighter and swings less. The one that is preferred is run. Where it fails, its
        size goes on by one length, then two, four and so on; where it passes after such a leap,
        the shortest that passes is found by halving. The fast search takes the first that passes.
        """
        chosen: Judged | None = None
        fronts = {k: _Front(each.first, each.first) for k, each in enumerate(sizes)}
        while True:
            nexts = {k: self._next(sizes[k], front) for k, front in fronts.items()}
            there = {k: point for k, point in nexts.items() if point is not None}
            points = [*there.values(), *([chosen.settled.point] if chosen else [])]
            if not points:
                return None
            if self.how.quick and (chosen is not None or len(self.tried) >= MOST_LINES):
                return chosen
            wanted = best_of(points, self.request.line)
            if chosen is not None and wanted is chosen.settled.point:
                proven = self._proven(chosen, crew)
                if proven.tried.passes:
                    return proven
                size = next(e for e in sizes if _is_of(proven, e))
                rung = self.lengths.index(_nearest(self.lengths, proven.tried.length))
                fronts[sizes.index(size)] = _Front(rung + 1, rung + 1)
                chosen = None
                continue
            k = next(each for each, point in there.items() if point is wanted)
            size, front = sizes[k], fronts[k]
            tried = self._tried(size, front.at, crew)
            if tried is not None and tried.tried.passes:
                passes = tried if self.how.quick else self._halved(size, front, tried, crew)
                points = [passes.settled.point, *([chosen.settled.point] if chosen else [])]
                if best_of(points, self.request.line) is passes.settled.point:
                    chosen = passes
                del fronts[k]
            else:
                front.low, front.at = front.at + 1, front.at + front.leap
                front.leap *= 2

    def _next(self, size: _Size, front: _Front) -> DesignPoint | None:
        """Settle the next line of a size; its last length is not leapt over."""
        last = len(self.lengths) - 1
        while front.low <= last:
            front.at = min(front.at, last)
            settled = self._rest(size, front.at)
            if settled is not None:
                return settled.point
            front.low = front.at = front.at + 1
        return None

    def _halved(self, size: _Size, front: _Front, passes: Judged, crew: Crew) -> Judged:
        """Halve what was leapt over to the shortest that passes."""
        low, high = front.low, front.at
        while low < high:
            middle = (low + high) // 2
            found = self._tried(size, middle, crew)
            if found is not None and found.tried.passes:
                passes, high = found, middle
            else:
                low = middle + 1
        return passes

    def _rest(self, size: _Size, rung: int) -> ConvergedSizing | None:
        """Settle a line; None where it fails at rest."""
        key = (size.component, size.diameter, rung)
        if key not in self._at_rest:
            scope = self.lengths[rung] / self._depth
            try:
                self._at_rest[key] = self._settled(size.component, size.diameter, (scope, scope))
            except NoFeasibleDesignError:
                self._at_rest[key] = None
        return self._at_rest[key]

    def by_length(
        self, sizes: Sequence[_Size], chosen: Judged, crew: Crew
    ) -> tuple[LengthRun, ...]:
        """Run other lengths of a line's size that pass at rest, from the shortest to the longest.

        All their seeds are run, whether they pass or not.
        """
        own = chosen.tried
        size = next(e for e in sizes if _is_of(chosen, e))
        every = (self._rest(size, rung) for rung in range(size.first, len(self.lengths)))
        pass_at_rest = [each for each in every if each is not None]
        others = [each for each in pass_at_rest if each.point.line.length != own.length]
        count = min(self.how.other_lengths, len(others))
        places = {round(k * (len(others) - 1) / max(count - 1, 1)) for k in range(count)}
        found = [chosen]
        found += [self._run(others[k], crew, whole=True) for k in sorted(places)]
        runs = []
        for each in found:
            anchor, storm = each.case.anchor, _storm(each, self.how) if each.parts else None
            sinker = None if anchor is None or storm is None else anchor.mass
            runs.append(LengthRun(each.tried, storm, sinker))
        return tuple(sorted(runs, key=lambda run: run.tried.length))

    def _proven(self, of: Judged, crew: Crew) -> Judged:
        """Run a line again at a finer step and with more bars; it passes there, too, or fails."""
        rung = self.lengths.index(_nearest(self.lengths, of.tried.length))
        found = _again(of, self.how, crew, self._tell)
        self.judged[of.tried.component, of.tried.diameter, rung] = found
        return found

    def _run(self, settled: ConvergedSizing, crew: Crew, *, whole: bool = False) -> Judged:
        self._tell(0, 1)
        return _run(settled, self.request, self.how, crew, self._tell, whole=whole)

    @property
    def _tell(self) -> Progress:
        """Tell of a part of the present line as of all lines that are run at most, about."""
        lines, tell = len(self.tried), watcher()
        return lambda done, total: tell(lines + done / total, max(MOST_LINES, lines) + 1)

    def _tried(self, size: _Size, rung: int, crew: Crew) -> Judged | None:
        """Run a line; None where it fails at rest."""
        key = (size.component, size.diameter, rung)
        if key not in self.judged:
            settled = self._rest(size, rung)
            run = None if settled is None else self._run(settled, crew)
            self.judged[key] = run
        return self.judged[key]


def _is_of(judged_line: Judged, size: _Size) -> bool:
    """Whether a line is of a size."""
    tried = judged_line.tried
    return (size.component, size.diameter) == (tried.component, tried.diameter)


def _nearest(lengths: Sequence[float], length: float) -> float:
    return min(lengths, key=lambda each: abs(each - length))


@dataclass
class _Front:
    """How far the lengths of a size are known to fail, or taken to."""

    low: int  # the first that is not
    at: int  # that is next
    leap: int = 1


def _ladder(every: Sequence[float], most: float) -> tuple[float, ...]:
    """Thin lengths out up to the most, m, which the last one reaches."""
    within = [each for each in every if each <= most * (1.0 + 1e-9)] or [every[0]]
    kept = [within[0]]
    for each in within[1:]:
        if each >= _RUNG * kept[-1]:
            kept.append(each)
    return tuple(kept if kept[-1] == within[-1] else [*kept, within[-1]])


# ------------------------------------------------------------------ one line


def _run(
    settled: ConvergedSizing,
    request: BuoyRequest,
    how: RunsAfloat,
    crew: Crew,
    tell: Progress,
    *,
    whole: bool = False,
) -> Judged:
    """Run a line in every load case and sea, side by side: first one seed, by its largest values.

    The largest value of a run is never above what all of them are judged by. `whole`: the others
    are run, too, where that fails.
    """
    case = run_in_still_water(settled.case, request)
    assert case is not None
    assert case.dynamics is not None
    assert case.waves is not None
    sinkers = _sinkers_from(settled, case)
    seas = _seas(case, how)
    largest_values = replace(case.dynamics, judged_by="largest")
    drives = [
        (name, replace(read_drive(state), compares_at_rest=False, sinkers=sinkers))
        for sea in seas
        for name, state in load_states(sea, None)
    ]
    begun = run_once([Wanted(*each, (0,)) for each in drives], crew, tell)
    if how.quick:
        return judged(settled, seas, _pooled(begun), how)
    found = judged(settled, [replace(e, dynamics=largest_values) for e in seas], begun, how)
    goes_on = found.tried.passes or (whole and not found.tried.reason)
    if goes_on and how.seeds > 1:
        rest = tuple(range(1, how.seeds))
        more = run_once([Wanted(*each, rest) for each in drives], crew, tell)
        begun = [_together(*each) for each in zip(begun, more, strict=True)]
    return judged(settled, seas, begun, how) if goes_on else found


def _pooled(found: Sequence[DynamicPart | NoAnswer]) -> list[DynamicPart | NoAnswer]:
    """Judge every load case of a line by the runs of all of them.

    They are runs of one line in one sea, whose water is higher or lower, or whose chain is worn: a
    largest value counts in each, and together they have the peaks for an interval.
    """
    runs = tuple(run for each in found if isinstance(each, DynamicPart) for run in each.runs)
    return [replace(e, runs=runs) if isinstance(e, DynamicPart) else e for e in found]


def _again(of: Judged, how: RunsAfloat, crew: Crew, tell: Progress) -> Judged:
    """Run a line that passes again, as `catopt verify --dynamic` does; what fails there fails.

    Its sinker stays in all runs.
    """
    seas, parts = _seas(of.case, how), run_again(of.parts, crew, tell)
    found = judged(of.settled, seas, parts, how)
    if not found.tried.passes:
        return found
    undecided = [
        each
        for k, sea in enumerate(seas)
        for each in with_verdicts(
            replace(sea, anchor=found.case.anchor), found.parts[_of_sea(k, seas, parts)]
        )
    ]
    checks = found.checks
    assert checks is not None
    worst = worst_verdict(each.verdict for each in undecided)
    checks = replace(checks, is_proven=worst == "converged", is_doubted=worst == "not converged")
    names = dict.fromkeys(name for each in undecided for name in each.undecided)
    reason = Message("sizing.fails_again", checks=Several(names, ", ")) if names else ""
    tried = replace(found.tried, reason=reason)
    return replace(found, tried=tried, parts=tuple(undecided), checks=checks)


def _of_sea(k: int, seas: Sequence[Case], parts: Sequence[DynamicPart]) -> slice:
    """Places of the load cases of a sea among all."""
    count = len(parts) // len(seas)
    return slice(k * count, (k + 1) * count)


def _seas(case: Case, how: RunsAfloat) -> list[Case]:
    """List the seas that a case is run in."""
    assert case.waves is not None
    waves = [replace(case.waves, **each._asdict()) for each in how.seas(*sea_of(case))]
    return [replace(case, waves=each) for each in waves]


def _sinkers_from(settled: ConvergedSizing, case: Case) -> tuple[Anchor, ...]:
    """List the sinker that the line has at rest and the heavier ones, where they may slide."""
    own, posed = case.anchor, settled.posed.case
    if own is None or own.max_slide is None or posed.design is None or posed.design.sinker is None:
        return ()
    choice = posed.design.sinker
    every = (sinker_of(posed, choice, k) for k in range(len(choice.masses)))
    heavier = (each for each in every if (each.mass or 0.0) > (own.mass or 0.0))
    return (own, *(replace(each, max_slide=own.max_slide) for each in heavier))


def _together(one: DynamicPart | NoAnswer, other: DynamicPart | NoAnswer) -> Any:
    """Put the runs of a load case together; what has no answer stays that."""
    if not isinstance(one, DynamicPart) or not isinstance(other, DynamicPart):
        return other if isinstance(one, DynamicPart) else one
    return with_more_runs(one, other)


# ------------------------------------------------------------------ the answer


def _storm(of: Judged, how: RunsAfloat) -> Storm:
    """Find the load case of the largest tension at the fairlead, and what the storm comes to.

    Of runs that were made again those count that come to the most.
    """
    fairlead = "fairlead_tension"

    def maximum(part: DynamicPart) -> float:
        every = (run for _, runs in part.levels for run in runs)
        return max(run.statistics(fairlead).maximum for run in every)

    def tension(pair: tuple[DynamicPart, Solution]) -> float:
        storm = pair[0].worst_storm(fairlead)
        return maximum(pair[0]) if storm is None else storm.most_probable

    part, at_rest = largest(list(zip(of.parts, of.at_rest, strict=True)), tension)
    extreme, case = part.worst_storm(fairlead), part.drive.case
    assert isinstance(case, Case)
    return Storm(
        in_sea(part.name, how, sea_of(case)),
        max(map(maximum, of.parts)),
        None if extreme is None else extreme.most_probable,
        None if extreme is None else extreme.low,
        None if extreme is None else extreme.high,
        at_rest.fairlead.tension,
    )


def _slides(of: Judged) -> tuple[SinkerSlide, ...]:
    """Say how far the sinker slides in the load case where it does so most, and its neighbours."""
    every, own = of.parts[0].drive.sinkers, of.case.anchor
    if own not in every:
        return ()
    at = every.index(own)
    found = []
    for each in every[max(0, at - 1) : at + 2]:
        ways = {}
        for judged_by in ("most-probable", "upper"):
            parts = (
                with_settings(e, replace(e.drive.dynamics, judged_by=judged_by)) for e in of.parts
            )
            ways[judged_by] = max(way_of(each, part, part.runs) for part in parts)
        found.append(SinkerSlide(each.mass or 0.0, ways["most-probable"], ways["upper"]))
    return tuple(found)


def _sinker_size(request: BuoyRequest, of: Judged) -> SinkerSize:
    """Size the sinker for the pull in motion, with its sources.

    One that may slide is sized for the pull at rest, and no lighter than what stays in the storm.
    """
    anchor, density = of.case.anchor, request.environment.water_density
    assert anchor is not None
    if anchor.max_slide is not None:
        ends = [solution.anchor for _, solution in of.settled.point.checks.solutions]
        size = request.ground.sized_for(ends, density)
        mass, weight = anchor.mass or size.mass, anchor.submerged_weight or size.submerged_weight
        smaller, larger = neighbours(mass, HEAVY_SINKERS)
        return replace(size, mass=mass, submerged_weight=weight, smaller=smaller, larger=larger)
    carried = [
        line_in_motion(of.case, part, part.runs, solution).carried
        for part, solution in zip(of.parts, of.at_rest, strict=True)
    ]
    pulls = [each.anchor for each in carried if each is not None]
    return request.ground.sized_for(pulls, density)
