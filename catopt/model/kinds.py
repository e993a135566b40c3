"""What a key of a case file, or an attribute of the model, may be; and checks of ranges."""

from __future__ import annotations

import math
import sys
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import MISSING, dataclass, replace
from functools import cache
from types import MappingProxyType
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    NamedTuple,
    Self,
    get_args,
    get_origin,
    get_type_hints,
)

from catopt.errors import InputError, Problem, refused
from catopt.units import Dimension, as_written, is_quantity, plain, to_si, wanted
from catopt.words import Message


def _unit(si_unit: str) -> str:
    """Write a unit of SI as messages about arguments do."""
    return si_unit.replace("^", "").replace("*", " ")


def number_wanted(unit: str) -> Message:
    """Say that a number in a unit of SI is required; empty for a pure one."""
    return Message("refused.number_in" if unit else "refused.number", unit=unit)


DIMENSIONS = {_unit(each.si_unit): each for each in Dimension}
DIMENSIONS["N/m2"] = Dimension.PRESSURE
"""By their SI units, as messages write them."""


@cache
def _known(of: type) -> Mapping[str, tuple[object, Annotation]]:
    """Of each attribute of a class: its default, and what its annotation says."""
    return {key: (getattr(of, key, MISSING), each) for key, each in annotated(of).items()}


