"""One hanging piece: how far and how high it reaches, and how that changes with the end forces.

A uniform piece of unstretched length l, submerged weight w, compliance c = 1/EA carries the
horizontal force H, and the vertical forces V1 at its lower-s and V2 = V1 + w l at its upper-s end,
with tensions T1 and T2. Written with the sums S = V1 + V2 and m = T1 + T2 nothing is divided by w,
and nothing cancels for w -> 0 or V2 -> V1 (docs/theory.md, "Stable forms"):

    dz = l S / m + c l S / 2
    dx = (2 H l / m) atanh(y) / y + c H l,    y = w l / m

Without horizontal force the piece hangs straight: dz is exact as it stands, dx is 0.

Plain functions of floats: they serve one line as they are and thousands of lines compiled.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.compiled import inlined


class PieceReach(NamedTuple):
    """What one hanging piece contributes: m, and m/N for the derivatives at fixed length.

    A change of V shifts V1 and V2 alike; dx/dV = dz/dH, because both are derivatives of one
    potential.
    """

    dx: float
    dz: float
    x_H: float
    z_H: float
    z_V: float


@inlined
def piece_reach(
    H: float, V1: float, V2: float, T1: float, T2: float, length: float, compliance: float
) -> PieceReach:
    """Reach of a hanging piece and its derivatives; forces in N with H above 0.

    The length is unstretched, m; the compliance is 1/EA, 1/N.
    """
    S = V1 + V2
    by_m = 1.0 / (T1 + T2)
    q = length * by_m
    cl = compliance * length
    TT = T1 * T2
    q_by_TT = q / TT
    y = (V2 - V1) * by_m
    excess = atanh_excess(H, V1, V2, T1, T2, y)
    return PieceReach(
        2.0 * H * q * (1.0 + excess) + cl * H,
        S * (q + 0.5 * cl),
        0.5 * q_by_TT * S * S * (1.0 - y * y) + 2.0 * q * excess + cl,
        -H * S * q_by_TT,
        rise_by_V(H, V1, V2, T1 + T2, TT, length) + cl,
    )


@inlined
def piece_rise(
    H: float, V1: float, V2: float, length: float, compliance: float, slope: float
) -> float:
    """Height of the upper end of a hanging piece above its lower end, m; H may be 0.

    A piece without weight or force may take any inclination: `slope` is the sine of it.
    """
    m = math.sqrt(H * H + V1 * V1) + math.sqrt(H * H + V2 * V2)
    if m == 0.0:
        return slope * length
    return (V1 + V2) * (length / m + 0.5 * compliance * length)


@inlined
def atanh_excess(H: float, V1: float, V2: float, T1: float, T2: float, y: float) -> float:
    """Evaluate atanh(y)/y - 1 for y = (V2 - V1)/(T1 + T2), which lies between -1 and 1."""
    if abs(y) < 0.15:
        # Series in y2; the first term left out is below 1e-17 of the sum.
        t = y * y
        tail = 1 / 13 + t * (1 / 15 + t * (1 / 17 + t * (1 / 19 + t / 21)))
        return t * (1 / 3 + t * (1 / 5 + t * (1 / 7 + t * (1 / 9 + t * (1 / 11 + t * tail)))))
    # m - |V2 - V1| cancels when the piece runs steeply down and up again: sum its two parts.
    upper = max(V1, V2)
    lower = min(V1, V2)
    T_upper = T2 if V2 >= V1 else T1
    T_lower = T1 if V2 >= V1 else T2
    rest = H * H / (T_upper + upper) if upper > 0.0 else T_upper - upper
    rest += H * H / (T_lower - lower) if lower < 0.0 else T_lower + lower
    return 0.5 * math.log((T1 + T2 + (upper - lower)) / rest) / abs(y) - 1.0


@inlined
def rise_by_V(H: float, V1: float, V2: float, m: float, TT: float, length: float) -> float:
    """Evaluate dz/dV = (V2/T2 - V1/T1)/w of the inextensible piece, without cancelling, m/N.

    It is (l/m) (H2 + T1 T2 - V1 V2)/(T1 T2), with one division for all.
    """
    product = V1 * V2
    if product > 0.0:
        both = TT + product
        H2 = H * H
        return length * H2 * (both + H2 + V1 * V1 + V2 * V2) / (m * both * TT)
    return length * (H * H + TT - product) / (m * TT)
