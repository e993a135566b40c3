"""What a deck says, whichever program it is for; numbers in SI, heights from the still water."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from operator import itemgetter
from typing import Any, Literal, TypedDict, TypeVar, Unpack

from catopt.errors import InputError, Problem
from catopt.tables import few, number
from catopt.units import Dimension, implausible
from catopt.words.message import Message

T = TypeVar("T")
End = Literal["fixed", "coupled", "free"]


@dataclass(frozen=True)
class Row:
    """A line of data: its number in the file, counted from 1, and its words."""

    number: int
    words: tuple[str, ...]


@dataclass(frozen=True)
class LineType:
    """What a line is made of, with its line of the file.

    `diameter`: volume-equivalent, m; `mass`: in air, kg/m; `EA`, `MBL`: N, or
    the table of strains that a rope follows; `friction`: on the bed, where the deck has it by line
    type; `drag`: Cd across on d, Cd along on pi d, Ca across and along on the displaced water.
    """

    row: int
    diameter: float
    mass: float
    EA: Any
    friction: float | None = None
    drag: tuple[float, float, float, float] | None = None
    MBL: float | None = None
    nominal_diameter: float | None = None


@dataclass(frozen=True)
class Point:
    """Where lines end or meet; M (kg), V (m3), Cd A (m2) and force (N) of what hangs there.

    `hung`: name of that, where the deck has one. `float_height`: m, of what floats there; 0: not
    known.
    """

    row: int
    name: str
    end: End
    x: float
    y: float
    z: float
    mass: float = 0.0
    volume: float = 0.0
    drag_area: float = 0.0
    added_mass: float = 0.0
    force: tuple[float, float, float] = (0.0, 0.0, 0.0)
    hung: str = ""
    float_height: float = 0.0

    @property
    def body(self) -> tuple[float, float, float, float]:
        """M, V, Cd A and Ca of what hangs there."""
        return self.mass, self.volume, self.drag_area, self.added_mass


def along_axes(
    place: tuple[float, float, float], turned: Sequence[float]
) -> tuple[float, float, float]:
    """Return a place along the axes of a body along x, y, z; turned about x, then y, then z, deg.

    Where it is turned about one of them the order does not matter.
    """
    x, y, z = place
    roll, pitch, yaw = map(math.radians, turned)
    y, z = y * math.cos(roll) - z * math.sin(roll), y * math.sin(roll) + z * math.cos(roll)
    x, z = x * math.cos(pitch) + z * math.sin(pitch), z * math.cos(pitch) - x * math.sin(pitch)
    x, y = x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) + y * math.cos(yaw)
    return x, y, z


@dataclass(frozen=True)
class DeckPiece:
    """A uniform line between two points."""

    row: int
    type: str
    ends: tuple[str, str]
    length: float


@dataclass(frozen=True)
class Deck:
    """A deck whose every number was read."""

    gravity: float
    density: float
    depth: float
    types: Mapping[str, LineType]
    points: Mapping[str, Point]
    pieces: Sequence[DeckPiece]
    friction: float | None = None

    def hung_weight(self, point: Point) -> float:
        """Return the weight in water of what hangs at a point, N."""
        return (point.mass - self.density * point.volume) * self.gravity


MOST_PARTS = 2_000
"""Points and lines of a deck, each; more answer no sooner than in minutes."""
MOST_TOLD = 50
"""Faults of a deck that are told."""
SHOWN = 10
"""Lines of a file that are named for one fault."""
LONGEST = 80
"""Characters of a deck that a refusal shows."""


class Limits(TypedDict, total=False):
    """What a number has to lie above, or be no less than."""

    above: float
    at_least: float


def refusal(key: str, /, **values: object) -> Message:
    """Say why a deck is refused, or what was found in it; long words of the deck are cut."""
    return Message(
        f"refused_deck.{key}",
        **{name: cut(value) if isinstance(value, str) else value for name, value in values.items()},
    )


def cut(text: str) -> str:
    """Keep as much of a text as a refusal shows; a message stays as it is."""
    is_short = len(text) <= LONGEST or isinstance(text, Message)
    return text if is_short else f"{text[:LONGEST]}..."


def _place(rows: Sequence[int]) -> Message:
    """Say in which lines of the file something is wrong."""
    if len(rows) > 1:
        first = [*map(str, rows[: min(SHOWN, len(rows) - 1)]), *["..."] * (len(rows) > SHOWN + 1)]
        return refusal("at_lines", rows=", ".join(first), row=rows[-1])
    return refusal("at_line", row=rows[0]) if rows[0] else refusal("at_file")


@dataclass
class Notes:
    """What is wrong with a deck and what is to be said of it, gathered while it is read.

    `source`: name of the file; `only`: the one line that is required, counted from 1; `turbines`: x
    and y of each turbine of a farm, m; `problems`: with their lines of the file.
    """

    source: str = ""
    only: int | None = None
    turbines: Sequence[tuple[float, float]] = ()
    problems: dict[Problem, int] = field(default_factory=dict)
    remarks: list[Message] = field(default_factory=list)
    _said: set[Message] = field(default_factory=set)

    def refuse(self, row: int, found: str, key: str, /, **values: object) -> None:
        """Note what is wrong in a line of the file; 0: in the whole of it. Long words are cut.

        `key` with its `values` says what would be right, as `refusal` has it.
        """
        problem = Problem(_place([row]), cut(found), refusal(key, **values))
        self.problems[problem] = row

    def say(self, key: str, /, **values: object) -> None:
        """Note a remark, once."""
        remark = Message(f"decks.{key}", **values)
        if remark not in self._said:
            self._said.add(remark)
            self.remarks.append(remark)

    def raise_if_any(self) -> None:
        """Raise InputError with every problem, in the order of the file, each once."""
        alike: dict[tuple[str, str], list[int]] = {}
        for problem, row in sorted(self.problems.items(), key=itemgetter(1)):
            alike.setdefault((problem.found, problem.allowed), []).append(row)
        if alike:
            problems = [Problem(_place(rows), *said) for said, rows in alike.items()]
            raise InputError(few(problems, most=MOST_TOLD), self.source)

    def require(self, sections: Mapping[str, Sequence[Row]]) -> None:
        """Refuse a deck without line types, points or lines."""
        for name, said in (("types", "line_types"), ("points", "points"), ("lines", "lines")):
            if not sections.get(name):
                self.refuse(0, "", "section_is_missing", name=refusal(said))

    def by_name(self, entries: Mapping[Row, T]) -> dict[str, T]:
        """Key the entries of a section by their first word, which stands once."""
        found: dict[str, T] = {}
        for row, entry in entries.items():
            if row.words[0] in found:
                self.refuse(row.number, row.words[0], "another_of_this_name")
            found[row.words[0]] = entry
        return found

    def number(self, row: Row, column: int, name: str, **limits: Unpack[Limits]) -> float:
        """Read a number by its column; NaN where it is none, which is noted."""
        if column >= len(row.words):
            self.refuse(row.number, "", "missing_in_column", name=name, column=column + 1)
            return math.nan
        return self.value(row.number, row.words[column], name, **limits)

    def value(self, row: int, word: str, name: str, **limits: Unpack[Limits]) -> float:
        """Read a number, with Fortran's D for an exponent too."""
        above, at_least = limits.get("above", -math.inf), limits.get("at_least", -math.inf)
        found = number(word.lower().replace("d", "e"))
        if not math.isfinite(found) or found <= above or found < at_least:
            key = "a_number_above" if above > -math.inf else "a_number_of_at_least"
            limit = max(above, at_least)
            key = key if limit > -math.inf else "a_number_is_wanted"
            self.refuse(row, f"{name} {word}", key, limit=limit)
            return math.nan
        return found


