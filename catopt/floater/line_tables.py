"""Tensions of a ship's lines out of tables: closed form at nodes, straight lines between them.

A line's force grows ever faster as it tautens: what lies between two nodes is taken up to a
thousandth too large, never too small.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from catopt.catenary.equilibrium import given_force
from catopt.catenary.pieces import LineProblem, Pieces, total_length, total_weight
from catopt.catenary.state import CONVERGED
from catopt.compiled import compiled
from catopt.mooring.net import Net, problem_at
from catopt.mooring.under_loads import as_arrays

NODES: Final = 300
"""Of the horizontal force, after 0, each 1.05 times the one before."""
_LEAST: Final = 5e-4
_MOST: Final = 1e3
"""Forces of the first node and of the last, in weights of the line."""
_COLUMNS: Final = 7
"""Heights of the fairlead."""


class LineTables(NamedTuple):
    """Tables of lines, one after the other; lists in plain code, arrays in compiled code.

    `table`: that of each line, or -1 for each where there are none; `low` and `rise`: the least
    height of its fairlead and the way from one to the next, m; `force` (tables, nodes); `span`,
    `fairlead` and `anchor` (tables, heights, nodes): spans, m, and tensions at both ends, N.
    """

    table: Any
    low: Any
    rise: Any
    force: Any
    span: Any
    fairlead: Any
    anchor: Any


def no_tables() -> LineTables:
    """Make what says that lines are solved by closed form."""
    return LineTables([-1], [0.0], [0.0], [0.0], [0.0], [0.0], [0.0])


class Tabulated(NamedTuple):
    """Forces of a line out of its table, N; `held`: whether it reaches."""

    held: bool
    H: float
    fairlead: float
    anchor: float


def tabulated(k: int, span: float, height: float, tables: LineTables) -> Tabulated:
    """Read line k at a span and a height of its fairlead, m."""
    own = tables.table[k]
    place = (height - tables.low[own]) / tables.rise[own]
    column = min(max(int(place), 0), _COLUMNS - 2)
    part = min(max(place - column, 0.0), 1.0)
    count = NODES + 1
    below = (own * _COLUMNS + column) * count
    above = below + count
    left, right = 0, count - 1
    end = tables.span[below + right] * (1.0 - part) + tables.span[above + right] * part
    if span > end:
        return Tabulated(False, 0.0, 0.0, 0.0)
    while right - left > 1:
        middle = (left + right) // 2
        there = tables.span[below + middle] * (1.0 - part) + tables.span[above + middle] * part
        if there <= span:
            left = middle
        else:
            right = middle
    start = tables.span[below + left] * (1.0 - part) + tables.span[above + left] * part
    end = tables.span[below + right] * (1.0 - part) + tables.span[above + right] * part
    # Closer than a slack line reaches it pulls to no side.
    way = 0.0 if end <= start else min(max((span - start) / (end - start), 0.0), 1.0)
    i, j = below + left, above + left
    fairlead = (tables.fairlead[i] * (1.0 - part) + tables.fairlead[j] * part) * (1.0 - way)
    fairlead += (tables.fairlead[i + 1] * (1.0 - part) + tables.fairlead[j + 1] * part) * way
    anchor = (tables.anchor[i] * (1.0 - part) + tables.anchor[j] * part) * (1.0 - way)
    anchor += (tables.anchor[i + 1] * (1.0 - part) + tables.anchor[j + 1] * part) * way
    node = own * count + left
    H = tables.force[node] * (1.0 - way) + tables.force[node + 1] * way
    return Tabulated(True, H, fairlead, anchor)


class SpanUnder(NamedTuple):
    """Span of a line under a horizontal force, m, nan beyond its table; its stiffness, N/m."""

    length: float
    stiffness: float


def span_under(force: float, height: float, tables: LineTables) -> SpanUnder:
    """Read the first line under a horizontal force, N, with its fairlead at a height, m."""
    place = (height - tables.low[0]) / tables.rise[0]
    column = min(max(int(place), 0), _COLUMNS - 2)
    part, count = place - column, NODES + 1
    ratio = math.log(_MOST / _LEAST) / (NODES - 1)
    least = float(tables.force[1])
    node = 0 if force < least else 1 + int(math.log(force / least) / ratio)
    if node >= NODES:
        return SpanUnder(math.nan, math.nan)
    below, above = column * count + node, (column + 1) * count + node
    start = tables.span[below] * (1.0 - part) + tables.span[above] * part
    end = tables.span[below + 1] * (1.0 - part) + tables.span[above + 1] * part
    step = float(tables.force[node + 1] - tables.force[node])
    way = (force - float(tables.force[node])) / step
    return SpanUnder(float(start + way * (end - start)), step / max(float(end - start), 1e-12))


def fill_table(problem: LineProblem, force: Any, span: Any, fairlead: Any, anchor: Any) -> int:
    """Solve a line at each force; how many have an answer."""
    for i in range(len(force)):
        state = given_force(force[i], problem)
        if state.status != CONVERGED:
            return i
        span[i] = state.span
        fairlead[i] = math.sqrt(state.H * state.H + state.V * state.V)
        anchor[i] = math.sqrt(state.H_anchor * state.H_anchor + state.V_anchor * state.V_anchor)
    return len(force)


def tables_of(net: Net, way: float) -> Any:
    """Tabulate lines whose fairleads rise and fall by up to a way, m; None where one has no answer.

    Lines that are alike share a table.
    """
    made = LineTables([], [], [], [], [], [], [])
    known: dict[tuple[Any, ...], int] = {}
    for k in range(net.used[0]):
        height, below = net.base[6 * k + 5], net.base[6 * k + 2]
        pieces, friction = problem_at(k, below, height, net).pieces, net.friction[k]
        key = (height, below, *(tuple(map(float, each)) for each in pieces))
        if key not in known:
            known[key] = len(known)
            if not _tabulate(made, pieces, height, below, friction, way):
                return None
        made.table.append(known[key])
    return as_arrays(made)


def _tabulate(
    made: LineTables, pieces: Pieces, height: float, below: float, friction: float, way: float
) -> bool:
    rise = 2.0 * max(way, 1e-3) / (_COLUMNS - 1)
    low = height - max(way, 1e-3)
    weight = abs(total_weight(pieces))
    ratio = (_MOST / _LEAST) ** (1.0 / (NODES - 1))
    force = [_LEAST * weight * ratio**i for i in range(NODES)]
    solve = compiled(fill_table)
    asked = np.array(force)
    made.low.append(low)
    made.rise.append(rise)
    made.force.extend((0.0, *force))
    for column in range(_COLUMNS):
        at = low + column * rise
        problem = LineProblem(pieces, below, at, friction)
        if at - below >= total_length(pieces):
            return False
        span, fairlead, anchor = (np.zeros(NODES) for _ in range(3))
        if solve(problem, asked, span, fairlead, anchor) < NODES:
            return False
        # A slack line lies below its fairlead; the first node is all but that.
        for table, values in ((made.span, span), (made.fairlead, fairlead), (made.anchor, anchor)):
            first = values[0] if table is made.fairlead else 0.0
            table.extend(map(float, (first, *values)))
    return True
