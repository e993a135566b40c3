"""What an engineer should know before using an answer: rules with their numbers.

A buoy above the water surface is no warning: such a line is refused.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from itertools import count

from catopt.catenary.solution import Solution
from catopt.errors import FloatsUpError
from catopt.model import Line
from catopt.model.line import INEXTENSIBLE
from catopt.model.strain_table import StrainTable
from catopt.words import Measure, Message

OPEN_FORCE = 1e-6
"""Beyond this part of the tension the rounding of the input shows in the digits printed."""

LARGE_STRAIN = 0.05
"""Beyond a few percent, chain and rope no longer stretch in proportion to the tension."""

ROUNDING = 1e-9
"""How far above the surface, over the water depth, a buoy may be by rounding."""


def plausibility(solution: Solution) -> Iterator[Message]:
    """Warnings that follow from the line alone."""
    if solution.regime == "slack":
        yield Message("catenary.slack", length=solution.grounded_length, span=solution.span)
    parts = list(zip(count(1), solution.segments, solution.line.segments))
    for number, state, segment in parts:
        if isinstance(segment.EA, StrainTable):
            continue  # whose strains are its own
        if INEXTENSIBLE < segment.EA < math.inf:
            yield Message("catenary.inextensible", number=number, EA=segment.EA)
        strain = state.max_tension / segment.EA
        if strain > LARGE_STRAIN:
            values = {"number": number, "strain": 100 * strain, "limit": 100 * LARGE_STRAIN}
            yield Message("catenary.large_strain", **values)
    for number, state, _ in parts:
        if state.MBL is not None and state.max_tension > state.MBL:
            carried, MBL = Measure("tension", state.max_tension), Measure("MBL", state.MBL)
            yield Message("catenary.beyond_MBL", number=number, tension=carried, MBL=MBL)
    if solution.anchor.tension == 0.0 and solution.horizontal_force > 0.0:
        yield Message("catenary.held_by_friction")
    open_force = solution.residual.force_uncertainty
    if open_force > OPEN_FORCE * solution.fairlead.tension:
        yield Message("catenary.nearly_straight", force=open_force)


def above_water(solution: Solution, water_depth: float) -> tuple[Message, ...]:
    """Warn when the line rises above both the water and its fairlead; refuse a buoy above it."""
    heights = (state.z for state in solution.point_loads)
    check_buoys(solution.line, heights, water_depth)
    # Only a buoyant part can rise above both of its ends.
    floats = any(stretch.submerged_weight < 0.0 for stretch in solution.stretches)
    ends = (solution.fairlead_height, *(stretch.z for stretch in solution.stretches))
    top = max(solution.profile(201).z) if floats else max(ends)
    limit = max(water_depth, solution.fairlead_height)
    if top <= limit * (1.0 + 1e-9):
        return ()
    return (Message("catenary.rises", height=top - limit),)


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
