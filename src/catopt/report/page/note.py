"""What the note of one line is made of: a case with its answers, and where it comes from."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from catopt.casefile import read_case
from catopt.casefile.design_directory import DESIGN_CASE, DESIGN_DOCUMENT, read_design
from catopt.catenary.case import solve_case, under_a_load
from catopt.checks.case import LOAD, NO_CHECK, check_case
from catopt.errors import CatoptError, InputError, Problem
from catopt.report.page.origin import Origin, SourceFile, origin_of, read_source

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport
    from catopt.model import Case
    from catopt.verify.result import Verification

__all__ = ["Chosen", "Note", "note_of", "read_note"]

MOST_FORCE, LEAST_FORCE = 4.0, 0.01
"""The load curve goes up to this multiple of the case's force, and from this part of that."""


@dataclass(frozen=True)
class Chosen:
    """A design out of a front.

    Attributes
    ----------
    document : dict
        The front as ``catopt design --out`` wrote it (schema catopt.design/1).
    number : int
        Which design, counted from 1.
    """

    document: dict[str, Any]
    number: int


@dataclass(frozen=True)
class Note:
    """Everything that the page shows.

    Attributes
    ----------
    case : Case
        With the line of the note; under the load that is drawn.
    load_case : str
        Name of the load case that is drawn; empty when there is only the load.
    solution : Solution
        The line under it.
    checks : CheckReport
        Under every load case.
    curve : CaseCurve or None
        None where it cannot be computed; `warnings` then says why.
    origin : Origin
        The files that it rests on.
    chosen : Chosen or None
        When the line is a design of a front.
    warnings : tuple of str
        What an engineer should know before using the note, each once.
    verification : Verification or None
        The line under the load that is drawn by the truss model, too; None where it was left out
        or failed.
    verification_failure : str
        Why the truss model has no answer; empty where it has one or was left out.
    """

    case: Case
    load_case: str
    solution: Solution
    checks: CheckReport
    curve: CaseCurve | None
    origin: Origin
    chosen: Chosen | None = None
    warnings: tuple[str, ...] = ()
    verification: Verification | None = None
    verification_failure: str = ""

    kind: ClassVar[str] = "page.kind"
    """Key of the text that says what kind of note it is."""

    @property
    def title(self) -> str:
        """Title of the case; empty when it has none."""
        return self.case.title


def read_note(
    path: Path, design: int | None = None, *, date: str = "", verify: bool = True
) -> Note:
    """Read a case file, or a design out of a result directory, and compute its note.

    Parameters
    ----------
    path : Path
        A case file, or a directory that ``catopt design --out`` wrote.
    design : int, optional
        Number of the design, counted from 1; the recommended one when left out.
    date : str
        For the title block.
    verify : bool
        Whether the truss model is put beside the closed form.

    Raises
    ------
    InputError, NoAnswerError, NotConvergedError
        As for `read_case`, `read_design`, `solve_case` and `check_case`.
    """
    if design is None and not (path / DESIGN_DOCUMENT).is_file():
        case, source = read_case(path), read_source(path)
        _check_kind(case, source)
        return note_of(case, (source,), date=date, verify=verify)
    from catopt.casefile.design_directory import read_design_document

    document = read_design_document(path)
    number = document["recommended"] + 1 if design is None else design
    case = read_design(path, number)
    sources = (read_source(path / DESIGN_CASE), read_source(path / DESIGN_DOCUMENT))
    chosen = Chosen(document, number)
    return note_of(case, sources, date=date, chosen=chosen, verify=verify)


def _check_kind(case: Case, source: SourceFile) -> None:
    """Refuse a moored body, which has lines of its own and no load at a fairlead."""
    if case.system is not None:
        allowed = "this page is of one line; catopt system CASE --out DIR writes that of a body"
        raise InputError([Problem("system", "a table", allowed)], source.name)


def note_of(
    case: Case,
    files: tuple[SourceFile, ...],
    *,
    date: str = "",
    chosen: Chosen | None = None,
    verify: bool = True,
) -> Note:
    """Compute the note of a case.

    The line is drawn, and its equations are followed, under the load case of the check that
    governs; without load cases under its load.

    Parameters
    ----------
    case : Case
        What the first of the files says, or a design of it.
    files : tuple of SourceFile
        What the note rests on.
    date : str
        For the title block.
    chosen : Chosen, optional
        When the line is a design of a front.
    verify : bool
        Whether the truss model is put beside the closed form.
    """
    checks = check_case(case)
    load_case, drawn = _drawn(case, checks)
    solution = solve_case(drawn)
    curve, curve_warnings = _curve(drawn, solution)
    verification, failure = _verification(drawn, load_case) if verify else (None, "")
    of_the_search = () if chosen is None else chosen.document["warnings"]
    warnings = (
        *_doubts(verification, failure),
        *_warnings(case, checks, solution),
        *curve_warnings,
        *of_the_search,
    )
    return Note(
        case=drawn,
        load_case=load_case,
        solution=solution,
        checks=checks,
        curve=curve,
        origin=origin_of(files, date),
        chosen=chosen,
        warnings=tuple(dict.fromkeys(warnings)),
        verification=verification,
        verification_failure=failure,
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
    of_the_load = f'load case "{LOAD}": '
    for warning in checks.warnings:
        if warning != NO_CHECK and (case.load_cases or not warning.startswith(of_the_load)):
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
        stop = MOST_FORCE * solution.horizontal_force
        if 0.0 < stop < float(curve.curve.horizontal_force[-1]):
            with suppress(CatoptError):
                curve = curve_case(case, start=LEAST_FORCE * stop, stop=stop)
    except CatoptError as error:
        return None, (f"the load curve is left out: {error}",)
    return curve, ()


def _verification(case: Case, load_case: str) -> tuple[Verification | None, str]:
    """Put the truss model beside the closed form; say why where it has no answer."""
    from catopt.verify.case import LOAD, verify_case

    try:
        found = verify_case(replace(case, load_cases=()))
    except CatoptError as error:
        return None, str(error)
    (part,) = found.parts
    return replace(found, parts=(replace(part, name=load_case or LOAD),)), ""


def _doubts(verification: Verification | None, failure: str) -> Iterator[str]:
    """Yield what the truss model leaves in doubt."""
    if failure:
        yield f"the line is not verified, for the truss model has no answer: {failure}"
    if verification is not None and not verification.is_settled:
        yield "closed form and truss model differ: see the verification"
