"""What people see of a block, and one value as they read it."""

from __future__ import annotations

import math
from collections.abc import Sequence

from catopt.answers.blocks import Block, Column, Facts, Table, Text, Value, Warnings
from catopt.quantities import Quantity
from catopt.words import Message

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


def shown(value: Value, quantity: Quantity | None, *, unit: bool = False) -> str:
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
    return shown(column.values[row], column.quantity_of(row), unit=bool(column.units))
