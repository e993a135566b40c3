"""Buoys at the water surface: none lifts above it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from catopt.errors import FloatsUpError
from catopt.model import Line
from catopt.words import Message

ROUNDING = 1e-9
"""How far above the surface, over the water depth, a buoy may be by rounding."""


def check_buoys(line: Line, heights: Iterable[float], water_depth: float) -> None:
    """Refuse a line of which a buoy would be above the water surface under its full lift.

    The heights are those of its point loads above the bed, m; those of negative weight are buoys.
    FloatsUpError names the first such buoy, how far it would be above the surface, and the way out.
    """
    for index, (load, height) in enumerate(zip(line.point_loads, heights, strict=True)):
        above = height - water_depth
        if load.submerged_weight < 0.0 and above > ROUNDING * water_depth:
            name = f" ({load.name})" if load.name else ""
            raise FloatsUpError(
                Message(
                    "catenary.floats_up",
                    path=f"line.point_loads[{index}]{name}",
                    position=load.position,
                    above=above,
                    lift=-load.submerged_weight,
                    depth=water_depth,
                )
            )


@contextmanager
def named_line(number: int) -> Iterator[None]:
    """Name the line of a system, counted from 1, whose buoy is refused within."""
    try:
        yield
    except FloatsUpError as stop:
        said = Message("mooring.of_line", number=number, warning=stop.message)
        raise FloatsUpError(said) from None
