"""A body whose coefficients a panel program computed, as a hull that is stepped in time."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from catopt.arrays import Array
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError, Problem
from catopt.hydro.build import HullOfCoefficients
from catopt.hydro.coefficient_files import read_capytaine, read_wamit
from catopt.hydro.coefficients import Coefficients
from catopt.model import HullAfloat, System
from catopt.words import Message

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
        raise InputError([Problem("floater.hull.file", ", ".join(lacking), allowed)], "--dynamic")
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
            raise InputError([Problem("floater.hull.file", found, allowed)], "--dynamic")
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


def _read(of: HullAfloat, density: float) -> Coefficients:
    if Path(of.file).suffix == ".nc":
        return read_capytaine(of.file)
    if of.ulen is None:
        allowed = Message("refused_motion.ulen_of_wamit")
        raise InputError([Problem("floater.hull.ulen", "", allowed)], "--dynamic")
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
