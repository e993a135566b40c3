"""Quantities under more particular names, and their headings."""

from __future__ import annotations

from dataclasses import replace

from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Message

__all__ = ["heading_of", "named"]


def heading_of(quantity: Quantity) -> str:
    """Label with the field's unit; a message where the name is one."""
    if not isinstance(quantity.name, Message):
        return quantity.heading
    label: str = quantity.name
    if quantity.symbol:
        label = Message("words.label", name=quantity.name, symbol=quantity.symbol)
    return Message("words.heading", label=label, unit=quantity.field_unit)


def named(key: str, name: str, symbol: str | None = None) -> Quantity:
    """Take a quantity of the table under a more particular name: `Fairlead tension`."""
    quantity = QUANTITIES[key]
    return replace(quantity, name=name, symbol=quantity.symbol if symbol is None else symbol)
