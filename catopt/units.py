"""Reads a number with its unit into SI: ``"9.5 m"``, ``"0.343 tf"``, ``"95 mm"``.

Bare numbers are SI. The units this field writes stand in one small table; any other unit, such as
"3 ft", "50 knots" or "12 kip/ft", is words with ``*``, ``/`` and whole powers between them. Each
word is worth so much in SI, and has powers of metre, kilogram, second, radian and US dollar. Values
are the definitions: the international foot and pound (1959), the nautical mile of 1852 m, standard
gravity.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import date, time
from functools import cache
from numbers import Integral, Real
from typing import Any, Final

from catopt.constants import STANDARD_GRAVITY, YEAR
from catopt.dimensions import UNITS as UNITS
from catopt.dimensions import Dimension as Dimension
from catopt.errors import InputError, refused
from catopt.words import Message

_NUMERAL = re.compile(r"([+-]?)(\d[\d.,]*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_THOUSANDS = {
    mark: re.compile(rf"[1-9]\d{{0,2}}(?:{re.escape(mark)}\d{{3}})+", re.ASCII) for mark in ".,"
}


def readings(number: str) -> tuple[str, ...]:
    """List the ways in which a number may be read, each with a decimal point and no groups.

    A comma is a decimal one where no thousands can be meant: ``31,3`` and ``0,343``. One mark with
    three digits behind it parts thousands in one country and decimals in the next: ``50,000`` has
    two readings. So has ``50.000``, whose last zero no decimal needs; ``12.345`` is read as the
    decimal that it is in every file of catopt. Where both marks are there, the last is the decimal
    one. Of what is no number there is none; of two readings the decimal one is first.

    Examples
    --------
    >>> readings("31,3"), readings("50.000"), readings("1.234,5"), readings("1,2,3")
    (('31.3',), ('50.000', '50000'), ('1234.5',), ())
    """
    parts = _NUMERAL.fullmatch(number)
    if parts is None:
        return ()
    sign, digits, power = parts[1], parts[2], parts[3] or ""
    return tuple(f"{sign}{each}{power}" for each in _of_digits(digits, has_power=bool(power)))


def _of_digits(digits: str, *, has_power: bool) -> tuple[str, ...]:
    marks = [each for each in digits if each in ".,"]
    if not marks:
        return (digits,)
    last = marks[-1]
    whole, _, rest = digits.rpartition(last)
    if len(set(marks)) > 1:
        group = "." if last == "," else ","
        is_number = last not in whole and rest and _THOUSANDS[group].fullmatch(whole)
        return (f"{whole.replace(group, '')}.{rest}",) if is_number else ()
    is_grouped = bool(_THOUSANDS[last].fullmatch(digits)) and not has_power
    if len(marks) > 1:
        return (digits.replace(last, ""),) if is_grouped else ()
    if last == "," and not rest:
        return ()
    decimal = f"{whole}.{rest}"
    has_two = is_grouped and (last == "," or rest.endswith("0"))
    return (decimal, whole + rest) if has_two else (decimal,)


_LIKE: Final[Mapping[str, tuple[str, ...]]] = {
    "m": ("ft", "fathom"),
    "mm": ("cm", "in"),
    "km": ("m", "nmi"),
    "kN": ("tf", "kgf", "N", "kip"),
    "MN": ("kN", "tf"),
    "N/m": ("kN/m", "kgf/m"),
    "t": ("kg", "lb"),
    "kg/m": ("lb/ft",),
    "kg/m^3": ("t/m^3",),
    "m/s": ("knots", "km/h"),
    "mm/year": ("in/year",),
    "s": ("min",),
    "min": ("s", "h"),
    "h": ("min",),
    "deg": ("rad",),
    "m^2": ("ft^2",),
}


def units_like(unit: str) -> tuple[str, ...]:
    """List a unit with those that are written in its place, of quantities of the same size.

    A diameter in mm is written in inches, not in fathoms; wear not in knots.

    Examples
    --------
    >>> units_like("mm"), units_like("years")
    (('mm', 'cm', 'in'), ('years',))
    """
    return (unit, *_LIKE.get(unit, ()))


def bare_number(text: str) -> float | str:
    """Return the number of a text that is one without a unit; else, or if it has two, the text.

    Examples
    --------
    >>> bare_number("22"), bare_number("31,3"), bare_number("50.000"), bare_number("5 kN")
    (22, 31.3, '50.000', '5 kN')
    """
    found = readings(text.strip())
    if len(found) != 1:
        return text
    return int(found[0]) if found[0].lstrip("+-").isdecimal() else float(found[0])


Powers = tuple[int, int, int, int, int]
"""Of metre, kilogram, second, radian and US dollar."""

_METRE, _KILOGRAM, _SECOND = (1, 0, 0, 0, 0), (0, 1, 0, 0, 0), (0, 0, 1, 0, 0)
_SPEED, _NEWTON, _PASCAL = (1, 0, -1, 0, 0), (1, 1, -2, 0, 0), (-1, 1, -2, 0, 0)
_POUND, _FOOT, _NAUTICAL_MILE = 0.45359237, 0.3048, 1852.0
_POUND_FORCE = _POUND * STANDARD_GRAVITY

_WORDS: Final[tuple[tuple[str, float, Powers], ...]] = (
    ("m metre metres meter meters mét", 1.0, _METRE),
    ("km kilometre kilometres kilometer kilometers kilômét kilomét", 1e3, _METRE),
    ("dm", 0.1, _METRE),
    ("cm centimetre centimetres centimeter centimeters xentimét", 1e-2, _METRE),
    ("mm millimetre millimetres millimeter millimeters milimét", 1e-3, _METRE),
    ("um µm μm", 1e-6, _METRE),
    ("ft foot feet", _FOOT, _METRE),
    ("in inch inches", _FOOT / 12.0, _METRE),
    ("yd yard yards", 3.0 * _FOOT, _METRE),
    ("fathom fathoms ftm", 6.0 * _FOOT, _METRE),
    ("shot shots", 27.5, _METRE),
    ("shackle shackles", 90.0 * _FOOT, _METRE),
    ("mi mile miles", 5280.0 * _FOOT, _METRE),
    ("nmi NM nautical_mile nautical_miles hải_lý", _NAUTICAL_MILE, _METRE),
    ("kg kilogram kilograms kilogramme kilôgam kilogam", 1.0, _KILOGRAM),
    ("g gram grams", 1e-3, _KILOGRAM),
    ("t tonne tonnes metric_ton metric_tons metric_tonne metric_tonnes tấn", 1e3, _KILOGRAM),
    ("lb lbs pound pounds", _POUND, _KILOGRAM),
    ("s sec second seconds giây", 1.0, _SECOND),
    ("ms", 1e-3, _SECOND),
    ("min minute minutes phút", 60.0, _SECOND),
    ("h hr hrs hour hours giờ", 3600.0, _SECOND),
    ("d day days ngày", 86400.0, _SECOND),
    ("year years yr yrs năm", YEAR, _SECOND),
    ("kn kt kts knot knots nút", _NAUTICAL_MILE / 3600.0, _SPEED),
    ("mph", 5280.0 * _FOOT / 3600.0, _SPEED),
    ("kph kmh", 1.0 / 3.6, _SPEED),
    ("fps", _FOOT, _SPEED),
    ("rad radian radians", 1.0, (0, 0, 0, 1, 0)),
    ("deg degree degrees độ", math.pi / 180.0, (0, 0, 0, 1, 0)),
    ("gon grad", math.pi / 200.0, (0, 0, 0, 1, 0)),
    ("N newton newtons niutơn", 1.0, _NEWTON),
    ("daN decanewton decanewtons", 10.0, _NEWTON),
    ("kN kilonewton kilonewtons kilôniutơn", 1e3, _NEWTON),
    ("MN meganewton meganewtons", 1e6, _NEWTON),
    ("GN giganewton giganewtons", 1e9, _NEWTON),
    ("kgf kp kilopond kiloponds", STANDARD_GRAVITY, _NEWTON),
    ("tf tấn_lực tonne_force tonnes_force", 1000.0 * STANDARD_GRAVITY, _NEWTON),
    ("lbf", _POUND_FORCE, _NEWTON),
    ("kip kips", 1e3 * _POUND_FORCE, _NEWTON),
    ("Pa pascal", 1.0, _PASCAL),
    ("hPa", 1e2, _PASCAL),
    ("kPa", 1e3, _PASCAL),
    ("MPa", 1e6, _PASCAL),
    ("GPa", 1e9, _PASCAL),
    ("mbar", 1e2, _PASCAL),
    ("bar bars", 1e5, _PASCAL),
    ("psi", _POUND_FORCE / (_FOOT / 12.0) ** 2, _PASCAL),
    ("ksi", 1e3 * _POUND_FORCE / (_FOOT / 12.0) ** 2, _PASCAL),
    ("sqm", 1.0, (2, 0, 0, 0, 0)),
    ("sqft", _FOOT**2, (2, 0, 0, 0, 0)),
    ("l L litre litres liter liters lít", 1e-3, (3, 0, 0, 0, 0)),
    ("J", 1.0, (2, 1, -2, 0, 0)),
    ("USD", 1.0, (0, 0, 0, 0, 1)),
)
_TOGETHER: Final = (
    *("nautical mile", "nautical miles", "metric ton", "metric tons", "metric tonne"),
    *("metric tonnes", "tonne force", "tonnes force", "hải lý", "tấn lực"),
)
"""Units of two words, which are no product."""
_PART: Final = re.compile(r"([*/ ])?([^\W\d]\w*?)(?:\^(-?[1-9]))?(?=[*/ ]|$)")


@cache
def units_in_si() -> Mapping[str, tuple[float, Powers]]:
    """List every word with its worth in SI and its powers."""
    return {word: (si, powers) for words, si, powers in _WORDS for word in words.split()}


def worth(unit: str) -> tuple[float, Powers] | None:
    """Find what a unit is worth in SI, and its powers; None for what is no unit.

    Capitals count in what is as short as a symbol.

    Examples
    --------
    >>> value, powers = worth("kip/ft")
    >>> round(value, 4), powers
    (14593.9029, (0, 1, -2, 0, 0))
    >>> worth("Hải lý/giờ")
    (0.5144444444444445, (1, 0, -1, 0, 0))
    """
    text = unicodedata.normalize("NFC", unit)
    for words in _TOGETHER:
        text = re.sub(rf"(?i)\b{words}\b", words.replace(" ", "_"), text)
    if text != "".join(found[0] for found in _PART.finditer(text)):
        return None
    si, powers = 1.0, [0] * 5
    for between, word, power in _PART.findall(text):
        is_long = len(word) > 3 or not word.isascii()
        found = units_in_si().get(word) or (units_in_si().get(word.casefold()) if is_long else None)
        if found is None:
            return None
        times = int(power or 1) * (-1 if between == "/" else 1)
        si *= found[0] ** times
        powers = [a + times * b for a, b in zip(powers, found[1], strict=True)]
    a, b, c, d, e = powers
    return si, (a, b, c, d, e)


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

_LONGEST_UNIT, _LONGEST = 24, 100
"""Characters of a unit, and of a number with its unit."""
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


def is_quantity(value: object) -> bool:
    """Whether a value has a unit of its own, as those of pint, astropy and unyt have."""
    kind = type(value)
    return hasattr(kind, "to_value") or (hasattr(kind, "to") and hasattr(kind, "magnitude"))


def of_quantity(value: Any, dimension: Dimension, key: str = "value") -> Any:
    """Return what a quantity of pint, astropy or unyt is in SI, a number or an array.

    Mass per length where weight per length is required is taken times g0, as in text. InputError
    for one of another dimension.
    """
    ways = [(dimension, 1.0)]
    if dimension is Dimension.FORCE_PER_LENGTH:
        ways.append((Dimension.MASS_PER_LENGTH, STANDARD_GRAVITY))
    for each, times in ways:
        with suppress(Exception):  # of a library that is not known here
            if hasattr(value, "to_value"):
                return value.to_value(each.si_unit) * times
            return value.to(each.si_unit).magnitude * times
    unit = getattr(value, "units", getattr(value, "unit", ""))
    raise refused(key, Message("refused.a_quantity_in", unit=f"{unit}"[:40]), wanted(dimension))


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
    and fifty thousand in another is an error (`catopt.units`). A mass per length given where a
    weight per length is required is taken times g0. A mass given where a force is required is an
    error, because nobody can tell which of the two was meant.

    `key` says where the value is, for the message; `bare` is the unit of a bare number, one of the
    table, that of SI when left out; `most` the largest plausible value, where it is not the
    dimension's. What is returned is in SI, finite, and plausible. InputError
    when it is not such a value: one problem, which names what was found and gives an example.
    """
    value = plain(of_quantity(value, dimension, key) if is_quantity(value) else value)
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
        values = {"unit": reading.bare, "example": dimension.example}
        fault = Message("refused.and_bare", fault=fault, **values)
    if fault:
        raise reading.error(fault)
    return si


