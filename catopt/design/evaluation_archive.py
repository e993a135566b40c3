"""The designs that a search has evaluated: each one once, within a budget, their front kept."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from catopt.design.outcome import Outcome, Progress, Tally
from catopt.design.problem import Evaluated, Floats, Genes, Problem


class BudgetSpentError(Exception):
    """The search has evaluated as many designs as it may. It never leaves `explore`."""


class EvaluationArchive(Tally):
    """What one search knows of a design space, which is `problem`."""

    def __init__(self, problem: Problem, budget: int, progress: Progress | None = None) -> None:
        super().__init__(problem)
        self.problem = problem
        self._budget = budget
        self._progress = progress
        self._row: dict[bytes, int] = {}
        self._objectives: Floats = np.empty((0, problem.objectives))
        self._excess: Floats = np.empty(0)

    @property
    def share_spent(self) -> float:
        """Share of the budget that is spent, 0 to 1."""
        return self.evaluations / self._budget

    def is_known(self, genes: Genes) -> NDArray[np.bool_]:
        """Say which of the canonical designs were evaluated before, shape (n,)."""
        known = (each.tobytes() in self._row for each in genes)
        return np.fromiter(known, dtype=np.bool_, count=len(genes))

    def evaluate(self, genes: Genes) -> Evaluated:
        """Evaluate those of the canonical designs that are not known yet; return all.

        BudgetSpentError after the designs for which the budget was enough.
        """
        keys = [each.tobytes() for each in genes]
        new = {key: k for k, key in enumerate(keys) if key not in self._row}
        room = self._budget - self.evaluations
        chosen = list(new.values())[:room]
        if chosen:
            self._record(genes[chosen])
        if len(new) > room:
            raise BudgetSpentError
        rows = [self._row[key] for key in keys]
        return Evaluated(self._objectives[rows], self._excess[rows])

    def _record(self, genes: Genes) -> None:
        """Evaluate designs of which none is known."""
        objectives, excess = self.problem.evaluate(genes)
        # What cannot be compared is no answer, whatever its checks say.
        excess = np.where(np.isfinite(objectives).all(axis=1), excess, np.maximum(excess, 1.0))
        first, last = self.evaluations, self.evaluations + len(genes)
        self._make_room(last)
        self._objectives[first:last] = objectives
        self._excess[first:last] = excess
        self._row.update((each.tobytes(), first + k) for k, each in enumerate(genes))
        self.count(genes, objectives, excess)
        if self._progress is not None:
            self._progress(last, self._budget)

    def _make_room(self, rows: int) -> None:
        """Lengthen what is remembered to a number of rows or more; a budget may be any number."""
        more = max(rows, 2 * len(self._excess)) - len(self._excess)
        if rows > len(self._excess):
            room = np.empty((more, self.problem.objectives))
            self._objectives = np.concatenate((self._objectives, room))
            self._excess = np.concatenate((self._excess, np.empty(more)))


def explore(
    problem: Problem,
    evaluations: int,
    progress: Progress | None,
    search: Callable[[EvaluationArchive], None],
) -> Outcome:
    """Let a search run until it ends, its budget is spent or the user stops it (Ctrl-C).

    It evaluates designs through what it is given, which remembers the best of them.
    """
    archive = EvaluationArchive(problem, evaluations, progress)
    try:
        search(archive)
    except BudgetSpentError:
        pass
    except KeyboardInterrupt:
        return archive.outcome(interrupted=True)
    return archive.outcome(interrupted=False)
