"""What is known before a sizing: every input that was given or is taken, in SI."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Final, Literal, Protocol, TypeVar

from catopt.casefile.reading import Moored
from catopt.catalogue.family import nearest
from catopt.errors import InputError, Problem
from catopt.loads.buoy import BreakingSeaError, buoys
from catopt.loads.ship import DIMENSIONS_SOURCE, SHORTEST, ship_dimensions
from catopt.model import TitleBlock
from catopt.records import Record
from catopt.sizing.inputs import SINKER, Input, inputs_of
from catopt.sizing.kinds import default_of, kind_of, usual
from catopt.units import UNITS, Dimension, as_written, to_si
from catopt.words import Cited, Measure, Message, Several, term, typed_name

Made = TypeVar("Made")


class Spelling(Protocol):
    """How a caller writes the name of an input."""

    def __call__(self, name: str, index: int | None = None) -> str:
        """Write it; `index` counts several values from 0."""


def as_keyword(name: str, index: int | None = None) -> str:
    """Write an input as a keyword in Python."""
    return name if index is None else f"{name}[{index}]"


class ErrorCollector:
    """Makes values out of inputs and keeps what is wrong with them until all have been tried.

    `spell` writes a name as the caller does, `source` is who is told, for the error; of inputs in
    `reported` a fault is known, and no more is said. `called` has further names by what the model
    calls them: a key, or ``source.key``. `written`: inputs as they were given; text with a unit is
    shown so, not in SI.
    """

    def __init__(
        self,
        inputs: Mapping[str, Input],
        spell: Spelling = as_keyword,
        source: str = "",
        reported: Collection[str] = (),
        called: Mapping[str, str] | None = None,
        written: Mapping[str, object] | None = None,
    ) -> None:
        self._written = written or {}
        self.spell, self.source = spell, source
        self._reported = set(reported)
        self._names = {name: name for name in inputs}
        self._names |= {each: row.name for row in inputs.values() for each in row.called}
        self._names |= called or {}
        self._problems: list[Problem] = []

    def is_reported(self, name: str) -> bool:
        """Say whether something is wrong with an input."""
        return name in self._reported

    def no_more_of(self, name: str) -> None:
        """Keep no further problem of an input."""
        self._reported.add(name)

    def add(self, name: str, found: str, allowed: str, index: int | None = None) -> None:
        """Keep a problem of an input."""
        if name not in self._reported:
            self._problems.append(Problem(self.spell(name, index), found, allowed))

    def read(
        self, name: str, reader: Callable[[Any], Made], value: object, index: int | None = None
    ) -> Made | None:
        """Read a value of an input; None, with what is wrong kept, when it cannot be read."""
        try:
            return reader(value)
        except InputError as error:
            for each in error.problems:
                self.add(name, each.found, each.allowed, index)
        return None

    def make(self, maker: Callable[..., Made], *parts: Any) -> Made | None:
        """Make a value out of others; None when it cannot be made, or one of them was not.

        `maker` may raise InputError, which is kept; None among `parts` means that it was not made.
        """
        if any(part is None for part in parts):
            return None
        try:
            return maker(*parts)
        except InputError as error:
            for each in error.problems:
                key, index = each.key, None
                if one_of_several := re.fullmatch(r"(.+)\[(\d+)\]", key):
                    key, index = one_of_several[1], int(one_of_several[2])
                name = self._names.get(f"{error.source}.{key}", self._names.get(key))
                if name is None:
                    self._problems.append(each)
                else:
                    self.add(name, self._as_given(name, index, each.found), each.allowed, index)
        return None

    def _as_given(self, name: str, index: int | None, found: str) -> str:
        """Return text with a unit as the caller wrote it where a bare number was found."""
        value = self._written.get(name)
        if index is not None and isinstance(value, (list, tuple)) and index < len(value):
            value = value[index]
        is_bare = re.fullmatch(r"-?[\d.]+(e[-+]?\d+)?", found) is not None
        return as_written(value) if isinstance(value, str) and is_bare else found

    def made(self, maker: Callable[..., Made], *parts: Any) -> Made:
        """Make a value as `make` does; raise with all that was kept where anything is wrong.

        What a method refuses names the way out as it is spelt.
        """
        try:
            found = self.make(maker, *parts)
        except BreakingSeaError as error:
            raise error.spelt(self.spell("load_method")) from None
        self.raise_if_any()
        assert found is not None
        return found

    def raise_if_any(self) -> None:
        """Raise InputError with all that was kept, each once; with nothing, if all is told."""
        if self._problems or self._reported:
            raise InputError(tuple(dict.fromkeys(self._problems)), self.source)


Origin = Literal["given", "taken", "estimated"]

_FIELD = {"LENGTH": "m", "MASS": "t", "AREA": "m^2", "DENSITY": "kg/m^3", "NUMBER": ""}
"""Units of what has no example with one."""


@dataclass(frozen=True)
class ReadInput(Record):
    """An input as it was read, for the beginning of the answer."""

    DOCUMENT = "keyword=name value unit origin"

    of: Input  # its row in the table
    value: float | str | bool | tuple[float | str, ...]
    """In SI; an array of several."""
    origin: Origin
    """By the user, by default, or estimated from what was given."""
    source: str = ""  # of an estimate
    written_in: str = field(default="", compare=False)  # unit in which it was given; or as usual

    @property
    def keyword(self) -> str:
        """Keyword in Python; the option is the same with dashes."""
        return self.of.name

    @property
    def name(self) -> Message:
        """What it is."""
        return Message(f"inputs.{self.of.name}")

    @property
    def unit(self) -> str:
        """SI; empty where there is none."""
        return Dimension[self.of.takes].si_unit if self.of.is_measure else ""

    @property
    def said(self) -> str:
        """Its value in the unit that one writes it in."""
        values = self.value if isinstance(self.value, tuple) else (self.value,)
        return Several((self._said(each) for each in values), ", ")

    @property
    def from_where(self) -> Message:
        """Whether it was given, taken or estimated, and by what."""
        return Message(f"sizing.is_{self.origin}", source=self.source)

    def _said(self, value: Any) -> str:
        if self.of.takes == "FORCE":
            return Message("sizing.about", value=Measure("horizontal_force", value))
        if not self.of.is_measure:
            return term(str(value).lower() if isinstance(value, bool) else str(value))
        unit = self.written_in or self._unit
        if not unit:
            return f"{value:.6g}"
        dimension = Dimension[self.of.takes]
        factor = UNITS[dimension].get(unit) or to_si(f"1 {unit}", dimension)
        if self.of.takes == "TIME" and value < factor:
            unit, factor = "s", 1.0
        return Message("sizing.in_unit", value=value / factor, unit=term(unit))

    @property
    def _unit(self) -> str:
        """Take that of the example, or of the default that was taken."""
        texts = (self.of.one_example, self.of.default)
        for text in reversed(texts) if self.origin == "taken" else texts:
            if isinstance(text, str) and " " in text:
                return text.partition(" ")[2]
        return _FIELD.get(self.of.takes, "")


@dataclass(frozen=True)
class ResolvedInputs:
    """Inputs of a sizing that have been read."""

    moored: Moored
    values: Mapping[str, Any]  # by name, in SI: given without fault, or taken in its place
    given: frozenset[str]  # with faults or without
    errors: ErrorCollector  # keeps what is wrong
    estimated: frozenset[str] = frozenset()  # from others that were given
    written_in: Mapping[str, str] = field(default_factory=dict)  # units of those with one
    title_block: TitleBlock | None = None  # of the file

    def __getitem__(self, name: str) -> Any:
        """Return a value; None where it is not known."""
        return self.values.get(name)

    def require(self, *names: str) -> None:
        """Tell which of some inputs are missing, each with an example."""
        inputs = inputs_of(self.moored)
        for name in names:
            known_by = inputs[name].estimated_from
            if name in self.given or name in self.values or known_by in self.given:
                continue  # what it is estimated from may be wrong, which is told there
            example = as_written(inputs[name].example)
            allowed = Message("refused.missing_input", example=example)
            if known_by:
                other = self.errors.spell(known_by)
                allowed = Message("refused.or_estimated", wanted=allowed, other=other)
            self.errors.add(name, "", allowed)

    @property
    def made_for(self) -> tuple[float, float]:
        """Least and largest size of chain that the named buoy is made for, m; any if not known."""
        shape = next((each for each in buoys() if each.name == self["buoy"]), None)
        least, most = (None, None) if shape is None else (shape.chain_min, shape.chain_max)
        return least or 0.0, most or math.inf

    @property
    def read(self) -> tuple[ReadInput, ...]:
        """Every input that is known and counts, in the order of the table."""
        inputs = inputs_of(self.moored, held_by=_held_by(self.moored, self.values))
        return tuple(
            ReadInput(each, self.values[name], *self._origin(name), self.written_in.get(name, ""))
            for name, each in inputs.items()
            if name in self.values and each.only_with in {"", *self.given}
        )

    def _origin(self, name: str) -> tuple[Origin, str]:
        if name in self.estimated:
            return "estimated", Cited(DIMENSIONS_SOURCE)
        return ("given" if name in self.given else "taken"), ""


FOUND_BY: Final = MappingProxyType({"wind": "place", "hs": "fetch"})
"""Weather that has no default where another input is given, by which it is found."""


def is_needless(each: Input, given: Collection[str]) -> bool:
    """Say whether others that are given stand in the place of an input."""
    follows = each.name == "hs" and "hmax" in given
    return follows or any(other in given for other in (*each.not_with, each.estimated_from))


def input_values(
    moored: Moored,
    given: Mapping[str, object],
    spell: Spelling = as_keyword,
    source: str = "",
    *,
    reported: Collection[str] = (),
    defaults: Mapping[str, object] | None = None,
    called: Mapping[str, str] | None = None,
) -> ResolvedInputs:
    """Read what is given, and take what is not.

    `given`: by name: numbers in SI, or texts with units; None: left out. `spell`, `source`,
    `reported`, `called`: as for `ErrorCollector`. `defaults`: what is taken of what is left out, in
    place of the defaults of the table.
    """
    given = {name: value for name, value in given.items() if value is not None}
    inputs = inputs_of(moored, held_by=_held_by(moored, given))
    errors = ErrorCollector(inputs, spell, source, reported, called, given)
    values: dict[str, Any] = {}
    for name, value in given.items():
        if name not in inputs:
            _refuse(errors, moored, name, value)
        elif not errors.is_reported(name):
            read = _read(errors, inputs[name], value)
            values |= {} if read is None else {name: read}
    _contradictions(errors, inputs, given)
    estimated = _estimated(errors, given, values) if moored == "tanker" else {}
    values |= estimated
    for name, each in inputs.items():
        is_found = FOUND_BY.get(name) in given
        if name in values or is_found or is_needless(each, values):
            continue
        if defaults is None and each.default:
            values[name] = default_of(each)
        elif defaults and defaults.get(name):
            values[name] = kind_of(each).read(defaults[name])
    units = {name: unit for name in given.keys() & values.keys() if (unit := _unit_of(given[name]))}
    return ResolvedInputs(moored, values, frozenset(given), errors, frozenset(estimated), units)


def _unit_of(written: object) -> str:
    """Return the unit of a text, or of the first of several; empty where it has none."""
    if isinstance(written, list | tuple):
        written = written[0] if written else ""
    found = re.fullmatch(r"\s*[-+]?\d[\d.,]*(?:e[-+]?\d+)?\s*([^\d\s].*?)\s*", str(written))
    return found[1] if found and isinstance(written, str) else ""


def _estimated(
    errors: ErrorCollector, given: Mapping[str, object], values: Mapping[str, Any]
) -> dict[str, float]:
    """Estimate the ship's dimensions from its deadweight, as far as they are not given."""
    missing = {"length", "breadth", "draught"} - given.keys()
    if "dwt" not in values or not missing:
        return {}
    if "draught" in missing:
        missing |= {"moulded_depth"} - given.keys()
    kind = values.get("ship", usual("ship", "tanker"))
    found = errors.make(ship_dimensions, kind, values["dwt"])
    return {} if found is None else {name: getattr(found, name) for name in missing}


