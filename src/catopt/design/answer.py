"""From the front as numbers to the answer: lines with their reports, and which one to take."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from catopt.design.ends import ends
from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem
from catopt.design.hypervolume import hypervolume, reference_point
from catopt.design.knee import Knee, knee
from catopt.design.neighbours import neighbours
from catopt.design.outcome import Outcome
from catopt.design.points import design_point
from catopt.design.present import present_line
from catopt.design.problem import Genes
from catopt.design.result import DesignPoint, DesignResult
from catopt.errors import NotConvergedError

__all__ = ["Found", "answer"]


class Found(NamedTuple):
    """What a search came to.

    Attributes
    ----------
    outcome : Outcome
        The front as numbers.
    method : str
        ``"enumeration"``, ``"nsga2"`` or ``"swarm"``.
    seconds : float
        That it took.
    unsolved : int
        Lines that did not converge.
    """

    outcome: Outcome
    method: str
    seconds: float
    unsolved: int = 0


def answer(problem: DesignProblem, found: Found, seed: int) -> DesignResult:
    """Check every design of the front once more, in plain closed form, and choose one.

    Parameters
    ----------
    problem : DesignProblem
        The space.
    found : Found
        With one design on the front or more.
    seed : int
        Of the search.

    Raises
    ------
    NotConvergedError
        The closed form confirms no design of the front.
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
        recommended=best.index,
        recommendation=_why(problem, best, front),
        method=found.method,
        is_exact=is_whole,
        designs=problem.space.count,
        evaluations=outcome.evaluations,
        feasible=outcome.feasible,
        hypervolume=hypervolume(objectives, corner),
        reference_point=tuple(corner.tolist()),
        seed=seed,
        interrupted=outcome.interrupted,
        ends=ends(problem, front),
        neighbours=neighbours(problem, front[best.index].genes),
        present=present_line(problem),
        seconds=found.seconds,
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
        count = f"{len(front):,} design{'' if len(front) == 1 else 's'}"
        raise NotConvergedError(f"the closed form confirms none of the {count} of the front")
    return confirmed


def _why(problem: DesignProblem, best: Knee, front: tuple[DesignPoint, ...]) -> str:
    """Say why a design is recommended."""
    if len(front) == 1:
        return "It is the only design of the front: best in every objective."
    shares = " and ".join(
        f"{100 * share:.0f} % for {name}"
        for name, share in zip(problem.names, best.shares, strict=True)
    )
    if best.depth <= 0.0:
        return (
            "The front has no knee: every compromise costs more of one objective than it gives of "
            f"the others. This is its end with the least {problem.names[0]}."
        )
    return (
        "The knee of the front. On the way from the best to the worst value of each objective on "
        f"the front it lies at {shares}, the least sum: leaving it costs more of one objective "
        "than it gives of the others."
    )


def _of_method(problem: DesignProblem, found: Found) -> Iterator[str]:
    """Say where enumeration took the place of the search asked for, or could have."""
    design, count = problem.case.design, problem.space.count
    assert design is not None
    if design.method in ("auto", "enumeration"):
        return
    if found.method == "enumeration":
        yield (
            f"{design.method} was asked for with {design.evaluations:,} evaluations, which are no "
            f"fewer than the {count:,} designs: all of them were enumerated instead, which is exact"
        )
    elif count <= design.max_enumerated:
        yield (
            f"the front of {design.method} is approximate; all {count:,} designs can be "
            "enumerated, which is exact (--method enumeration)"
        )


def _of_search(problem: DesignProblem, found: Found, confirmed: int) -> list[str]:
    """Say what an engineer should know of how the front, of so many designs, was found."""
    told = list(_of_method(problem, found))
    evaluated = f"{found.outcome.evaluations:,} of {problem.space.count:,} designs"
    if found.outcome.interrupted:
        told.append(f"the search was interrupted after {evaluated}: the front may be incomplete")
    if found.unsolved:
        told.append(f"{found.unsolved:,} designs did not converge and were left out")
    left_out = len(found.outcome.genes) - confirmed
    if left_out:
        told.append(
            "designs left out of the front, because the closed form does not confirm them: "
            f"{left_out:,}; what only they beat is missing"
        )
    return told
