"""How far apart the designs of a front lie: what is lonely deserves company."""

from __future__ import annotations

import numpy as np

from catopt.design.problem import Floats


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
