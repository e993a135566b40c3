"""The place, what pulls on the line there, and what it has to keep."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal, Self

from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import refused
from catopt.model.kinds import (
    Checked,
    Density,
    Factor,
    Findings,
    Given,
    Height,
    Length,
    Measured,
    NotNegative,
    Place,
    SomeForce,
    Strength,
    Text,
    Uplift,
)
from catopt.model.plausible_ranges import Plausible
from catopt.model.wear import Condition
from catopt.units import Dimension
from catopt.words import Message, given_keys, term

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
            found.add("load", given_keys(self.given), Message("refused.one_load"))
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


STEEPEST = math.radians(45.0)
"""Slope of a bed, either way, rad."""
HIGHEST = 1.0
"""Contact offset, m: of a chain whose bar has 0.6 m."""
Slope = Annotated[
    float, Measured(Dimension.ANGLE, at_least=-STEEPEST, at_most=STEEPEST, example='"3 deg"')
]
Offset = Annotated[
    float, Measured(Dimension.LENGTH, at_least=0.0, at_most=HIGHEST, example='"0.164 m"')
]


@dataclass(frozen=True)
class Site(Plausible):
    """Water and seabed at the mooring; `Site.in_air()` of a line without either."""

    water_depth: Length
    """From the still water to the seabed, m; with a contact offset to what the line lies on.
    Infinite of a line in air, which nothing floats or lies under."""
    seabed_friction: NotNegative = 0.0
    """Coulomb coefficient of what lies on the bed, along the line."""
    water_density: Density = SEA_WATER_DENSITY
    """kg/m3."""
    seabed_slope: Slope = 0.0
    """Angle by which the bed, a plane, rises from the anchor towards the fairlead, rad. Depth and
    heights are then those above the bed at the anchor, x = 0."""
    contact_offset: Offset = 0.0
    """Height of the axis of a line that lies above the seabed, m: a contact radius, less what it
    sinks in. Depth and heights of a case are less by it: they count from there."""

    if TYPE_CHECKING:  # numbers in SI or text with a unit; what is kept are numbers

        def __init__(
            self,
            water_depth: Given,
            seabed_friction: Given = 0.0,
            water_density: Given = SEA_WATER_DENSITY,
            seabed_slope: Given = 0.0,
            contact_offset: Given = 0.0,
            *,
            accept: Sequence[str] = (),
        ) -> None: ...

    def _check(self, found: Findings) -> None:
        if self.is_in_air:
            return
        found.check()
        if self.seabed_slope and self.contact_offset:
            allowed = Message("refused_case.level_only")
            found.add("contact_offset", f"{self.contact_offset:g} m", allowed)

    @classmethod
    def in_air(cls) -> Self:
        """Return the site of a line without water and bed; heights count from any level."""
        return cls(math.inf, water_density=0.0)

    @property
    def is_in_air(self) -> bool:
        """Whether there is neither water nor bed."""
        return self.water_depth == math.inf and self.water_density == 0.0

    def check_water(self) -> None:
        """Raise InputError for a line in air, for what takes water and bed."""
        if self.is_in_air:
            raise refused("site", "", Message("refused_case.wants_water_and_bed"))

    @property
    def depth_to_seabed(self) -> float:
        """From the still water surface to the seabed itself, m."""
        return self.water_depth + self.contact_offset

    def height_above_seabed(self, height: float) -> float:
        """Return a height of the case above the seabed itself, m; an end on the bed stays at 0."""
        return height + self.contact_offset if height > 0.0 else 0.0

    def check_level(self) -> None:
        """Raise InputError where the bed slopes, for what takes it to be level."""
        if self.seabed_slope != 0.0:
            allowed = Message("refused_case.level_bed_unless")
            found = f"{math.degrees(self.seabed_slope):g} deg"
            raise refused("site.seabed_slope", found, allowed)


Code = Annotated[str, Text(filled=True, example='"break/5"')]


@dataclass(frozen=True)
class Checks(Plausible):
    """Limits a design has to keep; None: not checked."""

    safety_factor: Factor = 1.0
    """Tension times this factor may reach the MBL. 1 when none is asked for."""
    max_anchor_uplift_angle: Uplift | None = None
    """Largest inclination of the line at the anchor, rad."""
    codes: tuple[Code, ...] = ()
    """Names of the profiles of criteria that the line is checked by (`catopt.checks.profiles`)."""
    proof_load_factor: Factor | None = None
    """Tension times this factor may reach the proof load."""
    max_anchor_uplift_force: SomeForce | None = None
    """Largest vertical pull at the anchor, N."""
    min_grounded_length: Height | None = None
    """Least length of line that stays on the bed, m, unstretched."""
    max_offset: Length | None = None
    """`max_span` under its old name; one of the two."""
    allow_recalled: bool = False
    """Whether criteria that were read in no document (confidence R) may be used."""
    max_span: Length | None = None
    """Largest horizontal distance from the anchor to the fairlead, m."""
    motion_code: Code | None = None
    """Profile with factors for dynamic analysis that judges lines in motion in the place of those
    of `codes` that have none; None: these do, by their factors for lines at rest."""
    safety_factor_line_out: Factor | None = None
    """In the place of `safety_factor` where one line of several is gone; None: the same."""
    min_tension: SomeForce | None = None
    """Least tension of every line at its fairlead, N: that of the leeward lines of several."""

    def _check(self, found: Findings) -> None:
        found.check("safety_factor", "proof_load_factor", "safety_factor_line_out", "min_tension")
        found.check("max_anchor_uplift_angle", "max_anchor_uplift_force", "min_grounded_length")
        found.check("max_span", "max_offset", "motion_code")
        if None not in (self.max_span, self.max_offset):
            allowed = Message("refused_case.leave_out_beside_max_span")
            found.add("max_offset", f"{self.max_offset:g} m", allowed)
