"""The catalogue as a case chooses it: its own families, and which of disagreeing figures."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from catopt import catalogue
from catopt.catalogue.collection import ALL, Catalogue, one_of_variants
from catopt.catalogue.components import Component
from catopt.catalogue.finding import own_variants
from catopt.errors import Problem
from catopt.model import CatalogueChoice
from catopt.units import as_written


@dataclass(frozen=True)
class ChosenCatalogue:
    """Families to choose from, catopt's own and the user's, with the figures that a case follows.

    A family that lacks a variant keeps its default.
    """

    families: Catalogue
    choice: CatalogueChoice
    water_density: float
    """For submerged weights, kg/m3."""

    def component(self, name: str, diameter: float) -> Component:
        """Look a component up by family and grade, and by nominal diameter, m."""
        return self.families.component(name, diameter, **self._figures(name))

    def sold(self, name: str) -> tuple[Component, ...]:
        """List a component in the sizes that are sold, as `Catalogue.sold`; of one grade or all."""
        return self.families.sold(name, **self._figures(name))

    def variants_of_none(self, names: Iterable[str]) -> list[Problem]:
        """List variants that none of some known components has.

        With the quantity as key, and what there is to choose from.
        """
        parsed = [self.families.parse_name(name) for name in names]
        own = [(self.families.family(each.family), each.grade) for each in parsed]
        problems = []
        for quantity, variant in self.choice.variants:
            if any(own_variants(family, grade, {quantity: variant}) for family, grade in own):
                continue
            there = {
                figure.variant: None
                for family, grade in own
                for figure in family.figures
                if quantity in (ALL, figure.quantity) and figure.holds_for(grade) and figure.variant
            }
            problems.append(Problem(quantity, as_written(variant), one_of_variants(there)))
        return problems

    def _figures(self, name: str) -> dict[str, Any]:
        """Say which figures to follow, by the arguments of `Catalogue.component`."""
        parsed = self.families.parse_name(name)
        family = self.families.family(parsed.family)
        return {
            "variants": own_variants(family, parsed.grade, self.choice.by_quantity),
            "water_density": self.water_density,
            "allow_recalled": self.choice.allow_recalled,
        }


def chosen(choice: CatalogueChoice, water_density: float) -> ChosenCatalogue:
    """Return the catalogue that a case chooses.

    InputError: the user's file cannot be read, or has a name that catopt's own families have.
    """
    families = catalogue.standard()
    if choice.file:
        families = families.with_families(catalogue.read_families(choice.file))
    return ChosenCatalogue(families, choice, water_density)
