"""Range checks that collect every problem before they raise."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from types import MappingProxyType

from catopt.errors import InputError, Problem
from catopt.units import Dimension, to_si

COUNTS: Mapping[str, tuple[int, int]] = MappingProxyType(
    {
        "particles": (2, 10_000),
        "iterations": (1, 10_000),
        "runs": (1, 1_000),
        "seed": (0, 2**63 - 1),
        "population": (4, 10_000),
        "evaluations": (1, 10_000_000),
        "max_enumerated": (1, 100_000_000),
        "elements": (4, 5_000),
        "components": (1, 10_000),
        "spreading_directions": (1, 360),
        "segment": (1, 200),
        "point_load": (1, 200),
        "joint": (1, 200),
        "broken_line": (1, 100),
        "lines": (1, 100),
        "headings": (1, 360),
        "samples": (1, 10_000_000),
        "count": (2, 100_000),
    }
)
"""Fewest and most of everything that a user may ask a number of. The most is what still answers
within days; how long it takes is said before it begins."""


_DIMENSIONS = {each.si_unit.replace("^", "").replace("*", " "): each for each in Dimension}
_DIMENSIONS["N/m2"] = Dimension.PRESSURE
"""By their SI units, as messages write them."""


class Findings:
    """Gathers the problems of one value or one call, so that all are reported together.

    Given the value itself, it reads what of it is text with a unit, and puts the number in SI in
    its place; nan where there is none, with its problem noted.
    """

    def __init__(self, source: str, of: object = None) -> None:
        self.source = source
        self.problems: list[Problem] = []
        self._of = of

    def number(
        self,
        key: str,
        value: object,
        unit: str,
        *,
        above: float | None = None,
        at_least: float | None = None,
        at_most: float | None = None,
        infinite: bool = False,
    ) -> None:
        """Note a problem unless `value` is a number within the bounds.

        The unit is empty for a pure number; `infinite` allows positive infinity.
        """
        if isinstance(value, str) and hasattr(self._of, key):
            read = self._read(key, value, unit)
            if read is None:
                object.__setattr__(self._of, key, math.nan)
                return
            object.__setattr__(self._of, key, read)
            value = read
        if isinstance(value, bool) or not isinstance(value, (int, float)) or value != value:
            self.add(key, repr(value), f"a number{_in(unit)} is wanted")
            return
        if isinstance(value, int) and abs(value) > sys.float_info.max:
            self.add(key, "a whole number beyond all floats", f"a number{_in(unit)} is wanted")
            return
        if math.isinf(value) and not (infinite and value > 0.0):
            self.add(key, repr(value), f"a finite number{_in(unit)} is wanted")
        elif above is not None and not value > above:
            self.add(key, repr(value), f"must be above {above:g}{_of(unit)}")
        elif at_least is not None and not value >= at_least:
            self.add(key, repr(value), f"must be {at_least:g}{_of(unit)} or more")
        elif at_most is not None and not value <= at_most:
            self.add(key, repr(value), f"must be {at_most:g}{_of(unit)} or less")

    def numbers(
        self,
        of: object,
        unit: str,
        *keys: str,
        above: float | None = None,
        at_least: float | None = None,
        at_most: float | None = None,
    ) -> None:
        """Note a problem of each attribute that is neither None nor a number within the bounds."""
        for key in keys:
            value = getattr(of, key)
            if value is not None:
                self.number(key, value, unit, above=above, at_least=at_least, at_most=at_most)

    def taken(self, key: str, value: object, unit: str, *, at_least: float) -> float:
        """Return an argument, read where it is text with a unit; nan with its problem noted."""
        read = self._read(key, value, unit) if isinstance(value, str) else value
        if read is not None:
            self.number(key, read, unit, at_least=at_least)
        return read if isinstance(read, (int, float)) else math.nan

    def each(
        self,
        key: str,
        unit: str,
        *,
        above: float | None = None,
        at_least: float | None = None,
        at_most: float | None = None,
    ) -> None:
        """Do the same for each item of an attribute that is a sequence."""
        items = list(getattr(self._of, key))
        for index, item in enumerate(items):
            name = f"{key}[{index}]"
            read = self._read(name, item, unit) if isinstance(item, str) else item
            items[index] = math.nan if read is None else read
            if read is not None:
                self.number(name, read, unit, above=above, at_least=at_least, at_most=at_most)
        object.__setattr__(self._of, key, tuple(items))

    def _read(self, key: str, text: str, unit: str) -> float | None:
        """Read text with a unit; None, with the problem noted, where it is none."""
        try:
            return to_si(text, _DIMENSIONS[unit], key)
        except InputError as error:
            self.problems += error.problems
            return None

    def word(self, key: str, value: object, words: Sequence[str]) -> None:
        """Note a problem unless `value` is one of some words."""
        if value not in words:
            self.add(key, repr(value), "one of " + ", ".join(words))

    def count(self, key: str, value: object) -> None:
        """Note a problem unless `value` is within the bounds of the count that `key` is."""
        fewest, most = COUNTS[key]
        if isinstance(value, str):
            self.add(key, repr(value), "a whole number is wanted")
        else:
            self.number(key, value, "", at_least=fewest, at_most=most)

    def add(self, key: str, found: str, allowed: str) -> None:
        """Note a problem."""
        self.problems.append(Problem(key, found, allowed))

    def raise_if_any(self) -> None:
        """Raise InputError when a problem was noted."""
        if self.problems:
            raise InputError(self.problems, self.source)


def _in(unit: str) -> str:
    return f" in {unit}" if unit else ""


def _of(unit: str) -> str:
    return f" {unit}" if unit else ""
