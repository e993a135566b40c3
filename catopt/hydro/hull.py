"""Hulls of plain shape: their panels, and a ship's hull from its main dimensions."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from catopt.arrays import Array, Codes
from catopt.compiled import packed
from catopt.constants import STANDARD_GRAVITY
from catopt.hydro.coefficients import Complex
from catopt.model.kinds import Findings
from catopt.waves.between import WaterEnds, fill_between, keep_start, look_ahead
from catopt.waves.kinematics import Flow, cos_sin, fill_kinematics, smooth_ramp
from catopt.waves.random_surface import fill_wave_numbers

PRESSURE, DIFFRACTION, MEMORY, DRAG, WIND, DAMPING = range(6)
"""Rows of `HullState.parts`; the first with the weight."""
PARTS: Final = 6
LEAST_COSINE: Final = 0.05
"""Of the angle between the axis and the surface, as far as columns are cut by it."""


@packed
class Hull(NamedTuple):
    """What does not change in a run."""

    mass: float  # kg
    inertia: float  # about its centre of gravity, kg m2
    added: Array  # (3, 3): added mass of motion much faster than its waves, about that point
    density: float  # of the water, kg/m3
    gravity: float  # m/s2
    foot: Array  # (slices,): s of each slice's foot, m
    top: Array  # (slices,): and of its top
    radius: Array  # (slices,): of the disc that displaces as much, m
    drag: Array  # (slices,): 0.5 rho C D, per length, N s2/m3
    bottom: float  # s of the lowest face, m
    bottom_drag: float  # 0.5 rho C A of it along the axis, N s2/m2
    bottom_radius: float  # m
    column: Array  # (columns, 2): place across, over the radius, and share of the disc
    wind: Array  # (2,): force along x, N, and s of where it acts, m
    damping: Array  # (3,): linear, N s/m and N m s
    constant: Array  # (3,): other constant forces, N and N m
    stiffness: Array  # (3, 3): derivative of the restoring forces at rest, for Newton's steps
    eye: Array  # (lines, 2): place of each mooring eye across and along the axis, m
    free: Array  # (3,): 1.0 for each direction in which it moves
    mode: Codes  # (modes, 2): force and motion of each exponential of the memory
    rate: Array  # (modes, 2): its rate, real and imaginary, 1/s
    strength: Array  # (modes, 2)
    excited: Array  # (waves, 6): diffraction of each wave of the sea, real and imaginary parts of
    # surge, heave, pitch, with the wave's amplitude, N and N m


@packed
class HullState(NamedTuple):
    """Where it is at one time."""

    q: Array  # (3,): place, velocity, acceleration
    v: Array
    a: Array
    force: Array  # (3,): all forces but inertia and lines
    parts: Array  # (PARTS, 3): of which it consists
    memory: Array  # (modes, 2): integral of exp(rate (t - s)) v(s) ds, real and imaginary
    wet: Array  # (1,): volume under the surface, m3
    line: Array  # (3,): force and moment of the lines with their inertia


@packed
class HullRoom(NamedTuple):
    """Work space, and the water at the step's end where the hull is expected."""

    points: Array  # (slices, 3)
    velocity: Array  # (slices, 3)
    acceleration: Array  # (slices, 3)
    surface: Array  # (slices,)
    sea: Array  # (5,): elevation, m, its slope along x, diffraction in three directions
    ends: WaterEnds  # of the slices, over the whole step
    sea_ends: Array  # (2, 5): the sea at its start and its end
    carried: Array  # (modes, 2): memory at the step's end by what was before
    by_speed: Array  # (modes, 2): and by each m/s at the step's end
    matrix: Array  # (3, 3): of Newton's step
    rest: Array  # (3,): what is left over, then the move
    by_v: Array  # (3, 3): derivative of the drag


