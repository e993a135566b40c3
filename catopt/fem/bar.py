"""The two-node bar: axial force from the coordinates of its ends, and its tangent stiffness.

Three displacements a node, no bending. With d = x2 - x1, l = |d|, t = d/l and the unstretched
length l0 the axial force is T = EA (l - l0)/l0 (per unstretched length), and a change of d changes
the force T t by the elastic stiffness EA/l0 along the bar and the geometric stiffness T/l across
it (S4 [2.80]-[2.96]).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from catopt.compiled import inlined

__all__ = ["axis", "bar_force", "bar_stiffness"]

Array = npt.NDArray[np.float64]


@inlined
def axis(x: Any, first: int) -> tuple[float, float, float, float]:
    """Give the current length of the bar between nodes `first` and `first + 1`, and its direction.

    `x` (nodes, 3): coordinates, m. Returns: length, tx, ty, tz: m, and the unit vector towards the
    second node.
    """
    dx = x[first + 1, 0] - x[first, 0]
    dy = x[first + 1, 1] - x[first, 1]
    dz = x[first + 1, 2] - x[first, 2]
    length = math.sqrt(dx * dx + dy * dy + dz * dz)
    if length == 0.0:
        return 0.0, 1.0, 0.0, 0.0
    return length, dx / length, dy / length, dz / length


def bar_force(x1: Array, x2: Array, l0: float, EA: float, *, compression: bool = True) -> Array:
    """Force with which a bar pulls its first node towards its second, N, shape (3,).

    `x1`, `x2` (3,): coordinates of the ends, m; `l0`: unstretched length, m; `EA`: axial stiffness,
    N; `compression`: whether the bar pushes when it is shorter than `l0`.
    """
    d = x2 - x1
    length = float(np.linalg.norm(d))
    tension = EA * (length - l0) / l0
    if not compression:
        tension = max(tension, 0.0)
    force: Array = tension / length * d
    return force


def bar_stiffness(x1: Array, x2: Array, l0: float, EA: float) -> Array:
    """Tangent of `bar_force` by x2 (and its negative by x1), N/m, shape (3, 3)."""
    d = x2 - x1
    length = float(np.linalg.norm(d))
    along = np.outer(d, d) / length**2
    elastic = EA / l0 * along
    geometric = EA * (length - l0) / l0 / length * (np.eye(3) - along)
    stiffness: Array = elastic + geometric
    return stiffness
