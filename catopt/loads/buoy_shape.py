"""A buoy by its geometry: what it displaces, what it can still carry, what wind and water see."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Final

from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.model.kinds import Findings
from catopt.words import Message

CAST_IRON: Final = 7320.0
"""kg/m3, of ballast (CALMAR 7.2, A)."""

DRAG_COEFFICIENT: Final = 1.2
"""Of hull in water, hull in air, pylon, topmark and chain (CALMAR 7.2, A)."""

_ROUNDS: Final = 100
"""Of the search for a waterline, which stops long before: at the accuracy of a double."""


@dataclass(frozen=True)
class BuoySlice:
    """A truncated cone of a buoy, or a tapered part of its superstructure; lengths in m."""

    height: float
    lower: float
    """Outer diameter, or width, at its foot."""
    upper: float
    """The same at its top."""
    inner: float = 0.0
    """Diameter of the hole through it."""
    volume: float | None = None
    """That it displaces when it is under water, m3: spread over the height as that of the geometry
    is. None: that of the geometry."""

    def __post_init__(self) -> None:
        found = Findings("slice of a buoy")
        found.number("height", self.height, "m", above=0.0, at_most=60.0)
        found.numbers(self, "m", "lower", "upper", "inner", at_least=0.0, at_most=60.0)
        found.numbers(self, "m3", "volume", at_least=0.0, at_most=1e5)
        found.raise_if_any()
        narrow, wide = sorted((self.lower, self.upper))
        if self.volume is None and narrow < self.inner < wide:
            allowed = Message("refused_sizing.wider_than_one_end_narrower")
            found.add("inner", f"{self.inner:g} m", allowed)
        if self.volume and not wide:
            allowed = Message("refused_sizing.has_no_width_displace_water")
            found.add("volume", f"{self.volume:g} m3", allowed)
        found.raise_if_any()

    def _width(self, height: float) -> float:
        return self.lower + (self.upper - self.lower) * height / self.height

    @cached_property
    def _hole(self) -> float:
        """Square of the hole's diameter, as far as it is one through the whole slice, m2.

        Where a volume is stated and the hole is wider than an end, it is left out: a hull of plates
        is written so, and the outside alone says how its volume is spread.
        """
        narrow, wide = sorted((self.lower, self.upper))
        if self.inner >= wide and self.volume is None:
            return math.inf
        return self.inner**2 if self.inner < narrow else 0.0

    def _geometric(self, height: float) -> float:
        if self._hole == math.inf:
            return 0.0
        low, up = self.lower, self._width(height)
        return math.pi / 12.0 * height * (low**2 + low * up + up**2 - 3.0 * self._hole)

    @cached_property
    def _whole(self) -> float:
        """Volume of the geometry, m3."""
        return self._geometric(self.height)

    def displaced(self, level: float) -> float:
        """Volume below a level above its foot, m3."""
        below = self._geometric(min(max(level, 0.0), self.height))
        if not self.volume:
            return below if self.volume is None else 0.0
        return below / self._whole * self.volume

    def waterplane(self, level: float) -> float:
        """How much a metre more of water would displace at a level above its foot, m2."""
        if not 0.0 <= level < self.height or self._hole == math.inf:
            return 0.0
        area = 0.25 * math.pi * (self._width(level) ** 2 - self._hole)
        if not self.volume:
            return area if self.volume is None else 0.0
        return area / self._whole * self.volume

    def outline(self, low: float = 0.0, high: float = math.inf) -> float:
        """Area seen from the side between two levels above its foot, m2."""
        low, high = (min(max(each, 0.0), self.height) for each in (low, high))
        return 0.5 * (high - low) * (self._width(low) + self._width(high))


Stack = tuple[tuple[float, BuoySlice], ...]
"""Slices, each with the level of its foot above the hull's bottom, m."""


def _cylinder(height: float, diameter: float) -> BuoySlice:
    return BuoySlice(height, diameter, diameter)


def _stacked(slices: tuple[BuoySlice, ...], foot: float) -> Iterator[tuple[float, BuoySlice]]:
    for each in slices:
        yield foot, each
        foot += each.height