@packed
class HullRecord(NamedTuple):
    """What is kept of a run."""

    q: Array  # (samples, 3)
    v: Array  # (samples, 3)
    wet: Array  # (samples,): volume under the surface, m3
    surface: Array  # (samples,): elevation over its centre, m
    line: Array  # (samples, 3)
    extreme: Array  # (4, 2): least and largest x, z, pitch, wet volume of every step
    works: Array  # (PARTS + 2,): of each part, of the lines, and what was put in, J


def fill_sea(t: float, hull: Hull, q: Any, flow: Flow, room: HullRoom) -> None:
    """Take the water at time t, s, about a hull at q."""
    _place_slices(hull, q[0], q[1], q[2], flow.depth, room.points)
    fill_kinematics(t, room.points, flow, room.velocity, room.acceleration, room.surface)
    _look_at_sea(t, q[0], hull, flow, room.sea)


def keep_sea(room: HullRoom) -> None:
    """Keep the water at hand as that at the next whole step's start."""
    keep_start(room.velocity, room.acceleration, room.surface, room.ends)
    for i in range(room.sea.shape[0]):
        room.sea_ends[0, i] = room.sea[i]


def fill_sea_between(
    t: float, part: float, ahead: float, at: HullState, hull: Hull, flow: Flow, room: HullRoom
) -> None:
    """Take the water about a hull after a part of a whole step, `between.fill_between`.

    The step ends at t, s, which is so far ahead of the hull's state, s.
    """
    ends, sea = room.ends, room.sea_ends
    if ends.is_known[0] == 0.0:
        x, z, turn = at.q[0] + ahead * at.v[0], at.q[1] + ahead * at.v[1], at.q[2] + ahead * at.v[2]
        _place_slices(hull, x, z, turn, flow.depth, ends.points)
        look_ahead(t, flow, ends)
        _look_at_sea(t, x, hull, flow, sea[1])
    fill_between(part, ends, room.velocity, room.acceleration, room.surface)
    for i in range(sea.shape[1]):
        room.sea[i] = (1.0 - part) * sea[0, i] + part * sea[1, i]


def _place_slices(hull: Hull, x: float, z: float, turn: float, depth: float, to: Any) -> None:
    """Write the middles of the slices of a hull at a place and in an attitude."""
    sine, cosine = math.sin(turn), math.cos(turn)
    for j in range(to.shape[0]):
        s = 0.5 * (hull.foot[j] + hull.top[j])
        to[j, 0] = x + s * sine
        to[j, 1] = 0.0
        to[j, 2] = min(z + s * cosine, depth)


def _look_at_sea(t: float, x: float, hull: Hull, flow: Flow, sea: Any) -> None:
    """Write elevation and slope over a hull at x, m, and what it diffracts, as `HullRoom.sea`."""
    eta = slope = surge = heave = pitch = 0.0
    waves, excited = flow.waves, hull.excited
    for i in range(waves.shape[0]):
        cos, sin = cos_sin(waves[i, 1] * x - (waves[i, 0] * t) % (2.0 * math.pi) + waves[i, 4])
        eta += waves[i, 7] * cos
        slope -= waves[i, 7] * waves[i, 1] * sin
        surge += excited[i, 0] * cos - excited[i, 1] * sin
        heave += excited[i, 2] * cos - excited[i, 3] * sin
        pitch += excited[i, 4] * cos - excited[i, 5] * sin
    ramp, _ = smooth_ramp(t, flow.ramp_time)
    sea[0], sea[1] = ramp * eta, ramp * slope
    sea[2], sea[3], sea[4] = ramp * surge, ramp * heave, ramp * pitch


