"""Solve a case file's line by particle swarm."""

from __future__ import annotations

from collections.abc import Callable

from catopt.catenary.solution import Solution
from catopt.catenary.swarm.solve import solve_swarm
from catopt.model import Case
from catopt.model.validity import Findings


def solve_case_by_swarm(case: Case, *, progress: Callable[[int], None] | None = None) -> Solution:
    """Solve a case by the particle swarm method of S1; errors as for `solve_swarm`.

    The horizontal force is known and the anchor on the bed: S1 has no other.
    """
    found = Findings("swarm")
    if case.find is not None:
        found.add(
            "find", case.find.quantity, "the swarm method seeks nothing; the closed form does"
        )
    force = None if case.load is None else case.load.horizontal_force
    if force is None:
        found.add(
            "load", "no horizontal_force", "the swarm method wants one; the closed form does not"
        )
    if case.anchor_height != 0.0:
        found.add(
            "line.anchor_height",
            f"{case.anchor_height:g} m",
            "the swarm method has the anchor on the bed; the closed form does not need that",
        )
    found.raise_if_any()
    assert force is not None
    return solve_swarm(
        case.line,
        height=case.fairlead_height,
        horizontal_force=force,
        settings=case.swarm,
        seabed_friction=case.site.seabed_friction,
        progress=progress,
    )
