"""What sinkers and anchors hold."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Final, Literal, NamedTuple, TypeAlias, cast

from catopt.catalogue.components import Confidence, Source
from catopt.catalogue.family import meant, words_of
from catopt.catalogue.fittings import AnchorType, anchor_types
from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import refused
from catopt.loads.component import CALMAR, NAVFAC, LoadSource
from catopt.loads.drag_anchor import default_factor, holding_capacity
from catopt.loads.ship import SINKER_MASSES, NextSize, neighbours, next_size
from catopt.model.anchor import sinker_needed
from catopt.model.kinds import (
    Density,
    Findings,
    Mass,
    Measured,
    NotNegative,
    Positive,
    SomeForce,
    Strength,
)
from catopt.model.line import weight_in_water
from catopt.records import Record
from catopt.units import Dimension, as_written
from catopt.words import Message, term

Material = Literal["concrete", "concrete cast in place", "steel", "cast iron"]

DENSITIES: Final = MappingProxyType(
    {"concrete": 2400.0, "concrete cast in place": 2400.0, "steel": 7850.0, "cast iron": 7320.0}
)
"""kg/m3. Steel and cast iron: IALA CALMAR 7.2 (A). Concrete: recalled (R), for lack of another;
weigh yours. Concrete alone is precast: formed concrete, with the friction of that surface."""

SAFETY_FACTOR: Final = 1.5
"""On sliding, recommended by IALA (CALMAR 6.2.6, A)."""

FACTOR_SOURCE: Final = LoadSource(CALMAR, "6.2.6", "A")

_LAND = "a figure for foundations on land: soft mud is not covered"
_FORMED = LoadSource(NAVFAC, f"formed concrete; {_LAND}", "B")
_CAST = LoadSource(NAVFAC, f"mass concrete; {_LAND}", "A")
_STEEL = LoadSource(NAVFAC, f"steel; {_LAND}", "B")
_IRON = LoadSource(NAVFAC, f"steel, for want of a row of cast iron; {_LAND}", "C")
_MASONRY = LoadSource(NAVFAC, f"dressed hard rock on dressed hard rock; {_LAND}", "B")
_MASS_FOR_FORMED = LoadSource(NAVFAC, f"mass concrete, for want of formed concrete; {_LAND}", "A")
_CALMAR = LoadSource(CALMAR, "7.2, phi = 45 deg", "A")

Adhered = Annotated[float, Measured(Dimension.PRESSURE, above=0.0)]
_Range: TypeAlias = tuple[float, float]


@dataclass(frozen=True)
class SoilFriction:
    """Friction tan(delta) of a sinker on a soil: of each surface a range; the lower counts."""

    soil: str
    formed: _Range
    """Of precast concrete, the usual sinker."""
    cast: _Range
    """Of concrete cast in place on the soil."""
    steel: float | None
    """Of steel, and for want of a row of its own of cast iron; None where there is none."""
    source: LoadSource = _FORMED
    """Of the figures of formed concrete."""
    note: str = ""
    """Key of what else to know."""

    @property
    def low(self) -> float:
        """The lower figure of formed concrete."""
        return self.formed[0]

    @property
    def high(self) -> float:
        """The higher figure of formed concrete."""
        return self.formed[1]

    def of(self, material: Material) -> tuple[float, LoadSource] | None:
        """Give the lower figure of a material with its source; None where there is none."""
        if self.source is _CALMAR:  # its angle is that of any sinker
            return self.low, self.source
        if material in ("steel", "cast iron"):
            source = _STEEL if material == "steel" else _IRON
            return None if self.steel is None else (self.steel, source)
        if material == "concrete cast in place":
            return self.cast[0], _CAST
        return self.low, self.source


_TABLE: Final = (
    SoilFriction("clean sound rock", (0.55, 0.55), (0.70, 0.70), None, _MASONRY),
    SoilFriction("gravel or coarse sand", (0.40, 0.50), (0.55, 0.60), 0.40),
    SoilFriction("clean fine to medium sand", (0.30, 0.40), (0.45, 0.55), 0.30),
    SoilFriction("fine or silty sand", (0.30, 0.30), (0.35, 0.45), 0.25),
    SoilFriction("sandy silt", (0.25, 0.25), (0.30, 0.35), 0.20),
    SoilFriction("hard clay", (0.40, 0.50), (0.40, 0.50), None, _MASS_FOR_FORMED),
    SoilFriction("stiff clay", (0.30, 0.35), (0.30, 0.35), None, _MASS_FOR_FORMED),
    SoilFriction("IALA default", (1.0, 1.0), (1.0, 1.0), None, _CALMAR, "loads.optimistic"),
)

SOIL_FRICTION: Final = MappingProxyType({each.soil: each for each in _TABLE})
"""Soils by name."""


@dataclass(frozen=True)
class Adhesion:
    """What a clay holds of a sinker per area of its base, Pa; of each range the lower counts."""

    soil: str
    concrete: _Range
    steel: _Range
    source: LoadSource


_ADHESION: Final = LoadSource(NAVFAC, "adhesion in clay, as a book on soil properties has it", "C")

ADHESION: Final = MappingProxyType(
    {
        each.soil: each
        for each in (
            Adhesion("soft clay", (10e3, 35e3), (5e3, 30e3), _ADHESION),
            Adhesion("stiff clay", (35e3, 60e3), (30e3, 60e3), _ADHESION),
        )
    }
)
"""Clays by name."""

AS_CLAY: Final = MappingProxyType({"mud": "soft clay", "soft mud": "soft clay"})
"""Soils by names of practice; soft clay has the lowest figures."""

MUD: Final = (*AS_CLAY, "soft clay")
"""Soils that hold a sinker by adhesion, not by a share of its weight: no table has a friction."""


@dataclass(frozen=True, kw_only=True)
class SinkerSize(NextSize, Record):
    """A sinker that does not slide."""

    DOCUMENT = (
        "mass needed_mass smaller=smaller_mass_kg larger=larger_mass_kg material density "
        "submerged_weight friction friction_source.text=friction_source "
        "safety_factor=wanted_factor factor"
    )

    material: Material
    """Of what."""
    density: Density
    """Of its material."""
    friction: NotNegative
    """tan(delta) on the soil, a pure number."""
    friction_source: LoadSource | None
    """Where the friction is from; None for the user's own."""
    submerged_weight: SomeForce
    """In water."""
    vertical_force: float
    """Of the line on it, upwards, N."""
    notes: tuple[str, ...] = ()
    """What an engineer should know."""

    @property
    def rule(self) -> str:
        """Document of the rule that its friction is by; CALMAR's where that is the user's own."""
        return CALMAR if self.friction_source is None else self.friction_source.document

    @property
    def held(self) -> float:
        """Horizontal pull at which it slides, N."""
        return holding_force(self.submerged_weight, self.vertical_force, self.friction)


