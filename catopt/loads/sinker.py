"""What sinkers and anchors hold."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Annotated, Final, Literal, TypeAlias

from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import NoAnswerError, refused
from catopt.loads.component import CALMAR, NAVFAC, LoadSource
from catopt.loads.ship import SINKER_MASSES, NextSize, neighbours, next_size
from catopt.model.anchor import sinker_needed
from catopt.model.kinds import (
    Area,
    Density,
    Findings,
    Length,
    Measured,
    NotNegative,
    SomeForce,
)
from catopt.model.line import weight_in_water
from catopt.records import Record
from catopt.units import Dimension, as_written
from catopt.words import Message, term, typed_name

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

AS_CLAY: Final = MappingProxyType(
    dict.fromkeys(("mud", "soft mud", "clay", "bùn", "sét"), "soft clay")
)
"""Soils by names of practice; soft clay has the lowest figures."""

_WEAKEST: Final = MappingProxyType(
    {
        **AS_CLAY,
        **dict.fromkeys(("sand", "cát"), "fine or silty sand"),
        **dict.fromkeys(("silt", "bụi"), "sandy silt"),
        **dict.fromkeys(("gravel", "sỏi"), "gravel or coarse sand"),
        **dict.fromkeys(("rock", "đá"), "clean sound rock"),
    }
)
"""Of a kind of soil that is named alone the weakest that has figures."""

_NO_FRICTION: Final = "sandy silt"
"""Whose friction, the lowest of all, stands in for that of a clay that has none."""

_LOWEST: Final = "of sandy silt, the lowest that it has, for want of one of soft clay"

PROPORTION: Final = 0.5
"""Height of a cast sinker over the side of its square base: recalled (R) of concrete sinkers of the
United States Coast Guard; it counts only where adhesion holds and no base is given."""


def soil_named(word: str) -> str:
    """Name the soil that a word of practice stands for: of a kind the weakest; else itself.

    >>> soil_named("sand"), soil_named("Mud"), soil_named("hard clay")
    ('fine or silty sand', 'soft clay', 'hard clay')
    """
    english = typed_name(word)
    return _WEAKEST.get(english.strip().casefold(), english)


@dataclass(frozen=True)
class Bond:
    """What a clay holds of sinkers on their bases, whatever they weigh.

    Adhesion times the area of the base and, of a block that has sunk in, of the two sides along
    the pull. catopt's own: neither what it pushes before it nor the soil's gain of strength counts.
    """

    adhesion: float
    """Pa."""
    source: LoadSource
    base_area: float | None = None
    """m2; None: that of a cast block of each mass, `PROPORTION`."""
    embedment: float = 0.0
    """m: how deep it has sunk in."""

    def holding(self, mass: float, density: float) -> float:
        """Horizontal pull that a sinker of a mass (kg) holds by it, N."""
        area = base_of(mass, density) if self.base_area is None else self.base_area
        depth = min(self.embedment, mass / (density * area))
        return self.adhesion * (area + 2.0 * math.sqrt(area) * depth)

    def mass(self, pull: float, density: float) -> float:
        """Least mass that holds a pull (N) by it, kg; infinite where no mass does."""
        wanted = pull / self.adhesion
        if self.base_area is not None:
            side = math.sqrt(self.base_area)
            depth = max(0.0, wanted - self.base_area) / (2.0 * side)
            return density * self.base_area * depth if depth <= self.embedment else math.inf
        # The side of a block that has sunk in by less than its height, or else wholly.
        side = math.sqrt(wanted + self.embedment**2) - self.embedment
        if PROPORTION * side < self.embedment:
            side = math.sqrt(wanted / (1.0 + 2.0 * PROPORTION))
        return density * PROPORTION * side**3


def base_of(mass: float, density: float) -> float:
    """Area of the square base of a cast block, m2: its height is half the side."""
    return float((mass / (density * PROPORTION)) ** (2.0 / 3.0))


@dataclass(frozen=True, kw_only=True)
class SinkerSize(NextSize, Record):
    """A sinker that does not slide."""

    DOCUMENT = (
        "mass needed_mass smaller=smaller_mass_kg larger=larger_mass_kg material density "
        "submerged_weight friction friction_source.text=friction_source "
        "safety_factor=wanted_factor factor soil base_area side height is_base_given "
        "bond.adhesion=adhesion_Pa bond.source.text=adhesion_source bond.embedment=embedment_m "
        "base_holding"
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
    soil: str | None = None
    """That it lies on; None where its friction is the user's own."""
    given_base: float | None = None
    """Area of its base, m2, where that is given."""
    bond: Bond | None = None
    """Of a clay, which holds no more than that on its base; None where friction alone holds."""
    notes: tuple[str, ...] = ()
    """What an engineer should know."""

    @property
    def rule(self) -> str:
        """Document of the rule that its friction is by; CALMAR's where that is the user's own."""
        return CALMAR if self.friction_source is None else self.friction_source.document

    @property
    def is_base_given(self) -> bool:
        """Whether its base is given, not that of a cast block."""
        return self.given_base is not None

    @property
    def base_area(self) -> Area:
        """Of its base: as given, or of a cast block."""
        return base_of(self.mass, self.density) if self.given_base is None else self.given_base

    @property
    def side(self) -> Length:
        """Of its square base."""
        return math.sqrt(self.base_area)

    @property
    def height(self) -> Length:
        """Of the block."""
        return self.mass / (self.density * self.base_area)

    @property
    def base_holding(self) -> SomeForce | None:
        """Horizontal pull that a clay holds on its base; None where friction alone holds."""
        return None if self.bond is None else self.bond.holding(self.mass, self.density)

    @property
    def held(self) -> float:
        """Horizontal pull at which it slides, N."""
        by_weight = holding_force(self.submerged_weight, self.vertical_force, self.friction)
        base = self.base_holding
        return by_weight if base is None else min(by_weight, base)


