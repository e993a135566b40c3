"""Hulls that are stepped in time: a buoy, or a body of a panel program's coefficients."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np

from catopt.arrays import Array
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError, refused
from catopt.hydro.build import FloatingHull, HullOfCoefficients, Radiation
from catopt.hydro.coefficient_files import WAMIT, read_capytaine, read_wamit
from catopt.hydro.coefficients import Coefficients
from catopt.hydro.cylinder import FloatingCylinder
from catopt.loads.buoy import buoy, read_buoys
from catopt.loads.buoy_heel import centre_of, slices_of, wind_on
from catopt.loads.buoy_shape import BuoyShape
from catopt.model import Floater, HullAfloat, System
from catopt.waves.random_surface import wave_numbers
from catopt.words import Message

_CARRIED: Final = 0.9
"""Part of the reserve buoyancy that the line takes at most where the radiation is found."""


class _Slices(NamedTuple):
    """Slices of a buoy from below, heights above the hull's bottom, m."""

    foot: Array
    top: Array
    volume: Array  # m3
    width: Array  # as the water sees it from the side; 0 of what stands inside the hull, m
    below: Array  # part of it that is below the hull


def floating_buoy(of: Floater) -> BuoyShape:
    """Look a floater's buoy up; InputError by the keys of ``[floater]``."""
    try:
        return buoy(of.buoy, read_buoys(of.file) if of.file else None)
    except InputError as error:
        reported = [replace(each, key=f"floater.{each.key}") for each in error.problems]
        raise InputError(reported, "--dynamic") from None


def buoy_hull(
    of: Floater, depth: float, density: float, pull: float, *, shape: BuoyShape | None = None
) -> FloatingHull:
    """Make the hull of a buoy.

    Parameters
    ----------
    of : Floater
        What is known of it.
    depth, density : float
        Of the water, m and kg/m3.
    pull : float
        Of its line downwards in calm water, N, for the draught of its radiation.
    shape : BuoyShape, optional
        The buoy; looked up when left out.

    Raises
    ------
    InputError
        For a buoy that is not known, or would not stay upright.
    """
    return _hull(of, depth, density, pull, shape or floating_buoy(of))


@lru_cache(maxsize=32)
def _hull(of: Floater, depth: float, density: float, pull: float, shape: BuoyShape) -> FloatingHull:
    """Do it for a shape: once for all runs of a line, for its radiation takes seconds."""
    carried = min(max(pull, 0.0), _CARRIED * max(shape.reserve_buoyancy(density), 0.0))
    hull, slices = _rigid(of, density, carried, shape)
    upright = _righting(hull, carried)
    if upright <= 0.0:
        found = Message("refused_motion.above_bottom", height=hull.centre)
        allowed = Message("refused_motion.so_high_would_not_float")
        raise refused("floater.centre_of_gravity", found, allowed, "--dynamic")
    radiation = _radiation(hull, slices, depth)
    inertia = hull.inertia + radiation.infinite[2, 2]
    own = 2.0 * (of.pitch_damping or 0.0) * math.sqrt(inertia * upright)
    return replace(hull, radiation=radiation, damping=(0.0, 0.0, own))


def _righting(hull: FloatingHull, pull: float) -> float:
    """Moment per heel, N m, of the buoy's weight and buoyancy and of its line's pull downwards."""
    return float(hull.stiffness[2, 2]) + pull * max(hull.centre - hull.eyes[0][2], 0.0)


def _rigid(
    of: Floater, density: float, carried: float, shape: BuoyShape
) -> tuple[FloatingHull, _Slices]:
    """Make the hull under a pull, N, with its slices and without the waves that it makes."""
    draught, slices = shape.afloat(carried, density).draught, _slices(shape)
    centre, gyration = _mass_of(of, shape, slices)
    radius = np.sqrt(slices.volume / (math.pi * (slices.top - slices.foot)))
    mass, displaced = shape.total_mass, shape.ballast / shape.ballast_density
    hull = FloatingHull(
        slices.foot,
        slices.top,
        radius,
        mass,
        mass * gyration**2,
        centre,
        draught,
        drag=0.5 * density * shape.drag_in_water * slices.width,
        bottom_drag=0.125 * math.pi * density * of.heave_drag * shape.widest**2,
        bottom_radius=0.5 * shape.widest,
        wind=wind_on(of.wind_speed, shape, draught),
        wind_direction=of.wind_direction,
        constant=(0.0, density * STANDARD_GRAVITY * displaced, 0.0),
        eyes=((0.0, 0.0, shape.eye),),
        density=density,
    )
    return hull, slices


def _slices(shape: BuoyShape) -> _Slices:
    """Cut a buoy into slices; what stands inside the hull displaces, and is not seen."""
    return _Slices(*(np.array(column) for column in zip(*slices_of(shape), strict=True)))


def _mass_of(of: Floater, shape: BuoyShape, slices: _Slices) -> tuple[float, float]:
    """Height of the centre of gravity above the hull's bottom, and radius of gyration, m."""
    middle = 0.5 * (slices.foot + slices.top)
    long = slices.top - slices.foot
    share = slices.volume / slices.volume.sum() * shape.mass
    total = shape.total_mass
    centre = centre_of(shape, of.centre_of_gravity)
    if of.pitch_radius is not None:
        return centre, of.pitch_radius
    radius = np.sqrt(slices.volume / (math.pi * long))
    about = 0.25 * radius**2 + long**2 / 12.0 + (middle - centre) ** 2
    own = share @ about + shape.ballast * (shape.lowest - centre) ** 2
    return centre, math.sqrt(float(own) / total)