def check_sizes(deck: Deck, notes: Notes) -> None:
    """Note what is beyond any mooring: as in a case file, but where a deck has 1e-20 for none."""
    for name, count in (("points", len(deck.points)), ("lines", len(deck.pieces))):
        if count > MOST_PARTS:
            notes.refuse(0, refusal(name), "most_parts", count=count, most=MOST_PARTS)
    length, force, mass = Dimension.LENGTH, Dimension.FORCE, Dimension.MASS
    every: list[tuple[int, str, float, Dimension]] = [(0, "depth", deck.depth, length)]
    for kind in deck.types.values():
        every.append((kind.row, "d", kind.diameter, length))
        every.append((kind.row, "m", kind.mass, Dimension.MASS_PER_LENGTH))
        if isinstance(kind.EA, float) and not math.isinf(kind.EA):
            every.append((kind.row, "EA", kind.EA, Dimension.PRESSURE))  # up to rigid: 1e15
    for point in deck.points.values():
        every += [(point.row, key, getattr(point, key), length) for key in "xyz"]
        every += [(point.row, "F", number, force) for number in point.force]
        every += [(point.row, "M", point.mass, mass)]
        every += [(point.row, "V", point.volume, Dimension.VOLUME)]
    every += [(piece.row, "L", piece.length, length) for piece in deck.pieces]
    for row, key, value, dimension in every:
        if abs(value) > dimension.largest:
            found = Problem(_place([row]), f"{key} {value:g}", implausible(dimension, value))
            notes.problems[found] = row
