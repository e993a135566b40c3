"""Hypervolume: how much of the space of objectives a front beats, the one measure of its worth.

It is the area or volume between the front and a reference point, the worst corner. It grows with
every design that is added to a front and with nothing else.
"""

from __future__ import annotations

import numpy as np

from catopt.compiled import compiled
from catopt.design.problem import Floats

MARGIN = 0.1
"""How far beyond the front the reference point lies, as a share of the front's range: far enough
for the ends to count, near enough for them not to outweigh the rest (usual practice)."""

_A_PAIR = 1e-7
"""Time that two designs beside each other take as plain Python, s."""


def reference_point(front: Floats) -> Floats:
    """Worst corner to measure fronts from, given the best front that is known.

    The worst of each objective and a tenth of its range more; of its value where all are equal.
    """
    worst = front.max(axis=0)
    length = np.ptp(front, axis=0)
    point: Floats = worst + MARGIN * np.where(length > 0.0, length, np.abs(worst))
    return point


def hypervolume(objectives: Floats, reference: Floats) -> float:
    """Area or volume that designs beat, up to the reference point; exact, in the objectives' units.

    Of any designs, not only of a front; those beyond the reference point add nothing.
    """
    inside = objectives[(objectives < reference).all(axis=1)]
    rows = inside[np.lexsort(inside.T[::-1])]
    if rows.shape[1] == 2:
        return _area(rows, reference)
    by_second = np.argsort(rows[:, 1], kind="stable")
    return float(compiled(_volume, _A_PAIR * len(rows) ** 2)(rows, by_second, reference))


def _area(rows: Floats, reference: Floats) -> float:
    """Area from rows by rising first objective: each adds a bar below the lowest before it."""
    lowest = np.minimum.accumulate(np.concatenate((reference[1:], rows[:, 1])))
    return float(((reference[0] - rows[:, 0]) * -np.diff(lowest)).sum())


def _volume(rows: Floats, by_second: Floats, reference: Floats) -> float:
    """Volume, slice by slice along the first objective; in each the area of the rows up to it."""
    count = len(rows)
    total = 0.0
    for row in range(count):
        end = rows[row + 1, 0] if row + 1 < count else reference[0]
        depth = end - rows[row, 0]
        if depth <= 0.0:
            continue
        area, lowest = 0.0, reference[2]
        for other in by_second:
            if other <= row and rows[other, 2] < lowest:
                area += (reference[1] - rows[other, 1]) * (lowest - rows[other, 2])
                lowest = rows[other, 2]
        total += depth * area
    return total
