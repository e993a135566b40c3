"""How a moored body answers: where it goes and what its lines carry, in a few numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.model.kinds import Angle, Force, Height, Place, SomeForce
from catopt.mooring.balance import Lines
from catopt.mooring.descent import Rest
from catopt.mooring.network_rest import LinesAtRest
from catopt.mooring.zero_load import ZeroLoadPosition
from catopt.records import Record
from catopt.ties import first_largest


@dataclass(frozen=True)
class Response(Record):
    """One place of rest of the body; in Python lines count from 0."""

    DOCUMENT = (
        "x y yaw offset largest_tension most_loaded+1=most_loaded_line largest_anchor_tension "
        "largest_uplift=largest_anchor_vertical_force_N least_grounded=least_grounded_length_m"
    )

    x: Place
    """Position of the body."""
    y: Place
    """Position of the body."""
    yaw: Angle
    """Counter-clockwise."""
    offset: Height
    """Distance from the zero-load position."""
    largest_tension: SomeForce
    """At a fairlead."""
    most_loaded: int
    """The line that carries it, the first of several alike, in the system as given."""
    largest_anchor_tension: SomeForce
    """Of any line."""
    largest_uplift: Force
    """Largest on an anchor; 0 or less where none is pulled up."""
    least_grounded: Height
    """Shortest on the bed of any line, unstretched."""


def network_response(rest: LinesAtRest, moved: tuple[float, float] | None = None) -> Response:
    """Sum a network up; tensions are those at either end of a line.

    `moved`: by how much what is held is, m; None: of its one free body.
    """
    ends = rest.joints.ends
    tensions = [max(math.hypot(*each.first), math.hypot(*each.second)) for each in ends]
    anchored = [each.first for k, each in enumerate(ends) if rest.is_anchored(k)]
    if moved is None:
        (body,) = rest.bodies
        place, offset = (body.position.x, body.position.y, body.position.yaw), body.offset
    else:
        place, offset = (*moved, 0.0), moved
    return Response(
        *place,
        offset=math.hypot(*offset),
        largest_tension=max(tensions),
        most_loaded=first_largest(tensions),
        largest_anchor_tension=max((math.hypot(*each) for each in anchored), default=0.0),
        largest_uplift=max((each[2] for each in anchored), default=0.0),
        least_grounded=min(each.state.grounded for each in ends),
    )


def response_of(
    zero_load: ZeroLoadPosition, rest: Rest, lines: Lines, zero: Rest | None = None
) -> Response:
    """Sum a place of rest up; the offset is from `zero`, by default the zero-load position."""
    start = zero_load.neutral if zero is None else zero
    tensions = [math.hypot(H, V) for H, V in zip(lines.H, lines.V, strict=True)]
    return Response(
        x=rest.x,
        y=rest.y,
        yaw=rest.yaw,
        offset=math.hypot(rest.x - start.x, rest.y - start.y),
        largest_tension=max(tensions),
        most_loaded=first_largest(tensions),
        largest_anchor_tension=max(map(math.hypot, lines.H_anchor, lines.V_anchor)),
        largest_uplift=max(lines.V_anchor),
        least_grounded=min(lines.grounded),
    )
