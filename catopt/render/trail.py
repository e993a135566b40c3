"""A step of a calculation by hand, in symbols and with its numbers put in."""

from __future__ import annotations

from collections.abc import Sequence

from catopt.answers.blocks import Step, exact

__all__ = ["digits", "in_numbers", "in_symbols"]

_MOST = 12
"""Terms of a sum that are all written out; of more, its first two and its last are."""


class _Symbol(str):
    """A symbol, however its number is written."""

    __slots__ = ()

    def __format__(self, spec: str) -> str:
        return str(self)


class _Number(float):
    """A number as it is put in: ``()`` in brackets where it is negative, ``°`` with its sign."""

    def __format__(self, spec: str) -> str:
        shown = digits(0.0 + self)
        if spec == "()" and (self < 0.0 or "e" in shown):
            return f"({shown})"
        return f"{shown}°" if spec == "°" else shown


def digits(value: float) -> str:
    """Write a number with nine digits, enough to be put in again."""
    return exact("").format(value).replace("-", "−")


def in_symbols(step: Step) -> str:
    """Write the formula: ``"a = H / w"``."""
    formula = step.formula.format(**{symbol: _Symbol(symbol) for symbol in step.numbers})
    return " = ".join(each for each in (step.symbol, formula) if each)


def in_numbers(step: Step) -> str:
    """Put the numbers in: ``"4000 / 245"``; empty where there are none."""
    if step.terms:
        return _sum([" · ".join(map(digits, each)) for each in step.terms])
    numbers = {symbol: _Number(value) for symbol, value in step.numbers.items()}
    return step.formula.format(**numbers) if numbers else ""


def _sum(terms: Sequence[str]) -> str:
    shown = terms if len(terms) <= _MOST else (*terms[:2], "…", terms[-1])
    return " + ".join(shown).replace("+ −", "− ")
