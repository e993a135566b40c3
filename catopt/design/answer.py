"""From the front as numbers to the answer: lines with their reports, and which one to take."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from catopt.design.bounds import BOUNDS
from catopt.design.evaluation import (
    OBJECTIVE_KEYS,
    DesignProblem,
    design_point,
    objective_words,
    present_line,
)
from catopt.design.front import Knee, hypervolume, knee, reference_point
from catopt.design.neighbours import ends, neighbours
from catopt.design.outcome import Outcome
from catopt.design.problem import Genes
from catopt.design.result import DesignPoint, DesignResult
from catopt.errors import NotConvergedError
from catopt.words import Listed, Message


class Found(NamedTuple):
    """What a search came to."""

    outcome: Outcome
    method: str  # "enumeration", "nsga2" or "swarm"
    seconds: float


def answer(problem: DesignProblem, found: Found) -> DesignResult:
    """Check every design of the front once more, in plain closed form, and choose one.

    The front has one design or more. NotConvergedError: the closed form confirms none of them.
    """
    outcome = found.outcome
    front = _confirmed(problem, outcome.genes)
    keys = tuple(OBJECTIVE_KEYS[name] for name in problem.names)
    objectives = np.array([[point.objectives[key] for key in keys] for point in front])
    corner = reference_point(objectives)
    best = knee(objectives)
    is_whole = found.method == "enumeration" and not outcome.interrupted
    return DesignResult(
        case=problem.case,
        objectives=keys,
        front=front,
        recommended=best.index + 1,
        recommendation=_why(problem, best, front),
        method=found.method,
        is_exact=is_whole,
        designs=problem.space.count,
        evaluations=outcome.evaluations,
        feasible=outcome.feasible,
        hypervolume=hypervolume(objectives, corner),
        reference_point=tuple(corner.tolist()),
        seed=problem.design.seed,
        interrupted=outcome.interrupted,
        ends=ends(problem, front),
        neighbours=neighbours(problem, front[best.index].genes),
        present=present_line(problem),
        seconds=found.seconds,
        excluded=dict(zip(BOUNDS, outcome.excluded, strict=False)),
        warnings=(*problem.warnings, *_of_search(problem, found, len(front))),
    )


def _confirmed(problem: DesignProblem, front: Genes) -> tuple[DesignPoint, ...]:
    """Keep the designs that pass in plain closed form, too."""
    points = []
    for genes in front:
        try:
            points.append(design_point(problem, tuple(genes.tolist())))
        except NotConvergedError:
            continue
    confirmed = tuple(point for point in points if point.checks.passes)
    if not confirmed:
        raise NotConvergedError(Message("design.none_confirmed", count=len(front)))
    return confirmed


def _why(problem: DesignProblem, best: Knee, front: tuple[DesignPoint, ...]) -> str:
    """Say why a design is recommended."""
    if len(front) == 1:
        return Message("design.only")
    names = [objective_words(name) for name in problem.names]
    if best.depth <= 0.0:
        return Message("design.no_knee", objective=names[0])
    shares = (
        Message("design.share", share=100 * share, objective=name)
        for name, share in zip(names, best.shares, strict=True)
    )
    return Message("design.knee", shares=Listed(shares, "and"))


def _of_search(problem: DesignProblem, found: Found, confirmed: int) -> Iterator[Message]:
    """Say what an engineer should know of how the front, of so many designs, was found."""
    design, outcome, count = problem.design, found.outcome, problem.space.count
    # Enumeration took the place of the search asked for, or could have.
    if design.method not in ("auto", "enumeration"):
        if found.method == "enumeration":
            values = {"method": design.method, "evaluations": design.evaluations, "count": count}
            yield Message("design.all_enumerated", **values)
        elif count <= design.max_enumerated:
            yield Message("design.approximate", method=design.method, count=count)
    if outcome.interrupted:
        yield Message("design.interrupted", done=outcome.evaluations, count=count)
    if outcome.unsolved:
        yield Message("design.unsolved", count=outcome.unsolved)
    left_out = len(outcome.genes) - confirmed
    if left_out:
        yield Message("design.not_confirmed", count=left_out)
