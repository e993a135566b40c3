"""What a line has to keep: the limits and factors that a user or a code asks for."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.model.validity import Findings

__all__ = ["Checks"]


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
    max_offset : float or None
        Largest span, m; None when not checked.
    allow_recalled : bool
        Whether criteria that were read in no document (confidence R) may be used.
    """

    safety_factor: float = 1.0
    max_anchor_uplift_angle: float | None = None
    codes: tuple[str, ...] = ()
    proof_load_factor: float | None = None
    max_anchor_uplift_force: float | None = None
    min_grounded_length: float | None = None
    max_offset: float | None = None
    allow_recalled: bool = False

    def __post_init__(self) -> None:
        found = Findings("Checks")
        found.number("safety_factor", self.safety_factor, "", at_least=1.0)
        if self.max_anchor_uplift_angle is not None:
            found.number(
                "max_anchor_uplift_angle",
                self.max_anchor_uplift_angle,
                "rad",
                at_least=0.0,
                at_most=math.pi / 2.0,
            )
        if self.proof_load_factor is not None:
            found.number("proof_load_factor", self.proof_load_factor, "", at_least=1.0)
        if self.max_anchor_uplift_force is not None:
            found.number("max_anchor_uplift_force", self.max_anchor_uplift_force, "N", at_least=0.0)
        if self.min_grounded_length is not None:
            found.number("min_grounded_length", self.min_grounded_length, "m", at_least=0.0)
        if self.max_offset is not None:
            found.number("max_offset", self.max_offset, "m", above=0.0)
        found.raise_if_any()
