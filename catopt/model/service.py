"""Service life and wear: what is left of a chain's or a wire's diameter at the end of it."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.errors import InputError, Problem
from catopt.model.validity import Findings
from catopt.model.wear import WEAR_TABLES, WearTable


@dataclass(frozen=True)
class Service:
    """How long the line is to last and how fast it wears.

    Attributes
    ----------
    life : float
        Service life, s.
    wear_rate : float
        Loss of nominal diameter by corrosion and wear together, m/s. A segment may have its own.
    wear_table : str or None
        Instead, a key of `WEAR_TABLES`, which has the rate by each segment's `wear_zone`.
    """

    life: float
    wear_rate: float = 0.0
    wear_table: str | None = None

    def __post_init__(self) -> None:
        found = Findings("Service", self)
        found.number("life", self.life, "s", at_least=0.0)
        found.number("wear_rate", self.wear_rate, "m/s", at_least=0.0)
        if self.wear_table is not None and self.wear_table not in WEAR_TABLES:
            found.add("wear_table", f'"{self.wear_table}"', "one of " + ", ".join(WEAR_TABLES))
        found.raise_if_any()

    @property
    def table(self) -> WearTable | None:
        """Rates by zone, where they are asked for."""
        return None if self.wear_table is None else WEAR_TABLES[self.wear_table]

    def diameter_loss(self, wear_rate: float | None = None, wear_zone: str | None = None) -> float:
        """Loss of nominal diameter over the service life, m.

        Parameters
        ----------
        wear_rate : float, optional
            A segment's own, m/s.
        wear_zone : str, optional
            Where a segment without a rate of its own hangs or lies, for the table.

        Raises
        ------
        InputError
            The table has no rate for that.
        """
        if wear_rate is None and self.table is not None:
            rates = self.table.rates
            if wear_zone is None or wear_zone not in rates:
                allowed = f"wear_table {self.wear_table} has {', '.join(rates)}; or give wear_rate"
                found = "" if wear_zone is None else f'"{wear_zone}"'
                raise InputError([Problem("wear_zone", found, allowed)], "Service")
            wear_rate = rates[wear_zone]
        return self.life * (self.wear_rate if wear_rate is None else wear_rate)
