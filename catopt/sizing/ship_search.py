"""Which line holds its ship in motion: sized for what the runs of lines say, until one passes.

A line is sized at rest, run with the ship in every load case, and sized anew for an allowance for
motion that is the runs' own, by the factors of the code that judges lines in motion, until what is
sized passes its runs. From there shorter lines and thinner ones are run as long as they pass and
are preferred, and lines that are both thinner and longer, or thicker and shorter: what is
recommended is the last that passes, and the next shorter and the next thinner line were run, too.
What holds the line is sized for its runs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from operator import itemgetter
from typing import Any, Final, NamedTuple

from catopt.checks.case import check_case
from catopt.checks.profiles import profiles_of
from catopt.checks.result import CheckReport, CheckResult
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.errors import NoAnswerError, NotConvergedError, refused
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.environment import Headings
from catopt.loads.sinker import SinkerSize
from catopt.model import Case, Line, Segment
from catopt.progress import expect
from catopt.sizing.answer import worn_name
from catopt.sizing.in_motion import (
    Counted,
    InMotion,
    LineTried,
    NoLineInMotionError,
    RunsAfloat,
    Sea,
    in_sea,
    sea_of,
    tightest_seas,
)
from catopt.sizing.line_choice import sold
from catopt.sizing.motion_judged import (
    JudgedLine,
    ShipLost,
    ShipRun,
    ShipState,
    in_load_case,
    offset_of_lost,
    size_of,
    storm_of,
)
from catopt.sizing.pattern import DragGround, Pattern
from catopt.sizing.quick import NEAR, lines_of
from catopt.sizing.settle import ConvergedSizing, best_of
from catopt.sizing.ship_afloat import MOTION_CODE, runs_afloat, ship_afloat
from catopt.sizing.ship_band import band_of, basis_of
from catopt.sizing.tanker_request import TankerRequest
from catopt.ties import largest
from catopt.verify.convergence_check import LIMIT
from catopt.verify.ship_result import few_cycles, slow_cycles
from catopt.verify.two_scales import (
    change_at_half_step,
    check_hanging,
    hardest_run,
    run_without,
    verify_ship,
    with_proof,
)
from catopt.words import Message

_MOST_FACTOR: Final = 100.0
"""Allowance for motion beyond which no line is sized."""
_RISE: Final = 1.05
"""By which the allowance rises at least where the line that it gives fails."""
_LEAP: Final = 4.0
"""By which it rises at most: a line that is nearly taut moves harder than the next one will."""
_HOUR: Final = 0.25
"""s, about, that an hour of a ship on a line takes to run."""
_LEAST_SCOPE: Final = 6.0
"""Of a line that is laid, in depths at high water: what UR A1 takes for her own anchors (C)."""
_MOST_SCOPES: Final = (16.0, 24.0)
"""Likewise, before the size rises: catopt's own."""
_SAME_SIZE: Final = 5e-4
_LINES: Final = 8
"""Lines that a search runs, about: for its announcement."""

Settle = Callable[[TankerRequest], ConvergedSizing]
Around = Callable[[TankerRequest, ConvergedSizing], Pattern | None]


class ShipMoved(NamedTuple):
    """The line that a sizing recommends in motion, with what holds it."""

    settled: ConvergedSizing
    around: Pattern | None
    in_motion: InMotion
    drag_anchor: DragAnchorSize | None
    sinker: SinkerSize | None
    # load case of the largest span in motion, of several lines offset with one lost, and that, m
    span: tuple[str, float]


