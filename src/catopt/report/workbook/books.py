"""Results as an .xlsx workbook with native charts; every heading carries its unit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Literal

import pandas as pd

from catopt.quantities import QUANTITIES
from catopt.report.tables import solution as tables
from catopt.report.texts import Language, Words
from catopt.report.wording.design import OBJECTIVES, said_change, said_governing
from catopt.report.wording.reproduction import said_among_numbers, said_note
from catopt.report.workbook.sheet import Book, Chart, Series, Sheet

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution, SwarmReport
    from catopt.checks.result import CheckReport
    from catopt.design.result import DesignResult
    from catopt.loads.component import Loads
    from catopt.model import Case
    from catopt.reproduce import Reproduction

__all__ = [
    "catalogue_workbook",
    "check_workbook",
    "curve_workbook",
    "design_workbook",
    "loads_workbook",
    "reproduction_workbook",
    "size_workbook",
    "solution_workbook",
    "system_workbook",
    "verification_workbook",
]


def solution_workbook(case: Case, solution: Solution, language: Language = "en") -> bytes:
    """Lay out a case and its solution.

    Parameters
    ----------
    case : Case
        What was given.
    solution : Solution
        What came out.
    language : {"en", "vi"}
        Of its words.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Inputs, Results, Line shape and, for a swarm, Swarm.
    """
    book = Book(solution.title, Words(language))
    _inputs(book, case, solution)
    _results(book, solution)
    _line_shape(book, solution)
    if solution.swarm is not None:
        _swarm(book, solution.swarm)
    return book.close()


def curve_workbook(result: CaseCurve, language: Language = "en") -> bytes:
    """Lay out a load curve, its marks, and the case that it belongs to.

    Parameters
    ----------
    result : CaseCurve
        What came out.
    language : {"en", "vi"}
        Of its words.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Inputs, Results, Curve and Marks.
    """
    book = Book(result.case.title, Words(language))
    _inputs(book, result.case, result.reference)
    _results(book, result.reference)
    frame = tables.curve_points(result)
    sheet = book.sheet("Curve")
    sheet.table(frame)
    span, _, force, tension, *_ = frame.columns
    place = (1, len(frame.columns) + 1)
    _draw(sheet, frame, span, (force, tension), result.case.title, place=place)
    book.sheet("Marks").table(tables.curve_marks(result))
    return book.close()


def reproduction_workbook(result: Reproduction, language: Language = "en") -> bytes:
    """Lay out printed numbers beside computed ones, and what was found.

    Parameters
    ----------
    result : Reproduction
        What came out.
    language : {"en", "vi"}
        Of its words; names of studies and of printed quantities are those of the JSON document.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Comparison, Inputs and Findings.
    """
    words = Words(language)
    book = Book(words.name("Published figures beside catopt's"), words)
    comparison = tables.reproduction(result)
    comparison["Note"] = [said_note(words, item) for item in result.items]
    rounded = "Computed, rounded as printed (unit of the row)"
    said = {"Method", rounded, "Computed by", "Verdict"}
    book.sheet("Comparison").table(comparison, said=said)
    given = book.sheet("Inputs")
    found = book.sheet("Findings")
    given.table(
        pd.DataFrame(
            [
                (
                    study.name,
                    words.sentence(each.quantity).text,
                    said_among_numbers(words, each.value),
                    each.unit,
                    words.sentence(each.origin).text,
                )
                for study in result.studies
                for each in study.inputs
            ],
            columns=["Study", "Quantity", "Value (unit of the row)", "Unit", "Origin"],
        ),
        said=(),
    )
    found.table(
        pd.DataFrame(
            [
                (study.name, words.sentence(text).text)
                for study in result.studies
                for text in study.findings
            ],
            columns=["Study", "Finding"],
        ),
        wrap=True,
        said=(),
    )
    for study in result.studies:
        if study.side_by_side:
            sheet = book.sheet(study.name, study.name)
            for table in study.side_by_side:
                rows = [[said_among_numbers(words, cell) for cell in row] for row in table.rows]
                frame = pd.DataFrame(rows, columns=list(table.header))
                sheet.table(frame, title=table.title, wrap=True, said=())
    return book.close()


def design_workbook(result: DesignResult, language: Language = "en") -> bytes:
    """Lay out the front of a design search.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Front, Recommended, Components, Checks and Search.
    """
    from catopt.report.tables import design

    book = Book(result.case.title, Words(language))
    frame = design.front(result)
    governing = [said_governing(book.words, point.governing) for point in result.front]
    frame["Governing check (load case)"] = governing
    sheet = book.sheet("Front")
    sheet.table(frame)
    x, y = (OBJECTIVES[key].heading for key in result.objectives[:2])
    _draw(sheet, frame, x, (y,), result.case.title, place=(len(frame) + 3, 1), style="points")
    recommended = book.sheet("Recommended")
    recommended.list_of(frame.iloc[[result.recommended]])
    steps = design.neighbours(result)
    changed = (*result.neighbours, result.present)
    steps[steps.columns[0]] = [said_change(book.words, each) for each in changed]
    recommended.table(steps, title="One step up or down", wrap=True)
    book.sheet("Components").table(design.components(result))
    book.sheet("Checks").table(design.design_checks(result))
    book.sheet("Search").list_of(design.search_summary(result))
    return book.close()


def check_workbook(report: CheckReport, language: Language = "en") -> bytes:
    """Lay out a report of checks.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Summary, Checks and Load cases.
    """
    from catopt.report.tables import checks

    book = Book(report.title, Words(language))
    book.sheet("Summary").list_of(checks.check_summary(report))
    book.sheet("Checks").table(checks.checks(report), wrap=True)
    book.sheet("Load cases").table(checks.load_cases(report))
    return book.close()


def catalogue_workbook(frames: Mapping[str, pd.DataFrame], language: Language = "en") -> bytes:
    """Lay out an answer out of the catalogue.

    Parameters
    ----------
    frames : mapping of str to DataFrame
        Its tables by name.
    language : {"en", "vi"}
        Of its words; names, keys and what is cited are the same in both.

    Returns
    -------
    bytes
        An .xlsx file with a sheet for each table.
    """
    from catopt.report.tables.catalogue import said_tables

    words = Words(language)
    book = Book(words.name("Components with the source of every figure"), words)
    for name, frame in said_tables(words, frames).items():
        book.sheet(name.capitalize()).table(frame, wrap=True, said=())
    return book.close()


def system_workbook(
    title: str, frames: Mapping[str, pd.DataFrame], language: Language = "en"
) -> bytes:
    """Lay out a moored body: a sheet for itself and one for each further table.

    Parameters
    ----------
    title : str
        Of the case.
    frames : mapping of str to DataFrame
        As `catopt.report.tables.system.frames` makes them.
    language : {"en", "vi"}
        Of its words.
    """
    book = Book(title, Words(language))
    for name, frame in frames.items():
        sheet = book.sheet(name.replace("_", " ").capitalize())
        if name == "body":
            sheet.list_of(frame)
            continue
        sheet.table(frame)
        if name.startswith("restoring"):
            _, offset, force, *_ = frame.columns
            _draw(sheet, frame, offset, (force,), title, place=(1, len(frame.columns) + 1))
    return book.close()


def verification_workbook(
    title: str, frames: Mapping[str, pd.DataFrame], language: Language = "en"
) -> bytes:
    """Lay out a verification: a sheet for each of its tables.

    Parameters
    ----------
    title : str
        Of the case or the search.
    frames : mapping of str to DataFrame
        As `said_frames` or `workbook_frames` of `catopt.report.tables` makes them.
    language : {"en", "vi"}
        Of its words.
    """
    book = Book(title, Words(language))
    for name, frame in frames.items():
        said = book.words("tab.runs") if name == "runs" else ""
        sheet = book.sheet(name.capitalize(), said)
        sheet.table(frame, wrap=name in {"designs", "verdicts"})
    return book.close()


def loads_workbook(of: Loads, language: Language = "en") -> bytes:
    """Lay out loads: forces, numbers, assumptions and warnings.

    Parameters
    ----------
    of : Loads
        On a buoy or a ship.
    language : {"en", "vi"}
        Of its words; formulas, numbers and sources are the same in both.

    Returns
    -------
    bytes
        An .xlsx file.
    """
    from catopt.report.tables import loads

    words = Words(language)
    book = Book(words.sentence(of.title).text, words)
    said = loads.SAID
    book.sheet("Forces").table(loads.loads_table(of), wrap=True, said=said)
    book.sheet("Numbers").table(loads.load_numbers(of), wrap=True, said=said)
    book.sheet("Notes").table(loads.load_notes(of), wrap=True, said=said)
    return book.close()


def size_workbook(
    title: str, frames: Mapping[str, pd.DataFrame], language: Language = "en"
) -> bytes:
    """Lay out a sizing: a sheet for each of its tables.

    Parameters
    ----------
    title : str
        Of its case.
    frames : mapping of str to DataFrame
        As `catopt.report.tables.size.size_tables` makes them.
    language : {"en", "vi"}
        Of its words; components, formulas, numbers and sources are the same in both.
    """
    from catopt.report.tables.size import SAID, SHOTS

    words = Words(language)
    book = Book(title, words)
    # Columns of units and documents, but for these two of the code's own words.
    own = {"Unit": {SHOTS: words.name(SHOTS)}, "Source": {"case file": words.name("case file")}}
    for name, frame in frames.items():
        book.sheet(name.capitalize()).table(frame.replace(own), said=SAID)
    return book.close()


# ------------------------------------------------------------------ sheets


def _inputs(book: Book, case: Case, solution: Solution) -> None:
    sheet = book.sheet("Inputs")
    sheet.list_of(tables.inputs(case))
    sheet.table(tables.segment_inputs(case.line), title="Segments, from the anchor to the fairlead")
    if case.line.point_loads:
        sheet.table(tables.point_load_inputs(case.line), title="Point loads")
    if solution.swarm is not None:
        sheet.table(tables.swarm_settings(case), title="Swarm")


def _results(book: Book, solution: Solution) -> None:
    sheet = book.sheet("Results")
    sheet.list_of(tables.summary(solution))
    sheet.table(tables.segments(solution), title="Segments, from the anchor to the fairlead")
    if solution.point_loads:
        sheet.table(tables.point_loads(solution), title="Point loads")


def _line_shape(book: Book, solution: Solution) -> None:
    frame = tables.profile(solution)
    sheet = book.sheet("Line shape")
    sheet.table(frame)
    s, x, z, tension = (QUANTITIES[key].heading for key in ("s", "x", "z", "tension"))
    _draw(sheet, frame, x, (z,), book.words.name("Line shape"), place=(1, 5))
    title = book.words.name("Tension along the line")
    _draw(sheet, frame, s, (tension,), title, place=(21, 5))


def _swarm(book: Book, swarm: SwarmReport) -> None:
    history, runs = tables.swarm_history(swarm), tables.swarm_runs(swarm)
    sheet = book.sheet("Swarm")
    sheet.table(history)
    sheet.table(runs, column=len(history.columns) + 1)
    iteration, objective, tension, _ = history.columns
    place = len(history.columns) + len(runs.columns) + 2
    # Excel leaves out what is 0 on a logarithmic axis; the title says so.
    title = book.said_heading(f"{objective}; exact zeros are not drawn")
    decades = _decades(history[objective])
    _draw(sheet, history, iteration, (objective,), title, place=(1, place), log=decades)
    _draw(sheet, history, iteration, (tension,), book.said_heading(tension), place=(21, place))


def _draw(
    sheet: Sheet,
    frame: pd.DataFrame,
    x: str,
    columns: tuple[str, ...],
    title: str,
    *,
    place: tuple[int, int],
    log: tuple[float, float] | None = None,
    style: Literal["line", "points"] = "line",
) -> None:
    """Draw columns of a table that starts in the first row and column over another of them.

    The title stands there as it is; a case's own is in no table of texts.
    """
    said = sheet.book.said_heading
    places = list(frame.columns)
    series = tuple(
        Series(said(name), (1, len(frame)), places.index(x), places.index(name), style, index)
        for index, name in enumerate(columns)
    )
    axis = f" {sheet.book.words('workbook.and')} ".join(said(name) for name in columns)
    row, column = place
    sheet.chart(Chart(title, said(x), axis, series, log), row=row, column=column)


def _decades(values: pd.Series[float]) -> tuple[float, float] | None:
    """Find the powers of ten around the positive values; None when there are none."""
    positive = values[values > 0.0]
    if positive.empty:
        return None
    low, high = math.floor(math.log10(positive.min())), math.ceil(math.log10(positive.max()))
    return 10.0**low, 10.0 ** max(high, low + 1)
