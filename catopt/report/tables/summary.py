"""What was given and what came out, as named values: the one list behind every summary.

Light on purpose: the terminal shows it without pandas.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from catopt.constants import STANDARD_GRAVITY
from catopt.quantities import QUANTITIES, Quantity

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.model import Case, Load
from catopt.words import Message

__all__ = [
    "Entry",
    "columns",
    "found",
    "given",
    "heading_of",
    "in_tonne_force",
    "label_of",
    "named",
    "residuals",
    "results",
]


@dataclass(frozen=True)
class Entry:
    """One value of a summary.

    Attributes
    ----------
    quantity : Quantity
        What it is, in the field's unit.
    value : float or None
        In SI; None when not known.
    also : tuple of Quantity
        The same in further units.
    """

    quantity: Quantity
    value: float | None
    also: tuple[Quantity, ...] = ()


def label_of(quantity: Quantity) -> str:
    """Name and symbol; a message where the name is one."""
    if not isinstance(quantity.name, Message):
        return quantity.label
    if not quantity.symbol:
        return quantity.name
    return Message("words.label", name=quantity.name, symbol=quantity.symbol)


def heading_of(quantity: Quantity) -> str:
    """Label with the field's unit; a message where the name is one."""
    if not isinstance(quantity.name, Message):
        return quantity.heading
    return Message("words.heading", label=label_of(quantity), unit=quantity.field_unit)


def named(key: str, name: str, symbol: str | None = None) -> Quantity:
    """Take a quantity of the table under a more particular name: `Fairlead tension`."""
    quantity = QUANTITIES[key]
    return replace(quantity, name=name, symbol=quantity.symbol if symbol is None else symbol)


def in_tonne_force(quantity: Quantity) -> Quantity:
    """Take a force in tf; a decimal more than in kN, for a tf is about 10 kN."""
    return replace(
        quantity, field_unit="tf", factor=1000.0 * STANDARD_GRAVITY, digits=quantity.digits + 1
    )


def columns(entries: Iterable[Entry]) -> dict[str, float | None]:
    """Lay entries out as headings with units and values in those units."""
    laid: dict[str, float | None] = {}
    for entry in entries:
        for quantity in (entry.quantity, *entry.also):
            laid[heading_of(quantity)] = (
                None if entry.value is None else quantity.to_field(entry.value)
            )
    return laid


def given(case: Case) -> tuple[Entry, ...]:
    """List what a case gives beside its line: site, heights, load and limits."""
    return (
        Entry(QUANTITIES["water_depth"], case.site.water_depth),
        Entry(QUANTITIES["fairlead_height"], case.fairlead_height),
        Entry(QUANTITIES["anchor_height"], case.anchor_height),
        Entry(QUANTITIES["friction"], case.site.seabed_friction),
        Entry(named("density", "Water density"), case.site.water_density),
        *_load(case.load),
        Entry(QUANTITIES["safety_factor"], case.checks.safety_factor),
        Entry(
            named("angle", "Allowed inclination at the anchor", ""),
            case.checks.max_anchor_uplift_angle,
        ),
    )


def _load(load: Load | None) -> tuple[Entry, ...]:
    """List the one known quantity; none where the force itself is sought."""
    if load is None:
        return ()
    known = (
        _force("horizontal_force", "Given horizontal force", load.horizontal_force),
        Entry(named("span", "Given span"), load.span),
        _force("tension", "Given fairlead tension", load.fairlead_tension),
    )
    return tuple(entry for entry in known if entry.value is not None)


def found(solution: Solution) -> tuple[Entry, ...]:
    """List what was sought and found; nothing when nothing was."""
    if solution.found is None:
        return ()
    value, number = solution.found.value, solution.found.number
    if solution.found.quantity == "length":
        return (Entry(named("length", Message("columns.found_length", number=number)), value),)
    if solution.found.quantity == "clump_weight":
        return (_force("point_weight", Message("columns.found_weight", number=number), value),)
    return (_force("horizontal_force", "Found horizontal force", value),)


def results(solution: Solution) -> tuple[Entry, ...]:
    """List what was found for the line as a whole."""
    anchor, fairlead = solution.anchor, solution.fairlead
    return (
        _angle("Inclination at the anchor", "theta0", anchor.angle),
        Entry(QUANTITIES["span"], solution.span),
        _force("tension", "Fairlead tension", fairlead.tension),
        _force("horizontal_force", "Horizontal force", solution.horizontal_force),
        _force("vertical_force", "Fairlead vertical force", fairlead.vertical_force),
        _angle("Inclination at the fairlead", "theta1", fairlead.angle),
        _force("tension", "Anchor tension", anchor.tension, ""),
        _force("horizontal_force", "Anchor horizontal force", anchor.horizontal_force, ""),
        _force("vertical_force", "Anchor vertical force", anchor.vertical_force, ""),
        Entry(QUANTITIES["grounded_length"], solution.grounded_length),
        Entry(QUANTITIES["suspended_length"], solution.suspended_length),
        Entry(QUANTITIES["stretched_length"], solution.stretched_length),
        Entry(named("mass", "Line mass in air", ""), solution.line.mass),
    )


def residuals(solution: Solution) -> tuple[Entry, ...]:
    """List by how much the line misses its fairlead, and what rounding leaves of its forces."""
    open_force = solution.residual.force_uncertainty
    return (
        Entry(named("residual", "Residual of the height"), solution.residual.height),
        Entry(named("residual", "Residual of the span"), solution.residual.span),
        _force("tension", "Force left open by rounding of the input", open_force, ""),
    )


def _force(key: str, name: str, value: float | None, symbol: str | None = None) -> Entry:
    quantity = named(key, name, symbol)
    return Entry(quantity, value, (in_tonne_force(quantity),))


def _angle(name: str, symbol: str, value: float) -> Entry:
    return Entry(named("angle", name, symbol), value, (named("angle_rad", name, symbol),))
