"""What an engineer should know before using an answer: rules with their numbers."""

from __future__ import annotations

from collections.abc import Sequence

from catopt.catenary.solution import Solution
from catopt.catenary.surface import check_buoys

__all__ = ["above_water", "other_tensions", "plausibility", "slides"]

OPEN_FORCE = 1e-6
"""Beyond this part of the tension the rounding of the input shows in the digits printed."""

LARGE_STRAIN = 0.05
"""Beyond a few percent, chain and rope no longer stretch in proportion to the tension."""


def plausibility(solution: Solution) -> tuple[str, ...]:
    """Warnings that follow from the line alone."""
    return (
        *_slack(solution),
        *_strain(solution),
        *_strength(solution),
        *_no_anchor_pull(solution),
        *_open_force(solution),
    )


def above_water(solution: Solution, water_depth: float) -> tuple[str, ...]:
    """Warn when the line rises above both the water and its fairlead; refuse a buoy above it.

    Raises
    ------
    FloatsUpError
        As for `check_buoys`.
    """
    heights = (state.z for state in solution.point_loads)
    check_buoys(solution.line, heights, water_depth)
    # Only a buoyant part can rise above both of its ends.
    floats = any(stretch.submerged_weight < 0.0 for stretch in solution.stretches)
    ends = (solution.fairlead_height, *(stretch.z for stretch in solution.stretches))
    top = max(solution.profile(201).z) if floats else max(ends)
    limit = max(water_depth, solution.fairlead_height)
    if top <= limit * (1.0 + 1e-9):
        return ()
    return (
        f"the line rises {top - limit:.3g} m above the water surface; its weight there is taken "
        "as submerged",
    )


def other_tensions(solution: Solution, forces: Sequence[float]) -> tuple[str, ...]:
    """Warn of smaller horizontal forces with the same fairlead tension.

    Parameters
    ----------
    solution : Solution
        For a known fairlead tension.
    forces : sequence of float
        The others, N.
    """
    if not forces:
        return ()
    others = " and ".join(f"{force:.6g} N" for force in forces)
    return (
        f"the line has this fairlead tension at another horizontal force, too: {others}; given "
        f"here is the largest, {solution.horizontal_force:.6g} N",
    )


def slides(solution: Solution, span: float) -> tuple[str, ...]:
    """Warn that a line held at its span would slide to another one under a held force.

    Parameters
    ----------
    solution : Solution
        Of a line that seabed friction lets slide.
    span : float
        Where it comes to rest under the same horizontal force, m.
    """
    return (
        f"with a seabed friction of {solution.seabed_friction:g} this line rests only while its "
        f"span is held: under the same horizontal force it also lies at a span of {span:.6g} m, "
        "and slides there when the force is held instead",
    )


def _open_force(solution: Solution) -> tuple[str, ...]:
    open_force = solution.residual.force_uncertainty
    if open_force <= OPEN_FORCE * solution.fairlead.tension:
        return ()
    return (
        "the line is so nearly straight that the last digits of its length and of the places of "
        f"its ends decide the forces: these are known to {open_force:.2g} N",
    )


def _slack(solution: Solution) -> tuple[str, ...]:
    if solution.regime != "slack":
        return ()
    return (
        f"the line is slack: it hangs straight down and {solution.grounded_length:.4g} m of it lie "
        f"in bights on {solution.span:.4g} m of bed; how they lie is not determined",
    )


def _strain(solution: Solution) -> tuple[str, ...]:
    found = []
    for index, (state, segment) in enumerate(
        zip(solution.segments, solution.line.segments, strict=True)
    ):
        strain = state.max_tension / segment.EA
        if strain > LARGE_STRAIN:
            found.append(
                f"segment {index + 1} stretches by {100 * strain:.3g} %; a constant EA is doubtful "
                f"beyond {100 * LARGE_STRAIN:g} %"
            )
    return tuple(found)


def _strength(solution: Solution) -> tuple[str, ...]:
    found = []
    for index, state in enumerate(solution.segments):
        if state.MBL is not None and state.max_tension > state.MBL:
            found.append(
                f"segment {index + 1} carries {state.max_tension / 1e3:.4g} kN, more than its MBL "
                f"of {state.MBL / 1e3:.4g} kN"
            )
    return tuple(found)


def _no_anchor_pull(solution: Solution) -> tuple[str, ...]:
    friction_holds = solution.anchor.tension == 0.0 and solution.horizontal_force > 0.0
    if not friction_holds:
        return ()
    return ("seabed friction alone holds the line; no tension reaches the anchor",)
