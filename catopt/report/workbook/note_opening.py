"""What the workbook of every kind of note opens with: the head of its summary, and its inputs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, ClassVar, Protocol

from catopt.casefile.fields import Kind, Measured
from catopt.casefile.schema import Table as Schema
from catopt.documents import dotted
from catopt.quantities import Quantity
from catopt.render.sheet import Book, Cell, Number, Sheet, Text
from catopt.render.texts import Language, Words
from catopt.report.page.inputs import given_values, some
from catopt.report.page.table import Table
from catopt.report.workbook.note_cells import number_of, unit_of
from catopt.units import as_written

__all__ = [
    "SUMMARY_WIDTHS",
    "Titled",
    "inputs_grid",
    "new_book",
    "summary_sheet",
    "title_rows",
    "value_grid",
    "value_row",
    "warning_rows",
]

SUMMARY_WIDTHS = (46.0, 15.0, 9.0, 22.0, 9.0)
"""Of the summary: quantity, value, unit, the same in SI; that of a body has wider columns."""
_HEADINGS = (
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


class Titled(Protocol):
    """What every kind of note has at its head."""

    kind: ClassVar[str]
    """Key of the text that says what kind of note it is."""

    untitled: ClassVar[str]
    """Key of the title of a case without one."""

    @property
    def title(self) -> str:
        """Title of the case; empty when it has none."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """What an engineer should know before using the note."""


def new_book(note: Titled, language: Language) -> Book:
    """Begin the workbook of a note, with its title and its language."""
    words = Words(language)
    return Book(note.title or words(note.untitled), words, typeset=True)


def summary_sheet(book: Book, note: Titled, widths: Sequence[float]) -> Sheet:
    """Begin the summary, on one upright page: the title, and what kind of note it is.

    Parameters
    ----------
    book : Book
        Where to.
    note : Titled
        What it shows.
    widths : sequence of float
        Of the columns, in characters: quantity, value, unit, the same in SI.
    """
    words = book.words
    sheet = book.sheet("Summary")
    sheet.worksheet.set_portrait()
    sheet.worksheet.fit_to_pages(1, 1)
    sheet.set_widths(widths)
    sheet.across(note.title or words(note.untitled), "large")
    sheet.across(words(note.kind), "grey")
    return sheet


def warning_rows(sheet: Sheet, note: Titled) -> None:
    """Write what an engineer should know before using the note; nothing where that is nothing."""
    words = sheet.book.words
    if note.warnings:
        sheet.row += 1
        sheet.across(words("warnings.heading"), "title")
        for warning in note.warnings:
            sheet.across(words.sentence(warning).text)


def title_rows(sheet: Sheet, block: Table) -> None:
    """Write the rows of the page's title block: what is called so, and what it is."""
    for label, value in block.rows:
        sheet.pair(label.text, value.text)


def value_grid(sheet: Sheet, rows: Sequence[Sequence[Cell]], widths: Sequence[float]) -> None:
    """Write values under the headings of the summary; each row as `value_row` makes it."""
    words = sheet.book.words
    sheet.grid([words(key) for key in _HEADINGS], rows, widths=widths, right=(1, 3))


def value_row(name: Cell, quantity: Quantity, si: float | None) -> Sequence[Cell]:
    """Lay a value out: what it is called, the value in the field's unit, and the same in SI."""
    return (
        name,
        number_of(quantity, si),
        Text(unit_of(quantity.field_unit), "text"),
        Number(si),
        Text(unit_of(quantity.si_unit), "text"),
    )


def inputs_grid(sheet: Sheet, document: dict[str, Any], schema: type[Schema]) -> None:
    """Write every value of a file as it stands there and in SI.

    Parameters
    ----------
    sheet : Sheet
        Where to.
    document : dict
        The file as the TOML reader returns it.
    schema : type of Table
        What the file may hold.
    """
    words = sheet.book.words
    rows = [
        row
        for path, kind, value in given_values(document, schema)
        for row in _input_rows(dotted(path), kind, value)
    ]
    keys = ("inputs.key", "inputs.given", "inputs.si", "workbook.si_unit")
    sheet.grid([words(key) for key in keys], rows, widths=[44, 60, 22, 12], right=(2,))


def _input_rows(key: str, kind: Kind | None, value: Any) -> Iterator[Sequence[Cell]]:
    """Yield the rows of one value of a file: as it stands there, in SI, and the SI unit."""
    if isinstance(value, list) and len(value) > _MOST:
        yield Text(key, "text"), some(value, str), None, None
    elif isinstance(value, list):
        for index, each in enumerate(value):
            yield from _input_rows(f"{key}[{index}]", kind, each)
    else:
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        as_given = value if isinstance(value, str) else as_written(value, _LONGEST)
        yield (
            Text(key, "text"),
            Number(value, is_left=True) if is_number else as_given[:_LONGEST],
            Number(kind.read(value)) if isinstance(kind, Measured) else None,
            Text(kind.dimension.si_unit, "text") if isinstance(kind, Measured) else None,
        )
