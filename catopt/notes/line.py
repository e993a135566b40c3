"""What the notes of one line, and of a sizing with its line, are made of."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from catopt.casefile import write_case
from catopt.casefile.reading import DESIGN_CASE
from catopt.catenary.case import solve_case, under_a_load
from catopt.checks.case import check_case, is_of_load
from catopt.checks.evaluation import NO_CHECK
from catopt.errors import CatoptError
from catopt.loads.component import CALMAR, LoadSource
from catopt.loads.sinker import DENSITIES, FACTOR_SOURCE, SAFETY_FACTOR
from catopt.mooring.solution import solve_system
from catopt.notes.motion import (
    InMotion,
    allowed_tensions,
    in_motion,
    motion_files,
    motion_warnings,
)
from catopt.notes.origin import (
    Asked,
    Chosen,
    Origin,
    SourceFile,
    asked_in,
    origin_of,
    read_with_sources,
    source_of,
)
from catopt.notes.sheet import (
    AnyNote,
    LinesOfABody,
    both_models,
    doubts_of_models,
    sheet_of,
)
from catopt.progress import Progress
from catopt.sizing.kinds import schema_of
from catopt.words import Cited, Message, is_said, term

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport
    from catopt.model import Case
    from catopt.mooring.solution import SystemSolution
    from catopt.notes.sheet import Sheet
    from catopt.sizing import Sizing
    from catopt.verify.result import Verification

_MOST_FORCE, _LEAST_FORCE = 4.0, 0.01
"""The load curve goes up to this multiple of the case's force, and from this part of that."""


@dataclass(frozen=True, kw_only=True)
class Note(AnyNote):
    """Everything that the page of a line shows; what nobody asked for is None.

    `case` and `solution` are under the load that is drawn, by its name in `load_case` (empty when
    there is only the load), and so are `verification`, by the truss model, and `swarm`; `motion` is
    under every load case. A warning says why there is no `curve`, `verification_failure` why the
    truss model has no answer.
    """

    case: Case
    sheet: Sheet
    load_case: str
    solution: Solution
    curve: CaseCurve | None
    chosen: Chosen | None = None
    verification: Verification | None = None
    verification_failure: str = ""
    swarm: Solution | None = None
    motion: InMotion | None = None

    @property
    def allowed(self) -> list[float | None]:
        """Least tension that each segment is allowed in the load case drawn, N."""
        return allowed_tensions(self.checks, self.solution, self.load_case)


def read_note(
    path: Path,
    design: int | None = None,
    *,
    date: str = "",
    verify: bool = True,
    swarm: bool | None = None,
    motion: bool | None = None,
    once: bool | None = None,
    progress: Progress | None = None,
) -> Note:
    """Read a case file, or what a directory that ``--out`` wrote has, and compute its note.

    A `design` of ``catopt design`` counts from 1 and is the recommended one when left out. The date
    and what is shown beside the closed form are as for `Asked`; `once` leaves out the convergence
    check of the line in motion. Of these a directory has what was asked for there where None is
    given. The line in motion tells `progress` how far it is and how far it goes.

    Raises InputError, NoAnswerError and NotConvergedError as `read_case`, `read_design`,
    `solve_case`, `check_case` and `verify_dynamic` do.
    """
    asked = asked_in(path, date=date, verify=verify)
    asked = asked.with_options(swarm=swarm, motion=motion, once=once)
    case, sources, chosen = read_with_sources(path, design)
    return note_of(case, sources, asked, chosen, progress=progress)


def note_of(
    case: Case,
    files: tuple[SourceFile, ...],
    asked: Asked | None = None,
    chosen: Chosen | None = None,
    *,
    progress: Progress | None = None,
) -> Note:
    """Compute the note of a case, which the first of the files says, or which is a design of it.

    The line is drawn, and its equations are followed, under the load case of the check that
    governs; without load cases under its load. The rest is as for `read_note`.
    """
    asked = asked or Asked()
    case.site.check_water()
    case.check_still_water()
    checks = check_case(case)
    load_case, drawn = _drawn(case, checks)
    solution = solve_case(drawn)
    swarm = solve_case(drawn, "pso") if asked.swarm else None
    motion = in_motion(case, checks, asked.convergence_check, progress) if asked.motion else None
    curve, curve_warnings = _curve(drawn, solution)
    verification, failure = both_models(drawn, load_case) if asked.verify else (None, "")
    warnings = (
        *doubts_of_models(verification, failure, "line"),
        *_swarm_doubts(swarm),
        *(() if motion is None else motion_warnings(motion)),
        *_warnings(case, checks, solution),
        *curve_warnings,
        *(() if chosen is None else chosen.document["warnings"]),
    )
    return Note(
        case=drawn,
        load_case=load_case,
        solution=solution,
        curve=curve,
        origin=origin_of(
            (*files, *(motion_files(case) if asked.motion else ())),
            asked.date,
            title_block=case.document,
        ),
        sheet=sheet_of(
            case, solution.line, checks, moved=None if motion is None else motion.checks
        ),
        chosen=chosen,
        warnings=tuple(dict.fromkeys(warnings)),
        verification=verification,
        verification_failure=failure,
        swarm=swarm,
        motion=motion,
    )


def _drawn(case: Case, checks: CheckReport) -> tuple[str, Case]:
    """Choose the load case that is drawn, by its name, and put the case under it."""
    governing = checks.governing
    for state in case.load_cases:
        if governing is not None and state.name == governing.load_case:
            return state.name, case.under(state)
    name = case.load_cases[0].name if case.load is None and case.load_cases else ""
    return name, under_a_load(case)[0]


