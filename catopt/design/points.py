"""One design, or the line of the case, in full: anchor and the report of ``catopt check``."""

from __future__ import annotations

import numpy as np

from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem
from catopt.design.result import DesignPoint, Neighbour
from catopt.errors import CatoptError
from catopt.words import Message

AGREEMENT = 1e-8
"""By how much the compiled loop and the closed form in plain Python may differ, relatively: both
end their roots at 1e-12 of the line's length or better."""


def design_point(problem: DesignProblem, genes: tuple[int, ...]) -> DesignPoint:
    """Build, solve and check one design in plain closed form.

    NoEquilibriumError: it has no equilibrium in one of the load cases. CatoptError: the answer is
    not that of the compiled loop, a fault of ours, never passed over.
    """
    point = problem.point(genes)
    batch = problem.evaluate(np.array([genes]))
    steps = problem.tables.step[problem.columns]
    compared = [
        (name, batch.objectives[0, index], point.objectives[OBJECTIVE_KEYS[name]], steps[index])
        for index, name in enumerate(problem.names)
    ]
    size = max(point.line.length, 1.0)
    if point.checks.results:
        worst = max(result.excess for result in point.checks.results)
        compared.append(("excess", batch.excess[0], worst, 0.0))
    for name, compiled_one, plain, step in compared:
        room = AGREEMENT * max(abs(plain), size if name in ("offset", "excursion") else 1.0)
        # What is small beside the largest of the space was rounded by more than that.
        if not abs(compiled_one - plain) <= room + step:
            raise CatoptError(
                f"design {genes}: the {name} of the search, {compiled_one!r}, is not that of the "
                f"closed form, {plain!r}; please report this case"
            )
    return point


def present_line(problem: DesignProblem) -> Neighbour:
    """Check the line of the case by the same checks as the designs.

    Its `point` is None, with the reason, where the line has no equilibrium or a figure that a check
    needs is missing: that is no error of the search.
    """
    try:
        point = problem.present()
    except CatoptError as error:
        return Neighbour(Message("design.present"), None, error.message)
    key = "design.present" if point.mooring is None else "design.present_mooring"
    return Neighbour(Message(key), point)
