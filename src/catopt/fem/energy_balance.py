"""Energy of a run: what the ends and the water put in, where it goes, and what the steps lose.

In every step the mean of a force at its start and at its end, times the way of its node. Under
Newmark's average acceleration these works add up to the kinetic energy gained, exactly; whatever is
left over in the sum of all is numerical: a scheme's damping, and forces that change too fast for
the step. Added mass works as a force of the water, since its direction turns with the bar.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from catopt.compiled import inlined
from catopt.fem.morison import split_velocity
from catopt.fem.moving import Moving, MovingLines, WaterAt

__all__ = ["EnergyBalance", "add_works", "fill_forces"]


@dataclass(frozen=True)
class EnergyBalance:
    """Energy of one run from its first moment to its last, J.

    Attributes
    ----------
    ends : float
        Work put in by what holds and leads the ends.
    water : float
        Work put in by the pressure of waves, with the added mass, and by weight out of the water.
    kinetic, elastic, potential : float
        Stored more at the end than at the beginning: in the line's own mass, in its strain and the
        bed's, in its weight.
    drag, bed, friction, damping : float
        Taken by the water's drag (negative where a current drives the line), the bed's damping and
        friction, and the damping of the line itself.
    put_in : float
        Work of ends, water and drag in the steps in which they put it in.
    """

    ends: float
    water: float
    kinetic: float
    elastic: float
    potential: float
    drag: float
    bed: float
    friction: float
    damping: float
    put_in: float

    @property
    def numerical(self) -> float:
        """What the steps in time lost, or gained where negative, J."""
        stored = self.kinetic + self.elastic + self.potential
        return self.ends + self.water - stored - self.drag - self.bed - self.friction - self.damping

    @property
    def numerical_part(self) -> float:
        """The same without its sign, as a part of the work put in."""
        return abs(self.numerical) / self.put_in if self.put_in > 0.0 else 0.0


def fill_forces(lines: MovingLines, at: Moving, water: WaterAt, has_sea: bool, to: Any) -> None:
    """Write the forces on the nodes whose work is booked, N.

    Parameters
    ----------
    lines, at, water
        What moves, how, and in what.
    has_sea : bool
        Without a sea all is in still water, and the second of the forces is none.
    to : array, shape (3, nodes, 3)
        Drag; pressure of the waves with weight out of the water; damping of the line.
    """
    to[:] = 0.0
    v, axis, flow, latest, wetness = at.v, at.axis, water.velocity, water.latest, water.wet
    alpha, masses, displaced = lines.mass_factor, lines.mass, lines.displaced
    length, drag_n, drag_t = lines.length, lines.drag_normal, lines.drag_tangential
    light, heavy = lines.weight, lines.weight_in_air
    added_n, added_t = lines.added_normal, lines.added_tangential
    drag, pressed, damped = to[0], to[1], to[2]
    x, tension, EA, pushes = at.x, at.tension, lines.EA, lines.pushes
    for k in range(lines.start.shape[0] - 1):
        for e in range(lines.start[k], lines.start[k + 1]):
            a, b = e + k, e + k + 1
            l0 = length[e]
            half = 0.5 * l0
            tx, ty, tz = axis[e, 0], axis[e, 1], axis[e, 2]
            wet_a, wet_b = wetness[e, 0], wetness[e, 1]
            cn, ct = half * drag_n[e], half * drag_t[e]
            _add_drag(drag, flow, v, a, tx, ty, tz, cn * wet_a, ct * wet_a)
            _add_drag(drag, flow, v, b, tx, ty, tz, cn * wet_b, ct * wet_b)
            wet = 0.5 * (wet_a + wet_b)
            near, far = l0 * lines.near, l0 * lines.far
            added = added_n[e] * wet
            more = added_t[e] * wet - added
            if has_sea:
                out = half * (heavy[e] - light[e])
                pressed[a, 2] -= (1.0 - wet_a) * out
                pressed[b, 2] -= (1.0 - wet_b) * out
                push = displaced[e] * wet + added
                _add_inertia(pressed, latest, a, b, tx, ty, tz, near, far, push, more)
            dx, dy, dz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
            elastic = EA[e] * (math.sqrt(dx * dx + dy * dy + dz * dz) / l0 - 1.0)
            N = tension[e] - (elastic if pushes else max(elastic, 0.0))
            damped[a, 0] += N * tx
            damped[a, 1] += N * ty
            damped[a, 2] += N * tz
            damped[b, 0] -= N * tx
            damped[b, 1] -= N * ty
            damped[b, 2] -= N * tz
            if alpha > 0.0:
                own = -alpha * (masses[e] + added)
                _add_inertia(damped, v, a, b, tx, ty, tz, near, far, own, -alpha * more)
            if lines.stiffness_factor > 0.0 and elastic > 0.0:
                _add_turning(e, a, lines.stiffness_factor * elastic, at, damped)
        for n in range(lines.start[k] + k, lines.start[k + 1] + k + 1 if alpha > 0.0 else 0):
            for i in range(3):
                damped[n, i] -= alpha * lines.node_mass[n] * v[n, i]


@inlined
def _add_drag(
    to: Any, flow: Any, v: Any, n: int, tx: float, ty: float, tz: float, cn: float, ct: float
) -> None:
    along, nx, ny, nz, size = split_velocity(flow, v, n, tx, ty, tz)
    axial, across = ct * abs(along) * along, cn * size
    to[n, 0] += axial * tx + across * nx
    to[n, 1] += axial * ty + across * ny
    to[n, 2] += axial * tz + across * nz


@inlined
def _add_inertia(
    to: Any, u: Any, a: int, b: int, tx: float, ty: float, tz: float, near: float, far: float,
    own: float, more: float,
) -> None:  # fmt: skip
    """Add a bar's mass matrix (own in all directions, more along it) times a row of `u` a node."""
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


