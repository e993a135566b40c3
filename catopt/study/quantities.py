"""What is kept of each member of a study: names, words and units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Message


@dataclass(frozen=True)
class Kept:
    """A number or a text that is kept of each member.

    Attributes
    ----------
    name : str
        In a study file and in documents.
    quantity : str
        Key of its quantity; empty for a text.
    high_is_worse : bool
        Which end of it is the bad one.
    """

    name: str
    quantity: str = ""
    high_is_worse: bool = True

    @property
    def measure(self) -> Quantity:
        """Its quantity."""
        return QUANTITIES[self.quantity]

    @property
    def words(self) -> Message:
        """What it is called."""
        return Message(f"study.{self.name}")

    @property
    def heading(self) -> str:
        """Of its column in files: ``fairlead_tension (kN)``."""
        unit = self.measure.field_unit if self.quantity else "-"
        return self.name if unit == "-" else f"{self.name} ({unit})"


_ENDS = (
    Kept("fairlead_tension", "tension"),
    Kept("anchor_tension", "tension"),
    Kept("anchor_uplift", "vertical_force"),
    Kept("grounded_length", "grounded_length", high_is_worse=False),
)
_USED = Kept("utilisation", "utilisation")
_GOVERNING = Kept("governing")

OF_LINE: Final = (*_ENDS, Kept("span", "span"))
OF_SYSTEM: Final = (*_ENDS, Kept("offset", "offset"))
"""At rest, of a line or over all lines of a body: the largest tensions and uplift of any line, the
least grounded length."""

OF_CHECKS: Final = (_USED, Kept("failing", "failing"), _GOVERNING)

OF_MOTION: Final = (
    Kept("fairlead_tension", "tension"),
    Kept("fairlead_mean", "tension"),
    Kept("fairlead_deviation", "tension"),
    Kept("anchor_tension", "tension"),
    Kept("offset", "offset"),
    Kept("grounded_length", "grounded_length", high_is_worse=False),
    _USED,
    Kept("change", "utilisation"),
    Kept("verdict"),
)
"""In motion, over the whole run and all lines: `change` is the largest part by which a maximum
hangs on the step, as far as that was looked for."""

OF_LINEAR: Final = (
    Kept("fairlead_probable", "tension"),
    Kept("fairlead_mean", "tension"),
    Kept("fairlead_deviation", "tension"),
    Kept("zero_crossing_period", "zero_crossing_period"),
    Kept("reserve", "reserve", high_is_worse=False),
    Kept("taut"),
)
"""By linear motion, at the fairlead with the largest `fairlead_probable`; `reserve` is the least of
any line."""

OF_SIZING: Final = (
    Kept("line"),
    Kept("holding"),
    Kept("mass", "mass"),
    Kept("line_length", "length"),
    Kept("swing_radius", "span"),
    Kept("holding_mass", "mass"),
    _USED,
    _GOVERNING,
)

KEPT: Final[Mapping[str, tuple[Kept, ...]]] = MappingProxyType(
    {
        "line": OF_LINE,
        "system": OF_SYSTEM,
        "checks": OF_CHECKS,
        "motion": OF_MOTION,
        "linear": OF_LINEAR,
        "sizing": OF_SIZING,
    }
)
"""What is kept, by what is computed; at rest by what is moored."""
