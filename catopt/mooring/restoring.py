"""Restoring curves: what it takes to move a body, and how far a force moves it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from catopt.model.system import System
from catopt.model.validity import Findings
from catopt.mooring.response import Response, response_of
from catopt.mooring.zero_load import ZeroLoadPosition, zero_load_position

__all__ = ["RestoringCurve", "offset_curve", "restoring_curve"]


@dataclass(frozen=True)
class RestoringCurve:
    """Force and offset of a body along one direction.

    Attributes
    ----------
    system : System
        The lines; its own load plays no part.
    direction : float
        Counter-clockwise from x, rad.
    is_held : bool
        Whether the body is held on the line along the direction (`restoring_curve`), or free and
        pushed along it (`offset_curve`).
    offset : tuple of float
        Of the body along the direction, from the zero-load position, m.
    across : tuple of float
        Across it, a quarter turn counter-clockwise, m; all 0 where it is held.
    force : tuple of float
        On the body along the direction, N.
    force_across : tuple of float
        That it takes across to hold it, N; all 0 where it is free.
    responses : tuple of Response
        The body and its lines at each point.
    """

    system: System
    direction: float
    is_held: bool
    offset: tuple[float, ...]
    across: tuple[float, ...]
    force: tuple[float, ...]
    force_across: tuple[float, ...]
    responses: tuple[Response, ...]

    def to_dict(self) -> dict[str, Any]:
        """Lay it out as the documents have it, lines from 1."""
        return {
            "direction_rad": self.direction,
            "offset_m": list(self.offset),
            "force_N": list(self.force),
            "force_across_N": list(self.force_across),
            "largest_tension_N": [each.largest_tension for each in self.responses],
            "most_loaded_line": [each.most_loaded + 1 for each in self.responses],
        }


def restoring_curve(
    system: System, *, direction: float, offsets: Sequence[float]
) -> RestoringCurve:
    """Force that holds a body at offsets along a direction.

    Parameters
    ----------
    system : System
        Its own load plays no part.
    direction : float
        Counter-clockwise from x, rad.
    offsets : sequence of float
        From the zero-load position along the direction, m.

    Raises
    ------
    NoEquilibriumError
        When a line that does not stretch is too short for an offset.
    InputError, NotConvergedError
        As for `solve_system`.
    """
    _check("offsets", offsets, direction, "m")
    zero_load = zero_load_position(system)
    cosine, sine = math.cos(direction), math.sin(direction)
    points = []
    for offset in offsets:
        x = zero_load.neutral.x + offset * cosine
        y = zero_load.neutral.y + offset * sine
        rest, lines = zero_load.held(x, y)
        along = -(rest.pull.x * cosine + rest.pull.y * sine)
        across = -(rest.pull.y * cosine - rest.pull.x * sine)
        points.append((float(offset), 0.0, along, across, response_of(zero_load, rest, lines)))
    return _curve(zero_load, direction, True, points)


def offset_curve(system: System, *, direction: float, forces: Sequence[float]) -> RestoringCurve:
    """Offset of a free body under forces along a direction.

    Parameters
    ----------
    system : System
        Its own load plays no part.
    direction : float
        Counter-clockwise from x, rad.
    forces : sequence of float
        On the body along the direction, N.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As for `solve_system`.
    """
    _check("forces", forces, direction, "N")
    zero_load = zero_load_position(system)
    cosine, sine = math.cos(direction), math.sin(direction)
    points = []
    for force in forces:
        rest, lines = zero_load.under((force * cosine, force * sine))
        x, y = rest.x - zero_load.neutral.x, rest.y - zero_load.neutral.y
        points.append(
            (
                x * cosine + y * sine,
                y * cosine - x * sine,
                float(force),
                0.0,
                response_of(zero_load, rest, lines),
            )
        )
    return _curve(zero_load, direction, False, points)


def _curve(
    zero_load: ZeroLoadPosition,
    direction: float,
    is_held: bool,
    points: Sequence[tuple[float, float, float, float, Response]],
) -> RestoringCurve:
    return RestoringCurve(
        zero_load.system,
        direction,
        is_held,
        offset=tuple(point[0] for point in points),
        across=tuple(point[1] for point in points),
        force=tuple(point[2] for point in points),
        force_across=tuple(point[3] for point in points),
        responses=tuple(point[4] for point in points),
    )


def _check(key: str, values: Sequence[float], direction: float, unit: str) -> None:
    found = Findings("restoring curve")
    found.number("direction", direction, "rad")
    for index, value in enumerate(values):
        found.number(f"{key}[{index}]", float(value), unit)
    found.raise_if_any()
