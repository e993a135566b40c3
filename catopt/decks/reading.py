"""Which file is a deck, and the way from its text to a case."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import PurePath
from typing import Any, Final, Unpack

from catopt.decks.deck import Deck, Limits, Notes, refusal
from catopt.decks.strung import Chain, check_meeting, is_joint
from catopt.decks.to_case import height_of, site_of, site_of_chains, weight_of
from catopt.documents import check_entries, unfit
from catopt.errors import InputError, Problem, need_package
from catopt.model import Case, Line, Segment, Site
from catopt.model.network import LineBetween, Network, Point, PointKind
from catopt.words.message import Message


@dataclass(frozen=True)
class Item:
    """A value with its line: text, None, a list of items, or a table."""

    row: int
    value: Any


class YamlTable:
    """A mapping: what is read of it is noted, so that the rest can be named.

    `notes` takes problems and remarks; `opened` has all tables of the file that were looked into.
    """

    def __init__(
        self, row: int, items: Mapping[str, Item], notes: Notes, opened: list[YamlTable]
    ) -> None:
        self.row, self.items, self.notes, self.opened = row, items, notes, opened
        self.read: set[str] = set()
        opened.append(self)

    def __contains__(self, key: str) -> bool:
        return key in self.items and self.items[key].value is not None

    def item(self, key: str) -> Item:
        """Return what stands under a key, which counts as read; None where it is not there."""
        self.read.add(key)
        return self.items.get(key, Item(self.row, None))

    def text(self, key: str, default: str = "") -> str:
        """Return a word."""
        found = self.item(key)
        if found.value is None:
            return default
        if not isinstance(found.value, str):
            self.notes.refuse(found.row, key, "one_word")
            return default
        return found.value

    def number(self, key: str, default: float | None = None, **limits: Unpack[Limits]) -> float:
        """Return a number; without a default it has to be there."""
        word = self.text(key)
        if not word and default is not None:
            return default
        if not word:
            self.notes.refuse(self.row, "", "is_missing", name=key)
            return math.nan
        return self.notes.value(self.items[key].row, word, key, **limits)

    def numbers(self, key: str, count: int) -> list[float]:
        """Return a list of numbers, NaN for each that is not given."""
        found = self.item(key)
        words = found.value if isinstance(found.value, list) else []
        if len(words) != count:
            self.notes.refuse(found.row, key, "numbers_are_wanted", count=count)
            return [math.nan] * count
        return [
            math.nan if each.value is None else self.notes.value(each.row, str(each.value), key)
            for each in words
        ]

    def table(self, key: str) -> YamlTable:
        """Return a table, an empty one where there is none."""
        found = self.item(key)
        if found.value is not None and not isinstance(found.value, dict):
            self.notes.refuse(found.row, key, "keys_with_values")
        items = found.value if isinstance(found.value, dict) else {}
        return YamlTable(found.row, items, self.notes, self.opened)

    def items_of(self, key: str) -> list[Item]:
        """Return a list, an empty one where there is none."""
        found = self.item(key)
        if isinstance(found.value, list):
            return found.value
        if found.value is not None:
            self.notes.refuse(found.row, key, "a_list_is_wanted")
        return []

    def tables(self, key: str) -> Iterator[YamlTable]:
        """Yield the tables of a list."""
        for each in self.items_of(key):
            if isinstance(each.value, dict):
                yield YamlTable(each.row, each.value, self.notes, self.opened)
            elif each.value is not None:
                self.notes.refuse(each.row, key, "keys_with_values")

    def named(self, key: str) -> Iterator[tuple[str, YamlTable]]:
        """Yield name and table of each table below, also of one with ``keys`` and ``data``."""
        below = self.table(key)
        for row in below.rows():
            yield row.text("name"), row
        for name in [each for each in below.items if each not in ("keys", "data")]:
            yield name, below.table(name)

    def rows(self) -> Iterator[YamlTable]:
        """Yield the rows of ``keys`` and ``data``, each as a table."""
        heads = [str(each.value) for each in self.items_of("keys")]
        yield from self._rows(heads, self.items_of("data"))

    def columns(self, first: str) -> Iterator[YamlTable]:
        """Yield the rows below a key that names its columns, ``A, B, C``, by its first."""
        for key in [each for each in self.items if each.split(",")[0].strip() == first]:
            heads = [each.strip() for each in key.split(",")]
            yield from self._rows(heads, self.items_of(key))

    def _rows(self, heads: list[str], lines: list[Item]) -> Iterator[YamlTable]:
        for each in lines:
            values = each.value if isinstance(each.value, list) else [each]
            if len(values) > len(heads):
                given = refusal("values", count=len(values))
                self.notes.refuse(each.row, given, "wanted_count", count=len(heads))
            items = dict(zip(heads, values, strict=False))
            yield YamlTable(each.row, items, self.notes, self.opened)

    def say_unread(self, groups: Mapping[str, str]) -> None:
        """Name every key of the file that was not read, by the group that says why.

        `groups`: pattern of a group's keys, by the key of its remark; the first that fits is said.
        """
        found: dict[str, dict[str, list[int]]] = {}
        reported = {id(t.items[key]) for t in self.opened for key in t.read if key in t.items}
        for table in self.opened:
            for key, item in table.items.items():
                if id(item) not in reported and item.value is not None:
                    reported.add(id(item))
                    first = key.split(",")[0].strip()
                    fits = (name for name, keys in groups.items() if re.search(keys, first))
                    group = found.setdefault(next(fits, "unread_unknown"), {})
                    group.setdefault(first, []).append(item.row)
        for name, keys in sorted(found.items()):
            listed = (f"{key} ({_lines(rows)})" for key, rows in keys.items())
            self.notes.say(name, keys=", ".join(listed))


def _lines(rows: list[int]) -> str:
    return f"{rows[0]}" if len(rows) == 1 else f"{rows[0]} and {len(rows) - 1} more"


def parse_yaml(text: str, notes: Notes) -> YamlTable:
    """Read a YAML file whose top is a mapping.

    Raises InputError for what is no YAML, and where PyYAML is not installed.
    """
    need_package("PyYAML", "yaml", notes.source, module="yaml")
    import yaml

    check_entries(text, notes.source, ":,[{-")
    found = Item(1, None)
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
        found = _item(node, notes, set()) if node is not None else found
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        row = mark.line + 1 if mark is not None else 0
        notes.refuse(row, "", "yaml", said=getattr(error, "problem", None) or f"{error}")
    except RecursionError:
        notes.refuse(0, "", "nests_too_deeply")
    if not notes.problems and not isinstance(found.value, dict):
        notes.refuse(found.row, "", "keys_with_values")
    notes.raise_if_any()
    return YamlTable(found.row, found.value, notes, [])


def _item(node: Any, notes: Notes, seen: set[int]) -> Item:
    """Turn a node of PyYAML into an item; an alias, which lets a small file grow, is refused."""
    row = node.start_mark.line + 1
    if node.id == "scalar":
        return Item(row, None if node.tag.endswith(":null") else str(node.value))
    if id(node) in seen:
        notes.refuse(row, refusal("alias"), "alias_written_out")
        return Item(row, None)
    seen.add(id(node))
    if node.id == "sequence":
        return Item(row, [_item(each, notes, seen) for each in node.value])
    found: dict[str, Item] = {}
    for key, value in node.value:
        name = " ".join(str(key.value).split())
        kept, line = _item(value, notes, seen), key.start_mark.line + 1
        if name in found:
            notes.say("twice", line=line, key=name, value=str(kept.value)[:40])
        found[name] = Item(line, kept.value)
    return Item(row, found)


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
    from catopt.decks.deck import Notes
    from catopt.decks.mappp import parse_mappp
    from catopt.decks.moordyn import parse_moordyn
    from catopt.decks.ontology import parse_ontology
    from catopt.decks.orcaflex import parse_orcaflex
    from catopt.decks.strung import chains_of
    from catopt.decks.to_case import case_of, is_radial, lines_of

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
