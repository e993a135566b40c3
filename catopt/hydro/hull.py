"""Hulls of plain shape: their panels, and a ship's hull from its main dimensions."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from catopt.arrays import Array, Codes
from catopt.compiled import inlined, packed
from catopt.constants import STANDARD_GRAVITY
from catopt.hydro.coefficients import Complex
from catopt.model.kinds import Findings
from catopt.waves.kinematics import (
    Flow,
    WaterEnds,
    cos_sin,
    fill_between,
    fill_kinematics,
    keep_start,
    look_ahead,
    smooth_ramp,
)
from catopt.waves.random_surface import wave_numbers

PRESSURE, DIFFRACTION, MEMORY, DRAG, WIND, DAMPING = range(6)
"""Rows of `HullState.parts`; the first with the weight."""
PARTS: Final = 6
LEAST_COSINE: Final = 0.05
"""Of the angle between the axis and the surface, as far as columns are cut by it."""


@packed
class Hull(NamedTuple):
    """What does not change in a run.

    Its freedoms are surge, sway, heave along x, y, z, and the turns about them through its centre
    of gravity: roll, pitch, yaw.
    """

    mass: float  # kg
    inertia: float  # about its centre of gravity, across its axis, kg m2
    spin_inertia: float  # about its axis, kg m2
    added: Array  # (6, 6): added mass of motion much faster than its waves, about that point
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
    wind: Array  # (3,): force along x and y, N, and s of where it acts, m
    damping: Array  # (6,): linear, N s/m and N m s
    constant: Array  # (6,): other constant forces, N and N m
    stiffness: Array  # (6, 6): derivative of the restoring forces at rest, for Newton's steps
    restoring: Array  # (6, 6): of a hull without slices, whose weight and buoyancy are linear
    level: Array  # (3,): place from which these count, m
    eye: Array  # (lines, 3): place of each mooring eye, two across and one along the axis, m
    free: Array  # (6,): 1.0 for each freedom that it has
    mode: Codes  # (modes, 2): force and motion of each exponential of the memory
    rate: Array  # (modes, 2): its rate, real and imaginary, 1/s
    strength: Array  # (modes, 2)
    excited: Array  # (waves, 12): force and moment of each wave of the sea beyond the pressure of
    # the wave itself on the slices, real and imaginary parts, with its amplitude: N and N m


@packed
class HullState(NamedTuple):
    """Where it is at one time."""

    q: Array  # (3,): place of its centre of gravity, m
    axes: Array  # (3, 3): its own axes, in columns; the last is its axis, upwards
    turn: Array  # (3,): by which the step has turned it, rad
    v: Array  # (6,): velocity, m/s and rad/s
    a: Array  # (6,): acceleration
    force: Array  # (6,): all forces but inertia and lines
    parts: Array  # (PARTS, 6): of which it consists
    memory: Array  # (modes, 2): integral of exp(rate (t - s)) v(s) ds, real and imaginary
    wet: Array  # (1,): volume under the surface, m3
    line: Array  # (6,): force and moment of the lines with their inertia


@packed
class HullRoom(NamedTuple):
    """Work space, and the water at the step's end where the hull is expected."""

    points: Array  # (slices, 3)
    velocity: Array  # (slices, 3)
    acceleration: Array  # (slices, 3)
    surface: Array  # (slices,)
    sea: Array  # (9,): elevation, m, its slopes along x and y, and what `Hull.excited` comes to
    ends: WaterEnds  # of the slices, over the whole step
    sea_ends: Array  # (2, 9): the sea at its start and its end
    carried: Array  # (modes, 2): memory at the step's end by what was before
    by_speed: Array  # (modes, 2): and by each m/s at the step's end
    matrix: Array  # (6, 6): of Newton's step
    rest: Array  # (6,): what is left over, then the move
    by_v: Array  # (6, 6): derivative of the drag


@packed
class HullRecord(NamedTuple):
    """What is kept of a run."""

    q: Array  # (samples, 6): place, and roll, pitch, yaw as of `attitude`
    v: Array  # (samples, 6)
    wet: Array  # (samples,): volume under the surface, m3
    surface: Array  # (samples,): elevation over its centre, m
    line: Array  # (samples, 6)
    extreme: Array  # (7, 2): least and largest of place, angles and wet volume of every step
    works: Array  # (PARTS + 2,): of each part, of the lines, and what was put in, J