def search_ship_in_motion(
    request: TankerRequest, start: ConvergedSizing, settle: Settle, around: Around
) -> ShipMoved:
    """Find a line that passes in motion, the next shorter and thinner of which do not.

    `start` is what is recommended at rest; `settle` sizes for a request, and `around` solves the
    equilibrium of its lines. InputError: the ship cannot be run. NoLineInMotionError: no line that
    was sized for its runs passes them.
    """
    how = request.in_motion
    assert how is not None
    if not runs_afloat(request):
        allowed = Message("refused.no_ship_afloat")
        raise refused("in_motion", "true", allowed, "TankerRequest")
    states = len(start.posed.loads) * max(1, len(how.periods))
    states *= len(request.weathervaning.directions)
    hours = _LINES * how.seeds * how.duration / 3600.0 * states * request.lines
    if not how.quick:
        expect(Message("sizing.running_ship"), _HOUR * hours)
    found = _Search(request, how, start, settle, around)
    laid = request.line.looks_for == "practice" and request.lines == 1
    passing = found.laid(start.point.line) if laid else None
    if passing is not None:
        return _moved(request, how, found, passing)
    if laid:
        found.prefer_lightest()
    passing = found.passing(start.point.line)
    if passing is None:
        every = found.judged.values()
        nearest = [each for each in every if each.tried.runs] or every
        raise NoLineInMotionError([(each.line, each.tried) for each in nearest], _counted(found))
    return _moved(request, how, found, found.best(passing))


