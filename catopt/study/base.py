"""What all members of a study have in common, and what is kept of each: names, words, units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Final, Literal

from catopt.arrays import Array, Flags
from catopt.casefile.sizing_file import Moored
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Message

Computed = Literal["statics", "checks", "motion", "linear", "sizing"]
"""What a study may compute of each of its members."""

Proof = Literal["step", "none"]
"""How a run in time is proven, as of ``catopt verify --dynamic``."""


@dataclass(frozen=True)
class Kept:
    """A number or a text that is kept of each member.

    `name`: in a study file and in documents; `quantity`: key of its quantity; empty for a text;
    `high_is_worse`: which end of it is the bad one.
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

    def beyond(self, values: Array, limit: float) -> Flags:
        """Which values are beyond a limit, on its bad side."""
        return values > limit if self.high_is_worse else values < limit

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
_SPREAD = (Kept("fairlead_mean", "tension"), Kept("fairlead_deviation", "tension"))
_USED = Kept("utilisation", "utilisation")
_GOVERNING = Kept("governing")

KEPT: Final[Mapping[str, tuple[Kept, ...]]] = MappingProxyType(
    {
        "line": (*_ENDS, Kept("span", "span")),
        "system": (*_ENDS, Kept("offset", "offset")),
        "checks": (_USED, Kept("failing", "failing"), _GOVERNING),
        "motion": (
            Kept("fairlead_tension", "tension"),
            *_SPREAD,
            Kept("anchor_tension", "tension"),
            Kept("offset", "offset"),
            Kept("grounded_length", "grounded_length", high_is_worse=False),
            _USED,
            Kept("change", "utilisation"),
            Kept("verdict"),
        ),
        "linear": (
            Kept("fairlead_probable", "tension"),
            *_SPREAD,
            Kept("zero_crossing_period", "zero_crossing_period"),
            Kept("reserve", "reserve", high_is_worse=False),
            Kept("taut"),
        ),
        "sizing": (
            Kept("line"),
            Kept("holding"),
            Kept("mass", "mass"),
            Kept("line_length", "length"),
            Kept("swing_radius", "span"),
            Kept("holding_mass", "mass"),
            _USED,
            _GOVERNING,
        ),
    }
)
"""What is kept, by what is computed; at rest by what is moored.

At rest, of a line or over all lines of a body: the largest tensions and uplift of any line, the
least grounded length. In motion, over the whole run and all lines: `change` is the largest part by
which a maximum hangs on the step, as far as that was looked for. By linear motion, at the fairlead
with the largest `fairlead_probable`; `reserve` is the least of any line.
"""


@dataclass(frozen=True)
class Base:
    """What all members have in common.

    `document`: of the case file, or of the file for ``catopt size``, as the TOML reader returns it;
    `source`, `folder`: its name, for messages, and where paths in it count from; `moored`: of what
    the file is for ``catopt size``; None for a case file; `proof`: of a run in time.
    """

    document: dict[str, Any]
    source: str
    folder: str
    compute: Computed
    moored: Moored | None = None
    proof: Proof = "step"

    @property
    def kept(self) -> tuple[Kept, ...]:
        """What is kept of each member."""
        at_rest = "system" if "system" in self.document else "line"
        return KEPT[at_rest if self.compute == "statics" else self.compute]
