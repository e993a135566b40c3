"""The two-node bar: its length and direction from the coordinates of its ends.

Three displacements a node, no bending. With d = x2 - x1, l = |d|, t = d/l and the unstretched
length l0 the axial force is T = EA (l - l0)/l0 (per unstretched length), and a change of d changes
the force T t by the elastic stiffness EA/l0 along the bar and the geometric stiffness T/l across
it (S4 [2.80]-[2.96]).
"""

from __future__ import annotations

import math
from typing import Any

from catopt.compiled import inlined


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