class Findings:
    """Gathers the problems of one value or one call, so that all are reported together.

    Given the value itself, it reads what of it is text with a unit, and puts the number in SI in
    its place; nan where there is none, with its problem noted.
    """

    def __init__(self, source: str = "", of: object = None) -> None:
        self.source = source or type(of).__name__
        self.problems: list[Problem] = []
        self._of = of

    def check(self, *keys: str) -> Self:
        """Note the problems of attributes, by their annotated kinds; of all if none is named.

        What is the default of its class is right.
        """
        of: type = type(self._of)
        known = _known(of)
        for key in keys or known:
            value = getattr(self._of, key)
            default, annotation = known[key]
            if value is default:
                continue
            # The commonest by far is a number that is right: it is passed at once.
            kind = annotation.kind
            if not (type(value) is float and isinstance(kind, Measured) and kind.allows(value)):
                self._check(key, value, annotation)
        return self

    def _check(self, key: str, value: object, annotation: Annotation) -> None:
        kind = annotation.kind
        if isinstance(kind, Measured):
            unit = _unit(kind.si_unit)
            bounds = {"above": kind.above, "at_least": kind.at_least, "at_most": kind.at_most}
            if not annotation.is_array:
                self.number(key, value, unit, **bounds, infinite=kind.infinite)
            elif annotation.size is None:
                self.each(key, unit, **bounds)
            else:
                self._vector(key, unit, annotation.size.most)
        elif isinstance(kind, Whole) and not annotation.is_array:
            self.count(key, value)
        elif isinstance(kind, OneOf) and not annotation.is_array:
            self.word(key, value, kind.words, quoted=kind.quoted)
        elif isinstance(kind, Text) and kind.filled and value and not str(value).strip():
            self.add(key, as_written(value), kind.wanted)  # a file refuses blanks, too

    def _vector(self, key: str, unit: str, size: int) -> None:
        """Check numbers of which there are none, or so many."""
        values = tuple(getattr(self._of, key))
        object.__setattr__(self._of, key, values)
        if len(values) not in {0, size}:
            found = Message("refused.numbers", count=len(values))
            self.add(key, found, Message("refused.so_many", count=size))
        self.each(key, unit)

    def number(
        self,
        key: str,
        value: object,
        unit: str,
        *,
        above: float | None = None,
        at_least: float | None = None,
        at_most: float | None = None,
        infinite: bool = False,
    ) -> None:
        """Note a problem unless `value` is a number within the bounds.

        The unit is empty for a pure number; `infinite` allows positive infinity.
        """
        if (isinstance(value, str) or is_quantity(value)) and hasattr(self._of, key):
            read = self._read(key, value, unit)
            object.__setattr__(self._of, key, math.nan if read is None else read)
            if read is None:
                return
            value = read
        elif plain(value) is not value:
            value = plain(value)
            if hasattr(self._of, key):
                object.__setattr__(self._of, key, value)
        if isinstance(value, bool) or not isinstance(value, (int, float)) or value != value:
            self.add(key, repr(value), number_wanted(unit))
        elif isinstance(value, int) and abs(value) > sys.float_info.max:
            self.add(key, Message("refused.beyond_floats"), number_wanted(unit))
        elif math.isinf(value) and not (infinite and value > 0.0):
            finite = "refused.finite_in" if unit else "refused.finite_number"
            self.add(key, repr(value), Message(finite, unit=unit))
        elif beyond := out_of_range(value, unit, above, at_least, at_most):
            self.add(key, repr(value), beyond)

    def numbers(self, of: object, unit: str, *keys: str, **bounds: float) -> None:
        """Note a problem of each attribute that is neither None nor a number within the bounds."""
        for key in keys:
            value = getattr(of, key)
            if value is not None:
                self.number(key, value, unit, **bounds, infinite=False)

    def taken(self, key: str, value: object, unit: str, **bounds: float | None) -> float:
        """Return a number, read where it is text with a unit; nan with its problem noted."""
        if type(value) is float and list(bounds) == ["at_least"]:  # nearly all are right: at once
            least = bounds["at_least"]
            if least is not None and least <= value < math.inf:
                return value
        has_unit = isinstance(value, str) or is_quantity(value)
        read = self._read(key, value, unit) if has_unit else plain(value)
        if read is not None:
            self.number(key, read, unit, **bounds, infinite=False)
        return read if isinstance(read, (int, float)) else math.nan

    def each(self, key: str, unit: str, **bounds: float | None) -> None:
        """Do the same for each item of an attribute that is a sequence."""
        items = enumerate(getattr(self._of, key))
        read = tuple(self.taken(f"{key}[{k}]", item, unit, **bounds) for k, item in items)
        object.__setattr__(self._of, key, read)

    def _read(self, key: str, text: object, unit: str) -> float | None:
        """Read what has a unit; None, with the problem noted, where it is none."""
        try:
            return to_si(text, DIMENSIONS[unit], key)
        except InputError as error:
            self.problems += error.problems
            return None

    def word(self, key: str, value: object, words: Sequence[str], *, quoted: bool = False) -> None:
        """Note a problem unless `value` is one of some words; quoted: shown as a file has it."""
        if value not in words:
            self.add(
                key,
                f'"{value}"' if quoted else repr(value),
                Message("refused.of_these", words=", ".join(words)),
            )

    def count(self, key: str, value: object) -> None:
        """Note a problem unless `value` is within the bounds of the count that `key` is."""
        fewest, most = COUNTS[key]
        if isinstance(value, str) or is_quantity(value):
            self.add(key, repr(value), Message("refused.whole"))
        else:
            self.number(key, value, "", at_least=fewest, at_most=most)

    def some(self, key: str, allowed: str) -> None:
        """Note a problem unless an attribute that is a sequence has an item."""
        if not getattr(self._of, key):
            self.add(key, Message("refused.none"), allowed)

    def add(self, key: str, found: str, allowed: str) -> None:
        """Note a problem."""
        self.problems.append(Problem(key, found, allowed))

    def raise_if_any(self) -> None:
        """Raise InputError when a problem was noted."""
        if self.problems:
            raise InputError(self.problems, self.source)


class Checked:
    """A part of the model, which is right when it is there: InputError has all that is wrong."""

    def __post_init__(self) -> None:
        found = Findings(of=self)
        self._check(found)
        found.raise_if_any()

    def _check(self, found: Findings) -> None:
        """Note what is wrong: of each attribute, by its kind."""
        found.check()


