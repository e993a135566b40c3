"""A line cut where its segments meet and where something hangs on it."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from catopt.model import Line, PointLoad

SAME_PLACE = 1e-9
"""Distance over the line's length at which two cuts are one: rounding of lengths added up."""


@dataclass(frozen=True)
class Joint:
    """A place between two pieces, or an end of the line.

    `arc`: unstretched, from the anchor, m; `loads`: what hangs there.
    """

    arc: float
    loads: tuple[PointLoad, ...] = ()


@dataclass(frozen=True)
class Piece:
    """A uniform part of the line between two joints that follow each other.

    `segment`: which one it belongs to, counted from 0 at the anchor; `length`: unstretched, m;
    `elements`: into how many equal parts it is cut.
    """

    segment: int
    length: float
    elements: int


def cut_line(line: Line, elements: int) -> tuple[list[Joint], list[Piece]]:
    """Cut a line; there is one joint more than pieces."""
    total = line.length
    ends: list[float] = []
    for segment in line.segments:
        ends.append((ends[-1] if ends else 0.0) + segment.length)
    joints: list[Joint] = []
    for arc in sorted([0.0, *ends[:-1], total, *(load.position for load in line.point_loads)]):
        if not joints or arc - joints[-1].arc > SAME_PLACE * total:
            joints.append(Joint(arc))
    for load in line.point_loads:
        at = min(range(len(joints)), key=lambda k: abs(joints[k].arc - load.position))
        joints[at] = Joint(joints[at].arc, (*joints[at].loads, load))
    pieces = []
    for lower, upper in pairwise(joints):
        middle = 0.5 * (lower.arc + upper.arc)
        segment_number = next((k for k, end in enumerate(ends) if middle < end), len(ends) - 1)
        length = upper.arc - lower.arc
        pieces.append(Piece(segment_number, length, max(2, round(elements * length / total))))
    return joints, pieces
