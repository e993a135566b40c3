"""Which line carries the most."""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["TIE", "most_loaded"]

TIE = 1e-9
"""Of the largest tension: what a symmetric system's lines differ by is rounding."""


def most_loaded(tensions: Sequence[float]) -> int:
    """Return the line of the largest tension, counted from 0; of several alike the first.

    Parameters
    ----------
    tensions : sequence of float
        Of each line at its fairlead, N.
    """
    least = max(tensions) * (1.0 - TIE)
    return next(index for index, tension in enumerate(tensions) if tension >= least)
