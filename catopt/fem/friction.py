"""Coulomb's friction of a node on the bed: for a line that was pulled, and with a history.

Friction of a sliding node is mu R along the bed; a point load may have a mu of its own. R follows
from the balance in height, which has the rows of the node's own neighbours, so that its change
enters the linear equations exactly.
"""

from __future__ import annotations

import math
from typing import Any

from catopt.fem.banded import DIAGONAL
from catopt.fem.bar import axis
from catopt.fem.bed import ON_BED, Ground


def limit(node: int, reaction: float, ground: Ground, contact: Any) -> float:
    """Return the friction at which a node slides, N.

    `node`, `reaction`: the node, and what the bed carries there, N.
    """
    most = float(ground.friction[node]) * reaction
    for side in range(2):
        beside = ground.beside[node, side]
        if beside != 0.0 and contact[node - 1 + 2 * side] == ON_BED:
            most += beside
    return max(most, 0.0)


def rub(
    x: Any, node: int, row: int, T: float, most: float, friction: float, soft: float,
    rigid: bool, stiffness: float, balance: Any, band: Any,
) -> None:  # fmt: skip
    """Add the friction of a line that was pulled towards the fairlead, or laid.

    Friction acts against the pull of the bar at the fairlead's side, with mu R or with what that
    bar pulls, whichever is less, so that tension falls to 0 and not below. With negative `most` and
    `friction` it acts along that pull, so that tension grows.

    `x` (nodes, 3): coordinates, m; `T`, `most`: tension of the bar at the fairlead's side and the
    `limit` of the friction, N; `friction`, `soft`: Coulomb coefficient; unit of force of the
    equations, N; `rigid`, `stiffness`: whether the bed is rigid, else its stiffness under the node,
    N/m; `balance` (3,): of the node; for a rigid bed without the reaction; `band` (rows, 19):
    equations.
    """
    size, tx, ty, _ = axis(x, node)
    level = math.sqrt(tx * tx + ty * ty)
    if level == 0.0 or T <= 0.0:
        return
    d = (tx / level, ty / level)
    if T * level <= most:
        _hold(size, x, node, row, T, soft, balance, band)
        return
    turn = most / (level * size * soft)
    for i in range(2):
        balance[i] -= most * d[i]
        if rigid:
            _add_row(band, row + i, row + 2, friction * d[i])
        else:
            band[row + i, DIAGONAL + 2 - i] += friction * d[i] * stiffness / soft
        for j in range(2):
            g = turn * ((1.0 if i == j else 0.0) - d[i] * d[j])
            band[row + i, DIAGONAL + j - i] += g
            band[row + i, DIAGONAL + 4 + j - i] -= g


def _hold(
    size: float, x: Any, node: int, row: int, T: float, soft: float, balance: Any, band: Any
) -> None:
    """Let friction take up all that the bar at the fairlead's side pulls along the bed."""
    _, tx, ty, tz = axis(x, node)
    t = (tx, ty, tz)
    for i in range(2):
        balance[i] -= T * t[i]
        band[row + i, DIAGONAL + 3 - i] -= t[i]
        for j in range(3):
            g = T / (size * soft) * ((1.0 if i == j else 0.0) - t[i] * t[j])
            band[row + i, DIAGONAL + j - i] += g
            band[row + i, DIAGONAL + 4 + j - i] -= g


def drag_spring(
    x: Any, foot: Any, spring: float, row: int, most: float, friction: float, soft: float,
    rigid: bool, stiffness: float, balance: Any, band: Any,
) -> None:  # fmt: skip
    """Add the force of a node's friction spring: elastic below mu R, slipping at it.

    `x` (3,): coordinates of the node, m; `foot` (2,): where the spring has its foot, m; `spring`:
    its stiffness, N/m.
    """
    u = (x[0] - foot[0], x[1] - foot[1])
    distance = math.sqrt(u[0] * u[0] + u[1] * u[1])
    if spring * distance <= most or distance == 0.0:
        for i in range(2):
            balance[i] -= spring * u[i]
            band[row + i, DIAGONAL] -= spring / soft
        return
    for i in range(2):
        n = u[i] / distance
        balance[i] -= most * n
        if rigid:
            _add_row(band, row + i, row + 2, friction * n)
        else:
            band[row + i, DIAGONAL + 2 - i] += friction * n * stiffness / soft
        for j in range(2):
            across = (1.0 if i == j else 0.0) - n * u[j] / distance
            band[row + i, DIAGONAL + j - i] -= most / (distance * soft) * across


def _add_row(band: Any, to: int, source: int, factor: float) -> None:
    """Add a multiple of one row of the band to another, not far below it."""
    shift = source - to
    for c in range(2 * DIAGONAL + 1):
        if c + shift < band.shape[1]:
            band[to, c + shift] += factor * band[source, c]


def slipped_foot(
    x: float, y: float, foot_x: float, foot_y: float, reach: float
) -> tuple[float, float]:
    """Foot of a friction spring after the node moved: dragged along so that it is `reach` away.

    `x`, `y`, `foot_x`, `foot_y`: node and foot, m; `reach`: largest elongation, mu R over the
    spring's stiffness, m.
    """
    dx, dy = x - foot_x, y - foot_y
    distance = math.hypot(dx, dy)
    if distance <= reach:
        return foot_x, foot_y
    keep = reach / distance
    return x - keep * dx, y - keep * dy
