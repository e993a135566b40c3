"""The body that lines moor: its inertia and what pushes it, or what a buoy can carry."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from catopt.model.kinds import File, Mass, Measured, Size, SomeMass, Strength, Weight
from catopt.model.validity import Checked
from catopt.units import Dimension


@dataclass(frozen=True)
class Buoy(Checked):
    """A buoy, as far as the line minds it."""

    reserve_buoyancy: Strength
    """Vertical pull that takes it to its allowed draught, N."""


@dataclass(frozen=True)
class Body(Checked):
    """A body that moves along x and y, held in height and in the yaw that it has at rest.

    The mean of the forces is that of the system; what is here comes on top of it.
    """

    mass: Mass
    """kg."""
    added_mass: SomeMass = 0.0
    """Of the water that moves with it, along x and y alike, kg."""
    damping: Annotated[float, Measured(Dimension.DAMPING, at_least=0.0)] = 0.0
    """Force per speed, along x and y alike, N s/m."""
    force_file: Annotated[str, File(example='"force.csv"')] = ""
    """Path of a CSV file with the forces over time; empty when not used."""
    wave_force: Annotated[tuple[Weight, ...], Size(2, 2)] = ()
    """Force along x and y per height of the waves' surface over still water at the body, N/m; empty
    for none."""
