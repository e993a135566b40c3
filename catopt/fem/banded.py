"""Gaussian elimination of a line's equations, which couple neighbours only.

The unknowns of a line of n bars run from its first node: displacements of node 0, tension of bar 0,
displacements of node 1, ..., displacements of node n. Those of both ends are the points' in which
lines meet, or 0. Each equation reaches 6 places to either side, 12 to the right after rows were
exchanged. Row r keeps its coefficients of columns r - 6 to r + 12 at places 0 to 18. Work and
storage are linear in the number of bars.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

REACH: Final = 6
DIAGONAL: Final = 6
WIDTH: Final = 19


def eliminate(band: Any, rhs: Any, side: Any, first: int, end: int) -> int:
    """Eliminate all unknowns of a line but the displacements of its ends.

    `first`: row of its first bar. What is left in the last three rows is the line's stiffness and
    force as its last node sees them. `side` (rows, 3): coefficients of the displacements of its
    first node where that moves, as `take_aside` leaves them; else of no row.
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
            _swap(side, j, pivot)
        inverse = 1.0 / band[j, DIAGONAL]
        for r in range(j + 1, last + 1):
            factor = band[r, j - r + DIAGONAL] * inverse
            if factor != 0.0:
                shift = j - r
                for c in range(DIAGONAL + 1, right - j + DIAGONAL + 1):
                    band[r, c + shift] -= factor * band[j, c]
                rhs[r] -= factor * rhs[j]
                _subtract(side, r, factor, j)
    return -1


def _swap(side: Any, j: int, pivot: int) -> None:
    """Exchange two rows, where there are any."""
    if side.shape[0] > 0:
        for c in range(3):
            swap = side[j, c]
            side[j, c] = side[pivot, c]
            side[pivot, c] = swap


def _subtract(side: Any, r: int, factor: float, j: int) -> None:
    """Take a multiple of row j off row r, where there are any."""
    if side.shape[0] > 0:
        for c in range(3):
            side[r, c] -= factor * side[j, c]


def take_aside(band: Any, side: Any, first: int, end: int) -> None:
    """Copy what the rows of a line have of the displacements of its first node to `side`."""
    for r in range(first, end):
        for c in range(3):
            place = first - 3 + c - r + DIAGONAL
            side[r, c] = band[r, place] if place >= 0 else 0.0


def reach_of_first(band: Any, rhs: Any, side: Any, first: int, end: int, own: Any) -> None:
    """Write the equations of a line's first node, all between its ends eliminated.

    `own` (3, 7): coefficients of its displacements and of the last node's, and the right hand side.
    """
    reach = np.zeros((end - first, 7))
    for i in range(3):
        reach[end - first - 3 + i, 3 + i] = 1.0
    for r in range(end - 4, first - 1, -1):
        right = min(r + 2 * REACH, end - 1)
        for q in range(7):
            total = rhs[r] if q == 6 else (-side[r, q] if q < 3 else 0.0)
            for c in range(r + 1, right + 1):
                total -= band[r, c - r + DIAGONAL] * reach[c - first, q]
            reach[r - first, q] = total / band[r, DIAGONAL]
    for i in range(3):
        row = first - 3 + i
        for q in range(7):
            total = 0.0
            for c in range(first, min(row + REACH, end - 1) + 1):
                total += band[row, c - row + DIAGONAL] * reach[c - first, q]
            own[i, q] = rhs[row] - total if q == 6 else total
        for j in range(3):
            own[i, j] += band[row, j - i + DIAGONAL]


def back_substitute(band: Any, rhs: Any, first: int, end: int) -> None:
    """Turn `rhs` as `eliminate` left it into the unknowns, given the last three."""
    for r in range(end - 4, first - 1, -1):
        total = rhs[r]
        for c in range(r + 1, min(r + 2 * REACH, end - 1) + 1):
            total -= band[r, c - r + DIAGONAL] * rhs[c]
        rhs[r] = total / band[r, DIAGONAL]
