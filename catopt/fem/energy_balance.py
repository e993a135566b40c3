"""Energy of a run: what the ends and the water put in, where it goes, and what the steps lose.

In every step the mean of a force at its start and at its end, times the way of its node. Under
Newmark's average acceleration these works add up to the kinetic energy gained, exactly; whatever is
left over in the sum of all is numerical: a scheme's damping, and forces that change too fast for
the step. Added mass works as a force of the water, since its direction turns with the bar.

Drag is what all forces on the nodes do beyond those that are booked by themselves. What is stored
is a difference of two states, taken once. The damping of a bar takes what its mean rate of strain
in a step takes at its mean length: in a step over which a snap rises and dies, the forces at its
start and its end say nothing of it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from catopt.compiled import inlined
from catopt.fem.banded import clear_blocks
from catopt.fem.moving import Moving, MovingLines, WaterAt
from catopt.fem.moving_bar import book_loads, load_works
from catopt.fem.sampling import Room
from catopt.fem.seabed import across_bed, along_bed


@dataclass(frozen=True)
class EnergyBalance:
    """Energy of one run from its first moment to its last, J."""

    ends: float
    """J, work of the ends: put in by what holds and leads them."""
    water: float
    """J, work of waves and current that drive the line: their pressure, with the added mass, and
    weight out of the water."""
    kinetic: float
    """J, gained in motion: in the line's own mass."""
    elastic: float
    """J, gained in stretch, and in the bed's."""
    potential: float
    """J, gained in height."""
    drag: float
    """J, taken by drag; negative where a current drives the line."""
    bed: float
    """J, taken by the bed's damping."""
    friction: float
    """J, taken by friction on the bed."""
    damping: float
    """J, taken by the damping of the line itself."""
    put_in: float
    """J, put in by the ends and the water in the steps in which they put it in."""

    @property
    def numerical(self) -> float:
        """J, that none of these accounts for; negative where the steps gained it."""
        stored = self.kinetic + self.elastic + self.potential
        return self.ends + self.water - stored - self.drag - self.bed - self.friction - self.damping

    @property
    def numerical_part(self) -> float:
        """The same without its sign, as a part of the work put in."""
        return abs(self.numerical) / self.put_in if self.put_in > 0.0 else 0.0


def fill_forces(lines: MovingLines, at: Moving, water: WaterAt, has_sea: bool, to: Any) -> None:
    """Write the forces on the nodes whose work is booked beside that of the bars, N.

    `to` (4, nodes, 3): weight out of the water; pressure of the waves with the added mass;
    Rayleigh's damping of the mass, and of turning bars. Left alone where none of them is.
    """
    alpha, beta = lines.mass_factor, lines.stiffness_factor
    if not (has_sea or alpha > 0.0 or beta > 0.0):
        return
    clear_blocks(to)
    v, axis, latest, wetness = at.v, at.axis, water.latest, water.wet
    masses, displaced, length = lines.mass, lines.displaced, lines.length
    light, heavy = lines.weight, lines.weight_in_air
    added_n, added_t = lines.added_normal, lines.added_tangential
    out, pressed, damped, turned = to[0], to[1], to[2], to[3]
    book_loads(lines, at, water, out, pressed, damped)
    for k in range(lines.start.shape[0] - 1):
        for e in range(lines.start[k], lines.start[k + 1]):
            a, b = e + k, e + k + 1
            l0 = length[e]
            t = (axis[e, 0], axis[e, 1], axis[e, 2])
            wet_a, wet_b = wetness[e, 0], wetness[e, 1]
            wet = 0.5 * (wet_a + wet_b)
            near, far = l0 * lines.near, l0 * lines.far
            added = added_n[e] * wet
            more = added_t[e] * wet - added
            if has_sea:
                lost = 0.5 * l0 * (heavy[e] - light[e])
                out[a, 2] -= (1.0 - wet_a) * lost
                out[b, 2] -= (1.0 - wet_b) * lost
                push = displaced[e] * wet + added
                _add_inertia(pressed, latest, a, t, near, far, push, more)
            if alpha > 0.0:
                own = -alpha * (masses[e] + added)
                _add_inertia(damped, v, a, t, near, far, own, -alpha * more)
            if beta > 0.0:
                elastic = _elastic_force(e, a, lines, at)
                if elastic > 0.0:
                    _add_turning(e, a, beta * elastic, at, turned)
    for n in range(v.shape[0] if alpha > 0.0 else 0):
        for i in range(3):
            damped[n, i] -= alpha * lines.node_mass[n] * v[n, i]


