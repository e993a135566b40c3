"""The largest tension of each segment, out of a state of the kernel; meant to be compiled.

Plain numbers for millions of designs; one line is laid out by `catenary.layout`, and the tests hold
the two against each other.
"""

from __future__ import annotations

import math
from typing import Any

from catopt.catenary.pieces import Pieces, total_length
from catopt.catenary.state import State
from catopt.catenary.walk import NO_TOUCHDOWN
from catopt.compiled import inlined

__all__ = ["segment_tensions"]


def segment_tensions(
    state: State, pieces: Pieces, friction: float, owner: Any, segments: int, largest: Any
) -> None:
    """Find the largest tension of each segment.

    Tension is convex along a uniform piece: it is largest at one of the ends.

    Parameters
    ----------
    state : State
        A converged answer for a known horizontal force.
    pieces : Pieces
        The line.
    friction : float
        Coulomb coefficient of the bed.
    owner : sequence of int
        The segment of each piece.
    segments : int
        How many there are.
    largest : array, shape (segments or more,)
        Written to, N.
    """
    for segment in range(segments):
        largest[segment] = 0.0
    H = state.H
    V = state.V
    T = math.sqrt(H * H + V * V)
    for k in range(len(pieces.length) - 1, -1, -1):
        if state.touchdown == 2 * k:
            _note(largest, owner[k], pieces.length[k], max(T, H))
            break
        V1 = V - pieces.weight[k] * pieces.length[k]
        T1 = math.sqrt(H * H + V1 * V1)
        _note(largest, owner[k], pieces.length[k], max(T, T1))
        if state.touchdown == 2 * k + 1:
            V = V1
            break
        V = V1 - pieces.load[k]
        T = T1 if pieces.load[k] == 0.0 else math.sqrt(H * H + V * V)
    if state.touchdown != NO_TOUCHDOWN:
        _on_bed(state, V, pieces, friction, owner, largest)
    if state.anchor_touchdown != NO_TOUCHDOWN:
        _anchor_side(state, pieces, owner, largest)


@inlined
def _note(largest: Any, segment: int, length: float, tension: float) -> None:
    """Keep the larger tension, of a piece that is there at all."""
    if length > 0.0 and tension > largest[segment]:
        largest[segment] = tension


def _on_bed(
    state: State, V: float, pieces: Pieces, friction: float, owner: Any, largest: Any
) -> None:
    """Follow the part on the bed from the touchdown down, with what friction leaves of H.

    V is the vertical force at the upper end of the piece that touches down, or just above the
    clump weight that does.
    """
    k = state.touchdown // 2
    T = state.H
    if state.touchdown % 2 == 1:
        T = max(T - friction * (pieces.load[k] - V), 0.0)
        k -= 1
        room = pieces.length[k]
    else:
        weight = pieces.weight[k]
        hanging = max(V, 0.0) / weight if weight > 0.0 else 0.0
        room = pieces.length[k] - min(hanging, pieces.length[k])
    left = state.grounded
    least = 1e-15 * total_length(pieces)
    while left > least and k >= 0:
        length = min(room, left)
        _note(largest, owner[k], length, T)
        left -= length
        T = max(T - friction * (pieces.weight[k] * length + pieces.load[k]), 0.0)
        k -= 1
        room = pieces.length[k]


def _anchor_side(state: State, pieces: Pieces, owner: Any, largest: Any) -> None:
    """Walk from a raised anchor down to the bed, with the pieces counted from the fairlead."""
    count = len(pieces.length)
    V = -state.V_anchor
    H = max(state.H_anchor, 1e-12 * abs(V))
    for j in range(count - 1, -1, -1):
        k = count - 1 - j
        T = math.sqrt(H * H + V * V)
        if state.anchor_touchdown == 2 * j:
            _note(largest, owner[k], pieces.length[k], max(T, H))
            return
        V -= pieces.weight[k] * pieces.length[k]
        _note(largest, owner[k], pieces.length[k], max(T, math.sqrt(H * H + V * V)))
        if state.anchor_touchdown == 2 * j + 1:
            return
        V -= pieces.load[count - j]
