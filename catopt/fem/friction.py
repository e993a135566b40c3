"""Coulomb's friction of a node on the bed: for a line that was pulled, and with a history.

Friction of a sliding node is mu R along the bed; a point load may have a mu of its own. R follows
from the balance in height, which has the rows of the node's own neighbours, so that its change
enters the linear equations exactly.
"""

from __future__ import annotations

import math
from typing import Any

from catopt.fem.banded import DIAGONAL
from catopt.fem.loads import axis
from catopt.fem.seabed import ON_BED, SPRING, Ground, friction_sense
from catopt.fem.static_model import Net, row_of_bar


def limit(node: int, reaction: float, ground: Ground, contact: Any) -> float:
    """Return the friction at which a node slides under what the bed carries there, N."""
    most = float(ground.friction[node]) * reaction
    for side in range(2):
        beside = ground.beside[node, side]
        if beside != 0.0 and contact[node - 1 + 2 * side] == ON_BED:
            most += beside
    return max(most, 0.0)


def add_friction(e: int, node: int, pushed: float, rigid: bool, net: Net) -> None:
    """Add the friction of the first node of bar `e`, which the bed pushes with `pushed`, N."""
    state, ground = net.state, net.ground
    mu, most = ground.friction[node], limit(node, pushed, ground, state.contact)
    sense = friction_sense(ground.law)
    if sense != 0.0:
        _rub(e, node, sense * most, sense * mu, rigid, net)
    elif ground.law == SPRING and not math.isnan(ground.spring_foot[node, 0]):
        _drag_spring(e, node, most, mu, rigid, net)


def _rub(e: int, node: int, most: float, mu: float, rigid: bool, net: Net) -> None:
    """Add the friction of a line that was pulled towards the fairlead, or laid.

    Friction acts against the pull of the bar at the fairlead's side, with mu R or with what that
    bar pulls, whichever is less, so that tension falls to 0 and not below. With negative `most`, N,
    and `mu` it acts along that pull, so that tension grows.
    """
    state, band, soft, row = net.state, net.band, net.law.soft, row_of_bar(e, node - e) - 3
    T = state.tension[e]
    size, tx, ty, _ = axis(state.x, node)
    level = math.sqrt(tx * tx + ty * ty)
    if level == 0.0 or T <= 0.0:
        return
    if T * level <= most:
        _hold(e, node, net)
        return
    d = (tx / level, ty / level)
    _slide(e, node, d, most, mu, rigid, net)
    turn = most / (level * size * soft)
    for i in range(2):
        for j in range(2):
            g = turn * ((1.0 if i == j else 0.0) - d[i] * d[j])
            band[row + i, DIAGONAL + j - i] += g
            band[row + i, DIAGONAL + 4 + j - i] -= g


def _hold(e: int, node: int, net: Net) -> None:
    """Let friction take up all that the bar at the fairlead's side pulls along the bed."""
    state, band, row = net.state, net.band, row_of_bar(e, node - e) - 3
    T = state.tension[e]
    size, tx, ty, tz = axis(state.x, node)
    t = (tx, ty, tz)
    for i in range(2):
        state.balance[node, i] -= T * t[i]
        band[row + i, DIAGONAL + 3 - i] -= t[i]
        for j in range(3):
            g = T / (size * net.law.soft) * ((1.0 if i == j else 0.0) - t[i] * t[j])
            band[row + i, DIAGONAL + j - i] += g
            band[row + i, DIAGONAL + 4 + j - i] -= g


def _drag_spring(e: int, node: int, most: float, mu: float, rigid: bool, net: Net) -> None:
    """Add the force of a node's friction spring: elastic below mu R, slipping at it."""
    x, foot, spring = net.state.x, net.ground.spring_foot, net.ground.tangential[node]
    band, soft, row = net.band, net.law.soft, row_of_bar(e, node - e) - 3
    u = (x[node, 0] - foot[node, 0], x[node, 1] - foot[node, 1])
    distance = math.sqrt(u[0] * u[0] + u[1] * u[1])
    if spring * distance <= most or distance == 0.0:
        for i in range(2):
            net.state.balance[node, i] -= spring * u[i]
            band[row + i, DIAGONAL] -= spring / soft
        return
    n = (u[0] / distance, u[1] / distance)
    _slide(e, node, n, most, mu, rigid, net)
    for i in range(2):
        for j in range(2):
            across = (1.0 if i == j else 0.0) - n[i] * u[j] / distance
            band[row + i, DIAGONAL + j - i] -= most / (distance * soft) * across


def _slide(e: int, node: int, n: Any, most: float, mu: float, rigid: bool, net: Net) -> None:
    """Add a friction of `most`, N, against the direction n along the bed, and its change with R."""
    band, row = net.band, row_of_bar(e, node - e) - 3
    for i in range(2):
        net.state.balance[node, i] -= most * n[i]
        if rigid:
            # A multiple of the row of the balance in height, 2 - i below.
            for c in range(2 * DIAGONAL + 1):
                if c + 2 - i < band.shape[1]:
                    band[row + i, c + 2 - i] += mu * n[i] * band[row + 2, c]
        else:
            change = mu * n[i] * net.ground.stiffness[node] / net.law.soft
            band[row + i, DIAGONAL + 2 - i] += change
