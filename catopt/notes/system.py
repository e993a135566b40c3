"""What the notes of a moored body, and of lines between points, are made of."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from catopt.casefile.reading import read_mooring
from catopt.casefile.schema import NetworkTable
from catopt.checks.evaluation import NO_CHECK
from catopt.checks.system import check_network, check_system, criteria_of_network
from catopt.errors import CatoptError, NoEquilibriumError
from catopt.largest import first_largest
from catopt.model.network import Network
from catopt.mooring.case import CURVE_POINTS, SystemReport, report_system
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_out import NetworkOut, each_line_out, largest_tensions
from catopt.mooring.network_rest import LinesAtRest
from catopt.mooring.restoring import RestoringCurve, restoring_curve
from catopt.notes.motion import checks_in_motion, motion_files
from catopt.notes.origin import (
    Asked,
    SourceFile,
    case_path,
    origin_of,
    read_source,
    read_with_sources,
)
from catopt.notes.sheet import (
    AnyNote,
    LinesOfABody,
    Made,
    Stated,
    both_models,
    doubts_of_models,
    sheet_of,
)
from catopt.progress import Progress
from catopt.quantities import QUANTITIES
from catopt.verify.motion_words import doubts, stopped_sentence
from catopt.words import Message, is_said

if TYPE_CHECKING:
    from catopt.catenary.solution import EndState
    from catopt.checks.result import CheckReport
    from catopt.model import Case
    from catopt.mooring.solution import LegState, SystemSolution
    from catopt.notes.sheet import Sheet
    from catopt.verify.dynamic_result import DynamicVerification
    from catopt.verify.result import Verification

_NOTHING = 1e-9
"""Over the size of a vector: a part below it is rounding."""
_LESS = 0.9
"""Part of the offset under the load to which a restoring curve goes where half as far again is not
to be had."""


@dataclass(frozen=True, kw_only=True)
class SystemNote(AnyNote):
    """Everything that the page of a moored body shows.

    `report` has the body under its load, with one line out, the watch circle, and the restoring
    curves along the force and across it; what could not be computed is left out, and the warnings
    say why. `verification` is by the truss model, None where it was left out or failed, the latter
    for the reason of `verification_failure`; `motion` has all lines, `motion_checks` judges them,
    None where nobody asked for it.
    """

    case: Case
    sheet: Sheet
    report: SystemReport
    verification: Verification | None = None
    verification_failure: str = ""
    motion: DynamicVerification | None = None
    motion_checks: CheckReport | None = None

    @property
    def solution(self) -> SystemSolution:
        """The body under its load."""
        return self.report.solution

    @property
    def at_rest(self) -> tuple[LegState, ...]:
        """Every line under the body's load."""
        return self.solution.lines

    @property
    def loaded(self) -> LegState:
        """The most loaded line."""
        return self.solution.lines[self.solution.most_loaded]

    @property
    def is_judged(self) -> bool:
        """Whether any criterion is on the tensions of the intact body."""
        return self.checks.used() is not None

    @property
    def used(self) -> float | None:
        """Largest utilisation of any line: by its checks, or else of the MBL; None if unknown."""
        return self._used(self.solution, None)

    @property
    def left(self) -> tuple[float | None, ...]:
        """The same with each line gone in turn."""
        return tuple(self._used(each.solution, each.missing + 1) for each in self.report.line_out)

    def _used(self, solution: SystemSolution | None, missing: int | None) -> float | None:
        if solution is None or self.is_judged:
            return self.checks.used(missing=missing)
        used = [line.utilisation() for line in solution.lines]
        return max((each for each in used if each is not None), default=None)

    @property
    def force_towards(self) -> float:
        """Where the force on the body acts to, rad."""
        return heading_of(*self.solution.system.force)

    @property
    def offset_towards(self) -> float:
        """Where the body has gone, rad."""
        return heading_of(*self.solution.offset)

    def worst_out(self, what: Literal["largest_tension", "offset"]) -> int | None:
        """Which of the lines gone, counted as in the report, leaves the most of something."""
        responses = [gone.response for gone in self.report.line_out]
        known = [-math.inf if each is None else getattr(each, what) for each in responses]
        return first_largest(known) if any(responses) else None

    @property
    def allowed_at_fairlead(self) -> float | None:
        """Tension that the weakest line is allowed at its fairlead, by the checks or its MBL, N."""
        legs = self.solution.system.legs
        allowed = [
            each.capacity
            for each in self.checks.results
            if each.kind == "tension"
            and each.place.state == "intact"
            and each.place.line is not None
            and each.place.segment == len(legs[each.place.line - 1].line.segments)
        ]
        strengths = [leg.line.segments[-1].MBL for leg in legs]
        known = [each for each in strengths if each is not None]
        if allowed or len(known) < len(strengths):
            return min(allowed, default=None)
        return min(known)


