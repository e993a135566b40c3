"""Evaluates the figures of a family at one grade and one nominal diameter."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

from catopt.catalogue.components import (
    NO_FIGURE,
    RECALLED,
    SPECS,
    Alternative,
    Component,
    Figure,
    Hydrodynamic,
    MeanLoadTerms,
    Provenance,
    Source,
    weakest,
)
from catopt.catalogue.family import Family, in_mm
from catopt.catalogue.formula import Coefficient, MeanLoad
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError, Problem, refused
from catopt.words import Cited, Message, is_said

WEIGHT_SOURCE = Source("CATOPT", "catopt, from mass and volume", Cited("catopt.catalogue"))
"""The submerged weight is no printed figure: it follows from two of them."""

_VALUES = ("MBL", "proof_load", "wet_strength_factor", "EA", "price")
_COEFFICIENTS = ("drag_normal", "drag_axial", "added_mass_normal", "added_mass_axial")


@dataclass(frozen=True)
class Evaluation:
    """The figures that were chosen of a family in a grade, at a nominal diameter, m."""

    family: Family
    grade: str | None
    diameter: float
    """Within the family's range."""
    chosen: Mapping[str, Figure]
    """By quantity: the variants asked for, else the defaults."""
    asked: frozenset[str] = frozenset()
    """Quantities whose variant was asked for by name: there an unknown value is an error."""
    allow_recalled: bool = False
    """Whether figures of confidence R may be used."""
    _known: dict[str, float] = field(default_factory=dict, repr=False, compare=False)

    def at(self, diameter: float) -> Evaluation:
        """Return the same choice at another nominal diameter."""
        return replace(self, diameter=diameter, _known={})

    def value(self, quantity: str) -> float:
        """Evaluate a quantity in SI; InputError says why it is not known."""
        if quantity not in self._known:
            lacks = self.why_not(quantity)
            if lacks:
                raise refused(quantity, "", lacks, self._name)
            self._known[quantity] = self.chosen[quantity].formula.value(self.diameter, self.value)
        return self._known[quantity]

    def why_not(self, quantity: str) -> str:
        """Say why a quantity is not known here; empty when it is."""
        figure = self.chosen.get(quantity)
        if figure is None:
            others = self.family.alternatives(quantity, self.grade)
            if not others:
                return Message(NO_FIGURE)
            names = ", ".join(each.variant for each in others)
            return Message("catalogue.no_default", variants=names)
        if figure.confidence == RECALLED and not self.allow_recalled:
            return Message("catalogue.only_recalled")
        if not figure.covers(self.diameter):
            low, high = (in_mm(end) for end in figure.range)
            values = {"low": low, "high": high, "diameter": in_mm(self.diameter)}
            others = self.family.alternatives(quantity, self.grade)
            reach = [
                e.variant for e in others if e.covers(self.diameter) and e.confidence != RECALLED
            ]
            if figure.variant and reach:
                values["others"] = ", ".join(reach)
                return Message("catalogue.known_from_others", variant=figure.variant, **values)
            if figure.variant:
                return Message("catalogue.known_from_by", variant=figure.variant, **values)
            return Message("catalogue.known_from", **values)
        return next((why for key in figure.formula.rests_on if (why := self.why_not(key))), "")

    @property
    def is_made(self) -> bool:
        """Whether what no component can do without, or was asked for, holds at this diameter."""
        needed = {key for key, spec in SPECS.items() if spec.needed or key == "MBL"} | self.asked
        return all(f.covers(self.diameter) for key in needed if (f := self.chosen.get(key)))

    def component(self, water_density: float) -> Component:
        """Put the component together.

        InputError: mass, volume or strength has no value here, or a variant that was asked for has
        none.
        """
        lacking = {key: why for key in SPECS if (why := self.why_not(key))}
        needed = {key for key, spec in SPECS.items() if spec.needed} | self.asked
        if "MBL" in lacking and "MBL" in self.chosen and not self._is_barred("MBL"):
            needed |= {"MBL"}  # a strength is known, but not here
        problems = [Problem(key, "", why) for key, why in lacking.items() if key in needed]
        if problems:
            raise InputError(problems, self._name)
        origins = {key: self._provenance(key) for key in SPECS if key not in lacking}
        missing = {
            key: why
            for key, why in lacking.items()
            if not (is_said(why, NO_FIGURE) and SPECS[key].of_some)
        }
        values: dict[str, Any] = {key: self._hydrodynamic(key) for key in _COEFFICIENTS}
        values |= {key: None if key in lacking else self.value(key) for key in _VALUES}
        mass, volume = origins["mass"], origins["volume_diameter"]
        origins["submerged_weight"] = Provenance(
            sources=(WEIGHT_SOURCE,),
            place="from the mass and the volume-equivalent diameter above",
            confidence=weakest([mass.confidence, volume.confidence]),
            formula=Message("catalogue.by_volume", weight="(m - rho_w pi D^2/4) g0 N/m"),
            range=(max(mass.range[0], volume.range[0]), min(mass.range[1], volume.range[1])),
        )
        section = math.pi * self.value("volume_diameter") ** 2 / 4.0
        return Component(
            name=self._name,
            family=self.family.name,
            grade=self.grade,
            nominal_diameter=self.diameter,
            mass=self.value("mass"),
            submerged_weight=(self.value("mass") - water_density * section) * STANDARD_GRAVITY,
            volume_diameter=self.value("volume_diameter"),
            water_density=water_density,
            EA_dynamic_terms=self._dynamic_terms(),
            **values,
            provenance=MappingProxyType(origins),
            missing=MappingProxyType(missing),
            _evaluation=self,
        )

    def alternatives(self) -> tuple[Alternative, ...]:
        """Evaluate every figure that is not in use, recalled ones included."""
        others = (
            figure
            for quantity in SPECS
            for figure in self.family.alternatives(quantity, self.grade)
            if figure is not self.chosen.get(quantity) or self._is_barred(quantity)
        )
        return tuple(self._alternative(figure) for figure in others)

    def _alternative(self, figure: Figure) -> Alternative:
        key = figure.quantity
        chosen = {**self.chosen, key: figure}
        other = replace(self, chosen=chosen, allow_recalled=True, _known={})
        reaches = not other.why_not(key)
        known = other._hydrodynamic(key) if isinstance(figure.formula, Coefficient) else None
        return Alternative(
            quantity=key,
            variant=figure.variant,
            value=other.value(key) if reaches else None,
            reference=known.diameter if known else None,
            provenance=other._provenance(key),
        )

    @property
    def _name(self) -> str:
        parts = (self.family.name, self.grade, in_mm(self.diameter))
        return " ".join(part for part in parts if part)

    def _is_barred(self, quantity: str) -> bool:
        """Whether a quantity is held back only because it, or what it rests on, is recalled."""
        if self.allow_recalled or not self.why_not(quantity):
            return False
        return not replace(self, allow_recalled=True, _known={}).why_not(quantity)

    def _hydrodynamic(self, quantity: str) -> Hydrodynamic | None:
        if self.why_not(quantity):
            return None
        formula = self.chosen[quantity].formula
        assert isinstance(formula, Coefficient)
        reference = formula.reference(self.diameter, self.value)
        return Hydrodynamic(formula.coefficient, reference, formula.name)

    def _dynamic_terms(self) -> MeanLoadTerms | None:
        if self.why_not("EA_dynamic"):
            return None
        formula = self.chosen["EA_dynamic"].formula
        assert isinstance(formula, MeanLoad)
        return MeanLoadTerms(formula.constant, formula.slope)

    def _chain_of(self, quantity: str) -> tuple[Figure, ...]:
        """List a figure and all that it rests on."""
        figure = self.chosen[quantity]
        below = (self._chain_of(key) for key in figure.formula.rests_on)
        return (figure, *(each for chain in below for each in chain))

    def _provenance(self, quantity: str) -> Provenance:
        figure = self.chosen[quantity]
        others = self.family.alternatives(quantity, self.grade)
        return Provenance(
            sources=figure.sources,
            place=figure.place,
            confidence=weakest(each.confidence for each in self._chain_of(quantity)),
            formula=figure.text,
            variant=figure.variant,
            alternatives=tuple(each.variant for each in others if each is not figure),
            reason=figure.reason if len(others) > 1 else "",
            range=figure.range,
            note=figure.note,
        )