def holding_force(weight: float, vertical_force: float, friction: float) -> float:
    """Horizontal pull at which it slides, mu (W - V), N; 0 for one that is lifted.

    The weight W is in water; the vertical force V of the line is upwards.
    """
    return max(0.0, friction * (weight - vertical_force))


def friction_of(soil: str, material: Material = "concrete") -> tuple[float, LoadSource]:
    """Lower friction coefficient of a soil, a key of `SOIL_FRICTION`, with its source.

    A soil without a figure is refused. Mud and soft clay hold a sinker by adhesion on its base, not
    by a share of its weight (`adhesion_holding`): measure, and give a friction.
    """
    found = Findings("sinker")
    if soil in MUD:
        low, high = (f"{each / 1e3:g}" for each in ADHESION["soft clay"].concrete)
        found.add("soil", repr(soil), Message("loads.mud", low=low, high=high))
    elif soil not in SOIL_FRICTION:
        listed = "; ".join(SOIL_FRICTION)
        others = Message("refused_sizing.one_others_soft_mud_too", listed=listed)
        found.add("soil", repr(soil), others)
    check_material(found, material)
    of = SOIL_FRICTION[soil].of(material)
    if of is None:
        give = Message("refused_sizing.no_figure_on_give_friction", material=material)
        raise refused("soil", repr(soil), give, "sinker")
    return of


def adhesion_holding(
    soil: str, base_area: float, material: Material = "concrete"
) -> tuple[float, LoadSource]:
    """Horizontal pull that a clay holds by adhesion on the base of a sinker, N, with its source.

    The soil is a key of `ADHESION`, or mud; the area is in m2. Of the range printed the lower
    counts, times the area; neither the weight nor what the sinker sinks in adds to it.
    """
    found = Findings("sinker")
    name = AS_CLAY.get(soil, soil)
    if name not in ADHESION:
        clays = Message("refused_sizing.one_mud", adhesion=", ".join(ADHESION))
        found.add("soil", repr(soil), clays)
    found.number("base_area", base_area, "m^2", above=0.0)
    check_material(found, material)
    row = ADHESION[name]
    low, _ = row.steel if material in ("steel", "cast iron") else row.concrete
    return low * base_area, row.source


