"""What pulls on the nodes: bars, weight in water or in air, point loads, drag of a current.

The bar has three displacements a node and no bending. With d = x2 - x1, l = |d|, t = d/l and the
unstretched length l0 its force is T = EA (l - l0)/l0 (per unstretched length), and a change of d
changes T t by the elastic stiffness EA/l0 along the bar and the geometric stiffness T/l across it
(S4 [2.80]-[2.96]). A load per length goes half to each end, as by a bar with pinned ends.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from catopt.arrays import Array
from catopt.compiled import inlined
from catopt.constants import SEA_WATER_DENSITY
from catopt.fem.static_model import BarLoads, Bars
from catopt.model.kinds import Findings


@dataclass(frozen=True)
class DragSection:
    """Drag of one segment.

    0.5 rho D C |u| u per length, across and along the line; a tangential
    coefficient that refers to the circumference is to be multiplied by pi.
    """

    diameter: float  # D, m, to which both coefficients refer
    normal: float
    tangential: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("DragSection")
        found.number("diameter", self.diameter, "m", above=0.0)
        found.number("normal", self.normal, "", at_least=0.0)
        found.number("tangential", self.tangential, "", at_least=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class Current:
    """Moving water."""

    velocity: Callable[[Array], Array]  # of the water, m/s, at points, m; both of shape (n, 3)
    sections: Sequence[DragSection]  # one for each segment, from the anchor
    water_density: float = SEA_WATER_DENSITY  # kg/m3


@inlined
def axis(x: Any, first: int) -> tuple[float, float, float, float]:
    """Give the length, m, of the bar between nodes `first` and `first + 1`, and its direction t."""
    dx = x[first + 1, 0] - x[first, 0]
    dy = x[first + 1, 1] - x[first, 1]
    dz = x[first + 1, 2] - x[first, 2]
    length = math.sqrt(dx * dx + dy * dy + dz * dz)
    if length == 0.0:
        return 0.0, 1.0, 0.0, 0.0
    return length, dx / length, dy / length, dz / length


def bar_loads(
    x: Any, first_node: Any, bars: Bars, surface: float, velocity: Any, loads: BarLoads
) -> None:
    """Fill `loads` for the shape `x`.

    `first_node` (bars,): first node of each bar; `surface`: height of still water, m; `velocity`
    (bars, 3): of the water at the bars' middles, m/s.
    """
    force, by_first, by_second = loads
    varies = by_first.shape[0] > 0
    for e in range(force.shape[0]):
        force[e, 0] = 0.0
        force[e, 1] = 0.0
        force[e, 2] = -0.5 * bars.submerged[e]
        if varies:
            by_first[e, :, :] = 0.0
            by_second[e, :, :] = 0.0
            gain = 0.5 * (bars.in_air[e] - bars.submerged[e])
            _lift_from_water(x, first_node[e], e, gain, surface, loads)
            if bars.across.shape[0] > 0:
                half = 0.5 * bars.length[e]
                across, along = half * bars.across[e], half * bars.along[e]
                _drag(x, first_node[e], e, across, along, velocity[e], loads)


def _lift_from_water(x: Any, a: int, e: int, gain: float, surface: float, loads: BarLoads) -> None:
    """Add what a bar weighs more by the part of it above the water; `gain`: half of all, N."""
    low, high = 0, 1
    if x[a, 2] > x[a + 1, 2]:
        low, high = 1, 0
    z_low, z_high = x[a + low, 2], x[a + high, 2]
    if z_high <= surface:
        return
    if z_low >= surface:
        loads.force[e, 2] -= gain
        return
    rise = z_high - z_low
    dry = (z_high - surface) / rise
    loads.force[e, 2] -= gain * dry
    by_low, by_high = gain * dry / rise, gain * (1.0 - dry) / rise
    loads.by_first[e, 2, 2] -= by_low if low == 0 else by_high
    loads.by_second[e, 2, 2] -= by_high if low == 0 else by_low


def _drag(x: Any, a: int, e: int, across: float, along: float, u: Any, loads: BarLoads) -> None:
    """Add drag across |u_n| u_n and along |u_t| u_t, and its change with the bar's direction."""
    size, tx, ty, tz = axis(x, a)
    t = (tx, ty, tz)
    u_t = u[0] * tx + u[1] * ty + u[2] * tz
    n = (u[0] - u_t * tx, u[1] - u_t * ty, u[2] - u_t * tz)
    u_n = math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
    inverse = 1.0 / u_n if u_n > 0.0 else 0.0
    for i in range(3):
        loads.force[e, i] += across * u_n * n[i] + along * abs(u_t) * u_t * t[i]
        for j in range(3):
            # Derivative by t_k, projected across the bar and divided by its length.
            total = 0.0
            for k in range(3):
                # du_n,i/dt_k = -u_k t_i - u_t delta_ik, and d|u_n|/dt_k = -u_t n_k / |u_n|
                slope = across * (
                    -u_t * n[k] * inverse * n[i] - u_n * (u[k] * t[i] + (u_t if i == k else 0.0))
                )
                slope += along * abs(u_t) * (2.0 * u[k] * t[i] + (u_t if i == k else 0.0))
                total += slope * ((1.0 if k == j else 0.0) - t[k] * t[j])
            loads.by_second[e, i, j] += total / size
            loads.by_first[e, i, j] -= total / size