COUNTS: Mapping[str, tuple[int, int]] = MappingProxyType(
    {
        "particles": (2, 10_000),
        "iterations": (1, 10_000),
        "seeds": (1, 100),
        "other_lengths": (0, 30),
        "runs": (1, 1_000),
        "seed": (0, 2**63 - 1),
        "population": (4, 10_000),
        "evaluations": (1, 10_000_000),
        "max_enumerated": (1, 100_000_000),
        "max_run": (1, 100_000),
        "elements": (4, 5_000),
        "components": (1, 10_000),
        "spreading_directions": (1, 360),
        "segment": (1, 200),
        "point_load": (1, 200),
        "joint": (1, 200),
        "broken_line": (1, 100),
        "lines": (1, 100),
        "headings": (1, 360),
        "samples": (1, 10_000_000),
        "count": (2, 100_000),
    }
)
"""Fewest and most of everything that a user may ask a number of. The most is what still answers
within days; how long it takes is said before it begins."""


STIFFEST = 1e20
"""Largest axial stiffness that is read, N; so large a number says that nothing stretches."""

Given = float | str
"""What a measure may be given as: a number in SI, or text with a unit."""


class Kind(ABC):
    """A kind of value; stands in the ``Annotated`` type of an attribute or a key."""

    @property
    @abstractmethod
    def wanted(self) -> str:
        """What is required, with an example."""

    @abstractmethod
    def read(self, value: object) -> object:
        """Return the value as the model takes it, or raise InputError with one problem."""

    def _refused(self, value: object, allowed: str = "") -> InputError:
        return refused("value", as_written(value), allowed or self.wanted)


@dataclass(frozen=True)
class Measured(Kind):
    """A number with a unit; bounds in SI: exclusive below, inclusive below, inclusive above.

    `example`: where that of the dimension is not to the point. `bare`: unit of a bare number in a
    file, that of SI when empty. `si`: how its unit in SI is written, where not as the dimension's.
    `infinite`: whether Python may give positive infinity.
    """

    dimension: Dimension
    above: float | None = None
    at_least: float | None = None
    at_most: float | None = None
    example: str = ""
    bare: str = ""
    si: str = ""
    infinite: bool = False

    @property
    def wanted(self) -> str:
        """What is required, with an example."""
        return wanted(self.dimension, self.example)

    @property
    def si_unit(self) -> str:
        """Unit in SI as a file has it; empty for a pure number."""
        return self.si or self.dimension.si_unit

    def allows(self, value: float) -> bool:
        """Whether a number in SI is finite and within the bounds."""
        return (
            math.isfinite(value)
            and (self.above is None or value > self.above)
            and (self.at_least is None or not exceeds(self.at_least, value))
            and (self.at_most is None or not exceeds(value, self.at_most))
        )

    def read(self, value: object) -> float:
        """Return the value in SI."""
        try:
            most = STIFFEST if self.infinite else None
            si = to_si(value, self.dimension, bare=self.bare, most=most)
        except InputError as error:
            (problem,) = error.problems
            allowed = _with_example(problem.allowed, self.dimension.example, self.example)
            raise InputError([replace(problem, allowed=allowed)]) from None
        unit = self.dimension.si_unit
        beyond = out_of_range(si, unit, self.above, self.at_least, self.at_most)
        if beyond:
            # Too large for a bare number: perhaps it was meant in another unit.
            large = self.at_most is not None and si > self.at_most and not isinstance(value, str)
            if large and unit:
                example = self.dimension.example
                beyond = Message("refused.and_bare", fault=beyond, unit=unit, example=example)
            raise self._refused(value, beyond)
        return si


@dataclass(frozen=True)
class Whole(Kind):
    """A whole number within the bounds of one of `COUNTS`; the example is for messages."""

    key: str
    example: int

    @property
    def bounds(self) -> tuple[int, int]:
        """Smallest and largest value."""
        return COUNTS[self.key]

    @property
    def wanted(self) -> str:
        """What is required, with an example."""
        return Message("refused.whole_such_as", example=self.example)

    def read(self, value: object) -> int:
        """Return the number."""
        if isinstance(value, bool) or not isinstance(value, int):
            raise self._refused(value)
        fewest, most = self.bounds
        if value > most:
            raise self._refused(value, Message("refused.or_less", bound=f"{most}"))
        if value < fewest:
            raise self._refused(value, Message("refused.or_more", bound=f"{fewest}"))
        return value


