"""The units in which every face shows quantities: those that the reader asks for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextvars import ContextVar
from dataclasses import fields, is_dataclass, replace
from typing import TYPE_CHECKING, Any, TypeVar

from catopt.quantities import Quantity, Units
from catopt.words import Cited, Listed, Measure, Message, Sentence, Several, Told
from catopt.words.labels import Term

if TYPE_CHECKING:
    from catopt.answers.blocks import Column

UNITS: ContextVar[Units] = ContextVar("UNITS", default="")
"""What the reader of this run asks for; empty: each quantity in its own unit."""

_Thing = TypeVar("_Thing")


def as_wanted(thing: _Thing) -> _Thing:
    """Return an answer, a block or drawings in the units that the reader asks for."""
    return in_units(thing, UNITS.get())


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
    return _converted(thing, units) if units else thing


def _converted(thing: Any, units: Units) -> Any:
    if isinstance(thing, Quantity):
        return thing.in_units(units)
    if isinstance(thing, Measure):
        return replace(thing, units=units)
    if isinstance(thing, str):
        return _said(thing, units)
    if isinstance(thing, tuple | list):
        return _several(thing, units)
    if isinstance(thing, dict):
        return {key: _converted(value, units) for key, value in thing.items()}
    if is_dataclass(thing) and not isinstance(thing, type):
        changed = {
            each.name: _converted(getattr(thing, each.name), units) for each in fields(thing)
        }
        return _without_doubles(replace(thing, **changed))
    return thing


def _several(thing: Any, units: Units) -> Any:
    if all(type(each) in {float, int, bool} for each in thing):
        return thing
    made = [_converted(each, units) for each in thing]
    return type(thing)(*made) if hasattr(thing, "_fields") else type(thing)(made)


def _said(thing: str, units: Units) -> str:
    """Say a message with its measures in other units; any other text stays as it is."""
    if isinstance(thing, Several):
        return Several(_several(thing.parts, units), thing.separator)
    if isinstance(thing, Listed):
        return Listed(_several(thing.parts, units), thing.last)
    if isinstance(thing, Sentence):
        return Sentence(_said(thing.words, units), capital=thing.capital)
    if not isinstance(thing, Message) or isinstance(thing, Cited | Told | Term):
        return thing
    return Message(thing.key, **_converted(dict(thing.values), units))


def _without_doubles(made: Any) -> Any:
    from catopt.answers.blocks import Fact, Table
    from catopt.figures.chart import Axis

    if isinstance(made, Fact):
        also = [each for each in made.also if each.field_unit != _unit(made)]
        return replace(made, also=tuple(also))
    if isinstance(made, Table):
        return replace(made, columns=tuple(_seen_once(made.columns)))
    if isinstance(made, Axis) and made.second is not None and not made.second.zero:
        return replace(made, second=None) if _unit(made.second) == _unit(made) else made
    return made


def _seen_once(columns: Iterable[Column]) -> Iterator[Column]:
    """Leave out what people would see twice; files keep their columns."""
    seen = []
    for column in columns:
        shown = column.values, _unit(column)
        if column.only != "people" or shown not in seen:
            seen.append(shown)
            yield column


def _unit(of: Any) -> str | None:
    return None if of.quantity is None else str(of.quantity.field_unit)
