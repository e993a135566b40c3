"""What a search of a design space ends with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from catopt.checks.excess import ROUNDING
from catopt.design.front import empty_front, merge
from catopt.design.problem import Floats, Genes, Problem

Progress = Callable[[int, int], None]
"""Called with the designs evaluated so far and those that may be at most."""


@dataclass(frozen=True)
class Outcome:
    """The front that a search found, and what it took.

    Attributes
    ----------
    genes : ndarray of int, shape (n, genes)
        Designs of the front, by rising first objective: of all that were ever evaluated, those
        that are feasible and that no other feasible one beats. No row where none is feasible.
    objectives : ndarray, shape (n, objectives)
        What they are worth.
    evaluations : int
        Designs that were evaluated; each counts once.
    feasible : int
        How many of those passed every check.
    interrupted : bool
        Whether the search was stopped before its end.
    closest : tuple of int or None
        The design of the least excess, which explains what stops the others where none is
        feasible; None where none was evaluated.
    least_excess : float
        Its excess; infinite where there is none.
    unsolved : int
        Lines that did not converge, of an enumeration.
    excluded : tuple of int
        How many designs each of `catopt.design.bounds.BOUNDS` has proved needless; these were not
        evaluated. Empty where nothing is proved.
    """

    genes: Genes
    objectives: Floats
    evaluations: int
    feasible: int
    interrupted: bool
    closest: tuple[int, ...] | None
    least_excess: float
    unsolved: int = 0
    excluded: tuple[int, ...] = ()


class Tally:
    """What is kept of the designs evaluated so far.

    Attributes
    ----------
    front : Front
        Of all feasible ones.
    evaluations, feasible : int
        Designs evaluated, and those of them that pass every check.
    closest : ndarray of int, shape (1, genes)
        The design of the least excess; shape (0, genes) as long as there is none.
    least_excess : float
        Its excess.
    unsolved : int
        Lines that did not converge, as far as they are counted.
    excluded : tuple of int
        Designs that were proved needless, by bound.
    """

    def __init__(self, problem: Problem) -> None:
        self.front = empty_front(len(problem.sizes), problem.objectives)
        self.evaluations = 0
        self.feasible = 0
        self.closest: Genes = self.front.genes
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
            genes=self.front.genes,
            objectives=self.front.objectives,
            evaluations=max(self.evaluations, evaluated),
            feasible=self.feasible,
            interrupted=interrupted,
            closest=tuple(self.closest[0].tolist()) if len(self.closest) else None,
            least_excess=self.least_excess,
            unsolved=self.unsolved,
            excluded=self.excluded,
        )