@inlined
def _bar_length(e: int, a: int, at: Moving) -> float:
    """Length of a bar, m; `a` is its first node."""
    x, axis, b = at.x, at.axis, a + 1
    size = (x[b, 0] - x[a, 0]) * axis[e, 0] + (x[b, 1] - x[a, 1]) * axis[e, 1]
    return float(size + (x[b, 2] - x[a, 2]) * axis[e, 2])


@inlined
def _elastic_force(e: int, a: int, lines: MovingLines, at: Moving) -> float:
    """Part of a bar's force that its strain makes, N; `a` is its first node."""
    elastic = lines.EA[e] * (_bar_length(e, a, at) / lines.length[e] - 1.0)
    return float(elastic) if lines.pushes else max(float(elastic), 0.0)


@inlined
def _add_inertia(
    to: Any, u: Any, a: int, t: Any, near: float, far: float, own: float, more: float
) -> None:
    """Add a bar's mass matrix (own in all directions, more along it) times a row of `u` a node."""
    b = a + 1
    tx, ty, tz = t
    ux, wx = near * u[a, 0] + far * u[b, 0], near * u[b, 0] + far * u[a, 0]
    uy, wy = near * u[a, 1] + far * u[b, 1], near * u[b, 1] + far * u[a, 1]
    uz, wz = near * u[a, 2] + far * u[b, 2], near * u[b, 2] + far * u[a, 2]
    s_a = more * (tx * ux + ty * uy + tz * uz)
    s_b = more * (tx * wx + ty * wy + tz * wz)
    to[a, 0] += own * ux + s_a * tx
    to[a, 1] += own * uy + s_a * ty
    to[a, 2] += own * uz + s_a * tz
    to[b, 0] += own * wx + s_b * tx
    to[b, 1] += own * wy + s_b * ty
    to[b, 2] += own * wz + s_b * tz


def _add_turning(e: int, a: int, force: float, at: Moving, to: Any) -> None:
    """Add Rayleigh's damping of the turning bar; `force` is beta times its elastic force."""
    b = a + 1
    square = along = 0.0
    for i in range(3):
        square += (at.x[b, i] - at.x[a, i]) ** 2
        along += at.axis[e, i] * (at.v[b, i] - at.v[a, i])
    size = math.sqrt(square)
    for i in range(3):
        across = at.v[b, i] - at.v[a, i] - along * at.axis[e, i]
        to[a, i] += force / size * across
        to[b, i] -= force / size * across


def own_kinetic_energy(lines: MovingLines, at: Moving) -> float:
    """Kinetic energy of the lines and of what is fixed to them, without added mass, J."""
    total, v = 0.0, at.v
    for k in range(lines.start.shape[0] - 1):
        for e in range(lines.start[k], lines.start[k + 1]):
            a, b = e + k, e + k + 1
            same = cross = 0.0
            for i in range(3):
                same += v[a, i] * v[a, i] + v[b, i] * v[b, i]
                cross += v[a, i] * v[b, i]
            each = 0.5 * lines.near * same + lines.far * cross
            total += lines.mass[e] * lines.length[e] * each
    for n in range(v.shape[0]):
        for i in range(3):
            total += 0.5 * lines.node_mass[n] * v[n, i] * v[n, i]
    return total


def add_works(
    h: float, lines: MovingLines, before: Moving, is_booked: bool, room: Room, works: Any
) -> None:
    """Add what the forces did in a step of h, s; `is_booked`: those of `fill_forces`, too.

    `works` (8,): of the ends, the water, drag, bed, friction and line damping on the line; kinetic
    energy (not written to); what ends, water and drag put in, J.
    """
    now, water = room.now, room.water
    x, x_0, R, R_0, rub, rub_0 = now.x, before.x, now.reaction, before.reaction, now.rub, before.rub
    force, force_0, steady = now.force, before.force, lines.node_force
    booked, booked_0 = room.booked, room.booked_before
    by_ends = by_drag = by_water = by_damping = by_bed = by_friction = 0.0
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k, lines.start[k + 1] + k
        for i in range(3):  # what ends at a joint do is between lines
            upper = room.ends_before[k, 1, i] + room.ends[k, 1, i]
            lower = room.ends_before[k, 0, i] + room.ends[k, 0, i]
            if lines.of_end[k, 1] < 0:
                by_ends -= 0.5 * upper * (x[last, i] - x_0[last, i])
            if lines.of_end[k, 0] < 0:
                by_ends -= 0.5 * lower * (x[first, i] - x_0[first, i])
        taken, damped = _bar_works(k, h, lines, before, now)
        by_drag += taken
        by_damping -= 2.0 * damped
        by_water -= 2.0 * _added_mass_works(k, lines, before, now, water.wet, room.wet_before)
    for n in range(x.shape[0]):
        for i in range(3):
            way = x[n, i] - x_0[n, i]
            by_drag += (force_0[n, i] + force[n, i] - 2.0 * steady[n, i]) * way
            if is_booked:
                seen = booked_0[0, n, i] + booked[0, n, i]
                turned = booked_0[3, n, i] + booked[3, n, i]
                by_drag -= (seen + turned) * way
                by_water += (seen + booked_0[1, n, i] + booked[1, n, i]) * way
                by_damping += (turned + booked_0[2, n, i] + booked[2, n, i]) * way
        rise = across_bed(x, n, lines) - across_bed(x_0, n, lines)
        by_bed += (R_0[n] + R[n]) * rise
        slip = along_bed(x, n, lines) - along_bed(x_0, n, lines)
        by_friction += (rub_0[n, 0] + rub[n, 0]) * slip
        by_friction += (rub_0[n, 1] + rub[n, 1]) * (x[n, 1] - x_0[n, 1])
    by_drag -= by_bed + by_friction
    by_water -= 2.0 * load_works(lines, before, now, water.surface)
    works[0] += by_ends
    works[1] += 0.5 * by_water
    works[2] += 0.5 * by_drag
    works[3] += 0.5 * by_bed
    works[4] += 0.5 * by_friction
    works[5] += 0.5 * by_damping
    works[7] += max(by_ends, 0.0) + 0.5 * (max(by_water, 0.0) + max(by_drag, 0.0))


