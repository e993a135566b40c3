"""How a moored body answers: where it goes and what its lines carry, in a few numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from catopt.mooring.arrangement import Lines
from catopt.mooring.descent import Rest
from catopt.mooring.held import LinesAtRest
from catopt.mooring.zero_load import ZeroLoadPosition
from catopt.ties import first_largest


@dataclass(frozen=True)
class Response:
    """One place of rest of the body: m, m, rad.

    offset counts from the zero-load position (m); tensions in N, at a fairlead for the largest.
    most_loaded is the line that carries it, the first of several alike, counted from 0 in the
    system as given. largest_uplift is the largest vertical force on an anchor (N; 0 or less where
    none is lifted), least_grounded the shortest length on the bed of any line (m).
    """

    x: float
    y: float
    yaw: float
    offset: float
    largest_tension: float
    most_loaded: int
    largest_anchor_tension: float
    largest_uplift: float
    least_grounded: float

    def to_dict(self) -> dict[str, Any]:
        """Lay it out as the documents have it, lines from 1."""
        return {
            "x_m": self.x,
            "y_m": self.y,
            "yaw_rad": self.yaw,
            "offset_m": self.offset,
            "largest_tension_N": self.largest_tension,
            "most_loaded_line": self.most_loaded + 1,
            "largest_anchor_tension_N": self.largest_anchor_tension,
            "largest_anchor_vertical_force_N": self.largest_uplift,
            "least_grounded_length_m": self.least_grounded,
        }


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