def fill_forces_on_hull(hull: Hull, now: HullState, depth: float, room: HullRoom) -> None:
    """Write the forces on a hull in the water at hand; `depth` of still water, m."""
    parts, sea, by_v, v = now.parts, room.sea, room.by_v, now.v
    for i in range(PARTS):
        for j in range(3):
            parts[i, j] = 0.0
    for i in range(3):
        for j in range(3):
            by_v[i, j] = 0.0
    now.wet[0] = _press(hull, now, depth, room)
    parts[PRESSURE, 1] -= hull.mass * hull.gravity
    for i in range(3):
        parts[PRESSURE, i] += hull.constant[i]
        parts[DIFFRACTION, i] = sea[2 + i]
        parts[DAMPING, i] = -hull.damping[i] * v[i]
        by_v[i, i] += hull.damping[i]
    for m in range(hull.mode.shape[0]):
        of, by = hull.mode[m, 0], hull.mode[m, 1]
        real = room.carried[m, 0] + room.by_speed[m, 0] * v[by]
        imaginary = room.carried[m, 1] + room.by_speed[m, 1] * v[by]
        now.memory[m, 0], now.memory[m, 1] = real, imaginary
        r, i_ = hull.strength[m, 0], hull.strength[m, 1]
        parts[MEMORY, of] -= r * real - i_ * imaginary
        by_v[of, by] += r * room.by_speed[m, 0] - i_ * room.by_speed[m, 1]
    sine, cosine = math.sin(now.q[2]), math.cos(now.q[2])
    parts[WIND, 0] = hull.wind[0]
    parts[WIND, 2] = hull.wind[0] * hull.wind[1] * cosine
    _drag_bottom(hull, now, depth, sine, cosine, room)
    for j in range(3):
        total = 0.0
        for i in range(PARTS):
            total += parts[i, j]
        now.force[j] = total


def _press(hull: Hull, now: HullState, depth: float, room: HullRoom) -> float:
    """Add the pressure on all slices and the drag across them; give the volume under water, m3."""
    q, v, column = now.q, now.v, hull.column
    sine, cosine = math.sin(q[2]), math.cos(q[2])
    above = depth + room.sea[0] - q[1]
    lean = room.sea[1] * cosine + sine
    upright = max(cosine - room.sea[1] * sine, LEAST_COSINE)
    volume = 0.0
    for j in range(hull.foot.shape[0]):
        s_0, s_1, R = hull.foot[j], hull.top[j], hull.radius[j]
        ax, az = room.acceleration[j, 0], room.acceleration[j, 2] + hull.gravity
        middle = 0.5 * (s_0 + s_1)
        whole = math.pi * R * R * (s_1 - s_0)
        reach = abs(lean) * R
        wet, arm_x, arm_z = 0.0, 0.0, 0.0
        if (above - reach) >= s_1 * upright:
            wet = whole
            arm_x, arm_z = middle * sine * whole, middle * cosine * whole
        elif (above + reach) > s_0 * upright:
            for c in range(column.shape[0]):
                across = column[c, 0] * R
                long = min(max((above + across * lean) / upright - s_0, 0.0), s_1 - s_0)
                part = column[c, 1] * math.pi * R * R * long
                s = s_0 + 0.5 * long
                wet += part
                arm_x += part * (across * cosine + s * sine)
                arm_z += part * (s * cosine - across * sine)
        if wet <= 0.0:
            continue
        volume += wet
        now.parts[PRESSURE, 0] += hull.density * wet * ax
        now.parts[PRESSURE, 1] += hull.density * wet * az
        now.parts[PRESSURE, 2] += hull.density * (arm_z * ax - arm_x * az)
        if hull.drag[j] > 0.0:
            long = (s_1 - s_0) * (wet / whole if whole > 0.0 else 0.0)
            s = arm_x / wet * sine + arm_z / wet * cosine
            off = (room.velocity[j, 0] - v[0]) * cosine - (room.velocity[j, 2] - v[1]) * sine
            off -= s * v[2]
            factor = hull.drag[j] * long * abs(off)
            push = factor * off
            now.parts[DRAG, 0] += push * cosine
            now.parts[DRAG, 1] -= push * sine
            now.parts[DRAG, 2] += push * s
            _add_square(room.by_v, 2.0 * factor, cosine, -sine, s)
    return volume


