"""Any one number of a file, from any one quantity of its answer: every value in a range.

The range is looked at in steps, each up to the very end of where there is an answer; between two
values on either side of what is asked lies a root, also where it is met only in between
(`catenary.unknowns`). Each answer carries what is left of the condition.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import singledispatch
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final, NamedTuple

from catopt.casefile.document import parts
from catopt.catenary.case import solve_case
from catopt.catenary.roots import root
from catopt.catenary.solution import Solution
from catopt.catenary.unknowns import MET, ROUNDING, Trial, crossings
from catopt.checks.case import check_case
from catopt.checks.kinds import CHECK_KINDS
from catopt.display import Displayable
from catopt.errors import CatoptError, InputError, NoAnswerError, NotConvergedError, refused
from catopt.model import Case
from catopt.model.kinds import Measured
from catopt.model.network import Network
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_rest import LinesAtRest
from catopt.mooring.solution import SystemSolution, solve_system
from catopt.quantities import QUANTITIES, Quantity
from catopt.records import Record
from catopt.sizing.file import SizingFile
from catopt.study.member import Base, document_of, kind_of_key, read_member, reason_of
from catopt.units import Dimension, to_si
from catopt.words import Message

Answer = Any
"""Of a case at rest: a Solution, a SystemSolution or LinesAtRest."""

_STEPS: Final = 40
_EDGE: Final = 1e-7
"""Of the range, to which the end of where there is an answer is looked for."""
_TOP: Final = 10.0
"""Times the number of the file, and that over it, is the range where none is given."""


class Word(NamedTuple):
    """A quantity of a part of an answer: which one it is, and how it is read."""

    quantity: str
    read: Callable[[Any], float | None]


def _end(which: str, name: str) -> Callable[[Solution], float]:
    return lambda line: float(getattr(getattr(line, which), name))


_ENDS: Final = {
    f"{word}_{name}": Word(quantity, _end(which, name))
    for word, which in (("from", "anchor"), ("to", "fairlead"))
    for name, quantity in (
        ("tension", "tension"),
        ("horizontal_force", "horizontal_force"),
        ("vertical_force", "vertical_force"),
        ("angle", "angle"),
    )
}
LINE: Final[Mapping[str, Word]] = MappingProxyType(
    {
        "span": Word("span", lambda line: line.span),
        "sag": Word("height", lambda line: line.sag),
        "clearance": Word("height", lambda line: line.lowest_point.z),
        "grounded_length": Word("grounded_length", lambda line: line.grounded_length),
        "tension": Word("tension", lambda line: max(each.max_tension for each in line.segments)),
        **_ENDS,
    }
)
"""Quantities of a line; its first end, an anchor where it has one, is `from`."""
_AT: Final = {
    "x": Word("offset", lambda each: each.place[0]),
    "y": Word("offset", lambda each: each.place[1]),
    "z": Word("height", lambda each: each.place[2]),
    "depth": Word("height", lambda each: each.place[2]),
}
"""Of what is somewhere; of a depth its height over the bed, which is taken off the water depth."""
POINT: Final[Mapping[str, Word]] = MappingProxyType(
    {**_AT, "bed_reaction": Word("vertical_force", lambda point: point.bed_reaction)}
)
FLOAT: Final[Mapping[str, Word]] = MappingProxyType(
    {
        "used": Word("vertical_force", lambda each: each.used),
        "draught": Word("height", lambda each: each.draught),
        "freeboard": Word("height", lambda each: each.freeboard and each.freeboard - each.under),
        "awash": Word("utilisation", lambda each: each.lost / each.of.lost_above - each.under),
    }
)
"""Of a float; `awash` is 0 where it begins to go under, and above 0 while it is afloat."""
IN_PLAN: Final[Mapping[str, Word]] = MappingProxyType(
    {
        "x": Word("offset", lambda body: body.position.x),
        "y": Word("offset", lambda body: body.position.y),
        "yaw": Word("angle", lambda body: body.position.yaw),
        "offset": Word("offset", lambda body: math.hypot(*body.offset)),
    }
)
"""Of a body."""
BODY: Final[Mapping[str, Word]] = MappingProxyType(
    {
        **IN_PLAN,
        "draught": Word("height", lambda body: body.floating.draught),
        "freeboard": Word("height", lambda body: body.floating.freeboard),
        "pull": Word("vertical_force", lambda body: body.floating.pull),
    }
)
"""Of one between points; `pull` is what its lines pull it down with."""
LOAD: Final[Mapping[str, Word]] = MappingProxyType(
    {**_AT, "bed_reaction": Word("seabed_reaction", lambda load: load.state.seabed_reaction)}
)
OWN_LOAD: Final[Mapping[str, Word]] = MappingProxyType(
    {
        "x": Word("offset", lambda load: load.x),
        "z": Word("height", lambda load: load.z),
        "depth": Word("height", lambda load: load.z),
        "bed_reaction": Word("seabed_reaction", lambda load: load.seabed_reaction),
    }
)
"""Of a clump weight or a buoy of a line alone."""


@dataclass(frozen=True)
class Asked:
    """What is asked of an answer: a quantity of one of its parts, and its value in SI."""

    part: str
    word: str
    quantity: Quantity
    value: float

    def of(self, read: Case | Network) -> float:
        """Solve a case, and say what its answer has of the quantity."""
        if self.part == "check":
            return _used(read, self.word)
        found = _parts(_answer(read), self.part)
        value = next(words[self.word].read(part) for part, words in found if self.word in words)
        if value is None:
            raise refused("--until", f"{self.part}.{self.word}", Message("study.not_known"))
        return read.site.water_depth - value if self.word == "depth" else value

    @property
    def words(self) -> str:
        """What is asked, as it was typed."""
        return f"{self.part}.{self.word}"


@dataclass(frozen=True)
class FoundValue(Record):
    """A value of the unknown at which the quantity is as asked."""

    DOCUMENT = "value reached residual"

    value: float
    """Of the key, in its unit."""
    reached: float
    """Of the quantity there, in its unit."""
    residual: float
    """By how much that misses what is asked, as a part of it, or of what the quantity spans."""


@dataclass(frozen=True)
class FoundValues(Displayable, Record):
    """Every value of one key of a file, in a range, at which a quantity of its answer is as asked.

    Numbers are in SI.
    """

    SCHEMA = "catopt.find/1"
    DOCUMENT = "title key unit quantity quantity_unit asked low high tried solutions reasons"

    title: str
    """Of the file; empty when it has none."""
    key: str
    """Path of the key in the file."""
    unit: str
    """SI unit of its values; empty for a pure number."""
    quantity: str
    """Part of the answer and quantity, as ``weight.z``."""
    quantity_unit: str
    """Its SI unit; empty for a pure number."""
    asked: float
    """Of the quantity."""
    low: float
    """End of the range of the key that was looked at."""
    high: float
    """The other."""
    tried: int
    """How many values of it were solved."""
    solutions: tuple[FoundValue, ...]
    """In rising order."""
    reasons: tuple[str, ...]
    """Why parts of the range have no answer."""
    base: Base
    """The file."""

    def mooring(self, number: int = 0) -> Case | Network:
        """Return the case with the value of a solution in place."""
        return _read(self.base, self.key, self.solutions[number].value)


@dataclass
class _Search:
    """The condition over the unknown, as `crossings` looks at it: from the low end of a range."""

    base: Base
    key: str
    asked: Asked
    low: float
    turns: bool = True

    def __post_init__(self) -> None:
        self.reasons: dict[str, None] = {}
        self.tried = 0

    def missing(self, way: float) -> float:
        """Say what is missing so far up from the low end; nan where there is no answer."""
        self.tried += 1
        try:
            return self.asked.of(_read(self.base, self.key, self.low + way)) - self.asked.value
        except InputError as error:
            if any(each.key == "--until" for each in error.problems):
                raise
            self.reasons[reason_of(error)] = None
        except (NoAnswerError, NotConvergedError) as error:
            self.reasons[reason_of(error)] = None
        return math.nan

    def runs(self, ways: list[float]) -> Iterator[list[Trial]]:
        """Try values, and yield runs of neighbours with an answer, each up to its ends."""
        tried = [Trial(way, self.missing(way)) for way in ways]
        run: list[Trial] = []
        for one, other in pairwise([*tried, Trial(math.inf, math.nan)]):
            if not math.isnan(one.missing):
                run.append(one)
            if math.isnan(one.missing) == math.isnan(other.missing):
                continue
            if math.isfinite(other.value):
                run += self._edge(one, other)
            if not math.isnan(one.missing):
                yield sorted(run)
                run = []

    def _edge(self, one: Trial, other: Trial) -> list[Trial]:
        """Close in on the end of where there is an answer; the last value that has one."""
        low, high, within = one, other, _EDGE * max(other.value, one.value)
        while high.value - low.value > within:
            middle = 0.5 * (low.value + high.value)
            new = Trial(middle, self.missing(middle))
            if math.isnan(new.missing) == math.isnan(low.missing):
                low = new
            else:
                high = new
        return [each for each in (low, high) if not math.isnan(each.missing)]

    def root(self, low: Trial, high: Trial) -> float:
        """Find where nothing is missing between two values; either side of a jump."""
        try:
            return root(
                self.missing, low.value, high.value, xtol=ROUNDING * high.value, rtol=ROUNDING
            )
        except NotConvergedError:
            return low.value


def find_value(
    path: Path, key: str, until: str, low: str | None = None, high: str | None = None
) -> FoundValues:
    """Find every value of one key of a case file at which a quantity of its answer is as asked.

    Parameters
    ----------
    path : Path
        Of the case file, of a line, a body or points.
    key : str
        Path of a number in it, such as ``lines[0].segments[1].length``; a part of an array by its
        number from 0, or by its name: ``points[weight].submerged_weight``.
    until : str
        What the answer is to have, such as ``weight.z = 100 m``.
    low, high : str, optional
        Ends of the range, with units; else a tenth of the file's number, and ten times that.

    Raises
    ------
    InputError
        What is asked is not in the file, or in its answer.
    NoAnswerError
        No value in the range gives it.
    """
    document = document_of(path)
    base = Base(document, str(path), str(path.parent), "statics")
    key = _numbered(key, document)
    kind = kind_of_key(base, key)
    if not isinstance(kind, Measured):
        raise refused("key", f'"{key}"', Message("study.no_number"))
    dimension = kind.dimension
    ends = [None if end is None else _in_si(end, dimension, "--from, --to") for end in (low, high)]
    least, most = _range(base, key, kind, *ends)
    read = read_member(base, {})
    assert not isinstance(read, SizingFile)
    asked = _asked(until, read)
    search = _Search(base, key, asked, least)
    solutions, spread = _solutions(
        search, most - least, by_ratio=least > 0.0 and most > 4.0 * least
    )
    if not solutions:
        raise _none(search, spread, least, most, dimension)
    return FoundValues(
        getattr(read, "title", ""),
        key,
        dimension.si_unit,
        asked.words,
        asked.quantity.si_unit.strip("-"),
        asked.value,
        least,
        most,
        search.tried,
        tuple(solutions),
        tuple(search.reasons),
        base,
    )


def _solutions(
    search: _Search, width: float, *, by_ratio: bool
) -> tuple[list[FoundValue], list[Trial]]:
    """Look at the whole range: the values found, and all that was tried on the way."""
    shares = [k / _STEPS for k in range(_STEPS + 1)]
    if by_ratio:
        ratio = (search.low + width) / search.low
        shares = [(ratio**share - 1.0) / (ratio - 1.0) for share in shares]
    runs = [*search.runs([width * share for share in shares])]
    every = [each for run in runs for each in run]
    size = abs(search.asked.value) or max((abs(each.missing) for each in every), default=1.0)
    found = []
    for run in runs:
        ways = [each.value for each in run if each.missing == 0.0]
        ways += [search.root(*pair) for pair in crossings(search, run)]
        for way in sorted(dict.fromkeys(ways)):
            left = search.missing(way)
            if abs(left) <= MET * max(size, 1e-300):
                there = search.asked.value + left
                found.append(FoundValue(search.low + way, there, left / size if size else 0.0))
    return found, every


def _none(
    search: _Search, tried: list[Trial], low: float, high: float, dimension: Dimension
) -> CatoptError:
    """Say that no value of the range gives what is asked, and how near the nearest comes."""
    if not tried:
        why = "; ".join(search.reasons)
        return NoAnswerError(Message("study.no_value_answered", key=search.key, why=why))
    nearest = min(tried, key=lambda each: abs(each.missing))
    quantity = search.asked.quantity
    unit = f" {dimension.si_unit}".rstrip()
    values = {
        "key": search.key,
        "quantity": search.asked.words,
        "low": f"{low:.6g}{unit}",
        "high": f"{high:.6g}{unit}",
        "asked": f"{search.asked.value:.6g} {quantity.si_unit.strip('-')}".strip(),
        "nearest": f"{search.asked.value + nearest.missing:.6g}",
        "at": f"{search.low + nearest.value:.6g}{unit}",
    }
    return NoAnswerError(Message("study.no_value_found", **values))


def _range(
    base: Base, key: str, kind: Measured, low: float | None, high: float | None
) -> tuple[float, float]:
    """Say which range of a key is looked at."""
    if low is None or high is None:
        own = _own(base, key, kind)
        if own is None or own == 0.0:
            raise refused("--from, --to", "", Message("study.range_wanted", key=key))
        ends = sorted((own / _TOP, own * _TOP))
        low, high = ends[0] if low is None else low, ends[1] if high is None else high
    if not low < high:
        raise refused("--from, --to", f"{low:g}, {high:g}", Message("study.range_rising"))
    return low, high


def _own(base: Base, key: str, kind: Measured) -> float | None:
    """Return what the file itself has at a key, in SI."""
    place: Any = base.document
    for part in parts(key):
        try:
            place = place[part]
        except (KeyError, IndexError, TypeError):
            return None
    return float(kind.read(place))


def _in_si(text: str, dimension: Dimension, key: str) -> float:
    return to_si(float(text) if re.fullmatch(r"[-+.\deE]+", text) else text, dimension, key)


def _read(base: Base, key: str, value: float) -> Case | Network:
    read = read_member(base, {key: value})
    assert not isinstance(read, SizingFile)
    return read


def _numbered(key: str, document: Mapping[str, Any]) -> str:
    """Count a part of an array that a key names: ``points[weight].x`` as ``points[1].x``."""

    def number(found: re.Match[str]) -> str:
        array = document.get(found[1], [])
        names = [each.get("name") if isinstance(each, dict) else None for each in array]
        if found[2] in names:
            return f"{found[1]}[{names.index(found[2])}]"
        return found[0]

    return re.sub(r"^(\w+)\[([^\]]*)\]", number, key)


# ------------------------------------------------------------------ what an answer has


@singledispatch
def _answer(read: Case | Network) -> Answer:
    """Bring what a file moors to rest."""
    raise TypeError(type(read))


@_answer.register
def _(read: Network) -> Answer:
    return at_rest(read)


@_answer.register
def _(read: Case) -> Answer:
    return solve_case(read) if read.system is None else solve_system(read.system)


def _used(read: Case | Network, kind: str) -> float:
    report = check_case(read)
    used = report.tightest(kind)
    if used is None or used.utilisation is None:
        raise refused("--until", f"check.{kind}", Message("study.no_such_check"))
    return used.utilisation


Part = tuple[Any, Mapping[str, Word]]


def _parts(answer: Answer, name: str) -> list[Part]:
    """List what of an answer has a name, with what may be asked of it."""
    return [(part, words) for own, part, words in _named(answer) if own == name]


Named = Iterator[tuple[str, Any, Mapping[str, Word]]]


@singledispatch
def _named(answer: Answer) -> Named:
    """Yield every part of an answer by its name."""
    raise TypeError(type(answer))


@_named.register
def _(answer: LinesAtRest) -> Named:
    for line in answer.named_lines:
        yield line.name, line.solution, LINE
        yield from _loads(line.point_loads, LOAD, f" of {line.name}")
    for point in answer.points:
        yield point.of.name, point, POINT
    for each in answer.floats:
        yield each.name, each, FLOAT
    for body in answer.bodies:
        yield body.body.name, body, BODY


@_named.register
def _(answer: SystemSolution) -> Named:
    for k, line in enumerate(answer.lines, start=1):
        yield f"line {k}", line.solution, LINE
        yield from _loads(line.placed_loads, LOAD, f" of line {k}")
    yield "body", answer, IN_PLAN


@_named.register
def _(answer: Solution) -> Named:
    yield "line", answer, LINE
    yield from _loads(answer.point_loads, OWN_LOAD, "")


def _loads(loads: tuple[Any, ...], words: Mapping[str, Word], where: str) -> Named:
    for k, load in enumerate(loads, start=1):
        name = getattr(load, "name", "") or getattr(getattr(load, "state", None), "name", "")
        yield name or f"load {k}{where}", load, words


_ASKED: Final = re.compile(r"\s*(.+)\.(\w+)\s*=\s*(.+?)\s*")
_OTHER_NAMES: Final = {"anchor": "from", "fairlead": "to"}


def _asked(until: str, read: Case | Network) -> Asked:
    """Read what is asked of an answer; InputError where it has nothing of the kind."""
    found = _ASKED.fullmatch(until)
    if found is None:
        raise refused("--until", f'"{until}"', Message("study.until_wanted"))
    part, word, text = found[1], found[2], found[3]
    for own, other in _OTHER_NAMES.items():
        word = re.sub(f"^{own}_", f"{other}_", word)
    if part == "check":
        if word not in CHECK_KINDS:
            words = ", ".join(CHECK_KINDS)
            raise refused("--until", word, Message("refused.of_these", words=words))
        return Asked(
            part, word, QUANTITIES["utilisation"], _in_si(text, Dimension.NUMBER, "--until")
        )
    named = [*_named(_answer(read))]
    of_part = [words for own, _, words in named if own == part]
    if not of_part:
        names = ", ".join(dict.fromkeys(own for own, _, _ in named))
        raise refused("--until", part, Message("refused.one_of", words=names))
    known = {name: each for words in of_part for name, each in words.items()}
    if word not in known:
        raise refused("--until", word, Message("refused.of_these", words=", ".join(known)))
    quantity = QUANTITIES[known[word].quantity]
    dimension = next(each for each in Dimension if each.si_unit == quantity.si_unit.strip("-"))
    return Asked(part, word, quantity, _in_si(text, dimension, "--until"))
