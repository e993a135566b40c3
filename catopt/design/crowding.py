"""How far apart the designs of a front lie: what is lonely deserves company."""

from __future__ import annotations

import numpy as np

from catopt.design.problem import Floats

__all__ = ["crowding_distance"]


def crowding_distance(objectives: Floats) -> Floats:
    """Distance between the two neighbours of each design, summed over the objectives.

    Each objective counts as a share of its range on the front. The ends of an objective are
    infinitely lonely (K. Deb et al., IEEE Trans. Evol. Comp. 6 (2002) 182, III B).

    Parameters
    ----------
    objectives : ndarray, shape (n, objectives)
        Of one front.

    Returns
    -------
    ndarray, shape (n,)
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
