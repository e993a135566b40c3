"""The exact front: every design of the space is evaluated."""

from __future__ import annotations

import time
from collections.abc import Iterator
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
    """How large a design space is.

    Attributes
    ----------
    designs : int
        That there are.
    seconds : float
        That their evaluation may take.
    """

    designs: int
    seconds: float

    def __str__(self) -> str:
        return f"{self.designs:,} designs, {_duration(self.seconds)}"

    @property
    def chunk(self) -> int:
        """Designs to evaluate at once, between two signs of life: in some tenths of a second."""
        return max(min(CHUNK, int(0.2 * self.designs / max(self.seconds, 1e-9))), SAMPLES[0])


def estimate(problem: DesignProblem, *, workers: int = 1) -> Estimate:
    """Estimate the time from designs that are spread over the whole space.

    The first call in a process waits for the compiled loop, which does not count.
    """
    designs = problem.space.count
    problem.assess(problem.space.genes_between(0, 1), stops_early=True, of=designs)
    taken = 0.0
    for sample in (SAMPLES[0], SAMPLES[1] * workers):
        sample = min(sample, designs)
        genes = problem.space.genes_of(np.linspace(0, designs - 1, sample).astype(np.int64))
        start = time.perf_counter()
        problem.assess(genes, stops_early=True, workers=workers)
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
) -> Outcome:
    """Evaluate every design, `chunk` of them at once, and keep the front.

    Threads change nothing in the answer. Ctrl-C ends it early, with the front of the designs
    evaluated until then.
    """
    pass_, evaluated = _Pass(problem, progress, workers), 0
    try:
        for first, end in _chunks(problem.space.count, chunk):
            pass_.take(first, end, stops_early=True)
        if pass_.feasible == 0:
            # Only now is it worth knowing by how much each design fails.
            pass_, evaluated = _Pass(problem, progress, workers), pass_.evaluations
            for first, end in _chunks(problem.space.count, chunk):
                pass_.take(first, end, stops_early=False)
    except KeyboardInterrupt:
        return pass_.outcome(interrupted=True, evaluated=evaluated)
    return pass_.outcome(interrupted=False, evaluated=evaluated)


class _Pass(Tally):
    """One pass over the space, and what it has found so far."""

    def __init__(self, problem: DesignProblem, progress: Progress | None, workers: int) -> None:
        super().__init__(problem)
        self.problem = problem
        self._progress = progress
        self._workers = workers

    def take(self, first: int, end: int, *, stops_early: bool) -> None:
        """Evaluate the designs number `first` to `end` (not included)."""
        genes = self.problem.space.genes_between(first, end)
        assessed = self.problem.assess(genes, stops_early=stops_early, workers=self._workers)
        objectives = assessed.objectives[:, self.problem.columns]
        self.count(genes, objectives, assessed.excess, is_whole=not stops_early)
        self.unsolved += assessed.unsolved
        if self._progress is not None:
            self._progress(self.evaluations, self.problem.space.count)


def _chunks(count: int, size: int) -> Iterator[tuple[int, int]]:
    for first in range(0, count, size):
        yield first, min(first + size, count)


def _duration(seconds: float) -> str:
    if seconds < 1.0:
        return "less than a second"
    if seconds < 90.0:
        return f"about {seconds:.0f} s"
    return (
        f"about {seconds / 60.0:.0f} min" if seconds < 5400.0 else f"about {seconds / 3600.0:.1f} h"
    )
