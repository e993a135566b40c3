"""What pulls on the nodes: weight in water or in air, point loads, drag of a current.

A load per length goes half to each end of its bar, which is what a bar with pinned ends passes on
(S4 [2.92]-[2.96]).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from catopt.constants import SEA_WATER_DENSITY
from catopt.fem.bar import axis
from catopt.model.validity import Findings

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class DragSection:
    """Drag of one segment.

    Attributes
    ----------
    diameter : float
        Drag diameter, m, to which both coefficients refer.
    normal, tangential : float
        Coefficients of 0.5 rho D C |u| u per length, across and along the line. A tangential
        coefficient that refers to the circumference is to be multiplied by pi.
    """

    diameter: float
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
    """Moving water.

    Attributes
    ----------
    velocity : callable
        Takes points, m, shape (n, 3), and gives the water's velocity there, m/s, shape (n, 3).
    sections : sequence of DragSection
        One for each segment, from the anchor.
    water_density : float
        kg/m3.
    """

    velocity: Callable[[Array], Array]
    sections: Sequence[DragSection]
    water_density: float = SEA_WATER_DENSITY


class Weights(NamedTuple):
    """Weight of the bars; arrays of shape (bars,).

    `submerged`, `in_air`: weight of each bar, N; `surface`: height of the still water surface, m;
    infinite when all is taken to be submerged.
    """

    submerged: Array
    in_air: Array
    surface: float


class BarLoads(NamedTuple):
    """What each bar hands to each of its ends.

    `force` (bars, 3): N; `by_first`, `by_second` (bars, 3, 3): derivatives by the coordinates of
    its first and second node, N/m; of shape (0, 3, 3) when the loads do not depend on the shape.
    """

    force: Array
    by_first: Array
    by_second: Array


def bar_loads(
    x: Any,
    first_node: Any,
    weights: Weights,
    length: Any,
    across: Any,
    along: Any,
    velocity: Any,
    loads: BarLoads,
) -> None:
    """Fill `loads` for the shape `x`.

    `x` (nodes, 3): coordinates, m; `first_node` (bars,): first node of each bar; `length` (bars,):
    unstretched length, m; `across`, `along` (bars,): 0.5 rho D C across and along, N s2/m3; of
    shape (0,) without a current; `velocity` (bars, 3): of the water at the bars' middles, m/s;
    `loads`: written to.
    """
    force, by_first, by_second = loads
    varies = by_first.shape[0] > 0
    for e in range(force.shape[0]):
        force[e, 0] = 0.0
        force[e, 1] = 0.0
        force[e, 2] = -0.5 * weights.submerged[e]
        if varies:
            by_first[e, :, :] = 0.0
            by_second[e, :, :] = 0.0
            _lift_from_water(x, first_node[e], e, weights, loads)
            if across.shape[0] > 0:
                half = 0.5 * length[e]
                _drag(x, first_node[e], e, half * across[e], half * along[e], velocity[e], loads)


def _lift_from_water(x: Any, a: int, e: int, weights: Weights, loads: BarLoads) -> None:
    """Add the weight that a bar gains by the part of it above the water."""
    low, high = 0, 1
    if x[a, 2] > x[a + 1, 2]:
        low, high = 1, 0
    z_low, z_high = x[a + low, 2], x[a + high, 2]
    if z_high <= weights.surface:
        return
    gain = 0.5 * (weights.in_air[e] - weights.submerged[e])
    if z_low >= weights.surface:
        loads.force[e, 2] -= gain
        return
    rise = z_high - z_low
    dry = (z_high - weights.surface) / rise
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
