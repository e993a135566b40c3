"""Service life and wear: what is left of a chain's or a wire's diameter at the end of it."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.constants import YEAR
from catopt.model.validity import Findings

__all__ = ["YEAR", "Service"]


@dataclass(frozen=True)
class Service:
    """How long the line is to last and how fast it wears.

    Attributes
    ----------
    life : float
        Service life, s.
    wear_rate : float
        Loss of nominal diameter by corrosion and wear together, m/s. A segment may have its own.
    """

    life: float
    wear_rate: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("Service")
        found.number("life", self.life, "s", at_least=0.0)
        found.number("wear_rate", self.wear_rate, "m/s", at_least=0.0)
        found.raise_if_any()

    def diameter_loss(self, wear_rate: float | None = None) -> float:
        """Loss of nominal diameter over the service life, m.

        Parameters
        ----------
        wear_rate : float, optional
            A segment's own, m/s.
        """
        return self.life * (self.wear_rate if wear_rate is None else wear_rate)
