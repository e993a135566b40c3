"""An answer on a terminal of 80 columns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from textwrap import wrap
from typing import Protocol

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Facts,
    Points,
    Table,
    Text,
    Verdict,
    Warnings,
)
from catopt.render.values import cell, shown
from catopt.words import Language, Message, Sentence, Several, say

__all__ = ["Printer", "show"]

_WIDTH = 80
_GAP = 3
"""Columns between two columns of a table."""
_TEXT = 12
"""Characters that a column of words needs at least; longer ones fold."""
_HEADING, _TEXT_HEADING = 11, 24
"""Characters to which headings over words are folded at least, and at most over long ones."""
_SEEN = {"all", "people", "not csv"}
"""For whom tables and lists are that a terminal shows."""


class Printer(Protocol):
    """What paragraphs and tables are printed with."""

    def text(self, text: str, *, bold: bool = False) -> None:
        """Print a paragraph."""

    def line(self) -> None:
        """Print an empty line."""

    def table(
        self,
        columns: Sequence[str],
        rows: Sequence[Sequence[str]],
        *,
        title: str = "",
        numbers: Sequence[int] = (),
    ) -> None:
        """Print a table and an empty line."""


def show(output: Printer, answer: Answer, language: Language = "en") -> None:
    """Print an answer for a reader.

    Parameters
    ----------
    output : Printer
        Where to.
    answer : Answer
        What is shown.
    language : {"en", "vi"}
        Of its words.
    """
    output.text(say(answer.title, language), bold=True)
    in_text = True
    for block in answer.blocks:
        if not _is_seen(block):
            continue
        stands_apart = isinstance(block, Table | Facts) or bool(_caption(block))
        if stands_apart and in_text:
            output.line()
        _show(output, block, language)
        in_text = not stands_apart


def _is_seen(block: Block) -> bool:
    if isinstance(block, Table) and block.length == 0:
        return False
    if isinstance(block, Table | Facts | Text | Warnings):
        return block.only in _SEEN
    return isinstance(block, Verdict | Points)


def _caption(block: Block) -> str:
    return block.caption if isinstance(block, Text | Points) else ""


def _show(output: Printer, block: Block, language: Language) -> None:
    if isinstance(block, Table):
        for caption, rows in _parts(block):
            _table(output, block, caption, rows, language)
    elif isinstance(block, Facts):
        _facts(output, block, language)
    elif isinstance(block, Text):
        _text(output, block, language)
    elif isinstance(block, Verdict):
        output.text(say(block.said, language), bold=True)
    elif isinstance(block, Points):
        _points(output, block, language)
    elif isinstance(block, Warnings):
        for said in block.said:
            warning = Sentence(Message("answers.warning", warning=said))
            output.text(say(warning, language), bold=True)


def _points(output: Printer, block: Points, language: Language) -> None:
    if block.caption:
        output.text(say(block.caption, language), bold=True)
    for said in block.said:
        output.text(say(said, language))


def _text(output: Printer, block: Text, language: Language) -> None:
    """Print a paragraph; one with a caption stands apart from what follows, as a table does."""
    if block.caption:
        output.text(say(block.caption, language), bold=True)
    output.text(say(block.said, language))
    if block.caption:
        output.line()


def _facts(output: Printer, block: Facts, language: Language) -> None:
    rows = []
    for fact in block.facts:
        if fact.only == "files":
            continue
        symbol = fact.quantity.symbol if fact.quantity else ""
        values = (fact.quantity, *(fact.also if fact.value is not None else ()))
        rows.append(
            (
                f"{say(fact.name, language)} {symbol}".rstrip(),
                *(shown(fact.value, quantity, language, unit=True) for quantity in values),
            )
        )
    width = max(map(len, rows))
    padded = [(*row, *[""] * (width - len(row))) for row in rows]
    # Words that are long fold; what is short stands flush right, as numbers do.
    short = [k for k in range(1, width) if max(len(row[k]) for row in padded) <= _TEXT_HEADING]
    output.table([""] * width, padded, title=say(block.caption, language), numbers=short)


def _parts(table: Table) -> Iterator[tuple[str, Sequence[int]]]:
    if table.parts:
        yield from table.parts
    else:
        yield table.caption, range(table.length) if table.shown is None else table.shown


def _table(
    output: Printer, table: Table, caption: str, rows: Sequence[int], language: Language
) -> None:
    """Print rows of a table, without the columns for which 80 have no room; those are named."""
    columns = [each for each in table.columns if each.only != "files"]
    cells = [[cell(each, row, language) for row in rows] for each in columns]
    left_out = []
    while _width(columns, cells, language) > _WIDTH and any(each.priority for each in columns):
        worst = max(range(len(columns)), key=lambda k: columns[k].priority)
        left_out.append(columns.pop(worst).name)
        cells.pop(worst)
    tight = _width(columns, cells, language) > _WIDTH
    headings = [
        _heading(each, below, language, tight=tight)
        for each, below in zip(columns, cells, strict=True)
    ]
    numbers = [k for k, each in enumerate(columns) if each.is_number]
    if table.marked is not None and table.marked in rows:
        place = list(rows).index(table.marked)
        cells[0][place] = f"*{cells[0][place]}"
    printed = list(zip(*cells, strict=True))
    output.table(headings, printed, title=say(caption, language), numbers=numbers)
    if left_out:
        names = Several(reversed(left_out), ", ")
        output.text(say(Message("answers.left_out", columns=names), language))
        output.line()


def _width(columns: Sequence[Column], cells: Sequence[Sequence[str]], language: Language) -> int:
    total = 0
    for column, below in zip(columns, cells, strict=True):
        heading = _heading(column, below, language)
        widest = max(map(len, (*heading.split("\n"), *below)), default=0)
        total += widest if column.is_number else min(widest, max(_TEXT, _longest_word(heading)))
    return total + _GAP * (len(columns) - 1)


def _longest_word(text: str) -> int:
    return max(map(len, text.split()), default=0)


def _heading(
    column: Column, cells: Sequence[str], language: Language, *, tight: bool = False
) -> str:
    """Say what a column holds in few characters, folded to what stands below it."""
    name = say(column.name, language)
    quantity = column.quantity
    if quantity is not None and quantity.symbol:
        name = quantity.symbol
    room = max(map(len, cells), default=0)
    if not column.is_number:
        room = max(min(room, _TEXT_HEADING), _HEADING)
    room = max(room, 6) if tight else max(room, _longest_word(name), 1)
    lines = wrap(name, room, break_long_words=tight)
    if quantity is not None and quantity.field_unit != "-":
        lines.append(f"({quantity.field_unit})")
    return "\n".join(lines)
