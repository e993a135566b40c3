"""An answer on one screen: 22 lines of 80 columns, whatever it holds."""

from __future__ import annotations

import re
from collections.abc import Iterator
from textwrap import wrap
from typing import NamedTuple, Protocol

from catopt.answers.blocks import Answer, Brief, CardBlock, Facts, Verdict
from catopt.render.units import as_wanted
from catopt.render.values import shown
from catopt.words import Language, Message, say

LINES, WIDTH = 22, 80

_GAP = 2
"""Columns between a name and its value; twice as many between two of them."""
_CUT = "..."
_NO_BREAK = "\u00a0"
"""Between a number and its unit."""


class Printer(Protocol):
    """What lines are printed with."""

    def text(self, text: str, *, bold: bool = False) -> None:
        """Print a line."""

    def line(self) -> None:
        """Print an empty line."""


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

    What is brief gets fewer lines where there is no room for all of it, the longest first.
    """
    card = as_wanted(answer).card
    (title,) = _cut(say(answer.title, language), 1)
    below = [Line(each) for each in folded(say(further, language))]
    rooms = [each.lines if isinstance(each, Brief) else 1 for each in card]
    while True:
        laid = [_laid(each, room, language) for each, room in zip(card, rooms, strict=True)]
        lines = [Line(title, is_bold=True), *(line for part in laid for line in part), *below]
        longest = max(range(len(rooms)), key=rooms.__getitem__)
        if len(lines) <= LINES or rooms[longest] == 1:
            return lines
        rooms[longest] -= 1


def folded(text: str) -> list[str]:
    """Fold a text to the width; words stay whole, and a number keeps its unit beside it."""
    joined = re.sub(r"(?<=\d) (?=[^\W\d]{1,5}\b)", _NO_BREAK, text)
    lines = wrap(joined, WIDTH, break_long_words=False, break_on_hyphens=False)
    return [line.replace(_NO_BREAK, " ") for line in lines]


def _laid(block: CardBlock, lines: int, language: Language) -> list[Line]:
    match block:
        case Facts():
            return [Line(""), *map(Line, _facts(block, language)), Line("")]
        case Brief():
            return [Line(each) for each in _brief(block, lines, language)]
    bold = isinstance(block, Verdict)
    return [Line(each, bold) for each in folded(say(block.said, language))]


def _facts(block: Facts, language: Language) -> Iterator[str]:
    """Set facts in two columns, or one below the other where two are too wide."""
    cells = [
        (say(each.name, language), say(shown(each.value, each.quantity, unit=True), language))
        for each in block.facts
    ]
    half = -(-len(cells) // 2)
    columns = [_column(cells[:half]), _column(cells[half:])]
    rows = [
        f"{left}{' ' * 2 * _GAP}{right}".rstrip()
        for left, right in zip(columns[0], [*columns[1], ""], strict=False)
    ]
    if max(map(len, rows)) <= WIDTH:
        yield from rows
    else:
        yield from _column(cells)


def _column(cells: list[tuple[str, str]]) -> list[str]:
    """Set names flush left and values flush right."""
    names, values = (max((len(each[k]) for each in cells), default=0) for k in (0, 1))
    return [f"{name:<{names}}{' ' * _GAP}{value:>{values}}" for name, value in cells]


def _brief(block: Brief, lines: int, language: Language) -> list[str]:
    """Say as much as there is room for, and how much more there is."""
    said = [say(each, language).rstrip(".") for each in block.said]
    for count in range(len(said), 0, -1):
        text = _counted("; ".join(said[:count]), len(said) - count, language)
        whole = folded(_labelled(block, text, language))
        if len(whole) <= lines:
            return whole
    return _cut(_labelled(block, said[0], language), lines, len(said) - 1, language)


def _counted(said: str, count: int, language: Language) -> str:
    return say(Message("answers.and_more", said=said, count=count), language) if count else said


def _labelled(block: Brief, text: str, language: Language) -> str:
    label = say(block.label, language)
    if not label:
        return text
    label = label[:1].upper() + label[1:]
    return say(Message("answers.labelled", label=label, said=text), language)


def _cut(text: str, lines: int, count: int = 0, language: Language = "en") -> list[str]:
    """Fold a text, and leave words out from its end on until it has so many lines."""
    words, whole = text.split(), folded(_counted(text, count, language))
    while len(whole) > lines and len(words) > 1:
        words.pop()
        whole = folded(_counted(f"{' '.join(words)} {_CUT}", count, language))
    return whole or [""]
