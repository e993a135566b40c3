"""Solve a case: by the method wanted, or for what it seeks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from catopt.catenary.find import find_case
from catopt.catenary.result import under_case
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.model import Case

__all__ = ["Method", "solve_case"]

Method = Literal["closed-form", "pso"]


def solve_case(
    case: Case,
    method: Method = "closed-form",
    *,
    progress: Callable[[int], None] | None = None,
) -> Solution:
    """Solve a case; errors as for `solve`.

    When the case seeks something (`case.find`), the answer is the line with what was found.

    Parameters
    ----------
    case : Case
        As read by `catopt.read_case`.
    method : {"closed-form", "pso"}
        The particle swarm takes what docs/theory.md says it carries, and refuses the rest.
    progress : callable, optional
        Called after each run of the swarm with the number of runs done.
    """
    if method == "pso":
        from catopt.catenary.swarm.case import solve_case_by_swarm

        return under_case(solve_case_by_swarm(case, progress=progress), case)
    if case.find is not None:
        found = find_case(case)
        return under_case(found.solution, case).with_found(found.alone())
    assert case.load is not None
    solution = solve(
        case.line,
        height=case.fairlead_height,
        horizontal_force=case.load.horizontal_force,
        span=case.load.span,
        fairlead_tension=case.load.fairlead_tension,
        seabed_friction=case.site.seabed_friction,
        anchor_height=case.anchor_height,
    )
    return under_case(solution, case)
