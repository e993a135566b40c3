"""An answer out of the catalogue as a document: what ``catopt catalog --json`` prints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from catopt.catalogue.components import (
    SPECS,
    Alternative,
    Component,
    Figure,
    Hydrodynamic,
    Provenance,
    Source,
)
from catopt.catalogue.family import Family
from catopt.catalogue.fittings import Fitting
from catopt.documents import figures


@dataclass(frozen=True)
class Answer:
    """Families and components that a question gave."""

    question: Literal["list", "show", "search", "find", "anchor", "fittings", "sinker"]
    families: tuple[Family, ...]
    """Families that were listed, or that the components are of."""
    components: tuple[Component, ...] = ()
    anchors: Sequence[Any] = ()
    """What drag anchors hold, `catopt.loads.sinker.AnchorHeld`."""
    fittings: tuple[Fitting, ...] = ()
    uses: tuple[str, ...] = ()
    """What the fittings are for, beside each; empty where they were looked up by name."""
    missing: Sequence[str] = ()
    """Why what was asked for has no fitting."""
    sinkers: Sequence[Any] = ()
    """What sinkers hold, `catopt.loads.sinker.SinkerHeld`."""

    @property
    def sources(self) -> tuple[Source, ...]:
        """Documents that the answer rests on, by key."""
        cited = [
            *(s for family in self.families for s in family.sizes.sources),
            *(s for family in self.families for f in family.figures for s in f.sources),
            *(s for c in self.components for p in c.provenance.values() for s in p.sources),
            *(s for each in (*self.anchors, *self.fittings) for s in each.sources),
        ]
        return tuple(sorted(set(cited), key=lambda source: source.key))

    def to_dict(self) -> dict[str, Any]:
        """Make the document ``catopt.catalog/1``."""
        parts = {
            "anchors": [_anchor(each) for each in self.anchors],
            "fittings": [_fitting(each, use) for each, use in self.used_fittings()],
            "missing_fittings": [str(each) for each in self.missing],
            "sinkers": [_sinker(each) for each in self.sinkers],
        }
        return {
            "schema": "catopt.catalog/1",
            "question": self.question,
            "families": [_family(family) for family in self.families],
            "components": [_component(component) for component in self.components],
            **{name: each for name, each in parts.items() if each},
            "sources": [figures(source, "key title place") for source in self.sources],
        }

    def used_fittings(self) -> list[tuple[Fitting, str]]:
        """List each fitting with what it is for."""
        uses = self.uses or ("",) * len(self.fittings)
        return list(zip(self.fittings, uses, strict=True))


def _sinker(of: Any) -> dict[str, Any]:
    return {
        **figures(of, "material soil mass_kg submerged_weight_N friction"),
        "adhesion_Pa": of.adhesion,
        **figures(of, "holding_N safety_factor pull_N source confidence"),
    }


def _anchor(of: Any) -> dict[str, Any]:
    return {
        **figures(of, "anchor soil mass_kg holding_N data"),
        "others": [{"data": data, "holding_N": held} for data, held in of.others],
        **figures(of, "safety_factor pull_N price_USD"),
        "sold_kg": list(of.sold),
        **figures(of, "confidence"),
        "sources": _keys(of.sources),
        **figures(of, "place note"),
    }


def _fitting(of: Fitting, use: str) -> dict[str, Any]:
    return {
        "use": use,
        **figures(of, "name kind title size_m MBL_N proof_load_N mass_kg WLL_kg price_USD"),
        **figures(of, "confidence"),
        "sources": _keys(of.sources),
        **figures(of, "place note"),
    }


def _family(family: Family) -> dict[str, Any]:
    sizes = family.sizes
    return {
        **figures(family, "name title also grades range_m"),
        "sizes_m": list(sizes.diameters),
        "sizes_confidence": sizes.confidence,
        "sizes_sources": _keys(sizes.sources),
        "note": family.note,
        "figures": [_figure(figure) for figure in family.figures],
    }


def _figure(figure: Figure) -> dict[str, Any]:
    return {
        **figures(figure, "quantity grades variant default"),
        "formula": figure.text,
        "confidence": figure.confidence,
        "sources": _keys(figure.sources),
        **figures(figure, "place range_m reason note"),
    }


def _component(component: Component) -> dict[str, Any]:
    terms = component.EA_dynamic_terms
    weight = "mass_kg_per_m submerged_weight_N_per_m water_density_kg_per_m3 volume_diameter_m"
    coefficients = ("drag_normal", "drag_axial", "added_mass_normal", "added_mass_axial")
    return {
        **figures(component, f"name family grade nominal_diameter_m {weight}"),
        **figures(component, "MBL_N MBL_in_water_N proof_load_N EA_N"),
        "EA_dynamic": None if terms is None else {"constant": terms[0], "slope": terms[1]},
        **{key: _hydrodynamic(getattr(component, key)) for key in coefficients},
        **figures(component, "price_USD_per_m recalled"),
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
    return {**figures(value, "coefficient diameter_m"), "diameter_name": value.name}


def _provenance(origin: Provenance) -> dict[str, Any]:
    return {
        **figures(origin, "variant formula confidence"),
        "sources": _keys(origin.sources),
        **figures(origin, "place range_m reason note"),
    }


def _alternative(other: Alternative) -> dict[str, Any]:
    return {
        **figures(other, "quantity value"),
        "unit": SPECS[other.quantity].unit,
        "reference_diameter_m": other.reference,
        **_provenance(other.provenance),
    }


def _keys(sources: tuple[Source, ...]) -> list[str]:
    return [source.key for source in sources]
