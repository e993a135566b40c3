"""Restoring curves: what it takes to move a body, and how far a force moves it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from catopt.model.kinds import Findings
from catopt.model.system import System
from catopt.mooring.response import Response, response_of
from catopt.mooring.zero_load import zero_load_position
from catopt.patience import paced
from catopt.words import Message

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

    `direction`: counter-clockwise from x, rad; `offsets`: from the zero-load position along it, m.
    The system's own load plays no part.

    Raises
    ------
    NoEquilibriumError
        When a line that does not stretch is too short for an offset.
    InputError, NotConvergedError
        As for `solve_system`.
    """
    return _curve(system, direction, offsets, is_held=True)


def offset_curve(system: System, *, direction: float, forces: Sequence[float]) -> RestoringCurve:
    """Offset of a free body under forces along a direction.

    `direction`: counter-clockwise from x, rad; `forces`: on the body along it, N. The system's own
    load plays no part.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As for `solve_system`.
    """
    return _curve(system, direction, forces, is_held=False)


def _curve(
    system: System, direction: float, values: Sequence[float], *, is_held: bool
) -> RestoringCurve:
    found = Findings("restoring curve")
    found.number("direction", direction, "rad")
    key, unit = ("offsets", "m") if is_held else ("forces", "N")
    for index, value in enumerate(values):
        found.number(f"{key}[{index}]", float(value), unit)
    found.raise_if_any()
    zero_load = zero_load_position(system)
    start = zero_load.neutral
    cosine, sine = math.cos(direction), math.sin(direction)
    points = []
    for value in paced(Message("words.offsets", total=len(values)), values):
        if is_held:
            rest, lines = zero_load.held(start.x + value * cosine, start.y + value * sine)
            x, y = rest.pull.x, rest.pull.y
        else:
            rest, lines = zero_load.under((value * cosine, value * sine))
            x, y = rest.x - start.x, rest.y - start.y
        along, across = x * cosine + y * sine, y * cosine - x * sine
        known = (float(value), 0.0)
        numbers = (*known, -along, -across) if is_held else (along, across, *known)
        points.append((*numbers, response_of(zero_load, rest, lines)))
    columns = zip(*points, strict=True) if points else [()] * 5
    return RestoringCurve(system, direction, is_held, *columns)
