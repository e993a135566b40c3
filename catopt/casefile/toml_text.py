"""Writes single lines of TOML: a key with its value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catopt.documents import unfit
from catopt.errors import InputError, Problem
from catopt.units import UNITS, Dimension

__all__ = ["flag", "measured", "measures", "text", "texts", "whole"]

_ESCAPES = {
    '"': '\\"',
    "\\": "\\\\",
    "\t": "\\t",
    "\n": "\\n",
}

_WIDTH = 100


def measured(key: str, value: float | None, unit: str = "") -> Iterator[str]:
    """Write a number with its unit; nothing for None."""
    if value is not None:
        yield f"{key} = {_number(value, unit)}"


def wear(key: str, rate: float | None) -> Iterator[str]:
    """Write a rate of wear (m/s) in mm a year, where that reads back as the same number."""
    if rate is None:
        return
    unit = UNITS[Dimension.SPEED]["mm/year"]
    per_year = float(f"{rate / unit:.15g}")
    if per_year * unit == rate:
        yield f"{key} = {_number(per_year, 'mm/year')}"
    else:
        yield from measured(key, rate, "m/s")


def measures(key: str, values: Sequence[float], unit: str) -> Iterator[str]:
    """Write an array of numbers with their unit; nothing when it is empty."""
    if values:
        yield _array(key, [_number(value, unit) for value in values])


def whole(key: str, value: int | None) -> Iterator[str]:
    """Write a whole number; nothing for None."""
    if value is not None:
        yield f"{key} = {int(value)}"


def flag(key: str, value: bool) -> Iterator[str]:
    """Write what is true; nothing for what is not, which is every flag's default."""
    if value:
        yield f"{key} = true"


def text(key: str, value: str, *, empty: bool = False) -> Iterator[str]:
    """Write a text; nothing when it is empty, unless that is to be said."""
    if value or empty:
        yield f"{key} = {_quoted(value)}"


def texts(key: str, values: Sequence[str]) -> Iterator[str]:
    """Write an array of texts; nothing when it is empty."""
    if values:
        yield _array(key, [_quoted(value) for value in values])


def _number(value: float, unit: str) -> str:
    digits = repr(float(value))  # the shortest text that reads back as the same number
    return f'"{digits} {unit}"' if unit else digits


def _array(key: str, values: Sequence[str]) -> str:
    """Write an array on one line, or on as many as it needs."""
    line = f"{key} = [{', '.join(values)}]"
    if len(line) <= _WIDTH:
        return line
    lines, row = [f"{key} = ["], ""
    for value in values:
        if row and len(f"  {row}{value},") > _WIDTH:
            lines.append(f"  {row.rstrip()}")
            row = ""
        row += f"{value}, "
    return "\n".join([*lines, f"  {row.rstrip()}", "]"])


def _quoted(value: str) -> str:
    if unfit(value):
        raise InputError([Problem("text", unfit(value), f"take it out of {value[:40]!r}")])
    return f'"{"".join(_ESCAPES.get(character, character) for character in value)}"'
