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

__all__ = ["hanging_part", "own_rest", "share_weight"]

_LEAST: Final = 1e-3
"""r below which the slope of the square root is no longer followed."""


def hanging_part(lift: float, weight: float) -> float:
    """Give the part r of a bar that hangs, from 0 to 1.

    Parameters
    ----------
    lift, weight : float
        V and W, N.
    """
    if weight <= 0.0 or 2.0 * lift >= weight:
        return 1.0
    return math.sqrt(2.0 * lift / weight) if lift > 0.0 else 0.0


def share_weight(
    a: int, row: int, has_first: bool, T: float, t: Any, across: float, weight: float,
    contact: Any, balance: Any, band: Any,
) -> None:  # fmt: skip
    """Shift weight from the hanging node of a bar to the lying one, with its derivatives.

    Parameters
    ----------
    a, row, has_first : int, int, bool
        First node, row of the bar's tension, whether the first node has rows of its own.
    T, t : float, tuple
        Tension, N, and direction.
    across, weight : float
        Stiffness across the bar in the equations' unit, and its weight, N.
    contact, balance, band : array
        As in `assembly`.
    """
    lies = contact[a] == ON_BED
    other = contact[a + 1] if lies else contact[a]
    if other != FREE or (not lies and contact[a + 1] != ON_BED):
        return
    sign = 1.0 if lies else -1.0
    lift = sign * T * t[2]
    r = hanging_part(lift, weight)
    if r == 1.0:
        return
    shifted = sign * 0.5 * weight * (1.0 - r) ** 2
    balance[a, 2] -= shifted
    balance[a + 1, 2] += shifted
    slope = (1.0 - r) / max(r, _LEAST)
    band[row + 3, DIAGONAL - 3] -= slope * t[2]
    if has_first:
        band[row - 1, DIAGONAL + 1] += slope * t[2]
    for j in range(3):
        g = slope * across * ((1.0 if j == 2 else 0.0) - t[2] * t[j])
        band[row + 3, DIAGONAL - 2 + j] -= g
        if has_first:
            band[row + 3, DIAGONAL - 6 + j] += g
            band[row - 1, DIAGONAL + 2 + j] += g
            band[row - 1, DIAGONAL - 2 + j] -= g


def own_rest(node: int, below: float, above: float, contact: Any) -> float:
    """Weight that keeps lying when a node lifts off, N: half of each bar that lies wholly.

    Parameters
    ----------
    node : int
        The node.
    below, above : float
        Weight of the bars towards the anchor and the fairlead, N.
    contact : array of int
        States of the nodes.
    """
    rest = 0.0
    if contact[node - 1] == ON_BED:
        rest += 0.5 * max(below, 0.0)
    if contact[node + 1] == ON_BED:
        rest += 0.5 * max(above, 0.0)
    return rest * (1.0 - 1e-9)
