"""Elimination of a line's equations, linear in the nodes."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from catopt.compiled import inlined
from catopt.fem.moving import Equations

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


def eliminate_blocks(equations: Equations, first: int, end: int) -> bool:
    """Eliminate the nodes from `first` up to the one before `end`; say if all were regular.

    Diagonal blocks are turned into their inverses. Node `end` keeps its block and right hand side,
    less what the line takes from them.
    """
    diagonal, lower = equations.diagonal, equations.lower
    upper, rest = equations.upper, equations.rest
    regular = True
    for n in range(first, end):
        regular = invert_3(diagonal, n) and regular
        after = n + 1
        for i in range(3):
            l0, l1, l2 = lower[after, i, 0], lower[after, i, 1], lower[after, i, 2]
            w0 = l0 * diagonal[n, 0, 0] + l1 * diagonal[n, 1, 0] + l2 * diagonal[n, 2, 0]
            w1 = l0 * diagonal[n, 0, 1] + l1 * diagonal[n, 1, 1] + l2 * diagonal[n, 2, 1]
            w2 = l0 * diagonal[n, 0, 2] + l1 * diagonal[n, 1, 2] + l2 * diagonal[n, 2, 2]
            for j in range(3):
                diagonal[after, i, j] -= (
                    w0 * upper[n, 0, j] + w1 * upper[n, 1, j] + w2 * upper[n, 2, j]
                )
            rest[after, i] -= w0 * rest[n, 0] + w1 * rest[n, 1] + w2 * rest[n, 2]
    return regular


def back_substitute_blocks(equations: Equations, first: int, end: int) -> None:
    """Turn `rest` of the nodes from `first` on into displacements, given that of node `end`."""
    diagonal, upper, rest = equations.diagonal, equations.upper, equations.rest
    for n in range(end - 1, first - 1, -1):
        x, y, z = rest[n + 1, 0], rest[n + 1, 1], rest[n + 1, 2]
        r0 = rest[n, 0] - upper[n, 0, 0] * x - upper[n, 0, 1] * y - upper[n, 0, 2] * z
        r1 = rest[n, 1] - upper[n, 1, 0] * x - upper[n, 1, 1] * y - upper[n, 1, 2] * z
        r2 = rest[n, 2] - upper[n, 2, 0] * x - upper[n, 2, 1] * y - upper[n, 2, 2] * z
        for i in range(3):
            rest[n, i] = diagonal[n, i, 0] * r0 + diagonal[n, i, 1] * r1 + diagonal[n, i, 2] * r2


def take_block_aside(equations: Equations, side: Any, first: int, last: int) -> None:
    """Write what the rows of a line have of the place of its first node, as eliminated, to `side`.

    `eliminate_blocks` has gone from the node behind it to `last`.
    """
    diagonal, lower = equations.diagonal, equations.lower
    for i in range(3):
        for j in range(3):
            side[first + 1, i, j] = lower[first + 1, i, j]
    for n in range(first + 2, last + 1):
        behind = np.zeros((3, 3))
        _add_product(behind, diagonal, n - 1, side[n - 1], 1.0)
        for i in range(3):
            for j in range(3):
                side[n, i, j] = 0.0
        _add_product(side[n], lower, n, behind, -1.0)


def reach_of_first_block(equations: Equations, side: Any, first: int, last: int) -> Any:
    """Return the equations of a line's first node, all between its ends eliminated.

    Shape (3, 7): derivatives by its own place and by that of `last`, and the right hand side.
    """
    diagonal, upper, rest = equations.diagonal, equations.upper, equations.rest
    reach = np.zeros((3, 7))
    for i in range(3):
        reach[i, 3 + i] = 1.0
    for n in range(last - 1, first, -1):
        behind = np.zeros((3, 7))
        for i in range(3):
            behind[i, 6] = rest[n, i]
            for j in range(3):
                behind[i, j] = -side[n, i, j]
        _add_product(behind, upper, n, reach, -1.0)
        reach = np.zeros((3, 7))
        _add_product(reach, diagonal, n, behind, 1.0)
    own = np.zeros((3, 7))
    _add_product(own, upper, first, reach, 1.0)
    for i in range(3):
        own[i, 6] = rest[first, i] - own[i, 6]
        for j in range(3):
            own[i, j] += diagonal[first, i, j]
    return own


def _add_product(to: Any, blocks: Any, n: int, by: Any, sign: float) -> None:
    """Add block n times a matrix of three rows."""
    for i in range(3):
        for q in range(by.shape[1]):
            for c in range(3):
                to[i, q] += sign * blocks[n, i, c] * by[c, q]


@inlined
def invert_3(blocks: Any, n: int) -> bool:
    """Replace block n, of shape (3, 3), by its inverse; False when it has none."""
    a, b, c = blocks[n, 0, 0], blocks[n, 0, 1], blocks[n, 0, 2]
    d, e, f = blocks[n, 1, 0], blocks[n, 1, 1], blocks[n, 1, 2]
    g, h, i = blocks[n, 2, 0], blocks[n, 2, 1], blocks[n, 2, 2]
    A, B, C = e * i - f * h, f * g - d * i, d * h - e * g
    determinant = a * A + b * B + c * C
    if determinant == 0.0:
        return False
    # Of complex numbers, whose division is not everywhere the same to the last digit.
    mirrored = determinant.conjugate()
    over = mirrored * (1.0 / (determinant * mirrored).real)
    blocks[n, 0, 0], blocks[n, 1, 0], blocks[n, 2, 0] = A * over, B * over, C * over
    blocks[n, 0, 1], blocks[n, 0, 2] = (c * h - b * i) * over, (b * f - c * e) * over
    blocks[n, 1, 1], blocks[n, 1, 2] = (a * i - c * g) * over, (c * d - a * f) * over
    blocks[n, 2, 1], blocks[n, 2, 2] = (b * g - a * h) * over, (a * e - b * d) * over
    return True


def solve_dense(matrix: Any, rest: Any) -> bool:
    """Turn the right hand side of a few equations into their solution, with exchange of rows.

    False where there is none; both are overwritten.
    """
    size = rest.shape[0]
    for j in range(size):
        pivot = j
        for r in range(j + 1, size):
            if abs(matrix[r, j]) > abs(matrix[pivot, j]):
                pivot = r
        if matrix[pivot, j] == 0.0:
            return False
        for c in range(size):
            matrix[j, c], matrix[pivot, c] = matrix[pivot, c], matrix[j, c]
        rest[j], rest[pivot] = rest[pivot], rest[j]
        for r in range(j + 1, size):
            factor = matrix[r, j] / matrix[j, j]
            for c in range(j, size):
                matrix[r, c] -= factor * matrix[j, c]
            rest[r] -= factor * rest[j]
    for r in range(size - 1, -1, -1):
        for c in range(r + 1, size):
            rest[r] -= matrix[r, c] * rest[c]
        rest[r] /= matrix[r, r]
    return True


def hold(free: Any, matrix: Any, rest: Any) -> None:
    """Take the directions in which a body is held or led out of its equations."""
    for i in range(rest.shape[0]):
        if free[i] == 0.0:
            rest[i] = 0.0
            for j in range(rest.shape[0]):
                matrix[i, j] = matrix[j, i] = 0.0
            matrix[i, i] = 1.0


def copy_values(of: Any, to: Any) -> None:
    """Write an array of one axis to another."""
    for n in range(of.shape[0]):
        to[n] = of[n]


def copy_rows(of: Any, to: Any) -> None:
    """Write an array of two axes to another."""
    for n in range(of.shape[0]):
        for i in range(of.shape[1]):
            to[n, i] = of[n, i]


def copy_blocks(of: Any, to: Any) -> None:
    """Write an array of three axes to another."""
    for j in range(of.shape[0]):
        for n in range(of.shape[1]):
            for i in range(of.shape[2]):
                to[j, n, i] = of[j, n, i]


def clear_blocks(to: Any) -> None:
    """Write 0 to an array of three axes."""
    for j in range(to.shape[0]):
        for n in range(to.shape[1]):
            for i in range(to.shape[2]):
                to[j, n, i] = 0.0
