"""An answer on one screen: 22 lines, whatever it holds."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cache
from itertools import islice
from textwrap import wrap
from typing import NamedTuple

from catopt.answers.blocks import (
    TO_BE_KNOWN,
    Answer,
    Brief,
    CardBlock,
    Facts,
    Points,
    Table,
    Text,
    Verdict,
    Warnings,
)
from catopt.render.terminal import COLUMNS, NO_BREAK, Printer, table_lines
from catopt.render.values import as_text, as_wanted, is_seen, parts_of
from catopt.words import Language, Message, say

LINES = 22

_GAP = 2
"""Columns between a name and its value; twice as many between two of them."""
_MOST_FACTS, _MOST_LINES = 12, 2
"""Of an answer without a card: facts of a list, and lines of a text."""
_LEAST_ROWS = 3
"""That a table or a list of facts keeps."""


class Line(NamedTuple):
    """A line of a card; an empty one sets apart what is above it."""

    text: str
    is_bold: bool = False


def show_card(
    output: Printer, answer: Answer, language: Language = "en", further: str = ""
) -> None:
    """Print the card of an answer, and below it what `further` there is."""
    for each in card_lines(answer, language, further):
        if each.text:
            output.text(each.text, bold=each.is_bold)
        else:
            output.line()


def card_lines(answer: Answer, language: Language = "en", further: str = "") -> list[Line]:
    """Lay the card of an answer out, under its title.

    Tables and what is brief get fewer lines where there is no room for all of it, the longest
    first. Where that is not enough blocks are left out, `_left_out_first`, and the tables among
    them named; facts get fewer lines once nothing brief is left.
    """
    wanted = as_wanted(answer)
    blocks = wanted.card or islice(_screen(wanted), LINES)  # each takes a line at least
    card = [each for each in blocks if isinstance(each, Brief) or is_seen(each)]

    @cache
    def laid(block: CardBlock, room: int) -> list[Line]:
        return _laid(block, room, language)

    (title,) = _cut(say(answer.title, language), 1)
    below = [Line(each) for part in say(further, language).split("\n") for each in folded(part)]
    left_out: list[str] = []
    rooms = [_room(each, language) for each in card]
    while True:
        named = [Brief(tuple(left_out), Message("answers.card_left_out"))] if left_out else []
        parts = map(laid, [*card, *named], [*rooms, 1])
        lines = [Line(title, is_bold=True), *_joined(parts), *below]
        if len(lines) <= LINES:
            return lines
        spare = [
            room - (_LEAST_ROWS if isinstance(each, Table | Facts) else 1)
            for each, room in zip(card, rooms, strict=True)
        ]
        first = next((k for k, each in enumerate(card) if isinstance(each, Table)), None)
        facts = {k for k, each in enumerate(card) if isinstance(each, Facts)}
        longest = max(
            range(len(rooms)),
            key=lambda k: (spare[k] > 0, k not in facts, rooms[k] / (1 + (k == first)), k),
        )
        place = _left_out_first(card)
        is_brief = place is not None and isinstance(card[place], Brief)
        if spare[longest] > 0 and not (longest in facts and is_brief):
            rooms[longest] -= 1
            continue
        if place is None:
            return lines
        gone = card.pop(place)
        if isinstance(gone, Table | Facts) and gone.caption:
            left_out.append(gone.caption)
        rooms = [_room(each, language) for each in card]


def _left_out_first(card: list[CardBlock]) -> int | None:
    """Choose what a screen can do without: the last of what is brief, then of tables and facts.

    Never verdicts and other texts, the first table or facts, and the first of what is to be known.
    """
    briefs = [k for k, e in enumerate(card) if isinstance(e, Brief) and e.label != TO_BE_KNOWN]
    tables = [k for k, each in enumerate(card) if isinstance(each, Table | Facts)]
    known = [k for k, e in enumerate(card) if isinstance(e, Brief) and e.label == TO_BE_KNOWN]
    return next((places[-1] for places in (briefs, tables[1:], known[1:]) if places), None)


def _screen(answer: Answer) -> Iterator[CardBlock]:
    """Yield what the sections say for a screen: verdicts, numbers, then words."""
    seen = [block for block in answer.blocks if is_seen(block)]
    verdicts = (block for block in reversed(seen) if isinstance(block, Verdict))
    yield from dict.fromkeys(verdicts)  # that of all of it stands last
    for block in seen:
        if isinstance(block, Facts):
            facts = [each for each in block.facts if each.only != "files"]
            yield replace(block, facts=tuple(facts[:_MOST_FACTS]))
        elif isinstance(block, Table):
            yield block
    for block in seen:
        if isinstance(block, Warnings) and block.said:
            yield Brief(block.said, TO_BE_KNOWN, _MOST_LINES)
    for block in seen:
        if isinstance(block, Text) and not block.is_small:
            yield Brief((block.said,), block.caption, _MOST_LINES)
        elif isinstance(block, Points):
            yield Brief(block.said, block.caption, _MOST_LINES)


def _room(block: CardBlock, language: Language) -> int:
    """How many lines a block may take, as far as that is up to the card."""
    if isinstance(block, Table):
        return min(sum(len(rows) for _, rows in parts_of(block)), LINES)
    if isinstance(block, Facts):
        return len(_facts(block, LINES, language))
    return block.lines if isinstance(block, Brief) else 1


def _joined(laid: Iterable[list[Line]]) -> Iterator[Line]:
    """Yield the lines of blocks, with one empty line where two would meet."""
    before = Line("-")
    for line in (each for lines in laid for each in lines):
        if line.text or before.text:
            yield line
        before = line


def folded(text: str) -> list[str]:
    """Fold a text to the width; words stay whole, and a number keeps its unit beside it."""
    joined = re.sub(r"(?<=\d) (?=[^\W\d]{1,5}\b)", NO_BREAK, text)
    lines = wrap(joined, COLUMNS.get(), break_long_words=False, break_on_hyphens=False)
    return [line.replace(NO_BREAK, " ") for line in lines]


def _laid(block: CardBlock, lines: int, language: Language) -> list[Line]:
    match block:
        case Table():
            return [Line(""), *map(Line, table_lines(block, lines, language)), Line("")]
        case Facts():
            return [Line(""), *map(Line, _facts(block, lines, language)), Line("")]
        case Brief():
            return [Line(each) for each in _brief(block, lines, language)]
    bold = isinstance(block, Verdict)
    return [Line(each, bold) for each in folded(say(block.said, language))]


def _facts(block: Facts, lines: int, language: Language) -> list[str]:
    """Set as many facts as there is room for, and how many more there are."""
    cells = [
        (say(each.name, language), say(as_text(each.value, each.quantity, unit=True), language))
        for each in block.facts
    ]
    rows = _rows(cells)
    for many in range(len(cells) - 1, 0, -1):
        if len(rows) <= lines:
            break
        more = say(Message("answers.more_facts", count=len(cells) - many), language)
        rows = [*_rows(cells[:many]), more]
    return rows


def _rows(cells: list[tuple[str, str]]) -> list[str]:
    """Set facts in two columns, or one below the other where two are too wide."""
    half = -(-len(cells) // 2)
    columns = [_column(cells[:half]), _column(cells[half:])]
    rows = [
        f"{left}{' ' * 2 * _GAP}{right}".rstrip()
        for left, right in zip(columns[0], [*columns[1], ""], strict=False)
    ]
    return rows if max(map(len, rows), default=0) <= COLUMNS.get() else _column(cells)


def _column(cells: list[tuple[str, str]]) -> list[str]:
    """Set names flush left and values flush right."""
    names, values = (max((len(each[k]) for each in cells), default=0) for k in (0, 1))
    return [f"{name:<{names}}{' ' * _GAP}{value:>{values}}" for name, value in cells]


def _brief(block: Brief, lines: int, language: Language) -> list[str]:
    """Say as much as there is room for, and how much more there is."""
    said: list[str] = []
    while len(said) < len(block.said) and len(" ".join(said).split()) <= lines * COLUMNS.get():
        said.append(say(block.said[len(said)], language).rstrip("."))
    for many in range(len(said), 0, -1):
        text = _counted("; ".join(said[:many]), len(block.said) - many, language)
        whole = folded(_labelled(block, text, language))
        if len(whole) <= lines:
            return whole
    return _cut(_labelled(block, said[0], language), lines, len(block.said) - 1, language)


def _counted(said: str, more: int, language: Language) -> str:
    return say(Message("answers.and_more", said=said, count=more), language) if more else said


def _labelled(block: Brief, text: str, language: Language) -> str:
    label = say(block.label, language)
    if not label:
        return text
    label = label[:1].upper() + label[1:]
    return say(Message("answers.labelled", label=label, said=text), language)


def _cut(text: str, lines: int, more: int = 0, language: Language = "en") -> list[str]:
    """Fold a text, and leave words out from its end on until it has so many lines."""
    words = text.split()
    if len(words) <= lines * COLUMNS.get():
        whole = folded(_counted(text, more, language))
        if len(whole) <= lines:
            return whole or [""]
    for most in range(min(len(words) - 1, lines * COLUMNS.get()), 0, -1):
        whole = folded(_counted(f"{' '.join(words[:most])} ...", more, language))
        if len(whole) <= lines:
            break
    return whole
