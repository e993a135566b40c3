"""What a line has to keep: the limits and factors that a user or a code asks for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from catopt.model.kinds import Factor, Height, Length, SomeForce, Text, Uplift
from catopt.model.validity import Checked, Findings
from catopt.words import Message

"""Why a case of one line has no factor for one line out."""

Code = Annotated[str, Text(filled=True, example='"break/5"')]


@dataclass(frozen=True)
class Checks(Checked):
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

    def _check(self, found: Findings) -> None:
        found.check("safety_factor", "proof_load_factor", "safety_factor_line_out")
        found.check("max_anchor_uplift_angle", "max_anchor_uplift_force", "min_grounded_length")
        found.check("max_span", "max_offset", "motion_code")
        if None not in (self.max_span, self.max_offset):
            found.add(
                "max_offset",
                f"{self.max_offset:g} m",
                Message("refused_case.leave_out_beside_max_span"),
            )
