"""Reads the formula of a figure from its inline table."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from types import MappingProxyType

from catopt.catalogue.figure import SPECS
from catopt.catalogue.formula import (
    ChainLoad,
    ChainModulus,
    Coefficient,
    Constant,
    Density,
    Formula,
    MeanLoad,
    Multiple,
    Polynomial,
    Rows,
)
from catopt.catalogue.table import Table
from catopt.units import UNITS, Dimension
from catopt.words import Message

_POWER = re.compile(r"d([0-3])")
_DIAMETER = re.compile(r"(?:(\d+(?:\.\d+)?) )?d(/pi)?")

_UNITS: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "kg/m": UNITS[Dimension.MASS_PER_LENGTH],
        "N": UNITS[Dimension.FORCE],
        "USD/m": {"USD/m": 1.0},
    }
)
"""Units that rows may be in, by the SI unit of the quantity."""

_OF_ONE_NUMBER: Mapping[str, Callable[[float], Formula]] = MappingProxyType(
    {"chain_load": ChainLoad, "density": Density, "value": Constant}
)

_EXTRA = {"rows": ("unit",), "times": ("of",), "coefficient": ("diameter",)}


def read_formula(figure: Table, quantity: str) -> Formula | None:
    """Read the formula of a figure; None when something is wrong with it, which was then noted."""
    table = figure.table("formula")
    spec = SPECS[quantity]
    if table is None:
        if not figure.has("formula"):
            figure.problem("formula", Message("refused_file.one_by", forms=", ".join(spec.forms)))
        return None
    forms = [key for key in table.values if key in spec.forms]
    powers = [key for key in forms if _POWER.fullmatch(key)]
    kinds = (["power"] if powers else []) + [key for key in forms if key not in powers]
    table.only(*spec.forms, *(e for key in forms for e in _EXTRA.get(key, ())))
    if len(kinds) != 1:
        figure.problem("formula", Message("refused.exactly_one", ways=", ".join(spec.forms)))
        return None
    if powers:
        return _polynomial(table, powers)
    return _read(table, kinds[0], quantity)


def _read(table: Table, kind: str, quantity: str) -> Formula | None:
    match kind:
        case "rows":
            return _rows(table, SPECS[quantity].unit)
        case "times":
            return _multiple(table, SPECS[quantity].of)
        case "coefficient":
            return _coefficient(table)
        case "chain_modulus":
            pair = table.numbers(kind, 2)
            return ChainModulus(*pair) if pair else None
        case "mean_load":
            pair = table.numbers(kind, 2)
            return MeanLoad(*pair) if pair else None
    value = table.number(kind, above=0.0)
    return None if value is None else _OF_ONE_NUMBER[kind](value)


def _polynomial(table: Table, powers: list[str]) -> Polynomial | None:
    read = [(int(key[1:]), table.number(key)) for key in sorted(powers)]
    terms = tuple((power, value) for power, value in read if value is not None)
    return Polynomial(terms) if len(terms) == len(powers) else None


def _rows(table: Table, si_unit: str) -> Rows | None:
    rows = table.rows("rows")
    units = _UNITS[si_unit]
    unit = table.word("unit", tuple(units))
    if not rows or unit is None:
        return None
    return Rows(
        tuple(diameter / 1e3 for diameter, _ in rows),
        tuple(value * units[unit] for _, value in rows),
    )


def _multiple(table: Table, of: tuple[str, ...]) -> Multiple | None:
    factor, other = table.number("times", above=0.0), table.word("of", of)
    return None if factor is None or other is None else Multiple(factor, other)


def _coefficient(table: Table) -> Coefficient | None:
    value, name = table.number("coefficient", above=0.0), table.text("diameter")
    if value is None or name is None:
        return None
    if name == "volume":
        return Coefficient(value, None, name)
    parts = _DIAMETER.fullmatch(name)
    if parts is None:
        table.problem("diameter", Message("refused_file.a_diameter"))
        return None
    ratio = float(parts[1] or 1.0) / (math.pi if parts[2] else 1.0)
    return Coefficient(value, ratio, name)
