"""The search for the best designs of a case: all of them, or a method for spaces too large."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Collection, Iterator
from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np

from catopt.checks.kinds import ROUNDING
from catopt.design.assess import BOUNDS
from catopt.design.evaluation import (
    OBJECTIVE_KEYS,
    DesignProblem,
    design_point,
    objective_words,
    present_line,
)
from catopt.design.front import (
    Genes,
    Knee,
    Outcome,
    Tally,
    hypervolume,
    knee,
    reference_point,
)
from catopt.design.groups import GroupProblem
from catopt.design.mooring import MooringProblem
from catopt.design.neighbours import ends, neighbours, no_feasible_design
from catopt.design.result import DesignPoint, DesignResult
from catopt.errors import NotConvergedError, refused
from catopt.model import Case
from catopt.model.design import FoundBy, SearchMethod
from catopt.model.network import Network
from catopt.progress import Progress
from catopt.words import Listed, Message

CHUNK = 50_000
"""Designs evaluated at once: some ten MB, and a fraction of a second between two signs of life."""

SAMPLES = 100, 2000
"""Designs by which the time is estimated, and those a thread where that took no time to measure."""

MEASURABLE = 0.005
"""s."""


class Estimate(NamedTuple):
    """How large a design space is."""

    designs: int
    seconds: float  # that their evaluation may take

    @property
    def words(self) -> Message:
        """Both, as it is announced."""
        seconds = self.seconds
        if seconds < 1.0:
            time = Message("beside.no_second")
        elif seconds < 90.0:
            time = Message("beside.about_seconds", time=seconds)
        elif seconds < 5400.0:
            time = Message("beside.about_minutes", time=seconds / 60.0)
        else:
            time = Message("beside.about_hours", time=seconds / 3600.0)
        return Message("beside.designs_and_time", count=self.designs, time=time)

    @property
    def chunk(self) -> int:
        """Designs to evaluate at once, between two signs of life: in some tenths of a second."""
        return max(min(CHUNK, int(0.2 * self.designs / max(self.seconds, 1e-9))), SAMPLES[0])


def estimate(problem: DesignProblem, *, workers: int = 1) -> Estimate:
    """Estimate the time from designs that are spread over the whole space.

    The first call in a process waits for the compiled loop, which does not count. Bounds leave out
    most of a whole mooring's designs: the sample is timed by the front that it has itself.
    """
    designs = problem.space.count
    problem.assess(problem.space.genes_between(0, 1), stops_early=True, of=designs)
    taken, tally = 0.0, Tally(problem)
    for sample in (SAMPLES[0], SAMPLES[1] * workers):
        sample = min(sample, designs)
        genes = problem.space.genes_of(np.linspace(0, designs - 1, sample).astype(np.int64))
        found = problem.assess(genes, stops_early=True, workers=workers)
        tally.count(genes, found.objectives[:, problem.columns], found.exceedance, is_whole=False)
        best = tally.front.objectives if len(tally.front.genes) else None
        start = time.perf_counter()
        problem.assess(genes, stops_early=True, workers=workers, best=best)
        taken = time.perf_counter() - start
        if taken > MEASURABLE:
            break
    return Estimate(designs, taken / sample * designs)


def enumerate_designs(
    problem: DesignProblem,
    *,
    progress: Progress | None = None,
    chunk: int = CHUNK,
    workers: int = 1,
    bounds: bool = True,
    without: Collection[bytes] = (),
) -> Outcome:
    """Evaluate every design, `chunk` of them at once, and keep the front.

    Whole moorings come in batches of their own, and those that bounds prove needless are left out;
    with `bounds` off the front is the same, to the last digit. Threads change nothing in the
    answer. Ctrl-C ends it early, with the front of the designs evaluated until then. Designs whose
    genes, as bytes, are in `without` count as failing.
    """

    def evaluate(tally: Tally, *, stops_early: bool, bounds: bool) -> None:
        for genes in problem.batches(chunk):
            best = tally.front.objectives if bounds else None
            found = problem.assess(genes, stops_early=stops_early, workers=workers, best=best)
            objectives, is_whole = found.objectives[:, problem.columns], not stops_early
            exceedance, excluded = found.exceedance, found.excluded
            if without:
                passing = np.flatnonzero(exceedance <= ROUNDING)
                failing = [k for k in passing.tolist() if genes[k].tobytes() in without]
                exceedance[failing] = 1.0
            tally.count(genes, objectives, exceedance, is_whole=is_whole, excluded=excluded)
            tally.unsolved += found.unsolved
            if progress is not None:
                progress(tally.evaluations + sum(tally.excluded), problem.space.count)

    tally, evaluated = Tally(problem), 0
    try:
        evaluate(tally, stops_early=True, bounds=bounds)
        if tally.feasible == 0:
            # Only now is it worth knowing by how much each design fails.
            tally, evaluated = Tally(problem), tally.evaluations
            evaluate(tally, stops_early=False, bounds=False)
    except KeyboardInterrupt:
        return tally.outcome(interrupted=True, evaluated=evaluated)
    return tally.outcome(interrupted=False, evaluated=evaluated)


class Found(NamedTuple):
    """What a search came to."""

    outcome: Outcome
    method: FoundBy
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
        load_cases=problem.load_cases(front[0]),
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
    confirmed = tuple(point for point in points if point.passes)
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
    if left_out := len(outcome.genes) - confirmed:
        yield Message("design.not_confirmed", count=left_out)


LARGE_SPACES: Final = "nsga2"
"""What "auto" takes where a space is too large to enumerate: the better of the two by
benchmarks/search.py."""

MOST_ENUMERATED: Final = 10**12
"""Designs that can be enumerated at all: at a million a second they take twelve days."""

Announce = Callable[[str], None]


def design_case(
    case: Case | Network,
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
    case : Case or Network
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

    Examples
    --------
    >>> import catopt
    >>> result = catopt.design_case(catopt.read_case("cases/design-buoy-9.5m/case.toml"))
    >>> len(result.front), all(point.checks.passes for point in result.front)
    (21, True)
    """
    if case.design is not None and case.design.in_motion:
        allowed = Message("refused_case.designs_in_motion_by")
        raise refused("design.in_motion", "true", allowed, "design")
    if case.design is not None:
        given = {"method": method, "seed": seed, "evaluations": evaluations}
        own = {key: value for key, value in given.items() if value is not None}
        case = replace(case, design=replace(case.design, **own))  # type: ignore[arg-type]
    return search_design(problem_of(case), progress, announce)