def _drag_bottom(
    hull: Hull, now: HullState, depth: float, sine: float, cosine: float, room: HullRoom
) -> None:
    """Add the drag along the axis on the lowest face, in columns."""
    if hull.bottom_drag <= 0.0:
        return
    q, v, s = now.q, now.v, hull.bottom
    for c in range(hull.column.shape[0]):
        across = hull.column[c, 0] * hull.bottom_radius
        x, z = across * cosine + s * sine, s * cosine - across * sine
        under = depth + room.sea[0] + room.sea[1] * x - (q[1] + z)
        part = min(max(under / max(hull.bottom_radius, 1e-9), 0.0), 1.0)
        off = (room.velocity[0, 0] - v[0]) * sine + (room.velocity[0, 2] - v[1]) * cosine
        off += across * v[2]
        factor = hull.bottom_drag * hull.column[c, 1] * part * abs(off)
        push = factor * off
        now.parts[DRAG, 0] += push * sine
        now.parts[DRAG, 1] += push * cosine
        now.parts[DRAG, 2] -= push * across
        _add_square(room.by_v, 2.0 * factor, sine, cosine, -across)


def _add_square(to: Any, factor: float, x: float, z: float, turn: float) -> None:
    """Add a vector's product with itself."""
    to[0, 0] += factor * x * x
    to[0, 1] += factor * x * z
    to[0, 2] += factor * x * turn
    to[1, 0] += factor * z * x
    to[1, 1] += factor * z * z
    to[1, 2] += factor * z * turn
    to[2, 0] += factor * turn * x
    to[2, 1] += factor * turn * z
    to[2, 2] += factor * turn * turn


def carry_memory(h: float, hull: Hull, before: HullState, room: HullRoom) -> None:
    """Carry the memory over a step of h, s, in which velocities change evenly."""
    for m in range(hull.mode.shape[0]):
        p, w = hull.rate[m, 0], hull.rate[m, 1]
        decay, cos, sin = math.exp(p * h), math.cos(w * h), math.sin(w * h)
        e_r, e_i = decay * cos, decay * sin
        # With z = rate h: w_1 = h (e^z - 1 - z)/z^2 of the end, w_0 = h (e^z - 1)/z - w_1.
        z_r, z_i = p * h, w * h
        size = z_r * z_r + z_i * z_i
        if size < 1e-4:
            # By series: (e^z - 1)/z = 1 + z/2 + z^2/6, (e^z - 1 - z)/z^2 = 1/2 + z/6 + z^2/24.
            s_r, s_i = z_r * z_r - z_i * z_i, 2.0 * z_r * z_i
            f_r, f_i = 1.0 + 0.5 * z_r + s_r / 6.0, 0.5 * z_i + s_i / 6.0
            g_r, g_i = 0.5 + z_r / 6.0 + s_r / 24.0, z_i / 6.0 + s_i / 24.0
        else:
            f_r = ((e_r - 1.0) * z_r + e_i * z_i) / size
            f_i = (e_i * z_r - (e_r - 1.0) * z_i) / size
            g_r = ((f_r - 1.0) * z_r + f_i * z_i) / size
            g_i = (f_i * z_r - (f_r - 1.0) * z_i) / size
        old = before.v[hull.mode[m, 1]]
        r, i = before.memory[m, 0], before.memory[m, 1]
        room.carried[m, 0] = e_r * r - e_i * i + h * (f_r - g_r) * old
        room.carried[m, 1] = e_i * r + e_r * i + h * (f_i - g_i) * old
        room.by_speed[m, 0], room.by_speed[m, 1] = h * g_r, h * g_i


def hull_inertia(hull: Hull, i: int, j: int) -> float:
    """Mass or moment of inertia with the added mass."""
    own = 0.0
    if i == j:
        own = hull.inertia if i == 2 else hull.mass
    return float(own + hull.added[i, j])


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
