"""Lines in motion, as values: of a note with what drove them, and every design of a front."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from catopt.checks.criteria import criteria_of
from catopt.largest import first_largest
from catopt.notes.origin import SourceFile, read_source
from catopt.progress import Progress
from catopt.units import lasting
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport
    from catopt.model import Case
    from catopt.model.network import Network
    from catopt.verify.convergence_check import ConvergenceCheck
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
    from catopt.verify.dynamic_setup import Excitation


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
    factors of `codes` for dynamic analysis the tensions are judged; `checks` are all of them.
    """

    found: DynamicVerification
    drive: Excitation
    uses: tuple[tuple[SegmentUse, ...], ...]
    solutions: tuple[Solution, ...]
    codes: tuple[str, ...] = ()
    checks: CheckReport | None = None

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
    return InMotion(found, drive, uses, solutions, tuple(codes), made)


def checks_in_motion(
    found: DynamicVerification, at_rest: Sequence[Solution | None] | None = None
) -> CheckReport:
    """Check what came of a case in motion, by `check_motion`.

    The mean tension of a segment is its largest at rest, under the mean loads: by the parts of what
    was found, solved here when left out. On a bed that slopes there is none.

    Raises InputError, NoEquilibriumError and NotConvergedError as `check_case` does.
    """
    from catopt.verify.verdicts import check_parts, solutions_at_rest

    solved = solutions_at_rest(found.case, found.parts) if at_rest is None else at_rest
    report = check_parts(found.case, found.parts, solved)
    if report.results:
        report = replace(report, warnings=(*report.warnings, *_of_the_storm(found.parts)))
    if found.verdict == "not converged" or not found.is_complete:
        doubt = Message("checks.motion_doubted")
        return replace(report, is_doubted=True, warnings=(doubt, *report.warnings))
    return replace(report, is_proven=found.verdict == "converged")


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
    from catopt.verify.verdicts import governing_tensions

    allowed = allowed_tensions(made, solution, part.name)
    largest = governing_tensions(part, part.runs, solution.line)
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
    from catopt.verify.motion_words import doubts, stopped_sentence

    found = moved.found
    if not found.is_complete:
        yield Message("notes.motion_incomplete", where=stopped_sentence(found))
    first, *others = found.parts
    of_all = [each for each in first.remarks if all(each in part.remarks for part in others)]
    yield from (Message("notes.in_motion", what=remark) for remark in of_all)
    for part, uses in zip(found.parts, moved.uses, strict=True):
        over_used = (
            Message(
                "notes.over_used",
                number=use.number,
                tension=Measure("tension", use.largest),
                used=use.utilisation,
            )
            for use in uses
            if (use.utilisation or 0.0) > 1.0
        )
        slack = [Message("notes.goes_slack", time=part.slack_time)] if part.slack_time > 0.0 else []
        own = (remark for remark in part.remarks if remark not in of_all)
        for what in (*over_used, *doubts(part), *slack, *own):
            if found.case.load_cases:
                yield Message("notes.case_in_motion", name=part.name, what=what)
            else:
                yield Message("notes.in_motion", what=what)


def motion_files(case: Case | Network) -> tuple[SourceFile, ...]:
    """Read the files of motion, force and sea that a case names, as the note rests on them, too."""
    named = (
        (case.motion, ("file", "rao_file", "drift_file")),
        (case.body, ("force_file",)),
        (case.waves, ("elevation_file",)),
        (case.current, ("series_file",)),
    )
    places = [getattr(table, key) for table, keys in named if table is not None for key in keys]
    return tuple(read_source(Path(place)) for place in places if place)
