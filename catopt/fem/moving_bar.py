"""Bars that move: their inertia and their loads."""

from __future__ import annotations

import math
from typing import Any

from catopt.compiled import inlined
from catopt.fem.morison import axial_drag, split_velocity
from catopt.fem.moving import Blend, Equations, Moving, MovingLines, WaterAt


def add_bars(
    lines: MovingLines,
    now: Moving,
    before: Moving,
    water: WaterAt,
    blend: Blend,
    slopes: bool,
    to: Equations,
) -> float:
    """Add the bars' forces to `now.force`, their inertia to `to.rest`, derivatives to the blocks.

    `slopes`: whether derivatives are required.

    Writes their tension and axis, too; returns the largest force in one, N. All arrays are taken
    out of their tuples before the loop: numba counts references to those that are taken out within
    it, which would be most of the time.
    """
    x, v, force, axis, tension = now.x, now.v, now.force, now.axis, now.tension
    acc, old_axis = to.acceleration, before.axis
    flow, u, wetness = water.velocity, water.acceleration, water.wet
    length, EA, damping, masses = lines.length, lines.EA, lines.damping, lines.mass
    weight, weight_in_air, displaced = lines.weight, lines.weight_in_air, lines.displaced
    added_normal, added_tangential = lines.added_normal, lines.added_tangential
    drag_normal, drag_tangential = lines.drag_normal, lines.drag_tangential
    drag_by_speed, drag_by_across = lines.drag_by_speed, lines.drag_by_across
    diagonal, upper, lower, rest = to.diagonal, to.upper, to.lower, to.rest
    start, line, pushes = lines.start, 0, lines.pushes
    by_x, by_v = blend.by_x, blend.by_v
    by_inertia = blend.by_a + lines.mass_factor * by_v
    beta = lines.stiffness_factor
    slopes = slopes or beta > 0.0  # whose forces come with their derivatives
    largest = 0.0
    for e in range(length.shape[0]):
        if e == start[line + 1]:
            line += 1
        a, b = e + line, e + line + 1
        dx, dy, dz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        size = math.sqrt(dx * dx + dy * dy + dz * dz)
        over = 1.0 / size
        tx, ty, tz = dx * over, dy * over, dz * over
        wx, wy, wz = v[b, 0] - v[a, 0], v[b, 1] - v[a, 1], v[b, 2] - v[a, 2]
        along = wx * tx + wy * ty + wz * tz
        l0 = length[e]
        rigidity, viscosity = EA[e] / l0, damping[e] / l0
        elastic = rigidity * (size - l0)
        N = elastic + viscosity * along
        if not pushes and N < 0.0:
            N = rigidity = viscosity = elastic = 0.0
        tension[e] = N
        largest = max(largest, abs(N))
        axis[e, 0], axis[e, 1], axis[e, 2] = tx, ty, tz
        # Weight and drag, of the half bar at either end.
        half = 0.5 * l0
        wet_a, wet_b = wetness[e, 0], wetness[e, 1]
        light, heavy = half * weight[e], half * weight_in_air[e]
        weight_a = wet_a * light + (1.0 - wet_a) * heavy
        weight_b = wet_b * light + (1.0 - wet_b) * heavy
        cn, ct = half * drag_normal[e], half * drag_tangential[e]
        cn_a, ct_a, cn_b, ct_b = cn * wet_a, ct * wet_a, cn * wet_b, ct * wet_b
        r_a, ax, ay, az, n_a = split_velocity(flow, v, a, tx, ty, tz)
        r_b, bx, by, bz, n_b = split_velocity(flow, v, b, tx, ty, tz)
        cs, cx = half * drag_by_speed[e], half * drag_by_across[e]
        axial_a, turn_a, self_a, cross_a = axial_drag(r_a, n_a, ct_a, cs * wet_a, cx * wet_a)
        axial_b, turn_b, self_b, cross_b = axial_drag(r_b, n_b, ct_b, cs * wet_b, cx * wet_b)
        across_a, across_b = cn_a * n_a, cn_b * n_b
        pull_a, pull_b = N + axial_a * r_a, axial_b * r_b - N
        force[a, 0] += pull_a * tx + across_a * ax
        force[a, 1] += pull_a * ty + across_a * ay
        force[a, 2] += pull_a * tz + across_a * az - weight_a
        force[b, 0] += pull_b * tx + across_b * bx
        force[b, 1] += pull_b * ty + across_b * by
        force[b, 2] += pull_b * tz + across_b * bz - weight_b
        # Inertia, balanced within the step; the direction of the added mass is the one there.
        sx, sy, sz = tx, ty, tz
        if blend.before_force > 0.0:
            sx, sy, sz = _blended_axis(tx, ty, tz, old_axis, e, blend.before_force)
        wet = 0.5 * (wet_a + wet_b)
        mass, push = masses[e], displaced[e] * wet
        added = added_normal[e] * wet
        more = added_tangential[e] * wet - added
        near, far = l0 * lines.near, l0 * lines.far
        Ax, Bx = near * acc[a, 0] + far * acc[b, 0], near * acc[b, 0] + far * acc[a, 0]
        Ay, By = near * acc[a, 1] + far * acc[b, 1], near * acc[b, 1] + far * acc[a, 1]
        Az, Bz = near * acc[a, 2] + far * acc[b, 2], near * acc[b, 2] + far * acc[a, 2]
        Ux, Vx = near * u[a, 0] + far * u[b, 0], near * u[b, 0] + far * u[a, 0]
        Uy, Vy = near * u[a, 1] + far * u[b, 1], near * u[b, 1] + far * u[a, 1]
        Uz, Vz = near * u[a, 2] + far * u[b, 2], near * u[b, 2] + far * u[a, 2]
        own, all_u = mass + added, push + added
        s_a = sx * (Ax - Ux) + sy * (Ay - Uy) + sz * (Az - Uz)
        s_b = sx * (Bx - Vx) + sy * (By - Vy) + sz * (Bz - Vz)
        rest[a, 0] += own * Ax - all_u * Ux + more * s_a * sx
        rest[a, 1] += own * Ay - all_u * Uy + more * s_a * sy
        rest[a, 2] += own * Az - all_u * Uz + more * s_a * sz
        rest[b, 0] += own * Bx - all_u * Vx + more * s_b * sx
        rest[b, 1] += own * By - all_u * Vy + more * s_b * sy
        rest[b, 2] += own * Bz - all_u * Vz + more * s_b * sz
        if not slopes:
            continue
        # Change of N t with d, the velocities following: q + t g'.
        q = by_x * N * over
        turn = by_x * viscosity * over
        stretch = by_x * rigidity + by_v * viscosity - q - turn * along
        gx, gy, gz = stretch * tx + turn * wx, stretch * ty + turn * wy, stretch * tz + turn * wz
        # Drag's change with the direction, o n n' + p P + t h n', and with the velocity, e, which
        # has a part t n' where the drag along depends on the velocity across.
        turned = by_x * over
        inv_a = 1.0 / n_a if n_a > 0.0 else 0.0
        inv_b = 1.0 / n_b if n_b > 0.0 else 0.0
        o_a, o_b = -turned * cn_a * r_a * inv_a, -turned * cn_b * r_b * inv_b
        h_a, h_b = turned * (turn_a - across_a), turned * (turn_b - across_b)
        p_a, p_b = turned * (axial_a - across_a) * r_a, turned * (axial_b - across_b) * r_b
        en_a, en_b = by_v * across_a, by_v * across_b
        et_a, et_b = by_v * self_a - en_a, by_v * self_b - en_b
        ec_a, ec_b = by_v * cross_a, by_v * cross_b
        eo_a, eo_b = by_v * cn_a * inv_a, by_v * cn_b * inv_b
        # Every block is c + t h' + o n n'.
        k = more * turned
        d_a, d_b = k * s_a - p_a, k * s_b - p_b
        f_a, f_b = -d_a - k * s_a, -d_b - k * s_b
        hax = f_a * tx + k * (Ax - Ux) - h_a * ax
        hay = f_a * ty + k * (Ay - Uy) - h_a * ay
        haz = f_a * tz + k * (Az - Uz) - h_a * az
        hbx = f_b * tx + k * (Bx - Vx) - h_b * bx
        hby = f_b * ty + k * (By - Vy) - h_b * by
        hbz = f_b * tz + k * (Bz - Vz) - h_b * bz
        m_near, m_far = by_inertia * near, by_inertia * far
        i_a, i_b, i_far = et_a + m_near * more, et_b + m_near * more, m_far * more
        t, side_a, side_b = (tx, ty, tz), (ax, ay, az), (bx, by, bz)
        hx = gx - hax + i_a * tx + ec_a * ax
        hy = gy - hay + i_a * ty + ec_a * ay
        hz = gz - haz + i_a * tz + ec_a * az
        c = q - d_a + en_a + m_near * own
        _add_block(diagonal, a, c, t, (hx, hy, hz), o_a + eo_a, side_a)
        hx = gx + hbx + i_b * tx + ec_b * bx
        hy = gy + hby + i_b * ty + ec_b * by
        hz = gz + hbz + i_b * tz + ec_b * bz
        c = q + d_b + en_b + m_near * own
        _add_block(diagonal, b, c, t, (hx, hy, hz), eo_b - o_b, side_b)
        h = (hax - gx + i_far * tx, hay - gy + i_far * ty, haz - gz + i_far * tz)
        _set_block(upper, a, d_a - q + m_far * own, t, h, -o_a, side_a)
        h = (i_far * tx - gx - hbx, i_far * ty - gy - hby, i_far * tz - gz - hbz)
        _set_block(lower, b, m_far * own - q - d_b, t, h, o_b, side_b)
        if beta > 0.0 and elastic > 0.0:
            N, K = beta * elastic * over, beta * rigidity * over
            _add_turning_damping(a, N, K, over, t, (wx, wy, wz), now, blend, to)
    return largest


