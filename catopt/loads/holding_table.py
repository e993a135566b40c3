"""What drag anchors and sinkers hold on every soil, tabulated."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated, NamedTuple, cast

from catopt.catalogue.components import Confidence, Source
from catopt.catalogue.family import meant, words_of
from catopt.catalogue.fittings import AnchorType, anchor_types
from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import refused
from catopt.loads.drag_anchor import default_factor, holding_capacity
from catopt.loads.sinker import (
    ADHESION,
    DENSITIES,
    SAFETY_FACTOR,
    SOIL_FRICTION,
    Material,
    bond_of,
    check_material,
    friction_of,
)
from catopt.model.kinds import Findings, Mass, Measured, Positive, SomeForce, Strength
from catopt.model.line import weight_in_water
from catopt.records import Record
from catopt.units import Dimension, as_written
from catopt.words import Message

Adhered = Annotated[float, Measured(Dimension.PRESSURE, above=0.0)]


class HoldingByData(NamedTuple):
    """What a data set has of an anchor."""

    data: str
    """Data set."""
    holding: Strength
    """Ultimate."""


@dataclass(frozen=True)
class AnchorHolding(Record):
    """What a drag anchor of a mass holds in a soil, pulled horizontally."""

    DOCUMENT = (
        "anchor soil mass holding data others(data holding) safety_factor pull price=price_USD "
        "sold confidence source_keys=sources place note"
    )

    anchor: str
    """Kind of drag anchor."""
    soil: str
    """Soil."""
    mass: Mass
    """In air."""
    holding: Strength
    """Ultimate, of a horizontal pull, by the lowest data set."""
    data: str
    """Data set."""
    others: tuple[HoldingByData, ...]
    """What the other data sets have."""
    safety_factor: Positive
    """On the ultimate holding, of UFC table 3-7."""
    price: Positive
    """Material only, USD of 2024."""
    sold: tuple[Mass, Mass]
    """Smallest and largest mass that is sold."""
    confidence: Confidence
    """How well it was read."""
    sources: tuple[Source, ...]
    place: str
    """Where in the sources."""
    note: str
    """What else to know."""

    @property
    def source_keys(self) -> tuple[str, ...]:
        """Keys of the sources."""
        return tuple(source.key for source in self.sources)

    @property
    def pull(self) -> Strength:
        """Largest pull that keeps the factor."""
        return self.holding / self.safety_factor


@dataclass(frozen=True)
class SinkerHolding(Record):
    """What a sinker of a mass holds on a soil before it slides."""

    DOCUMENT = (
        "material soil mass submerged_weight friction adhesion holding safety_factor pull source "
        "confidence"
    )

    material: Material
    """Of the sinker."""
    soil: str
    """Soil."""
    mass: Mass
    """In air."""
    submerged_weight: Strength
    """In water."""
    friction: Positive
    """tan(delta) on the weight in water."""
    adhesion: Adhered | None
    """Of a clay, per area of the base; None where friction alone holds."""
    holding: SomeForce
    """Pull at which it slides: on clay no more than its base holds."""
    source: str
    """Of friction or adhesion."""
    confidence: Confidence
    """How well it was read."""
    safety_factor: Positive = SAFETY_FACTOR
    """On sliding."""

    @property
    def pull(self) -> SomeForce:
        """Largest pull that keeps the factor."""
        return self.holding / self.safety_factor


def named_anchors(name: str) -> tuple[AnchorType, ...]:
    """Find the kinds of drag anchor that go by a name; InputError gives the nearest."""
    asked = set(words_of(name))
    every = {each.name: each for each in anchor_types()}
    exact = [e for e in every.values() if asked in [set(words_of(n)) for n in (e.name, *e.also)]]
    if exact:
        return tuple(exact[:1])
    wanted = meant(Message("refused.one_of", words="; ".join(every)), name, every)
    raise refused("anchor", as_written(name), wanted, "catalogue")


def anchor_holdings(
    kinds: Iterable[AnchorType],
    soil: str | None = None,
    mass: float | None = None,
    *,
    allow_recalled: bool = False,
) -> tuple[AnchorHolding, ...]:
    """Tabulate what kinds of anchor hold, in one soil or in all, of one mass or of all sold.

    InputError: a soil without figures, or a mass that is not sold.
    """
    return tuple(
        _held(kind, each, of, allow_recalled=allow_recalled)
        for kind in kinds
        for each in ([soil] if soil else dict.fromkeys(of.soil for of in kind.holdings))
        for of in ([mass] if mass is not None else kind.masses)
    )


def _held(kind: AnchorType, soil: str, mass: float, *, allow_recalled: bool) -> AnchorHolding:
    capacity = holding_capacity(kind.name, soil, mass, allow_recalled=allow_recalled)
    curve = capacity.curve
    own = next(e for e in kind.holdings if (e.soil, e.data) == (curve.soil, curve.data))
    return AnchorHolding(
        anchor=kind.name,
        soil=soil,
        mass=mass,
        holding=capacity.capacity,
        data=curve.data,
        others=tuple(HoldingByData(*each) for each in capacity.others),
        safety_factor=default_factor(kind.name),
        price=kind.price_per_mass * mass,
        sold=kind.range,
        confidence=own.confidence,
        sources=own.sources,
        place=own.place,
        note=kind.note,
    )


def sinker_holdings(
    mass: float,
    material: str = "concrete",
    *,
    base_area: float | None = None,
    water_density: float = SEA_WATER_DENSITY,
) -> tuple[SinkerHolding, ...]:
    """Tabulate what a sinker holds on every soil that has a figure.

    The mass is in air, kg; the area of the base, m2, counts on clay alone, and is that of a cast
    block where it is left out.
    """
    found = Findings("sinker")
    if base_area is not None:
        found.number("base_area", base_area, "m^2", above=0.0)
    check_material(found, material)
    material = cast("Material", material)
    weight = weight_in_water(mass, DENSITIES[material], water_density)
    rows = []
    for soil in dict.fromkeys((*SOIL_FRICTION, *ADHESION)):
        row = SOIL_FRICTION.get(soil)
        if row is not None and row.of(material) is None:
            continue
        mu, source = friction_of(soil, material)
        bond, holding, adhesion = bond_of(soil, material, base_area), mu * weight, None
        if bond is not None:
            by_base, adhesion = bond.holding(mass, DENSITIES[material]), bond.adhesion
            source = source if holding <= by_base else bond.source
            holding = min(holding, by_base)
        origin = source.text, source.confidence
        rows.append(SinkerHolding(material, soil, mass, weight, mu, adhesion, holding, *origin))
    return tuple(rows)
