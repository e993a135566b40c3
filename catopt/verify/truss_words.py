"""What is said of closed form and truss model beside each other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity
from catopt.verify.compared import ORDER, ROUNDING
from catopt.words import Measure, Message, Several

if TYPE_CHECKING:
    from catopt.verify.compared import Compared
    from catopt.verify.result import StaticComparison


def named(key: str, name: str, symbol: str | None = None) -> Quantity:
    """Return a quantity under another name, and symbol where one is given."""
    of = QUANTITIES[key]
    return replace(of, name=name, symbol=of.symbol if symbol is None else symbol)


QUANTITY_OF: Mapping[str, Quantity] = MappingProxyType(
    {
        "span": QUANTITIES["span"],
        "horizontal_force": QUANTITIES["horizontal_force"],
        "fairlead_tension": named("tension", "Fairlead tension"),
        "fairlead_vertical_force": named("vertical_force", "Fairlead vertical force"),
        "fairlead_angle": named("angle", "Fairlead inclination", ""),
        "anchor_tension": named("tension", "Anchor tension", "TA"),
        "anchor_vertical_force": named("vertical_force", "Anchor vertical force", "VA"),
        "anchor_angle": named("angle", "Anchor inclination", ""),
        "grounded_length": QUANTITIES["grounded_length"],
        "shape": named("length", "Distance of the shapes", ""),
        "position_x": named("offset", "Position of the body", "x"),
        "position_y": named("offset", "Position of the body", "y"),
        "moment_of_lines": named("moment", "Moment of the lines", ""),
        "place_x": named("offset", "Position of the joint", "x"),
        "place_y": named("offset", "Position of the joint", "y"),
        "place_z": named("height", "Position of the joint", "z"),
        "from_tension": named("tension", "Tension, from", "T1"),
        "to_tension": named("tension", "Tension, to", "T2"),
    }
)
"""What each compared quantity is in tables."""

_SCALE_WORDS = {
    "N": "truss.of_the_tension",
    "m": "truss.of_the_length",
    "rad": "truss.of_a_rad",
    "Nm": "truss.of_moment",
}

_MOST_NAMED = 4
"""Quantities that a sentence names."""


def in_parts(value: float) -> str:
    """Write a difference over its scale; below the truss's own tolerance even a 0 is chance."""
    return f"{value:.1e}" if value >= ROUNDING else f"<{ROUNDING:.0e}"


def name_of(each: Compared, part: StaticComparison | None = None) -> Message:
    """Name a quantity, with its line in a system: ``"fairlead tension of line 2"``.

    `part`: of which it is, where lines may have names.
    """
    name = Message(f"truss.{each.quantity}")
    if each.point:
        return Message("truss.quantity_of_point", quantity=name, name=each.point)
    if each.line is None or each.quantity.startswith("position"):
        return name
    number = f"{each.line + 1}" if part is None else part.name_of_line(each.line)
    return Message("truss.quantity_of_line", quantity=name, number=number)


def gap_words(each: Compared) -> Message:
    """Say how large a gap is: ``"3.1e-09 of the tension"``."""
    gap = in_parts(each.gap)
    if each.theory != ORDER:
        # Of a slack line the scale may be that of a bar, over the tolerance.
        return Message("truss.of_its_scale", gap=gap)
    if each.quantity.startswith("position"):
        return Message("truss.of_the_offset", gap=gap)
    return Message(_SCALE_WORDS[each.unit], gap=gap)


def part_sentence(part: StaticComparison) -> Message:
    """Say what came of one load case."""
    worst = part.worst
    allowed = f"{part.tolerance:.0e}"
    if part.verdict == "agrees":
        told = Message("truss.largest", quantity=name_of(worst, part), gap=gap_words(worst))
        if worst.gap < ROUNDING:
            told = Message("truss.below_scale", limit=f"{ROUNDING:.0e}")
        return Message("truss.agree", largest=told, allowed=allowed)
    others = [each for each in part.quantities if not each.agrees]
    differences = []
    for each in others[:_MOST_NAMED]:
        of = QUANTITY_OF[each.quantity]
        amount = Measure(of.key, each.difference, digits=of.digits + 1)
        values = {"quantity": name_of(each, part), "amount": amount, "gap": gap_words(each)}
        differences.append(Message("truss.differs_by", **values))
    if len(others) > _MOST_NAMED:
        differences.append(Message("truss.and_more", more=len(others) - _MOST_NAMED))
    key = "truss.not_resolved" if part.verdict == "not resolved" else "truss.differ"
    return Message(key, differences=Several(differences), allowed=allowed)


def rough_sentence(part: StaticComparison) -> str:
    """Name what does not close up smoothly; empty where everything does."""
    if not part.rough:
        return ""
    rough = (
        Message("truss.rough_quantity", quantity=name_of(each, part), order=each.order)
        for each in part.rough[:_MOST_NAMED]
    )
    told: Message = Several(rough, ", ")
    if len(part.rough) > _MOST_NAMED:
        more = len(part.rough) - _MOST_NAMED
        told = Message("truss.rough_more", quantities=told, more=more)
    return Message("truss.rough", quantities=told)
