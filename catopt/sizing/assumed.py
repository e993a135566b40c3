"""What the loads depend on that is known only when the line is: assumed, compared, raised."""

from __future__ import annotations

import math
from dataclasses import dataclass

_ROUNDING = 1e-9


@dataclass(frozen=True)
class Assumed:
    """The line that the loads were computed for.

    Attributes
    ----------
    diameter : float
        Nominal, of the chain that the water moves, m; 0 for none.
    pull : float
        Of the line downwards on the buoy, N.
    forces : tuple of float
        Horizontal force on the line in each load case, N; empty where it is that of the loads.
    """

    diameter: float = 0.0
    pull: float = 0.0
    forces: tuple[float, ...] = ()

    def covers(self, other: Assumed) -> bool:
        """Whether the loads for this are on the safe side of those for another."""
        own, others = self._values(other), other._values(self)
        return all(a >= b * (1.0 - _ROUNDING) for a, b in zip(own, others, strict=True))

    def raised_to(self, other: Assumed) -> Assumed:
        """Return the larger of each."""
        diameter, pull, *forces = map(max, self._values(other), other._values(self))
        return Assumed(diameter, pull, tuple(forces))

    def _values(self, other: Assumed) -> tuple[float, ...]:
        forces = self.forces or (0.0,) * len(other.forces)
        return self.diameter, self.pull, *forces


def rounded_up(value: float, digits: int = 2) -> float:
    """Round a positive number up to so many digits: 4231 becomes 4300."""
    if value <= 0.0:
        return 0.0
    unit = 10.0 ** (math.floor(math.log10(value)) - digits + 1)
    return float(unit * math.ceil(value / unit * (1.0 - _ROUNDING)))
