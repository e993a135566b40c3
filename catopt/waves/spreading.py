"""Short-crested seas: how the energy of a train lies over the direction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from catopt.arrays import Array
from catopt.model.validity import Findings


@dataclass(frozen=True)
class CosineSpreading:
    """D(b) = C cos^n(b), b up to a right angle to either side of the main direction.

    C = Gamma(1 + n/2)/(sqrt(pi) Gamma(1/2 + n/2)), DNV-RP-C205: the same at every frequency. It is
    not cos^2s(b/2), which spreads over the full circle; of narrow seas s is about 2 n.
    """

    exponent: float  # n, above 0
    directions: int = 20  # into how many it is cut, each with the same energy

    def __post_init__(self) -> None:
        found = Findings("CosineSpreading")
        found.number("exponent", self.exponent, "", above=0.0)
        found.number("directions", self.directions, "", at_least=1)
        found.raise_if_any()

    @property
    def deviations(self) -> Array:
        """Angles from the main direction, rad: the median of each strip of equal energy.

        With u = sin²(b) the part of the energy within b to either side is the incomplete beta
        function of u with 1/2 and (n + 1)/2.
        """
        from scipy.special import betaincinv

        place = (2.0 * np.arange(self.directions) + 1.0) / self.directions - 1.0
        square = betaincinv(0.5, 0.5 * (self.exponent + 1.0), np.abs(place))
        angles: Array = np.sign(place) * np.arcsin(np.sqrt(square))
        return angles
