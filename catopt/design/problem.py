"""What a search sees of a design space: whole numbers in, objectives and excess out."""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

Genes = NDArray[np.int64]
"""Designs as whole numbers, shape (n, genes); gene k counts from 0 to below ``sizes[k]``."""
Floats = NDArray[np.float64]


class Evaluated(NamedTuple):
    """What many designs are worth."""

    objectives: Floats  # to be made small; nan where a design has no equilibrium
    # the largest excess of all checks over all load cases (`catopt.checks.kinds`); a design
    # is feasible when it is at most ROUNDING. Finite also where there is no equilibrium
    exceedance: Floats


class Problem(Protocol):
    """A design space with its evaluation."""

    @property
    def sizes(self) -> tuple[int, ...]:
        """How many values each gene has. Neighbouring values are alike: sizes and lengths rise."""

    @property
    def objectives(self) -> int:
        """How many objectives there are, two or three."""

    def canonical(self, genes: Genes) -> Genes:
        """Set genes that do not matter (the length of an absent segment) to 0."""

    def evaluate(self, genes: Genes) -> Evaluated:
        """Solve and check many designs under all load cases."""
