"""Cells of the note's workbook: a value with the unit of its quantity, and its heading."""

from __future__ import annotations

from catopt.quantities import Quantity
from catopt.render.sheet import Number, number_pattern
from catopt.render.texts import Words
from catopt.report.page.table import in_unit, label_of

__all__ = ["headed", "number_of", "unit_of"]


def number_of(quantity: Quantity, si: float | None) -> Number:
    """Take a value in the field's unit."""
    return Number(None if si is None else quantity.to_field(si), number_pattern(quantity))


def headed(words: Words, quantity: Quantity) -> str:
    """Head a column: name, symbol and unit, in the language of the book."""
    return in_unit(label_of(words, quantity), quantity)


def unit_of(unit: str) -> str:
    """Write a unit; nothing for a pure number."""
    return "" if unit == "-" else unit