@inlined
def _add_block(to: Any, n: int, c: float, t: Any, h: Any, o: float, across: Any) -> None:
    """Add c + t h' + o n n' to a block, n being the flow across the bar."""
    ox, oy, oz = o * across[0], o * across[1], o * across[2]
    to[n, 0, 0] += c + t[0] * h[0] + ox * across[0]
    to[n, 0, 1] += t[0] * h[1] + ox * across[1]
    to[n, 0, 2] += t[0] * h[2] + ox * across[2]
    to[n, 1, 0] += t[1] * h[0] + oy * across[0]
    to[n, 1, 1] += c + t[1] * h[1] + oy * across[1]
    to[n, 1, 2] += t[1] * h[2] + oy * across[2]
    to[n, 2, 0] += t[2] * h[0] + oz * across[0]
    to[n, 2, 1] += t[2] * h[1] + oz * across[1]
    to[n, 2, 2] += c + t[2] * h[2] + oz * across[2]


@inlined
def _set_block(to: Any, n: int, c: float, t: Any, h: Any, o: float, across: Any) -> None:
    """Set a block to c + t h' + o n n'."""
    ox, oy, oz = o * across[0], o * across[1], o * across[2]
    to[n, 0, 0] = c + t[0] * h[0] + ox * across[0]
    to[n, 0, 1] = t[0] * h[1] + ox * across[1]
    to[n, 0, 2] = t[0] * h[2] + ox * across[2]
    to[n, 1, 0] = t[1] * h[0] + oy * across[0]
    to[n, 1, 1] = c + t[1] * h[1] + oy * across[1]
    to[n, 1, 2] = t[1] * h[2] + oy * across[2]
    to[n, 2, 0] = t[2] * h[0] + oz * across[0]
    to[n, 2, 1] = t[2] * h[1] + oz * across[1]
    to[n, 2, 2] = c + t[2] * h[2] + oz * across[2]


