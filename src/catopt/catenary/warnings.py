"""What an engineer should know before using an answer: rules with their numbers."""

from __future__ import annotations

from catopt.catenary.solution import Solution

__all__ = ["above_water", "plausibility"]

LARGE_STRAIN = 0.05
"""Beyond a few percent, chain and rope no longer stretch in proportion to the tension."""


def plausibility(solution: Solution) -> tuple[str, ...]:
    """Warnings that follow from the line alone."""
    return (*_slack(solution), *_strain(solution), *_strength(solution), *_no_anchor_pull(solution))


def above_water(solution: Solution, water_depth: float) -> tuple[str, ...]:
    """Warn when the line rises above both the water and its fairlead."""
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
