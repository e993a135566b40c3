"""A line cut into uniform pieces: the form in which the kernel takes it."""

from __future__ import annotations

from typing import Any, NamedTuple

from catopt.compiled import inlined
from catopt.model import Line

__all__ = [
    "Pieces",
    "cut",
    "flip",
    "has_buoyancy",
    "is_inextensible",
    "length_below",
    "split",
    "total_length",
    "total_weight",
]


class Pieces(NamedTuple):
    """Uniform pieces from the anchor up; lists of float, or arrays in compiled code.

    Attributes
    ----------
    length : sequence of float, shape (n,)
        Unstretched, m.
    weight : sequence of float, shape (n,)
        Submerged, N/m.
    compliance : sequence of float, shape (n,)
        1/EA in 1/N; 0 for an inextensible piece.
    load : sequence of float, shape (n + 1,)
        Submerged weight hung on the joint below piece k, N; 0 at both ends of the line.
    """

    length: Any
    weight: Any
    compliance: Any
    load: Any


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
def is_inextensible(pieces: Pieces) -> bool:
    """Whether no piece stretches."""
    for k in range(len(pieces.length)):
        if pieces.compliance[k] > 0.0:
            return False
    return True


@inlined
def length_below(pieces: Pieces, piece: int, rest: float) -> float:
    """Unstretched length from the anchor to the place `rest` above the lower end of a piece, m."""
    below = rest
    for k in range(piece):
        below += pieces.length[k]
    return below


def flip(pieces: Pieces) -> Pieces:
    """Return the same line counted from its other end."""
    return Pieces(
        pieces.length[::-1], pieces.weight[::-1], pieces.compliance[::-1], pieces.load[::-1]
    )


def split(
    length: Any,
    weight: Any,
    compliance: Any,
    position: Any,
    point_weight: Any,
    pieces: Pieces,
    owner: Any,
) -> None:
    """Cut segments at point loads, into as many pieces as there are segments and point loads.

    A point load on a joint leaves a piece of length 0, which the kernel passes over.

    Parameters
    ----------
    length, weight, compliance : sequence of float, shape (segments,)
        Of the segments: m, N/m, 1/N.
    position, point_weight : sequence of float, shape (loads,)
        Of the point loads, by rising position: m, N.
    pieces : Pieces
        Written to; its sequences have segments + loads (and one more) entries.
    owner : sequence of int, shape (segments + loads,)
        Written to: the segment of each piece.
    """
    piece = 0
    load = 0
    joint = 0.0
    start = 0.0
    pieces.load[0] = 0.0
    for segment in range(len(length)):
        joint += length[segment]
        is_last = segment == len(length) - 1
        while load < len(position) and (position[load] <= joint or is_last):
            pieces.length[piece] = max(position[load] - start, 0.0)
            pieces.weight[piece] = weight[segment]
            pieces.compliance[piece] = compliance[segment]
            pieces.load[piece + 1] = point_weight[load]
            owner[piece] = segment
            start = position[load]
            load += 1
            piece += 1
        pieces.length[piece] = max(joint - start, 0.0)
        pieces.weight[piece] = weight[segment]
        pieces.compliance[piece] = compliance[segment]
        pieces.load[piece + 1] = 0.0
        owner[piece] = segment
        start = joint
        piece += 1


def cut(line: Line) -> tuple[Pieces, tuple[int, ...]]:
    """Cut a line at its joints and point loads.

    Returns
    -------
    pieces : Pieces
        Lists of plain floats.
    segment_of : tuple of int
        Which segment each piece belongs to.
    """
    count = len(line.segments) + len(line.point_loads)
    pieces = Pieces([0.0] * count, [0.0] * count, [0.0] * count, [0.0] * (count + 1))
    owner = [0] * count
    split(
        [float(segment.length) for segment in line.segments],
        [float(segment.submerged_weight) for segment in line.segments],
        [1.0 / segment.EA for segment in line.segments],
        [float(load.position) for load in line.point_loads],
        [float(load.submerged_weight) for load in line.point_loads],
        pieces,
        owner,
    )
    return pieces, tuple(owner)
