"""Point loads that move: drag, added mass, and the lift that they have under water alone.

For a body of the volume V at a node, r = u - v the velocity of the water relative to it:

    drag      0.5 rho Cd A |r| r
    inertia   rho V u' + Ca rho V (u' - v')
    lift      rho g V

each times the part of a sphere of that volume about the node that is under water. With s the part
of its diameter, that is s^2 (3 - 2 s).
"""

from __future__ import annotations

import math
from typing import Any

from catopt.compiled import inlined
from catopt.fem.moving import Blend, Equations, Moving, MovingLines, WaterAt


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