def read_system_note(
    path: Path,
    design: int | None = None,
    asked: Asked | None = None,
    *,
    progress: Progress | None = None,
) -> SystemNote:
    """Read the case file of a moored body, with a table [system], and compute its note.

    `design` is the number of a design, counted from 1, in a directory that ``catopt design --out``
    wrote, the recommended one when left out.

    Raises InputError, NoAnswerError and NotConvergedError as `read_case`, `report_system`,
    `check_case` and `verify_dynamic` do.
    """
    case, sources, chosen = read_with_sources(path, design)
    note = system_note(case, sources, asked, progress=progress)
    if chosen is None:
        return note
    return replace(note, warnings=(Message("design.one_heading"), *note.warnings))


def system_note(
    case: Case,
    files: tuple[SourceFile, ...],
    asked: Asked | None = None,
    *,
    progress: Progress | None = None,
) -> SystemNote:
    """Compute the note of a moored body; as `read_system_note`."""
    asked = asked or Asked()
    found, judged = _in_motion(case, asked, progress)
    report, left_out = _report(case)
    checks = check_system(case, report)
    verification, failure = both_models(case) if asked.verify else (None, "")
    warnings = (
        *doubts_of_models(verification, failure, "body"),
        *(() if found is None else _of_motion(found)),
        *(each for each in checks.warnings if not is_said(each, NO_CHECK)),
        *report.solution.warnings,
        *left_out,
    )
    return SystemNote(
        case=case,
        report=report,
        origin=origin_of(
            (*files, *(motion_files(case) if found else ())), asked.date, title_block=case.document
        ),
        sheet=sheet_of(case, case.line, checks, LinesOfABody(report.solution), moved=judged),
        warnings=tuple(dict.fromkeys(warnings)),
        verification=verification,
        verification_failure=failure,
        motion=found,
        motion_checks=judged,
    )


def _in_motion(
    case: Case | Network, asked: Asked, progress: Progress | None
) -> tuple[DynamicVerification | None, CheckReport | None]:
    """Run all lines in time where that is asked for, and judge them."""
    if not asked.motion:
        return None, None
    from catopt.verify.dynamic import verify_dynamic

    found = verify_dynamic(case, convergence_check=asked.convergence_check, progress=progress)
    return found, checks_in_motion(found)


def heading_of(x: float, y: float) -> float:
    """Direction of a vector, rad; a part along x or y that is rounding beside the other is 0."""
    size = math.hypot(x, y)
    x, y = (0.0 if abs(each) <= _NOTHING * size else each for each in (x, y))
    return math.atan2(y, x)


def _made(rest: LinesAtRest) -> tuple[Made, ...]:
    """Count the lines that are made alike, those that an anchor holds apart."""
    alike = Counter((run.line, rest.is_anchored(k)) for k, run in enumerate(rest.runs))
    return tuple(Made(line, count, is_held) for (line, is_held), count in alike.items())


def directions_of(force: tuple[float, float]) -> tuple[float, float]:
    """Choose the directions of the restoring curves: along a force and across it; x and y without.

    In rad, counter-clockwise from x.
    """
    along = heading_of(*force) if any(force) else 0.0
    quarter = 0.5 * math.pi
    return along, along - quarter if along > quarter else along + quarter


