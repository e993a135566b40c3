"""Range checks that collect every problem before they raise."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from dataclasses import MISSING
from typing import Self

from catopt.errors import InputError, Problem
from catopt.model.kinds import COUNTS, Annotation, Measured, OneOf, Whole, annotated, out_of_range
from catopt.units import Dimension, plain, to_si
from catopt.words import Message


def _unit(si_unit: str) -> str:
    """Write a unit of SI as messages about arguments do."""
    return si_unit.replace("^", "").replace("*", " ")


def _number(unit: str) -> Message:
    return Message("refused.number_in" if unit else "refused.number", unit=unit)


_DIMENSIONS = {_unit(each.si_unit): each for each in Dimension}
_DIMENSIONS["N/m2"] = Dimension.PRESSURE
"""By their SI units, as messages write them."""


_KNOWN: dict[type, Mapping[str, tuple[object, Annotation]]] = {}


def _known(of: type) -> Mapping[str, tuple[object, Annotation]]:
    """Of each attribute of a class: its default, and what its annotation says."""
    if of not in _KNOWN:
        every = annotated(of).items()
        _KNOWN[of] = {key: (getattr(of, key, MISSING), each) for key, each in every}
    return _KNOWN[of]


class Findings:
    """Gathers the problems of one value or one call, so that all are reported together.

    Given the value itself, it reads what of it is text with a unit, and puts the number in SI in
    its place; nan where there is none, with its problem noted.
    """

    def __init__(self, source: str = "", of: object = None) -> None:
        self.source = source or type(of).__name__
        self.problems: list[Problem] = []
        self._of = of

    def check(self, *keys: str) -> Self:
        """Note the problems of attributes, by their annotated kinds; of all if none is named.

        What is the default of its class is right.
        """
        of: type = type(self._of)
        known = _known(of)
        for key in keys or known:
            value = getattr(self._of, key)
            default, annotation = known[key]
            if value is default:
                continue
            # The commonest by far is a number that is right: it is passed at once.
            kind = annotation.kind
            if not (type(value) is float and isinstance(kind, Measured) and kind.allows(value)):
                self._check(key, value, annotation)
        return self

    def _check(self, key: str, value: object, annotation: Annotation) -> None:
        kind = annotation.kind
        if isinstance(kind, Measured):
            unit = _unit(kind.si_unit)
            bounds = {"above": kind.above, "at_least": kind.at_least, "at_most": kind.at_most}
            if not annotation.is_array:
                self.number(key, value, unit, **bounds, infinite=kind.infinite)
            elif annotation.size is None:
                self.each(key, unit, **bounds)
            else:
                self._vector(key, unit, annotation.size.most)
        elif isinstance(kind, Whole) and not annotation.is_array:
            self.count(key, value)
        elif isinstance(kind, OneOf) and not annotation.is_array:
            self.word(key, value, kind.words, quoted=kind.quoted)

    def _vector(self, key: str, unit: str, size: int) -> None:
        """Check numbers of which there are none, or so many."""
        values = tuple(getattr(self._of, key))
        object.__setattr__(self._of, key, values)
        if len(values) not in {0, size}:
            found = Message("refused.numbers", count=len(values))
            self.add(key, found, Message("refused.so_many", count=size))
        self.each(key, unit)

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
            object.__setattr__(self._of, key, math.nan if read is None else read)
            if read is None:
                return
            value = read
        elif plain(value) is not value:
            value = plain(value)
            if hasattr(self._of, key):
                object.__setattr__(self._of, key, value)
        if isinstance(value, bool) or not isinstance(value, (int, float)) or value != value:
            self.add(key, repr(value), _number(unit))
        elif isinstance(value, int) and abs(value) > sys.float_info.max:
            self.add(key, Message("refused.beyond_floats"), _number(unit))
        elif math.isinf(value) and not (infinite and value > 0.0):
            finite = "refused.finite_in" if unit else "refused.finite_number"
            self.add(key, repr(value), Message(finite, unit=unit))
        elif beyond := out_of_range(value, unit, above, at_least, at_most):
            self.add(key, repr(value), beyond)

    def numbers(self, of: object, unit: str, *keys: str, **bounds: float) -> None:
        """Note a problem of each attribute that is neither None nor a number within the bounds."""
        for key in keys:
            value = getattr(of, key)
            if value is not None:
                self.number(key, value, unit, **bounds, infinite=False)

    def taken(self, key: str, value: object, unit: str, **bounds: float | None) -> float:
        """Return a number, read where it is text with a unit; nan with its problem noted."""
        read = self._read(key, value, unit) if isinstance(value, str) else plain(value)
        if read is not None:
            self.number(key, read, unit, **bounds, infinite=False)
        return read if isinstance(read, (int, float)) else math.nan

    def each(self, key: str, unit: str, **bounds: float | None) -> None:
        """Do the same for each item of an attribute that is a sequence."""
        items = enumerate(getattr(self._of, key))
        read = tuple(self.taken(f"{key}[{k}]", item, unit, **bounds) for k, item in items)
        object.__setattr__(self._of, key, read)

    def _read(self, key: str, text: str, unit: str) -> float | None:
        """Read text with a unit; None, with the problem noted, where it is none."""
        try:
            return to_si(text, _DIMENSIONS[unit], key)
        except InputError as error:
            self.problems += error.problems
            return None

    def word(self, key: str, value: object, words: Sequence[str], *, quoted: bool = False) -> None:
        """Note a problem unless `value` is one of some words; quoted: shown as a file has it."""
        if value not in words:
            self.add(
                key,
                f'"{value}"' if quoted else repr(value),
                Message("refused.of_these", words=", ".join(words)),
            )

    def count(self, key: str, value: object) -> None:
        """Note a problem unless `value` is within the bounds of the count that `key` is."""
        fewest, most = COUNTS[key]
        if isinstance(value, str):
            self.add(key, repr(value), Message("refused.whole"))
        else:
            self.number(key, value, "", at_least=fewest, at_most=most)

    def add(self, key: str, found: str, allowed: str) -> None:
        """Note a problem."""
        self.problems.append(Problem(key, found, allowed))

    def raise_if_any(self) -> None:
        """Raise InputError when a problem was noted."""
        if self.problems:
            raise InputError(self.problems, self.source)


class Checked:
    """A part of the model, which is right when it is there: InputError has all that is wrong."""

    def __post_init__(self) -> None:
        found = Findings(of=self)
        self._check(found)
        found.raise_if_any()

    def _check(self, found: Findings) -> None:
        """Note what is wrong: of each attribute, by its kind."""
        found.check()
