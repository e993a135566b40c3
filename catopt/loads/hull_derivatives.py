"""What turns a hull in a stream and what slows its turn, from its main dimensions."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from catopt.loads.component import LoadSource

CLARKE: Final = LoadSource(
    "Clarke, Gedling and Hine (1983), Trans. RINA 125, 45-68",
    "linear derivatives by regression over 72 hulls in deep water, as the MSS toolbox lists them",
    "C",
)
"""Of all of `HullDerivatives`."""


class HullDerivatives(NamedTuple):
    """Linear derivatives of a hull under way, pure numbers, all but `Yr` below 0.

    Forces over 1/2 rho L^2 V^2 and moments over 1/2 rho L^3 V^2, of a sway v/V and a turn r L/V
    about midships; of the accelerations likewise with L in the place of V^2.
    """

    Yv: float
    Yr: float
    Nv: float
    Nr: float
    Yv_dot: float
    Nr_dot: float

    @property
    def lever(self) -> float:
        """Where the force of a small drift angle acts, over the length, forward of midships."""
        return self.Nv / self.Yv


def hull_derivatives(
    length: float, breadth: float, draught: float, block: float
) -> HullDerivatives:
    """Estimate linear derivatives after Clarke, Gedling and Hine (1983), in deep water (C).

    Lengths in m, that at the waterline; the block coefficient is a pure number.

    Examples
    --------
    The force of a small drift angle on a tanker of 50,000 DWT in ballast acts 0.226 L ahead:

    >>> round(hull_derivatives(203.7, 32.2, 6.07, 0.72).lever, 3)
    0.226
    """
    L, B, T, beam = length, breadth, draught, breadth / draught
    unit = -math.pi * (T / L) ** 2
    return HullDerivatives(
        Yv=unit * (1.0 + 0.40 * block * beam),
        Yr=unit * (-0.5 + 2.2 * B / L - 0.080 * beam),
        Nv=unit * (0.5 + 2.4 * T / L),
        Nr=unit * (0.25 + 0.039 * beam - 0.56 * B / L),
        Yv_dot=unit * (1.0 + 0.16 * block * beam - 5.1 * (B / L) ** 2),
        Nr_dot=unit * (1.0 / 12.0 + 0.017 * block * beam - 0.33 * B / L),
    )
