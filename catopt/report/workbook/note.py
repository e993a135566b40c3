"""The calculation note as a workbook: a sheet for each part, with native charts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from catopt.answers.check import governing_sentence, verdict_sentence
from catopt.casefile.schema import CaseTable
from catopt.notes.line import Note
from catopt.render.sheet import Book, Cell, Sheet, Style, Text
from catopt.render.texts import Language, Words
from catopt.report.page.identity import identity
from catopt.report.page.table import label_of
from catopt.report.tables.summary import Entry, found, given, residuals, results
from catopt.report.workbook.note_cells import number_of, unit_of
from catopt.report.workbook.note_checks import (
    checks_sheet,
    front_sheet,
    load_cases_sheet,
    neighbours_sheet,
    verification_sheet,
)
from catopt.report.workbook.note_components import catalogue_sheet, components_sheet
from catopt.report.workbook.note_line import curve_sheet, line_sheet
from catopt.report.workbook.note_motion import motion_sheet
from catopt.report.workbook.note_opening import (
    SUMMARY_WIDTHS,
    inputs_grid,
    new_book,
    summary_sheet,
    title_rows,
    value_grid,
    value_row,
    warning_rows,
)
from catopt.report.workbook.note_swarm import swarm_sheet

__all__ = ["note_workbook"]


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
    book = new_book(note, language)
    _summary(book, note)
    _inputs(book, note)
    components_sheet(book, note.solution)
    catalogue_sheet(book, note.case)
    line_sheet(book, note)
    curve_sheet(book, note.curve)
    checks_sheet(book, note)
    load_cases_sheet(book, note)
    front_sheet(book, note.chosen)
    neighbours_sheet(book, note.chosen)
    verification_sheet(book, note)
    swarm_sheet(book, note)
    motion_sheet(book, note)
    return book.close()


# ------------------------------------------------------------------ summary and inputs


def _summary(book: Book, note: Note) -> None:
    """Write the title, the verdict, warnings, the title block and the results."""
    words = book.words
    sheet = summary_sheet(book, note, SUMMARY_WIDTHS)
    _verdict(sheet, note)
    warning_rows(sheet, note)
    sheet.row += 1
    sheet.across(words("identity.heading"), "title")
    title_rows(sheet, identity(note, words)["table"])
    solution = note.solution
    came_out = (*found(solution), *results(solution), *residuals(solution))
    for title, entries in (("workbook.given", given(note.case)), ("results.heading", came_out)):
        sheet.row += 1
        sheet.across(words(title), "title")
        value_grid(sheet, list(_entry_rows(entries, words)), SUMMARY_WIDTHS)
        sheet.row -= 1


def _verdict(sheet: Sheet, note: Note) -> None:
    checks = note.checks
    style: Style = "grey" if not checks.results else "good" if checks.passes else "bad"
    for english in (verdict_sentence(checks), governing_sentence(checks)):
        if english:
            sheet.across(sheet.book.words.sentence(english).text, style)


def _entry_rows(entries: Iterable[Entry], words: Words) -> Iterator[Sequence[Cell]]:
    """Yield what is known in each unit that it is shown in, and in SI."""
    for entry in entries:
        if entry.value is None:
            continue
        name = Text(label_of(words, entry.quantity), "text")
        yield value_row(name, entry.quantity, entry.value)
        for quantity in entry.also:
            unit = Text(unit_of(quantity.field_unit), "text")
            yield Text("", "text"), number_of(quantity, entry.value), unit, None, Text("", "text")


def _inputs(book: Book, note: Note) -> None:
    """Write every value of the case file as it stands there and in SI."""
    sheet = book.sheet("Inputs")
    inputs_grid(sheet, note.origin.inputs, CaseTable)
    if note.chosen is not None:
        sheet.across(book.words("inputs.design", number=note.chosen.number))
