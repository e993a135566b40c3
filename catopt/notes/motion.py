"""Lines in motion, as values: of a note with what drove them, and every design of a front."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, wait
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from catopt.checks.criteria import criteria_of
from catopt.design.front import knee
from catopt.errors import InputError, NoAnswerError, NotConvergedError, Problem
from catopt.interrupt import waiting_interrupt
from catopt.notes.origin import SourceFile, read_source
from catopt.ties import first_largest, largest
from catopt.units import lasting
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport, CheckResult
    from catopt.model import Case
    from catopt.verify.convergence_check import ConvergenceCheck
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
    from catopt.verify.dynamic_setup import Excitation

Progress = Callable[[int, int], None]

_LOOK = 0.1
"""Seconds between two looks at what an executor has done."""


@dataclass(frozen=True)
class SegmentUse:
    """What a segment, counted from 1 at the anchor, carries in motion beside what it may, N.

    `largest` is in motion, at an end or in a bar, `at_rest` in closed form; `capacity` is the least
    that is allowed by `checks_in_motion`, without any the MBL over the safety factor.
    """

    number: int
    name: str
    largest: float
    at_rest: float
    capacity: float | None

    @property
    def utilisation(self) -> float | None:
        """Largest tension over what is allowed; None where that is not known or 0."""
        return self.largest / self.capacity if self.capacity else None


@dataclass(frozen=True)
class InMotion:
    """A line in motion in every load case, and what drove it, with its files read.

    `uses` of each segment and `solutions` at rest are by load case as in `found.parts`; by the
    factors of `codes` for dynamic analysis the tensions are judged.
    """

    found: DynamicVerification
    drive: Excitation
    uses: tuple[tuple[SegmentUse, ...], ...]
    solutions: tuple[Solution, ...]
    codes: tuple[str, ...] = ()

    @property
    def governing(self) -> int:
        """Index of the load case with the largest utilisation, or else the largest tension."""
        used = [self.used(index) or 0.0 for index in range(len(self.found.parts))]
        return first_largest(used if any(used) else [part.max_tension for part in self.found.parts])

    def used(self, index: int) -> float | None:
        """Largest utilisation of a load case; None where no tension is limited."""
        known = [use.utilisation for use in self.uses[index] if use.utilisation is not None]
        return max(known, default=None)


def in_motion(
    case: Case,
    checks: CheckReport,
    convergence_check: ConvergenceCheck = "step",
    progress: Progress | None = None,
) -> InMotion:
    """Run the line of a case, checked at rest, in time under every load case.

    Raises InputError, NoEquilibriumError and NotConvergedError as `verify_dynamic` does.
    """
    from catopt.verify.dynamic import verify_dynamic
    from catopt.verify.dynamic_setup import check_for_motion, read_drive

    check_for_motion(case)
    drive = read_drive(case)
    found = verify_dynamic(case, convergence_check=convergence_check, progress=progress)
    at_rest = dict(checks.solutions)
    solutions = tuple(at_rest[part.name] for part in found.parts)
    made = checks_in_motion(found, solutions)
    uses = tuple(
        tuple(_uses(part, solution, made))
        for part, solution in zip(found.parts, solutions, strict=True)
    )
    wanted = criteria_of(case, analysis="dynamic").all
    codes = dict.fromkeys(each.source.code for each in wanted if each.analysis == "dynamic")
    return InMotion(found, drive, uses, solutions, tuple(codes))


def motion_document(moved: InMotion | DynamicVerification | None) -> dict[str, Any] | None:
    """Say what came of the line in motion that governs, as part of catopt.report/1."""
    if moved is None:
        return None
    if isinstance(moved, InMotion):
        part, used = moved.found.parts[moved.governing], moved.used(moved.governing)
    else:
        part, used = moved.governing, None
    fairlead = part.of("fairlead_tension")
    extreme = None if fairlead.tail is None else fairlead.tail.extreme
    return {
        "load_case": part.name,
        "line": part.line,
        "runs": len(part.runs),
        "max_tension_N": part.max_tension,
        "max_fairlead_tension_N": fairlead.maximum,
        "most_probable_max_N": fairlead.most_probable_maximum,
        "duration_of_interest_s": part.duration_of_interest,
        "most_probable_low_N": None if extreme is None else extreme.low,
        "most_probable_high_N": None if extreme is None else extreme.high,
        "amplification": part.dynamic_amplification,
        "slack_time_s": part.slack_time,
        "utilisation": used,
    }


def checks_in_motion(
    found: DynamicVerification, at_rest: Sequence[Solution | None] | None = None
) -> CheckReport:
    """Check what came of a case in motion, by `check_motion`.

    The mean tension of a segment is its largest at rest, under the mean loads: by the parts of what
    was found, solved here when left out. On a bed that slopes there is none.

    Raises InputError, NoEquilibriumError and NotConvergedError as `check_case` does.
    """
    from catopt.verify.judged import check_parts, solutions_at_rest

    solved = solutions_at_rest(found.case, found.parts) if at_rest is None else at_rest
    report = check_parts(found.case, found.parts, solved)
    if report.results:
        report = replace(report, warnings=(*report.warnings, *_of_the_storm(found.parts)))
    if found.verdict == "not converged" or not found.is_complete:
        doubt = Message("checks.motion_doubted")
        return replace(report, is_doubted=True, warnings=(doubt, *report.warnings))
    return report


def _of_the_storm(parts: Sequence[DynamicPart]) -> Iterator[Message]:
    """Say that the storm's maxima are judged, or where it is likely to bring more than the runs."""
    for part in parts:
        fairlead = part.of("fairlead_tension")
        probable, judged_by = fairlead.most_probable_maximum, part.drive.dynamics.judged_by
        if judged_by != "largest":
            found = "no_storm" if probable is None else judged_by.replace("-", "_")
            values = {"where": part.where, "time": lasting(part.duration_of_interest)}
            yield Message(f"checks.motion_by_{found}", **values)
            continue
        if probable is not None and probable > fairlead.maximum:
            yield Message(
                "checks.motion_probable",
                where=part.where,
                largest=Measure("tension", fairlead.maximum),
                probable=Measure("tension", probable),
                time=lasting(part.duration_of_interest),
            )


