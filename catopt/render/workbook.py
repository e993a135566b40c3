"""An answer as a workbook: a sheet for each section."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final, Literal

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Facts,
    Figure,
    Graph,
    Points,
    Section,
    Table,
    Text,
    Trail,
    Verdict,
    Warnings,
)
from catopt.quantities import Quantity
from catopt.render.drawing import draw
from catopt.render.sheet import Book, Cell, Chart, Number, Series, Sheet, Style, number_pattern
from catopt.render.sheet import Text as Words
from catopt.render.trail import in_numbers, in_symbols
from catopt.render.units import as_wanted
from catopt.render.values import shown
from catopt.words import Language, Listed, Message, say

_WIDTHS = (44.0, 24.0)
"""Of a list of facts, in characters."""
_MOST_ROWS = 100_000
"""Of a table that a workbook holds; the CSV file has all of them."""
_READABLE = 90.0
"""Least width of what is said in words, in characters."""
_STEPS = (40.0, 12.0, 56.0, 18.0, 9.0, 18.0, 40.0)
"""Of the columns of a trail."""


def workbook(answer: Answer, language: Language = "en") -> bytes:
    """Lay out all tables of an answer, every digit kept."""
    answer = as_wanted(answer)
    book = Book(say(answer.title, language), language)
    charts = sum(isinstance(block, Figure) for block in answer.blocks)
    # The cells of drawings stand on the last sheet, which the charts before it refer to.
    drawings: list[tuple[Sheet, Figure, int, int]] = []
    for section in answer.sections:
        # Notes say on sheets of their own what is said in words alone.
        has_words = bool(answer.kind) and any(_words_of(block) for block in section.blocks)
        if has_words or any(_is_laid(block) for block in section.blocks):
            drawings += _sheet(book, section, language)
    if charts:
        name = say(Message("page.drawings"), language)
        cells = book.sheet(name)
        below: dict[str, int] = {}
        for sheet, figure, row, column in drawings:
            start = below.get(sheet.name, row)
            below[sheet.name] = draw(figure.chart, sheet, cells, start, column, language)
    return book.close()


def _is_laid(block: Block) -> bool:
    if isinstance(block, Table | Facts):
        return block.only != "people"
    return isinstance(block, Trail | Figure) or (isinstance(block, Points) and bool(block.said))


def _sheet(
    book: Book, section: Section, language: Language
) -> list[tuple[Sheet, Figure, int, int]]:
    """Lay a section out; return its drawings with their places."""
    title = say(section.title, language)
    sheet = book.sheet(title)
    tops: dict[str, int] = {}
    below = 1
    # The sheet's name says what its list or its only table is.
    is_alone = sum(map(_is_laid, section.blocks)) == 1
    for block in section.blocks:
        if isinstance(block, Table | Facts) and _is_laid(block):
            is_named = bool(tops) or (isinstance(block, Table) and not is_alone)
            caption = block.caption if is_named else ""
            tops[block.name] = _block(sheet, block, caption, language)
        elif isinstance(block, Trail):
            _trail(sheet, block, language)
        elif isinstance(block, Graph):
            below = _graph(sheet, section, (tops[block.table], below), block, language)
    _said(sheet, section, language)
    column = max(sheet.widths, default=-2) + 2
    figures = [block for block in section.blocks if isinstance(block, Figure)]
    return [(sheet, figure, 1, column) for figure in figures]


def _block(sheet: Sheet, block: Table | Facts, caption: str, language: Language) -> int:
    """Write a table below what is there; return the row of its headings."""
    title = say(caption, language)
    if isinstance(block, Facts):
        return _facts(sheet, block, title, language)
    columns = list(block.for_files())
    rows = range(min(block.length, _MOST_ROWS))
    first = sheet.row + (2 if title else 1)
    cells = [
        [_computed(columns, each, row, first + row, language) for row in rows] for each in columns
    ]
    headings = [each.said_heading(language) for each in columns]
    top = sheet.grid(headings, list(zip(*cells, strict=True)), title=title)
    if block.length > _MOST_ROWS:
        _tell(sheet, Message("answers.first_rows", shown=_MOST_ROWS, count=block.length), language)
    return top


def _computed(
    columns: Sequence[Column], column: Column, row: int, place: int, language: Language
) -> Cell:
    """Write a cell, as a formula where the spreadsheet can compute it."""
    cell = _cell(column, row, language)
    if column.formula is None or not isinstance(cell, Number):
        return cell
    first, sign, second = column.formula
    left, right = (f"{_letter(columns.index(each))}{place + 1}" for each in (first, second))
    return replace(cell, formula=f"={left}{sign}{right}")


def _letter(column: int) -> str:
    """Name a column; tables have fewer than 26."""
    return chr(ord("A") + column)


def _trail(sheet: Sheet, block: Trail, language: Language) -> None:
    """Write steps: what comes out, its equation, its numbers put in, and what others have."""
    names = ["page.what", "page.equation", "page.put_in", "page.value", "columns.unit"]
    headings = [say(Message(name), language) for name in names]
    headings += [say(block.stated, language), say(Message("page.source"), language)]
    rows = [
        (
            Words(say(step.name, language), "wrapped"),
            Words(step.equation, "text"),
            Words("\n= ".join(each for each in (in_symbols(step), in_numbers(step)) if each)),
            _of(step.quantity, step.value),
            Words(step.quantity.field_unit, "text"),
            _of(step.quantity, step.stated),
            Words(say(step.source, language)),
        )
        for step in block.steps
    ]
    sheet.grid(headings, rows, title=say(block.caption, language), widths=_STEPS)


def _of(quantity: Quantity, si: float | None) -> Cell:
    return None if si is None else Number(quantity.in_files(si), _pattern(quantity))


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


_VERDICTS: Final[Mapping[str, Style]] = {
    "": "grey",
    "passes": "good",
    "reserve": "amber",
    "fails": "bad",
}
"""Style of a verdict by its kind."""


def _said(sheet: Sheet, section: Section, language: Language) -> None:
    """Write what is said in words below the tables."""
    if any(map(_words_of, section.blocks)):
        sheet.widen(_READABLE)
    for block in section.blocks:
        style: Style = "wrapped"
        if isinstance(block, Verdict):
            style = _VERDICTS[block.kind]
        for each in _words_of(block):
            sheet.across(say(each, language), style)


def _tell(sheet: Sheet, said: str, language: Language) -> None:
    sheet.write(sheet.row, 0, Words(say(said, language), "text"))
    sheet.row += 1


def _words_of(block: Block) -> tuple[str, ...]:
    if isinstance(block, Verdict):
        return (block.words,)
    if isinstance(block, Points):
        return (block.caption, *block.said) if block.caption and block.said else block.said
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
