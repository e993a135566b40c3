"""What people see of a block, in which units, and one value as they read it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

from catopt.answers.blocks import Answer, Block, Column, Fact, Facts, Table, Text, Value, Warnings
from catopt.figures.chart import Axis
from catopt.quantities import Quantity, Units, fitted
from catopt.words import Language, Measure, Message, say

SEEN = {"all", "people", "not csv"}
"""For whom things are that people see."""


def is_seen(block: Block) -> bool:
    """Whether people see anything of a block."""
    if isinstance(block, Table) and block.length == 0:
        return False
    return block.only in SEEN if isinstance(block, Table | Facts | Text | Warnings) else True


def parts_of(table: Table) -> Sequence[tuple[str, Sequence[int]]]:
    """List captions and rows of the tables into which a table falls for people."""
    rows = range(table.length) if table.shown is None else table.shown
    return table.parts or ((table.caption, rows),)


def as_text(value: Value, quantity: Quantity | None, *, unit: bool = False) -> str:
    """Write a value in the field's unit, a message as it is; a dash where it is not known."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return "-"
    if isinstance(value, str):
        return value
    if quantity is None:
        return f"{value:,}" if isinstance(value, int) and value > 9999 else f"{value}"
    if quantity.key == "EA" and math.isinf(value):
        return Message("answers.inextensible")
    return "∞" if math.isinf(value) else quantity.format(value, unit=unit)


def cell(column: Column, row: int) -> str:
    """Write a cell of a table; with its unit where that is the row's own."""
    return as_text(column.values[row], column.quantity_of(row), unit=bool(column.units))


UNITS: ContextVar[Units] = ContextVar("UNITS", default="")
"""What the reader of this run asks for; empty: each quantity in its own unit."""

_Thing = TypeVar("_Thing")


def as_wanted(thing: _Thing, language: Language = "en") -> _Thing:
    """Return an answer, a block or drawings in the units that the reader asks for, and said.

    Numbers of an answer have as many digits as their size wants.
    """
    return in_language(_with_digits(in_units(thing, UNITS.get())), language)


_NOTHING = 1e-9
"""Of the largest of its kind in an answer: what is smaller is rounding."""


def _with_digits(thing: _Thing) -> _Thing:
    """Give small forces and masses of an answer their digits, and what is rounding none."""
    if not isinstance(thing, Answer):
        return thing
    largest: dict[str, float] = {}
    for block in (*thing.blocks, *thing.card):
        for quantity, values in _measured(block):
            sizes = (abs(each) for each in values if math.isfinite(each))
            unit = quantity.si_unit
            largest[unit] = max(largest.get(unit, 0.0), *sizes, 0.0)
    rounding = {unit: _NOTHING * size for unit, size in largest.items() if unit != "-"}

    def change(each: Any) -> Any:
        if isinstance(each, Column) and each.quantity is not None:
            return replace(each, quantity=_fitted(each.quantity, each.values, rounding))
        if isinstance(each, Facts):
            alike: dict[str, list[Value]] = {}
            for fact in each.facts:
                if fact.quantity is not None and fact.only != "files":
                    alike.setdefault(fact.quantity.si_unit, []).append(fact.value)
            return replace(each, facts=tuple(_fitted_fact(f, alike, rounding) for f in each.facts))
        return each

    fitting: _Thing = _changed(thing, change)
    return fitting


def _fitted_fact(
    fact: Fact, alike: Mapping[str, list[Value]], rounding: Mapping[str, float]
) -> Fact:
    if fact.quantity is None:
        return fact
    values = alike.get(fact.quantity.si_unit, [fact.value])
    quantity, *also = (_fitted(each, values, rounding) for each in (fact.quantity, *fact.also))
    return replace(fact, quantity=quantity, also=tuple(also))


def _fitted(quantity: Quantity, values: Iterable[Value], rounding: Mapping[str, float]) -> Quantity:
    numbers = (each for each in values if isinstance(each, int | float))
    return fitted(quantity, numbers, rounding.get(quantity.si_unit, 0.0))


def _measured(block: object) -> Iterator[tuple[Quantity, list[float]]]:
    """Yield the quantities of a block with their numbers."""
    parts: Iterable[tuple[Quantity | None, Iterable[Value]]] = ()
    if isinstance(block, Table):
        parts = ((each.quantity, each.values) for each in block.columns)
    elif isinstance(block, Facts):
        parts = ((each.quantity, (each.value,)) for each in block.facts)
    for quantity, values in parts:
        if quantity is not None:
            yield quantity, [each for each in values if isinstance(each, int | float)]


def in_language(thing: _Thing, language: Language) -> _Thing:
    """Say all messages of an answer, a block or drawings; in English they are what they are."""

    def change(each: Any) -> Any:
        return say(each, language) if isinstance(each, str) else each

    return thing if language == "en" else _changed(thing, change)


def in_units(thing: _Thing, units: Units) -> _Thing:
    """Return an answer, a block or drawings in other units; values stay in SI.

    Columns, facts and axes that showed the same in a second unit, and would now show it twice, are
    left out.

    Examples
    --------
    >>> from catopt.answers.blocks import fact
    >>> shown = in_units(fact("tension", 98066.5), "tf")
    >>> shown.quantity.format(shown.value, unit=True)
    '10.0000 tf'
    """
    return _changed(thing, lambda each: _converted(each, units)) if units else thing


def _changed(thing: Any, change: Callable[[Any], Any]) -> Any:
    """Change all that a thing consists of, from the inside out."""
    if isinstance(thing, tuple | list):
        if all(type(each) in {float, int, bool} for each in thing):
            return thing
        made = [_changed(each, change) for each in thing]
        return type(thing)(*made) if hasattr(thing, "_fields") else type(thing)(made)
    if isinstance(thing, dict):
        return {key: _changed(value, change) for key, value in thing.items()}
    if is_dataclass(thing) and not isinstance(thing, type | Quantity | Measure):
        parts = {each.name: _changed(getattr(thing, each.name), change) for each in fields(thing)}
        return change(replace(thing, **parts))
    return change(thing)


def _converted(thing: Any, units: Units) -> Any:
    if isinstance(thing, Quantity):
        return thing.in_units(units)
    if isinstance(thing, Measure):
        return replace(thing, units=units)
    if isinstance(thing, Message):
        kind: Any = type(thing)
        made = in_units(vars(thing), units)
        return kind(made["key"], **made["values"]) if thing.key else kind(**made)
    if isinstance(thing, Fact):
        also = [each for each in thing.also if each.field_unit != _unit(thing)]
        return replace(thing, also=tuple(also))
    if isinstance(thing, Table):
        return replace(thing, columns=tuple(_seen_once(thing.columns)))
    if isinstance(thing, Axis) and thing.second is not None and not thing.second.zero:
        return replace(thing, second=None) if _unit(thing.second) == _unit(thing) else thing
    return thing


def _seen_once(columns: Iterable[Column]) -> Iterator[Column]:
    """Leave out what people would see twice; files keep their columns."""
    seen = []
    for column in columns:
        shown = column.name, column.values, _unit(column)
        if column.only != "people" or shown not in seen:
            yield column
        if column.only != "files":
            seen.append(shown)


def _unit(of: Any) -> str | None:
    return None if of.quantity is None else str(of.quantity.field_unit)