def _uses(part: DynamicPart, solution: Solution, made: CheckReport) -> Iterator[SegmentUse]:
    """Yield what each segment carries beside what the checks of its tension allow."""
    from catopt.verify.judged import judged_tensions

    allowed = allowed_tensions(made, solution, part.name)
    largest = judged_tensions(part, part.runs, solution.line)
    every = zip(solution.segments, largest, allowed, strict=True)
    for number, (segment, carried, capacity) in enumerate(every, start=1):
        yield SegmentUse(number, segment.name, carried, segment.max_tension, capacity)


def allowed_tensions(
    checks: CheckReport, solution: Solution, load_case: str = ""
) -> list[float | None]:
    """Find the least tension that each segment is allowed, N.

    By the checks of a load case, whose name is empty where there is only the load; without any, the
    MBL over the safety factor; None where neither is known.
    """
    found: list[float | None] = []
    for index, segment in enumerate(solution.segments, start=1):
        by_mbl = None if segment.MBL is None else segment.MBL / solution.safety_factor
        checked = (
            result.capacity
            for result in checks.results
            if result.kind == "tension"
            and (result.load_case == load_case or not load_case)
            and result.place.segment == index
        )
        found.append(min(checked, default=by_mbl))
    return found


def motion_warnings(moved: InMotion) -> Iterator[str]:
    """Yield what is to be known before the note is used: what fails, and what was remarked on."""
    from catopt.verify.motion_words import stopped_sentence

    found = moved.found
    if not found.is_complete:
        yield Message("notes.motion_incomplete", where=stopped_sentence(found))
    first, *others = found.parts
    of_all = [each for each in first.remarks if all(each in part.remarks for part in others)]
    yield from (Message("notes.in_motion", what=remark) for remark in of_all)
    for part, uses in zip(found.parts, moved.uses, strict=True):
        for what in _of_part(part, uses, of_all):
            if found.case.load_cases:
                yield Message("notes.case_in_motion", name=part.name, what=what)
            else:
                yield Message("notes.in_motion", what=what)


def _of_part(
    part: DynamicPart, uses: tuple[SegmentUse, ...], of_all: Sequence[str]
) -> Iterator[str]:
    from catopt.verify.motion_words import doubts

    for use in uses:
        if use.utilisation is not None and use.utilisation > 1.0:
            values = {"tension": Measure("tension", use.largest), "used": use.utilisation}
            yield Message("notes.over_used", number=use.number, **values)
    yield from doubts(part)
    if part.slack_time > 0.0:
        yield Message("notes.goes_slack", time=part.slack_time)
    yield from (remark for remark in part.remarks if remark not in of_all)


def motion_files(case: Case) -> tuple[SourceFile, ...]:
    """Read the files of motion, force and sea that a case names, as the note rests on them, too."""
    named = (
        (case.motion, ("file", "rao_file", "drift_file")),
        (case.body, ("force_file",)),
        (case.waves, ("elevation_file",)),
        (case.current, ("series_file",)),
    )
    places = [getattr(table, key) for table, keys in named if table is not None for key in keys]
    return tuple(read_source(Path(place)) for place in places if place)