def noun_of(dimension: Dimension) -> Message:
    """Name what is required: a length."""
    return Message(f"refused.{dimension.name}")


def wanted(dimension: Dimension, example: str = "") -> Message:
    """Say what is required, with an example: that of the dimension where none is given."""
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
        return refused(self.key, found, allowed)

    def and_wanted(self, key: str) -> Message:
        """Say what is wrong, and what is required."""
        return Message(f"refused.{key}", wanted=self.wanted)

    def split(self, text: str) -> tuple[str, str]:
        """Part a text into number and unit, the unit in the spelling of the table."""
        plain = text.translate(_SPELLINGS).strip()
        if len(plain) > _LONGEST:
            raise self.error(self.wanted)
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
        digits, si_unit = self._one_of(found, unit), self.dimension.si_unit
        if unit:
            return digits, unit
        if not si_unit:
            noun = noun_of(self.dimension)
            raise self.error(Message("refused.no_quotes", noun=noun, digits=digits))
        raise self.error(Message("refused.unit_missing", digits=digits, unit=si_unit))

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
        kind, factor = _by_table(unit)
        if kind is None:
            kind, factor = _by_words(unit)
        if kind is self.dimension:
            return factor
        if kind is Dimension.MASS_PER_LENGTH and self.dimension is Dimension.FORCE_PER_LENGTH:
            return factor * STANDARD_GRAVITY
        # Units that differ by capitals alone; those of the field come first.
        listed = dict.fromkeys((*(u for units in UNITS.values() for u in units), *units_in_si()))
        near = (each for each in listed if each.casefold() == unit.casefold() and each != unit)
        meant = [
            Message("refused.capitals", unit=each)
            for each in near
            if self.dimension in (_by_table(each)[0], _by_words(each)[0])
        ]
        if kind is None:
            raise self.error(meant[0] if meant else self.and_wanted("no_unit"))
        instead, noun = self.wanted, noun_of(self.dimension)
        if meant:
            instead = Message("refused.noun_and", noun=noun, instead=meant[0])
        elif self.dimension is Dimension.FORCE and unit in _AS_FORCE:
            weight = float(digits) * factor * STANDARD_GRAVITY / 1e3
            one, other = f'"{digits} {_AS_FORCE[unit]}"', f'"{weight:.4g} kN"'
            instead = Message("refused.as_force", noun=noun, one=one, other=other)
        raise self.error(instead, kind)


