"""One Newton step for all lines and the body where they meet."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from catopt.fem.assembly import assemble
from catopt.fem.banded import DIAGONAL, back_substitute, eliminate
from catopt.fem.block_tridiagonal import solve_3
from catopt.fem.resting import Bars, Body, Law, Net, State


class StepReport(NamedTuple):
    """What a step found at the shape from which it started."""

    imbalance: float  # largest force left over at a node, N
    node: int  # where; -1 for the body
    strain: float  # largest misfit of a bar's length, relative to it
    tension: float  # largest tension, N
    changed: int  # nodes that touched down or lifted off
    away: float  # distance by which the body is not yet where it is held, m
    turn: float  # largest change of a bar's direction that the step asks for, rad
    singular: bool  # whether the equations had no solution


def newton_step(net: Net, body: Body) -> StepReport:
    """Assemble, measure what is left over, and solve; the step is left in `net.rhs`.

    Its entry 4 e is the change of the tension of bar e over `law.soft`, entries 4 e + 1 to 4 e + 3
    are the displacement of the bar's second node.
    """
    bars, state, band, rhs = net.bars, net.state, net.band, net.rhs
    lines = bars.start.shape[0] - 1
    schur = np.zeros((3, 3))
    total = np.zeros(3)
    left = body.force.copy()
    changed = 0
    strain = 0.0
    singular = False
    for k in range(lines):
        first, end = 4 * bars.start[k], 4 * bars.start[k + 1]
        news, worst = assemble(k, net)
        if news > 0:
            # How a bar shares its weight depends on the states of both its nodes.
            _, worst = assemble(k, net)
        changed += news
        strain = max(strain, worst)
        for i in range(3):
            left[i] += state.balance[bars.start[k + 1] + k, i]
        if eliminate(band, rhs, first, end) >= 0:
            singular = True
        for i in range(3):
            total[i] += rhs[end - 3 + i]
            for j in range(3):
                schur[i, j] += band[end - 3 + i, DIAGONAL + j - i]
    imbalance, node = _largest_imbalance(bars, state, left, body)
    away = _gap_to_place(state.x, bars.start[1], body, total)
    move = _body_move(schur, total, body, net.law)
    for k in range(lines):
        first, end = 4 * bars.start[k], 4 * bars.start[k + 1]
        for i in range(3):
            rhs[end - 3 + i] = move[i]
        back_substitute(band, rhs, first, end)
    turn = _largest_turn(bars, state, rhs)
    tension = 0.0
    for e in range(state.tension.shape[0]):
        tension = max(tension, abs(state.tension[e]))
    singular = singular or not math.isfinite(turn)
    return StepReport(imbalance, node, strain, tension, changed, away, turn, singular)


def take_step(net: Net, part: float) -> None:
    """Move the state by a part of the step that `newton_step` left.

    On the way (e above 0) a tension falls to a tenth at most: it gives the bar its stiffness across
    itself, and a step too far would take that away.
    """
    bars, state, law, rhs = net.bars, net.state, net.law, net.rhs
    for k in range(bars.start.shape[0] - 1):
        for e in range(bars.start[k], bars.start[k + 1]):
            T = state.tension[e] + part * law.soft * rhs[4 * e]
            if law.ease > 0.0 and not law.carries_compression:
                T = max(T, 0.1 * state.tension[e])
            state.tension[e] = T
            for i in range(3):
                state.x[e + k + 1, i] += part * rhs[4 * e + 1 + i]


def _gap_to_place(x: Any, node: int, body: Body, total: Any) -> float:
    """Ask for the way to the body's place in the directions that are held; its largest part, m."""
    away = 0.0
    for i in range(3):
        if body.free[i] == 0.0:
            total[i] = body.place[i] - x[node, i]
            away = max(away, abs(total[i]))
    return away


def _body_move(schur: Any, total: Any, body: Body, law: Law) -> Any:
    """Displacement of the body under what lines and force leave over; nan if it has none."""
    for i in range(3):
        schur[i, i] -= law.drag_in / law.soft
        if body.free[i] == 0.0:
            for j in range(3):
                schur[i, j] = 0.0
            schur[i, i] = 1.0
        else:
            total[i] -= body.force[i] / law.soft
    if not solve_3(schur, total):
        total[:] = math.nan
    return total


def _largest_imbalance(bars: Bars, state: State, left: Any, body: Body) -> tuple[float, int]:
    """Size and place of the largest force left over at a node that may move."""
    square = 0.0
    for i in range(3):
        square += body.free[i] * left[i] ** 2
    largest, place = square, -1
    for k in range(bars.start.shape[0] - 1):
        for node in range(bars.start[k] + k + 1, bars.start[k + 1] + k):
            square = 0.0
            for i in range(3):
                square += state.balance[node, i] ** 2
            if square > largest:
                largest, place = square, node
    return math.sqrt(largest), place


def _largest_turn(bars: Bars, state: State, rhs: Any) -> float:
    """Largest relative displacement of two neighbours, over the distance between them."""
    largest = 0.0
    for k in range(bars.start.shape[0] - 1):
        for e in range(bars.start[k], bars.start[k + 1]):
            a = e + k
            square = 0.0
            size = 0.0
            for i in range(3):
                by = rhs[4 * e + 1 + i] - (rhs[4 * e - 3 + i] if e > bars.start[k] else 0.0)
                square += by * by
                size += (state.x[a + 1, i] - state.x[a, i]) ** 2
            if not square <= largest * largest * size:
                largest = math.sqrt(square / size) if size > 0.0 else math.inf
    return largest