def problem_of(case: Case | Network) -> DesignProblem:
    """Make the problem of a case: of lines, of whole moorings, or of lines between points.

    Errors as for `design_case`.
    """
    if isinstance(case, Network):
        return GroupProblem.of(case)
    case.site.check_level()
    case.check_still_water()
    is_mooring = case.design is not None and case.several_lines
    return (MooringProblem if is_mooring else DesignProblem).of(case)


def search_design(
    problem: DesignProblem, progress: Progress | None = None, announce: Announce | None = None
) -> DesignResult:
    """Find the best designs of a problem, as `design_case`."""
    found = _search(problem, progress, announce or (lambda _: None))
    if not len(found.outcome.genes):
        raise no_feasible_design(problem, found.outcome)
    return answer(problem, found)


def _search(problem: DesignProblem, progress: Progress | None, announce: Announce) -> Found:
    design, designs, workers = problem.design, problem.space.count, os.cpu_count() or 1
    # A search that may evaluate every design enumerates them.
    method: FoundBy = "enumeration"
    if design.method == "auto":
        method = "enumeration" if designs <= design.max_enumerated else LARGE_SPACES
    elif design.evaluations < designs:
        method = design.method
    if method == "enumeration":
        if designs > MOST_ENUMERATED:
            values = {"most_enumerated": MOST_ENUMERATED, "designs": designs}
            allowed = Message("refused_case.designs_at_most_which_space", **values)
            raise refused("design.method", "enumeration", allowed, "design")
        size = estimate(problem, workers=workers)
        announce(Message("beside.enumeration", size=size.words))
        start = time.perf_counter()
        outcome = enumerate_designs(problem, progress=progress, chunk=size.chunk, workers=workers)
        return Found(outcome, method, time.perf_counter() - start)
    budget = design.evaluations
    announce(Message("beside.evaluations", method=method, budget=budget, designs=designs))
    if designs <= design.max_enumerated:
        size = estimate(problem, workers=workers)
        announce(Message("beside.would_be_exact", size=size.words))
    if method == "nsga2":
        try:
            from catopt.design.nsga2 import nsga2 as search
        except ModuleNotFoundError as error:
            allowed = Message("refused_case.not_installed_here_take_swarm", name=error.name)
            raise refused("design.method", "nsga2", allowed, "design") from error
    else:
        from catopt.design.swarm import swarm as search
    start, population = time.perf_counter(), min(design.population, budget)
    settings = {"evaluations": budget, "population": population, "seed": design.seed}
    outcome = search(problem, progress=progress, **settings)
    return Found(outcome, method, time.perf_counter() - start)
