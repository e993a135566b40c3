"""What anchors and sinkers of the catalogue hold, as a table."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import cast

from catopt.catalogue.anchors import AnchorType, anchor_types
from catopt.catalogue.figure import Confidence, Source
from catopt.catalogue.names import meant, words_of
from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import InputError, Problem
from catopt.loads.drag_anchor import default_factor, holding_capacity
from catopt.loads.holding_data import CURVES
from catopt.loads.sinker import (
    ADHESION,
    DENSITIES,
    SAFETY_FACTOR,
    SOIL_FRICTION,
    Material,
    adhesion_holding,
    check_material,
    submerged_weight,
)
from catopt.model.validity import Findings
from catopt.units import as_written
from catopt.words import Message


@dataclass(frozen=True)
class AnchorHeld:
    """What a drag anchor of a mass holds in a soil, pulled horizontally; N and kg."""

    anchor: str
    soil: str
    mass: float
    holding: float
    """Ultimate, by the lowest data set."""
    data: str
    others: tuple[tuple[str, float], ...]
    safety_factor: float
    """Of UFC table 3-7."""
    price: float
    """Material only, USD of 2024."""
    sold: tuple[float, float]
    confidence: Confidence
    """Of the holding."""
    sources: tuple[Source, ...]
    place: str
    note: str

    @property
    def pull(self) -> float:
        """Largest pull that keeps the factor."""
        return self.holding / self.safety_factor


@dataclass(frozen=True)
class SinkerHeld:
    """What a sinker of a mass holds on a soil before it slides; N and kg."""

    material: Material
    soil: str
    mass: float
    submerged_weight: float
    friction: float | None
    adhesion: float | None
    """Pa, of clays; None where friction holds."""
    holding: float | None
    """None where the area of the base is not known."""
    source: str
    confidence: Confidence
    safety_factor: float = SAFETY_FACTOR

    @property
    def pull(self) -> float | None:
        """Largest pull that keeps the factor."""
        return None if self.holding is None else self.holding / self.safety_factor


def named_anchors(name: str) -> tuple[AnchorType, ...]:
    """Find the kinds of drag anchor that go by a name; InputError gives the nearest."""
    asked = set(words_of(name))
    every = {each.name: each for each in anchor_types()}
    exact = [e for e in every.values() if asked in [set(words_of(n)) for n in (e.name, *e.also)]]
    if exact:
        return tuple(exact[:1])
    wanted = meant(Message("refused.one_of", words="; ".join(every)), name, every)
    raise InputError([Problem("anchor", as_written(name), wanted)], "catalogue")


def anchors_held(
    kinds: Iterable[AnchorType],
    soil: str | None = None,
    mass: float | None = None,
    *,
    allow_recalled: bool = False,
) -> tuple[AnchorHeld, ...]:
    """Tabulate what kinds of anchor hold, in one soil or in all, of one mass or of all sold.

    InputError: a soil without figures, or a mass that is not sold.
    """
    return tuple(
        _held(kind, each, of, allow_recalled=allow_recalled)
        for kind in kinds
        for each in ([soil] if soil else _soils(kind))
        for of in ([mass] if mass is not None else kind.masses)
    )


def _soils(kind: AnchorType) -> Sequence[str]:
    return list(dict.fromkeys(each.soil for each in CURVES if each.anchor == kind.name))


def _held(kind: AnchorType, soil: str, mass: float, *, allow_recalled: bool) -> AnchorHeld:
    capacity = holding_capacity(kind.name, soil, mass, allow_recalled=allow_recalled)
    curve = capacity.curve
    own = next(e for e in kind.holdings if (e.soil, e.data) == (curve.soil, curve.data))
    return AnchorHeld(
        anchor=kind.name,
        soil=soil,
        mass=mass,
        holding=capacity.capacity,
        data=curve.data,
        others=capacity.others,
        safety_factor=default_factor(kind.name),
        price=kind.price_per_mass * mass,
        sold=kind.range,
        confidence=own.confidence,
        sources=own.sources,
        place=own.place,
        note=kind.note,
    )


def sinkers_held(
    mass: float,
    material: str = "concrete",
    *,
    base_area: float | None = None,
    water_density: float = SEA_WATER_DENSITY,
) -> tuple[SinkerHeld, ...]:
    """Tabulate what a sinker holds on every soil that has a figure, and in every clay by adhesion.

    The mass is in air, kg; the area of the base, m2, counts in clay alone.
    """
    found = Findings("sinker")
    if base_area is not None:
        found.number("base_area", base_area, "m^2", above=0.0)
    check_material(found, material)
    material = cast("Material", material)
    weight = submerged_weight(mass, DENSITIES[material], water_density)
    rows = []
    for soil, row in SOIL_FRICTION.items():
        of = row.of(material)
        if of is not None:
            mu, source = of
            origin = source.text, source.confidence
            rows.append(SinkerHeld(material, soil, mass, weight, mu, None, mu * weight, *origin))
    for soil in ADHESION:
        adhesion, source = adhesion_holding(soil, 1.0, material)
        total = None if base_area is None else adhesion * base_area
        origin = source.text, source.confidence
        rows.append(SinkerHeld(material, soil, mass, weight, None, adhesion, total, *origin))
    return tuple(rows)
