"""Checks of lines in motion: of what the runs came to, and whether runs again come to the same."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

import numpy as np
from scipy.special import stdtrit

from catopt.catenary.case import solve_case
from catopt.catenary.solution import Solution
from catopt.checks.case import Carried, LineInMotion, Pull, check_motion
from catopt.checks.result import CheckReport, CheckResult
from catopt.fem.extremes import taken_together
from catopt.largest import first_largest, largest
from catopt.model import Anchor, Case, Dynamics, Line
from catopt.model.network import Network
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.solution import solve_system
from catopt.verify.dynamic_result import BeyondMBL, DynamicPart
from catopt.verify.dynamic_run import DynamicRun

_ONE_SIDED: Final = 0.95
_NORMAL: Final = 1.645
"""Standard errors up to the end of an interval that holds nine tenths."""


def beyond_MBL(part: DynamicPart) -> BeyondMBL | None:
    """Find the segment that exceeds its MBL by most, whatever is checked; None where none does."""
    line = part.own_line
    over = [
        BeyondMBL(number, tension, segment.MBL)
        for number, (segment, tension) in enumerate(
            zip(line.segments, governing_tensions(part, part.runs, line), strict=True), start=1
        )
        if segment.MBL is not None and tension > segment.MBL
    ]
    return largest(over, lambda each: each.times) if over else None


def solutions_at_rest(
    case: Case | Network, parts: Sequence[DynamicPart]
) -> Sequence[Solution | None]:
    """Solve the line of every part at rest, in closed form; none on a bed that slopes."""
    if isinstance(case, Network):
        return at_rest(case).lines
    if case.site.seabed_slope != 0.0:
        return [None] * len(parts)
    if case.several_lines:
        return [each.solution for each in solve_system(case.own_system).lines]
    return [solve_case(part.drive.one) for part in parts]


def with_settings(part: DynamicPart, dynamics: Dynamics) -> DynamicPart:
    """Judge a part as other settings of its runs ask for it."""
    case = replace(part.drive.case, dynamics=dynamics)
    return replace(part, drive=replace(part.drive, case=case))


def with_more_runs(part: DynamicPart, other: DynamicPart) -> DynamicPart:
    """Put more runs of the same line in the same load case to those of a part."""
    remarks = tuple(dict.fromkeys((*part.remarks, *other.remarks)))
    return replace(part, runs=(*part.runs, *other.runs), remarks=remarks)


def check_parts(
    case: Case | Network, parts: Sequence[DynamicPart], still: Sequence[Solution | None]
) -> CheckReport:
    """Check what the runs of every part came to, by `check_motion`; `still`: the lines at rest."""
    lines = [
        line_in_motion(case, part, part.runs, solution)
        for part, solution in zip(parts, still, strict=True)
    ]
    return check_motion(case, lines)


def line_in_motion(
    case: Case | Network, part: DynamicPart, runs: Sequence[DynamicRun], still: Solution | None
) -> LineInMotion:
    """Take together what the runs of a line came to; its mean tensions are those at rest."""
    line = part.own_line if still is None else still.line
    mean = None if still is None else tuple(e.max_tension for e in still.segments)
    tensions, carried = governing_tensions(part, runs, line), _carried(case, part, runs)
    one_parts = _one_parts(part, runs)
    return LineInMotion(line, tensions, mean, part.name, part.line, carried, one_parts)


def _one_parts(part: DynamicPart, runs: Sequence[DynamicRun]) -> bool:
    """Whether a line that is to part does so in some run."""
    by_time = part.drive.dynamics.broken_by == "time"
    return by_time or any(run.history.parted is not None for run in runs)


def governing_tensions(
    part: DynamicPart, runs: Sequence[DynamicRun], line: Line
) -> tuple[float, ...]:
    """Tension of each segment that the checks are held against, N.

    The largest over all runs, of its bars and of an end it holds. Where the storm's maximum is
    judged in its place, that of an end is its own, and that of bars as much higher than the largest
    of the runs as at the end of the line that has the larger one.
    """
    ends = ("anchor_tension", "fairlead_tension")
    anchor, fairlead = (_higher(part, runs, each) for each in ends)
    most = [max(run.maxima[each] for run in runs) for each in ends]
    of_bars = (anchor, fairlead)[first_largest(most)]
    found = [tuple(_segments(run, line, anchor, fairlead, of_bars)) for run in runs]
    found += [tuple(_parted_at(part, run, line)) for run in runs]
    return tuple(max(each) for each in zip(*found, strict=True))


def _higher(part: DynamicPart, runs: Sequence[DynamicRun], quantity: str) -> float:
    """Say by how much a maximum that is judged is above the largest of the runs, as a factor."""
    dynamics = part.drive.dynamics
    # As a line parts, what the storm may bring is that of none of its states.
    judged_by = "largest" if dynamics.broken_line is not None else dynamics.judged_by
    extreme = None if judged_by == "largest" else part.storm(quantity, runs)
    if extreme is None:
        return 1.0
    largest = max(run.history.course(quantity).maximum for run in runs)
    storm = extreme.high if judged_by == "upper" else extreme.most_probable
    return max(1.0, storm / largest)


def _segments(
    run: DynamicRun, line: Line, anchor: float, fairlead: float, of_bars: float
) -> Iterator[float]:
    """Yield the largest tension of each segment, N, times the factors of its ends and its bars."""
    history, start = run.history, 0.0
    for index, segment in enumerate(line.segments, start=1):
        end = start + segment.length
        inside = history.max_tension[(history.arc >= start) & (history.arc <= end)]
        largest = of_bars * max((each for each in inside.tolist() if each == each), default=0.0)
        if index == 1:
            largest = max(largest, anchor * run.maxima["anchor_tension"])
        if index == len(line.segments):
            largest = max(largest, fairlead * run.maxima["fairlead_tension"])
        yield largest
        start = end


def _parted_at(part: DynamicPart, run: DynamicRun, line: Line) -> Iterator[float]:
    """Yield the MBL of the segment that a line parts in by its strength, 0 of all others, N."""
    dynamics, parted, start = part.drive.dynamics, run.history.parted, 0.0
    is_own = dynamics.broken_line == (part.line or 1) and dynamics.broken_by == "MBL"
    arc = run.history.arc[parted.bar] if parted is not None and is_own else math.inf
    for segment in line.segments:
        inside = start <= arc < start + segment.length
        yield (segment.MBL or 0.0) if inside else 0.0
        start += segment.length


def _carried(case: Case | Network, part: DynamicPart, runs: Sequence[DynamicRun]) -> Carried | None:
    """Take the least favourable values at every step of all runs.

    None where nothing counts, or a line ends at no anchor.

    A buoy afloat carries the mean pull down: what its peaks do to it is in how it moves.
    """
    if not part.is_anchored or not all(run.history.counts for run in runs):
        return None
    of = [run.history for run in runs]

    def most(quantity: str) -> float:
        return max(each.course(quantity).maximum for each in of)

    def storm(quantity: str) -> float:
        return most(quantity) * _higher(part, runs, quantity)

    anchor = Pull(storm("anchor_horizontal"), storm("uplift_force"), most("uplift_angle"))
    lies, slackest = (
        min(each.course(quantity).minimum for each in of)
        for quantity in ("grounded_length", "fairlead_tension")
    )
    unknown = math.nan  # no check asks for it yet; not 0, lest one that does pass unseen
    pull = storm("fairlead_vertical")
    if case.floater is not None:
        pull = taken_together([each.course("fairlead_vertical") for each in of])
    of_line = [each for each in part.drive.sinkers if each == case.anchor]
    slide = way_of(of_line[0], part, runs) if of_line else None
    ends = anchor, Pull(unknown, pull, unknown)
    return Carried(*ends, lies, storm("span"), slackest, slide, mean_heel(runs))


def mean_heel(runs: Sequence[DynamicRun]) -> float | None:
    """Return the largest mean heel of a buoy in some runs, rad; None without one."""
    found = [run.hull.mean_heel(run.counted) for run in runs if run.hull is not None]
    return max(found, default=None)


def way_of(anchor: Anchor, part: DynamicPart, runs: Sequence[DynamicRun]) -> float:
    """Say how far a sinker slides, m: in the run in which it does so most, or in the storm.

    The storm has slides as often and as long as the runs have. Up to the upper end of the interval
    it is 1.645 standard errors further, those of a compound Poisson process, or, where runs differ
    by more than that, as far as Student's distribution says of so many.
    """
    which = part.drive.sinkers.index(anchor)
    slides = [run.history.slides[0, which] for run in runs]
    dynamics = part.drive.dynamics
    if dynamics.judged_by == "largest":
        return max(float(each[0]) for each in slides)
    time = sum(run.history.course("anchor_horizontal").duration for run in runs)
    ways, squares, _ = np.sum(slides, axis=0)
    most = 0.0
    if dynamics.judged_by == "upper":
        most = _NORMAL * math.sqrt(squares)
        if len(runs) > 1:
            apart = float(np.std([each[0] for each in slides], ddof=1)) * math.sqrt(len(runs))
            most = max(most, float(stdtrit(len(runs) - 1, _ONE_SIDED)) * apart)
    return float(ways + most) * dynamics.duration_of_interest / time


def _turned(
    case: Case | Network, lines: Sequence[tuple[DynamicPart, Solution | None]]
) -> list[CheckResult]:
    """List the checks of lines that move together whose verdict is another in runs again."""
    verdicts = []
    for level in zip(*(part.levels for part, _ in lines), strict=True):
        moved = [
            line_in_motion(case, part, runs, still)
            for (part, still), (_, runs) in zip(lines, level, strict=True)
        ]
        verdicts.append(check_motion(case, moved).results)
    return [
        same[0] for same in zip(*verdicts, strict=True) if len({each.passes for each in same}) > 1
    ]


def with_verdicts(case: Case | Network, parts: Sequence[DynamicPart]) -> list[DynamicPart]:
    """Say of every part what turns out otherwise in runs again, is beyond its MBL, and governs."""
    moved = list(zip(parts, solutions_at_rest(case, parts), strict=True))
    together: dict[str, list[tuple[DynamicPart, Solution | None]]] = {}
    for pair in moved:
        together.setdefault(pair[0].name, []).append(pair)
    judged = []
    for lines in together.values():
        turned = _turned(case, lines)
        for part, _ in lines:
            own = (each.name for each in turned if each.place.line in (None, part.line))
            undecided = tuple(dict.fromkeys(own))
            judged.append(replace(part, undecided=undecided, beyond_MBL=beyond_MBL(part)))
    if len(judged) == len(together):
        return judged
    used = [part.max_tension / (part.MBL or 1.0) for part in judged]
    if any(part.MBL is None for part in judged):
        used = [part.max_tension for part in judged]
    first_one = first_largest(used)
    return [replace(part, governs=k == first_one) for k, part in enumerate(judged)]
