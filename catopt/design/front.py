"""The front: the designs that no other design beats in all objectives.

A design beats (dominates) another when it is as small in every objective and smaller in one. Of
designs that are equal in all objectives the first is kept. All objectives are made small.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from catopt.compiled import compiled
from catopt.design.problem import Floats, Genes

Indices = NDArray[np.int64]

_A_ROW = 4e-6
"""Time that a row takes as plain Python, s."""


class Front(NamedTuple):
    """Designs of which none beats another, by rising first objective.

    Attributes
    ----------
    genes : ndarray of int, shape (n, genes)
        The designs.
    objectives : ndarray, shape (n, objectives)
        What they are worth.
    """

    genes: Genes
    objectives: Floats


def empty_front(genes: int, objectives: int) -> Front:
    """Front of no design, to which designs are merged."""
    return Front(np.empty((0, genes), dtype=np.int64), np.empty((0, objectives)))


def merge(front: Front, genes: Genes, objectives: Floats) -> Front:
    """Merge more feasible designs into a front.

    Of two that are equal in all objectives the front's stays. A row of objectives that is not
    finite is left out. Designs given in many batches end in the front of all of them together.
    """
    best = non_dominated(objectives)
    genes = np.concatenate((front.genes, genes[best]))
    objectives = np.concatenate((front.objectives, objectives[best]))
    best = non_dominated(objectives)
    return Front(genes[best], objectives[best])


def non_dominated(objectives: Floats) -> Indices:
    """Find the rows of two or three objectives, made small, that no other row beats.

    By rising first, then second objective. Of equal rows the first alone, and none that is not
    finite. In the order of the sorted rows only an earlier row can beat a later one. With two
    objectives the running minimum of the second says whether one does. With three, those kept so
    far form a staircase in the second and third, on which a row's place is found by bisection (H.
    T. Kung, F. Luccio and F. P. Preparata, Journal of the ACM 22 (1975) 469).
    """
    finite = np.flatnonzero(np.isfinite(objectives).all(axis=1))
    rows = objectives[finite]
    # lexsort is stable, so that the first of equal rows stays the first.
    order = np.lexsort(rows.T[::-1])
    rows = rows[order]
    find = _best_of_two if rows.shape[1] == 2 else compiled(_best_of_three, _A_ROW * len(rows))
    is_best = find(rows)
    best: Indices = finite[order[is_best]]
    return best


def _best_of_two(rows: Floats) -> NDArray[np.bool_]:
    """Whether each of the sorted rows is smaller in the second objective than all before it."""
    second = rows[:, 1]
    least_before = np.empty_like(second)
    least_before[:1] = np.inf
    np.minimum.accumulate(second[:-1], out=least_before[1:])
    is_best: NDArray[np.bool_] = second < least_before
    return is_best


def _best_of_three(rows: Floats) -> NDArray[np.bool_]:
    """Whether no earlier one of the sorted rows is as small in the second and third objective.

    The staircase holds the steps of the rows kept so far: y rises and z falls.
    """
    count = len(rows)
    is_best = np.zeros(count, dtype=np.bool_)
    steps_y, steps_z = np.empty(count), np.empty(count)
    steps = 0
    for row in range(count):
        y, z = rows[row, 1], rows[row, 2]
        after = np.searchsorted(steps_y[:steps], y, side="right")
        if after > 0 and steps_z[after - 1] <= z:
            continue
        is_best[row] = True
        # Steps at or right of y and not lower than z disappear under the new one.
        first = after - 1 if after > 0 and steps_y[after - 1] == y else after
        last = first
        while last < steps and steps_z[last] >= z:
            last += 1
        shift = first + 1 - last
        if shift > 0:
            for step in range(steps - 1, last - 1, -1):
                steps_y[step + shift], steps_z[step + shift] = steps_y[step], steps_z[step]
        elif shift < 0:
            for step in range(last, steps):
                steps_y[step + shift], steps_z[step + shift] = steps_y[step], steps_z[step]
        steps += shift
        steps_y[first], steps_z[first] = y, z
    return is_best


def crowding_distance(objectives: Floats) -> Floats:
    """Distance between the two neighbours of each design of a front, summed over the objectives.

    From shape (n, objectives), shape (n,). Each objective counts as a share of its range on the
    front. The ends of an objective are infinitely lonely (K. Deb et al., IEEE Trans. Evol. Comp. 6
    (2002) 182, III B).
    """
    distance = np.zeros(len(objectives))
    for values in objectives.T:
        order = np.argsort(values, kind="stable")
        ordered = values[order]
        gaps = np.full(len(values), np.inf)
        gaps[1:-1] = ordered[2:] - ordered[:-2]
        length = np.ptp(values) if len(values) else 0.0
        distance[order] += gaps / (length if length > 0.0 else 1.0)
    return distance
