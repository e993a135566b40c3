"""Where a search starts, the ways from one design to others, and the rounds of a search."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from catopt.design.front import (
    BudgetSpentError,
    EvaluationArchive,
    Genes,
    Outcome,
    Problem,
    crowding_distance,
)
from catopt.progress import Progress

ROAMING = 0.6
"""Share of what is left of the budget that a search roams with before it improves its front.

Measured (benchmarks/results/search.md): 0.3 and 0.6 do equally well, without improvement the swarm
is worse. More than half leaves room to find other parts of spaces that are far larger.
"""

Roam = Callable[[EvaluationArchive, float, int, np.random.Generator], None]
"""Evaluates designs, a population at once, until the given share of the budget is spent or it finds
no new one."""


def scattered(problem: Problem, count: int, generator: np.random.Generator) -> Genes:
    """Spread designs evenly over every gene (a Latin hypercube), shape (count, genes).

    Two of them may turn out equal where a gene does not matter.
    """
    strata = generator.permuted(np.tile(np.arange(count), (len(problem.sizes), 1)), axis=1).T
    places = (strata + generator.random(strata.shape)) / count
    return problem.canonical(np.floor(places * np.array(problem.sizes)).astype(np.int64))


def single_steps(genes: int) -> Genes:
    """One step of one gene, up or down; shape (2 genes, genes)."""
    up = np.eye(genes, dtype=np.int64)
    steps: Genes = np.concatenate((up, -up))
    return steps


def double_steps(genes: int) -> Genes:
    """One step each of two genes, such as a size down and a length up."""
    single = single_steps(genes)
    first, second = np.triu_indices(len(single), 1)
    both = single[first] + single[second]
    # Up and down in the same gene is no step.
    steps: Genes = both[np.count_nonzero(both, axis=1) == 2]
    return steps


def reached(problem: Problem, genes: Genes, steps: Genes) -> Genes:
    """Take every step from every design, without leaving the space.

    Canonical, in the order of the designs; some may be equal.
    """
    places = (genes[:, np.newaxis] + steps).reshape(-1, len(problem.sizes))
    is_inside = ((places >= 0) & (places < problem.sizes)).all(axis=1)
    return problem.canonical(places[is_inside])


def improve(archive: EvaluationArchive, batch: int) -> None:
    """Look round the designs of the front until nothing next to them is unknown.

    First everything one step of one gene away, then one step each of two genes: along a front that
    is bound by a check, one thing has to give when another grows. While no design is feasible, the
    design of the least excess is looked round instead. A batch is of about as many designs;
    BudgetSpentError when there are no more evaluations.
    """
    genes = len(archive.problem.sizes)
    rings = [(steps, set[bytes]()) for steps in (single_steps(genes), double_steps(genes))]
    while any(_look_round(archive, steps, finished, batch) for steps, finished in rings):
        pass


def _look_round(archive: EvaluationArchive, steps: Genes, finished: set[bytes], batch: int) -> bool:
    """Take all steps from some designs that are not finished, the loneliest first; False if none.

    Those from which they were taken are added to the finished ones.
    """
    genes, objectives = archive.front
    if not len(genes):
        genes, objectives = archive.closest, np.zeros((len(archive.closest), 1))
    is_open = np.array([each.tobytes() not in finished for each in genes], dtype=np.bool_)
    if not is_open.any():
        return False
    by_loneliness = np.argsort(-crowding_distance(objectives), kind="stable")
    # A large front would otherwise be sorted anew for every few of its designs.
    at_once = max(1, batch // max(1, len(steps)), np.count_nonzero(is_open) // 20)
    chosen = genes[by_loneliness[is_open[by_loneliness]][:at_once]]
    archive.evaluate(reached(archive.problem, chosen, steps))
    finished.update(each.tobytes() for each in chosen)
    return True


def explore(
    roam: Roam,
    problem: Problem,
    *,
    evaluations: int,
    population: int = 100,
    seed: int = 1,
    progress: Progress | None = None,
) -> Outcome:
    """Roam a design space and improve the front in turns, until a round finds no new design.

    Each of the evaluations counts once; when they are spent, the search ends. The same seed gives
    the same front. `progress` is called after every batch with the designs evaluated and
    `evaluations`. Ctrl-C gives the front so far.
    """
    generator = np.random.default_rng(seed)
    archive, before = EvaluationArchive(problem, evaluations, progress), -1
    try:
        while archive.evaluations > before:
            before = archive.evaluations
            spent = archive.share_spent
            roam(archive, spent + ROAMING * (1.0 - spent), population, generator)
            improve(archive, population)
    except BudgetSpentError:
        pass
    except KeyboardInterrupt:
        return archive.outcome(interrupted=True)
    return archive.outcome(interrupted=False)
