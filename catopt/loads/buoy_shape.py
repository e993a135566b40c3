"""A buoy by its geometry: what it displaces, what it can still carry, what wind and water see."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.model.validity import Findings
from catopt.words import Message


@dataclass(frozen=True)
class BuoyShape:
    """A buoy: an upright cylinder with, if any, a closed tail tube below and a tower above.

    Lengths in m; the tail tube has none where there is none.
    """

    name: str
    hull_diameter: float
    hull_depth: float
    """From bottom to deck."""
    mass: float
    """With everything on it, without the mooring, kg."""
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
    origin: str = "the user's own"
    """Whose geometry this is."""

    def __post_init__(self) -> None:
        found = Findings(f"buoy {self.name}".rstrip())
        found.number("hull_diameter", self.hull_diameter, "m", at_least=0.1, at_most=30.0)
        found.number("hull_depth", self.hull_depth, "m", at_least=0.1, at_most=60.0)
        found.number("mass", self.mass, "kg", above=0.0, at_most=1e7)
        for key in ("least_freeboard", "tower_height", "tower_width"):
            found.number(key, getattr(self, key), "m", at_least=0.0)
        found.number("tower_solidity", self.tower_solidity, "", at_least=0.0, at_most=1.0)
        found.number("topmark_area", self.topmark_area, "m2", at_least=0.0)
        for key in ("tube_diameter", "tube_length"):
            found.number(key, getattr(self, key), "m", at_least=0.0, at_most=60.0)
        if not found.problems:
            self._check_floats(found)
        found.raise_if_any()

    def _check_floats(self, found: Findings) -> None:
        if self.tube_diameter > self.hull_diameter:
            found.add("tube_diameter", f"{self.tube_diameter:g} m", "wider than the hull")
        draught = self._draught(SEA_WATER_DENSITY, 0.0)
        if draught <= 0.0:
            light = "less than its tail tube displaces: the hull would float above the water"
            found.add("mass", f"{self.mass:g} kg", light)
        elif self.hull_depth - draught <= self.least_freeboard:
            heavy = (
                f"floats, without a mooring, with a freeboard of {self.hull_depth - draught:.2f} m,"
                f" not above the least one of {self.least_freeboard:g} m: "
                f"below {SEA_WATER_DENSITY * self._most_volume:.0f} kg"
            )
            found.add("mass", f"{self.mass:g} kg", heavy)

    @property
    def _most_volume(self) -> float:
        """Displaced at the least freeboard, m3."""
        depth = self.hull_depth - self.least_freeboard
        return self.tube_volume + depth * self.waterplane_area

    @property
    def waterplane_area(self) -> float:
        """Area of the waterline, pi D^2/4, m2."""
        return 0.25 * math.pi * self.hull_diameter**2

    @property
    def tube_volume(self) -> float:
        """That the tail tube displaces, m3."""
        return 0.25 * math.pi * self.tube_diameter**2 * self.tube_length

    @property
    def tower_area(self) -> float:
        """Of the tower, as the wind sees it, m2."""
        return self.tower_height * self.tower_width * self.tower_solidity

    def _draught(self, water_density: float, pull: float) -> float:
        volume = (self.mass + pull / STANDARD_GRAVITY) / water_density
        return (volume - self.tube_volume) / self.waterplane_area

    def reserve_buoyancy(self, water_density: float = SEA_WATER_DENSITY) -> float:
        """Vertical pull that leaves it its least freeboard, N: rho g (volume up to that) - m g."""
        return STANDARD_GRAVITY * (water_density * self._most_volume - self.mass)

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
            found.add("water_density", f"{water_density:g} kg/m3", "its hull floats clear of it")
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
        return self.shape.hull_depth - self.draught

    @property
    def keel_depth(self) -> float:
        """From the water to the lowest point, where the chain is made fast, m."""
        return self.draught + self.shape.tube_length

    @property
    def displacement(self) -> float:
        """Mass of the water displaced, kg."""
        volume = self.shape.tube_volume + self.draught * self.shape.waterplane_area
        return self.water_density * volume

    def hull_area_in_water(self, growth: float = 0.0) -> float:
        """Seen by the current: hull and tail tube, m2, with a marine growth (m) all round."""
        tube = self.shape.tube_length * (self.shape.tube_diameter + 2.0 * growth)
        hull = self.draught * (self.shape.hull_diameter + 2.0 * growth)
        return hull + tube if self.shape.tube_length > 0.0 else hull

    @property
    def hull_area_in_air(self) -> float:
        """Of the hull, seen by the wind, m2."""
        return self.freeboard * self.shape.hull_diameter

    @property
    def windage(self) -> float:
        """Hull, tower and topmark, seen by the wind, m2."""
        return self.hull_area_in_air + self.shape.tower_area + self.shape.topmark_area
