"""What an engineer should know before using an answer: rules with their numbers."""

from __future__ import annotations

from collections.abc import Sequence

from catopt.catenary.solution import Solution
from catopt.catenary.surface import check_buoys
from catopt.words import Measure, Message

OPEN_FORCE = 1e-6
"""Beyond this part of the tension the rounding of the input shows in the digits printed."""

LARGE_STRAIN = 0.05
"""Beyond a few percent, chain and rope no longer stretch in proportion to the tension."""


def plausibility(solution: Solution) -> tuple[Message, ...]:
    """Warnings that follow from the line alone."""
    return (
        *_slack(solution),
        *_strain(solution),
        *_strength(solution),
        *_no_anchor_pull(solution),
        *_open_force(solution),
    )


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


def other_tensions(solution: Solution, forces: Sequence[float]) -> tuple[Message, ...]:
    """Warn of smaller horizontal forces with the same fairlead tension."""
    if not forces:
        return ()
    others = ", ".join(f"{force:.6g} N" for force in forces)
    return (Message("catenary.other_force", others=others, largest=solution.horizontal_force),)


def slides(solution: Solution, span: float) -> tuple[Message, ...]:
    """Warn that a line held at its span would slide to another one (m) under a held force."""
    return (Message("catenary.slides", friction=solution.seabed_friction, span=span),)


def _open_force(solution: Solution) -> tuple[Message, ...]:
    open_force = solution.residual.force_uncertainty
    if open_force <= OPEN_FORCE * solution.fairlead.tension:
        return ()
    return (Message("catenary.nearly_straight", force=open_force),)


def _slack(solution: Solution) -> tuple[Message, ...]:
    if solution.regime != "slack":
        return ()
    return (Message("catenary.slack", length=solution.grounded_length, span=solution.span),)


def _strain(solution: Solution) -> tuple[Message, ...]:
    found = []
    for index, (state, segment) in enumerate(
        zip(solution.segments, solution.line.segments, strict=True)
    ):
        strain = state.max_tension / segment.EA
        if strain > LARGE_STRAIN:
            values = {"number": index + 1, "strain": 100 * strain, "limit": 100 * LARGE_STRAIN}
            found.append(Message("catenary.large_strain", **values))
    return tuple(found)


def _strength(solution: Solution) -> tuple[Message, ...]:
    found = []
    for index, state in enumerate(solution.segments):
        if state.MBL is not None and state.max_tension > state.MBL:
            carried, MBL = Measure("tension", state.max_tension), Measure("MBL", state.MBL)
            found.append(Message("catenary.beyond_MBL", number=index + 1, tension=carried, MBL=MBL))
    return tuple(found)


def _no_anchor_pull(solution: Solution) -> tuple[Message, ...]:
    friction_holds = solution.anchor.tension == 0.0 and solution.horizontal_force > 0.0
    if not friction_holds:
        return ()
    return (Message("catenary.held_by_friction"),)
