"""Which file is a deck, and the way from its text to a case."""

from __future__ import annotations

import re
from dataclasses import asdict, dataclass
from pathlib import PurePath
from typing import Final

from catopt.documents import unfit
from catopt.errors import InputError, Problem
from catopt.model import Case
from catopt.model.network import Network
from catopt.words.message import Message

NOT_FOR_THIS: Final = Message("refused_command.lines_meet_joints_or_differ")


@dataclass(frozen=True)
class Asked:
    """What the user says beside the deck: m/s2, kg/m3 and m, where the deck has none.

    `line`: only this one, counted from 1 as they come in the deck.
    """

    gravity: float | None = None
    density: float | None = None
    depth: float | None = None
    line: int | None = None


@dataclass(frozen=True)
class Imported:
    """A deck as a case: one line between its ends, or equal lines around a body.

    `remarks`: what decides a number, and what of the deck the case has not, with its line.
    """

    case: Case
    remarks: tuple[Message, ...]


_BEGINS = r"(?m)^(mooring_systems|mooring_line_configs)\s*:", r"(?m)^LineTypes\s*:"
"""How the ontology and OrcaFlex's text data are known."""


def is_deck(text: str) -> bool:
    """Whether a text is a deck: it has a section of line types, or moorings in YAML.

    Examples
    --------
    >>> from catopt.decks.reading import is_deck
    >>> is_deck("--- LINE TYPES ---"), is_deck("[site]")
    (True, False)
    """
    begins = (r"(?mi)^.*---.*\bLINE\s+(TYPES|DICTIONARY)\b", *_BEGINS)
    return any(re.search(each, text) is not None for each in begins)


def _is_of_mappp(text: str) -> bool:
    """Whether a deck is MAP++'s: it has no columns, sections or options of MoorDyn's."""
    if not re.search(r"(?mi)^-.*SOLVER OPTIONS", text):
        return False
    heads = r"\b(NumSegs|NumNodes|EI|BA\S*|Can|CdAx|CdA)\b"
    of_map = r"(?mi)^\s*LineType\s.*\bCB\b"
    if re.search(of_map, text) or re.search(r"(?mi)^\s*Option\s*$", text):
        return True
    return not re.search(rf"(?mi)^\s*\w+\s.*{heads}|^-.*\b(POINTS|CONNECTION|OUTPUTS)\b", text)


def read_deck(text: str, source: str = "", asked: Asked | None = None) -> Imported:
    """Read the text of a deck; `asked` says what it lacks, and of several lines which one.

    InputError has everything that is wrong, or that no case can say, by the line of the file.

    Examples
    --------
    >>> from catopt.decks.reading import read_deck
    >>> deck = '''one line
    ... --- LINE TYPES ---
    ... Name Diam MassDen EA BA EI Cd Ca CdAx CaAx
    ... (-) (m) (kg/m) (N) (-) (N-m2) (-) (-) (-) (-)
    ... chain 0.1 100 4e8 -1 0 1.2 1 0 0
    ... --- POINTS ---
    ... ID Attachment X Y Z Mass Volume CdA Ca
    ... (#) (-) (m) (m) (m) (kg) (m3) (m2) (-)
    ... 1 Fixed 0 0 -50 0 0 0 0
    ... 2 Coupled 150 0 0 0 0 0 0
    ... --- LINES ---
    ... ID LineType AttachA AttachB UnstrLen NumSegs Outputs
    ... (#) (name) (#) (#) (m) (-) (-)
    ... 1 chain 1 2 170 20 -
    ... --- OPTIONS ---
    ... 50 WtrDpth
    ... --- END ---'''
    >>> found = read_deck(deck, "one.txt")
    >>> found.case.load.span, found.case.line.length
    (150.0, 170.0)
    """
    case, remarks = read_any_deck(text, source, asked)
    if isinstance(case, Network):
        raise InputError([Problem("file", "", NOT_FOR_THIS)], source)
    return Imported(case, remarks)


def read_any_deck(
    text: str, source: str = "", asked: Asked | None = None
) -> tuple[Case | Network, tuple[Message, ...]]:
    """Read a deck, with remarks; as a Network where its lines meet in joints, or differ."""
    from catopt.decks.chains import chains_of
    from catopt.decks.deck import Notes
    from catopt.decks.mappp import parse_mappp
    from catopt.decks.moordyn import parse_moordyn
    from catopt.decks.ontology import parse_ontology
    from catopt.decks.orcaflex import parse_orcaflex
    from catopt.decks.to_case import case_of, is_radial, lines_of
    from catopt.decks.to_network import has_joints, network_of, network_of_lines

    given = {key: value for key, value in asdict(asked or Asked()).items() if value is not None}
    line = given.pop("line", None)
    notes = Notes(source, line)
    text = text.replace("\r\n", "\n")
    for row, said in enumerate(text.split("\n"), start=1):
        if unfit(said):
            notes.refuse(row, unfit(said), "out_of_file")
    notes.raise_if_any()
    parse = parse_mappp if _is_of_mappp(text) else parse_moordyn
    for begins, other in zip(_BEGINS, (parse_ontology, parse_orcaflex), strict=True):
        parse = other if re.search(begins, text) else parse
    deck = parse(text, notes, given)
    notes.raise_if_any()
    title = PurePath(source).stem
    case: Case | Network
    if notes.only is None and has_joints(deck):
        case = network_of(deck, notes, title)
    else:
        chains = chains_of(deck, notes, notes.only)
        lines = lines_of(deck, chains)
        alike = is_radial(deck, chains, lines)
        make = case_of if alike else network_of_lines
        case = make(deck, chains, lines, notes, title)
    return case, tuple(notes.remarks)
