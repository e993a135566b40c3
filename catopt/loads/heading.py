"""Where wind, current and waves come from, as a ship sees them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from catopt.model.kinds import Angle
from catopt.model.validity import Findings

_ALONG: Final = 1e-9


@dataclass(frozen=True)
class Headings:
    """Angles from the bow to where wind, current and waves come from, rad: 0 from ahead.

    From -pi to pi; positive to one side, negative to the other.
    """

    wind: Angle = 0.0
    """That the wind comes from; of a ship that does not weathervane, off the bow."""
    current: Angle = 0.0
    """Of the current."""
    waves: Angle = 0.0
    """Of the waves."""

    def __post_init__(self) -> None:
        found = Findings("Headings")
        for key in ("wind", "current", "waves"):
            found.number(key, getattr(self, key), "rad", at_least=-math.pi, at_most=math.pi)
        found.raise_if_any()

    def seen_at(self, heading: float) -> Headings:
        """Turn directions that are counted from any one line into angles from a bow.

        The heading of the bow counts from the same line, rad.

        Examples
        --------
        >>> Headings(wind=0.0, current=0.5).seen_at(0.2).current
        0.3
        """
        every = (self.wind, self.current, self.waves)
        return Headings(*(math.remainder(each - heading, 2.0 * math.pi) for each in every))

    @property
    def head_on(self) -> bool:
        """Whether everything comes from ahead."""
        return max(abs(self.wind), abs(self.current), abs(self.waves)) < _ALONG


HEAD_ON: Final = Headings()
"""The collinear case of a weathervaning ship."""