@inlined
def cross(a: Any, b: Any) -> tuple[float, float, float]:
    """Multiply two vectors."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def rotated(by: Any, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Turn a vector by a rotation about its own direction, as many rad as it is long."""
    square = by[0] * by[0] + by[1] * by[1] + by[2] * by[2]
    angle = math.sqrt(square)
    if angle < 1e-8:
        cosine, sine, rest = 1.0, 1.0, 0.5
    else:
        cosine, sine = math.cos(angle), math.sin(angle) / angle
        rest = (1.0 - cosine) / square
    along = rest * (by[0] * x + by[1] * y + by[2] * z)
    return (
        cosine * x + sine * (by[1] * z - by[2] * y) + along * by[0],
        cosine * y + sine * (by[2] * x - by[0] * z) + along * by[1],
        cosine * z + sine * (by[0] * y - by[1] * x) + along * by[2],
    )


def rotate_axes(by: Any, axes: Any, to: Any) -> None:
    """Write axes that are turned by a rotation, as `rotated`."""
    for j in range(3):
        to[0, j], to[1, j], to[2, j] = rotated(by, axes[0, j], axes[1, j], axes[2, j])


def attitude(axes: Any) -> tuple[float, float, float]:
    """Roll, pitch and yaw, rad: it is turned about its axis, then about x, then about y."""
    roll = math.asin(min(max(-axes[1, 2], -1.0), 1.0))
    return roll, math.atan2(axes[0, 2], axes[2, 2]), math.atan2(axes[1, 0], axes[1, 1])


def fill_sea(t: float, hull: Hull, at: HullState, flow: Flow, room: HullRoom) -> None:
    """Take the water at time t, s, about a hull."""
    q, axes = at.q, at.axes
    axis = axes[0, 2], axes[1, 2], axes[2, 2]
    _place_slices(hull, (q[0], q[1], q[2]), axis, flow.depth, room.points)
    fill_kinematics(t, room.points, flow, room.velocity, room.acceleration, room.surface)
    _look_at_sea(t, q[0], q[1], hull, flow, room.sea)


def keep_sea(room: HullRoom) -> None:
    """Keep the water at hand as that at the next whole step's start."""
    keep_start(room.velocity, room.acceleration, room.surface, room.ends)
    for i in range(room.sea.shape[0]):
        room.sea_ends[0, i] = room.sea[i]


def fill_sea_between(
    t: float, part: float, ahead: float, at: HullState, hull: Hull, flow: Flow, room: HullRoom
) -> None:
    """Take the water about a hull after a part of a whole step, as `fill_between` does.

    The step ends at t, s, which is so far ahead of the hull's state, s.
    """
    ends, sea = room.ends, room.sea_ends
    if ends.is_known[0] == 0.0:
        q, v, axes = at.q, at.v, at.axes
        place = q[0] + ahead * v[0], q[1] + ahead * v[1], q[2] + ahead * v[2]
        by = ahead * v[3], ahead * v[4], ahead * v[5]
        axis = rotated(by, axes[0, 2], axes[1, 2], axes[2, 2])
        _place_slices(hull, place, axis, flow.depth, ends.points)
        look_ahead(t, flow, ends)
        _look_at_sea(t, place[0], place[1], hull, flow, sea[1])
    fill_between(part, ends, room.velocity, room.acceleration, room.surface)
    for i in range(sea.shape[1]):
        room.sea[i] = (1.0 - part) * sea[0, i] + part * sea[1, i]


def _place_slices(hull: Hull, place: Any, axis: Any, depth: float, to: Any) -> None:
    """Write the middles of the slices of a hull at a place and in an attitude."""
    for j in range(to.shape[0]):
        s = 0.5 * (hull.foot[j] + hull.top[j])
        to[j, 0] = place[0] + s * axis[0]
        to[j, 1] = place[1] + s * axis[1]
        to[j, 2] = min(place[2] + s * axis[2], depth)


def _look_at_sea(t: float, x: float, y: float, hull: Hull, flow: Flow, sea: Any) -> None:
    """Write the surface over a hull at x, y, m, and the waves' force, as `HullRoom.sea`."""
    for j in range(9):
        sea[j] = 0.0
    waves, excited = flow.waves, hull.excited
    for i in range(waves.shape[0]):
        k_x, k_y = waves[i, 1], waves[i, 2]
        cos, sin = cos_sin(k_x * x + k_y * y - (waves[i, 0] * t) % (2.0 * math.pi) + waves[i, 4])
        sea[0] += waves[i, 7] * cos
        sea[1] -= waves[i, 7] * k_x * sin
        sea[2] -= waves[i, 7] * k_y * sin
        for j in range(6):
            sea[3 + j] += excited[i, 2 * j] * cos - excited[i, 2 * j + 1] * sin
    ramp, _ = smooth_ramp(t, flow.ramp_time)
    for j in range(9):
        sea[j] *= ramp


