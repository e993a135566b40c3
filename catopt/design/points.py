"""One design, or the line of the case, in full: anchor and the report of ``catopt check``."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

import numpy as np

from catopt.checks.case import check_line
from catopt.checks.result import CheckReport
from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem
from catopt.design.result import DesignPoint, Neighbour
from catopt.errors import CatoptError
from catopt.model import Line
from catopt.words import Message

AGREEMENT = 1e-8
"""By how much the compiled loop and the closed form in plain Python may differ, relatively: both
end their roots at 1e-12 of the line's length or better."""


def design_point(problem: DesignProblem, genes: tuple[int, ...]) -> DesignPoint:
    """Build, solve and check one design in plain closed form.

    NoEquilibriumError: it has no equilibrium in one of the load cases. CatoptError: the answer is
    not that of the compiled loop, a fault of ours, never passed over.
    """
    line = problem.space.line(genes)
    anchor = problem.anchor(genes)
    checks = check_line(line, problem.case, anchor)
    objectives = objectives_of(problem, line, checks)
    _compare(problem, genes, objectives, checks)
    return DesignPoint(line, anchor, genes, objectives, checks)


def objectives_of(problem: DesignProblem, line: Line, checks: CheckReport) -> Mapping[str, float]:
    """Work out all known objectives of a checked line, the wanted ones first.

    A line of the user's own may lack a mass or a price; what follows from them is then left out.
    """
    spans = [solution.span for _, solution in checks.solutions]
    at_rest = [
        span for span, state in zip(spans, problem.states, strict=True) if state.kind == "reference"
    ]
    excursion = max(spans) - min(at_rest) if at_rest else None
    values = {
        "mass": line.mass,
        "offset": max(spans),
        "excursion": excursion,
        "cost": _cost(line),
    }
    known = ((OBJECTIVE_KEYS[name], values[name]) for name in problem.known)
    return {key: value for key, value in known if value is not None}


def _cost(line: Line) -> float | None:
    """Material of the segments, USD; None when the price of one is not known."""
    prices = [segment.price for segment in line.segments]
    known = [price for price in prices if price is not None]
    if len(known) < len(prices):
        return None
    lengths = (segment.length for segment in line.segments)
    return math.fsum(length * price for length, price in zip(lengths, known, strict=True))


def _compare(
    problem: DesignProblem,
    genes: tuple[int, ...],
    objectives: Mapping[str, float],
    checks: CheckReport,
) -> None:
    """Hold the compiled loop against the closed form."""
    batch = problem.evaluate(np.array([genes]))
    steps = problem.tables.step[problem.columns]
    compared = [
        (name, batch.objectives[0, index], objectives[OBJECTIVE_KEYS[name]], steps[index])
        for index, name in enumerate(problem.names)
    ]
    size = max(problem.space.line(genes).length, 1.0)
    if checks.results:
        worst = max(result.excess for result in checks.results)
        compared.append(("excess", batch.excess[0], worst, 0.0))
    for name, compiled_one, plain, step in compared:
        room = AGREEMENT * max(abs(plain), size if name in ("offset", "excursion") else 1.0)
        # What is small beside the largest of the space was rounded by more than that.
        if not abs(compiled_one - plain) <= room + step:
            raise CatoptError(
                f"design {genes}: the {name} of the search, {compiled_one!r}, is not that of the "
                f"closed form, {plain!r}; please report this case"
            )


PRESENT: Final = "design.present"
"""Key of what the line is called."""


def present_line(problem: DesignProblem) -> Neighbour:
    """Check the line of the case by the same checks as the designs.

    A sinker that the search chooses is not part of the present line. Its `point` is None, with the
    reason, where the line has no equilibrium or a figure that a check needs is missing: that is no
    error of the search.
    """
    line = problem.case.line
    try:
        checks = check_line(line, problem.case)
    except CatoptError as error:
        return Neighbour(Message(PRESENT), None, error.message)
    objectives = objectives_of(problem, line, checks)
    point = DesignPoint(line, problem.case.anchor, (), objectives, checks)
    return Neighbour(Message(PRESENT), point)
