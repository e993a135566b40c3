"""Load cases: the same mooring at several water levels and under several forces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from catopt.model.validity import Findings

LoadCaseKind = Literal["extreme", "reference"]
LOAD_CASE_KINDS: tuple[str, ...] = get_args(LoadCaseKind)
LoadCaseState = Literal["intact", "one_line_out"]
LOAD_CASE_STATES: tuple[str, ...] = get_args(LoadCaseState)


@dataclass(frozen=True)
class LoadCase:
    """One state of the sea that the line has to meet.

    Attributes
    ----------
    name : str
        As tables show it; no two of a case are the same.
    horizontal_force : float
        At the fairlead, N.
    water_level : float
        Above the level that the site's water depth is given for, m; negative below it. The
        fairlead goes up and down with it.
    kind : {"extreme", "reference"}
        What the line has to withstand, or the everyday state that excursions start from. Codes
        that tell normal from extreme loads take their normal factors for the reference.
    state : {"intact", "one_line_out"}
        Of the mooring that the line is one of: with all its lines, or at rest anew without one.
        Codes have factors for each.
    fairlead_rise : float
        Of the fairlead above its place on the case's body, m: a ship at another draught.
    """

    name: str
    horizontal_force: float
    water_level: float = 0.0
    kind: LoadCaseKind = "extreme"
    state: LoadCaseState = "intact"
    fairlead_rise: float = 0.0

    @property
    def lift(self) -> float:
        """How much higher the fairlead is than in the case: by the water and by its rise, m."""
        return self.water_level + self.fairlead_rise

    def __post_init__(self) -> None:
        found = Findings("LoadCase", self)
        if not self.name.strip():
            found.add("name", repr(self.name), "a name is wanted")
        found.number("horizontal_force", self.horizontal_force, "N", above=0.0)
        found.number("water_level", self.water_level, "m")
        found.number("fairlead_rise", self.fairlead_rise, "m")
        found.word("kind", self.kind, LOAD_CASE_KINDS)
        found.word("state", self.state, LOAD_CASE_STATES)
        found.raise_if_any()
