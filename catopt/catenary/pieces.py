"""A line cut into uniform pieces: the form in which the kernel takes it.

One hanging piece: how far and how high it reaches, and how that changes with the end forces.

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
from typing import Any, Final, NamedTuple

from catopt.compiled import inlined
from catopt.model import Line


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


LEAST_FORCE, GREATEST_FORCE = 1e-30, 1e30
"""N: beyond them products of forces leave the range of double precision."""


class Pieces(NamedTuple):
    """Uniform pieces from the anchor up; lists of float, or arrays in compiled code.

    length is unstretched (m), weight submerged (N/m), compliance 1/EA (1/N; 0: inextensible).
    `load`, of 2 n + 2 numbers, has first the submerged weight hung on the joint below each piece k
    (N; 0 at both ends of the line), then the Coulomb coefficients of these point loads on the bed,
    below 0 where it is the bed's. One sequence and not two, because each one passed costs every
    call its time.
    """

    length: Any
    weight: Any
    compliance: Any
    load: Any


class LineProblem(NamedTuple):
    """A line with all that its equilibrium depends on, save the load.

    Heights are above the bed (m), friction is the Coulomb coefficient of the bed.
    """

    pieces: Pieces
    anchor_height: float
    fairlead_height: float
    friction: float


@inlined
def total_length(pieces: Pieces) -> float:
    """Unstretched length, m."""
    total = 0.0
    for k in range(len(pieces.length)):
        total += pieces.length[k]
    return total


@inlined
def total_weight(pieces: Pieces) -> float:
    """Submerged weight of line and point loads, N."""
    total = 0.0
    for k in range(len(pieces.length)):
        total += pieces.length[k] * pieces.weight[k] + pieces.load[k]
    return total


@inlined
def has_buoyancy(pieces: Pieces) -> bool:
    """Whether any piece or point load floats."""
    for k in range(len(pieces.length)):
        if pieces.weight[k] < 0.0 or pieces.load[k] < 0.0:
            return True
    return False


@inlined
def is_plain(problem: LineProblem) -> bool:
    """Whether nothing floats and the anchor lies on the bed: then the suspended part tells all."""
    return problem.anchor_height == 0.0 and not has_buoyancy(problem.pieces)


@inlined
def is_inextensible(pieces: Pieces) -> bool:
    """Whether no piece stretches."""
    for k in range(len(pieces.length)):
        if pieces.compliance[k] > 0.0:
            return False
    return True


@inlined
def length_between(
    pieces: Pieces, piece: int, rest: float, end_piece: int, end_rest: float
) -> float:
    """Unstretched length between two places, each `rest` above the lower end of its piece, m."""
    length = rest
    for k in range(end_piece, piece):
        length += pieces.length[k]
    return length - end_rest


@inlined
def bed_friction(pieces: Pieces, joint: int, friction: float) -> float:
    """Coulomb coefficient of the point load on a joint; `friction` is the bed's, with its sign."""
    own = pieces.load[len(pieces.length) + 1 + joint]
    return math.copysign(own, friction) if own >= 0.0 else friction


@inlined
def tension_past_clump(
    T: float, pieces: Pieces, joint: int, friction: float, reaction: float
) -> float:
    """Tension that friction leaves beyond a clump weight of which the bed carries a reaction, N."""
    return max(T - bed_friction(pieces, joint, friction) * reaction, 0.0)


def reversed_pieces(pieces: Pieces) -> Pieces:
    """Return the same line counted from its other end."""
    joints = len(pieces.length) + 1
    load = pieces.load.copy()
    for k in range(joints):
        load[k] = pieces.load[joints - 1 - k]
        load[joints + k] = pieces.load[2 * joints - 1 - k]
    return Pieces(
        pieces.length[::-1].copy(), pieces.weight[::-1].copy(), pieces.compliance[::-1].copy(), load
    )


def above(pieces: Pieces, piece: int, rest: float) -> Pieces:
    """Return the line above a place, `rest` above the lower end of a piece (m)."""
    count = len(pieces.length) - piece
    load = pieces.load[: 2 * count + 2].copy()
    for k in range(count + 1):
        load[k] = pieces.load[piece + k]
        load[count + 1 + k] = pieces.load[len(pieces.length) + 1 + piece + k]
    load[0] = 0.0
    length = pieces.length[piece:].copy()
    length[0] -= rest
    return Pieces(length, pieces.weight[piece:].copy(), pieces.compliance[piece:].copy(), load)


