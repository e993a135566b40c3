"""An answer out of the catalogue as a document: what ``catopt catalog --json`` prints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from catopt.catalogue.components import Alternative, Component, Hydrodynamic, Provenance
from catopt.catalogue.family import Family
from catopt.catalogue.figure import SPECS, Figure, Source


@dataclass(frozen=True)
class Answer:
    """Families and components that a question gave.

    Attributes
    ----------
    question : {"list", "show", "search"}
        What was asked.
    families : tuple of Family
        Families that were listed, or that the components are of.
    components : tuple of Component
        Components that were found.
    """

    question: Literal["list", "show", "search"]
    families: tuple[Family, ...]
    components: tuple[Component, ...] = ()

    @property
    def sources(self) -> tuple[Source, ...]:
        """Documents that the answer rests on, by key."""
        cited = [
            *(s for family in self.families for s in family.sizes.sources),
            *(s for family in self.families for f in family.figures for s in f.sources),
            *(s for c in self.components for p in c.provenance.values() for s in p.sources),
        ]
        return tuple(sorted(set(cited), key=lambda source: source.key))

    def to_dict(self) -> dict[str, Any]:
        """Make the document ``catopt.catalog/1``."""
        return {
            "schema": "catopt.catalog/1",
            "question": self.question,
            "families": [_family(family) for family in self.families],
            "components": [_component(component) for component in self.components],
            "sources": [
                {"key": source.key, "title": source.title, "place": source.place}
                for source in self.sources
            ],
        }


def _family(family: Family) -> dict[str, Any]:
    sizes = family.sizes
    return {
        "name": family.name,
        "title": family.title,
        "also": list(family.also),
        "grades": list(family.grades),
        "range_m": list(family.range),
        "sizes_m": list(sizes.diameters),
        "sizes_confidence": sizes.confidence,
        "sizes_sources": _keys(sizes.sources),
        "note": family.note,
        "figures": [_figure(figure) for figure in family.figures],
    }


def _figure(figure: Figure) -> dict[str, Any]:
    return {
        "quantity": figure.quantity,
        "grades": list(figure.grades),
        "variant": figure.variant,
        "default": figure.default,
        "formula": figure.text,
        "confidence": figure.confidence,
        "sources": _keys(figure.sources),
        "place": figure.place,
        "range_m": list(figure.range),
        "reason": figure.reason,
        "note": figure.note,
    }


def _component(component: Component) -> dict[str, Any]:
    terms = component.EA_dynamic_terms
    return {
        "name": component.name,
        "family": component.family,
        "grade": component.grade,
        "nominal_diameter_m": component.nominal_diameter,
        "mass_kg_per_m": component.mass,
        "submerged_weight_N_per_m": component.submerged_weight,
        "water_density_kg_per_m3": component.water_density,
        "volume_diameter_m": component.volume_diameter,
        "MBL_N": component.MBL,
        "MBL_in_water_N": component.MBL_in_water,
        "proof_load_N": component.proof_load,
        "EA_N": component.EA,
        "EA_dynamic": None if terms is None else {"constant": terms[0], "slope": terms[1]},
        "drag_normal": _hydrodynamic(component.drag_normal),
        "drag_axial": _hydrodynamic(component.drag_axial),
        "added_mass_normal": _hydrodynamic(component.added_mass_normal),
        "added_mass_axial": _hydrodynamic(component.added_mass_axial),
        "price_USD_per_m": component.price,
        "recalled": list(component.recalled),
        "provenance": [
            {"quantity": key, **_provenance(origin)} for key, origin in component.provenance.items()
        ],
        "missing": [
            {"quantity": key, "reason": reason} for key, reason in component.missing.items()
        ],
        "alternatives": [_alternative(each) for each in component.alternatives],
    }


def _hydrodynamic(value: Hydrodynamic | None) -> dict[str, Any] | None:
    if value is None:
        return None
    return {
        "coefficient": value.coefficient,
        "diameter_m": value.diameter,
        "diameter_name": value.name,
    }


def _provenance(origin: Provenance) -> dict[str, Any]:
    return {
        "variant": origin.variant,
        "formula": origin.formula,
        "confidence": origin.confidence,
        "sources": _keys(origin.sources),
        "place": origin.place,
        "range_m": list(origin.range),
        "reason": origin.reason,
        "note": origin.note,
    }


def _alternative(other: Alternative) -> dict[str, Any]:
    return {
        "quantity": other.quantity,
        "value": other.value,
        "unit": SPECS[other.quantity].unit,
        "reference_diameter_m": other.reference,
        **_provenance(other.provenance),
    }


def _keys(sources: tuple[Source, ...]) -> list[str]:
    return [source.key for source in sources]
