"""A bar of which one part lies on a rigid bed and the other hangs: what each of its nodes carries.

Half of a bar's weight to each node would move the touchdown from node to node. A bar whose first
node lies and whose second hangs touches down between them. Over its hanging part r l the line is
a parabola, level at the touchdown; moments about the second node and the first give

    V = W r^2 / 2            lift at the lying node, V = T t_z, so that r = sqrt(2 V / W)
    W (r - r^2 / 2)          weight that the hanging node carries

and the lying node has the rest, of which the bed carries W (1 - r). So W (1 - r)^2 / 2 goes over
from the hanging node to the lying one. At r = 1 the weight is halved, and the lying node lifts off
when more than that pulls on it; its other bar then begins with r = 0.
"""

from __future__ import annotations

import math
from typing import Any, Final

from catopt.fem.banded import DIAGONAL
from catopt.fem.bed import FREE, ON_BED

_LEAST: Final = 1e-14
"""r that is rounding."""


def hanging_part(lift: float, weight: float) -> float:
    """Give the part r of a bar that hangs, from 0 to 1; `lift`, `weight`: V and W, N."""
    if weight <= 0.0 or 2.0 * lift >= weight:
        return 1.0
    return math.sqrt(2.0 * lift / weight) if lift > 0.0 else 0.0


def hanging_node(a: int, contact: Any) -> int:
    """Give the node that hangs of a bar whose other node lies on the bed; -1 for none."""
    if contact[a] == ON_BED and contact[a + 1] == FREE:
        return a + 1
    if contact[a] == FREE and contact[a + 1] == ON_BED:
        return a
    return -1


def share_weight(a: int, hangs: int, rise: float, weight: float, balance: Any) -> None:
    """Shift weight from the hanging node of a bar to the lying one; `rise`: T t_z of it, N."""
    lift = rise if hangs > a else -rise
    shifted = 0.5 * weight * (1.0 - hanging_part(lift, weight)) ** 2
    balance[2 * a + 1 - hangs, 2] -= shifted
    balance[hangs, 2] += shifted


def shift_slope(lift: float, weight: float, left: float) -> float:
    """By how much less weight is shifted as the lift grows: (1 - r)/r, but between two points.

    The square root is followed from the lift there is to the one that ends the imbalance of the
    hanging node, not along its tangent, which is of no use near r = 0. With the shift that node is
    left with W (q - r), where q is the part that has to hang; so what is wanted is the lift at q.
    r and q go on below 0, as V/W, and above 1, as V/W + 1/2: there nothing more is shifted. `left`:
    upward force left over at the hanging node, N.
    """
    if weight <= 0.0 or 2.0 * lift >= weight:
        return 0.0
    now = lift / weight
    r = math.sqrt(2.0 * now) if now > 0.0 else now
    q = r + left / weight
    if r >= 0.0 and 0.0 <= q <= 1.0:
        return 2.0 / max(r + q, _LEAST) - 1.0
    wanted = q if q < 0.0 else (0.5 * q * q if q <= 1.0 else q - 0.5)
    return (q - r) / (wanted - now) - 1.0 if wanted != now else 0.0


def share_slope(row: int, slope: float, t: Any, across: float, band: Any) -> None:
    """Write the derivatives of `share_weight`; `slope`: of what is shifted (`shift_slope`)."""
    band[row + 3, DIAGONAL - 3] -= slope * t[2]
    band[row - 1, DIAGONAL + 1] += slope * t[2]
    for j in range(3):
        g = slope * across * ((1.0 if j == 2 else 0.0) - t[2] * t[j])
        band[row + 3, DIAGONAL - 2 + j] -= g
        band[row + 3, DIAGONAL - 6 + j] += g
        band[row - 1, DIAGONAL + 2 + j] += g
        band[row - 1, DIAGONAL - 2 + j] -= g


def own_rest(node: int, below: float, above: float, contact: Any) -> float:
    """Weight that keeps lying when a node lifts off, N: half of each bar that lies wholly.

    `below`, `above`: weight of the bars towards the anchor and the fairlead, N.
    """
    rest = 0.0
    if contact[node - 1] == ON_BED:
        rest += 0.5 * max(below, 0.0)
    if contact[node + 1] == ON_BED:
        rest += 0.5 * max(above, 0.0)
    return rest * (1.0 - 1e-9)
