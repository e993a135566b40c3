"""The calculation note as a workbook: a sheet for each part, with native charts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from catopt.casefile.fields import Kind, Measured
from catopt.casefile.location import dotted
from catopt.casefile.schema import CaseTable
from catopt.quantities import QUANTITIES
from catopt.report.page.components import figures_of, looked_up, sources_of
from catopt.report.page.identity import identity
from catopt.report.page.inputs import FREE_TEXT, leaves, some
from catopt.report.page.note import Note
from catopt.report.page.table import called, label_of
from catopt.report.tables import solution as tables
from catopt.report.tables.checks import load_cases
from catopt.report.tables.summary import Entry, found, given, residuals, results
from catopt.report.texts import Language, Words
from catopt.report.wording.checks import governing_sentence, verdict_sentence
from catopt.report.workbook.note_cells import headed, number_of, unit_of
from catopt.report.workbook.note_checks import (
    checks_sheet,
    front_sheet,
    neighbours_sheet,
    verification_sheet,
)
from catopt.report.workbook.note_line import curve_sheet, line_sheet
from catopt.report.workbook.note_motion import motion_sheet
from catopt.report.workbook.note_swarm import swarm_sheet
from catopt.report.workbook.sheet import Book, Cell, Number, Sheet, Style, Text
from catopt.units import as_written

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.model import Case, Line

__all__ = [
    "catalogue_of",
    "catalogue_sheet",
    "components_of",
    "components_sheet",
    "entry_rows",
    "input_rows",
    "note_workbook",
]

_SUMMARY = (46.0, 15.0, 9.0, 22.0, 9.0)
"""Widths of the summary's columns: quantity, value, unit, the same in SI."""
_SUMMARY_HEADINGS = (
    "workbook.quantity",
    "workbook.value",
    "workbook.unit",
    "workbook.si",
    "workbook.si_unit",
)
_MOST = 12
"""Values of an array of the case file that get a row each; of a longer one the ends are told."""
_LONGEST = 250
"""Characters of a text of the case file that are shown."""


def note_workbook(note: Note, language: Language = "en") -> bytes:
    """Lay a calculation note out.

    The same note gives the same bytes.

    Parameters
    ----------
    note : Note
        What it shows.
    language : {"en", "vi"}
        Of its words.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Summary, Inputs, Components and Line; Catalogue, Curve,
        Checks, Load cases, Front, Neighbours, Verification, Swarm and Motion where there is
        something to show.
    """
    words = Words(language)
    book = Book(note.title or words(note.untitled), words, typeset=True)
    _summary(book, note)
    _inputs(book, note)
    components_sheet(book, note)
    catalogue_sheet(book, note)
    line_sheet(book, note)
    if note.curve is not None:
        curve_sheet(book, note.curve)
    if note.checks.results:
        checks_sheet(book, note)
    if len(note.checks.solutions) > 1:
        book.sheet("Load cases").table(load_cases(note.checks))
    if note.chosen is not None:
        front_sheet(book, note.chosen.document, note.chosen.number)
        neighbours_sheet(book, note.chosen.document)
    if note.verification is not None or note.verification_failure:
        verification_sheet(book, note)
    if note.swarm is not None:
        swarm_sheet(book, note)
    if note.motion is not None:
        motion_sheet(book, note)
    return book.close()


# ------------------------------------------------------------------ summary and inputs


def _summary(book: Book, note: Note) -> None:
    """Write the title, the verdict, warnings, the title block and the results."""
    words = book.words
    sheet = book.sheet("Summary")
    sheet.worksheet.set_portrait()
    sheet.worksheet.fit_to_pages(1, 1)
    sheet.set_widths(_SUMMARY)
    sheet.across(note.title or words(note.untitled), "large")
    sheet.across(words(note.kind), "grey")
    _verdict(sheet, note)
    if note.warnings:
        sheet.row += 1
        sheet.across(words("warnings.heading"), "title")
        for warning in note.warnings:
            sheet.across(words.sentence(warning).text)
    sheet.row += 1
    sheet.across(words("identity.heading"), "title")
    for label, value in identity(note, words)["table"].rows:
        sheet.pair(label.text, value.text)
    solution = note.solution
    came_out = (*found(solution), *results(solution), *residuals(solution))
    for title, entries in (("workbook.given", given(note.case)), ("results.heading", came_out)):
        sheet.row += 1
        sheet.across(words(title), "title")
        sheet.grid(
            [words(key) for key in _SUMMARY_HEADINGS],
            list(entry_rows(entries, words)),
            widths=_SUMMARY,
            right=(1, 3),
        )
        sheet.row -= 1


def _verdict(sheet: Sheet, note: Note) -> None:
    checks = note.checks
    style: Style = "grey" if not checks.results else "good" if checks.passes else "bad"
    for english in (verdict_sentence(checks), governing_sentence(checks)):
        if english:
            sheet.across(sheet.book.words.sentence(english).text, style)


def entry_rows(entries: Iterable[Entry], words: Words) -> Iterator[Sequence[Cell]]:
    """Yield what is known in each unit that it is shown in, and in SI."""
    for entry in entries:
        if entry.value is None:
            continue
        for quantity in (entry.quantity, *entry.also):
            first = quantity is entry.quantity
            yield (
                Text(label_of(words, quantity) if first else "", "text"),
                number_of(quantity, entry.value),
                Text(unit_of(quantity.field_unit), "text"),
                Number(entry.value) if first else None,
                Text(unit_of(quantity.si_unit) if first else "", "text"),
            )