class _Search:
    """Lines that were tried."""

    def __init__(
        self,
        request: TankerRequest,
        how: RunsAfloat,
        start: ConvergedSizing,
        settle: Settle,
        around: Around,
    ) -> None:
        self.request, self.how = request, how
        self._settle, self._around = settle, around
        self.judged: dict[Line, JudgedLine] = {}
        self._settled: dict[Line, ConvergedSizing] = {}
        # By load case and directions, with tables that their lines share.
        self._ships: dict[tuple[str, Headings, bool], Any] = {}
        self._run_on = lines_of(how, request.environment.sea.hs)
        # The one that stopped the last line first.
        outs = (True, False) if request.lines > 1 else (False,)
        wears = start.posed.case.service is not None
        self.own: LineTried | None = None
        env = request.environment
        # A current turns a ship the more, the less wind there is to hold her head to it.
        lulls = request.lines == 1 and env.current.speed > 0.0 and env.wind.speed > 0.0
        ways = [(False, False), *([(True, False)] * wears), *([(False, True)] * lulls)]
        self._order = [
            ShipState(each.load_case, sea, directions, out, worn, lull)
            for worn, lull in ways
            for out in outs
            for directions in request.weathervaning.directions
            for sea in how.seas(env.sea.hs, env.sea.period)
            for each in start.posed.loads
        ]
        design = start.posed.case.design
        assert design is not None
        self.lengths = design.segments[0].lengths
        self._sizes = sold(request.line, request.environment.water_density)
        own = request.line
        is_for_motion = all(each.is_for_motion for each in profiles_of(own.checks))
        code = own.code if is_for_motion else MOTION_CODE
        self._line = replace(own, code=code, prefer=own.looks_for)
        self._without_allowance = replace(request, line=replace(own, dynamic_factor=1.0))

    def prefer_lightest(self) -> None:
        """Look for the lightest from now on: where nothing that is laid holds."""
        self.request = replace(self.request, line=self.request.line.by("lightest"))
        self._line = self._line.by("lightest")

    # ------------------------------------------------------------------ lines

    def laid(self, line: Line) -> JudgedLine | None:
        """Find the line that would be laid: no thinner than her own cable, by rule as short.

        The thinnest that passes at sixteen depths or at twenty-four, and of that the shortest from
        six on, taken that what is longer passes: harder weather then asks for no thinner one. None
        where none does: then the lightest.
        """
        (segment,) = line.segments
        sizes = sorted((e for e in self._sizes if e.component == segment.component), key=size_of)
        own = self.request.own_cable
        sizes = [each for each in sizes if size_of(each) >= own - _SAME_SIZE] or sizes[-1:]
        depth = self.request.environment.levels.high
        shortest = _LEAST_SCOPE * depth
        lengths = [e for e in self.lengths if e >= shortest] or list(self.lengths[-1:])
        scopes = [sum(e <= most * depth for e in lengths) or 1 for most in _MOST_SCOPES]

        def judged(each: Segment, length: float) -> JudgedLine:
            return self.tried(replace(line, segments=(replace(each, length=length),)))

        def least(count: int, passes: Callable[[int], bool]) -> int:
            """Count those that fail before the first that passes: all of them where none does."""
            low, high = 0, count
            while low < high:
                middle = 0 if not low and high == count else (low + high) // 2
                low, high = (low, middle) if passes(middle) else (middle + 1, high)
            return low

        self.own = judged(sizes[0], lengths[scopes[0] - 1]).tried
        holds = (
            (k, count)
            for k, each in enumerate(sizes)
            for count in dict.fromkeys(scopes)
            if judged(each, lengths[count - 1]).tried.passes
        )
        found = next(holds, None)
        if found is None:
            return None
        at, count = found
        place = least(count, lambda k: judged(sizes[at], lengths[k]).tried.passes)
        length = lengths[min(place, count - 1)]
        if at:
            judged(sizes[at - 1], length)
        return judged(sizes[at], length)

    def passing(self, line: Line) -> JudgedLine | None:
        """Size lines for what the runs of the one before ask for, until one passes its own."""
        factor = 1.0
        while True:
            judged = self.tried(line)
            if judged.tried.passes:
                return judged
            if factor >= _MOST_FACTOR:
                return self._longer(line)
            needed = judged.factor if judged.tried.runs else 0.0
            low, factor = factor, min(max(needed, _RISE * factor), _LEAP * factor, _MOST_FACTOR)
            sized = self._sized(factor)
            while sized in self.judged and factor < _MOST_FACTOR:
                factor = min(_RISE * factor, _MOST_FACTOR)
                sized = self._sized(factor)
            # Another line than the one before may move less: what can be sized for is tried.
            while sized is None and factor > _RISE * low:
                factor = 0.5 * (low + factor)
                sized = self._sized(factor)
            if sized is None or sized in self.judged:
                return self._longer(judged.line)
            line = sized

    def _longer(self, line: Line) -> JudgedLine | None:
        """Run ever longer lines of the thickest size, where nothing can be sized for the runs."""
        (segment,) = line.segments
        thickest = self._thickest(segment.component)
        lengths = [each for each in self.lengths if each >= segment.length * (1.0 - 1e-9)]
        at, leap = 0, 1
        while lengths:
            own = replace(thickest, length=lengths[at])
            judged = self.tried(replace(line, segments=(own,)))
            if judged.tried.passes or at == len(lengths) - 1:
                return judged if judged.tried.passes else None
            at, leap = min(at + leap, len(lengths) - 1), 2 * leap
        return None

    def best(self, passing: JudgedLine) -> JudgedLine:
        """Run less, then thinner lines that are longer and thicker ones that are shorter.

        Until none of these that passes is preferred.
        """
        passing = self.lessened(passing)
        while True:
            before = passing
            for lines in self._exchanged(before.line):
                better = tuple(each for each in lines if self._is_better(each, passing))
                passing = self._last_of(better, passing)
                if passing is not before:
                    passing = self.lessened(passing)
                    break
            if passing is before:
                return passing

    def lessened(self, passing: JudgedLine) -> JudgedLine:
        """Run shorter and thinner lines as long as they pass and are preferred.

        In the end the next shorter and the next thinner one were both run, and are no better.
        """
        while True:
            before = passing
            for less in (self._shorter, self._thinner):
                passing = self._last_of(tuple(less(passing.line)), passing)
            if passing is before:
                return passing

    def _last_of(self, lines: tuple[Line, ...], passing: JudgedLine) -> JudgedLine:
        """Find the last of lines, each less than the one before, that passes and is preferred.

        Steps double as long as they do, and are halved from the first that does not: taken that a
        line fails between two that fail. The one after the last was run.
        """
        at, leap, end = -1, 1, len(lines)
        while at + 1 < end:
            place = min(at + leap, end - 1)
            judged = self.tried(lines[place])
            if judged.tried.passes and self._is_better(judged.line, passing):
                passing, at, leap = judged, place, 2 * leap
            else:
                end, leap = place, max(1, (place - at) // 2)
        return passing

    def _sized(self, factor: float) -> Line | None:
        """Size a line at rest for an allowance for motion; None where none passes."""
        line = replace(self._line, run_factor=factor)
        try:
            return self._settle(replace(self.request, line=line)).point.line
        except NoAnswerError:
            return None

    def _shorter(self, line: Line) -> Iterator[Line]:
        """Yield shorter lines of its size, the longest first."""
        (segment,) = line.segments
        for each in reversed(self.lengths):
            if each < segment.length * (1.0 - 1e-9):
                yield replace(line, segments=(replace(segment, length=each),))

    def _thinner(self, line: Line) -> Iterator[Line]:
        """Yield thinner lines of its length, the thickest first; the fast search the next few."""
        (segment,) = line.segments
        least = NEAR * size_of(segment) if self.how.quick else 0.0
        for each in sorted(self._sizes, key=size_of, reverse=True):
            if each.component == segment.component and least <= size_of(each) < size_of(segment):
                yield replace(line, segments=(replace(each, length=segment.length),))

    def _thickest(self, component: str) -> Segment:
        return max((each for each in self._sizes if each.component == component), key=size_of)

    def _exchanged(self, line: Line) -> Iterator[tuple[Line, ...]]:
        """Yield lines a step or two longer, from the thickest of the thinner ones on; then shorter.

        Of those the thickest alone: it is the likeliest to pass.
        """
        (segment,) = line.segments
        lengths = [round(each, 9) for each in self.lengths]
        at = lengths.index(round(segment.length, 9))
        for place in (at + 1, at + 2, at - 1, at - 2):
            if not 0 <= place < len(lengths):
                continue
            of_length = replace(line, segments=(replace(segment, length=self.lengths[place]),))
            if place > at:
                yield tuple(self._thinner(of_length))
                continue
            thickest = self._thickest(segment.component)
            if size_of(thickest) > size_of(segment):
                cut = replace(thickest, length=self.lengths[place])
                yield (replace(line, segments=(cut,)),)

    def failing_below(self, line: Line) -> Iterator[LineTried]:
        """Yield the next shorter and the next thinner line, where they fail."""
        for less in (self._shorter, self._thinner):
            judged = self.judged.get(next(less(line), line))
            if judged is not None and not judged.tried.passes:
                yield judged.tried

    def _is_better(self, line: Line, than: JudgedLine) -> bool:
        """Whether a line passes at rest and is preferred."""
        assert than.settled is not None
        try:
            own = self._at_rest(line).point
        except NoAnswerError:
            return False
        return best_of([own, than.settled.point], self.request.line) is own

    # ------------------------------------------------------------------ one line

    def tried(self, line: Line) -> JudgedLine:
        """Run a line in every load case; those after one that fails are left out."""
        if line not in self.judged:
            self.judged[line] = self._run(line)
        return self.judged[line]

    def _at_rest(self, line: Line) -> ConvergedSizing:
        """Settle a line, once, without an allowance for motion; NoAnswerError where it fails."""
        if line not in self._settled:
            (segment,), weights = line.segments, line.point_loads
            assert segment.nominal_diameter is not None
            only = self.request.line.only(segment.component, segment.nominal_diameter)
            own = replace(
                self.request,
                line=replace(only, dynamic_factor=1.0, length=segment.length),
                clump_masses=tuple(each.mass for each in weights if each.mass is not None),
                clump_places=tuple(each.position for each in weights),
            )
            self._settled[line] = self._settle(own)
        return self._settled[line]

    def _run(self, line: Line) -> JudgedLine:
        try:
            settled = self._at_rest(line)
            around = self._around(self._without_allowance, settled)
        except NoFeasibleDesignError as error:
            failing = () if error.near_miss is None else error.near_miss.failing
            reason = "" if failing else error.message
            return JudgedLine(LineTried.of(line, 0, failing, reason), line)
        except NoAnswerError as error:
            return JudgedLine(LineTried.of(line, 0, (), error.message), line)
        judged = JudgedLine(LineTried.of(line, 0, ()), line, settled, around)
        for state in tuple(self._order):
            try:
                if state.line_out:
                    assert around is not None
                    lost = self._without_line(state, settled, around)
                    judged = self._held(replace(judged, lost=(*judged.lost, lost)))
                else:
                    run = self._in_state(state, settled, around)
                    judged = self._held(replace(judged, runs=(*judged.runs, run)))
            except (NoAnswerError, NotConvergedError) as error:
                count = judged.tried.runs + self.how.seeds
                judged = replace(judged, tried=LineTried.of(line, count, (), error.message))
            if not judged.tried.passes:
                self._order.remove(state)
                self._order.insert(0, state)
                break
        return judged

    def _in_state(
        self, state: ShipState, settled: ConvergedSizing, around: Pattern | None
    ) -> ShipRun:
        name, said = state.load_case, self._said(state)
        case = self._afloat(state, settled, around)
        weather = (name, state.directions, state.lull)
        ship, judged = self._ships.get(weather), self._as_judged(case)
        found = verify_ship(judged, ship=ship, proven=False, **self._run_on)
        ship = self._ships[weather] = found.moored.ship
        offset = max(found.offset.judged, offset_of_lost(found.lost))
        if around is None:
            at_rest, without = dict(settled.point.checks.solutions)[name], 0.0
        else:
            rest = around.state_in(name)
            lines = (each.solution for each in rest.solution.lines)
            at_rest = largest(list(lines), lambda each: each.fairlead.tension)
            without = rest.line_out.line_force
        lost = ShipLost(said, case, found.lost, without, offset)
        return ShipRun(
            said,
            case,
            found.lines,
            found.hanging,
            found.most_loaded,
            at_rest,
            lost,
            state.worn,
            slow_cycles(found.runs, found.rest),
            partial(change_at_half_step, case, hardest_run(found.runs), ship=ship, **self._run_on),
        )

    def _without_line(
        self, state: ShipState, settled: ConvergedSizing, around: Pattern
    ) -> ShipLost:
        """Run it without line 1, in weather from the side that is then hardest at rest."""
        name, said = state.load_case, self._said(state)
        case = self._afloat(state, settled, around)
        weather = (name, state.directions, state.lull)
        ship = self._ships.get(weather)
        found, moored = run_without(self._as_judged(case), 1, ship=ship, **self._run_on)
        self._ships[weather] = moored.ship
        without = around.state_in(name).line_out.line_force
        return ShipLost(said, case, (found,), without, offset_of_lost((found,)))

    def _said(self, state: ShipState) -> str:
        """Name a load case with its sea and directions, where there are several."""
        name = worn_name(state.load_case) if state.worn else state.load_case
        if state.lull:
            name = Message("sizing.in_a_lull", load_case=name)
        said = in_sea(name, self.how, state.sea)
        if len(self.request.weathervaning.directions) == 1:
            return said
        angles = {key: math.degrees(angle) for key, angle in vars(state.directions).items()}
        return Message("sizing.from_directions", load_case=said, **angles)

    def _afloat(self, state: ShipState, settled: ConvergedSizing, around: Pattern | None) -> Case:
        case = ship_afloat(self.request, settled, around, **state._asdict())
        assert case is not None
        return case

    def _as_judged(self, case: Case) -> Case:
        assert case.dynamics is not None
        return replace(case, dynamics=replace(case.dynamics, judged_by=self.how.judged_by))

    def _held(self, judged: JudgedLine) -> JudgedLine:
        """Size what holds the line for its runs, and check it; NoAnswerError: nothing does."""
        settled, ground = judged.settled, self.request.ground
        assert settled is not None
        anchor, size, sinker = settled.point.anchor, None, None
        every = (*judged.lost, *(each.lost for each in judged.runs))
        hanging = [solution for each in judged.runs for solution in each.every]
        hanging += [solution for of in every for each in of.lost for solution in each.hanging]
        pulls = [solution.anchor for solution in hanging]
        if isinstance(ground, DragGround):
            pull = max((each.horizontal_force for each in pulls), default=0.0)
            least = max(each.horizontal_force for each in settled.posed.loads)
            size = ground.sized(max(pull, self.request.line.allowance * least / self.request.lines))
            anchor = ground.held(size)
        else:
            sinker = ground.sized_for(pulls, self.request.environment.water_density)
            if anchor is not None and sinker.mass > (anchor.mass or 0.0):
                weight = sinker.submerged_weight
                anchor = replace(anchor, mass=sinker.mass, submerged_weight=weight)
        results: list[CheckResult] = []
        of_sea: list[Sea] = []
        warnings: dict[str, None] = {}
        reports = (
            *((each.lost, each.every) for each in judged.runs),
            *((each, ()) for each in judged.lost),
        )
        for of, intact in reports:
            report = check_hanging(replace(of.case, anchor=anchor), intact, of.lost)
            results += (in_load_case(one, of.load_case) for one in report.results)
            of_sea += [sea_of(of.case)] * len(report.results)
            warnings |= dict.fromkeys(report.warnings)
            whole = of.case
        failing = sorted((e for e in results if not e.passes), key=lambda check: -check.exceedance)
        sets = len(judged.runs) + sum(len(each.lost) for each in every)
        tried = LineTried.of(judged.line, sets * self.how.seeds, tuple(failing))
        if judged.runs:  # of the load case that has seen the fewest
            warnings |= dict.fromkeys(few_cycles(min(each.cycles for each in judged.runs)))
        checks = CheckReport(
            settled.case.title,
            tuple(results),
            (),
            tuple(warnings),
            case=whole,
            is_in_motion=True,
        )
        held = replace(judged, anchor=anchor, drag_anchor=size, sinker=sinker)
        seas = tightest_seas(zip(results, of_sea, strict=True)) if self.how.periods else ()
        return replace(held, tried=tried, checks=checks, seas=seas)


# ------------------------------------------------------------------ the answer


def _counted(found: _Search) -> Counted:
    run = [each.tried for each in found.judged.values() if each.tried.runs]
    considered = len(found._sizes) * len(found.lengths)
    return Counted(
        considered, None, considered - len(run), len(run), sum(each.runs for each in run)
    )


def _moved(
    request: TankerRequest, how: RunsAfloat, found: _Search, chosen: JudgedLine
) -> ShipMoved:
    assert chosen.settled is not None
    assert chosen.checks is not None
    as_laid = [each for each in chosen.runs if not each.worn]
    hardest = largest(as_laid, lambda each: each.hanging.fairlead.tension)
    case = replace(hardest.case, anchor=chosen.anchor)
    assert hardest.at_half_step is not None
    change = hardest.at_half_step()
    settled = chosen.settled
    still = check_case(replace(settled.case, anchor=chosen.anchor, design=None))
    point = replace(settled.point, anchor=chosen.anchor, checks=still)
    if chosen.around is None:
        ways = [(each.load_case, each.hanging.span) for each in chosen.runs]
    else:
        every = (*chosen.lost, *(each.lost for each in chosen.runs))
        ways = [(each.load_case, each.offset) for each in every]
    return ShipMoved(
        replace(settled, point=point, choice=request.line),
        chosen.around,
        InMotion(
            how,
            case,
            with_proof(chosen.checks, change),
            storm_of(chosen),
            request.line.allowance,
            _counted(found),
            tuple(each.tried for each in found.judged.values()),
            load_cases=len({(each.load_case, each.worn, each.lull) for each in found._order}),
            directions=len(request.weathervaning.directions),
            seas=chosen.seas,
            less=tuple(found.failing_below(chosen.line)),
            basis=basis_of(case),
            band=band_of(case),
            own=found.own,
            proof="converged" if change.size <= LIMIT else "not converged",
            changes=(change,),
        ),
        chosen.drag_anchor,
        chosen.sinker,
        largest(ways, itemgetter(1)),
    )