def fill_forces_on_hull(hull: Hull, now: HullState, depth: float, room: HullRoom) -> None:
    """Write the forces on a hull in the water at hand; `depth` of still water, m."""
    parts, sea, by_v, v, axes = now.parts, room.sea, room.by_v, now.v, now.axes
    for i in range(PARTS):
        for j in range(6):
            parts[i, j] = 0.0
    for i in range(6):
        for j in range(6):
            by_v[i, j] = 0.0
    n = axes[0, 2], axes[1, 2], axes[2, 2]
    now.wet[0] = _press(hull, now, n, depth, room)
    parts[PRESSURE, 2] -= hull.mass * hull.gravity
    for i in range(6):
        parts[PRESSURE, i] += hull.constant[i]
        parts[DAMPING, i] = -hull.damping[i] * v[i]
        by_v[i, i] += hull.damping[i]
        parts[DIFFRACTION, i] = sea[3 + i]
    if hull.foot.shape[0] == 0:
        _restore(hull, now)
    _remember(hull, now, room)
    wind = hull.wind[0], hull.wind[1], 0.0
    turn = cross(n, wind)
    for i in range(3):
        parts[WIND, i], parts[WIND, 3 + i] = wind[i], hull.wind[2] * turn[i]
    _drag_bottom(hull, now, n, depth, room)
    for j in range(6):
        total = 0.0
        for i in range(PARTS):
            total += parts[i, j]
        now.force[j] = total
    _keep_spin(hull, now, n)


def _restore(hull: Hull, now: HullState) -> None:
    """Add weight and buoyancy of a hull without slices: linear in its way from where it floats."""
    roll, pitch, yaw = attitude(now.axes)
    q, level = now.q, hull.level
    way = q[0] - level[0], q[1] - level[1], q[2] - level[2], roll, pitch, yaw
    for i in range(6):
        for j in range(6):
            now.parts[PRESSURE, i] -= hull.restoring[i, j] * way[j]


def _keep_spin(hull: Hull, now: HullState, n: Any) -> None:
    """Add what keeps the turning about its axis as that is turned: it does no work."""
    v = now.v
    spin = v[3] * n[0] + v[4] * n[1] + v[5] * n[2]
    aside = cross((v[3], v[4], v[5]), n)
    for i in range(3):
        now.force[3 + i] -= (hull.spin_inertia - hull.inertia) * spin * aside[i]


def _remember(hull: Hull, now: HullState, room: HullRoom) -> None:
    """Add what the waves do to it that it made before."""
    parts, by_v, v = now.parts, room.by_v, now.v
    for m in range(hull.mode.shape[0]):
        of, by = hull.mode[m, 0], hull.mode[m, 1]
        real = room.carried[m, 0] + room.by_speed[m, 0] * v[by]
        imaginary = room.carried[m, 1] + room.by_speed[m, 1] * v[by]
        now.memory[m, 0], now.memory[m, 1] = real, imaginary
        r, i_ = hull.strength[m, 0], hull.strength[m, 1]
        parts[MEMORY, of] -= r * real - i_ * imaginary
        by_v[of, by] += r * room.by_speed[m, 0] - i_ * room.by_speed[m, 1]


def _press(hull: Hull, now: HullState, n: Any, depth: float, room: HullRoom) -> float:
    """Add the pressure on all slices and the drag across them; give the volume under water, m3.

    `n`: the hull's axis. Columns stand side by side in the direction in which it leans most out of
    the surface, `e`.
    """
    column, sea, parts = hull.column, room.sea, now.parts
    above = depth + sea[0] - now.q[2]
    upright = n[2] - sea[1] * n[0] - sea[2] * n[1]
    off_x, off_y = sea[1] + upright * n[0], sea[2] + upright * n[1]
    off_z = upright * n[2] - 1.0
    lean = math.sqrt(off_x * off_x + off_y * off_y + off_z * off_z)
    if lean > 1e-12:
        e = off_x / lean, off_y / lean, off_z / lean
    else:
        e = now.axes[0, 0], now.axes[1, 0], now.axes[2, 0]
    upright = max(upright, LEAST_COSINE)
    volume = 0.0
    for j in range(hull.foot.shape[0]):
        s_0, s_1, R = hull.foot[j], hull.top[j], hull.radius[j]
        middle = 0.5 * (s_0 + s_1)
        whole = math.pi * R * R * (s_1 - s_0)
        reach = lean * R
        wet, across, along = 0.0, 0.0, 0.0
        if (above - reach) >= s_1 * upright:
            wet = whole
            along = middle * whole
        elif (above + reach) > s_0 * upright:
            for c in range(column.shape[0]):
                place = column[c, 0] * R
                long = min(max((above + place * lean) / upright - s_0, 0.0), s_1 - s_0)
                part = column[c, 1] * math.pi * R * R * long
                wet += part
                across += part * place
                along += part * (s_0 + 0.5 * long)
        if wet <= 0.0:
            continue
        volume += wet
        arm = (
            across * e[0] + along * n[0],
            across * e[1] + along * n[1],
            across * e[2] + along * n[2],
        )
        a = room.acceleration[j, 0], room.acceleration[j, 1], room.acceleration[j, 2] + hull.gravity
        moment = cross(arm, a)
        for i in range(3):
            parts[PRESSURE, i] += hull.density * wet * a[i]
            parts[PRESSURE, 3 + i] += hull.density * moment[i]
        if hull.drag[j] > 0.0:
            _drag_slice(hull, j, now, n, wet / whole if whole > 0.0 else 0.0, along / wet, room)
    return volume