def size_sinker(
    horizontal_force: float,
    vertical_force: float = 0.0,
    *,
    soil: str | None = None,
    friction: float | None = None,
    material: Material = "concrete",
    density: float | None = None,
    safety_factor: float = SAFETY_FACTOR,
    water_density: float = SEA_WATER_DENSITY,
    series: Sequence[float] = SINKER_MASSES,
) -> SinkerSize:
    """Pick the next size that does not slide: mu (W - V) >= SF H, W in water.

    The forces are those of the line on the sinker, N, the vertical one upwards; the factor is on
    the horizontal one. Either a soil is given, a key of `SOIL_FRICTION`, or tan(delta) of one's
    own. The density, kg/m3, is that of `DENSITIES` when left out; the masses of the series rise,
    kg.

    Raises
    ------
    InputError, NoAnswerError
        For wrong input; when the largest of the series slides.
    """
    _check(horizontal_force, vertical_force, soil, friction, safety_factor)
    source: LoadSource | None = None
    if soil is not None:
        mu, source = friction_of(soil, material)
    else:
        assert friction is not None
        mu = friction
    if density is None:
        check_material(Findings("sinker"), material)
    rho = DENSITIES[material] if density is None else density
    found = Findings("sinker")
    found.number("water_density", water_density, "kg/m3", at_least=900.0, at_most=1100.0)
    found.number("density", rho, "kg/m3", at_most=20e3)
    if not found.problems and rho <= water_density:
        floats = Message("refused_sizing.floats_above_water_wanted")
        found.add("density", f"{rho:g} kg/m3", floats)
    found.raise_if_any()
    weight = sinker_needed(horizontal_force, vertical_force, mu, safety_factor)
    needed = weight / weight_in_water(1.0, rho, water_density)
    mass = next_size(needed, series, Message(_SINKERS[material]))
    smaller, larger = neighbours(mass, series)
    return SinkerSize(
        material=material,
        density=rho,
        friction=mu,
        friction_source=source,
        needed_mass=needed,
        mass=mass,
        smaller=smaller,
        larger=larger,
        submerged_weight=weight_in_water(mass, rho, water_density),
        horizontal_force=horizontal_force,
        vertical_force=vertical_force,
        safety_factor=safety_factor,
        notes=_notes(soil, material, density),
    )


_SINKERS: Final = {
    "concrete": "loads.concrete_sinker",
    "concrete cast in place": "loads.concrete_sinker",
    "steel": "loads.steel_sinker",
    "cast iron": "loads.iron_sinker",
}


def check_material(found: Findings, material: str) -> None:
    """Raise InputError for what was found, and for an unknown material."""
    if material not in DENSITIES:
        allowed = Message("refused.of_these", words=", ".join(DENSITIES))
        found.add("material", as_written(material), allowed)
    found.raise_if_any()


def _notes(soil: str | None, material: str, density: float | None) -> tuple[str, ...]:
    notes = []
    if soil is not None:
        row = SOIL_FRICTION[soil]
        notes.append(Message(row.note) if row.note else Message("loads.land", soil=term(soil)))
    if density is None and material.startswith("concrete"):
        notes.append(Message("loads.concrete"))
    return tuple(notes)


def _check(
    horizontal: float, vertical: float, soil: str | None, friction: float | None, factor: float
) -> None:
    found = Findings("sinker")
    found.number("horizontal_force", horizontal, "N", at_least=0.0)
    found.number("vertical_force", vertical, "N", at_least=0.0)
    found.number("safety_factor", factor, "", at_least=1.0)
    if (soil is None) == (friction is None):
        given = Message("refused_motion.neither" if soil is None else "refused_motion.both")
        found.add("soil", given, Message("refused_sizing.one_soil_friction_wanted"))
    if friction is not None:
        found.number("friction", friction, "", above=0.0, at_most=1.5)
    found.raise_if_any()


class HeldBy(NamedTuple):
    """What a data set has of an anchor."""

    data: str
    """Data set."""
    holding: Strength
    """Ultimate."""


@dataclass(frozen=True)
class AnchorHeld(Record):
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
    others: tuple[HeldBy, ...]
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
class SinkerHeld(Record):
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
    friction: Positive | None
    """tan(delta) on the weight in water; None where adhesion holds."""
    adhesion: Adhered | None
    """Of a clay, per area of the base; None where friction holds."""
    holding: SomeForce | None
    """Pull at which it slides; None where the area of the base is not known."""
    source: str
    """Of friction or adhesion."""
    confidence: Confidence
    """How well it was read."""
    safety_factor: Positive = SAFETY_FACTOR
    """On sliding."""

    @property
    def pull(self) -> SomeForce | None:
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
    raise refused("anchor", as_written(name), wanted, "catalogue")


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
        for each in ([soil] if soil else dict.fromkeys(of.soil for of in kind.holdings))
        for of in ([mass] if mass is not None else kind.masses)
    )


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
        others=tuple(HeldBy(*each) for each in capacity.others),
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
    weight = weight_in_water(mass, DENSITIES[material], water_density)
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
