"""The body that lines moor: its inertia and what pushes it, what it carries, how it floats."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from catopt.model.kinds import (
    Coefficient,
    File,
    Length,
    Mass,
    Measured,
    NotNegative,
    Place,
    Size,
    SomeMass,
    SomeSpeed,
    Source,
    Strength,
    Weight,
)
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


@dataclass(frozen=True)
class Floater(Checked):
    """A buoy that floats at the upper end of its line and moves with it, in the line's plane.

    Surge, heave and pitch; waves and current go along x, from the anchor to the fairlead, or
    against it. `load` and the line's `fairlead_height` are for the answers at rest.
    """

    buoy: Source
    """Name of the buoy, of the library or of `file`."""
    file: Annotated[str, File(example='"buoys.toml"')] = ""
    """Path of a file of buoys of one's own; empty when not used."""
    wind_speed: SomeSpeed = 0.0
    """That blows along x, m/s; its drag is the buoy's own in air."""
    centre_of_gravity: Place | None = None
    """Height above the bottom of the hull, m; None: that of its hull and structure, as if their
    mass were spread over what they displace, with the ballast at the lowest point."""
    pitch_radius: Length | None = None
    """Radius of gyration about it, m; None: likewise."""
    pitch_damping: NotNegative | None = None
    """Of what else damps the pitch than waves and the drag of the slices, as a part of critical;
    None: not known, and then nothing."""
    heave_drag: Coefficient = 1.0
    """Drag coefficient along the axis, on the widest section."""
