"""What a search of a design space ends with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from catopt.design.problem import Floats, Genes

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
    """

    genes: Genes
    objectives: Floats
    evaluations: int
    feasible: int
    interrupted: bool
    closest: tuple[int, ...] | None
    least_excess: float
