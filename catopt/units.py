"""Reads a number with its unit into SI: ``"9.5 m"``, ``"0.343 tf"``, ``"95 mm"``.

Bare numbers are SI. The units this field writes stand in one small table, so that an ordinary case
file is read without the units library; any other unit ("3 ft", "12 kip/ft") is looked up there.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import date, time
from enum import Enum
from functools import cache
from numbers import Integral, Real
from types import MappingProxyType
from typing import Any

from catopt.constants import STANDARD_GRAVITY, YEAR
from catopt.errors import InputError, Problem
from catopt.numerals import readings


class Dimension(Enum):
    """What a quantity is: its noun for messages, its SI unit, and a value as a case file has it.

    The smallest and the largest value (SI, without sign) between which every plausible one lies
    that is not 0 keep apart what a file can mean from slips of the unit or of a power of ten.
    """

    LENGTH = ("a length", "m", '"9.5 m"', 1e-9, 1e6)
    FORCE = ("a force", "N", '"50 kN"', 1e-9, 1e12)
    FORCE_PER_LENGTH = ("a weight per length", "N/m", '"9.5 kgf/m"', 1e-9, 1e7)
    MASS = ("a mass", "kg", '"5 t"', 1e-9, 1e10)
    MASS_PER_LENGTH = ("a mass per length", "kg/m", '"10.9 kg/m"', 1e-9, 1e6)
    DENSITY = ("a density", "kg/m^3", '"1025 kg/m^3"', 1e-3, 3e4)
    MOMENT = ("a moment", "N*m", '"5 MN*m"', 1e-9, 1e15)
    ANGLE = ("an angle", "rad", '"5 deg"', 1e-12, 100.0)
    SPEED = ("a speed", "m/s", '"1.2 m/s"', 1e-15, 200.0)
    ACCELERATION = ("an acceleration", "m/s^2", '"9.81 m/s^2"', 1e-9, 1e4)
    TIME = ("a time", "s", '"8 s"', 1e-6, 1e11)
    AREA = ("an area", "m^2", '"380 mm^2"', 1e-12, 1e7)
    VOLUME = ("a volume", "m^3", '"2.5 m^3"', 1e-12, 1e8)
    PRESSURE = ("a pressure or modulus", "Pa", '"56 GPa"', 1e-6, 1e15)
    DAMPING = ("a damping", "N*s/m", '"50 kN*s/m"', 1e-9, 1e12)
    DAMPING_PER_LENGTH = ("a damping per length", "N*s/m^2", '"10 kN*s/m^2"', 1e-9, 1e12)
    PRICE_PER_LENGTH = ("a price per length", "USD/m", '"120 USD/m"', 1e-6, 1e7)
    NUMBER = ("a pure number", "", "0.5", 1e-9, 1e6)

    def __init__(self, noun: str, si_unit: str, example: str, least: float, most: float) -> None:
        self.noun, self.si_unit, self.example = noun, si_unit, example
        self.smallest, self.largest = least, most

    def implausible(self, si: float) -> str:
        """Say why no input has such a value, of whatever it is; empty where one may."""
        if si == 0.0 or self.smallest <= abs(si) <= self.largest:
            return ""
        if abs(si) > self.largest:
            return f"not plausible: {self.noun} of more than {self._said(self.largest)}"
        return f"not plausible: {self.noun} of less than {self._said(self.smallest)}, and not 0"

    def _said(self, bound: float) -> str:
        return f"{bound:g} {self.si_unit}".rstrip()


_TONNE, _TONNE_FORCE = 1000.0, 1000.0 * STANDARD_GRAVITY
_KNOT = 1852.0 / 3600.0
_SHOT = 27.5

UNITS: Mapping[Dimension, Mapping[str, float]] = MappingProxyType(
    {
        Dimension.LENGTH: {
            "m": 1.0,
            "mm": 1e-3,
            "cm": 1e-2,
            "km": 1e3,
            "shot": _SHOT,
            "shots": _SHOT,
        },
        Dimension.FORCE: {
            "N": 1.0,
            "kN": 1e3,
            "MN": 1e6,
            "kgf": STANDARD_GRAVITY,
            "tf": _TONNE_FORCE,
        },
        Dimension.FORCE_PER_LENGTH: {
            "N/m": 1.0,
            "kN/m": 1e3,
            "kgf/m": STANDARD_GRAVITY,
            "tf/m": _TONNE_FORCE,
        },
        Dimension.MASS: {"kg": 1.0, "t": _TONNE},
        Dimension.MASS_PER_LENGTH: {"kg/m": 1.0, "t/m": _TONNE},
        Dimension.DENSITY: {"kg/m^3": 1.0, "t/m^3": _TONNE, "g/cm^3": 1e3},
        Dimension.MOMENT: {"N*m": 1.0, "kN*m": 1e3, "MN*m": 1e6, "tf*m": _TONNE_FORCE},
        Dimension.ANGLE: {"rad": 1.0, "deg": math.pi / 180.0},
        Dimension.SPEED: {
            "m/s": 1.0,
            "cm/s": 1e-2,
            "km/h": 1.0 / 3.6,
            "kn": _KNOT,
            "knot": _KNOT,
            "mm/year": 1e-3 / YEAR,
        },
        Dimension.ACCELERATION: {"m/s^2": 1.0},
        Dimension.TIME: {"s": 1.0, "min": 60.0, "h": 3600.0, "year": YEAR, "years": YEAR},
        Dimension.AREA: {"m^2": 1.0, "cm^2": 1e-4, "mm^2": 1e-6},
        Dimension.VOLUME: {"m^3": 1.0},
        Dimension.PRESSURE: {
            "Pa": 1.0,
            "kPa": 1e3,
            "MPa": 1e6,
            "GPa": 1e9,
            "N/m^2": 1.0,
            "kN/m^2": 1e3,
            "N/mm^2": 1e6,
        },
        Dimension.DAMPING: {"N*s/m": 1.0, "kN*s/m": 1e3, "kg/s": 1.0},
        Dimension.DAMPING_PER_LENGTH: {"N*s/m^2": 1.0, "kN*s/m^2": 1e3, "Pa*s": 1.0},
        Dimension.PRICE_PER_LENGTH: {"USD/m": 1.0},
        Dimension.NUMBER: {"%": 1e-2},
    }
)
"""SI units in one of each unit that is read without the units library.

