"""A hanging part of the line: what lies between two places where it is held or rests on the bed.

The forces along it are counted from the piece in which they are known best: at a touchdown V is 0
exactly, and what hangs above it adds up from there. Counted down from the fairlead, V near the
touchdown would be the small difference of large weights.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.catenary.piece import piece_reach, piece_rise
from catopt.catenary.pieces import Pieces

NO_TOUCHDOWN = -1


class Part(NamedTuple):
    """A hanging part; the line's pieces are counted from the anchor.

    H is its horizontal force (N; 0 when it hangs straight), `slope` the sine of the inclination of
    pieces that have neither weight nor force. It ends above in piece `top`, top_length (m) of which
    lies below the end, and below in piece `bottom`, bottom_length (m) of which lies above the end.
    V (N) is the vertical force at the lower end of its share in `piece`. `touchdown` says how it
    ends below: NO_TOUCHDOWN at the anchor, 2 k inside piece k, 2 k + 1 at the clump weight below
    piece k.
    """

    H: float
    slope: float
    top: int
    top_length: float
    bottom: int
    bottom_length: float
    piece: int
    V: float
    touchdown: int


NO_PART = Part(math.nan, 0.0, -1, 0.0, -1, 0.0, 0, math.nan, NO_TOUCHDOWN)
"""Where there is none, or none was found."""

TO_THE_ANCHOR = Part(0.0, 0.0, 0, 0.0, -1, 0.0, 0, 0.0, NO_TOUCHDOWN)
"""What follows a touchdown below which the line lies all the way to its anchor."""


def with_force(part: Part, piece: int, V: float) -> Part:
    """Return the same part with the vertical force known in another place."""
    return Part(*part[:6], piece, V, part.touchdown)


def with_slope(part: Part, slope: float) -> Part:
    """Return the same part with its loose pieces inclined."""
    return Part(part.H, slope, *part[2:])


class PartReach(NamedTuple):
    """How far a part reaches from its lower to its upper end: x and z, m.

    x_H, z_H and z_V are derivatives by H and by a shift of V along the whole part (m/N; dx/dV =
    dz/dH), all 0 without horizontal force. V_top and V_bottom act at its ends (N). `low` is its
    lowest point above its lower end (m; 0 or below), `smallest` the piece with the smallest
    vertical force at its lower end; not the one in which it touches down, where that is 0 exactly.
    """

    x: float
    z: float
    x_H: float
    z_H: float
    z_V: float
    V_top: float
    V_bottom: float
    low: float
    smallest: int


def share(part: Part, pieces: Pieces, k: int) -> float:
    """Unstretched length of piece k that belongs to a part, m."""
    length: float = pieces.length[k]
    if k == part.bottom and part.bottom_length < length:
        return part.bottom_length - (length - part.top_length if k == part.top else 0.0)
    return part.top_length if k == part.top else length


def part_reach(part: Part, pieces: Pieces) -> PartReach:
    """Add up a part from the piece whose forces are known, upwards and downwards."""
    H = part.H
    x = x_H = z_H = z_V = 0.0
    # Upwards; heights are above the lower end of the share in `part.piece`.
    z = low = 0.0
    V = part.V
    smallest, least = part.piece, math.inf if part.touchdown % 2 == 0 else abs(V)
    for k in range(part.piece, part.top + 1):
        if k > part.piece:
            V += pieces.load[k]
            if abs(V) < least:
                smallest, least = k, abs(V)
        length = share(part, pieces, k)
        V2 = V + pieces.weight[k] * length
        low = min(low, z + _sag(H, V, V2, pieces.weight[k], pieces.compliance[k]))
        dx, dz, by_H, dz_H, dz_V = _reach(part, V, V2, length, pieces.compliance[k])
        x, z, x_H, z_H, z_V = x + dx, z + dz, x_H + by_H, z_H + dz_H, z_V + dz_V
        low = min(low, z)
        V = V2
    V_top = V
    top = z
    z = 0.0
    V = part.V
    for k in range(part.piece - 1, part.bottom - 1, -1):
        V -= pieces.load[k + 1]
        length = share(part, pieces, k)
        V1 = V - pieces.weight[k] * length
        dx, dz, by_H, dz_H, dz_V = _reach(part, V1, V, length, pieces.compliance[k])
        x, z, x_H, z_H, z_V = x + dx, z - dz, x_H + by_H, z_H + dz_H, z_V + dz_V
        low = min(low, z + _sag(H, V1, V, pieces.weight[k], pieces.compliance[k]), z)
        V = V1
        if abs(V) < least:
            smallest, least = k, abs(V)
    return PartReach(x, top - z, x_H, z_H, z_V, V_top, V, low - z, smallest)


def _reach(
    part: Part, V1: float, V2: float, length: float, compliance: float
) -> tuple[float, float, float, float, float]:
    """Reach of one piece and its derivatives by H, and by V of the height."""
    H = part.H
    if H > 0.0:
        T1, T2 = math.sqrt(H * H + V1 * V1), math.sqrt(H * H + V2 * V2)
        reach = piece_reach(H, V1, V2, T1, T2, length, compliance)
        return reach.dx, reach.dz, reach.x_H, reach.z_H, reach.z_V
    loose = V1 == 0.0 and V2 == 0.0
    dx = length * math.sqrt(1.0 - part.slope * part.slope) if loose else 0.0
    return dx, piece_rise(H, V1, V2, length, compliance, part.slope), 0.0, 0.0, 0.0


def _sag(H: float, V1: float, V2: float, weight: float, compliance: float) -> float:
    """Height of a heavy piece's lowest point above its lower end, m; 0 when that is the lowest."""
    if not V1 < 0.0 < V2:
        return 0.0
    return piece_rise(H, V1, 0.0, -V1 / weight, compliance, 0.0)
