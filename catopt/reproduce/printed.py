"""A number as it stands in print: its digits say how exactly it is known."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal


@dataclass(frozen=True)
class Printed:
    """A printed number.

    `text`: as printed, such as ``"17.430"``; the closing zero is a claim.
    """

    text: str

    @property
    def value(self) -> float:
        """The number."""
        return float(self.text)

    @property
    def decimals(self) -> int:
        """Digits after the point; of ``3.55e-15`` they are 17."""
        exponent = Decimal(self.text).as_tuple().exponent
        assert isinstance(exponent, int), f"{self.text} is not a finite number"
        return -exponent

    @property
    def digits(self) -> int:
        """Significant digits: 5 in ``17.430``. A printed zero counts its decimals."""
        number = Decimal(self.text)
        return len(number.as_tuple().digits) if number else self.decimals

    def rounding(self, value: float, *, further: int = 0) -> str:
        """Write a value to the decimals of this print."""
        return f"{value:.{self.decimals + further}f}"

    @property
    def bounds(self) -> tuple[float, float]:
        """The least and the largest value that prints so."""
        half = Decimal(5).scaleb(-self.decimals - 1)
        number = Decimal(self.text)
        return float(number - half), float(number + half)
