"""A line cut into uniform pieces: the form in which the kernel takes it."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from catopt.compiled import inlined
from catopt.model import Line

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
def grip(pieces: Pieces, joint: int, friction: float) -> float:
    """Coulomb coefficient of the point load on a joint; `friction` is the bed's, with its sign."""
    own = pieces.load[len(pieces.length) + 1 + joint]
    return math.copysign(own, friction) if own >= 0.0 else friction


@inlined
def beyond_clump(T: float, pieces: Pieces, joint: int, friction: float, reaction: float) -> float:
    """Tension that friction leaves beyond a clump weight of which the bed carries a reaction, N."""
    return max(T - grip(pieces, joint, friction) * reaction, 0.0)


def turned(pieces: Pieces) -> Pieces:
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
    """Cut a line at its joints and point loads; the pieces as lists, and the segment of each."""
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
