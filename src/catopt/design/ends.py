"""What a front runs into at its ends: checks that the next steps fail, and the end of a choice."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catopt.checks.result import CheckResult
from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem
from catopt.design.neighbours import Step, neighbour, steps
from catopt.design.result import DesignPoint, Neighbour
from catopt.ties import first_largest

__all__ = ["end_of_front", "ends"]


def ends(problem: DesignProblem, front: Sequence[DesignPoint]) -> tuple[str, ...]:
    """Say for each objective what keeps it from being smaller than at its end of the front.

    Parameters
    ----------
    problem : DesignProblem
        The space.
    front : sequence of DesignPoint
        At least one.
    """
    told = []
    for name in problem.names:
        key = OBJECTIVE_KEYS[name]
        index = first_largest([-each.objectives[key] for each in front])
        what = end_of_front(problem, front[index], name)
        told.append(f"Least {name}, design {index + 1}: {what}.")
    return tuple(told)


def end_of_front(problem: DesignProblem, point: DesignPoint, objective: str) -> str:
    """Say what the steps to a smaller value of an objective run into.

    Parameters
    ----------
    problem : DesignProblem
        The space.
    point : DesignPoint
        The end of the front.
    objective : str
        Which one is smallest there.
    """
    key = OBJECTIVE_KEYS[objective]
    here = point.objectives[key]
    around = [(step, neighbour(problem, step)) for step in steps(problem.space, point.genes)]
    checks = dict.fromkeys(
        _stop(found.point.governing)
        for _, found in around
        if found.point is not None
        and found.point.objectives[key] < here
        and not found.point.checks.passes
    )
    parts = [f"a step to less runs into {' or '.join(checks)}"] if checks else []
    closed = list(_closed(around, key, here))
    if closed:
        parts.append(f"the choices end for {' and '.join(closed)}")
    if not parts:
        parts.append("no step of one variable makes it smaller")
    return "; ".join(parts) + _tightest(point.governing)


def _closed(around: Sequence[tuple[Step, Neighbour]], key: str, here: float) -> Iterator[str]:
    """Yield the variables at the end of their choices where one more step would give less.

    A step back gives more, and there is none on the other side.
    """
    for variable in dict.fromkeys(step.variable for step, _ in around if step.variable):
        found = [each for step, each in around if step.variable == variable]
        point = found[0].point
        if len(found) == 1 and point is not None and point.objectives[key] > here:
            yield variable


def _stop(worst: CheckResult | None) -> str:
    assert worst is not None
    return f"{_KINDS[worst.kind]} ({worst.load_case})"


def _tightest(worst: CheckResult | None) -> str:
    if worst is None:
        return ""
    use = "" if worst.utilisation is None else f", utilisation {worst.utilisation:.3f}"
    return f" (tightest check there: {worst.name}, {worst.load_case}{use})"


_KINDS = {
    "tension": "the allowed tension",
    "uplift_angle": "the uplift angle at the anchor",
    "uplift_force": "the uplift force at the anchor",
    "grounded_length": "the least grounded length",
    "offset": "the largest offset",
    "buoyancy": "the reserve buoyancy",
    "sliding": "the sliding of the sinker",
    "holding": "the holding of the anchor",
}
