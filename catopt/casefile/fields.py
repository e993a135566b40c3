"""The kinds of value a key of a case file can hold, each with its range."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from typing import Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from catopt.errors import InputError, Problem
from catopt.model.validity import COUNTS, Findings
from catopt.units import Dimension, as_written, to_si

REFUSED = "refused"
"""Type of the pydantic errors that carry our own ``found`` and ``allowed``."""


class Kind(ABC):
    """A kind of value; stands in the ``Annotated`` type of a key."""

    @property
    @abstractmethod
    def wanted(self) -> str:
        """What is wanted, with an example."""

    @abstractmethod
    def read(self, value: object) -> object:
        """Return the value as the model takes it, or raise InputError with one problem."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self._validate)

    def _validate(self, value: object) -> object:
        try:
            return self.read(value)
        except InputError as error:
            (problem,) = error.problems
            told = {"found": problem.found, "allowed": problem.allowed}
            raise PydanticCustomError(REFUSED, "{allowed}", told) from None


@dataclass(frozen=True)
class Measured(Kind):
    """A number with a unit.

    Attributes
    ----------
    dimension : Dimension
        What it measures.
    above, at_least, at_most : float or None
        Bounds in SI: exclusive below, inclusive below, inclusive above.
    example : str
        For messages, where that of the dimension is not to the point.
    bare : str
        Unit of a bare number; that of SI when empty.
    """

    dimension: Dimension
    above: float | None = None
    at_least: float | None = None
    at_most: float | None = None
    example: str = ""
    bare: str = ""

    @property
    def wanted(self) -> str:
        """What is wanted, with an example."""
        return f"{self.dimension.noun} is wanted, such as {self.example or self.dimension.example}"

    def read(self, value: object) -> float:
        """Return the value in SI."""
        try:
            si = to_si(value, self.dimension, bare=self.bare)
        except InputError as error:
            (problem,) = error.problems
            example = self.example or self.dimension.example
            allowed = problem.allowed.replace(self.dimension.example, example)
            raise InputError([replace(problem, allowed=allowed)]) from None
        unit = self.dimension.si_unit
        beyond = _out_of_range(si, unit, self.above, self.at_least, self.at_most)
        if beyond is not None:
            # Too large for a bare number: perhaps it was meant in another unit.
            large = self.at_most is not None and si > self.at_most and not isinstance(value, str)
            hint = f"; a bare number is in {unit}: give a unit, as in {self.dimension.example}"
            raise _refused(value, beyond + (hint if large and unit else ""))
        return si


@dataclass(frozen=True)
class Whole(Kind):
    """A whole number.

    Attributes
    ----------
    key : str
        Which of the model's counts it is.
    example : int
        For messages.
    """

    key: str
    example: int

    @property
    def bounds(self) -> tuple[int, int]:
        """Smallest and largest value."""
        return COUNTS[self.key]

    @property
    def wanted(self) -> str:
        """What is wanted, with an example."""
        return f"a whole number is wanted, such as {self.example}"

    def read(self, value: object) -> int:
        """Return the number."""
        if isinstance(value, bool) or not isinstance(value, int):
            raise _refused(value, self.wanted)
        fewest, most = self.bounds
        if value > most:
            raise _refused(value, f"must be {most} or less")
        if value < fewest:
            raise _refused(value, f"must be {fewest} or more")
        return value


@dataclass(frozen=True)
class Text(Kind):
    """Free text.

    Attributes
    ----------
    filled : bool
        Whether it must have more than blanks.
    example : str
        For messages, where an example helps.
    """

    filled: bool = False
    example: str = ""

    @property
    def wanted(self) -> str:
        """What is wanted, with the example if there is one."""
        return "text in quotes is wanted" + (f", such as {self.example}" if self.example else "")

    def read(self, value: object) -> str:
        """Return the text."""
        if not isinstance(value, str) or (self.filled and not value.strip()):
            raise _refused(value, self.wanted)
        return value


@dataclass(frozen=True)
class Flag(Kind):
    """Yes or no."""

    @property
    def wanted(self) -> str:
        """What is wanted."""
        return "true or false is wanted, without quotes"

    def read(self, value: object) -> bool:
        """Return it."""
        if not isinstance(value, bool):
            raise _refused(value, self.wanted)
        return value


@dataclass(frozen=True)
class OneOf(Kind):
    """One of several words."""

    words: tuple[str, ...]

    @property
    def wanted(self) -> str:
        """The words."""
        return f"one of {', '.join(self.words)} is wanted"

    def read(self, value: object) -> str:
        """Return the word."""
        if not isinstance(value, str) or value not in self.words:
            raise _refused(value, self.wanted + self._meant(value))
        return value

    def _meant(self, value: object) -> str:
        if not isinstance(value, str):
            return ""
        from difflib import get_close_matches

        close = get_close_matches(value.casefold(), self.words, n=1)
        return f"; did you mean {close[0]}?" if close else ""


def _out_of_range(
    value: float, unit: str, above: float | None, at_least: float | None, at_most: float | None
) -> str | None:
    """Say, in the model's words, which bound the value breaks."""
    check = Findings("")
    check.number("", value, unit, above=above, at_least=at_least, at_most=at_most)
    return check.problems[0].allowed if check.problems else None


def _refused(value: object, allowed: str) -> InputError:
    return InputError([Problem("value", as_written(value), allowed)])
