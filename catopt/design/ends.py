"""What a front runs into at its ends: checks that the next steps fail, and the end of a choice."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catopt.checks.result import CheckResult
from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem, objective_words
from catopt.design.neighbours import Step, neighbour, steps
from catopt.design.result import DesignPoint, Neighbour
from catopt.ties import first_largest
from catopt.words import Listed, Message, Several


def ends(problem: DesignProblem, front: Sequence[DesignPoint]) -> tuple[Message, ...]:
    """Say for each objective what keeps it from being smaller than at its end of the front."""
    told = []
    for name in problem.names:
        key = OBJECTIVE_KEYS[name]
        index = first_largest([-each.objectives[key] for each in front])
        what = end_of_front(problem, front[index], name)
        told.append(
            Message("design.end", objective=objective_words(name), number=index + 1, what=what)
        )
    return tuple(told)


def end_of_front(problem: DesignProblem, point: DesignPoint, objective: str) -> Message:
    """Say what the steps to a smaller value of an objective run into."""
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
    parts = []
    if checks:
        parts.append(Message("design.runs_into", checks=Listed(checks, "or")))
    closed = list(_closed(around, key, here))
    if closed:
        parts.append(Message("design.choices_end", variables=Listed(closed, "and")))
    if not parts:
        parts.append(Message("design.no_step"))
    return Several((Several(parts), *_tightest(point.governing)), " ")


def _closed(around: Sequence[tuple[Step, Neighbour]], key: str, here: float) -> Iterator[str]:
    """Yield the variables at the end of their choices where one more step would give less.

    A step back gives more, and there is none on the other side.
    """
    for variable in dict.fromkeys(step.variable for step, _ in around if step.variable):
        found = [each for step, each in around if step.variable == variable]
        point = found[0].point
        if len(found) == 1 and point is not None and point.objectives[key] > here:
            yield variable


def _stop(worst: CheckResult | None) -> Message:
    assert worst is not None
    return Message(_STOPS[worst.kind], load_case=worst.load_case)


def _tightest(worst: CheckResult | None) -> Iterator[Message]:
    if worst is None:
        return
    values = {"check": worst.name, "load_case": worst.load_case}
    if worst.utilisation is None:
        yield Message("design.tightest", **values)
    else:
        yield Message("design.tightest_used", used=worst.utilisation, **values)


_STOPS = {
    "tension": "design.stop_tension",
    "uplift_angle": "design.stop_uplift_angle",
    "uplift_force": "design.stop_uplift_force",
    "grounded_length": "design.stop_grounded_length",
    "offset": "design.stop_offset",
    "buoyancy": "design.stop_buoyancy",
    "sliding": "design.stop_sliding",
    "holding": "design.stop_holding",
}
"""Key of what a step runs into, by kind of check."""
