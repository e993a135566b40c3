"""One design, or the line of the case, in full: anchor and the report of ``catopt check``."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

import numpy as np

from catopt.checks.case import check_line
from catopt.checks.result import CheckReport
from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem
from catopt.design.mooring import MooringProblem
from catopt.design.mooring_point import mooring_point
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
    point = (
        _mooring(problem, genes) if isinstance(problem, MooringProblem) else _line(problem, genes)
    )
    _compare(problem, point)
    return point


def _line(problem: DesignProblem, genes: tuple[int, ...]) -> DesignPoint:
    """Work out one line."""
    line, anchor = problem.space.line(genes), problem.anchor(genes)
    checks = check_line(line, problem.case, anchor)
    return DesignPoint(line, anchor, genes, objectives_of(problem, line, checks), checks)


def _mooring(problem: MooringProblem, genes: tuple[int, ...]) -> DesignPoint:
    """Work out several equal lines about a body; mass and cost are those of all."""
    line, point = problem.space.line(genes), mooring_point(problem, genes)
    cost, lines = _cost(line), len(problem.system(genes).legs)
    values = {
        "mass": None if line.mass is None else lines * line.mass,
        "offset": point.offset,
        "cost": None if cost is None else lines * cost,
    }
    known = {OBJECTIVE_KEYS[name]: values[name] for name in problem.known}
    objectives = {key: value for key, value in known.items() if value is not None}
    return DesignPoint(line, problem.case.anchor, genes, objectives, point.checks, point)


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


def _compare(problem: DesignProblem, point: DesignPoint) -> None:
    """Compare the loop of the search with the closed form."""
    genes, objectives, checks = point.genes, point.objectives, point.checks
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
    case, line = problem.case, problem.case.line
    try:
        if isinstance(problem, MooringProblem):
            own = MooringProblem.of_present(case)
            return Neighbour(
                Message("design.present_mooring"), _mooring(own, (0,) * len(own.sizes))
            )
        checks = check_line(line, case)
    except CatoptError as error:
        return Neighbour(Message(PRESENT), None, error.message)
    objectives = objectives_of(problem, line, checks)
    return Neighbour(Message(PRESENT), DesignPoint(line, case.anchor, (), objectives, checks))