def _held_by(moored: Moored, given: Mapping[str, object]) -> str:
    """Name what holds the line, which says what else counts."""
    if moored == "buoy":
        return SINKER
    return SINKER if given.get("anchor") == SINKER else inputs_of(moored)["anchor"].default


def _read(errors: ErrorCollector, each: Input, value: object) -> Any:
    """Read the value of an input, or several; None, and no more told, when one is wrong."""
    given = os.fspath(value) if isinstance(value, os.PathLike) else value
    many = given if each.several and isinstance(given, list | tuple) else [given]
    if each.takes in ("NAME", "WHICH"):
        many = [typed_name(one) if isinstance(one, str) else one for one in many]
    read = kind_of(each).read
    found = [
        errors.read(each.name, read, one, index if each.several else None)
        for index, one in enumerate(many)
    ]
    if None in found:
        errors.no_more_of(each.name)
        return None
    return tuple(found) if each.several else found[0]


def _refuse(errors: ErrorCollector, moored: Moored, name: str, value: object) -> None:
    """Keep that something is given which nothing is made of."""
    inputs = inputs_of(moored)
    if name in inputs:
        anchor = f'{errors.spell("anchor")} "{SINKER}"'
        errors.add(name, as_written(value), Message("refused.of_a_sinker", anchor=anchor))
        return
    rows = inputs.values()
    aliases = {alias: each.name for each in rows for alias in (*each.also, each.path[-1])}
    meant = aliases.get(name) or nearest(name, tuple(inputs))
    hint = Message("refused.allowed_here", keys=", ".join(inputs))
    if meant:
        hint = Message("refused.did_you_mean", near=meant)
        errors.no_more_of(meant)
    errors.add(name, Message("refused.unknown_keyword"), hint)


