"""A value that is said with its unit."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.quantities import QUANTITIES

__all__ = ["Measure"]


@dataclass(frozen=True)
class Measure:
    """A value of a quantity, said in the field's unit: ``7300 kN``.

    Attributes
    ----------
    quantity : str
        Key of `catopt.quantities.QUANTITIES`.
    value : float
        SI.

    Examples
    --------
    >>> from catopt.words import Measure
    >>> f"{Measure('tension', 7.3e6):.4g}"
    '7300 kN'
    """

    quantity: str
    value: float

    def __format__(self, spec: str) -> str:
        """Say the value in the field's unit, by the format of a number."""
        quantity = QUANTITIES[self.quantity]
        if not spec:
            return quantity.format(self.value, unit=True)
        return f"{quantity.to_field(self.value):{spec}} {quantity.field_unit}"

    def __str__(self) -> str:
        return f"{self}"