def add_works(
    lines: MovingLines, before: Moving, now: Moving, wet: Any, old_wet: Any, old: Any, new: Any,
    old_end: Any, new_end: Any, works: Any,
) -> None:  # fmt: skip
    """Add what the forces did in a step.

    Parameters
    ----------
    lines, before, now
        What moves, at the step's start and at its end.
    wet, old_wet : array, shape (bars, 2)
        Part of each half bar that is in the water, at the end and at the start.
    old, new : array, shape (3, nodes, 3)
        As `fill_forces` wrote them at the start and at the end.
    old_end, new_end : array, shape (lines, 3)
        Force of each line on what leads its fairlead, N.
    works : array, shape (8,)
        Of the ends, the water, drag, bed, friction and line damping on the line; kinetic energy
        gained; what ends, water and drag put in, J.
    """
    x, x_0, R, R_0, rub, rub_0 = now.x, before.x, now.reaction, before.reaction, now.rub, before.rub
    drag, pressed, damped = new[0], new[1], new[2]
    drag_0, pressed_0, damped_0 = old[0], old[1], old[2]
    v, v_0, node_mass = now.v, before.v, lines.node_mass
    by_ends = by_drag = by_water = by_damping = by_bed = by_friction = gain = 0.0
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k, lines.start[k + 1] + k
        for i in range(3):
            by_ends -= 0.5 * (old_end[k, i] + new_end[k, i]) * (x[last, i] - x_0[last, i])
        for n in range(first + 1, last + 1):
            square = 0.0
            for i in range(3):
                way = x[n, i] - x_0[n, i]
                by_drag += (drag_0[n, i] + drag[n, i]) * way
                by_water += (pressed_0[n, i] + pressed[n, i]) * way
                by_damping += (damped_0[n, i] + damped[n, i]) * way
                square += (v[n, i] + v_0[n, i]) * (v[n, i] - v_0[n, i])
            gain += 0.5 * node_mass[n] * square
            by_bed += (R_0[n] + R[n]) * (x[n, 2] - x_0[n, 2])
            by_friction += (rub_0[n, 0] + rub[n, 0]) * (x[n, 0] - x_0[n, 0])
            by_friction += (rub_0[n, 1] + rub[n, 1]) * (x[n, 1] - x_0[n, 1])
        own, added = _inertia_works(k, lines, before, now, wet, old_wet)
        gain += own
        by_water -= 2.0 * added
    works[0] += by_ends
    works[1] += 0.5 * by_water
    works[2] += 0.5 * by_drag
    works[3] += 0.5 * by_bed
    works[4] += 0.5 * by_friction
    works[5] += 0.5 * by_damping
    works[6] += gain
    works[7] += max(by_ends, 0.0) + 0.5 * (max(by_water, 0.0) + max(by_drag, 0.0))


def _inertia_works(
    line: int, lines: MovingLines, before: Moving, now: Moving, wet: Any, old_wet: Any
) -> tuple[float, float]:
    """Work that a line does on its own mass and on the added one in a step, J."""
    own, added = 0.0, 0.0
    v, v_0, axis, old_axis, mass = now.v, before.v, now.axis, before.axis, lines.mass
    length, added_n, added_t = lines.length, lines.added_normal, lines.added_tangential
    share_near, share_far = 0.5 * lines.near, 0.5 * lines.far
    for e in range(lines.start[line], lines.start[line + 1]):
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
        every_way = near * same + far * cross
        axial = near * (mean_a * gain_a + mean_b * gain_b)
        axial += far * (mean_a * gain_b + mean_b * gain_a)
        normal = added_n[e]
        part = 0.25 * (wet[e, 0] + wet[e, 1] + old_wet[e, 0] + old_wet[e, 1])
        own += mass[e] * every_way
        added += part * (normal * every_way + (added_t[e] - normal) * axial)
    return own, added
