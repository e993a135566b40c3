"""What runs of a line with a buoy, or of a ship on a line, came to, and their checks."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final, NamedTuple

from catopt.catenary.solution import Solution
from catopt.checks.case import check_case
from catopt.checks.result import CheckReport, CheckResult
from catopt.design.evaluation import sinker_of
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.largest import largest
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.environment import Headings
from catopt.loads.sinker import SinkerSize
from catopt.model import Anchor, Case, Line, Segment
from catopt.sizing.converge import ConvergedSizing
from catopt.sizing.in_motion import (
    LineTried,
    RunsAfloat,
    Sea,
    Storm,
    TightestSea,
    in_sea,
    sea_of,
    tightest_seas,
    with_margin,
)
from catopt.sizing.pattern import Pattern
from catopt.verify.convergence_check import Change
from catopt.verify.dynamic_result import DynamicPart, Verdict, worst_verdict
from catopt.verify.ship_result import LineOfShip, ShipWithoutLine
from catopt.verify.verdicts import check_parts, solutions_at_rest, way_of, with_settings
from catopt.words import Message

_ROLL, _PITCH = 3, 4
"""Rows of the extremes of a hull."""
_TURNED_OVER: Final = 0.5 * math.pi
"""Heel of a buoy from which it has turned over, rad."""

_ROUNDING: Final = 1e-9

NoAnswer = NoAnswerError | NotConvergedError
"""Why a load case has none."""


@dataclass(frozen=True)
class Judged:
    """What the runs of a line came to."""

    tried: LineTried
    settled: ConvergedSizing  # with the sinker that motion asks for
    case: Case
    parts: tuple[DynamicPart, ...] = ()
    at_rest: tuple[Solution, ...] = ()
    checks: CheckReport | None = None
    seas: tuple[TightestSea, ...] = ()

    @cached_property
    def verdict(self) -> Verdict:
        """Whether its runs came to the same again, at a finer step and with more bars."""
        return worst_verdict(each.verdict for each in self.parts)


def judged(
    settled: ConvergedSizing,
    seas: Sequence[Case],
    found: Sequence[DynamicPart | NoAnswer],
    how: RunsAfloat,
) -> Judged:
    """Check the runs of a line in every sea, one after the other, whose sinker is sized."""
    case = seas[0]
    line = settled.point.line
    failed = [each for each in found if not isinstance(each, DynamicPart)]
    made = {id(run) for each in found if isinstance(each, DynamicPart) for run in each.runs}
    runs = len(made) + len(failed)
    if failed:
        return Judged(LineTried.of(line, runs, (), failed[0].message), settled, case)
    assert case.dynamics is not None
    parts = tuple(
        with_settings(each, case.dynamics) for each in found if isinstance(each, DynamicPart)
    )
    heel = largest_heel(parts)
    if heel >= _TURNED_OVER:
        reason = Message("sizing.turns_over", heel=math.degrees(heel))
        return Judged(LineTried.of(line, runs, (), reason), settled, case, parts)
    solved = solutions_at_rest(case, parts)
    at_rest = tuple(each for each in solved if each is not None)
    checked: tuple[CheckReport, tuple[Sea, ...]] | None = None
    anchor = case.anchor
    if parts[0].drive.sinkers:
        anchor = _least_that_stays(parts, how.sinker_margin)
    else:
        checked = _checked(seas, parts, solved, how)
        anchor = _held(settled, checked[0])
    if checked is None or anchor != case.anchor:
        seas = [replace(each, anchor=anchor) for each in seas]
        case = seas[0]
        checked = _checked(seas, parts, solved, how)
    checks, of_sea = checked
    if anchor is not None and anchor.mass != (settled.point.anchor or anchor).mass:
        own = replace(anchor, max_slide=None)
        still = check_case(replace(settled.case, anchor=own, design=None))
        settled = replace(settled, point=replace(settled.point, anchor=own, checks=still))
    failing = sorted(
        (each for each in checks.results if not each.passes), key=lambda each: -each.exceedance
    )
    # The sea of what governs is the one that is written, to be run again.
    if checks.governing is not None:
        governs = of_sea[checks.results.index(checks.governing)]
        case = next(each for each in seas if sea_of(each) == governs)
    tried = LineTried.of(line, runs, tuple(failing))
    every = zip(checks.results, of_sea, strict=True)
    tightest = tightest_seas(every) if how.periods else ()
    return Judged(tried, settled, case, parts, at_rest, checks, tightest)


def largest_heel(parts: Sequence[DynamicPart]) -> float:
    """Return how far a buoy heels or pitches at most, rad; 0 where there is none."""
    hulls = (run.hull for part in parts for run in part.runs if run.hull is not None)
    angles = (abs(each.extreme[row]).max() for each in hulls for row in (_ROLL, _PITCH))
    return float(max((each for each in angles if math.isfinite(each)), default=0.0))


def _checked(
    seas: Sequence[Case],
    parts: Sequence[DynamicPart],
    at_rest: Sequence[Solution | None],
    how: RunsAfloat,
) -> tuple[CheckReport, tuple[Sea, ...]]:
    """Check the load cases of every sea; with the sea of each result."""
    count, verdict = len(parts) // len(seas), worst_verdict(each.verdict for each in parts)
    results: list[CheckResult] = []
    of_sea: list[Sea] = []
    warnings: dict[str, None] = {}
    for k, case in enumerate(seas):
        own = slice(k * count, (k + 1) * count)
        report, sea = check_parts(case, parts[own], at_rest[own]), sea_of(case)
        for each in report.results:
            own_sea = replace(each, load_case=in_sea(each.load_case, how, sea))
            results.append(with_margin(own_sea, how))
            of_sea.append(sea)
        warnings |= dict.fromkeys(report.warnings)
    checks = CheckReport(
        seas[0].title,
        tuple(results),
        (),
        tuple(warnings),
        case=seas[0],
        is_in_motion=True,
        is_proven=verdict == "converged",
        is_doubted=verdict == "not converged",
    )
    return checks, tuple(of_sea)


def _least_that_stays(parts: Sequence[DynamicPart], margin: float) -> Anchor:
    """Take the least sinker that slides no further than it may; the heaviest where none does.

    `margin`: by how much heavier it is taken, for how far one slides hangs on few peaks.
    """
    every = parts[0].drive.sinkers
    stays = (
        each
        for each in every
        if all(
            way_of(each, part, runs) <= (each.max_slide or 0.0)
            for part in parts
            for _, runs in part.levels
        )
    )
    least = next(stays, every[-1])
    weight = margin * (least.submerged_weight or 0.0) * (1.0 - _ROUNDING)
    heavier = (each for each in every if (each.submerged_weight or 0.0) >= weight)
    return next(heavier, every[-1])


def _held(settled: ConvergedSizing, checks: CheckReport) -> Anchor | None:
    """Take the least sinker that does not slide in motion, no less than that at rest.

    What the line pulls does not hang on it. The heaviest where none holds.
    """
    own, case = settled.point.anchor, settled.posed.case
    needed = [each.demand for each in checks.results if each.kind == "sliding"]
    if own is None or not needed or case.design is None or case.design.sinker is None:
        return own
    choice, base = case.design.sinker, own.base_holding or math.inf
    # Of a check that the base of this one governs, what the weight has to hold is less.
    by_base = [each.demand for each in checks.results if each.capacity == base]
    weight = max(
        [*(e for e in needed if e not in by_base), *(e / choice.friction for e in by_base)]
    )
    every = [own, *(sinker_of(case, choice, k) for k in range(len(choice.masses)))]
    return next(
        (
            each
            for each in every
            if (each.submerged_weight or 0.0) >= max(weight, own.submerged_weight or 0.0)
            and (each.base_holding or math.inf) >= max(by_base, default=0.0)
        ),
        every[-1],
    )


class ShipState(NamedTuple):
    """A load case in a sea, in weather that is hardest on a line with all there, or without one.

    Its lines as they were laid, or worn; strengths are those that wear leaves in either.
    """

    load_case: str
    sea: Sea
    directions: Headings
    line_out: bool  # line 1 is out
    worn: bool = False  # lines weigh what wear leaves of them
    lull: bool = False  # the wind has dropped, the current and the waves have not


class ShipRun(NamedTuple):
    """A load case of a line that was run with all there, and without those whose loss matters."""

    load_case: str
    case: Case
    lines: tuple[LineOfShip, ...]
    every: tuple[Solution, ...]  # line under the tension that it is judged by
    most_loaded: int
    at_rest: Solution  # the most loaded line under the steady load of that load case
    lost: ShipLost
    worn: bool = False  # whether its lines weigh what wear leaves of them
    cycles: int = 0  # slow ones of all its runs
    at_half_step: Callable[[], Change] | None = None  # runs the hardest of its runs again

    @property
    def line(self) -> LineOfShip:
        """What the most loaded line carries."""
        return self.lines[self.most_loaded]

    @property
    def hanging(self) -> Solution:
        """The most loaded line under the tension that it is judged by."""
        return self.every[self.most_loaded]

    @property
    def factor(self) -> float:
        """What an allowance for motion would have to be.

        By what the runs reached, or what is most probable, where an interval of few peaks is wide.
        """
        own = asked_of(self.line, self.hanging) / self.at_rest.horizontal_force
        return max(own, self.lost.factor)


class ShipLost(NamedTuple):
    """A load case that was run without lines, one at a time."""

    load_case: str
    case: Case
    lost: tuple[ShipWithoutLine, ...]
    at_rest: float  # horizontal force of the most loaded line at rest, from its hardest side, N
    offset: float  # of the ship: the largest with one of them lost, or with all there, m

    @property
    def factor(self) -> float:
        """What an allowance for motion would have to be; infinite where one has no answer."""
        if any(each.refusal for each in self.lost):
            return math.inf
        pulls = (asked_of(e.lines[e.most_loaded], e.hanging[e.most_loaded]) for e in self.lost)
        return max((each / self.at_rest for each in pulls), default=0.0)


def asked_of(line: LineOfShip, hanging: Solution) -> float:
    """Horizontal force that a line is to be sized for, N."""
    reached = max(line.fairlead.seen, line.judged("most-probable"))
    return min(1.0, reached / hanging.fairlead.tension) * hanging.horizontal_force


@dataclass(frozen=True)
class JudgedLine:
    """What the runs of a line came to."""

    tried: LineTried
    line: Line
    settled: ConvergedSizing | None = None  # None: it fails at rest
    around: Pattern | None = None
    runs: tuple[ShipRun, ...] = ()
    lost: tuple[ShipLost, ...] = ()
    anchor: Anchor | None = None
    drag_anchor: DragAnchorSize | None = None
    sinker: SinkerSize | None = None
    checks: CheckReport | None = None
    seas: tuple[TightestSea, ...] = ()
    done: tuple[ShipState, ...] = ()

    @property
    def factor(self) -> float:
        """The largest allowance for motion of its load cases; infinite where it has no run."""
        factors = (*(each.factor for each in self.runs), *(each.factor for each in self.lost))
        return max(factors, default=math.inf)


def in_load_case(check: CheckResult, name: str) -> CheckResult:
    """Name a check by its load case, with the line that is lost there."""
    gone = check.place.missing
    if gone is not None:
        name = Message("checks.state_under", state=check.load_case, load=name)
    return replace(check, load_case=name)


def offset_of_lost(lost: tuple[ShipWithoutLine, ...]) -> float:
    """Return the largest offset of a ship without a line, m."""
    return max((each.offset.judged for each in lost if each.offset is not None), default=0.0)


def size_of(segment: Segment) -> float:
    """Return the nominal diameter of a segment, m; 0 where it has none."""
    return segment.nominal_diameter or 0.0


def storm_of(of: JudgedLine) -> Storm:
    """Find the load case of the largest tension at the fairlead, and what the storm comes to."""

    def tension(each: ShipRun) -> float:
        return each.line.judged("most-probable")

    hardest = largest(of.runs, tension)
    extreme = hardest.line.storm
    return Storm(
        hardest.load_case,
        max(one.fairlead.seen for each in of.runs for one in each.lines),
        None if extreme is None else extreme.most_probable,
        None if extreme is None else extreme.low,
        None if extreme is None else extreme.high,
        hardest.at_rest.fairlead.tension,
    )