def _spelt(unit: str) -> str:
    """Bring ``m³``, ``m**3``, ``m3`` and ``kg / m^3`` to the one spelling ``kg/m^3``."""
    unit = re.sub(r"[⁻¹²³⁴]+", lambda found: "^" + found[0].translate(_SUPERSCRIPTS), unit)
    unit = re.sub(r"\s*(\^|\*\*|[*/])\s*", r"\1", unit.strip()).replace("**", "^")
    unit = re.sub(r"(?<=[^\W\d_])([23])(?=$|[*/ ])", r"^\1", unit)
    return re.sub(r"\s+", " ", unit)


def _by_table(unit: str) -> tuple[Dimension | None, float]:
    """Dimension and SI factor of a unit; None when the table lacks it."""
    for dimension, units in UNITS.items():
        if unit in units:
            return dimension, units[unit]
    return None, math.nan


def _by_words(unit: str) -> tuple[Dimension | None, float]:
    """Dimension and SI factor of a unit of words; None for no unit and for one of no use here."""
    found = worth(unit) if len(unit) <= _LONGEST_UNIT else None
    if found is None:
        return None, math.nan
    return _of_powers().get(found[1]), found[0]


@cache
def _of_powers() -> Mapping[Powers, Dimension]:
    """List the dimensions by their powers of the basic units."""
    made = ((worth(each.si_unit), each) for each in Dimension if each.si_unit)
    return {found[1]: each for found, each in made if found is not None}


def lasting(seconds: float) -> str:
    """Write a time in whole hours or minutes, or else in seconds: ``"3 h"``."""
    for size, unit in ((3600.0, "h"), (60.0, "min")):
        if seconds >= size and round(seconds / size, 9).is_integer():
            return f"{seconds / size:g} {unit}"
    return f"{seconds:g} s"