@dataclass(frozen=True)
class DesignInMotion:
    """One design of a front in motion, by its number from 1, as in the tables of the front.

    The objectives are those of the search, in SI, lower being better. Nothing was found where there
    is no answer, for the reason of `failure`; the checks are of the tensions in motion, and
    `at_rest` is the tension at the fairlead under the mean loads, N, where it is largest in motion.
    """

    number: int
    objectives: tuple[float, ...]
    found: DynamicVerification | None = None
    checks: CheckReport | None = None
    at_rest: float | None = None
    failure: str = ""

    @property
    def passes(self) -> bool:
        """Whether it was run to its end, is not doubted, and every check passes."""
        found, checks = self.found, self.checks
        is_sure = found is not None and found.is_complete and found.verdict != "not converged"
        return is_sure and checks is not None and bool(checks.results) and checks.passes

    @property
    def is_run_once(self) -> bool:
        """Whether it was run, but no run again says what its maxima hang on."""
        return self.found is not None and self.found.verdict == "not proven"

    @property
    def governing(self) -> DynamicPart | None:
        """The load case, or the line of a body, with the largest tension at the fairlead."""
        return None if self.found is None else self.found.governing

    @property
    def tightest(self) -> CheckResult | None:
        """The check that is nearest to its limit."""
        results = () if self.checks is None else self.checks.results
        return largest(results, lambda each: each.utilisation or 0.0) if results else None


@dataclass(frozen=True)
class FrontInMotion:
    """A front in motion; not complete when it was stopped (Ctrl-C), later designs being left out.

    `of_search` is the number of the design that the search recommends, which passes at rest.
    """

    designs: tuple[DesignInMotion, ...]
    of_search: int
    is_complete: bool

    @property
    def recommended(self) -> int | None:
        """Number of the best design that passes at rest and in motion; None if there is none.

        That of the search if it passes in motion, else the knee of those that do.
        """
        passing = [each for each in self.designs if each.passes]
        if self.of_search in {each.number for each in passing}:
            return self.of_search
        if not passing:
            return None
        return passing[knee(np.array([each.objectives for each in passing])).index].number

    @property
    def has_converged(self) -> bool:
        """Whether every design has an answer that its convergence check does not contradict."""
        return all(
            each.found is not None and each.found.verdict != "not converged"
            for each in self.designs
        )

    def to_dict(self) -> dict[str, Any]:
        """Build what ``catopt verify DIR --all --dynamic --json`` has under ``dynamic``."""
        return {
            "recommended_by_search": self.of_search,
            "recommended": self.recommended,
            "complete": self.is_complete,
            "designs": [_document(each) for each in self.designs],
        }


