"""An answer as a workbook: a sheet for each section."""

from __future__ import annotations

from typing import Literal

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Facts,
    Graph,
    Section,
    Table,
    Text,
    Verdict,
    Warnings,
)
from catopt.quantities import Quantity
from catopt.render.sheet import Book, Cell, Chart, Number, Series, Sheet, number_pattern
from catopt.render.sheet import Text as Words
from catopt.render.values import shown
from catopt.words import Language, Listed, Message, say

__all__ = ["workbook"]

_WIDTHS = (44.0, 24.0)
"""Of a list of facts, in characters."""
_MOST_ROWS = 100_000
"""Of a table that a workbook holds; the CSV file has all of them."""


def workbook(answer: Answer, language: Language = "en") -> bytes:
    """Lay out all tables of an answer, every digit kept.

    Parameters
    ----------
    answer : Answer
        What is laid out.
    language : {"en", "vi"}
        Of headings and words.

    Returns
    -------
    bytes
        An .xlsx file.
    """
    book = Book(say(answer.title, language))
    for section in answer.sections:
        if any(_is_laid(block) for block in section.blocks):
            _sheet(book, section, language)
    return book.close()


def _is_laid(block: Block) -> bool:
    return isinstance(block, Table | Facts) and block.only != "people"


def _sheet(book: Book, section: Section, language: Language) -> None:
    title = say(section.title, language)
    sheet = book.sheet(title, title)
    tops: dict[str, int] = {}
    below = 1
    # The sheet's name says what its list or its only table is.
    is_alone = sum(map(_is_laid, section.blocks)) == 1
    for block in section.blocks:
        if isinstance(block, Table | Facts) and _is_laid(block):
            is_named = bool(tops) or (isinstance(block, Table) and not is_alone)
            caption = block.caption if is_named else ""
            tops[block.name] = _block(sheet, block, caption, language)
        elif isinstance(block, Graph):
            below = _graph(sheet, section, (tops[block.table], below), block, language)
    _said(sheet, section, language)


def _block(sheet: Sheet, block: Table | Facts, caption: str, language: Language) -> int:
    """Write a table below what is there; return the row of its headings."""
    title = say(caption, language)
    if isinstance(block, Facts):
        return _facts(sheet, block, title, language)
    columns = list(block.for_files())
    rows = range(min(block.length, _MOST_ROWS))
    cells = [[_cell(each, row, language) for row in rows] for each in columns]
    headings = [each.said_heading(language) for each in columns]
    top = sheet.grid(headings, list(zip(*cells, strict=True)), title=title)
    if block.length > _MOST_ROWS:
        _tell(sheet, Message("answers.first_rows", shown=_MOST_ROWS, count=block.length), language)
    return top


def _facts(sheet: Sheet, block: Facts, title: str, language: Language) -> int:
    rows = []
    for column in block.as_table().for_files():
        name = Words(column.said_heading(language), "text")
        rows.append((name, _cell(column, 0, language, is_left=True)))
    headings = [
        say(Message("columns.quantity_and_unit"), language),
        say(Message("columns.of_row", name=Message("columns.value")), language),
    ]
    return sheet.grid(headings, rows, title=title, widths=_WIDTHS)


def _graph(
    sheet: Sheet, section: Section, rows: tuple[int, int], block: Graph, language: Language
) -> int:
    """Draw columns of a table whose heading stands in the first row given, from the second one.

    It stands to the right of all tables; the row below it is returned.
    """
    table = next(
        each for each in section.blocks if isinstance(each, Table) and each.name == block.table
    )
    names = [each.said_heading(language) for each in table.for_files()]
    top, row = rows
    style: Literal["line", "points"] = "points" if block.points else "line"
    series = tuple(
        Series(names[y], (top + 1, top + table.length), block.x, y, style, index)
        for index, y in enumerate(block.y)
    )
    axis = say(Listed([names[y] for y in block.y], "and"), language)
    chart = Chart(say(block.title, language), names[block.x], axis, series, block.log)
    return sheet.chart(chart, row=row, column=max(sheet.widths) + 2)


def _said(sheet: Sheet, section: Section, language: Language) -> None:
    """Write what is said in words below the tables."""
    for block in section.blocks:
        for each in _words_of(block):
            _tell(sheet, each, language)


def _tell(sheet: Sheet, said: str, language: Language) -> None:
    sheet.write(sheet.row, 0, Words(say(said, language), "text"))
    sheet.row += 1


def _words_of(block: Block) -> tuple[str, ...]:
    if isinstance(block, Verdict):
        return (block.said,)
    if not isinstance(block, Text | Warnings) or block.only == "people":
        return ()
    return (block.said,) if isinstance(block, Text) else block.said


def _cell(column: Column, row: int, language: Language, *, is_left: bool = False) -> Cell:
    value, quantity = column.values[row], column.quantity_of(row)
    number = column.in_files(row)
    if isinstance(value, int | float) and not isinstance(number, str) and _is_finite(number):
        return Number(number, _pattern(quantity), is_left=is_left)
    if value is None and not is_left:
        return None
    return Words(shown(value, quantity, language), "wrapped")


def _is_finite(number: float | None) -> bool:
    return number is not None and number - number == 0.0


def _pattern(quantity: Quantity | None) -> str:
    return "General" if quantity is None else number_pattern(quantity)
