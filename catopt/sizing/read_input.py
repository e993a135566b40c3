"""An input of a sizing as it was read, for the beginning of the answer."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal

from catopt.sizing.inputs import Input
from catopt.units import UNITS, Dimension
from catopt.words import Measure, Message, Several, term

Origin = Literal["given", "taken", "estimated"]

_FIELD = {"LENGTH": "m", "MASS": "t", "AREA": "m^2", "DENSITY": "kg/m^3", "NUMBER": ""}
"""Units of what has no example with one."""


@dataclass(frozen=True)
class ReadInput:
    """One input.

    Attributes
    ----------
    of : Input
        Its row in the table.
    value : object
        In SI; a tuple of several.
    origin : {"given", "taken", "estimated"}
        By whom: the user, a default, or an estimate from what was given.
    source : str
        Of an estimate.
    """

    of: Input
    value: Any
    origin: Origin
    source: str = ""

    @property
    def name(self) -> Message:
        """What it is."""
        return Message(f"inputs.{self.of.name}")

    @property
    def said(self) -> str:
        """Its value in the unit that one writes it in."""
        values = self.value if isinstance(self.value, tuple) else (self.value,)
        return Several((self._said(each) for each in values), ", ")

    @property
    def from_where(self) -> Message:
        """Whether it was given, taken or estimated, and by what."""
        return Message(f"sizing.is_{self.origin}", source=self.source)

    def _said(self, value: Any) -> str:
        if self.of.takes == "FORCE":
            return Message("sizing.about", value=Measure("horizontal_force", value))
        if not self.of.is_measure:
            return term(str(value).lower() if isinstance(value, bool) else str(value))
        unit = self._unit
        if not unit:
            return f"{value:.6g}"
        factor = UNITS[Dimension[self.of.takes]].get(unit, 1.0)
        if self.of.takes == "TIME" and value < factor:
            unit, factor = "s", 1.0
        return Message("sizing.in_unit", value=value / factor, unit=term(unit))

    @property
    def _unit(self) -> str:
        """Take that of the example, or of the default that was taken."""
        example = self.of.example[0] if isinstance(self.of.example, tuple) else self.of.example
        texts = (example, self.of.default)
        for text in reversed(texts) if self.origin == "taken" else texts:
            if isinstance(text, str) and " " in text:
                return text.partition(" ")[2]
        return _FIELD.get(self.of.takes, "")


def estimated_dimensions(inputs: Iterable[ReadInput]) -> tuple[Message, ...]:
    """Say which dimensions an answer rests on that were estimated."""
    found = [each for each in inputs if each.origin == "estimated"]
    if not found:
        return ()
    names = Several((each.name for each in found), ", ")
    return (Message("sizing.estimated_dimensions", names=names, source=found[0].source),)
