"""What pulls on the line: one of three known quantities.

Load cases: the same mooring at several water levels and under several forces.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from catopt.model.kinds import Given, Height, Place, Strength, Text
from catopt.model.validity import Checked, Findings
from catopt.model.wear import Condition
from catopt.words import Message, term

LOADS = ("horizontal_force", "span", "fairlead_tension")
"""The quantities of which one is known."""


@dataclass(frozen=True)
class Load(Checked):
    """The one known quantity at the fairlead; the others follow from it."""

    horizontal_force: Strength | None = None
    """N."""
    span: Height | None = None
    """Horizontal distance from the anchor to the fairlead, m; 0 for a plumb line."""
    fairlead_tension: Strength | None = None
    """Effective tension at the fairlead, N."""

    if TYPE_CHECKING:  # numbers in SI or text with a unit; what is kept are numbers

        def __init__(
            self,
            horizontal_force: Given | None = None,
            span: Given | None = None,
            fairlead_tension: Given | None = None,
        ) -> None: ...

    def _check(self, found: Findings) -> None:
        if len(self.given) != 1:
            allowed = Message("refused.one_load")
            found.add(
                "load", " and ".join(self.given) or Message("refused_file.none_of_them"), allowed
            )
            found.raise_if_any()
        found.check()

    @property
    def given(self) -> tuple[str, ...]:
        """Name of the known quantity; one, for a sound load has no more."""
        return tuple(key for key in LOADS if getattr(self, key) is not None)


LoadCaseKind = Literal["extreme", "reference"]
LoadCaseState = Literal["intact", "one_line_out"]


@dataclass(frozen=True)
class LoadCase(Checked):
    """One state of the sea that the line has to meet."""

    name: Annotated[str, Text(filled=True, example='"storm"')]
    """As tables show it; no two of a case are the same."""
    horizontal_force: Strength
    """At the fairlead, N."""
    water_level: Place = 0.0
    """Above the level that the site's water depth is given for, m; negative below it. The fairlead
    goes up and down with it."""
    kind: LoadCaseKind = "extreme"
    """What the line has to withstand, or the everyday state that excursions start from. Codes that
    tell normal from extreme loads take their normal factors for the reference."""
    state: LoadCaseState = "intact"
    """Of the mooring that the line is one of: with all its lines, or at rest anew without one.
    Codes have factors for each."""
    fairlead_rise: Place = 0.0
    """Of the fairlead above its place on the case's body, m: a ship at another draught."""

    condition: Condition | None = None
    """Of the line, for a case with a service life: new in weight and strength, or worn in both.
    Left out: the weight of the new line with the strength of the worn one."""

    @property
    def lift(self) -> float:
        """How much higher the fairlead is than in the case: by the water and by its rise, m."""
        return self.water_level + self.fairlead_rise

    def _check(self, found: Findings) -> None:
        if not self.name.strip():
            found.add("name", repr(self.name), Message("refused_case.name_wanted"))
        object.__setattr__(self, "name", term(self.name))  # templates' names are shown translated
        found.check("horizontal_force", "water_level", "fairlead_rise")
        found.check("kind", "state", "condition")
