"""Which programs' decks are read: how each is known by its text, and who reads it.

Another one is a module with a reader and a row of `FORMATS`; see docs/architecture.md.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Final, NamedTuple

from catopt.decks.deck import Deck, Notes
from catopt.decks.mappp import parse_mappp
from catopt.decks.moordyn import parse_moordyn
from catopt.decks.ontology import parse_ontology
from catopt.decks.orcaflex import parse_orcaflex
from catopt.decks.tables import parse_tables


class DeckFormat(NamedTuple):
    """A kind of deck.

    `is_one`: whether a text is one, if no format before it is; `read`: with the notes that are
    taken of it and the ``gravity``, ``density`` and ``depth`` that the user gives, SI.
    """

    is_one: Callable[[str], bool]
    read: Callable[[str, Notes, Mapping[str, float]], Deck]


def deck_format(text: str) -> DeckFormat | None:
    """Find the format of a text; None for what is no deck."""
    return next((known for known in FORMATS if known.is_one(text)), None)


def _has(*patterns: str) -> Callable[[str], bool]:
    """Whether lines of a text begin by each pattern."""
    return lambda text: all(re.search(rf"(?m)^{pattern}", text) is not None for pattern in patterns)


def _has_line_types(text: str) -> bool:
    """Whether a heading in dashes names line types: by lines, so that no blank is seen twice."""
    for line in text.split("\n"):
        _, dashes, name = line.partition("---")
        if dashes and re.search(r"(?i)\bLINE[ \t]+(TYPES|DICTIONARY)\b", name):
            return True
    return False


def _is_of_mappp(text: str) -> bool:
    """Whether a deck is MAP++'s: it has no columns, sections or options of MoorDyn's."""
    lines = text.split("\n")

    def has(pattern: str) -> bool:
        """Whether a line begins so: by lines, so that no blank is looked at twice."""
        return any(re.match(f"(?i){pattern}", line) for line in lines)

    if not has("-.*SOLVER OPTIONS") or not _has_line_types(text):
        return False
    if has(r"[ \t]*LineType\s.*\bCB\b") or has(r"[ \t]*Option\s*$"):
        return True
    heads = r"\b(NumSegs|NumNodes|EI|BA\S*|Can|CdAx|CdA)\b"
    return not has(rf"[ \t]*\w+\s.*{heads}|-.*\b(POINTS|CONNECTION|OUTPUTS)\b")


MOORDYN: Final = DeckFormat(_has_line_types, parse_moordyn)
FORMATS: Final = (
    DeckFormat(
        _has(r"(?:(-[ ]+)?LineTypes|[ \t]*(-[ ]+)?[Ii]nclude[Ff]ile)[ \t]*:"), parse_orcaflex
    ),
    DeckFormat(_has(r"(mooring_systems|mooring_line_configs)[ \t]*:"), parse_ontology),
    DeckFormat(_has(r"[ \t]*mooring[ \t]*:", r"[ \t]*line_types[ \t]*:"), parse_tables),
    DeckFormat(_is_of_mappp, parse_mappp),
    MOORDYN,
)
"""In the order in which they are asked."""
