"""What each segment of a line may carry."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport


def allowed_tensions(
    checks: CheckReport,
    solution: Solution,
    load_case: str = "",
) -> list[float | None]:
    """Find the least tension that each segment is allowed, N.

    By the checks of a load case, whose name is empty where there is only the load; without any, the
    MBL over the safety factor; None where neither is known.
    """
    found: list[float | None] = []
    for index, segment in enumerate(solution.segments, start=1):
        checked = [
            result.capacity
            for result in checks.results
            if result.kind == "tension"
            and (result.load_case == load_case or not load_case)
            and result.place.segment == index
        ]
        if checked:
            found.append(min(checked))
        else:
            found.append(None if segment.MBL is None else segment.MBL / solution.safety_factor)
    return found
