"""Restoring curves: what it takes to move a body, and how far a force moves it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from catopt.model.kinds import Angle, Findings, Force, Place, SomeForce
from catopt.model.system import System
from catopt.mooring.response import Response, response_of
from catopt.mooring.zero_load import zero_load_position
from catopt.patience import paced
from catopt.records import Counted, Record
from catopt.words import Message

__all__ = ["RestoringCurve", "offset_curve", "restoring_curve"]


@dataclass(frozen=True)
class RestoringCurve(Record):
    """Force and offset of a body along one direction."""

    DOCUMENT = "direction offset force force_across largest_tension most_loaded_line"

    system: System
    """The lines; its own load plays no part."""
    direction: Angle
    """Counter-clockwise from x."""
    is_held: bool
    """Whether the body is held on the line along the direction (`restoring_curve`), or free and
    pushed along it (`offset_curve`)."""
    offset: tuple[Place, ...]
    """Of the body along the direction, from the zero-load position."""
    across: tuple[Place, ...]
    """Across it, a quarter turn counter-clockwise; all 0 where it is held."""
    force: tuple[Force, ...]
    """On the body along the direction."""
    force_across: tuple[Force, ...]
    """That it takes across to hold it, a quarter turn counter-clockwise; all 0 where it is free."""
    responses: tuple[Response, ...]
    """The body and its lines at each point."""

    @property
    def largest_tension(self) -> tuple[SomeForce, ...]:
        """At a fairlead, at each point."""
        return tuple(each.largest_tension for each in self.responses)

    @property
    def most_loaded_line(self) -> tuple[Counted, ...]:
        """The line that carries it."""
        return tuple(each.most_loaded + 1 for each in self.responses)


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
