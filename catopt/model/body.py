"""The body that lines moor: its inertia and what pushes it, what it carries, how it floats."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, fields
from typing import Annotated, Final, Literal

from catopt.errors import Problem
from catopt.model.kinds import (
    Angle,
    Area,
    Checked,
    Coefficient,
    File,
    Findings,
    Length,
    Mass,
    Measured,
    NotNegative,
    Place,
    Share,
    Size,
    SomeMass,
    SomeSpeed,
    Source,
    Strength,
    Time,
    Weight,
)
from catopt.units import Dimension
from catopt.words import Message


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
class ShipAfloat(Checked):
    """A ship, an FSO or a barge on its lines, by its main dimensions.

    Its x axis points forwards. It turns about the origin of the system where no fairlead lies off
    it (a turret), else its x axis lies along that of the system at rest without load.
    """

    length: Length
    """Over all, m."""
    breadth: Length
    draught: Length
    moulded_depth: Length
    """From deck to keel, m."""
    condition: Literal["loaded", "ballast"] = "loaded"
    """For the block coefficient and the wind's coefficients."""
    mooring_point: Place = 0.0
    """Of the origin of the system, m forward of midships."""
    displacement: Mass | None = None
    """kg; None: by the block coefficient of the condition."""
    frontal_area: Area | None = None
    lateral_area: Area | None = None
    """Above water, m2; None: estimated."""
    wind_direction: Angle = 0.0
    """Where the wind blows to, rad from the x axis."""
    gusts: Literal["NPD", "none"] = "NPD"
    """Spectrum of the wind's speed."""
    current_yaw: Literal["", "series-60", "FFG"] = ""
    """Hull by whose figures, which are recalled, the current turns the ship; empty: it acts
    amidships."""
    reflection: Share | None = None
    """Part of the height of every wave that the hull reflects, for the drift; None: of each wave
    the energy that flows above the keel."""
    drift_file: Annotated[str, File(example='"ship.8"')] = ""
    """Path of WAMIT's .8 file with the mean drift; empty: by `reflection`."""
    ulen: Length | None = None
    """The length ULEN of that file, m."""
    surge_damping: NotNegative = 0.05
    sway_damping: NotNegative = 0.05
    yaw_damping: NotNegative = 0.05
    """Linear, of slow motions beyond the drag of current and wind, as a part of critical."""
    roll_period: Time | None = None
    """Natural period, s; None: it does not roll."""
    roll_damping: Annotated[float, Measured(Dimension.NUMBER, above=0.0, at_most=1.0)] = 0.05
    """As a part of critical."""

    def _check(self, found: Findings) -> None:
        found.check()
        found.problems += ship_misfits([key for key in _OF_DRIFT if getattr(self, key)])


HEAVE_DRAG: Final = 1.0
_OF_DRIFT: Final = ("drift_file", "ulen")
_OF_A_BUOY: Final = ("file", "centre_of_gravity", "pitch_radius", "pitch_damping", "heave_drag")


def ship_misfits(given: Collection[str]) -> list[Problem]:
    """List what is missing of a ship's drift file and the length that goes with it."""
    lacks = [key for key in _OF_DRIFT if key not in given]
    if len(lacks) != 1:
        return []
    return [Problem(lacks[0], "", Message("refused_case.drift_file_and_ulen"))]


def floater_misfits(given: Mapping[str, object]) -> list[Problem]:
    """List what does not go together in what floats: of its keys, those that are given."""
    if ("buoy" in given) == ("ship" in given):
        wanted = Message("refused.exactly_one", ways="buoy, ship")
        if "buoy" in given:
            return [Problem("ship", Message("refused_case.beside_a_buoy"), wanted)]
        return [Problem("buoy", Message("refused_file.none_of_them"), wanted)]
    if "buoy" in given:
        return []
    allowed = Message("refused_case.of_a_buoy")
    others = [key for key in _OF_A_BUOY if key in given]
    if given.get("heave_drag") == HEAVE_DRAG:
        others.remove("heave_drag")
    return [Problem(key, "", allowed) for key in others]


@dataclass(frozen=True)
class Floater(Checked):
    """What floats: a buoy at the upper end of its line, or a ship on several lines.

    A buoy moves with its line, in surge, heave and pitch; waves and current go along x, from the
    anchor to the fairlead, or against it. `load` and the line's `fairlead_height` are for the
    answers at rest, as is the force of a system for a ship. All but `ship` and `wind_speed` is of a
    buoy.
    """

    buoy: Source = ""
    """Name of the buoy, of the library or of `file`."""
    ship: ShipAfloat | None = None
    """In its place."""
    file: Annotated[str, File(example='"buoys.toml"')] = ""
    """Path of a file of buoys of one's own; empty when not used."""
    wind_speed: SomeSpeed = 0.0
    """Of a buoy, that blows along x, m/s: its drag is the buoy's own in air; of a ship the mean of
    one hour at 10 m."""
    centre_of_gravity: Place | None = None
    """Height above the bottom of the hull, m; None: that of its hull and structure, as if their
    mass were spread over what they displace, with the ballast at the lowest point."""
    pitch_radius: Length | None = None
    """Radius of gyration about it, m; None: likewise."""
    pitch_damping: NotNegative | None = None
    """Of what else damps the pitch than waves and the drag of the slices, as a part of critical;
    None: not known, and then nothing."""
    heave_drag: Coefficient = HEAVE_DRAG
    """Drag coefficient along the axis, on the widest section."""

    def _check(self, found: Findings) -> None:
        found.check()
        given = {
            each.name: getattr(self, each.name)
            for each in fields(self)
            if getattr(self, each.name) != each.default
        }
        found.problems += floater_misfits(given)
