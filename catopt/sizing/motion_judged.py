"""What runs of a line afloat came to: checked in every sea, its sinker sized by them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from catopt.catenary.solution import Solution
from catopt.checks.case import check_case
from catopt.checks.result import CheckReport, CheckResult
from catopt.design.evaluation import sinker_of
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.model import Anchor, Case
from catopt.sizing.in_motion import (
    LineTried,
    RunsAfloat,
    Sea,
    TightestSea,
    in_sea,
    sea_of,
    tightest_seas,
)
from catopt.sizing.settle import ConvergedSizing
from catopt.verify.dynamic_result import DynamicPart
from catopt.verify.judged import check_parts, judged_as, solutions_at_rest, way_of
from catopt.words import Message

_ROLL, _PITCH = 3, 4
"""Rows of the extremes of a hull."""
_TURNED_OVER: Final = 0.5 * math.pi
"""Heel of a buoy from which it has turned over, rad."""

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


def judged(
    settled: ConvergedSizing,
    seas: Sequence[Case],
    found: Sequence[DynamicPart | NoAnswer],
    how: RunsAfloat,
) -> Judged:
    """Check the runs of a line in every sea, one after the other, whose sinker is sized."""
    case = seas[0]
    line = settled.point.line
    runs = sum(len(each.runs) if isinstance(each, DynamicPart) else 1 for each in found)
    failed = [each for each in found if not isinstance(each, DynamicPart)]
    if failed:
        return Judged(LineTried.of(line, runs, (), failed[0].message), settled, case)
    assert case.dynamics is not None
    parts = tuple(judged_as(each, case.dynamics) for each in found if isinstance(each, DynamicPart))
    heel = largest_heel(parts)
    if heel >= _TURNED_OVER:
        reason = Message("sizing.turns_over", heel=math.degrees(heel))
        return Judged(LineTried.of(line, runs, (), reason), settled, case, parts)
    solved = solutions_at_rest(case, parts)
    at_rest = tuple(each for each in solved if each is not None)
    checked: tuple[CheckReport, tuple[Sea, ...]] | None = None
    anchor = case.anchor
    if parts[0].drive.sinkers:
        anchor = _least_that_stays(parts)
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
    count = len(parts) // len(seas)
    results: list[CheckResult] = []
    of_sea: list[Sea] = []
    warnings: dict[str, None] = {}
    for k, case in enumerate(seas):
        own = slice(k * count, (k + 1) * count)
        report, sea = check_parts(case, parts[own], at_rest[own]), sea_of(case)
        for each in report.results:
            results.append(replace(each, load_case=in_sea(each.load_case, how, sea)))
            of_sea.append(sea)
        warnings |= dict.fromkeys(report.warnings)
    return CheckReport(seas[0].title, tuple(results), (), tuple(warnings)), tuple(of_sea)


def _least_that_stays(parts: Sequence[DynamicPart]) -> Anchor:
    """Take the least sinker that slides no further than it may; the heaviest where none does."""
    every = parts[0].drive.sinkers
    stays = (
        each
        for each in every
        if all(way_of(each, part, part.runs) <= (each.max_slide or 0.0) for part in parts)
    )
    return next(stays, every[-1])


def _held(settled: ConvergedSizing, checks: CheckReport) -> Anchor | None:
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