A knot is 1852 m/h, a shot of chain 27.5 m, a year the Julian one.
"""

_AMBIGUOUS = {
    "ton": "ambiguous; write t (1000 kg) or tf (9.80665 kN)",
    "tons": "ambiguous; write t (1000 kg) or tf (9.80665 kN)",
    "tonf": "ambiguous; write tf (9.80665 kN)",
    "mt": "the millitonne, 1 kg; write t (1000 kg) or tf (9.80665 kN)",
    "mN": "the millinewton; capitals count: write MN or N",
    "mPa": "the millipascal; capitals count: write MPa or Pa",
    "Mm": "the megametre; capitals count: write mm or m",
    "gf": "the gram-force; write kgf or N",
}
"""Units that mean something else to some readers, or a million times less by one capital."""

_AS_FORCE = {"kg": "kgf", "t": "tf", "tonne": "tf", "tonnes": "tf", "lb": "lbf"}

_LONGEST_UNIT = 24
_NUMBER = re.compile(r"([+-]?(?:\d[\d.,]*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.ASCII | re.DOTALL)
_FRACTION = re.compile(r"(?:(\d{1,3})[ -])?(\d{1,3})/([1-9]\d{0,2})(\s*[^\W\d].*)", re.ASCII)
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity)\b.*", re.IGNORECASE | re.DOTALL)
_UNIT_WORD = r"[^\W\d]\w*(?:\^-?[1-9])?"
_UNIT = re.compile(rf"{_UNIT_WORD}(?:[*/ ]{_UNIT_WORD})*")
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
        raise reading.error(f"must be finite; {reading.wanted}")
    fault = "" if most is not None and 0.0 < si <= most else dimension.implausible(si)
    if fault and reading.bare and not isinstance(value, str):
        fault += f"; a bare number is in {reading.bare}: give a unit, as in {dimension.example}"
    if fault:
        raise reading.error(fault)
    return si


def as_written(value: object, longest: int = 40) -> str:
    """Show a value of a TOML file the way it writes it; texts are cut to `longest` characters."""
    match value:
        case bool():
            return "true" if value else "false"
        case str():
            text = value if len(value) <= longest else value[: longest - 3] + "..."
            return '"' + repr(text)[1:-1].replace("\\'", "'") + '"'
        case dict():
            return "a table"
        case list() | tuple():
            return f"an array of {len(value)}" if value else "an empty array"
        case date() | time():
            return value.isoformat()
        case int() if abs(value) >= 10**longest:
            return f"a whole number of more than {longest} digits"
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
        return f"{self.dimension.noun} is wanted, such as {self.dimension.example}"

    def error(self, allowed: str, note: str = "") -> InputError:
        return InputError([Problem(self.key, as_written(self.value) + note, allowed)])

    def split(self, text: str) -> tuple[str, str]:
        """Part a text into number and unit, the unit in the spelling of the table."""
        plain = text.translate(_SPELLINGS).strip()
        if fraction := _FRACTION.fullmatch(plain):
            whole, above, below, unit = fraction.groups()
            plain = f"{int(whole or 0) + int(above) / int(below)!r}{unit}"
        if _NOT_FINITE.fullmatch(plain):
            raise self.error(f"must be finite; {self.wanted}")
        parts = _NUMBER.fullmatch(plain)
        if parts is None:
            raise self.error(self.wanted)
        unit, found = _spelt(parts[2]), readings(parts[1])
        if not found or (unit and unit[0] in "_.,0123456789"):
            raise self.error(f"the number is not in one piece; {self.wanted}")
        digits = self._one_of(found, unit)
        if not unit:
            raise self.error(self._without_unit(digits))
        return digits, unit

    def _one_of(self, found: Sequence[str], unit: str) -> str:
        """Take the one reading of a number; of two, the one that is plausible."""
        first, *others = found
        said = unit or self.bare
        factor = _by_table(said)[1] if _by_table(said)[0] else 1.0
        if not others or self.dimension.implausible(float(others[0]) * factor):
            return first
        two = [f'"{float(each):.12g} {said}"' if said else f"{float(each):.12g}" for each in found]
        raise self.error(f"has two meanings: write {' or '.join(two)}")

    def factor(self, unit: str, digits: str) -> float:
        """SI units in one `unit`, which must be of the wanted dimension."""
        if unit in UNITS[self.dimension]:
            return UNITS[self.dimension][unit]
        if unit in _AMBIGUOUS:
            raise self.error(f"{unit} is {_AMBIGUOUS[unit]}")
        near = [u for units in UNITS.values() for u in units if u.casefold() == unit.casefold()]
        kind, factor = _by_table(unit) if near else _by_library(unit)
        if kind is self.dimension:
            return factor
        if kind is Dimension.MASS_PER_LENGTH and self.dimension is Dimension.FORCE_PER_LENGTH:
            return factor * STANDARD_GRAVITY
        noun = self.dimension.noun
        meant = [
            f"capitals count: write {known}" for known in near if known in UNITS[self.dimension]
        ]
        if kind is None:
            raise self.error(meant[0] if meant else f"not a unit known here; {self.wanted}")
        instead = self.wanted
        if meant:
            instead = f"{noun} is wanted; {meant[0]}"
        elif self.dimension is Dimension.FORCE and unit in _AS_FORCE:
            instead = f'{noun} is wanted: write "{digits} {_AS_FORCE[unit]}" or "{digits} kN"'
        raise self.error(instead, f", {kind.noun}")

    def _without_unit(self, digits: str) -> str:
        unit = self.dimension.si_unit
        if not unit:
            return f"{self.dimension.noun} is wanted: write {digits} without quotes"
        return f'a unit is missing: write "{digits} {unit}", or {digits} without quotes'


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


def _by_library(unit: str) -> tuple[Dimension | None, float]:
    """Dimension and SI factor of a unit; None for no unit at all and for one of no use here."""
    if len(unit) > _LONGEST_UNIT or not _UNIT.fullmatch(unit):
        return None, math.nan
    registry = _registry()
    try:
        root = (1.0 * registry.Unit(unit)).to_root_units()
    except Exception:  # the library raises a dozen kinds for what it cannot read as a unit
        return None, math.nan
    for dimension in Dimension:
        if dimension.si_unit:
            si = (1.0 * registry.Unit(dimension.si_unit)).to_root_units()
            if si.units == root.units:
                return dimension, float(root.magnitude / si.magnitude)
    return None, math.nan


@cache
def _registry() -> Any:
    import pint

    registry: Any = pint.UnitRegistry()
    registry.define("USD = [currency]")
    return registry


def lasting(seconds: float) -> str:
    """Write a time in whole hours or minutes, or else in seconds: ``"3 h"``."""
    for size, unit in ((3600.0, "h"), (60.0, "min")):
        if seconds >= size and round(seconds / size, 9).is_integer():
            return f"{seconds / size:g} {unit}"
    return f"{seconds:g} s"
