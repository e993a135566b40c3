"""The exact front: every design of the space is evaluated."""

from __future__ import annotations

import time
from typing import NamedTuple

import numpy as np

from catopt.design.evaluation import DesignProblem
from catopt.design.outcome import Outcome, Progress, Tally

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

    def __str__(self) -> str:
        return f"{self.designs:,} designs, {_duration(self.seconds)}"

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
        tally.count(genes, found.objectives[:, problem.columns], found.excess, is_whole=False)
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
) -> Outcome:
    """Evaluate every design, `chunk` of them at once, and keep the front.

    Whole moorings come in batches of their own, and those that bounds prove needless are left out;
    with `bounds` off the front is the same, to the last digit. Threads change nothing in the
    answer. Ctrl-C ends it early, with the front of the designs evaluated until then.
    """

    def evaluate(tally: Tally, *, stops_early: bool, bounds: bool) -> None:
        for genes in problem.batches(chunk):
            best = tally.front.objectives if bounds else None
            found = problem.assess(genes, stops_early=stops_early, workers=workers, best=best)
            objectives, is_whole = found.objectives[:, problem.columns], not stops_early
            excluded = found.excluded
            tally.count(genes, objectives, found.excess, is_whole=is_whole, excluded=excluded)
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


def _duration(seconds: float) -> str:
    if seconds < 1.0:
        return "less than a second"
    if seconds < 90.0:
        return f"about {seconds:.0f} s"
    return (
        f"about {seconds / 60.0:.0f} min" if seconds < 5400.0 else f"about {seconds / 3600.0:.1f} h"
    )
