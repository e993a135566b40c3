"""One value as people read it."""

from __future__ import annotations

import math

from catopt.answers.blocks import Column, Value
from catopt.quantities import Quantity
from catopt.words import Language, Message, say


def shown(
    value: Value, quantity: Quantity | None, language: Language, *, unit: bool = False
) -> str:
    """Write a value in the field's unit; a dash where it is not known."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return "-"
    if isinstance(value, str):
        return say(value, language)
    if quantity is None:
        return f"{value:,}" if isinstance(value, int) and value > 9999 else f"{value}"
    if quantity.key == "EA" and math.isinf(value):
        return say(Message("answers.inextensible"), language)
    return "∞" if math.isinf(value) else quantity.format(value, unit=unit)


def cell(column: Column, row: int, language: Language) -> str:
    """Write a cell of a table; with its unit where that is the row's own."""
    return shown(column.values[row], column.quantity_of(row), language, unit=bool(column.units))
