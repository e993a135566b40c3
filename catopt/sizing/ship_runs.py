"""Lines run with their ship in every load case, and what holds them sized for that."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from operator import itemgetter
from typing import Any, Final

from catopt.checks.result import CheckReport, CheckResult
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.largest import largest
from catopt.loads.environment import Headings
from catopt.model import Case, Line
from catopt.progress import watcher
from catopt.sizing.answer import worn_name
from catopt.sizing.converge import ConvergedSizing
from catopt.sizing.in_motion import LineTried, RunsAfloat, Sea, in_sea, sea_of, tightest_seas
from catopt.sizing.motion_verdicts import (
    JudgedLine,
    ShipLost,
    ShipRun,
    ShipState,
    in_load_case,
    offset_of_lost,
)
from catopt.sizing.pattern import DragGround, Pattern
from catopt.sizing.quick import lines_of
from catopt.sizing.ship_afloat import ship_afloat
from catopt.sizing.tanker_request import TankerRequest
from catopt.verify.ship_result import few_cycles, slow_cycles
from catopt.verify.two_scales import (
    change_at_half_step,
    check_hanging,
    hardest_run,
    run_without,
    verify_ship,
)
from catopt.words import Message

LINES: Final = 8
"""Lines that a search runs, about: for its announcement."""
_HARD: Final = 3
"""Load cases in which it compares them, about."""

Settle = Callable[[TankerRequest], ConvergedSizing]
Around = Callable[[TankerRequest, ConvergedSizing], Pattern | None]


class ShipRuns:
    """Lines that were run."""

    def __init__(
        self,
        request: TankerRequest,
        how: RunsAfloat,
        start: ConvergedSizing,
        settle: Settle,
        around: Around,
    ) -> None:
        self.request, self.how, self.start = request, how, start
        self._settle, self._around = settle, around
        self.judged: dict[Line, JudgedLine] = {}
        self._settled: dict[Line, ConvergedSizing] = {}
        # By load case and directions, with tables that their lines share.
        self._ships: dict[tuple[str, Headings, bool], Any] = {}
        self.run_on = lines_of(how, request.environment.sea.hs)
        # The one that stopped the last line first.
        outs = (True, False) if request.lines > 1 else (False,)
        wears = start.posed.case.service is not None
        env = request.environment
        # A current turns a ship the more, the less wind there is to hold her head to it.
        lulls = request.lines == 1 and env.current.speed > 0.0 and env.wind.speed > 0.0
        ways = [(False, False), *([(True, False)] * wears), *([(False, True)] * lulls)]
        self.order = [
            ShipState(each.load_case, sea, directions, out, worn, lull)
            for worn, lull in ways
            for out in outs
            for directions in request.weathervaning.directions
            for sea in how.seas(env.sea.hs, env.sea.period)
            for each in start.posed.loads
        ]
        # Those in which lines are compared: that have stopped one, or are hardest on one.
        self._hard: set[ShipState] = set()
        laid = replace(request.line, dynamic_factor=1.0)
        self._without_allowance = replace(request, line=laid)

    def tried(self, line: Line) -> JudgedLine:
        """Run a line in every load case that is hard; in all until one is known to be.

        Those after one that fails are left out.
        """
        if line not in self.judged:
            self.judged[line] = self._settled_line(line)
        hard = [each for each in self.order if each in self._hard]
        self.judged[line] = self._run(self.judged[line], hard or self.order)
        return self.judged[line]

    def whole(self, judged: JudgedLine) -> JudgedLine:
        """Run a line in the load cases that are left."""
        whole = self.judged[judged.line] = self._run(judged, self.order)
        if whole.tried.passes:
            own = [each for each in whole.done if not each.line_out]
            tensions = [each.line.judged("most-probable") for each in whole.runs]
            rising = sorted(zip(tensions, own, strict=True), key=itemgetter(0))
            self._hard.update({each.load_case: each for _, each in rising}.values())
        return whole

    def at_rest(self, line: Line) -> ConvergedSizing:
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

    def _settled_line(self, line: Line) -> JudgedLine:
        try:
            settled = self.at_rest(line)
            around = self._around(self._without_allowance, settled)
        except NoFeasibleDesignError as error:
            failing = () if error.near_miss is None else error.near_miss.failing
            reason = "" if failing else error.message
            return JudgedLine(LineTried.of(line, 0, failing, reason), line)
        except NoAnswerError as error:
            return JudgedLine(LineTried.of(line, 0, (), error.message), line)
        return JudgedLine(LineTried.of(line, 0, ()), line, settled, around)

    def _run(self, judged: JudgedLine, states: Sequence[ShipState]) -> JudgedLine:
        """Run a line that passes so far in those of some load cases that it was not run in."""
        settled, around = judged.settled, judged.around
        for state in tuple(states):
            if state in judged.done or not judged.tried.passes:
                continue
            assert settled is not None
            self._tell()
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
                tried = LineTried.of(judged.line, count, (), error.message)
                judged = replace(judged, tried=tried)
            judged = replace(judged, done=(*judged.done, state))
            if not judged.tried.passes:
                self._hard.add(state)
                self.order.remove(state)
                self.order.insert(0, state)
        return judged

    def _tell(self) -> None:
        done = sum(len(each.done) for each in self.judged.values())
        usual = LINES * min(_HARD, len(self.order)) + len(self.order)
        watcher()(done, max(usual, done + 1))

    def _in_state(
        self, state: ShipState, settled: ConvergedSizing, around: Pattern | None
    ) -> ShipRun:
        name, said = state.load_case, self._said(state)
        case = self._afloat(state, settled, around)
        weather = (name, state.directions, state.lull)
        ship, judged = self._ships.get(weather), self._as_judged(case)
        found = verify_ship(judged, ship=ship, proven=False, **self.run_on)
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
            partial(change_at_half_step, case, hardest_run(found.runs), ship=ship, **self.run_on),
        )

    def _without_line(
        self, state: ShipState, settled: ConvergedSizing, around: Pattern
    ) -> ShipLost:
        """Run it without line 1, in weather from the side that is then hardest at rest."""
        name, said = state.load_case, self._said(state)
        case = self._afloat(state, settled, around)
        weather = (name, state.directions, state.lull)
        ship = self._ships.get(weather)
        found, moored = run_without(self._as_judged(case), 1, ship=ship, **self.run_on)
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
