"""What came of a number of a file that is found from what is asked of its answer."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Column, Rows, answered, section
from catopt.dimensions import Dimension
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.study.finding import FoundValues

_OF_UNIT = {"N": "vertical_force", "N/m": "submerged_weight", "m": "height", "rad": "angle"}
"""Quantity by whose field unit and digits numbers are shown; others are in SI."""


_LEFT = Quantity("left", "", "", "-", "-", 1.0, 2, "scientific")


def finding_answer(found: FoundValues) -> blocks.Answer:
    """Lay out every value that was found, with what it gives and what is left of the condition."""
    of = Rows(found.solutions)
    key, reached = _quantity(found.unit), _quantity(found.quantity_unit)
    table = blocks.Table(
        "solutions",
        (
            Column(found.key, tuple(of.read("value")), key),
            Column(found.quantity, tuple(of.read("reached")), reached),
            Column(Message("quantities.residual"), tuple(of.read("residual")), _LEFT),
        ),
        Message("captions.solutions"),
    )
    return answered(
        "find",
        found.title or Message("captions.mooring_line"),
        section("captions.results", *map(blocks.Text, _said(found)), table),
    )


def _said(found: FoundValues) -> Iterator[Message]:
    """Say what was looked for, and where; and where there is no answer."""
    key = _quantity(found.unit)
    low, high = (
        f"{key.to_field(each):.6g} {key.field_unit}".rstrip(" -")
        for each in (found.low, found.high)
    )
    values = {"key": found.key, "low": low, "high": high, "count": found.tried}
    number = "one" if len(found.solutions) == 1 else "several"
    yield Message(f"study.found_{number}", number=len(found.solutions), **values)
    for why in found.reasons:
        yield Message("study.not_everywhere", why=why)


def _quantity(unit: str) -> Quantity:
    """Say how a number in an SI unit is shown."""
    if unit in _OF_UNIT:
        own = QUANTITIES[_OF_UNIT[unit]]
        return replace(own, symbol="", digits=6, notation="significant")
    assert not unit or any(each.si_unit == unit for each in Dimension)
    return Quantity("found", "", "", unit or "-", unit or "-", 1.0, 6, "significant")
