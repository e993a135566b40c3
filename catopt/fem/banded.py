"""Gaussian elimination of a line's equations, which couple neighbours only.

The unknowns of a line of n bars run from the anchor: tension of bar 0, displacements of node 1,
tension of bar 1, ..., displacements of node n, which is the body's. Each equation reaches 6 places
to either side, 12 to the right after rows were exchanged. Row r keeps its coefficients of columns
r - 6 to r + 12 at places 0 to 18. Work and storage are linear in the number of bars.
"""

from __future__ import annotations

from typing import Any, Final

REACH: Final = 6
DIAGONAL: Final = 6
WIDTH: Final = 19


def eliminate(band: Any, rhs: Any, first: int, end: int) -> int:
    """Eliminate all unknowns of a line but the displacements of its last node.

    What is left in the last three rows is the line's stiffness and force as the body sees them.
    Returns the row at which no pivot was found; -1 when all is well.
    """
    inner = end - 3
    for j in range(first, inner):
        last = min(j + REACH, end - 1)
        pivot = j
        largest = abs(band[j, DIAGONAL])
        for r in range(j + 1, min(last, inner - 1) + 1):
            size = abs(band[r, j - r + DIAGONAL])
            if size > largest:
                largest = size
                pivot = r
        if largest == 0.0:
            return j
        right = min(j + 2 * REACH, end - 1)
        if pivot != j:
            for c in range(j, right + 1):
                swap = band[j, c - j + DIAGONAL]
                band[j, c - j + DIAGONAL] = band[pivot, c - pivot + DIAGONAL]
                band[pivot, c - pivot + DIAGONAL] = swap
            rhs[j], rhs[pivot] = rhs[pivot], rhs[j]
        inverse = 1.0 / band[j, DIAGONAL]
        for r in range(j + 1, last + 1):
            factor = band[r, j - r + DIAGONAL] * inverse
            if factor != 0.0:
                shift = j - r
                for c in range(DIAGONAL + 1, right - j + DIAGONAL + 1):
                    band[r, c + shift] -= factor * band[j, c]
                rhs[r] -= factor * rhs[j]
    return -1


def back_substitute(band: Any, rhs: Any, first: int, end: int) -> None:
    """Turn `rhs` as `eliminate` left it into the unknowns, given the last three: the body's."""
    for r in range(end - 4, first - 1, -1):
        total = rhs[r]
        for c in range(r + 1, min(r + 2 * REACH, end - 1) + 1):
            total -= band[r, c - r + DIAGONAL] * rhs[c]
        rhs[r] = total / band[r, DIAGONAL]
