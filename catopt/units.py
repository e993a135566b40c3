"""Reads a number with its unit into SI: ``"9.5 m"``, ``"0.343 tf"``, ``"95 mm"``.

Bare numbers are SI. The units this field writes stand in one small table; any other unit, such as
"3 ft", "50 knots" or "12 kip/ft", is made of the words in `catopt.unit_words`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import date, time
from functools import cache
from numbers import Integral, Real
from typing import TYPE_CHECKING

from catopt.constants import STANDARD_GRAVITY
from catopt.dimensions import UNITS, Dimension
from catopt.errors import InputError, Problem
from catopt.numerals import readings
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.unit_words import Powers


__all__ = [
    "UNITS",
    "Dimension",
    "as_written",
    "implausible",
    "lasting",
    "noun_of",
    "plain",
    "to_si",
    "wanted",
]

_AMBIGUOUS = {
    **dict.fromkeys(("ton", "tons"), "ton"),
    **{each: each for each in ("tonf", "mt", "mN", "mPa", "Mm", "gf")},
}
"""Units that mean something else to some readers, or a million times less by one capital."""

_AS_FORCE = {
    **dict.fromkeys(("kg", "kilogram", "kilograms"), "kgf"),
    **dict.fromkeys(("t", "tonne", "tonnes", "tấn"), "tf"),
    **dict.fromkeys(("lb", "lbs", "pounds"), "lbf"),
}

_LONGEST_UNIT = 24
_NUMBER = re.compile(r"([+-]?(?:\d[\d.,]*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.ASCII | re.DOTALL)
_FRACTION = re.compile(r"(?:(\d{1,3})[ -])?(\d{1,3})/([1-9]\d{0,2})(\s*[^\W\d].*)", re.ASCII)
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity)\b.*", re.IGNORECASE | re.DOTALL)
_SPELLINGS = str.maketrans({"−": "-", "·": "*", "⋅": "*", "×": "*", "°": "deg"})
_SUPERSCRIPTS = str.maketrans("⁻¹²³⁴", "-1234")


def plain(value: object) -> object:
    """Return a single number, of numpy or of another kind, as int or float; else what stands."""
    if type(value).__module__ == "numpy" and getattr(value, "shape", None) == ():
        return value.item()  # type: ignore[attr-defined]
    if isinstance(value, (bool, int, float)) or not isinstance(value, Real):
        return value
    return int(value) if isinstance(value, Integral) else float(value)


def to_si(
    value: object,
    dimension: Dimension,
    key: str = "value",
    *,
    bare: str = "",
    most: float | None = None,
) -> float:
    """Read a number or a number with a unit.

    A number may be a common fraction, ``"5/8 in"``, ``"1 1/4 in"``. It may have a decimal comma
    where it can mean nothing else; one that is 50 in one country
    and fifty thousand in another is an error (`catopt.numerals`). A mass per length given where a
    weight per length is wanted is taken times g0. A mass given where a force is wanted is an error,
    because nobody can tell which of the two was meant.

    `key` says where the value is, for the message; `bare` is the unit of a bare number, one of the
    table, that of SI when left out; `most` the largest plausible value, where it is not the
    dimension's. What is returned is in SI, finite, and plausible. InputError
    when it is not such a value: one problem, which names what was found and gives an example.
    """
    value = plain(value)
    reading = _Reading(value, dimension, key, bare or dimension.si_unit)
    if isinstance(value, str):
        digits, unit = reading.split(value)
        si = float(digits) * reading.factor(unit, digits)
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        try:
            si = float(value) * (UNITS[dimension][bare] if bare else 1.0)
        except OverflowError:  # a whole number beyond double precision
            si = math.inf
    else:
        raise reading.error(reading.wanted)
    if not math.isfinite(si):
        raise reading.error(reading.and_wanted("finite"))
    fault = "" if most is not None and 0.0 < si <= most else implausible(dimension, si)
    if fault and reading.bare and not isinstance(value, str):
        fault = Message(
            "refused.and_bare", fault=fault, unit=reading.bare, example=dimension.example
        )
    if fault:
        raise reading.error(fault)
    return si


def noun_of(dimension: Dimension) -> Message:
    """Name what is wanted: a length."""
    return Message(f"refused.{dimension.name}")


def wanted(dimension: Dimension, example: str = "") -> Message:
    """Say what is wanted, with an example: that of the dimension where none is given."""
    return Message("refused.wanted", noun=noun_of(dimension), example=example or dimension.example)


def implausible(dimension: Dimension, si: float) -> str:
    """Say why no input has such a value, of whatever it is; empty where one may."""
    if si == 0.0 or dimension.smallest <= abs(si) <= dimension.largest:
        return ""
    is_large = abs(si) > dimension.largest
    bound = f"{dimension.largest if is_large else dimension.smallest:g} {dimension.si_unit}"
    key = "refused.more_than_any" if is_large else "refused.less_than_any"
    return Message(key, noun=noun_of(dimension), bound=bound.rstrip())


def as_written(value: object, longest: int = 40) -> str:
    """Show a value of a TOML file the way it writes it; texts are cut to `longest` characters."""
    match value:
        case bool():
            return "true" if value else "false"
        case str():
            text = value if len(value) <= longest else value[: longest - 3] + "..."
            return '"' + repr(text)[1:-1].replace("\\'", "'") + '"'
        case dict():
            return Message("refused.a_table")
        case list() | tuple():
            empty = Message("refused.an_empty_array")
            return Message("refused.an_array", count=len(value)) if value else empty
        case date() | time():
            return value.isoformat()
        case int() if abs(value) >= 10**longest:
            return Message("refused.many_digits", count=longest)
        case _:
            return repr(value)


@dataclass(frozen=True)
class _Reading:
    """One value on its way to SI, with all that its error messages need."""

    value: object
    dimension: Dimension
    key: str
    bare: str

    @property
    def wanted(self) -> str:
        return wanted(self.dimension)

    def error(self, allowed: str, kind: Dimension | None = None) -> InputError:
        found = as_written(self.value)
        if kind is not None:
            found = Message("refused.of_kind", value=found, kind=noun_of(kind))
        return InputError([Problem(self.key, found, allowed)])

    def and_wanted(self, key: str) -> Message:
        """Say what is wrong, and what is wanted."""
        return Message(f"refused.{key}", wanted=self.wanted)

    def split(self, text: str) -> tuple[str, str]:
        """Part a text into number and unit, the unit in the spelling of the table."""
        plain = text.translate(_SPELLINGS).strip()
        if fraction := _FRACTION.fullmatch(plain):
            whole, above, below, unit = fraction.groups()
            plain = f"{int(whole or 0) + int(above) / int(below)!r}{unit}"
        if _NOT_FINITE.fullmatch(plain):
            raise self.error(self.and_wanted("finite"))
        parts = _NUMBER.fullmatch(plain)
        if parts is None:
            raise self.error(self.wanted)
        unit, found = _spelt(parts[2]), readings(parts[1])
        if not found or (unit and unit[0] in "_.,0123456789"):
            raise self.error(self.and_wanted("not_in_one_piece"))
        digits = self._one_of(found, unit)
        if not unit:
            raise self.error(self._without_unit(digits))
        return digits, unit

    def _one_of(self, found: Sequence[str], unit: str) -> str:
        """Take the one reading of a number; of two, the one that is plausible."""
        first, *others = found
        said = unit or self.bare
        factor = _by_table(said)[1] if _by_table(said)[0] else 1.0
        if not others or implausible(self.dimension, float(others[0]) * factor):
            return first
        two = [f'"{float(each):.12g} {said}"' if said else f"{float(each):.12g}" for each in found]
        raise self.error(Message("refused.two_meanings", one=two[0], other=two[1]))

    def factor(self, unit: str, digits: str) -> float:
        """SI units in one `unit`, which must be of the wanted dimension."""
        if unit in UNITS[self.dimension]:
            return UNITS[self.dimension][unit]
        if unit in _AMBIGUOUS:
            raise self.error(Message(f"refused.unit_{_AMBIGUOUS[unit]}", unit=unit))
        near = _near(unit)
        kind, factor = _by_table(unit)
        if kind is None:
            kind, factor = _by_words(unit)
        if kind is self.dimension:
            return factor
        if kind is Dimension.MASS_PER_LENGTH and self.dimension is Dimension.FORCE_PER_LENGTH:
            return factor * STANDARD_GRAVITY
        meant = [
            Message("refused.capitals", unit=each)
            for each in near
            if each != unit and self.dimension in (_by_table(each)[0], _by_words(each)[0])
        ]
        if kind is None:
            raise self.error(meant[0] if meant else self.and_wanted("no_unit"))
        instead = self.wanted
        noun = noun_of(self.dimension)
        if meant:
            instead = Message("refused.noun_and", noun=noun, instead=meant[0])
        elif self.dimension is Dimension.FORCE and unit in _AS_FORCE:
            weight = float(digits) * factor * STANDARD_GRAVITY / 1e3
            one, other = f'"{digits} {_AS_FORCE[unit]}"', f'"{weight:.4g} kN"'
            instead = Message("refused.as_force", noun=noun, one=one, other=other)
        raise self.error(instead, kind)

    def _without_unit(self, digits: str) -> str:
        unit = self.dimension.si_unit
        if not unit:
            return Message("refused.no_quotes", noun=noun_of(self.dimension), digits=digits)
        return Message("refused.unit_missing", digits=digits, unit=unit)


def _spelt(unit: str) -> str:
    """Bring ``m³``, ``m**3``, ``m3`` and ``kg / m^3`` to the one spelling ``kg/m^3``."""
    unit = re.sub(r"[⁻¹²³⁴]+", lambda found: "^" + found[0].translate(_SUPERSCRIPTS), unit)
    unit = re.sub(r"\s*(\^|\*\*|[*/])\s*", r"\1", unit.strip()).replace("**", "^")
    unit = re.sub(r"(?<=[^\W\d_])([23])(?=$|[*/ ])", r"^\1", unit)
    return re.sub(r"\s+", " ", unit)


def _near(unit: str) -> list[str]:
    """List the units that differ by capitals alone; those of the field come first."""
    from catopt.unit_words import known

    listed = dict.fromkeys((*(u for units in UNITS.values() for u in units), *known()))
    return [each for each in listed if each.casefold() == unit.casefold()]


def _by_table(unit: str) -> tuple[Dimension | None, float]:
    """Dimension and SI factor of a unit; None when the table lacks it."""
    for dimension, units in UNITS.items():
        if unit in units:
            return dimension, units[unit]
    return None, math.nan


def _by_words(unit: str) -> tuple[Dimension | None, float]:
    """Dimension and SI factor of a unit of words; None for no unit and for one of no use here."""
    from catopt.unit_words import worth

    found = worth(unit) if len(unit) <= _LONGEST_UNIT else None
    if found is None:
        return None, math.nan
    return _of_powers().get(found[1]), found[0]


@cache
def _of_powers() -> Mapping[Powers, Dimension]:
    """List the dimensions by their powers of the basic units."""
    from catopt.unit_words import worth

    made = ((worth(each.si_unit), each) for each in Dimension if each.si_unit)
    return {found[1]: each for found, each in made if found is not None}


def lasting(seconds: float) -> str:
    """Write a time in whole hours or minutes, or else in seconds: ``"3 h"``."""
    for size, unit in ((3600.0, "h"), (60.0, "min")):
        if seconds >= size and round(seconds / size, 9).is_integer():
            return f"{seconds / size:g} {unit}"
    return f"{seconds:g} s"
