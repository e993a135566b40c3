"""What a line has to keep: the limits and factors that a user or a code asks for."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.model.validity import Findings

NEEDS_SEVERAL_LINES = "leave it out, or give [system]: of one line none can be lost"
"""Why a case of one line has no factor for one line out."""


@dataclass(frozen=True)
class Checks:
    """Limits a design has to keep.

    Attributes
    ----------
    safety_factor : float
        Tension times this factor may reach the MBL. 1 when none is asked for.
    max_anchor_uplift_angle : float or None
        Largest inclination of the line at the anchor, rad; None when not checked.
    codes : tuple of str
        Names of the profiles of criteria that the line is checked by (`catopt.checks.profiles`).
    proof_load_factor : float or None
        Tension times this factor may reach the proof load; None when not checked.
    max_anchor_uplift_force : float or None
        Largest vertical pull at the anchor, N; None when not checked.
    min_grounded_length : float or None
        Least length of line that stays on the bed, m, unstretched; None when not checked.
    max_span : float or None
        Largest horizontal distance from the anchor to the fairlead, m; None when not checked.
    max_offset : float or None
        The same under its old name; one of the two.
    allow_recalled : bool
        Whether criteria that were read in no document (confidence R) may be used.
    safety_factor_line_out : float or None
        In the place of `safety_factor` where one line of several is gone; None: the same.
    """

    safety_factor: float = 1.0
    max_anchor_uplift_angle: float | None = None
    codes: tuple[str, ...] = ()
    proof_load_factor: float | None = None
    max_anchor_uplift_force: float | None = None
    min_grounded_length: float | None = None
    max_offset: float | None = None
    allow_recalled: bool = False
    max_span: float | None = None
    safety_factor_line_out: float | None = None

    def __post_init__(self) -> None:
        found = Findings("Checks", self)
        found.number("safety_factor", self.safety_factor, "", at_least=1.0)
        found.numbers(self, "", "proof_load_factor", "safety_factor_line_out", at_least=1.0)
        steepest = math.pi / 2.0
        found.numbers(self, "rad", "max_anchor_uplift_angle", at_least=0.0, at_most=steepest)
        found.numbers(self, "N", "max_anchor_uplift_force", at_least=0.0)
        found.numbers(self, "m", "min_grounded_length", at_least=0.0)
        found.numbers(self, "m", "max_span", "max_offset", above=0.0)
        if None not in (self.max_span, self.max_offset):
            found.add("max_offset", f"{self.max_offset:g} m", "leave it out beside max_span")
        found.raise_if_any()
