"""The calculation note of a sizing as a workbook: its own sheets, and those of its line's note."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catopt.answers.check import verdict_sentence
from catopt.notes.size import SizeNote
from catopt.render.sheet import Book, Cell, Text
from catopt.render.texts import Language, Words
from catopt.report.page.sizing.identity import found, governing, identity, recommendation
from catopt.report.page.sizing.inputs import schema_of
from catopt.report.page.sizing.load_case import load_case_words, said_line
from catopt.report.workbook.note_checks import (
    checks_sheet,
    front_sheet,
    load_cases_sheet,
    neighbours_sheet,
    verification_sheet,
)
from catopt.report.workbook.note_components import catalogue_sheet, components_sheet
from catopt.report.workbook.note_line import curve_sheet, line_sheet
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
from catopt.report.workbook.note_size_choice import (
    candidates_sheet,
    hold_sheet,
    pattern_sheet,
    swing_sheet,
)
from catopt.report.workbook.note_size_loads import loads_sheet, numbers_sheet
from catopt.report.workbook.note_swarm import swarm_sheet

__all__ = ["size_note_workbook"]


def size_note_workbook(note: SizeNote, language: Language = "en") -> bytes:
    """Lay the calculation note of a sizing out.

    The same note gives the same bytes.

    Parameters
    ----------
    note : SizeNote
        What it shows.
    language : {"en", "vi"}
        Of its words.

    Returns
    -------
    bytes
        An .xlsx file with sheets of the sizing (Summary, Inputs, Loads, Numbers, Candidates, what
        holds the line, swing radius, several lines, assumptions) and of the recommended line
        (Line, Curve, Checks, Load cases, Front, Neighbours, Components, Catalogue, Verification,
        Swarm), each where there is something to show.
    """
    book = new_book(note, language)
    _summary(book, note)
    _inputs(book, note)
    loads_sheet(book, note)
    numbers_sheet(book, note)
    candidates_sheet(book, note)
    line = said_line(note.line, book.words)
    line_sheet(book, line)
    checks_sheet(book, line)
    load_cases_sheet(book, line)
    hold_sheet(book, note)
    swing_sheet(book, note)
    pattern_sheet(book, note)
    _assumptions(book, note)
    curve_sheet(book, line.curve)
    front_sheet(book, line.chosen)
    neighbours_sheet(book, line.chosen)
    components_sheet(book, line.solution)
    catalogue_sheet(book, line.case)
    verification_sheet(book, line)
    swarm_sheet(book, line)
    return book.close()


# ------------------------------------------------------------------ summary and inputs


def _summary(book: Book, note: SizeNote) -> None:
    """Write what is recommended, what governs it, warnings, the results and the title block."""
    words = book.words
    sheet = summary_sheet(book, note, SUMMARY_WIDTHS)
    checks = note.line.checks
    sheet.across(recommendation(note, words), "good" if checks.passes else "bad")
    sheet.across(words.sentence(verdict_sentence(checks)).text)
    sheet.row += 1
    sheet.across(words("size_identity.governs"), "title")
    for phrase in governing(note, words):
        sheet.across(phrase.text)
    warning_rows(sheet, note)
    sheet.row += 1
    value_grid(sheet, list(_found(note, words)), SUMMARY_WIDTHS)
    title_rows(sheet, identity(note, words)["table"])


def _found(note: SizeNote, words: Words) -> Iterator[Sequence[Cell]]:
    for label, quantity, value, load_case in found(note.sizing, words):
        at = f" ({load_case_words(load_case, words)})" if load_case else ""
        yield value_row(f"{label}{at}", quantity, value)


def _inputs(book: Book, note: SizeNote) -> None:
    """Write every value of the sizing file as it stands there and in SI, then the options."""
    words = book.words
    sheet = book.sheet("Inputs")
    if note.origin.files:
        inputs_grid(sheet, note.origin.inputs, schema_of(note))
    if note.options:
        options: list[Sequence[Cell]] = [
            (Text(name, "text"), value) for name, value in note.options
        ]
        headings = [words("size_inputs.option"), words("inputs.given")]
        sheet.grid(headings, options, title=words("size_inputs.typed"), widths=[44, 60])


def _assumptions(book: Book, note: SizeNote) -> None:
    """Write what the answer rests on, with what the loads assume."""
    words = book.words
    of = note.sizing
    sheet = book.sheet("Assumptions", words("size_assumptions.heading"))
    parts = (part for each in of.settled.posed.loads for part in each.parts)
    of_loads = tuple(dict.fromkeys(text for part in parts for text in part.assumptions))
    kinds = (
        (words("size_assumptions.heading"), (*of.assumptions, *of_loads)),
        (words("size_assumptions.defaults"), of.defaults),
        (words("size_assumptions.recalled"), of.recalled),
    )
    sheet.set_widths([110.0])
    for title, texts in kinds:
        if texts:
            sheet.across(title, "title")
            for text in texts:
                sheet.across(words.sentence(text).text)
            sheet.row += 1
