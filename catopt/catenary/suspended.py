"""The suspended part of a line below its fairlead, and the part on the bed below that.

The suspended part is followed down from the forces H and V at the fairlead, one piece after the
other. Where it ends is said by a touchdown code:

    NO_TOUCHDOWN      at the anchor, whatever the line passes through
    FIRST_TOUCHDOWN   where V first falls to 0: inside a piece, or at a clump weight
    2 k               inside piece k, where V falls to 0
    2 k + 1           at the clump weight on the joint below piece k, which the bed carries in part
"""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.catenary.part import NO_TOUCHDOWN
from catopt.catenary.piece import piece_reach, rise_by_V
from catopt.catenary.pieces import Pieces, beyond_clump
from catopt.compiled import inlined

FIRST_TOUCHDOWN = -2


class SuspendedPart(NamedTuple):
    """The suspended part: reach (m), derivatives by H and V at the fairlead (m/N; dx/dV = dz/dH).

    It ends in piece `bottom`, of which bottom_length (unstretched, m) hangs, with the vertical
    force V (N) at the anchor or just above the clump weight; touchdown is NO_TOUCHDOWN, 2 k or 2 k
    + 1.
    """

    x: float
    z: float
    x_H: float
    z_H: float
    z_V: float
    touchdown: int
    bottom: int
    bottom_length: float
    V: float


class GroundedPart(NamedTuple):
    """The part on the bed: length along x (m), its derivative by H (m/N), H beyond it (N)."""

    x: float
    x_H: float
    H: float


@inlined
def suspended_height(H: float, V: float, pieces: Pieces) -> tuple[float, float]:
    """Height of the fairlead above the anchor or the first touchdown (m), and its derivative by V.

    H above 0 and V not below, N, on a line without buoyant parts.
    """
    z = 0.0
    z_V = 0.0
    T = math.sqrt(H * H + V * V)
    for k in range(len(pieces.length) - 1, -1, -1):
        length = pieces.length[k]
        V1 = V - pieces.weight[k] * length
        is_last = V1 < 0.0
        if is_last:
            length = V / pieces.weight[k]
            V1 = 0.0
        T1 = math.sqrt(H * H + V1 * V1)
        m = T1 + T
        cl = pieces.compliance[k] * length
        z += (V1 + V) * (length / m + 0.5 * cl)
        z_V += rise_by_V(H, V1, V, m, T1 * T, length) + cl
        below = V1 - pieces.load[k]
        if is_last or below < 0.0:
            break
        V = below
        T = T1 if pieces.load[k] == 0.0 else math.sqrt(H * H + V * V)
    return z, z_V


@inlined
def suspended_part(H: float, V: float, pieces: Pieces, touchdown: int) -> SuspendedPart:
    """Follow the suspended part down to a touchdown; all derivatives of its reach. H above 0."""
    x = 0.0
    z = 0.0
    x_H = 0.0
    z_H = 0.0
    z_V = 0.0
    T = math.sqrt(H * H + V * V)
    for k in range(len(pieces.length) - 1, -1, -1):
        length = pieces.length[k]
        V1 = V - pieces.weight[k] * length
        inside = touchdown == 2 * k or (touchdown == FIRST_TOUCHDOWN and V1 < 0.0)
        if inside:
            length = max(V, 0.0) / pieces.weight[k] if pieces.weight[k] > 0.0 else 0.0
            V1 = 0.0
        T1 = math.sqrt(H * H + V1 * V1)
        part = piece_reach(H, V1, V, T1, T, length, pieces.compliance[k])
        x += part.dx
        z += part.dz
        x_H += part.x_H
        z_H += part.z_H
        z_V += part.z_V
        if inside:
            return SuspendedPart(x, z, x_H, z_H, z_V, 2 * k, k, min(length, pieces.length[k]), 0.0)
        below = V1 - pieces.load[k]
        if touchdown == 2 * k + 1 or (touchdown == FIRST_TOUCHDOWN and below < 0.0):
            return SuspendedPart(x, z, x_H, z_H, z_V, 2 * k + 1, k, length, V1)
        V = below
        T = T1 if pieces.load[k] == 0.0 else math.sqrt(H * H + V * V)
    return SuspendedPart(x, z, x_H, z_H, z_V, NO_TOUCHDOWN, 0, pieces.length[0], V)


@inlined
def grounded_part(
    H: float,
    pieces: Pieces,
    friction: float,
    piece: int,
    rest: float,
    end_piece: int,
    end_rest: float,
) -> GroundedPart:
    """Follow the line on the bed from a touchdown, where its force is H (N), towards the anchor.

    Friction takes its Coulomb coefficient times the bed's reaction off the tension, on the weight
    of the line and on clump weights, down to 0 and not further. `rest` is the length of the first
    piece that lies on the bed, `end_rest` that of the last piece that does not, m.
    """
    T = H
    x = 0.0
    x_H = 0.0
    for k in range(piece, end_piece - 1, -1):
        length = rest if k == piece else pieces.length[k]
        if k == end_piece:
            length -= end_rest
        loss = friction * pieces.weight[k]
        tensioned = length if loss * length <= T else T / loss
        T1 = max(T - loss * length, 0.0)
        x += length + pieces.compliance[k] * tensioned * 0.5 * (T + T1)
        x_H += pieces.compliance[k] * tensioned
        T = T1
        if k > end_piece and pieces.load[k] != 0.0:
            T = beyond_clump(T, pieces, k, friction, pieces.load[k])
    return GroundedPart(x, x_H, T)
