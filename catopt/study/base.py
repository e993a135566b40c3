"""What all members of a study have in common, and what is kept of each: names, words, units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Final, Literal

from catopt.arrays import Array, Flags
from catopt.casefile.reading import Moored, is_network
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Message

Computed = Literal["statics", "checks", "motion", "linear", "sizing", "design"]
"""What a study may compute of each of its members."""

ConvergenceCheck = Literal["step", "none"]
"""How a run in time is proven, as of ``catopt verify --dynamic``."""


@dataclass(frozen=True)
class Output:
    """A number or a text that is kept of each member.

    `quantity`: key of its quantity; empty for a text; `high_is_worse`: which end of it is the bad
    one.
    """

    name: str
    """Of the quantity, or of the text, as study files have it."""
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
    Output("fairlead_tension", "tension"),
    Output("anchor_tension", "tension"),
    Output("anchor_uplift", "vertical_force"),
    Output("grounded_length", "grounded_length", high_is_worse=False),
)
_SPREAD = (Output("fairlead_mean", "tension"), Output("fairlead_deviation", "tension"))
_USED = Output("utilisation", "utilisation")
_GOVERNING = Output("governing")

KEPT: Final[Mapping[str, tuple[Output, ...]]] = MappingProxyType(
    {
        "line": (*_ENDS, Output("span", "span")),
        "system": (*_ENDS, Output("offset", "offset")),
        "points": (*_ENDS, Output("offset", "offset")),
        "checks": (_USED, Output("failing", "failing"), _GOVERNING),
        "motion": (
            Output("fairlead_tension", "tension"),
            *_SPREAD,
            Output("anchor_tension", "tension"),
            Output("offset", "offset"),
            Output("grounded_length", "grounded_length", high_is_worse=False),
            _USED,
            Output("change", "utilisation"),
            Output("verdict"),
        ),
        "linear": (
            Output("fairlead_probable", "tension"),
            *_SPREAD,
            Output("zero_crossing_period", "zero_crossing_period"),
            Output("reserve", "reserve", high_is_worse=False),
            Output("taut"),
        ),
        "sizing": (
            Output("line"),
            Output("holding"),
            Output("mass", "mass"),
            Output("line_length", "length"),
            Output("swing_radius", "span"),
            Output("holding_mass", "mass"),
            _USED,
            _GOVERNING,
        ),
        "design": (),  # of which the front is one answer for all members
    }
)
"""What is kept, by what is computed; at rest by what is moored.

At rest, of a line or over all lines: the largest tensions and uplift of any line, the
least grounded length. In motion, over the whole run and all lines: `change` is the largest part by
which a maximum hangs on the step, as far as that was looked for. By linear motion, at the fairlead
with the largest `fairlead_probable`; `reserve` is the least of any line.
"""


@dataclass(frozen=True)
class Base:
    """What all members have in common.

    `document`: of the case file, or of the file for ``catopt size``, as the TOML reader returns it;
    `source`, `folder`: its name, for messages, and where paths in it count from; `moored`: of what
    the file is for ``catopt size``; None for a case file; `convergence_check`: of a run in
    time.
    """

    document: dict[str, Any]
    source: str
    folder: str
    compute: Computed
    """What was computed of each member."""
    moored: Moored | None = None
    convergence_check: ConvergenceCheck = "step"

    @property
    def kept(self) -> tuple[Output, ...]:
        """What is kept of each member."""
        if self.compute != "statics":
            return KEPT[self.compute]
        if self.is_network:
            return KEPT["points"] if "bodies" in self.document else _ENDS
        return KEPT["system" if "system" in self.document else "line"]

    @property
    def is_network(self) -> bool:
        """Whether the file is of points and lines."""
        return self.moored is None and is_network(self.document)

    @property
    def in_bulk(self) -> bool:
        """Whether members are solved many at a time: of points, those without joints, on a body."""
        if self.compute != "statics" or not self.is_network:
            return self.compute == "statics"
        kinds = [point.get("kind") for point in self.document["points"]]
        return "joint" not in kinds and len(self.document.get("bodies", ())) == 1