def _inputs(book: Book, note: Note) -> None:
    """Write every value of the case file as it stands there and in SI."""
    words = book.words
    sheet = book.sheet("Inputs")
    rows = [
        row
        for path, kind, value in leaves(note.origin.inputs, CaseTable)
        if path not in {(key,) for key in FREE_TEXT}
        for row in input_rows(dotted(path), kind, value)
    ]
    headings = [
        words(key) for key in ("inputs.key", "inputs.given", "inputs.si", "workbook.si_unit")
    ]
    sheet.grid(headings, rows, widths=[44, 60, 22, 12], right=(2,))
    if note.chosen is not None:
        sheet.across(words("inputs.design", number=note.chosen.number))


def input_rows(key: str, kind: Kind | None, value: Any) -> Iterator[Sequence[Cell]]:
    """Yield the rows of one value of a file: as it stands there, in SI, and the SI unit."""
    if isinstance(value, list) and len(value) > _MOST:
        yield Text(key, "text"), some(value, str), None, None
    elif isinstance(value, list):
        for index, each in enumerate(value):
            yield from input_rows(f"{key}[{index}]", kind, each)
    else:
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        as_given = value if isinstance(value, str) else as_written(value, _LONGEST)
        yield (
            Text(key, "text"),
            Number(value, is_left=True) if is_number else as_given[:_LONGEST],
            Number(kind.read(value)) if isinstance(kind, Measured) else None,
            Text(kind.dimension.si_unit, "text") if isinstance(kind, Measured) else None,
        )


# ------------------------------------------------------------------ components


def components_sheet(book: Book, note: Note) -> None:
    """Write the figures of the line's parts, and what they carry."""
    components_of(book, note.solution)


def components_of(book: Book, solution: Solution) -> Sheet:
    """Write the figures of a line's parts, and what they carry; return the sheet."""
    words = book.words
    sheet = book.sheet("Components")
    line = solution.line
    keys = ("nominal_diameter", "length", "submerged_weight", "mass_per_length", "EA", "MBL")
    quantities = [QUANTITIES[key] for key in (*keys, "proof_load")]
    rows: list[Sequence[Cell]] = []
    for index, s in enumerate(line.segments, start=1):
        own = (
            s.nominal_diameter, s.length, s.submerged_weight, s.mass, s.EA, s.MBL, s.proof_load
        )  # fmt: skip
        numbers = [number_of(q, value) for q, value in zip(quantities, own, strict=True)]
        rows.append((Number(index), s.name or s.component, *numbers))
    headings = [words("components.segment"), words("components.name")]
    widths = (12, 34, 16, 16, 16, 16, 16, 16, 16)
    flush = range(2, 2 + len(quantities))
    sheet.grid([*headings, *(headed(words, q) for q in quantities)], rows,
        widths=widths, right=flush,
    )  # fmt: skip
    if line.point_loads:
        _point_loads(sheet, line)
    sheet.table(tables.segments(solution), title=words("workbook.carried"))
    if line.point_loads:
        sheet.table(tables.point_loads(solution), title=words("workbook.loads_carried"))
    return sheet


def catalogue_sheet(book: Book, note: Note) -> None:
    """Write where every figure of the catalogue comes from; no sheet where there is none."""
    catalogue_of(book, note.case)


def catalogue_of(book: Book, case: Case) -> None:
    """Write where every figure of the catalogue comes from that a case rests on."""
    words = book.words
    parts = list(looked_up(case))
    if not parts:
        return
    sheet = book.sheet("Catalogue")
    rows: list[Sequence[Cell]] = [
        (
            part.component.name,
            words.name(each.name),
            number_of(each.quantity, each.value),
            Text(each.quantity.field_unit, "text"),
            each.formula,
            Text(each.confidence, "text"),
            each.source or words("components.case_file"),
        )
        for part in parts
        for each in figures_of(part)
    ]
    sheet.grid(
        [
            words("workbook.component"),
            words("components.quantity"),
            words("components.value"),
            words("workbook.unit"),
            words("components.formula"),
            words("components.confidence"),
            words("components.source"),
        ],
        rows,
        widths=[30, 30, 14, 9, 34, 14, 60],
        right=(2,),
    )
    told = [f"{s.key}: {s.title}{f'. {s.place}' if s.place else ''}" for s in sources_of(parts)]
    for text in (words("components.legend"), *told):
        sheet.across(text)


def _point_loads(sheet: Sheet, line: Line) -> None:
    words = sheet.book.words
    quantities = [QUANTITIES[key] for key in ("position", "point_weight", "mass")]
    rows: list[Sequence[Cell]] = []
    for index, load in enumerate(line.point_loads, start=1):
        values = zip(quantities, (load.position, load.submerged_weight, load.mass), strict=True)
        name = called(words, load.submerged_weight, load.name)
        rows.append((Number(index), name, *(number_of(q, value) for q, value in values)))
    headings = [words("components.number"), words("components.name")]
    sheet.grid(
        [*headings, *(headed(words, q) for q in quantities)],
        rows,
        title=words("components.point_loads"),
        right=(2, 3, 4),
    )
