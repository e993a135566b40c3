"""A value that is said with its unit."""

from __future__ import annotations

from dataclasses import dataclass, replace

from catopt.quantities import QUANTITIES, Quantity, Units

_LARGE = 1e6
"""From here on numbers have an exponent."""


def number(value: float, spec: str) -> str:
    """Write a number by a format; of significant digits without an exponent for what is large.

    Examples
    --------
    >>> number(1000.0, ".3g"), number(123456.0, ".3g"), number(2.5e6, ".3g"), number(-1e-9, ".3f")
    ('1000', '123000', '2.5e+06', '0.000')
    """
    text = format(value, spec)
    if text.startswith("-") and not text.strip("-0."):  # rounded to zero, which has no sign
        return text[1:]
    return (
        f"{float(text):.0f}" if "e+" in text and spec[-1:] == "g" and abs(value) < _LARGE else text
    )


@dataclass(frozen=True)
class Measure:
    """A value of a quantity, said in the field's unit: ``7300 kN``.

    Examples
    --------
    >>> from catopt.words import Measure
    >>> f"{Measure('tension', 7.3e6):.4g}"
    '7300 kN'
    """

    quantity: str  # key of `catopt.quantities.QUANTITIES`
    value: float  # SI
    units: Units = ""  # in which it is said, in place of the field's
    digits: int | None = None  # behind the decimal point there, in place of the quantity's own

    def __format__(self, spec: str) -> str:
        """Say the value with its unit, by the format of a number; ``bare`` is without the unit."""
        own = QUANTITIES[self.quantity]
        if self.digits is not None:
            own = replace(own, digits=self.digits)
        quantity = own.in_units(self.units)
        if spec in {"", "bare"}:
            return quantity.format(self.value, unit=not spec)
        return f"{number(quantity.to_field(self.value), spec)} {quantity.field_unit}"

    def __str__(self) -> str:
        return f"{self}"


@dataclass(frozen=True)
class Unit:
    """The unit of a quantity, said where its values stand without: ``kN``."""

    quantity: Quantity

    def __str__(self) -> str:
        return self.quantity.field_unit
