"""An answer on a terminal of 80 columns."""

from __future__ import annotations

import re
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
from catopt.quantities import QUANTITIES
from catopt.render.units import as_wanted
from catopt.render.values import cell, shown
from catopt.words import Language, Message, Sentence, Several, say

_WIDTH = 80
_GAP = 3
"""Columns between two columns of a table."""
_TEXT = 12
"""Characters that a column of words needs at least; longer ones fold."""
_LEAST = 6
"""Characters to which words of a heading are broken at least."""
_HEADING, _TEXT_HEADING = 11, 24
"""Characters to which headings over words are folded at least, and at most over long ones."""
_NO_BREAK = "\u00a0"
"""Between a number and its unit."""
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
    """Print an answer for a reader."""
    answer = as_wanted(answer)
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
        output.text(say(block.words, language), bold=True)
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
    rooms = _rooms(columns, cells, language)
    headings = [_heading(each, room, language) for each, room in zip(columns, rooms, strict=True)]
    numbers = [k for k, each in enumerate(columns) if each.is_number]
    if table.marked is not None and table.marked in rows:
        place = list(rows).index(table.marked)
        cells[0][place] = f"*{cells[0][place]}"
    _fold(columns, headings, cells)
    printed = list(zip(*cells, strict=True))
    output.table(headings, printed, title=say(caption, language), numbers=numbers)
    if left_out:
        names = Several(reversed(left_out), ", ")
        output.text(say(Message("answers.left_out", columns=names), language))
        output.line()


def _rooms(
    columns: Sequence[Column], cells: Sequence[Sequence[str]], language: Language
) -> list[int]:
    """Choose to how many characters each heading folds: whole words, where 80 have room for them.

    Where not, words of headings that are widest over what stands below them are broken.
    """
    names = [_name(each, language) for each in columns]
    rooms = [
        _room(each, name, below) for each, name, below in zip(columns, names, cells, strict=True)
    ]
    spare = [
        room - max(map(len, below), default=0) if each.is_number and room > _LEAST else 0
        for each, room, below in zip(columns, rooms, cells, strict=True)
    ]
    over = _width(columns, cells, language) - _WIDTH
    while over > 0 and any(each > 0 for each in spare):
        widest = max(range(len(columns)), key=lambda k: spare[k])
        rooms[widest] -= 1
        spare[widest] = spare[widest] - 1 if rooms[widest] > _LEAST else 0
        over -= 1
    return rooms


def _room(column: Column, name: str, cells: Sequence[str]) -> int:
    room = max(map(len, cells), default=0)
    if not column.is_number:
        room = max(min(room, _TEXT_HEADING), _HEADING)
    return max(room, _longest_word(name), 1)


def _width(columns: Sequence[Column], cells: Sequence[Sequence[str]], language: Language) -> int:
    """Count the characters of a row whose headings keep their words whole."""
    total = 0
    for column, below in zip(columns, cells, strict=True):
        room = _room(column, _name(column, language), below)
        heading = _heading(column, room, language)
        widest = max(map(len, (*heading.split("\n"), *below)), default=0)
        total += widest if column.is_number else min(widest, max(_TEXT, _longest_word(heading)))
    return total + _GAP * (len(columns) - 1)


def _longest_word(text: str) -> int:
    return max(map(len, re.split(r"[ \n]", text)), default=0)


def _name(column: Column, language: Language) -> str:
    """Name a column; a quantity's own name gives way to its symbol, one that says more does not."""
    name, quantity = say(column.name, language), column.quantity
    if quantity is not None and quantity.symbol:
        own = QUANTITIES.get(quantity.key, quantity).name.lower()
        says_more = not own.endswith(column.name.lower())
        name = f"{name} {quantity.symbol}" if says_more else quantity.symbol
    return re.sub(r"(?<=\d) ", _NO_BREAK, name)


def _heading(column: Column, room: int, language: Language) -> str:
    """Say what a column holds, folded to so many characters."""
    words = [part for word in _name(column, language).split(" ") for part in _broken(word, room)]
    lines = wrap(" ".join(words), room, break_long_words=False, break_on_hyphens=False)
    quantity = column.quantity
    if quantity is not None and quantity.field_unit != "-":
        lines.append(f"({quantity.field_unit})")
    return "\n".join(lines).replace(_NO_BREAK, " ")


def _broken(word: str, room: int) -> Iterator[str]:
    """Break a word that is too long into parts of about the same length."""
    if len(word) <= room:
        yield word
        return
    half = min(-(-len(word) // 2), room - 1)
    yield f"{word[:half]}-"
    yield from _broken(word[half:], room)


def _fold(columns: Sequence[Column], headings: Sequence[str], cells: list[list[str]]) -> None:
    """Fold the one column of words that a table has; a number keeps its unit beside it."""
    words = [k for k, each in enumerate(columns) if not each.is_number]
    if len(words) != 1:
        return
    widths = [
        max(map(len, (*heading.split("\n"), *below)))
        for heading, below in zip(headings, cells, strict=True)
    ]
    (place,) = words
    room = _WIDTH - _GAP * (len(columns) - 1) - sum(widths) + widths[place]
    if room < widths[place]:
        joined = (re.sub(r"(?<=\d) (?=[^\W\d])", _NO_BREAK, cell) for cell in cells[place])
        folded = (
            "\n".join(wrap(cell, max(room, _TEXT), break_on_hyphens=False)) for cell in joined
        )
        cells[place] = [each.replace(_NO_BREAK, " ") for each in folded]
