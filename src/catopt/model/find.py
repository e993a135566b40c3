"""The question turned round: what is sought instead of how the line hangs."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, get_args

from catopt.model.validity import Findings

__all__ = ["FIND_QUANTITIES", "Find"]

FindQuantity = Literal["length", "clump_weight", "touchdown_force", "limit_force"]
FIND_QUANTITIES: tuple[str, ...] = get_args(FindQuantity)


@dataclass(frozen=True)
class Find:
    """What is sought, and the condition that it has to meet.

    Attributes
    ----------
    quantity : str
        ``"length"`` of a segment or ``"clump_weight"`` of a point load under the case's load;
        ``"touchdown_force"``, the horizontal force at which the touchdown reaches the anchor;
        ``"limit_force"``, the one at which a segment reaches MBL over the safety factor.
    segment, point_load : int
        Which one, counted from 1 at the anchor; 0 is the last segment, the one at the fairlead.
    anchor_angle : float or None
        For length and clump weight: inclination at the anchor, rad.
    grounded_length : float or None
        For length, instead of the angle: unstretched length on the bed, m.
    """

    quantity: FindQuantity
    segment: int = 0
    point_load: int = 1
    anchor_angle: float | None = None
    grounded_length: float | None = None

    def __post_init__(self) -> None:
        found = Findings("Find")
        if self.quantity not in FIND_QUANTITIES:
            found.add("quantity", repr(self.quantity), "one of " + ", ".join(FIND_QUANTITIES))
        found.number("segment", self.segment, "", at_least=0)
        found.number("point_load", self.point_load, "", at_least=1)
        if self.anchor_angle is not None:
            found.number(
                "anchor_angle", self.anchor_angle, "rad", at_least=0.0, at_most=0.49 * math.pi
            )
        if self.grounded_length is not None:
            found.number("grounded_length", self.grounded_length, "m", above=0.0)
        self._check_condition(found)
        found.raise_if_any()

    def _check_condition(self, found: Findings) -> None:
        given = [k for k in ("anchor_angle", "grounded_length") if getattr(self, k) is not None]
        if self.quantity == "length" and len(given) != 1:
            found.add(
                "condition",
                " and ".join(given) or "none",
                "exactly one of anchor_angle and grounded_length is wanted",
            )
        elif self.quantity == "clump_weight" and given != ["anchor_angle"]:
            found.add("condition", " and ".join(given) or "none", "anchor_angle is wanted")
        elif self.takes_no_condition and given:
            found.add("condition", " and ".join(given), f"{self.quantity} takes none")

    @property
    def takes_no_condition(self) -> bool:
        """Whether the quantity itself says its condition, and a load is not given either."""
        return self.quantity in ("touchdown_force", "limit_force")
