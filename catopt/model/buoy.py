"""The floating body that the line pulls down on."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.model.validity import Findings


@dataclass(frozen=True)
class Buoy:
    """A buoy, as far as the line minds it.

    Attributes
    ----------
    reserve_buoyancy : float
        Vertical pull that takes it to its allowed draught, N.
    """

    reserve_buoyancy: float

    def __post_init__(self) -> None:
        found = Findings("Buoy", self)
        found.number("reserve_buoyancy", self.reserve_buoyancy, "N", above=0.0)
        found.raise_if_any()