def holding_force(weight: float, vertical_force: float, friction: float) -> float:
    """Horizontal pull at which it slides, mu (W - V), N; 0 for one that is lifted.

    The weight W is in water; the vertical force V of the line is upwards.
    """
    return max(0.0, friction * (weight - vertical_force))


def friction_of(soil: str, material: Material = "concrete") -> tuple[float, LoadSource]:
    """Lower friction coefficient of a soil, with its source.

    A key of `SOIL_FRICTION` or a word of practice (`soil_named`); another is refused. Of soft clay
    no table has one: it takes the lowest, that of sandy silt, and no more than adhesion holds on
    the base (`bond_of`).
    """
    name, found = soil_named(soil), Findings("sinker")
    is_clay = name in ADHESION and name not in SOIL_FRICTION
    if not is_clay and name not in SOIL_FRICTION:
        listed = "; ".join((*SOIL_FRICTION, *(each for each in _WEAKEST if each.isascii())))
        others = Message("refused_sizing.one_others_give_friction", listed=listed)
        found.add("soil", repr(soil), others)
    check_material(found, material)
    of = SOIL_FRICTION[_NO_FRICTION if is_clay else name].of(material)
    if of is None:
        give = Message("refused_sizing.no_figure_on_give_friction", material=material)
        raise refused("soil", repr(soil), give, "sinker")
    mu, source = of
    if not is_clay:
        return of
    return mu, replace(source, clause=f"{source.clause}; {_LOWEST}", confidence="C")


def bond_of(
    soil: str | None,
    material: Material = "concrete",
    base_area: float | None = None,
    embedment: float = 0.0,
) -> Bond | None:
    """Return what a clay holds of sinkers on their bases; None of any other soil.

    Refused: an embedment on what is no clay.
    """
    name = None if soil is None else soil_named(soil)
    if name is None or name not in ADHESION:
        if embedment:
            allowed = Message("refused_sizing.embedment_in_clay", clays=", ".join(ADHESION))
            raise refused("embedment", f"{embedment:g} m", allowed, "sinker")
        return None
    adhesion, source = adhesion_holding(name, 1.0, material)
    return Bond(adhesion, source, base_area, embedment)


def adhesion_holding(
    soil: str, base_area: float, material: Material = "concrete"
) -> tuple[float, LoadSource]:
    """Horizontal pull that a clay holds by adhesion on the base of a sinker, N, with its source.

    The soil is a key of `ADHESION`, or mud; the area is in m2. Of the range printed the lower
    counts, times the area; neither the weight nor what the sinker sinks in adds to it.
    """
    found = Findings("sinker")
    name = soil_named(soil)
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
    base_area: float | None = None,
    embedment: float = 0.0,
    safety_factor: float = SAFETY_FACTOR,
    water_density: float = SEA_WATER_DENSITY,
    series: Sequence[float] = SINKER_MASSES,
) -> SinkerSize:
    """Pick the next size that does not slide: mu (W - V) >= SF H, W in water.

    On a clay that has an adhesion its base has to hold SF H, too (`Bond`). The forces are those of
    the line on the sinker, N, the vertical one upwards; the factor is on the horizontal one.
    Either a soil is given, a key of `SOIL_FRICTION` or a word of practice (`soil_named`), or
    tan(delta) of one's own. The density, kg/m3, is that of `DENSITIES` when left out, the base,
    m2, that of a cast block; the embedment, m, is how deep it has sunk into a clay; the masses of
    the series rise, kg.

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
    found.number("embedment", embedment, "m", at_least=0.0, at_most=10.0)
    if base_area is not None:
        found.number("base_area", base_area, "m^2", above=0.0)
    if not found.problems and rho <= water_density:
        floats = Message("refused_sizing.floats_above_water_wanted")
        found.add("density", f"{rho:g} kg/m3", floats)
    found.raise_if_any()
    weight = sinker_needed(horizontal_force, vertical_force, mu, safety_factor)
    needed = weight / weight_in_water(1.0, rho, water_density)
    bond = bond_of(soil, material, base_area, embedment)
    if bond is not None:
        by_base = bond.mass(safety_factor * horizontal_force, rho)
        if math.isinf(by_base):
            values = {"area": bond.base_area, "adhesion": bond.adhesion / 1e3}
            pull = safety_factor * horizontal_force
            values |= {"pull": pull / 1e3, "wanted": pull / bond.adhesion}
            raise NoAnswerError(Message("loads.base_too_small", **values))
        needed = max(needed, by_base)
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
        soil=None if soil is None else soil_named(soil),
        given_base=base_area,
        bond=bond,
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
        name = soil_named(soil)
        row, key = SOIL_FRICTION.get(name), "loads.land"
        if row is None:
            key = "loads.lowest_friction"
        notes.append(Message(row.note) if row and row.note else Message(key, soil=term(name)))
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
