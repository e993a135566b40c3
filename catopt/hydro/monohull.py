"""How a monohull answers to waves, by closed forms of its main dimensions.

Heave and pitch after Jensen, Mansour and Olsen (Ocean Engineering 31, 2004), of a box of the block
coefficient's breadth in deep water, read in two programs that have them (C); the wave number along
the hull is that of the depth. The other freedoms are catopt's own: surge, sway and yaw follow the
undisturbed water in the place of the hull, roll is an oscillator under the wave's slope.
"""

from __future__ import annotations

import math

import numpy as np

from catopt.arrays import Array
from catopt.constants import STANDARD_GRAVITY
from catopt.hydro.coefficients import Complex
from catopt.model.validity import Findings
from catopt.waves.dispersion import fill_wave_numbers


def monohull_response(
    omega: Array,
    heading: Array,
    depth: float,
    *,
    length: float,
    breadth: float,
    draught: float,
    block: float,
    roll_period: float | None = None,
    roll_damping: float = 0.05,
) -> Complex:
    """Response amplitude operators about midships in the waterline, shape (n, h, 6).

    As `catopt.hydro.coefficients.Coefficients.response` has them: m/m and rad/m, their angle the
    lag behind the crest.

    Parameters
    ----------
    omega, heading : array
        rad/s; where the waves travel to, counter-clockwise from the ship's x axis, rad.
    depth : float
        Of the water, m.
    length, breadth, draught : float
        Of the waterline, m.
    block : float
        Block coefficient.
    roll_period : float, optional
        Natural period of the roll, s; without, the ship does not roll.
    roll_damping : float
        Part of critical.

    Raises
    ------
    InputError
        What is not above 0, a block coefficient above 1, a keel in the bed.
    """
    found = Findings("monohull_response")
    for key, value in (("length", length), ("breadth", breadth), ("draught", draught)):
        found.number(key, value, "m", above=0.0)
    found.number("depth", depth, "m", above=draught)
    found.number("block", block, "", above=0.0, at_most=1.0)
    if roll_period is not None:
        found.number("roll_period", roll_period, "s", above=0.0)
    found.number("roll_damping", roll_damping, "", above=0.0)
    found.raise_if_any()
    k = np.empty(omega.size)
    fill_wave_numbers(omega, depth, k)
    cosine, sine = np.cos(heading), np.sin(heading)
    along, across = np.outer(k, cosine), np.outer(k, sine)
    out = np.zeros((omega.size, heading.size, 6), dtype=complex)

    # Heave and pitch, with the wave number of deep water in what is of a section.
    deep = omega**2 / STANDARD_GRAVITY
    width = breadth * block
    waves = 2.0 * np.sin(0.5 * deep * width) * np.exp(-deep * draught)
    damped = waves**2 / (deep * width)
    force = np.exp(-deep * draught) * np.hypot(1.0 - deep * draught, damped)
    answer = (force / (1.0 - 2.0 * deep * draught - 1j * damped))[:, np.newaxis]
    out[:, :, 2] = answer * np.sinc(along * length / (2.0 * math.pi))
    out[:, :, 4] = -1j * answer * _slope(along, length)

    # The water's own way, as the mean over the hull's place.
    over = np.expm1(-2.0 * k * (depth - draught)) / np.expm1(-2.0 * k * depth)
    way = (1.0 - np.exp(-k * draught) * over) / (k * draught)
    aside = np.sinc(across * breadth / (2.0 * math.pi))
    mean = way[:, np.newaxis] * np.sinc(along * length / (2.0 * math.pi)) * aside
    out[:, :, 0], out[:, :, 1] = 1j * mean * cosine, 1j * mean * sine
    out[:, :, 5] = -way[:, np.newaxis] * aside * sine * _slope(along, length)
    if roll_period is not None:
        r = (omega * roll_period / (2.0 * math.pi))[:, np.newaxis]
        slope = across * np.exp(-0.5 * deep * draught)[:, np.newaxis] * aside
        slope = slope * np.sinc(along * length / (2.0 * math.pi))
        out[:, :, 3] = 1j * slope / (1.0 - r**2 - 2j * roll_damping * r)
    return out


def _slope(q: Array, length: float) -> Array:
    """Turn of a rod that follows sin(q x) best, over a length, 1/m: q of long waves."""
    x = 0.5 * q * length
    small = np.abs(x) < 1e-3
    safe = np.where(small, 1.0, x)
    part = np.where(small, 1.0 - x**2 / 10.0, 3.0 * (np.sin(safe) - safe * np.cos(safe)) / safe**3)
    return np.asarray(q * part)