@inlined
def _blended_axis(
    tx: float, ty: float, tz: float, old: Any, e: int, early: float
) -> tuple[float, float, float]:
    """Direction between the step's start and its end."""
    sx = (1.0 - early) * tx + early * old[e, 0]
    sy = (1.0 - early) * ty + early * old[e, 1]
    sz = (1.0 - early) * tz + early * old[e, 2]
    over = 1.0 / math.sqrt(sx * sx + sy * sy + sz * sz)
    return sx * over, sy * over, sz * over


def _add_turning_damping(
    a: int,
    N: float,
    K: float,
    over: float,
    t: Any,
    w: Any,
    now: Moving,
    blend: Blend,
    to: Equations,
) -> None:
    """Add Rayleigh's damping of the turning bar, beta N_e P w / l, with its derivatives.

    `N`, `K`: beta N_e/l and its derivative by the bar's length; `over`: 1/l.
    """
    b = a + 1
    along = w[0] * t[0] + w[1] * t[1] + w[2] * t[2]
    Pw = (w[0] - along * t[0], w[1] - along * t[1], w[2] - along * t[2])
    for i in range(3):
        F = N * Pw[i]
        now.force[a, i] += F
        now.force[b, i] -= F
        for j in range(3):
            P = (1.0 if i == j else 0.0) - t[i] * t[j]
            turned = N * over * (along * P + t[i] * Pw[j] + Pw[i] * t[j])
            by_d = K * Pw[i] * t[j] - turned
            S = blend.by_x * by_d + blend.by_v * (N * P)
            to.diagonal[a, i, j] += S
            to.diagonal[b, i, j] += S
            to.upper[a, i, j] -= S
            to.lower[b, i, j] -= S


