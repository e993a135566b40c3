"""A formula with its numbers put in, so that a pocket calculator gets there."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from catopt.constants import STANDARD_GRAVITY
from catopt.loads.component import Number
from catopt.quantities import GREEK

__all__ = ["put_in", "typeset_formula", "typeset_unit"]

_POWERS = {"2": "²", "3": "³"}
_TIMES = "\N{NO-BREAK SPACE}· "
"""Does not begin a line."""
_NAMES = re.compile(r"(?<![A-Za-z])(theta0|theta1|theta|mu|rho)(?![A-Za-z])")


def put_in(formula: str, numbers: Iterable[Number]) -> str:
    """Put numbers into a product: ``"1/2 rho V^2 A Cd"`` becomes ``"1/2 · 1025 · 3.5² · 2 · 1.2"``.

    Nine digits are written.

    Parameters
    ----------
    formula : str
        Numbers, symbols and their powers with blanks between them; g is gravity.
    numbers : iterable of Number
        Of its symbols, which may have a blank themselves.

    Returns
    -------
    str
        Empty where the formula has more in it than that.
    """
    values = {"g": STANDARD_GRAVITY} | {each.symbol: each.value for each in numbers}
    factors = []
    for factor, power in _factors(formula, values):
        if factor in values:
            factors.append(_written(values[factor]) + _POWERS.get(power, ""))
        elif re.fullmatch(r"[\d.]+(/[\d.]+)?", factor) and not power:
            factors.append(factor)
        else:
            return ""
    return _TIMES.join(factors)


def _factors(formula: str, values: Mapping[str, float]) -> Iterable[tuple[str, str]]:
    """Split a product into its factors, each with its power; the longest symbol goes first."""
    symbols = "|".join(re.escape(each) for each in sorted(values, key=len, reverse=True))
    found = re.compile(rf"\s*({symbols}|\S+?)(?:\^(\d))?(?=\s|$)")
    return [(each[1], each[2] or "") for each in found.finditer(formula)]


def _written(value: float) -> str:
    return f"{value:.9g}" if value >= 0.0 else f"({value:.9g})"


def typeset_formula(formula: str) -> str:
    """Write Greek letters and powers as such: ``"1/2 ρ V² A Cd"``."""
    greek = _NAMES.sub(lambda found: GREEK[found[1]], formula)
    return re.sub(r"\^([23])", lambda found: _POWERS[found[1]], greek)


def typeset_unit(unit: str) -> str:
    """Write the powers of a unit as such: ``"kg/m³"``."""
    return re.sub(r"(?<=m)\^?([23])\b", lambda found: _POWERS[found[1]], unit)