def _drag_slice(
    hull: Hull, j: int, now: HullState, n: Any, part: float, s: float, room: HullRoom
) -> None:
    """Add the drag across a slice, of which a part is wet, its middle at s, m."""
    v, water = now.v, room.velocity
    swung = cross((v[3], v[4], v[5]), n)
    w_x = water[j, 0] - v[0] - s * swung[0]
    w_y = water[j, 1] - v[1] - s * swung[1]
    w_z = water[j, 2] - v[2] - s * swung[2]
    own = w_x * n[0] + w_y * n[1] + w_z * n[2]
    w_x, w_y, w_z = w_x - own * n[0], w_y - own * n[1], w_z - own * n[2]
    speed = math.sqrt(w_x * w_x + w_y * w_y + w_z * w_z)
    if speed <= 0.0:
        return
    factor = hull.drag[j] * (hull.top[j] - hull.foot[j]) * part * speed
    d = w_x / speed, w_y / speed, w_z / speed
    lever = cross(n, d)
    m = s * lever[0], s * lever[1], s * lever[2]
    for i in range(3):
        now.parts[DRAG, i] += factor * speed * d[i]
        now.parts[DRAG, 3 + i] += factor * speed * m[i]
    _add_square(room.by_v, 2.0 * factor, d, m)
    if hull.free[1] > 0.0:
        _add_square(room.by_v, factor, lever, (-s * d[0], -s * d[1], -s * d[2]))


def _drag_bottom(hull: Hull, now: HullState, n: Any, depth: float, room: HullRoom) -> None:
    """Add the drag along the axis on the lowest face, in columns across its turning."""
    if hull.bottom_drag <= 0.0:
        return
    q, v, s, sea = now.q, now.v, hull.bottom, room.sea
    tilt = cross(n, (v[3], v[4], v[5]))
    rate = math.sqrt(tilt[0] * tilt[0] + tilt[1] * tilt[1] + tilt[2] * tilt[2])
    if rate > 1e-12:
        e = tilt[0] / rate, tilt[1] / rate, tilt[2] / rate
    else:
        e = now.axes[0, 0], now.axes[1, 0], now.axes[2, 0]
    lever = cross(e, n)
    passing = (room.velocity[0, 0] - v[0]) * n[0] + (room.velocity[0, 1] - v[1]) * n[1]
    passing += (room.velocity[0, 2] - v[2]) * n[2]
    for c in range(hull.column.shape[0]):
        across = hull.column[c, 0] * hull.bottom_radius
        x, y = across * e[0] + s * n[0], across * e[1] + s * n[1]
        z = across * e[2] + s * n[2]
        under = depth + sea[0] + sea[1] * x + sea[2] * y - (q[2] + z)
        part = min(max(under / max(hull.bottom_radius, 1e-9), 0.0), 1.0)
        off = passing - across * rate
        factor = hull.bottom_drag * hull.column[c, 1] * part * abs(off)
        m = across * lever[0], across * lever[1], across * lever[2]
        for i in range(3):
            now.parts[DRAG, i] += factor * off * n[i]
            now.parts[DRAG, 3 + i] += factor * off * m[i]
        _add_square(room.by_v, 2.0 * factor, n, m)


@inlined
def _add_square(to: Any, factor: float, way: Any, turn: Any) -> None:
    """Add the product with itself of how a place moves with each freedom."""
    for i in range(3):
        for j in range(3):
            to[i, j] += factor * way[i] * way[j]
            to[i, 3 + j] += factor * way[i] * turn[j]
            to[3 + i, j] += factor * turn[i] * way[j]
            to[3 + i, 3 + j] += factor * turn[i] * turn[j]


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


def hull_inertia(hull: Hull, axes: Any, i: int, j: int) -> float:
    """Mass or moment of inertia with the added mass, as it is turned."""
    own = 0.0
    if i == j:
        own = hull.inertia if i > 2 else hull.mass
    if i > 2 and j > 2:
        own += (hull.spin_inertia - hull.inertia) * axes[i - 3, 2] * axes[j - 3, 2]
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
    k = wave_numbers(omega, depth)
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