def below(pieces: Pieces, piece: int, rest: float) -> Pieces:
    """Return the line below a place, `rest` above the lower end of a piece (m)."""
    count = piece + 1
    load = pieces.load[: 2 * count + 2].copy()
    for k in range(count + 1):
        load[count + 1 + k] = pieces.load[len(pieces.length) + 1 + k]
    load[count] = 0.0
    length = pieces.length[:count].copy()
    length[piece] = rest
    return Pieces(length, pieces.weight[:count].copy(), pieces.compliance[:count].copy(), load)


def split(
    length: Any,
    weight: Any,
    compliance: Any,
    position: Any,
    point_weight: Any,
    point_friction: Any,
    pieces: Pieces,
    owner: Any,
) -> None:
    """Cut segments at point loads, into as many pieces as there are segments and point loads.

    A point load on a joint leaves a piece of length 0, which the kernel passes over; point loads in
    one place become one. They come by rising position (m), with weight (N) and Coulomb coefficient
    (below 0: the bed's). Writes `pieces`, and the segment of each to `owner`.
    """
    piece = 0
    load = 0
    joint = 0.0
    start = 0.0
    coefficients = len(pieces.length) + 1
    pieces.load[0] = 0.0
    pieces.load[coefficients] = -1.0
    for segment in range(len(length)):
        begin = joint
        joint += length[segment]
        is_last = segment == len(length) - 1
        while load < len(position) and (position[load] <= joint or is_last):
            pieces.length[piece] = max(position[load] - start, 0.0)
            pieces.weight[piece] = weight[segment]
            pieces.compliance[piece] = compliance[segment]
            pieces.load[piece + 1] = point_weight[load]
            pieces.load[coefficients + piece + 1] = point_friction[load]
            owner[piece] = segment
            start = position[load]
            load += 1
            piece += 1
        # A whole segment keeps its very length, which the difference of two sums would not.
        pieces.length[piece] = length[segment] if start == begin else max(joint - start, 0.0)
        pieces.weight[piece] = weight[segment]
        pieces.compliance[piece] = compliance[segment]
        pieces.load[piece + 1] = 0.0
        pieces.load[coefficients + piece + 1] = -1.0
        owner[piece] = segment
        start = joint
        piece += 1
    # From the top down, so that of three loads in one place the upper two are one before they meet
    # the third.
    for k in range(piece - 2, -1, -1):
        if pieces.length[k] == 0.0:
            # Without length nothing floats, and a stretch on the bed goes on across it.
            pieces.weight[k] = max(pieces.weight[k], 0.0)
            _join(pieces, k)


@inlined
def _join(pieces: Pieces, k: int) -> None:
    """Put the loads at both ends of a piece without length on its lower joint: they are one."""
    if pieces.load[k + 1] != 0.0:
        coefficients = len(pieces.length) + 1
        pieces.load[coefficients + k] = pieces.load[coefficients + k + 1]
        pieces.load[k] += pieces.load[k + 1]
        pieces.load[k + 1] = 0.0


def joints_of(line: Line) -> tuple[int, ...]:
    """Return, for each point load of a line, the piece above the joint on which it hangs."""
    joints = []
    segment, end = 0, line.segments[0].length
    for number, load in enumerate(line.point_loads):
        while load.position > end and segment < len(line.segments) - 1:
            segment += 1
            end += line.segments[segment].length
        joints.append(segment + number + 1)
    return tuple(joints)


def cut(line: Line) -> tuple[Pieces, tuple[int, ...]]:
    """Cut a line at its joints and point loads; the pieces as lists, and the segment of each.

    A line is frozen, so its pieces are kept on it; they are not to be written to.
    """
    kept: tuple[Pieces, tuple[int, ...]] | None = line.__dict__.get(_KEPT)
    if kept is None:
        kept = line.__dict__[_KEPT] = _cut(line)
    return kept


_KEPT: Final = "_pieces"


def _cut(line: Line) -> tuple[Pieces, tuple[int, ...]]:
    count = len(line.segments) + len(line.point_loads)
    pieces = Pieces([0.0] * count, [0.0] * count, [0.0] * count, [0.0] * (2 * count + 2))
    owner = [0] * count
    split(
        [float(segment.length) for segment in line.segments],
        [float(segment.submerged_weight) for segment in line.segments],
        [1.0 / segment.EA for segment in line.segments],
        [float(load.position) for load in line.point_loads],
        [float(load.submerged_weight) for load in line.point_loads],
        [-1.0 if load.friction is None else float(load.friction) for load in line.point_loads],
        pieces,
        owner,
    )
    return pieces, tuple(owner)