def inertia_of_half(
    e: int, node: int, other: int, lines: MovingLines, at: Moving, a: Any, water: WaterAt
) -> tuple[float, float, float]:
    """Inertia of a bar at one of its nodes, N; `a` (nodes, 3): accelerations, m/s2."""
    l0 = lines.length[e]
    near, far, alpha = l0 * lines.near, l0 * lines.far, lines.mass_factor
    part = 0.5 * (water.wet[e, 0] + water.wet[e, 1])
    added_n, added_t = lines.added_normal[e] * part, lines.added_tangential[e] * part
    mass, push = lines.mass[e], lines.displaced[e] * part
    f = (0.0, 0.0, 0.0)
    r = (0.0, 0.0, 0.0)
    for i in range(3):
        u_0, u_1 = water.latest[node, i], water.latest[other, i]
        a_0, a_1 = a[node, i] + alpha * at.v[node, i], a[other, i] + alpha * at.v[other, i]
        own = near * (mass * a_0 - push * u_0) + far * (mass * a_1 - push * u_1)
        against = near * (a_0 - u_0) + far * (a_1 - u_1)
        f = (f[1], f[2], own)
        r = (r[1], r[2], against)
    tx, ty, tz = at.axis[e, 0], at.axis[e, 1], at.axis[e, 2]
    along = (added_t - added_n) * (tx * r[0] + ty * r[1] + tz * r[2])
    return (
        f[0] + added_n * r[0] + along * tx,
        f[1] + added_n * r[1] + along * ty,
        f[2] + added_n * r[2] + along * tz,
    )


@inlined
def immersion(below: float, radius: float) -> tuple[float, float]:
    """Part of a sphere that is under water, its middle `below` the surface; its growth, 1/m."""
    s = 0.5 * below / radius + 0.5
    if s >= 1.0:
        return 1.0, 0.0
    if s <= 0.0:
        return 0.0, 0.0
    return s * s * (3.0 - 2.0 * s), 3.0 * s * (1.0 - s) / radius


def add_loads(
    lines: MovingLines, now: Moving, before: Moving, water: WaterAt, blend: Blend, to: Equations
) -> None:
    """Add the water's forces on point loads to `now.force` and `to`, with their derivatives."""
    force, rest, acc, diagonal = now.force, to.rest, to.acceleration, to.diagonal
    flow, u, v = water.velocity, water.acceleration, now.v
    by_inertia = blend.by_a + lines.mass_factor * blend.by_v
    early = blend.before_force
    for k in range(lines.load_node.shape[0]):
        n, radius = lines.load_node[k], lines.load_radius[k]
        part, slope = immersion(water.surface[n] - now.x[n, 2], radius)
        old, _ = immersion(water.surface[n] - before.x[n, 2], radius)
        within = (1.0 - early) * part + early * old
        sinks = -blend.by_x * slope  # what a rise of the node takes off the part
        full, lift = lines.load_drag[k], lines.load_displaced[k] * lines.load_gravity
        added, displaced = lines.load_added[k], lines.load_displaced[k]
        rx, ry, rz = flow[n, 0] - v[n, 0], flow[n, 1] - v[n, 1], flow[n, 2] - v[n, 2]
        size = math.sqrt(rx * rx + ry * ry + rz * rz)
        over = 1.0 / size if size > 0.0 else 0.0
        r = (rx, ry, rz)
        force[n, 2] -= (1.0 - part) * lift
        diagonal[n, 2, 2] -= sinks * lift
        for i in range(3):
            force[n, i] += full * part * size * r[i]
            own = added * (acc[n, i] - u[n, i]) - displaced * u[n, i]
            rest[n, i] += within * own
            diagonal[n, i, 2] += sinks * (own - full * size * r[i])
            diagonal[n, i, i] += within * added * by_inertia + blend.by_v * full * part * size
            for j in range(3):
                diagonal[n, i, j] += blend.by_v * full * part * over * r[i] * r[j]


def book_loads(
    lines: MovingLines, at: Moving, water: WaterAt, out: Any, pressed: Any, damped: Any
) -> None:
    """Add the forces on point loads whose work is booked, N, as `energy_balance.fill_forces`."""
    for k in range(lines.load_node.shape[0]):
        n, added = lines.load_node[k], lines.load_added[k]
        part, _ = immersion(water.surface[n] - at.x[n, 2], lines.load_radius[k])
        out[n, 2] -= (1.0 - part) * lines.load_displaced[k] * lines.load_gravity
        for i in range(3):
            pressed[n, i] += part * (lines.load_displaced[k] + added) * water.latest[n, i]
            damped[n, i] -= lines.mass_factor * part * added * at.v[n, i]


def load_works(lines: MovingLines, before: Moving, now: Moving, surface: Any) -> float:
    """Work that point loads do on their added mass in a step, J; `surface`: of the water, m."""
    work = 0.0
    for k in range(lines.load_node.shape[0]):
        n, radius = lines.load_node[k], lines.load_radius[k]
        part, _ = immersion(surface[n] - now.x[n, 2], radius)
        old, _ = immersion(surface[n] - before.x[n, 2], radius)
        square = 0.0
        for i in range(3):
            square += (now.v[n, i] + before.v[n, i]) * (now.v[n, i] - before.v[n, i])
        work += 0.25 * (part + old) * lines.load_added[k] * square
    return work
