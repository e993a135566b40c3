"""Block elimination of a line's equations, three unknowns a node: linear in the nodes.

    lower_i x_(i-1) + diagonal_i x_i + upper_i x_(i+1) = rest_i

Lines that meet in one body make an arrow: each hands three equations for its last node over to the
body, whose displacement is found first and then put back into every line. Inertia makes the
diagonal blocks regular; so no rows are exchanged between nodes.
"""

from __future__ import annotations

from typing import Any

from catopt.compiled import inlined
from catopt.fem.moving import Equations


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
    """Take the directions in which a body is held or led out of its three equations."""
    for i in range(3):
        if free[i] == 0.0:
            rest[i] = 0.0
            for j in range(3):
                matrix[i, j] = matrix[j, i] = 0.0
            matrix[i, i] = 1.0
