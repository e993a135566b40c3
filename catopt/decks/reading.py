"""Which file is a deck, and the way from its text to a case."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import PurePath
from typing import Any, Final

from catopt.decks.deck import LONGEST, Deck, Notes, check_sizes
from catopt.decks.formats import MOORDYN, deck_format
from catopt.decks.to_case import (
    Chain,
    case_of,
    chains_of,
    check_meeting,
    height_of,
    is_joint,
    is_radial,
    lines_of,
    site_of,
    site_of_chains,
    weight_of,
    without_floating_ends,
)
from catopt.documents import unfit
from catopt.errors import InputError, refused
from catopt.model import Case, Line, Segment, Site
from catopt.model.network import LineBetween, Network, Point, PointKind
from catopt.model.plausible_ranges import NAMES, accepting
from catopt.words.message import Message, is_said

_KIND: dict[str, PointKind] = {"fixed": "anchor", "coupled": "fairlead", "free": "joint"}


def has_joints(deck: Deck) -> bool:
    """Whether a free point is more than what hangs between two lines."""
    ends = [end for piece in deck.pieces for end in piece.ends]
    return any(
        is_joint(point, ends.count(name)) for name, point in deck.points.items() if name in ends
    )


def network_of(deck: Deck, notes: Notes, title: str) -> Network:
    """Make every point and every line one of its own; free points are joints.

    Raises InputError with everything that a file of lines with joints cannot say.
    """
    meeting = check_meeting(deck, notes)
    points = [point for name, point in deck.points.items() if meeting[name]]
    ends = [point for point in points if point.end != "free"]
    site, source = site_of(deck, deck.pieces, ends, notes)
    notes.say("at_rest_alone")
    made = []
    for point in points:
        kind = _KIND[point.end]
        if kind == "joint":
            weight = deck.hung_weight(point)
            made.append(Point(point.name, kind, submerged_weight=weight, force=point.force))
            if point.float_height and weight < 0.0:
                made[-1] = replace(made[-1], mass=point.mass, float_height=point.float_height)
        else:
            made.append(Point(point.name, kind, point.x, point.y, height_of(deck, point.z)))
    lines = []
    for number, piece in enumerate(deck.pieces, start=1):
        kind_of = deck.types[piece.type]
        weight = weight_of(deck, kind_of)
        segment = Segment(piece.length, weight, EA=kind_of.EA, MBL=kind_of.MBL, name=piece.type)
        lines.append(LineBetween(Line([segment]), *piece.ends, name=f"{number}"))
    return _network(site, made, lines, title, source, notes)


def network_of_lines(
    deck: Deck, chains: Sequence[Chain], lines: Sequence[Line], notes: Notes, title: str
) -> Network:
    """Put every line between its own two points, for lines that are not alike or not radial."""
    site, source = site_of_chains(deck, chains, notes)
    notes.say("apart", lines=len(lines))
    ends = {point.name: point for c in chains for point in (c.anchor, c.fairlead)}
    points = [
        Point(point.name, _KIND[point.end], point.x, point.y, height_of(deck, point.z))
        for point in ends.values()
    ]
    between = [
        LineBetween(line, chain.anchor.name, chain.fairlead.name, name=f"{number}")
        for number, (line, chain) in enumerate(zip(lines, chains, strict=True), start=1)
    ]
    return _network(site, points, between, title, source, notes)


def _network(
    site: Site,
    points: Sequence[Point],
    lines: Sequence[LineBetween],
    title: str,
    source: str,
    notes: Notes,
) -> Network:
    try:
        return Network(site, tuple(points), tuple(lines), title, source)
    except InputError as error:
        raise InputError(error.problems, notes.source) from None


@dataclass(frozen=True)
class Asked:
    """What the user says beside the deck: m/s2, kg/m3 and m, where the deck has none.

    `line`: only this one, counted from 1 as they come in the deck; `turbines`: x and y of each
    turbine of a farm, m.
    """

    gravity: float | None = None
    density: float | None = None
    depth: float | None = None
    line: int | None = None
    turbines: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True)
class Imported:
    """A deck as a case: one line between its ends, or equal lines around a body; else a network.

    `remarks`: what decides a number, and what of the deck the case has not, with its line.
    """

    case: Any  # Case or Network
    remarks: tuple[Message, ...]


_SHOWN_KEYS: Final = 6


def is_deck(text: str) -> bool:
    """Whether a text is a deck: it has a section of line types, or moorings in YAML.

    Examples
    --------
    >>> from catopt.decks.reading import is_deck
    >>> is_deck("--- LINE TYPES ---"), is_deck("[site]")
    (True, False)
    """
    return deck_format(text) is not None


def is_yaml(text: str, source: str) -> bool:
    """Whether a text is YAML by its ending or its first line, and no case file."""
    ending = PurePath(source).suffix.lower()
    first = text.lstrip().partition("\n")[0].rstrip()
    return ending in (".yaml", ".yml") or first == "---" or first.startswith("%YAML")


def refuse_yaml(text: str, source: str) -> InputError:
    """Say what a YAML file has at its top, and which files are read."""
    lines = (line.removeprefix("- ") for line in text.split("\n"))
    keys = dict.fromkeys(key for key, colon, _ in (e.partition(":") for e in lines) if colon)
    top = [key for key in keys if key[:1].isalpha() and len(key) <= LONGEST]
    named = ", ".join(top[:_SHOWN_KEYS]) + (", ..." if len(top) > _SHOWN_KEYS else "")
    found = Message("refused_deck.yaml_of_keys", keys=named) if top else Message("refused.none")
    return refused("file", found, Message("refused_deck.yaml_that_is_read"), source)


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
    return Imported(*read_any_deck(text, source, asked))


def read_any_deck(
    text: str, source: str = "", asked: Asked | None = None
) -> tuple[Case | Network, tuple[Message, ...]]:
    """Read a deck, with remarks; as a Network where its lines meet in joints, or differ."""
    given = {key: value for key, value in asdict(asked or Asked()).items() if value is not None}
    notes = Notes(source, given.pop("line", None), given.pop("turbines", ()))
    text = text.replace("\r\n", "\n")
    for row, said in enumerate(text.split("\n"), start=1):
        if unfit(said):
            notes.refuse(row, unfit(said), "out_of_file")
    notes.raise_if_any()
    deck = (deck_format(text) or MOORDYN).read(text, notes, given)
    placed = sum(is_said(remark, "decks.turbine") for remark in notes.remarks)
    if placed < len(notes.turbines):
        own = f"--turbine ({len(notes.turbines)})"
        notes.refuse(0, own, "turbines_of_deck", count=placed)
    check_sizes(deck, notes)
    notes.raise_if_any()
    deck = without_floating_ends(deck, notes)
    title = PurePath(source).stem
    case: Case | Network
    with accepting(NAMES):  # what another program took is told where it is used
        if notes.only is None and has_joints(deck):
            case = network_of(deck, notes, title)
        else:
            chains = chains_of(deck, notes, notes.only)
            lines = lines_of(deck, chains)
            make = case_of if is_radial(deck, chains, lines) else network_of_lines
            case = make(deck, chains, lines, notes, title)
    return case, tuple(notes.remarks)
