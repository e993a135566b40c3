"""What a search keeps of the designs that it has evaluated, and what it ends with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from catopt.checks.excess import ROUNDING
from catopt.design.front import empty_front, merge
from catopt.design.problem import Evaluated, Floats, Genes, Problem

Progress = Callable[[int, int], None]
"""Called with the designs evaluated so far and those that may be at most."""


@dataclass(frozen=True)
class Outcome:
    """The front that a search found, and what it took.

    The front is of all designs that were ever evaluated: those that are feasible and that no other
    feasible one beats, by rising first objective.
    """

    genes: Genes  # no row where none is feasible
    objectives: Floats
    evaluations: int  # each design counts once
    feasible: int
    interrupted: bool
    # the design of the least excess, which explains what stops the others where none is feasible;
    # None where none was evaluated, its excess is infinite then
    closest: tuple[int, ...] | None
    least_excess: float
    unsolved: int = 0  # lines that did not converge, of an enumeration
    # designs that each of `catopt.design.bounds.BOUNDS` has proved needless, and that were not
    # evaluated; empty where nothing is proved
    excluded: tuple[int, ...] = ()


class Tally:
    """What is kept of the designs evaluated so far; as of `Outcome`."""

    def __init__(self, problem: Problem, progress: Progress | None = None) -> None:
        self.problem = problem
        self.progress = progress
        self.front = empty_front(len(problem.sizes), problem.objectives)
        self.evaluations = 0
        self.feasible = 0
        self.closest: Genes = self.front.genes  # one row, none as long as there is no such design
        self.least_excess = float("inf")
        self.unsolved = 0
        self.excluded: tuple[int, ...] = ()

    def count(
        self,
        genes: Genes,
        objectives: Floats,
        excess: Floats,
        *,
        is_whole: bool = True,
        excluded: tuple[int, ...] = (),
    ) -> None:
        """Add designs; an excess that is not of all checks tells nothing of the closest design."""
        is_feasible = excess <= ROUNDING
        front = merge(self.front, genes[is_feasible], objectives[is_feasible])
        least = int(np.argmax(excess <= excess.min() + ROUNDING))
        # Nothing slow from here on: what Ctrl-C leaves belongs together.
        self.front = front
        self.evaluations += len(genes) - sum(excluded)
        before = self.excluded or (0,) * len(excluded)
        self.excluded = tuple(map(int.__add__, before, excluded)) or before
        self.feasible += int(is_feasible.sum())
        if is_whole and excess[least] < self.least_excess - ROUNDING:
            self.closest, self.least_excess = genes[[least]], float(excess[least])

    def outcome(self, *, interrupted: bool, evaluated: int = 0) -> Outcome:
        """Sum up; `evaluated` says how many designs an earlier pass over them has evaluated."""
        return Outcome(
            *self.front,
            evaluations=max(self.evaluations, evaluated),
            feasible=self.feasible,
            interrupted=interrupted,
            closest=tuple(self.closest[0].tolist()) if len(self.closest) else None,
            least_excess=self.least_excess,
            unsolved=self.unsolved,
            excluded=self.excluded,
        )


class BudgetSpentError(Exception):
    """The search has evaluated as many designs as it may. It never leaves `explore`."""


class EvaluationArchive(Tally):
    """What one search knows of a design space: each design is evaluated once, within a budget."""

    def __init__(self, problem: Problem, budget: int, progress: Progress | None = None) -> None:
        super().__init__(problem, progress)
        self._budget = budget
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
        # Lengthen what is remembered to a number of rows or more; a budget may be any number.
        more = max(last, 2 * len(self._excess)) - len(self._excess)
        if last > len(self._excess):
            room = np.empty((more, self.problem.objectives))
            self._objectives = np.concatenate((self._objectives, room))
            self._excess = np.concatenate((self._excess, np.empty(more)))
        self._objectives[first:last] = objectives
        self._excess[first:last] = excess
        self._row.update((each.tobytes(), first + k) for k, each in enumerate(genes))
        self.count(genes, objectives, excess)
        if self.progress is not None:
            self.progress(last, self._budget)