def _bar_works(
    line: int, h: float, lines: MovingLines, before: Moving, now: Moving
) -> tuple[float, float]:
    """Twice the work in a step on the bars of a line, with their weight; what damping takes, J."""
    x, x_0, axis, axis_0 = now.x, before.x, now.axis, before.axis
    tension, tension_0, weight, length = now.tension, before.tension, lines.weight, lines.length
    taken = damping = 0.0
    for e in range(lines.start[line], lines.start[line + 1]):
        a, b = e + line, e + line + 1
        apart_0 = apart = 0.0
        for i in range(3):
            by = (x[b, i] - x_0[b, i]) - (x[a, i] - x_0[a, i])
            apart_0 += axis_0[e, i] * by
            apart += axis[e, i] * by
        rise = (x[b, 2] - x_0[b, 2]) + (x[a, 2] - x_0[a, 2])
        taken += tension_0[e] * apart_0 + tension[e] * apart + weight[e] * length[e] * rise
        damping += _damped(e, a, h, lines, before, now)
    return taken, damping


@inlined
def _damped(e: int, a: int, h: float, lines: MovingLines, before: Moving, now: Moving) -> float:
    """Energy that a bar's damping takes in a step, J; `a` is its first node."""
    size_0, size, l0 = _bar_length(e, a, before), _bar_length(e, a, now), lines.length[e]
    elastic = lines.EA[e] * (0.5 * (size_0 + size) / l0 - 1.0)
    whole = elastic + lines.damping[e] * (size - size_0) / (h * l0)
    if not lines.pushes:
        elastic, whole = max(elastic, 0.0), max(whole, 0.0)
    return float((whole - elastic) * (size - size_0))


def _added_mass_works(
    line: int, lines: MovingLines, before: Moving, now: Moving, wet: Any, old_wet: Any
) -> float:
    """Work that a line does on its added mass in a step, J."""
    work = 0.0
    v, v_0, axis, old_axis = now.v, before.v, now.axis, before.axis
    length, added_n, added_t = lines.length, lines.added_normal, lines.added_tangential
    share_near, share_far = 0.5 * lines.near, 0.5 * lines.far
    for e in range(lines.start[line], lines.start[line + 1]):
        if added_n[e] == 0.0 and added_t[e] == 0.0:
            continue
        a, b = e + line, e + line + 1
        near, far = share_near * length[e], share_far * length[e]
        same = cross = mean_a = mean_b = gain_a = gain_b = 0.0
        for i in range(3):
            m_a, m_b = v[a, i] + v_0[a, i], v[b, i] + v_0[b, i]
            g_a, g_b = v[a, i] - v_0[a, i], v[b, i] - v_0[b, i]
            same += m_a * g_a + m_b * g_b
            cross += m_a * g_b + m_b * g_a
            t = 0.5 * (axis[e, i] + old_axis[e, i])
            mean_a, mean_b = mean_a + t * m_a, mean_b + t * m_b
            gain_a, gain_b = gain_a + t * g_a, gain_b + t * g_b
        axial = near * (mean_a * gain_a + mean_b * gain_b)
        axial += far * (mean_a * gain_b + mean_b * gain_a)
        normal = added_n[e]
        part = 0.25 * (wet[e, 0] + wet[e, 1] + old_wet[e, 0] + old_wet[e, 1])
        work += part * (normal * (near * same + far * cross) + (added_t[e] - normal) * axial)
    return work
