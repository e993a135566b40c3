"""A step of a calculation by hand, in symbols and with its numbers put in."""

from __future__ import annotations

from dataclasses import replace

from catopt.answers.blocks import Step, exact
from catopt.quantities import GREEK

_MOST = 12
"""Terms of a sum that are all written out; of more, its first two and its last are."""
_POWERS = {"2": "²", "3": "³"}
_TIMES = "\N{NO-BREAK SPACE}· "
"""Does not begin a line."""


class _Symbol(str):
    """A symbol, Greek letters as such; of how its number is written its power counts alone."""

    __slots__ = ()

    def __format__(self, spec: str) -> str:
        return GREEK.get(self, str(self)) + _POWERS.get(spec, "")


class _Number(float):
    """A number as it is put in; one that is multiplied has brackets where it is negative."""

    digits = 9
    is_factor = False

    def __format__(self, spec: str) -> str:
        if self.is_factor:
            spec = spec or "()"
        shown = _digits(0.0 + self, self.digits)
        if (spec == "()" or spec in _POWERS) and (self < 0.0 or "e" in shown):
            shown = f"({shown})"
        return shown + ("°" if spec == "°" else _POWERS.get(spec, ""))


def put_in(step: Step) -> str:
    """Write the formula, and below it the same with its numbers; empty where there is neither."""
    return "\n= ".join(each for each in (in_symbols(step), in_numbers(step)) if each)


def in_symbols(step: Step) -> str:
    """Write the formula: ``"a = H / w"``."""
    formula = step.formula if isinstance(step.formula, str) else " ".join(step.formula)
    said = formula.format(**{symbol: _Symbol(symbol) for symbol in step.numbers})
    return " = ".join(each for each in (step.symbol, said) if each)


def in_numbers(step: Step) -> str:
    """Put the numbers in: ``"4000 / 245"``; empty where there are none."""
    if step.terms:
        terms = [" · ".join(_digits(each, step.digits) for each in of) for of in step.terms]
        shown = terms if len(terms) <= _MOST else (*terms[:2], "…", terms[-1])
        return " + ".join(shown).replace("+ −", "− ")
    is_product = not isinstance(step.formula, str)
    numbers = {symbol: _Number(value) for symbol, value in step.numbers.items()}
    for each in numbers.values():
        each.digits, each.is_factor = step.digits, is_product
    formula = _TIMES.join(step.formula) if is_product else str(step.formula)
    return formula.format(**numbers) if numbers else ""


def _digits(value: float, digits: int) -> str:
    """Write a number with so many digits; with nine it can be put in again."""
    return replace(exact(""), digits=digits).format(value).replace("-", "−")