def front_in_motion(
    cases: Sequence[tuple[int, Case, tuple[float, ...]]],
    of_search: int,
    *,
    convergence_check: ConvergenceCheck = "step",
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> FrontInMotion:
    """Run designs in time, side by side, in every load case, and check their tensions.

    Each is run once: first in one seed, by its largest values, which all of them together are never
    judged below; in the others where it passes. Then the design that is recommended is run again to
    prove it, and where that speaks against it the one that is recommended instead.

    A case is a design's number, case and objectives. `convergence_check`: of the one that is
    recommended; "bars" proves every design that passes. `executor`: what runs the designs, as of
    `concurrent.futures`; `workers` processes of this machine when left out. The rest is as for
    `verify_dynamic`.

    Raises InputError as `verify_dynamic` and `check_motion` do, and where the case has no check of
    a tension. A design without an answer does not stop the others.
    """
    from catopt.verify.side_by_side import Crew, share_of

    for _, case, _ in cases[:1]:
        if not any(each.check == "tension" for each in criteria_of(case, analysis="dynamic").all):
            allowed = Message("refused_command.codes_or_safety_factor_are")
            raise InputError(
                [Problem("checks", Message("refused_command.no_tension_limit"), allowed)],
                "case file",
            )
    with waiting_interrupt() as ask:

        def tell(at: int, end: int) -> None:
            ask()
            if progress is not None:
                progress(at, end)

        once, proof = share_of(tell, 0, 2), share_of(tell, 1, 2)
        task = partial(_once, cases)
        if executor is None:
            with Crew(min(_side(cases, workers), len(cases))) as crew:
                designs = crew.each(task, len(cases), once)
        else:
            designs = _on(executor, task, len(cases), once)
        front = FrontInMotion(tuple(designs), of_search, len(designs) == len(cases))
        if convergence_check == "none":
            return front
        proven: set[int] = set()
        try:
            while (wanted := _to_prove(front, convergence_check, proven)) is not None:
                number, case, objectives = cases[wanted]
                again = _design(number, objectives, case, convergence_check, workers, None, proof)
                proven.add(number)
                kept = (again if each.number == number else each for each in front.designs)
                front = replace(front, designs=tuple(kept))
        except KeyboardInterrupt:
            front = replace(front, is_complete=False)
        return front


def _side(cases: Sequence[tuple[int, Case, tuple[float, ...]]], workers: int | None) -> int:
    """Say how many processes run the designs, at most: one where there is little to do."""
    from catopt.verify.case import load_states
    from catopt.verify.dynamic import processes_for, work_of

    for _, case, _ in cases:
        with suppress(NoAnswerError, NotConvergedError):
            work = sum(work_of(state) for _, state in load_states(case, None))
            return processes_for(len(cases) * work, workers)
    return 1


def _on(
    executor: Executor, task: Callable[[int, Progress], DesignInMotion], count: int, tell: Progress
) -> list[DesignInMotion]:
    """Do a task for each number by an executor; stopped, what was done by then."""
    futures = [executor.submit(task, number, _silent) for number in range(count)]
    waiting = set(futures)
    try:
        while waiting:
            done, waiting = wait(waiting, _LOOK, FIRST_COMPLETED)
            for each in done:
                each.result()
            tell(count - len(waiting), count)
    except KeyboardInterrupt:
        for each in futures:
            each.cancel()
    return [each.result() for each in futures if each.done() and not each.cancelled()]


def _silent(*_: int) -> None:
    """Tell nobody."""


def _to_prove(
    front: FrontInMotion, convergence_check: ConvergenceCheck, proven: set[int]
) -> int | None:
    """Find the design, by its place, that passes and is to be proven next; not those that were."""
    wanted = [front.recommended]
    if convergence_check == "bars":
        wanted += [each.number for each in front.designs if each.passes]
    for k, each in enumerate(front.designs):
        if each.number in wanted and each.number not in proven:
            return k
    return None


def _once(
    cases: Sequence[tuple[int, Case, tuple[float, ...]]], at: int, progress: Progress
) -> DesignInMotion:
    """Run a design in one seed and, where it passes that, in the others."""
    from catopt.verify.side_by_side import share_of

    number, case, objectives = cases[at]
    assert case.dynamics is not None
    runs = case.dynamics.runs
    first = _design(
        number, objectives, case, "none", 1, range(min(1, runs)), share_of(progress, 0, runs)
    )
    if runs == 1 or not first.passes:
        return first
    rest = share_of(progress, 1, runs, runs - 1)
    return _design(number, objectives, case, "none", 1, range(1, runs), rest, first.found)


def _design(
    number: int,
    objectives: tuple[float, ...],
    case: Case,
    convergence_check: ConvergenceCheck,
    workers: int | None,
    seeds: Sequence[int] | None,
    progress: Progress,
    before: DynamicVerification | None = None,
) -> DesignInMotion:
    """Run a design and check what its runs came to; raises KeyboardInterrupt where it is stopped.

    `seeds`: as of `verify_dynamic`, those of the first ones being judged by their largest values;
    `before`: what the seeds came to that were run before these.
    """
    from catopt.verify.dynamic import verify_dynamic
    from catopt.verify.judged import judged_as, solutions_at_rest, with_more_runs, with_verdicts

    try:
        found = verify_dynamic(
            case,
            convergence_check=convergence_check,
            workers=workers,
            seeds=seeds,
            progress=progress,
        )
        if not found.is_complete:
            raise KeyboardInterrupt
        if before is not None:
            parts = [with_more_runs(*e) for e in zip(before.parts, found.parts, strict=True)]
            found = replace(found, parts=tuple(with_verdicts(case, parts)))
        judged = found
        if seeds is not None and before is None:
            assert case.dynamics is not None
            largest_values = replace(case.dynamics, judged_by="largest")
            parts = [judged_as(each, largest_values) for each in found.parts]
            judged = replace(found, parts=tuple(parts))
        still = solutions_at_rest(case, found.parts)
        checks = checks_in_motion(judged, still)
    except (NoAnswerError, NotConvergedError) as error:
        return DesignInMotion(number, objectives, failure=error.message)
    solution = still[found.parts.index(found.governing)]
    tension = None if solution is None else solution.fairlead.tension
    return DesignInMotion(number, objectives, found, checks, tension)


def _document(each: DesignInMotion) -> dict[str, Any]:
    part = each.governing
    return {
        "design": each.number,
        "verdict": "no answer" if each.found is None else each.found.verdict,
        "failure": each.failure,
        "passes": each.passes,
        "tension_at_rest_N": each.at_rest,
        "largest_tension_N": None if part is None else part.of("fairlead_tension").maximum,
        "quasi_static_tension_N": None if part is None else part.quasi_static_max,
        "amplification": None if part is None else part.dynamic_amplification,
        "runs": 0 if part is None else len(part.runs),
        "checks": None if each.checks is None else each.checks.motion_document(),
    }
