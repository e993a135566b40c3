"""An answer as a workbook: a sheet for each section."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from xlsxwriter.utility import xl_rowcol_to_cell

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
from catopt.render.page import put_in
from catopt.render.sheet import (
    Book,
    Cell,
    Chart,
    Number,
    Series,
    Style,
    WorkbookSheet,
    number_pattern,
)
from catopt.render.sheet import Text as Words
from catopt.render.values import as_text, as_wanted
from catopt.words import Language, Listed, Message

_WIDTHS = (44.0, 24.0)
"""Of a list of facts, in characters."""
_MOST_ROWS = 100_000
"""Of a table that a workbook holds; the CSV file has all of them."""
_READABLE = 90.0
"""Least width of what is said in words, in characters."""
_STEPS = (40.0, 12.0, 56.0, 18.0, 9.0, 18.0, 40.0)
"""Of the columns of a trail."""
_VERDICTS: dict[str, Style] = {
    "": "grey",
    "passes": "good",
    "in-part": "fair",
    "fails": "bad",
}
"""Style of a verdict by its kind."""
_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#7F7F7F")
_DASHES = ("solid", "dash", "long_dash", "dash_dot", "square_dot", "solid")
_MARKERS = ("circle", "diamond", "triangle", "square", "x", "plus")
"""Of the columns of a graph."""


def workbook(answer: Answer, language: Language = "en") -> bytes:
    """Lay out all tables of an answer, every digit kept."""
    answer = as_wanted(answer, language)
    book = Book(answer.title, language)
    drawn: list[tuple[WorkbookSheet, list[Figure]]] = []
    for section in answer.sections:
        # Notes say on sheets of their own what is said in words alone.
        has_words = bool(answer.kind) and any(map(_words_of, section.blocks))
        if has_words or any(map(_is_laid, section.blocks)):
            sheet = _sheet(book, section)
            drawn.append((sheet, [each for each in section.blocks if isinstance(each, Figure)]))
    if any(figures for _, figures in drawn):
        # The cells of drawings are on the last sheet, which the charts before it refer to.
        cells = book.sheet(Message("page.drawings"))
        for sheet, figures in drawn:
            row = 1
            for figure in figures:
                row = draw(figure.chart, sheet, cells, row)
    return book.close()


def _is_laid(block: Block) -> bool:
    if isinstance(block, Table | Facts):
        return block.only != "people"
    return isinstance(block, Trail | Figure) or (isinstance(block, Points) and bool(block.said))


def _sheet(book: Book, section: Section) -> WorkbookSheet:
    """Lay a section out, but for its drawings."""
    sheet = book.sheet(section.title)
    tops: dict[str, int] = {}
    below = 1
    # The sheet's name says what its list or its only table is.
    is_alone = sum(map(_is_laid, section.blocks)) == 1
    for block in section.blocks:
        if isinstance(block, Table | Facts) and _is_laid(block):
            is_named = bool(tops) or (isinstance(block, Table) and not is_alone)
            tops[block.name] = _block(sheet, block, block.caption if is_named else "")
        elif isinstance(block, Trail):
            _trail(sheet, block)
        elif isinstance(block, Graph):
            tables = (each for each in section.blocks if isinstance(each, Table))
            (table,) = (each for each in tables if each.name == block.table)
            below = _graph(sheet, table, tops[block.table], block, below)
    if any(map(_words_of, section.blocks)):
        sheet.widen(_READABLE)
    for block in section.blocks:
        style = _VERDICTS[block.kind] if isinstance(block, Verdict) else "wrapped"
        for each in _words_of(block):
            sheet.across(each, style)
    return sheet


def _block(sheet: WorkbookSheet, block: Table | Facts, title: str) -> int:
    """Write a table below what is there; return the row of its headings."""
    language = sheet.book.language
    if isinstance(block, Facts):
        value = Message("columns.of_row", name=Message("columns.value"))
        headings = [sheet.book.say(each) for each in (Message("columns.quantity_and_unit"), value)]
        facts = [
            (Words(each.said_heading(language), "text"), _cell(sheet, each, 0, is_left=True))
            for each in block.as_table().for_files()
        ]
        return sheet.grid(headings, facts, title, _WIDTHS)
    columns = list(block.for_files())
    rows = range(min(block.length, _MOST_ROWS))
    first = sheet.row + (2 if title else 1)
    cells = [[_computed(sheet, columns, each, row, first) for each in columns] for row in rows]
    top = sheet.grid([each.said_heading(language) for each in columns], cells, title)
    if block.length > _MOST_ROWS:
        left_out = Message("answers.first_rows", shown=_MOST_ROWS, count=block.length)
        sheet.write(sheet.row, 0, Words(sheet.book.say(left_out), "text"))
        sheet.row += 1
    return top


def _computed(
    sheet: WorkbookSheet, columns: Sequence[Column], column: Column, row: int, first: int
) -> Cell:
    """Write a cell, as a formula where the spreadsheet can compute it; rows begin at `first`."""
    cell = _cell(sheet, column, row)
    if column.formula is None or not isinstance(cell, Number):
        return cell
    left, sign, right = column.formula
    demand, capacity = (
        xl_rowcol_to_cell(first + row, columns.index(each)) for each in (left, right)
    )
    return cell._replace(formula=f"={demand}{sign}{capacity}")


def _trail(sheet: WorkbookSheet, block: Trail) -> None:
    """Write steps: what comes out, its equation, its numbers put in, and what others have."""
    say = sheet.book.say
    names = ("page.what", "page.equation", "page.put_in", "page.value", "columns.unit")
    headings = [*(Message(name) for name in names), block.stated, Message("page.source")]
    rows = [
        (
            Words(step.name),
            Words(step.equation, "text"),
            Words(put_in(step)),
            _of(step.quantity, step.value),
            Words(step.quantity.field_unit, "text"),
            _of(step.quantity, step.stated),
            Words(step.source),
        )
        for step in block.steps
    ]
    sheet.grid([say(each) for each in headings], rows, block.caption, _STEPS)


def _of(quantity: Quantity, si: float | None) -> Cell:
    return None if si is None else Number(quantity.in_files(si), number_pattern(quantity, si))


def _graph(sheet: WorkbookSheet, table: Table, top: int, block: Graph, row: int) -> int:
    """Draw columns of a table whose headings are in row `top`; return the first row below."""
    names = [each.said_heading(sheet.book.language) for each in table.for_files()]
    series = [
        Series(names[y], (top + 1, top + table.length), block.x, y, _look(k, block.points))
        for k, y in enumerate(block.y)
    ]
    up = sheet.book.say(Listed([names[y] for y in block.y], "and"))
    return sheet.chart(Chart(block.title, names[block.x], up, series, block.log), row)


def _look(number: int, is_points: bool) -> dict[str, Any]:
    """Say how a spreadsheet draws a column of a graph, by its number."""
    colour = {"color": _COLOURS[number]}
    if not is_points:
        line = colour | {"width": 1.75, "dash_type": _DASHES[number]}
        return {"line": line, "marker": {"type": "none"}}
    marker = {"type": _MARKERS[number], "size": 7, "fill": colour}
    return {"line": {"none": True}, "marker": marker | {"border": colour | {"width": 0.75}}}


def _words_of(block: Block) -> tuple[str, ...]:
    """List what is said in words below the tables."""
    if isinstance(block, Verdict):
        return (block.said,)
    if isinstance(block, Points):
        return (block.caption, *block.said) if block.caption and block.said else block.said
    if not isinstance(block, Text | Warnings) or block.only == "people":
        return ()
    return (block.said,) if isinstance(block, Text) else block.said


def _cell(sheet: WorkbookSheet, column: Column, row: int, *, is_left: bool = False) -> Cell:
    value, quantity = column.values[row], column.quantity_of(row)
    number = column.in_files(row)
    if isinstance(value, int | float) and isinstance(number, int | float) and math.isfinite(number):
        return Number(number, number_pattern(quantity, value), is_left=is_left)
    if value is None and not is_left:
        return None
    return Words(sheet.book.say(as_text(value, quantity)))
