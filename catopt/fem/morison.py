"""Forces of the water on a bar: Morison's equation, its coefficients, and its linear form."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from catopt.arrays import Array
from catopt.compiled import compiled, inlined
from catopt.fem.moving import WaterAt
from catopt.model.kinds import Findings
from catopt.waves.kinematics import Flow, fill_kinematics


def fill_water(
    t: float, x: Any, start: Any, flow: Flow, early: float, before: Any, water: WaterAt
) -> None:
    """Write the water's motion at a step's end t, s, where the nodes are expected, x, m.

    `start`: first bar of each line; `before` (nodes, 3): acceleration at the step's start, m/s2.
    """
    fill_kinematics(t, x, flow, water.velocity, water.latest, water.surface)
    wet_bars(x, start, early, before, water)


def wet_bars(x: Any, start: Any, early: float, before: Any, water: WaterAt) -> None:
    """Write what follows from the water at the nodes: where inertia balances, and wet bars."""
    for n in range(x.shape[0]):
        for i in range(3):
            water.acceleration[n, i] = (1.0 - early) * water.latest[n, i] + early * before[n, i]
    for k in range(start.shape[0] - 1):
        for e in range(start[k], start[k + 1]):
            a, b = e + k, e + k + 1
            below_a, below_b = water.surface[a] - x[a, 2], water.surface[b] - x[b, 2]
            middle = 0.5 * (below_a + below_b)
            water.wet[e, 0] = wet_part(below_a, middle)
            water.wet[e, 1] = wet_part(middle, below_b)


@inlined
def wet_part(one: float, other: float) -> float:
    """Part of a straight piece that is in the water, its ends being so far below the surface."""
    high, low = max(one, other), min(one, other)
    if low >= 0.0:
        return 1.0
    if high <= 0.0:
        return 0.0
    return high / (high - low)


OBLIQUE: Final = (0.03, 0.05)
"""m and n of the drag along, C_n (m + n sin g) cos g, S4 [2.32]."""

_SMOOTH, _ROUGH = 1e-4, 1e-2


def steady_drag(roughness: float, diameter: float) -> float:
    """C_DS in a steady flow, S4 [2.30]: 0.65 when smooth, 1.05 when rough; k and D in m."""
    relative = roughness / diameter
    if relative < _SMOOTH:
        return 0.65
    if relative > _ROUGH:
        return 1.05
    return (29.0 + 4.0 * math.log10(relative)) / 20.0


def wake_amplification(steady: float, keulegan_carpenter: float) -> float:
    """Factor psi on C_DS in a flow to and fro, C_D = psi C_DS, S4 [2.29].

    `keulegan_carpenter`: KC = v T/D, v being the amplitude of the velocity; 0 or more and below 12:
    from there on S4 has a graph.
    """
    C_pi = 1.50 - 0.024 * (12.0 / steady - 10.0)
    KC = keulegan_carpenter
    if KC < 0.75:
        return C_pi - 1.0 - 2.0 * (KC - 0.75)
    return C_pi - 1.0 if KC < 2.0 else C_pi + 0.10 * (KC - 12.0)


def added_mass(steady: float, keulegan_carpenter: float) -> float:
    """C_A across the cylinder, S4 [2.31], at KC of 0 or more; C_M = 1 + C_A."""
    if keulegan_carpenter < 3.0:
        return 1.0
    return max(1.0 - 0.044 * (keulegan_carpenter - 3.0), 0.6 - (steady - 0.65))


_REACH: Final = 6.0
"""Standard deviations to which the largest velocity is integrated over."""
_CELLS: Final = 96
"""Parts of that way either side together: |r| has a kink, which no rule of high order likes."""
_NODES: Final = 12
"""Nodes of Gauss's rule over the smaller ones."""
_FLAT: Final = 1e-3
"""Part of the largest deviation below which a smaller one is none."""
_AN_AXIS: Final = 1e-4
"""Time that one velocity takes as plain Python, s."""


def equivalent_drag(mean: Array, covariance: Array) -> Array:
    """Linear drag D, (n, 3, 3), m/s, in the place of |r| r: D (r - mean) about its mean.

    `mean` (n, 3), m/s, and `covariance` (n, 3, 3), (m/s)2, of the velocity r.
    """
    squares, axes = np.linalg.eigh(covariance)
    # The largest first.
    spread, axes = np.sqrt(np.maximum(squares[:, ::-1], 0.0)), axes[:, :, ::-1]
    along = np.einsum("nij,ni->nj", axes, mean)
    width = 2.0 * _REACH / _CELLS
    wide = -_REACH + width * (np.arange(_CELLS) + 0.5)
    parts = np.exp(-0.5 * wide**2)
    nodes, weights = np.polynomial.hermite_e.hermegauss(_NODES)
    rules = wide, parts / parts.sum(), nodes, weights / weights.sum()
    found = np.zeros((len(mean), 3, 3))
    compiled(fill_equivalents, _AN_AXIS * len(mean) * _CELLS)(along, spread, *rules, found)
    matrices: Array = np.einsum("nij,njk,nlk->nil", axes, found, axes)
    return matrices


