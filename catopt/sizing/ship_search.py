"""Which line holds its ship in motion: sized for what the runs of lines say, until one passes.

A line is sized at rest, run with the ship in every load case, and sized anew for an allowance for
motion that is the runs' own, by the factors of the code that judges lines in motion, until what is
sized passes its runs. From there shorter lines and thinner ones are run as long as they pass and
are preferred, and lines that are both thinner and longer, or thicker and shorter: what is
recommended is the last that passes, and the next shorter and the next thinner line were run, too.
What holds the line is sized for its runs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cached_property
from operator import itemgetter
from typing import Final, NamedTuple

from catopt.checks.case import check_case
from catopt.checks.profiles import profiles_of
from catopt.errors import NoAnswerError, refused
from catopt.largest import largest
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.sinker import SinkerSize
from catopt.model import Line, Segment
from catopt.progress import expect
from catopt.sizing.converge import ConvergedSizing, best_of
from catopt.sizing.in_motion import (
    Counted,
    InMotion,
    LineTried,
    NoLineInMotionError,
    RunsAfloat,
)
from catopt.sizing.line_choice import LineChoice, sold
from catopt.sizing.motion_verdicts import JudgedLine, size_of, storm_of
from catopt.sizing.pattern import Pattern
from catopt.sizing.quick import NEAR
from catopt.sizing.ship_afloat import MOTION_CODE, runs_afloat
from catopt.sizing.ship_band import band_of, basis_of
from catopt.sizing.ship_runs import LINES, Around, Settle, ShipRuns
from catopt.sizing.tanker_request import TankerRequest
from catopt.verify.convergence_check import LIMIT
from catopt.verify.two_scales import with_proof
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
    hours = LINES * how.seeds * how.duration / 3600.0 * states * request.lines
    if not how.quick:
        expect(Message("sizing.running_ship"), _HOUR * hours)
    found = _Search(request, how, start, settle, around)
    chosen = found.recommended(start.point.line)
    if chosen is None:
        every = found.judged.values()
        nearest = [each for each in every if each.tried.runs] or every
        raise NoLineInMotionError([(each.line, each.tried) for each in nearest], _counted(found))
    return _moved(request, how, found, chosen)


class _Search(ShipRuns):
    """Lines that are tried, and which is recommended."""

    own: LineTried | None = None
    """Her own cable, once it was run."""

    @cached_property
    def lengths(self) -> tuple[float, ...]:
        """That a line may have, m."""
        design = self.start.posed.case.design
        assert design is not None
        return design.segments[0].lengths

    @cached_property
    def sizes(self) -> tuple[Segment, ...]:
        """A metre of each that is sold."""
        return sold(self.request.line, self.request.environment.water_density)

    @property
    def _line(self) -> LineChoice:
        """What is chosen from for an allowance for motion: by a code that judges lines in it."""
        own = self.request.line
        is_for_motion = all(each.is_for_motion for each in profiles_of(own.checks))
        code = own.code if is_for_motion else MOTION_CODE
        return replace(own, code=code, prefer=own.looks_for)

    def prefer_lightest(self) -> None:
        """Look for the lightest from now on: where nothing that is laid holds."""
        self.request = replace(self.request, line=self.request.line.by("lightest"))

    # ------------------------------------------------------------------ lines

    def recommended(self, line: Line) -> JudgedLine | None:
        """Find a line that passes in every load case, starting from the one at rest; None: none.

        Lines are compared in those load cases that have stopped one, or are hardest on the first
        that passes in all. What is found is run in the others, too; if one of these stops it,
        lines are compared in that as well.
        """
        if self.request.line.looks_for == "practice" and self.request.lines == 1:
            while (passing := self.laid(line)) is not None:
                if self.whole(passing).tried.passes:
                    return self.judged[passing.line]
            self.prefer_lightest()
        found = self.passing(line)
        while found is not None:
            whole = self.whole(self.best(found))
            if whole.tried.passes:
                return whole
            found = self._passing_still() or self.passing(whole.line)
        return None

    def _passing_still(self) -> JudgedLine | None:
        """Find the preferred of the lines that passed and do so in what stops one by now."""
        lines = [each.line for each in self.judged.values() if each.tried.passes]
        while lines:
            points = [self.at_rest(each).point for each in lines]
            at = points.index(best_of(points, self.request.line))
            judged = self.tried(lines.pop(at))
            if judged.tried.passes:
                return judged
        return None

    def laid(self, line: Line) -> JudgedLine | None:
        """Find the line that would be laid: no thinner than her own cable, by rule as short.

        The thinnest that passes at sixteen depths or at twenty-four, and of that the shortest from
        six on, taken that what is longer passes: harder weather then asks for no thinner one. None
        where none does: then the lightest.
        """
        (segment,) = line.segments
        sizes = sorted((e for e in self.sizes if e.component == segment.component), key=size_of)
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
            judged = self.whole(self.tried(line))
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
            judged = self.whole(self.tried(replace(line, segments=(own,))))
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
        for each in sorted(self.sizes, key=size_of, reverse=True):
            if each.component == segment.component and least <= size_of(each) < size_of(segment):
                yield replace(line, segments=(replace(each, length=segment.length),))

    def _thickest(self, component: str) -> Segment:
        return max((each for each in self.sizes if each.component == component), key=size_of)

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
            own = self.at_rest(line).point
        except NoAnswerError:
            return False
        return best_of([own, than.settled.point], self.request.line) is own


# ------------------------------------------------------------------ the answer


def _counted(found: _Search) -> Counted:
    run = [each.tried for each in found.judged.values() if each.tried.runs]
    considered = len(found.sizes) * len(found.lengths)
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
            load_cases=len({(each.load_case, each.worn, each.lull) for each in found.order}),
            directions=len(request.weathervaning.directions),
            seas=chosen.seas,
            less=tuple(found.failing_below(chosen.line)),
            basis=basis_of(case),
            band=band_of(case, **found.run_on),
            own=found.own,
            proof="converged" if change.size <= LIMIT else "not converged",
            changes=(change,),
        ),
        chosen.drag_anchor,
        chosen.sinker,
        largest(ways, itemgetter(1)),
    )
