"""An answer on a terminal."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextvars import ContextVar
from copy import copy
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
from catopt.render.values import as_text, as_wanted, cell, is_seen, parts_of
from catopt.words import Language, Message, Sentence, Several, say, term

COLUMNS: ContextVar[int] = ContextVar("COLUMNS", default=80)
"""That an answer is laid out for."""
_GAP = 3
"""Columns between two columns of a table."""
_TEXT = 12
"""Characters that a column of words needs at least; longer ones fold."""
_LEAST = 6
"""Characters to which words of a heading are broken at least."""
_HEADING, _TEXT_HEADING = 11, 24
"""Characters to which headings over words are folded at least, and at most over long ones."""
NO_BREAK = "\u00a0"
"""Between a number and its unit."""


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
        if not isinstance(block, _PRINTED) or not is_seen(block):
            continue
        caption = block.caption if isinstance(block, Text | Points) else ""
        stands_apart = isinstance(block, Table | Facts) or bool(caption)
        if stands_apart and in_text:
            output.line()
        if caption:
            output.text(say(caption, language), bold=True)
        _show(output, block, language)
        if isinstance(block, Text) and caption:  # it stands apart from what follows, too
            output.line()
        in_text = not stands_apart


_PRINTED = Table | Facts | Text | Verdict | Points | Warnings
"""What a terminal shows."""


def _show(output: Printer, block: Block, language: Language) -> None:
    match block:
        case Table():
            for caption, rows in parts_of(block):
                _table(output, block, caption, rows, language)
        case Facts():
            _facts(output, block, language)
        case Text():
            output.text(say(block.said, language))
        case Verdict():
            output.text(say(block.said, language), bold=True)
        case Points():
            for said in block.said:
                output.text(say(said, language))
        case Warnings():
            for said in block.said:
                warning = Sentence(Message("answers.warning", warning=said))
                output.text(say(warning, language), bold=True)


def _facts(output: Printer, block: Facts, language: Language) -> None:
    rows = []
    for fact in block.facts:
        if fact.only == "files":
            continue
        symbol = fact.quantity.symbol if fact.quantity else ""
        name = f"{say(fact.name, language)} {symbol}".rstrip()
        ways = (fact.quantity, *(fact.also if fact.value is not None else ()))
        rows.append([name, *(say(as_text(fact.value, each, unit=True), language) for each in ways)])
    width = max(map(len, rows))
    padded = [[*row, *[""] * (width - len(row))] for row in rows]
    # Words that are long fold; what is short is flush right, as numbers are.
    short = [k for k in range(1, width) if max(len(row[k]) for row in padded) <= _TEXT_HEADING]
    output.table([""] * width, padded, title=say(block.caption, language), numbers=short)


def _table(
    output: Printer, table: Table, caption: str, rows: Sequence[int], language: Language
) -> None:
    """Print rows of a table, without the columns for which there is no room; those are named."""
    shown = [each for each in table.columns if each.only != "files"]
    columns = [_Column(each, rows, language) for each in shown]
    left_out = []
    while _excess(columns) > 0 and any(each.of.priority for each in columns):
        worst = max(columns, key=lambda each: each.of.priority)
        left_out.append(worst.of.name)
        columns.remove(worst)
    headings = _headings(columns)
    while _cuts_numbers(columns, headings):
        left_out.append(columns.pop(_last_number(columns)).of.name)
        headings = _headings(columns)
    numbers = [k for k, each in enumerate(columns) if each.is_number]
    if table.marked is not None and table.marked in rows:
        place = list(rows).index(table.marked)
        columns[0].cells[place] = f"*{columns[0].cells[place]}"
    _fold(columns, headings)
    printed = list(zip(*(each.cells for each in columns), strict=True))
    output.table(headings, printed, title=say(caption, language), numbers=numbers)
    if left_out:
        names = Several(reversed(left_out), ", ")
        output.text(say(Message("answers.left_out", columns=names), language))
        output.line()


def _headings(columns: Sequence[_Column], excess: int | None = None) -> list[str]:
    rooms = _rooms(columns, _excess(columns) if excess is None else excess)
    return [each.heading(room) for each, room in zip(columns, rooms, strict=True)]


def _headings_over_whole(columns: Sequence[_Column]) -> list[str]:
    """Break headings before words below them are cut."""
    whole = [each.heading(each.room) for each in columns]
    return _headings(columns, _over(_widths(columns, whole)))


def _cuts_numbers(columns: Sequence[_Column], headings: Sequence[str]) -> bool:
    """Whether there is no room for all digits, however far words fold."""
    least = [
        width if each.is_number else min(width, _LEAST)
        for each, width in zip(columns, _widths(columns, headings), strict=True)
    ]
    return _over(least) > 0 and _last_number(columns) > 0


def _last_number(columns: Sequence[_Column]) -> int:
    return max((k for k, each in enumerate(columns) if each.is_number), default=-1)


def table_lines(table: Table, room: int, language: Language) -> list[str]:
    """Lay a table out in so many lines below its headings, without a rule.

    Columns for which there is no room are left out, those of a priority first; of rows the marked
    one stays, and how many are left out is said in the last line.
    """
    every = [row for _, rows in parts_of(table) for row in rows]
    kept = every if len(every) <= room else every[: max(room - 1, 1)]
    if table.marked in every and table.marked not in kept:
        kept = [*kept[:-1], table.marked]
    columns = [_Column(each, kept, language) for each in table.columns if each.only != "files"]
    columns = [each for each in columns if any(cell not in ("", "-") for cell in each.cells)]
    if table.marked in kept and columns:
        own = columns[0].cells
        own[:] = [f"*{own[k]}" if row == table.marked else own[k] for k, row in enumerate(kept)]
    if not columns:
        return []
    while _excess(columns) > 0 and len(columns) > 1:
        third = COLUMNS.get() // 3
        worst = max(columns[1:], key=lambda each: (each.of.priority, each.width - third))
        if worst.of.priority == 0:
            break
        columns.remove(worst)
    kept_columns = next(filter(None, map(_cut, _fewer(columns))))
    lines = list(_set(kept_columns, _headings_over_whole(kept_columns)))
    left_out = len(every) - len(kept)
    if left_out:
        lines.append(say(Message("answers.more_rows", count=left_out), language))
    return lines


def _fewer(columns: list[_Column]) -> Iterator[list[_Column]]:
    """Yield the columns, then without the last ones: each that is dropped gives its room back."""
    for count in range(len(columns), 0, -1):
        yield columns[:count]


def _cut(columns: list[_Column]) -> list[_Column] | None:
    """Cut the widest words until a row fits; None where they would be cut too short for that."""
    kept = [copy(each) for each in columns]
    headings = _headings_over_whole(kept)
    while (excess := _over(_widths(kept, headings))) > 0:
        wordy = max(
            (each for each in kept if not each.is_number), key=lambda e: e.longest, default=None
        )
        if wordy is None or wordy.longest <= _TEXT:
            return kept if len(kept) == 1 else None
        room = max(wordy.longest - excess, _TEXT)
        wordy.cells = [
            cell if len(cell) <= room else f"{cell[: room - 3].rstrip()}..." for cell in wordy.cells
        ]
        headings = _headings_over_whole(kept)
    return kept


def _widths(columns: Sequence[_Column], headings: Sequence[str]) -> list[int]:
    return [
        max(each.longest, *map(len, heading.split("\n")))
        for each, heading in zip(columns, headings, strict=True)
    ]


def _set(columns: Sequence[_Column], headings: Sequence[str]) -> Iterator[str]:
    """Yield the lines of headings and rows, numbers flush right."""
    widths = _widths(columns, headings)
    deep = max((heading.count("\n") + 1 for heading in headings), default=0)
    folded = [["", *heading.split("\n")] for heading in headings]
    _, *above = zip(*([""] * (deep + 1 - len(each)) + each for each in folded), strict=True)
    for row in (*above, *zip(*(each.cells for each in columns), strict=True)):
        parts = (
            cell.rjust(width) if each.is_number else cell.ljust(width)
            for cell, width, each in zip(row, widths, columns, strict=True)
        )
        line = (" " * _GAP).join(parts).rstrip()
        if line:
            yield line


class _Column:
    """A column as it is printed: its name, its unit and its cells."""

    def __init__(self, of: Column, rows: Sequence[int], language: Language) -> None:
        self.of = of
        self.is_number = of.is_number
        # A quantity's own name gives way to its symbol, one that says more does not.
        name, quantity = say(of.name, language), of.quantity
        if quantity is not None and quantity.symbol:
            own = QUANTITIES.get(quantity.key, quantity).name.lower()
            says_more = not own.endswith(of.name.lower())
            name = f"{name} {quantity.symbol}" if says_more else quantity.symbol
        self.name = re.sub(r"(?<=\d) ", NO_BREAK, name)
        self.unit = "" if quantity is None else say(term(quantity.field_unit), language)
        self.cells = [say(cell(of, row), language) for row in rows]

    @property
    def longest(self) -> int:
        """Characters of its longest cell."""
        return max(map(len, self.cells), default=0)

    @property
    def room(self) -> int:
        """Characters to which its heading folds with its words whole."""
        room = self.longest
        if not self.is_number:
            room = max(min(room, _TEXT_HEADING), _HEADING)
        return max(room, _longest_word(self.name), 1)

    @property
    def width(self) -> int:
        """Characters that it takes where the words of its heading stay whole."""
        heading = self.heading(self.room)
        widest = max(self.longest, *map(len, heading.split("\n")))
        return widest if self.is_number else min(widest, max(_TEXT, _longest_word(heading)))

    def heading(self, room: int) -> str:
        """Say what it holds, folded to so many characters."""
        words = [part for word in self.name.split(" ") for part in _broken(word, room)]
        lines = wrap(" ".join(words), room, break_long_words=False, break_on_hyphens=False)
        if self.unit not in ("", "-"):
            lines.append(f"({self.unit})")
        return "\n".join(lines).replace(NO_BREAK, " ")


def _excess(columns: Sequence[_Column]) -> int:
    return _over([each.width for each in columns])


def _over(widths: Sequence[int]) -> int:
    """Count the characters by which a row of such widths is too long."""
    return sum(widths) + _GAP * (len(widths) - 1) - COLUMNS.get()


def _rooms(columns: Sequence[_Column], excess: int) -> list[int]:
    """Choose to how many characters each heading folds: whole words, where there is room for them.

    Where not, words of headings that are widest over what is below them are broken.
    """
    rooms = [each.room for each in columns]
    spare = [
        room - each.longest if each.is_number and room > _LEAST else 0
        for each, room in zip(columns, rooms, strict=True)
    ]
    for _ in range(excess):
        widest = max(range(len(columns)), key=lambda k: spare[k])
        if spare[widest] <= 0:
            break
        rooms[widest] -= 1
        spare[widest] = spare[widest] - 1 if rooms[widest] > _LEAST else 0
    return rooms


def _longest_word(text: str) -> int:
    return max(map(len, re.split(r"[ \n]", text)), default=0)


def _broken(word: str, room: int) -> Iterator[str]:
    """Break a word that is too long into parts of about the same length."""
    if len(word) <= room:
        yield word
        return
    half = min(-(-len(word) // 2), room - 1)
    yield word[:half] if word[half - 1] == "-" else f"{word[:half]}-"
    yield from _broken(word[half:], room)


def _fold(columns: Sequence[_Column], headings: Sequence[str]) -> None:
    """Fold the one column of words that a table has; a number keeps its unit beside it."""
    words = [k for k, each in enumerate(columns) if not each.is_number]
    if len(words) != 1:
        return
    widths, (place,) = _widths(columns, headings), words
    excess = _over(widths)
    if excess > 0:
        column, room = columns[place], max(widths[place] - excess, _TEXT)
        joined = (re.sub(r"(?<=\d) (?=[^\W\d])", NO_BREAK, cell) for cell in column.cells)
        folded = (wrap(cell, room, break_on_hyphens=False) for cell in joined)
        column.cells = ["\n".join(lines).replace(NO_BREAK, " ") for lines in folded]