def fill_equivalents(
    mean: Any, spread: Any, wide: Any, parts: Any, nodes: Any, weights: Any, to: Any
) -> None:
    """Write the matrices in their principal axes; `spread` (n, 3): standard deviations, falling."""
    for n in range(mean.shape[0]):
        least = _FLAT * spread[n, 0]
        second = nodes.shape[0] if spread[n, 1] > least else 1
        third = nodes.shape[0] if spread[n, 2] > least else 1
        first = wide.shape[0] if spread[n, 0] > 0.0 else 1
        xx = yy = zz = xy = xz = yz = fx = fy = fz = square = 0.0
        for i in range(first):
            x, own = mean[n, 0], 1.0
            if first > 1:
                x, own = x + spread[n, 0] * wide[i], parts[i]
            for j in range(second):
                y, both = mean[n, 1], own
                if second > 1:
                    y, both = y + spread[n, 1] * nodes[j], own * weights[j]
                for k in range(third):
                    z, w = mean[n, 2], both
                    if third > 1:
                        z, w = z + spread[n, 2] * nodes[k], both * weights[k]
                    size = math.sqrt(x * x + y * y + z * z)
                    over = w / size if size > 0.0 else 0.0
                    xx += w * size + over * x * x
                    yy += w * size + over * y * y
                    zz += w * size + over * z * z
                    xy += over * x * y
                    xz += over * x * z
                    yz += over * y * z
                    fx += w * size * x
                    fy += w * size * y
                    fz += w * size * z
                    square += w * size * size * (x * x + y * y + z * z)
        variance = square - fx * fx - fy * fy - fz * fz
        # Products: plain code rounds a power otherwise than compiled code on some machines.
        s, t, u = spread[n, 0], spread[n, 1], spread[n, 2]
        a, b, c = s * s, t * t, u * u
        linear = a * (xx * xx + xy * xy + xz * xz) + b * (xy * xy + yy * yy + yz * yz)
        linear += c * (xz * xz + yz * yz + zz * zz)
        raised = math.sqrt(variance / linear) if variance > 0.0 and linear > 0.0 else 1.0
        to[n, 0, 0], to[n, 1, 1], to[n, 2, 2] = raised * xx, raised * yy, raised * zz
        to[n, 0, 1] = to[n, 1, 0] = raised * xy
        to[n, 0, 2] = to[n, 2, 0] = raised * xz
        to[n, 1, 2] = to[n, 2, 1] = raised * yz


@dataclass(frozen=True)
class MorisonSection:
    """What the water does to one segment.

    Both drag coefficients refer to the area D per length: a tangential one that refers to the
    circumference pi D (MoorDyn, OrcaFlex) is to be multiplied by pi.
    """

    diameter: float  # drag diameter D, m
    drag_normal: float  # C_n
    drag_tangential: float = 0.0  # C_t
    added_mass_normal: float = 1.0  # Ca_n, on the displaced water; C_M = 1 + Ca
    added_mass_tangential: float = 0.0  # Ca_t
    oblique: tuple[float, float] = (0.0, 0.0)  # m and n, as parts of C_n; they add to C_t

    def __post_init__(self) -> None:
        found = Findings("MorisonSection")
        found.number("diameter", self.diameter, "m", above=0.0)
        found.number("drag_normal", self.drag_normal, "", at_least=0.0)
        found.number("drag_tangential", self.drag_tangential, "", at_least=0.0)
        found.number("added_mass_normal", self.added_mass_normal, "", at_least=0.0)
        found.number("added_mass_tangential", self.added_mass_tangential, "", at_least=0.0)
        for i, part in enumerate(self.oblique):
            found.number(f"oblique[{i}]", part, "", at_least=0.0)
        found.raise_if_any()


@inlined
def axial_drag(
    along: float, across: float, by_along: float, by_speed: float, by_across: float
) -> tuple[float, float, float, float]:
    """Drag along the bar over the velocity along it, with its derivatives.

    `along`, `across`: relative velocity along the bar, and size of that across it, m/s; `by_along`,
    `by_speed`, `by_across`: 0.5 rho D times C_t, C_n m and C_n n, times a length, N s2/m2. Returns:
    drag: A, N s/m; the force is A times `along`; by_turn: of the force, by the turn of the bar over
    `across`; by_itself: of the force, by `along`; by_crossing: of the force, by the velocity
    across, over `across`.
    """
    speed = math.sqrt(along * along + across * across)
    own = by_along * abs(along)
    A = own + by_speed * speed + by_across * across
    over_speed = 1.0 / speed if speed > 0.0 else 0.0
    over_across = 1.0 / across if across > 0.0 else 0.0
    square = along * along
    return (
        A,
        A + own - by_across * square * over_across,
        A + own + by_speed * square * over_speed,
        along * (by_speed * over_speed + by_across * over_across),
    )


@inlined
def split_velocity(
    u: Any, v: Any, node: int, tx: float, ty: float, tz: float
) -> tuple[float, float, float, float, float]:
    """Relative velocity of the water at a node: along the bar, and across it with its size.

    `u`, `v` (nodes, 3): velocities of the water and of the line, m/s. Returns: along, nx, ny, nz,
    size: m/s.
    """
    rx, ry, rz = u[node, 0] - v[node, 0], u[node, 1] - v[node, 1], u[node, 2] - v[node, 2]
    along = rx * tx + ry * ty + rz * tz
    nx, ny, nz = rx - along * tx, ry - along * ty, rz - along * tz
    return along, nx, ny, nz, math.sqrt(nx * nx + ny * ny + nz * nz)