def _contradictions(
    errors: ErrorCollector, inputs: Mapping[str, Input], given: Mapping[str, object]
) -> None:
    """Keep what would be left out of account, beside another input or without one."""
    for name, value in given.items():
        each = inputs.get(name)
        if each is None:
            continue
        if each.only_with and each.only_with not in given:
            allowed = Message("refused.or_give_with", other=errors.spell(each.only_with))
            errors.add(name, as_written(value), allowed)
        for other in each.not_with if each.why else ():
            if other in given and not is_needless(inputs[other], given):
                allowed = Message(f"refused.{each.why}", other=errors.spell(other))
                errors.add(name, as_written(value), allowed)


def estimated_dimensions(inputs: Iterable[ReadInput]) -> tuple[Message, ...]:
    """Say which dimensions an answer rests on that were estimated."""
    found = [each for each in inputs if each.origin == "estimated"]
    if not found:
        return ()
    names = Several((each.name for each in found), ", ")
    return (Message("sizing.estimated_dimensions", names=names, source=found[0].source),)


def small_craft(inputs: Iterable[ReadInput]) -> tuple[Message, ...]:
    """Say that the ship is shorter than those from which her areas above water are estimated."""
    of = {each.keyword: each.value for each in inputs}
    length = of.get("length")
    is_known = {"frontal_area", "lateral_area"} <= set(of) or of.get("ship") == "barge"
    if is_known or not isinstance(length, float) or length >= SHORTEST:
        return ()
    return (Message("sizing.small_craft", length=length, shortest=SHORTEST),)