@dataclass(frozen=True)
class BuoyShape:
    """A buoy as stacks of truncated cones: a hull, and a structure below, through or above it.

    In short, an upright cylinder with, if any, a closed tail tube below: `hull_diameter`,
    `hull_depth`, `tube_diameter` and `tube_length` stand for the stacks. Lengths in m; the tail
    tube has none where there is none.
    """

    name: str
    hull_diameter: float = 0.0
    hull_depth: float = 0.0
    """From bottom to deck."""
    mass: float = 0.0
    """With everything on it but ballast, without the mooring, kg."""
    least_freeboard: float = 0.0
    """That the mooring must leave."""
    tower_height: float = 0.0
    tower_width: float = 0.0
    """Of the tower's outline above the deck."""
    tower_solidity: float = 1.0
    """Share of the outline that stops the wind, 0 to 1."""
    topmark_area: float = 0.0
    """Of topmark, lantern and radar reflector as the wind sees them, m2."""
    tube_diameter: float = 0.0
    tube_length: float = 0.0
    centre_of_gravity: float | None = None
    """Above the bottom of the hull, with everything on it but the mooring, m; None: as if the mass
    were spread over what displaces, with the ballast at the lowest point."""
    origin: str = "the user's own"
    """Whose geometry this is."""
    hull: tuple[BuoySlice, ...] = ()
    """From the bottom upwards, as is the structure."""
    structure: tuple[BuoySlice, ...] = ()
    structure_depth: float = 0.0
    """Of the structure's foot below the hull's bottom; below 0 it stands higher."""
    eye_offset: float = 0.0
    """Of the mooring eye below the hull's bottom; a tail tube of the short form has it at its
    foot."""
    pylons: tuple[BuoySlice, ...] = ()
    """As the wind sees them, beside the tower."""
    topmarks: tuple[BuoySlice, ...] = ()
    """The same, beside `topmark_area`."""
    ballast_mass: float = 0.0
    """Of one piece, kg."""
    ballast_pieces: int = 0
    ballast_density: float = CAST_IRON
    """kg/m3: ballast hangs in the water and loses its buoyancy."""
    drag_in_water: float = DRAG_COEFFICIENT
    """Of the hull, on its area from the side."""
    drag_in_air: float = DRAG_COEFFICIENT
    """Of hull, tower and topmark."""
    chain_min: float | None = None
    """Smallest and largest chain that the buoy is made for, nominal; None: not known."""
    chain_max: float | None = None
    chain_source: str = ""
    """Whose limits of the chain these are, where the origin does not say it."""
    generic: bool = False
    """Whether it is no product but of catopt's own proportions."""

    def __post_init__(self) -> None:
        found = Findings(f"buoy {self.name}".rstrip())
        self._check_form(found)
        found.number("mass", self.mass, "kg", above=0.0, at_most=1e7)
        for key in ("least_freeboard", "tower_height", "tower_width"):
            found.number(key, getattr(self, key), "m", at_least=0.0)
        found.number("tower_solidity", self.tower_solidity, "", at_least=0.0, at_most=1.0)
        found.number("topmark_area", self.topmark_area, "m2", at_least=0.0)
        for key in ("tube_diameter", "tube_length"):
            found.number(key, getattr(self, key), "m", at_least=0.0, at_most=60.0)
        for key in ("structure_depth", "eye_offset"):
            found.number(key, getattr(self, key), "m", at_least=-60.0, at_most=60.0)
        found.number("ballast_mass", self.ballast_mass, "kg", at_least=0.0, at_most=1e6)
        found.number("ballast_pieces", self.ballast_pieces, "", at_least=0, at_most=1000)
        if self.ballast_pieces != int(self.ballast_pieces or 0):
            found.add("ballast_pieces", f"{self.ballast_pieces!r}", Message("refused.whole"))
        found.number("ballast_density", self.ballast_density, "kg/m3", above=1100.0, at_most=2e4)
        for key in ("drag_in_water", "drag_in_air"):
            found.number(key, getattr(self, key), "", above=0.0, at_most=5.0)
        found.numbers(self, "m", "chain_min", "chain_max", above=0.0, at_most=0.2)
        if not found.problems:
            self._check_together(found)
        found.raise_if_any()

    def _check_form(self, found: Findings) -> None:
        """Note what is wrong with the hull: it is a stack, or the cylinder in short."""
        if not self.hull:
            found.number("hull_diameter", self.hull_diameter, "m", at_least=0.1, at_most=30.0)
            found.number("hull_depth", self.hull_depth, "m", at_least=0.1, at_most=60.0)
            allowed = Message("refused_sizing.belongs_hull_slices_which_missing")
            for key in ("structure", "structure_depth", "eye_offset"):
                if value := getattr(self, key):
                    found.add(key, f"{value!r}", allowed)
            return
        for key in ("hull_diameter", "hull_depth", "tube_diameter", "tube_length"):
            if value := getattr(self, key):
                found.add(key, f"{value!r}", Message("refused_sizing.leave_out_hull_given_by"))

    def _check_together(self, found: Findings) -> None:
        if self.chain_min and self.chain_max and self.chain_max < self.chain_min:
            allowed = Message("refused_sizing.not_below_chain_min_m", chain_min=self.chain_min)
            found.add("chain_max", f"{self.chain_max:g} m", allowed)
        if not self.hull and self.tube_diameter > self.hull_diameter:
            wide = Message("refused_sizing.wider_than_hull")
            found.add("tube_diameter", f"{self.tube_diameter:g} m", wide)
        draught = self._draught(SEA_WATER_DENSITY, 0.0)
        freeboard = self.deck - draught
        if draught <= 0.0:
            light = Message("refused_sizing.less_than_what_below_hull")
            found.add("mass", f"{self.mass:g} kg", light)
        elif freeboard <= self.least_freeboard:
            most = SEA_WATER_DENSITY * self.displaced_at(self.least_freeboard)
            heavy = Message(
                "refused_sizing.floats_without_mooring_with_freeboard",
                freeboard=freeboard,
                least_freeboard=self.least_freeboard,
                most=most - self.ballast,
            )
            found.add("mass", f"{self.mass:g} kg", heavy)

    # ---------------------------------------------------------------- stacks

    @cached_property
    def _hull(self) -> Stack:
        short = () if self.hull else (_cylinder(self.hull_depth, self.hull_diameter),)
        return tuple(_stacked(self.hull or short, 0.0))

    @cached_property
    def _structure(self) -> Stack:
        if self.hull:
            return tuple(_stacked(self.structure, -self.structure_depth))
        if not self.tube_length:
            return ()
        return ((-self.tube_length, _cylinder(self.tube_length, self.tube_diameter)),)

    @property
    def stacks(self) -> tuple[Stack, Stack]:
        """Hull, and structure."""
        return self._hull, self._structure

    @cached_property
    def _slices(self) -> Stack:
        return (*self._hull, *self._structure)

    @property
    def parts(self) -> Stack:
        """What is seen of it from the side, each with the level of its foot above the hull's."""
        tower = _cylinder(self.tower_height, self.tower_width) if self.tower_height else None
        above = self.pylons or (() if tower is None else (tower,))
        return (*self._structure, *self._hull, *_stacked(above, self.deck))

    @cached_property
    def deck(self) -> float:
        """Level of the hull's top above its bottom, m."""
        foot, top = self._hull[-1]
        return foot + top.height

    @cached_property
    def lowest(self) -> float:
        """Level of the lowest point above the hull's bottom, m: 0 or below."""
        return min([0.0, *(foot for foot, _ in self._structure)])

    @cached_property
    def widest(self) -> float:
        """Largest diameter of the hull, m: what a buoy's size is called by."""
        return max(max(each.lower, each.upper) for _, each in self._hull)

    @property
    def eye(self) -> float:
        """Level of the mooring eye above the hull's bottom, m."""
        return -self.eye_offset if self.hull else self.lowest

    def volume_below(self, level: float) -> float:
        """Volume of hull and structure below a level above the hull's bottom, m3."""
        return math.fsum(each.displaced(level - foot) for foot, each in self._slices)

    @cached_property
    def volume(self) -> float:
        """Volume of hull and structure, m3."""
        return self.volume_below(math.inf)

    def waterplane_at(self, level: float) -> float:
        """Area of the waterline at a level above the hull's bottom, m2."""
        return math.fsum(each.waterplane(level - foot) for foot, each in self._slices)

    def outline(self, low: float = -math.inf, high: float = math.inf) -> float:
        """Area of hull and structure from the side between two levels, m2.

        What of the structure is inside the hull counts too, as CALMAR's printed results have it.
        """
        return math.fsum(each.outline(low - foot, high - foot) for foot, each in self._slices)

    # ---------------------------------------------------------------- afloat

    @property
    def ballast(self) -> float:
        """Mass of the ballast, kg."""
        return self.ballast_mass * self.ballast_pieces

    @property
    def total_mass(self) -> float:
        """With everything on it and with ballast, without the mooring, kg."""
        return self.mass + self.ballast

    def displaced_at(self, freeboard: float) -> float:
        """Volume of hull, structure and ballast in the water at a freeboard, m; m3."""
        return self.volume_below(self.deck - freeboard) + self.ballast / self.ballast_density

    @property
    def waterplane_area(self) -> float:
        """Area of the waterline, afloat without a mooring, m2."""
        return self.afloat().waterplane_area

    @property
    def tube_volume(self) -> float:
        """That the tail tube displaces, m3."""
        return 0.25 * math.pi * self.tube_diameter**2 * self.tube_length

    @property
    def tower_area(self) -> float:
        """Of tower and pylons, as the wind sees them, m2."""
        tower = self.tower_height * self.tower_width * self.tower_solidity
        return math.fsum((tower, *(each.outline() for each in self.pylons)))

    @property
    def marks_area(self) -> float:
        """Of all topmarks, as the wind sees them, m2."""
        return math.fsum((self.topmark_area, *(each.outline() for each in self.topmarks)))

    def _draught(self, water_density: float, pull: float) -> float:
        """Level of the water above the hull's bottom at which it floats, m."""
        mass = self.total_mass + pull / STANDARD_GRAVITY
        return self._level(mass / water_density - self.ballast / self.ballast_density)

    @cached_property
    def _table(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Levels of all ends of slices, rising, and the volume below each."""
        ends = sorted({foot + h for foot, each in self._slices for h in (0.0, each.height)})
        return tuple(ends), tuple(map(self.volume_below, ends))

    def _level(self, volume: float) -> float:
        """Level below which hull and structure have a volume, m: by Newton's steps in a bracket."""
        ends, volumes = self._table
        above = bisect_left(volumes, volume)
        low, high = ends[max(above - 1, 0)], ends[min(above, len(ends) - 1)]
        level = low
        for _ in range(_ROUNDS):
            over = self.volume_below(level) - volume
            low, high = (low, min(high, level)) if over > 0.0 else (max(low, level), high)
            area = self.waterplane_at(level)
            step = level - over / area if area > 0.0 else math.nan
            new = step if low <= step <= high else 0.5 * (low + high)
            if abs(new - level) <= 4e-16 * max(1.0, abs(level)):
                return new
            level = new
        return level

    def reserve_buoyancy(self, water_density: float = SEA_WATER_DENSITY) -> float:
        """Vertical pull that leaves it its least freeboard, N: rho g (volume up to that) - m g."""
        most = water_density * self.displaced_at(self.least_freeboard)
        return STANDARD_GRAVITY * (most - self.total_mass)

    def afloat(self, pull: float = 0.0, water_density: float = SEA_WATER_DENSITY) -> Floating:
        """Float it under the vertical pull of its mooring, N, downwards; the density in kg/m3.

        InputError: the pull is above the reserve buoyancy.
        """
        found = Findings(f"buoy {self.name}".rstrip())
        found.number("pull", pull, "N", at_least=0.0)
        found.number("water_density", water_density, "kg/m3", at_least=900.0, at_most=1100.0)
        found.raise_if_any()
        reserve = self.reserve_buoyancy(water_density)
        if pull > reserve:
            values = {"reserve": reserve / 1e3, "freeboard": self.least_freeboard}
            found.add("pull", f"{pull / 1e3:.3g} kN", Message("loads.above_reserve", **values))
        found.raise_if_any()
        draught = self._draught(water_density, pull)
        if draught <= 0.0:
            clear = Message("refused_sizing.hull_floats_clear")
            found.add("water_density", f"{water_density:g} kg/m3", clear)
        found.raise_if_any()
        return Floating(self, pull, water_density, draught)


@dataclass(frozen=True)
class Floating:
    """A buoy afloat: the pull of its mooring is downwards (N), the draught is the hull's (m)."""

    shape: BuoyShape
    pull: float
    water_density: float
    draught: float

    @property
    def freeboard(self) -> float:
        """From the water to the deck, m."""
        return self.shape.deck - self.draught

    @property
    def keel_depth(self) -> float:
        """From the water to the lowest point, m."""
        return self.draught - self.shape.lowest

    @property
    def eye_depth(self) -> float:
        """From the water to the mooring eye, where the chain is made fast, m."""
        return self.draught - self.shape.eye

    @property
    def volume(self) -> float:
        """Of hull and structure under water, m3."""
        return self.shape.volume_below(self.draught)

    @property
    def displacement(self) -> float:
        """Mass of the water displaced by hull, structure and ballast, kg."""
        return self.water_density * self.shape.displaced_at(self.freeboard)

    @property
    def reserve_share(self) -> float:
        """Share of the volume of hull and structure that is not under water (CALMAR 8.1.9)."""
        return 1.0 - self.volume / self.shape.volume

    @property
    def waterplane_area(self) -> float:
        """Area of the waterline, m2."""
        return self.shape.waterplane_at(self.draught)

    def hull_area_in_water(self, growth: float = 0.0) -> float:
        """Seen by the current: hull and structure, m2, with a marine growth (m) all round."""
        return self.shape.outline(high=self.draught) + 2.0 * growth * self.keel_depth

    @property
    def hull_area_in_air(self) -> float:
        """Of hull and structure, seen by the wind, m2."""
        return self.shape.outline(low=self.draught)

    @property
    def windage(self) -> float:
        """Hull, tower and topmarks, seen by the wind, m2."""
        return self.hull_area_in_air + self.shape.tower_area + self.shape.marks_area