def _radiation(hull: FloatingHull, slices: _Slices, depth: float) -> Radiation:
    """Find that of a cylinder of the hull's waterplane and volume; what hangs below by strips."""
    area, _ = hull.waterplane
    wet = np.clip(hull.draught - slices.foot, 0.0, slices.top - slices.foot)
    volumes = math.pi * hull.radius**2 * wet
    floats = float((volumes * (1.0 - slices.below)).sum())
    radius = math.sqrt(area / math.pi)
    draught = min(floats / area, 0.95 * depth)
    level = hull.centre - hull.draught
    cylinder = FloatingCylinder(radius, draught, depth, level, hull.density, hull.gravity)
    of = Radiation.of_cylinder(cylinder)
    assert of.excitation is not None
    # Added mass across a long tube is what it displaces.
    middle = 0.5 * (slices.foot + np.minimum(slices.top, hull.draught))
    added = hull.density * volumes * slices.below
    arm = middle - hull.centre
    more = np.zeros((3, 3))
    more[0, 0], more[2, 2] = added.sum(), added @ arm**2
    more[0, 2] = more[2, 0] = added @ arm
    k = wave_numbers(of.omega, depth)
    along = hull.water_acceleration(of.omega, k, depth, middle - hull.draught)
    excitation = of.excitation.copy()
    excitation[:, 0] += along @ added
    excitation[:, 2] += along @ (added * arm)
    return replace(
        of, added_mass=of.added_mass + more, infinite=of.infinite + more, excitation=excitation
    )


_WANTED = ("added_mass", "damping", "excitation", "stiffness")


def hull_of_files(
    of: HullAfloat, system: System, depth: float, density: float
) -> HullOfCoefficients:
    """Make the hull of a body on the lines of a system, whose force pushes it.

    `depth` and `density` of the water, m and kg/m3. InputError by the keys of ``[floater.hull]``
    for files that cannot be read or lack something, and a body that would not float upright.
    """
    known = _read(of, density)
    lacking = [key for key in _WANTED if getattr(known, key) is None]
    if lacking:
        allowed = Message("refused_motion.missing_from_files")
        raise refused("floater.hull.file", ", ".join(lacking), allowed, "--dynamic")
    assert known.stiffness is not None
    stiffness = known.stiffness.copy()
    if of.weightless:
        heel = of.mass * STANDARD_GRAVITY * of.centre_of_gravity[2]
        stiffness[3, 3] -= heel
        stiffness[4, 4] -= heel
    for freedom, key in ((2, "heave"), (3, "roll"), (4, "pitch")):
        if stiffness[freedom, freedom] <= 0.0:
            found = f"{key}: {stiffness[freedom, freedom]:.3g}"
            allowed = Message("refused_motion.stiffness_above_0")
            raise refused("floater.hull.file", found, allowed, "--dynamic")
    mass, memory = mass_about_point(of), known.memory(of.memory)
    infinite = known.infinite(memory)
    turning = (
        2.0 * part * math.sqrt(stiffness[i, i] * (mass[i, i] + infinite[i, i]))
        for i, part in ((3, of.roll_damping), (4, of.pitch_damping))
    )
    return HullOfCoefficients(
        known,
        mass,
        stiffness,
        memory,
        infinite,
        of.mass if of.displacement is None else of.displacement,
        force=system.force,
        damping=(*(of.damping or (0.0, 0.0, 0.0)), *turning, 0.0),
        eyes=tuple((*leg.fairlead, leg.fairlead_height - depth) for leg in system.legs),
        density=density,
        gravity=STANDARD_GRAVITY,
    )


_OTHERS: Final = (".h5", ".hdf5", ".mat")
"""Endings of coefficient files that are not read."""


def _read(of: HullAfloat, density: float) -> Coefficients:
    if Path(of.file).suffix == ".nc":
        return read_capytaine(of.file)
    ending = Path(of.file).suffix.lower()
    if ending in _OTHERS or (ending not in WAMIT and Path(of.file).is_file()):
        allowed = Message("refused_motion.coefficient_files", endings=", ".join(WAMIT))
        raise refused("floater.hull.file", Path(of.file).name, allowed, "--dynamic")
    if of.ulen is None:
        allowed = Message("refused_motion.ulen_of_wamit")
        raise refused("floater.hull.ulen", "", allowed, "--dynamic")
    return read_wamit(of.file, ulen=of.ulen, density=density, gravity=STANDARD_GRAVITY)


def mass_about_point(of: HullAfloat) -> Array:
    """Mass matrix (6, 6) about the point of the coefficients."""
    x, y, z = of.centre_of_gravity
    arm = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    out = np.zeros((6, 6))
    out[:3, :3] = of.mass * np.eye(3)
    out[:3, 3:], out[3:, :3] = -of.mass * arm, of.mass * arm
    out[3:, 3:] = of.mass * (np.diag(np.square(of.gyration)) - arm @ arm)
    return out
