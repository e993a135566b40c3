"""Lines at rest as the kernels take them: what they are made of, their shape, the law of the bars.

All bars follow one another, line after line. Line k has one node more than bars: bar e lies between
nodes e + k and e + k + 1. The equations of line k begin with three of its first node, then come
that of a bar and three of its second node, and so on: see `row_of_bar`.
"""

from __future__ import annotations

from typing import NamedTuple

from catopt.arrays import Array, Codes
from catopt.fem.seabed import SLACK, Ground


def row_of_bar(e: int, line: int) -> int:
    """Row of the strain of a bar; those of its first node are the three before it."""
    return 4 * e + 3 * line + 3


class Bars(NamedTuple):
    """All bars; arrays of shape (bars,) but `start`."""

    length: Array  # unstretched, m
    compliance: Array  # 1/EA, 1/N
    start: Codes  # (lines + 1,): first bar of each line
    submerged: Array  # weight in water, N
    in_air: Array  # weight in air, N
    across: Array  # 0.5 rho D C across the bar, N s2/m3; of shape (0,) without a current
    along: Array  # the same along it


class BarLoads(NamedTuple):
    """What each bar hands to each of its ends."""

    force: Array  # (bars, 3), N
    by_first: Array  # (bars, 3, 3): derivative by the coordinates of its first node, N/m
    by_second: Array  # of its second; both (0, 3, 3) when loads do not depend on the shape


class State(NamedTuple):
    """Shape and forces."""

    x: Array  # (nodes, 3): coordinates, m
    tension: Array  # (bars,), N
    contact: Codes  # (nodes,): what the bed does to each node (`seabed`)
    reaction: Array  # (nodes,): upward force of the bed on each node, N
    balance: Array  # (nodes, 3): force on each node from bars, loads and bed, N: 0 at the inner
    # nodes in equilibrium, the force on the support at the ends
    laid: Codes  # (lines,): how each line touches down: SHARING, HALVING or SLACK (`seabed`)


class Law(NamedTuple):
    """How bars behave on the way to the answer."""

    ease: float  # e: 1 for springs without length, 0 for the bars as they are
    soft: float  # K, N: stiffness of those springs; also the unit of force of the equations
    keep: float  # part of K that a bar too long by all its length keeps as tension; see `kept`
    carries_compression: bool  # whether a bar pushes when it is shorter than its length
    drag_in: float  # stiffness, N/m, that holds each node to where it is in one step; it speaks
    # only where nothing else holds a node, and not in the answer


def kept(line: int, state: State, law: Law) -> float:
    """Part of K that bars of a line keep as tension where they are too long by all their length.

    On the way those of every line do, for a bight to follow smoothly to where it lies; at the end
    those of slack lines alone, which nothing else holds along a smooth bed.
    """
    return law.keep if law.ease > 0.0 or state.laid[line] == SLACK else 0.0


class Body(NamedTuple):
    """The nodes in which lines meet: a joint, or a body that does not turn. Of shape (points, 3).

    The ends of lines that move with a point keep their distance from it.
    """

    free: Array  # 1.0 for each direction in which it may move, 0.0 where it is held
    force: Array  # on it, N
    place: Array  # of the first end that moves with it in the directions that are held, m
    of_end: Codes  # (lines, 2): point with which the first and the last node of a line move; -1:
    # none, it stays
    lies: Codes  # (points,): 1 for a joint, which the bed carries


class Net(NamedTuple):
    """All lines in one state under one law, with room for their equations."""

    bars: Bars
    state: State
    loads: BarLoads
    nodal: Array  # (nodes, 3): forces on the nodes, N
    ground: Ground
    law: Law
    band: Array  # (4 bars + 3 lines, 19): coefficients, forces divided by `law.soft`
    rhs: Array  # (4 bars + 3 lines,)
    side: Array  # (4 bars + 3 lines, 3): of the displacement of a line's first node that moves