def _report(case: Case) -> tuple[SystemReport, tuple[str, ...]]:
    """Solve the body, and what else is shown; say why where a part of that has no answer."""
    report = report_system(case, with_line_out=True)
    warnings = []
    try:
        report = replace(report, circle=report_system(case, with_circle=True).circle)
    except CatoptError as error:
        warnings.append(Message("notes.circle_left_out", why=error.message))
    curves = []
    for direction in directions_of(case.own_system.force):
        try:
            curves.append(_curve(case, report.solution, direction))
        except CatoptError as error:
            angle = QUANTITIES["angle"].format(direction)
            warnings.append(Message("notes.restoring_left_out", angle=angle, why=error.message))
    return replace(report, curves=tuple(curves)), tuple(warnings)


def _curve(case: Case, solution: SystemSolution, direction: float) -> RestoringCurve:
    """Find the restoring curve in a direction; up to less where lines that do not stretch end."""
    try:
        (curve,) = report_system(case, directions=(direction,)).curves
    except NoEquilibriumError:
        middle = CURVE_POINTS // 2
        far = _LESS * math.hypot(*solution.offset)
        if not any(solution.system.force):
            raise
        offsets = [far * (k - middle) / middle for k in range(CURVE_POINTS)]
        return restoring_curve(solution.system, direction=direction, offsets=offsets)
    return curve


def _of_motion(found: DynamicVerification) -> Iterator[str]:
    """Yield what the lines in motion leave in doubt, and which of them go slack."""
    if not found.is_complete:
        yield Message("notes.motion_incomplete", where=stopped_sentence(found))
    for doubt in doubts(found.least_proven):
        yield Message("notes.line_in_motion", number=found.least_proven.shown, what=doubt)
    slack = [part.shown for part in found.parts if part.slack_time > 0.0]
    if slack:
        yield Message("notes.lines_slack", lines=", ".join(slack))
    for remark in dict.fromkeys(each for part in found.parts for each in part.remarks):
        yield Message("notes.in_motion", what=remark)


@dataclass(frozen=True, kw_only=True)
class NetworkNote(AnyNote):
    """Everything that the page of lines between points shows, the body held.

    `line_out` has them with each out; `motion` has all lines, `motion_checks` what it is judged by,
    None where nobody asked for it.
    """

    case: Network
    rest: LinesAtRest
    line_out: tuple[NetworkOut, ...]
    verification: Verification | None = None
    verification_failure: str = ""
    motion: DynamicVerification | None = None
    motion_checks: CheckReport | None = None

    @property
    def at_rest(self) -> tuple[EndState, ...]:
        """The upper end of every line."""
        return tuple(line.fairlead for line in self.rest.lines)

    @property
    def tensions(self) -> tuple[float, ...]:
        """Largest of each line, N."""
        return largest_tensions(self.rest)

    @property
    def most_loaded(self) -> int:
        """The line of the largest tension, counted from 0; the first of several."""
        return first_largest(self.tensions)


def read_network_note(
    path: Path, asked: Asked | None = None, *, progress: Progress | None = None
) -> NetworkNote:
    """Read a file of points and lines, or a directory with one, and compute its note.

    Raises InputError, NoAnswerError and NotConvergedError as `read_mooring`, `check_network` and
    `verify_dynamic` do.
    """
    asked = asked or Asked()
    place = case_path(path)
    network, source = read_mooring(place), read_source(place)
    assert isinstance(network, Network)
    rest = at_rest(network)
    line_out = each_line_out(network) if len(network.lines) > 1 else ()
    checks = check_network(network, rest, line_out or None)
    found, judged = _in_motion(network, asked, progress)
    warnings = [*checks.first, *(() if found is None else _of_motion(found))]
    warnings += [each for each in checks.warnings if not is_said(each, NO_CHECK)]
    verification, failure = both_models(network) if asked.verify else (None, "")
    warnings += doubts_of_models(verification, failure, "body")
    files = () if found is None else motion_files(network)
    return NetworkNote(
        case=network,
        rest=rest,
        line_out=line_out,
        verification=verification,
        verification_failure=failure,
        motion=found,
        motion_checks=judged,
        origin=origin_of((source, *files), asked.date, NetworkTable, network.document),
        sheet=Stated(
            case=network,
            report=checks,
            criteria=criteria_of_network(network),
            lines=len(rest.runs),
            intact=rest.lines,
            made=_made(rest),
            anchor=network.anchor,
        ),
        warnings=tuple(dict.fromkeys(warnings)),
    )
