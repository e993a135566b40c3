"""The knee of a front: the design to recommend where nothing else decides.

Every objective is measured as a share of its range on the front, 0 at its best and 1 at its worst.
The knee has the least sum of shares. With two objectives the ends of the front are (0, 1) and
(1, 0), and the knee is the design furthest below the chord that joins them: to leave it for any
other design takes a larger share of one objective than it gives of the other. The rule needs no
weights, no unit matters to it, and it holds for three objectives as it stands. (The other common
rule, the sharpest bend, depends on the designs next to it alone and jumps about on a front of
sizes that can be bought.)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from catopt.design.problem import Floats


@dataclass(frozen=True)
class Knee:
    """The recommended design of a front.

    Attributes
    ----------
    index : int
        Its row.
    shares : tuple of float
        Of the range of each objective, 0 at its best on the front and 1 at its worst.
    depth : float
        1 less the sum of the shares, for two objectives sqrt(2) times the distance from the chord.
        At most 0 where the front has no knee: then every compromise costs more than it gives.
    """

    index: int
    shares: tuple[float, ...]
    depth: float


def knee(objectives: Floats) -> Knee:
    """Find the knee of a front, of shape (n, objectives).

    Of one or two designs, and where no design lies below the chord, the recommended one is the end
    with the best first objective. ValueError: the front is empty.
    """
    if not len(objectives):
        raise ValueError("an empty front has no knee")
    length = np.ptp(objectives, axis=0)
    shares = (objectives - objectives.min(axis=0)) / np.where(length > 0.0, length, 1.0)
    total = shares.sum(axis=1)
    # Of designs that are equal to rounding, the one with the best first objective.
    equal = np.flatnonzero(total <= total.min() + 1e-12)
    index = int(equal[np.argmin(shares[equal, 0])])
    return Knee(index, tuple(shares[index].tolist()), 1.0 - float(total[index]))