def _warnings(case: Case, checks: CheckReport, solution: Solution) -> Iterator[str]:
    """Yield what is to be known: of the criteria, and of each equilibrium by its load case."""
    for warning in checks.warnings:
        if not is_said(warning, NO_CHECK) and (case.load_cases or not is_of_load(warning)):
            yield warning
    if not case.load_cases:
        yield from solution.warnings


def _curve(case: Case, solution: Solution) -> tuple[CaseCurve | None, tuple[str, ...]]:
    """Compute the load curve; say why not where there is none.

    Where a segment's limit is far above the load, a curve up to it would show nothing of the case.
    """
    from catopt.catenary.case_curve import curve_case

    try:
        curve = curve_case(case)
        stop = _MOST_FORCE * solution.horizontal_force
        if 0.0 < stop < float(curve.curve.horizontal_force[-1]):
            with suppress(CatoptError):
                curve = curve_case(case, start=_LEAST_FORCE * stop, stop=stop)
    except CatoptError as error:
        return None, (Message("notes.curve_left_out", why=error.message),)
    return curve, ()


def _swarm_doubts(swarm: Solution | None) -> Iterator[str]:
    """Yield that even the best run of the swarm did not converge."""
    if swarm is not None and swarm.swarm is not None and swarm.swarm.converged_runs == 0:
        yield Message("notes.swarm_not_converged", f=swarm.swarm.objective)


@dataclass(frozen=True)
class Given:
    """What a sizing was asked for: by a file, None where there is none, and by options before it.

    `options` are what was typed, or answered on a terminal.
    """

    file: SourceFile | None = None
    options: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True, kw_only=True)
class SizeNote(AnyNote):
    """Everything that the page of a sizing shows.

    `line` is the note of the recommended line, `options` are what was typed, and `around` is the
    equilibrium of several lines under the load case that is hardest on one of them.
    """

    case: Case
    sheet: Sheet
    sizing: Sizing
    line: Note
    options: tuple[tuple[str, str], ...] = ()
    around: SystemSolution | None = None

    @property
    def sources(self) -> dict[str, str]:
        """Where friction, safety factor and density of what holds the line are from."""
        sinker, drag = self.sizing.sinker, self.sizing.drag_anchor
        given = term("this note")
        if drag is not None:
            return {"factor": given if drag.factor_source is None else drag.factor_source.text}
        if sinker is None:
            return {}
        is_usual = math.isclose(sinker.safety_factor, SAFETY_FACTOR)
        friction = sinker.friction_source
        density: str = given
        if math.isclose(sinker.density, DENSITIES[sinker.material]):
            density = Message("note_size.own_recalled")
            if sinker.material == "steel":
                density = Cited(LoadSource(CALMAR, "7.2", "A").text)
        return {
            "friction": given if friction is None else Cited(friction.text),
            "factor": Cited(FACTOR_SOURCE.text) if is_usual else given,
            "density": density,
        }


def size_note(sizing: Sizing, given: Given, asked: Asked | None = None) -> SizeNote:
    """Compute the note of a sizing, by what was asked for, and of its recommended line.

    Raises NoAnswerError and NotConvergedError as `note_of` does.
    """
    asked = asked or Asked()
    # The case of the recommended line, as ``catopt size --save`` writes it.
    text = write_case(sizing.line_case)
    file = source_of(DESIGN_CASE, text)
    chosen = Chosen(_front(sizing), sizing.settled.index + 1)
    line = note_of(sizing.case, (file,), asked, chosen)
    origin = Origin((), (), asked.date)
    if given.file is not None:
        block = sizing.case.document
        origin = origin_of((given.file,), asked.date, schema_of(sizing.kind), block)
    around = None if sizing.pattern is None else solve_system(sizing.pattern.system)
    fitted, point = _fitted(line), sizing.point
    known = {_bare(each) for each in sizing.warnings}
    more = [each for each in line.warnings if _bare(each) not in known]
    return SizeNote(
        case=sizing.case,
        sizing=sizing,
        line=fitted,
        origin=origin,
        sheet=sheet_of(
            sizing.case,
            point.line,
            fitted.checks,
            None if around is None else LinesOfABody(around),
            anchor=point.anchor,
            moved=None if sizing.in_motion is None else sizing.in_motion.checks,
        ),
        options=given.options,
        warnings=(*sizing.warnings, *more),
        around=around,
    )


def _fitted(line: Note) -> Note:
    """Fit a line's note into that of its sizing.

    Its load cases, which no user named, are said in every language; and a limit that no document
    has is from this note: of a sizing there is no case file.
    """
    of = line.checks
    names = {state.name: term(state.name) for state in of.load_cases}
    this_note = term("this note")
    results = []
    for each in of.results:
        source = each.source
        if source.confidence is None:
            source = replace(source, document=this_note)
        results.append(replace(each, load_case=names[each.load_case], source=source))
    checks = replace(
        of,
        results=tuple(results),
        solutions=tuple((names[name], solution) for name, solution in of.solutions),
        load_cases=tuple(replace(each, name=names[each.name]) for each in of.load_cases),
    )
    load_case = names.get(line.load_case, line.load_case)
    return replace(line, sheet=replace(line.sheet, report=checks), load_case=load_case)


def _front(sizing: Sizing) -> dict[str, Any]:
    """Lay out the front that the recommended line is from.

    The line that the search was given is none of an engineer's: it only has the place of one. Where
    another design than the knee was preferred, the knee's neighbours are none of the line's.
    """
    settled = sizing.settled
    document = settled.result.to_dict() | {"present": None}
    if settled.index != settled.result.recommended - 1:
        document |= {"recommended": settled.index, "neighbours": []}
    return document | {"recommendation": sizing.why}


def _bare(warning: str) -> str:
    return warning.rstrip(".").casefold()