@dataclass(frozen=True)
class Text(Kind):
    """Free text; filled: with more than blanks."""

    filled: bool = False
    example: str = ""

    @property
    def wanted(self) -> str:
        """What is required, with the example if there is one."""
        key = "refused.text_such_as" if self.example else "refused.text"
        return Message(key, example=self.example)

    def read(self, value: object) -> str:
        """Return the text."""
        if not isinstance(value, str) or (self.filled and not value.strip()):
            raise self._refused(value)
        return value


@dataclass(frozen=True)
class File(Text):
    """Path of a file, which counts from the folder of the case file; absolute in the model."""

    filled: bool = True


@dataclass(frozen=True)
class Flag(Kind):
    """Yes or no."""

    @property
    def wanted(self) -> str:
        """The two words."""
        return Message("refused.flag")

    def read(self, value: object) -> bool:
        """Return it."""
        if not isinstance(value, bool):
            raise self._refused(value)
        return value


@dataclass(frozen=True)
class OneOf(Kind):
    """One of several words; quoted: messages about an argument show it as a file has it."""

    words: tuple[str, ...]
    quoted: bool = False

    @property
    def wanted(self) -> str:
        """The words."""
        return Message("refused.one_of", words=", ".join(self.words))

    def read(self, value: object) -> str:
        """Return the word."""
        if not isinstance(value, str):
            raise self._refused(value)
        if value not in self.words:
            from difflib import get_close_matches

            for near in get_close_matches(value.casefold(), self.words, n=1):
                meant = Message("refused.and_meant", wanted=self.wanted, near=near)
                raise self._refused(value, meant)
            raise self._refused(value)
        return value


class Size(NamedTuple):
    """How many values an array has; an array of the model may be empty all the same."""

    fewest: int
    most: int


Length = Annotated[float, Measured(Dimension.LENGTH, above=0.0)]
Height = Annotated[float, Measured(Dimension.LENGTH, at_least=0.0)]
Place = Annotated[float, Measured(Dimension.LENGTH)]
Area = Annotated[float, Measured(Dimension.AREA, at_least=0.0, example='"1.5 m^2"')]
SomeArea = Annotated[float, Measured(Dimension.AREA, above=0.0, example='"20 m^2"')]
Mass = Annotated[float, Measured(Dimension.MASS, above=0.0)]
SomeMass = Annotated[float, Measured(Dimension.MASS, at_least=0.0)]
Density = Annotated[float, Measured(Dimension.DENSITY, above=0.0)]
Force = Annotated[float, Measured(Dimension.FORCE)]
SomeForce = Annotated[float, Measured(Dimension.FORCE, at_least=0.0)]
Strength = Annotated[float, Measured(Dimension.FORCE, above=0.0)]
Weight = Annotated[float, Measured(Dimension.FORCE_PER_LENGTH)]
MassPerLength = Annotated[float, Measured(Dimension.MASS_PER_LENGTH, at_least=0.0)]
Price = Annotated[float, Measured(Dimension.PRICE_PER_LENGTH, at_least=0.0)]
Stiffness = Annotated[float, Measured(Dimension.FORCE_PER_LENGTH)]
Moment = Annotated[float, Measured(Dimension.MOMENT)]
Angle = Annotated[float, Measured(Dimension.ANGLE)]
Uplift = Annotated[float, Measured(Dimension.ANGLE, at_least=0.0, at_most=math.pi / 2.0)]
Speed = Annotated[float, Measured(Dimension.SPEED)]
SomeSpeed = Annotated[float, Measured(Dimension.SPEED, at_least=0.0)]
WearRate = Annotated[float, Measured(Dimension.SPEED, at_least=0.0, example='"0.4 mm/year"')]
Time = Annotated[float, Measured(Dimension.TIME, above=0.0)]
Duration = Annotated[float, Measured(Dimension.TIME, at_least=0.0)]
Factor = Annotated[float, Measured(Dimension.NUMBER, at_least=1.0)]
Share = Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=1.0)]
Positive = Annotated[float, Measured(Dimension.NUMBER, above=0.0)]
NotNegative = Annotated[float, Measured(Dimension.NUMBER, at_least=0.0)]
Coefficient = Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, example="1.2")]
Seed = Annotated[int, Whole("seed", example=1)]
Headings = Annotated[int, Whole("headings", example=12)]
OneSegment = Annotated[int, Whole("segment", example=1)]
Source = Annotated[str, Text(filled=True)]
Accepted = Annotated[
    str,
    OneOf(
        (
            *("friction", "water_density", "body_density", "drag", "added_mass", "damping"),
            *("safety_factor", "water_depth", "diameter", "wave_height", "wave_period"),
            *("current_speed", "wind_speed", "weight_in_water"),
        ),
        quoted=True,
    ),
]
"""Names of plausible ranges that a file may set aside (`catopt.model.plausible_ranges`)."""


