"""The search for the best designs of a case, by whichever method fits."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np

from catopt.design.bounds import BOUNDS
from catopt.design.enumeration import enumerate_designs, estimate
from catopt.design.evaluation import (
    OBJECTIVE_KEYS,
    DesignProblem,
    design_point,
    objective_words,
    present_line,
)
from catopt.design.front import Knee, hypervolume, knee, reference_point
from catopt.design.mooring import MooringProblem
from catopt.design.near_miss import no_feasible_design
from catopt.design.neighbours import ends, neighbours
from catopt.design.outcome import Outcome, Progress
from catopt.design.problem import Genes
from catopt.design.result import DesignPoint, DesignResult
from catopt.errors import InputError, NotConvergedError, Problem
from catopt.model import Case, Design
from catopt.model.design import SearchMethod
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


LARGE_SPACES: Final = "nsga2"
"""What "auto" takes where a space is too large to enumerate: the better of the two by
benchmarks/search.py."""

MOST_ENUMERATED: Final = 10**12
"""Designs that can be enumerated at all: at a million a second they take twelve days."""

Announce = Callable[[str], None]


def design_case(
    case: Case,
    *,
    method: SearchMethod | None = None,
    seed: int | None = None,
    evaluations: int | None = None,
    progress: Progress | None = None,
    announce: Announce | None = None,
) -> DesignResult:
    """Find the lines, or the moorings, that are best in mass, offset, excursion or cost at once.

    Parameters
    ----------
    case : Case
        With a design, which says what may vary and what is made small.
    method : {"auto", "enumeration", "nsga2", "swarm"}, optional
        Instead of the design's own. A search that may evaluate as many designs as there are gives
        way to enumeration, which is exact and far faster there; the answer says so.
    seed, evaluations : int, optional
        Instead of the design's own.
    progress : callable, optional
        Called with the designs evaluated and those there are to evaluate.
    announce : callable, optional
        Called before the search begins, with how many designs there are and how long it may take,
        in words; beside a search asked for by name also of enumeration, where that is possible.

    Returns
    -------
    DesignResult
        The front, every design of it checked. Ctrl-C ends the search and keeps the front so far.

    Raises
    ------
    InputError
        With every problem of what was asked: no such component, a figure that is missing; or the
        space is too large to be enumerated.
    NoFeasibleDesignError
        No design passes every check; it names the one that fails by the least.
    """
    case.site.check_level()
    case.check_still_water()
    case = _with_settings(case, method, seed, evaluations)
    is_mooring = case.design is not None and case.system is not None
    problem = (MooringProblem if is_mooring else DesignProblem).of(case)
    found = _search(problem, progress, announce or (lambda _: None))
    if not len(found.outcome.genes):
        raise no_feasible_design(problem, found.outcome)
    return answer(problem, found)


def _with_settings(
    case: Case, method: SearchMethod | None, seed: int | None, evaluations: int | None
) -> Case:
    """Put what was given in place of the design's own settings."""
    if case.design is None:
        return case
    given = {"method": method, "seed": seed, "evaluations": evaluations}
    own = {key: value for key, value in given.items() if value is not None}
    return replace(case, design=replace(case.design, **own))  # type: ignore[arg-type]


def _search(problem: DesignProblem, progress: Progress | None, announce: Announce) -> Found:
    design, designs = problem.design, problem.space.count
    method, workers = _method(design, designs), os.cpu_count() or 1
    if method == "enumeration":
        if designs > MOST_ENUMERATED:
            allowed = Message(
                "refused_case.designs_at_most_which_space",
                most_enumerated=MOST_ENUMERATED,
                designs=designs,
            )
            raise InputError([Problem("design.method", "enumeration", allowed)], "design")
        size = estimate(problem, workers=workers)
        announce(f"enumeration of {size}")
        start = time.perf_counter()
        outcome = enumerate_designs(problem, progress=progress, chunk=size.chunk, workers=workers)
        return Found(outcome, method, time.perf_counter() - start)
    budget = design.evaluations
    announce(f"{method}: {budget:,} evaluations in a space of {designs:,} designs")
    if designs <= design.max_enumerated:
        announce(f"enumeration would be exact: {estimate(problem, workers=workers)}")
    if method == "nsga2":
        try:
            from catopt.design.nsga2 import nsga2 as search
        except ModuleNotFoundError as error:
            allowed = Message("refused_case.not_installed_here_take_swarm", name=error.name)
            raise InputError([Problem("design.method", "nsga2", allowed)], "design") from error
    else:
        from catopt.design.swarm import swarm as search
    start, population = time.perf_counter(), min(design.population, budget)
    settings = {"evaluations": budget, "population": population, "seed": design.seed}
    outcome = search(problem, progress=progress, **settings)
    return Found(outcome, method, time.perf_counter() - start)


def _method(design: Design, designs: int) -> SearchMethod:
    """Return the method to use: a search that may evaluate every design enumerates them."""
    if design.method == "auto":
        return "enumeration" if designs <= design.max_enumerated else LARGE_SPACES
    return "enumeration" if design.evaluations >= designs else design.method