_ROUNDING = 1e-12
"""Of a bound: what a few multiplications leave of a number that is the bound itself."""


def exceeds(value: float, most: float) -> bool:
    """Whether a number is above the most that it may be by more than rounding, or no number.

    Examples
    --------
    >>> exceeds(3.0 * 0.1, 0.3), 3.0 * 0.1 > 0.3
    (False, True)
    """
    if isinstance(value, int) and isinstance(most, int):
        return value > most  # counts and seeds are not rounded
    return not value <= most + _ROUNDING * abs(most)


def out_of_range(
    value: float, unit: str, above: float | None, at_least: float | None, at_most: float | None
) -> str:
    """Say which bound a number breaks; empty for none."""
    of = f" {unit}" if unit else ""
    if above is not None and not value > above:
        return Message("refused.above", bound=f"{above:g}{of}")
    if at_least is not None and exceeds(at_least, value):
        return Message("refused.or_more", bound=f"{at_least:g}{of}")
    if at_most is not None and exceeds(value, at_most):
        return Message("refused.or_less", bound=f"{at_most:g}{of}")
    return ""


def _with_example(said: str, own: str, example: str) -> str:
    """Say what is required with another example than that of the dimension."""
    if not example or not isinstance(said, Message):
        return said
    values = {
        key: example if each == own else _with_example(each, own, example)
        for key, each in said.values.items()
        if isinstance(each, str)
    }
    return Message(said.key, **{**said.values, **values})


class Annotation(NamedTuple):
    """What an annotation says: its kind, whether it is an array and of what size, its classes."""

    kind: Kind | None
    is_array: bool
    size: Size | None
    classes: tuple[type, ...]


_PLAIN: Mapping[object, Kind] = MappingProxyType({str: Text(), bool: Flag()})


_KNOWN_KINDS: dict[type, Mapping[str, Annotation]] = {}


def annotated(of: type) -> Mapping[str, Annotation]:
    """Read the annotations of a class, by attribute; once."""
    if of not in _KNOWN_KINDS:
        hints = get_type_hints(of, include_extras=True).items()
        own = {key: _read(hint) for key, hint in hints if ClassVar not in (hint, get_origin(hint))}
        _KNOWN_KINDS[of] = MappingProxyType(own)
    return _KNOWN_KINDS[of]


def _read(hint: Any) -> Annotation:
    parts = list(_parts(hint))
    kinds = [part for part in parts if isinstance(part, Kind)]
    kinds += [_PLAIN[part] for part in parts if isinstance(part, type) and part in _PLAIN]
    return Annotation(
        next(iter(kinds), None),
        list in parts or tuple in parts,
        next((part for part in parts if isinstance(part, Size)), None),
        tuple(part for part in parts if isinstance(part, type)),
    )


def _parts(hint: Any) -> Iterator[Any]:
    """Take an annotation apart: ``Annotated[float, k] | None`` gives ``float``, ``k`` and None.

    The words of a Literal are one kind; the empty word stands for none.
    """
    if get_origin(hint) is Literal:
        yield OneOf(tuple(word for word in get_args(hint) if word))
        return
    yield get_origin(hint) or hint
    for inner in get_args(hint):
        yield from _parts(inner)
