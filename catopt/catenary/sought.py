"""An unknown of a line that a condition fixes: its bracket, its root, or why there is none."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from catopt.catenary.brent import root
from catopt.catenary.solution import FoundQuantity, Solution
from catopt.errors import (
    NoAnswerError,
    NoEquilibriumError,
    NotConvergedError,
)
from catopt.words import Message

ROUNDING = 4.0 * 2.0**-52
FAR = 1e9
"""How many times its natural size an unknown may grow before it is called out of reach."""
MET = 1e-8
"""What may be left of a condition, over the size it is measured by."""


@dataclass(frozen=True)
class Found(FoundQuantity):
    """An unknown that meets a condition, with the line that has it."""

    solution: Solution = field(kw_only=True)

    def alone(self) -> FoundQuantity:
        """Return the quantity without its line."""
        return FoundQuantity(self.quantity, self.value, self.condition, self.residual, self.number)


class Condition(NamedTuple):
    """What is asked of a line, in words (`text`).

    Of a line `miss` gives what is missing of it, positive above it, and the size it is measured by;
    `reading` puts into words what the line has of the quantity.
    """

    text: str
    miss: Callable[[Solution], tuple[float, float]]
    reading: Callable[[Solution], str]


_NAMES = {
    "length": "catenary.length",
    "clump_weight": "catenary.clump_weight",
    "horizontal_force": "catenary.horizontal_force",
}


@dataclass(frozen=True)
class Sought:
    """An unknown (as in `FoundQuantity`), and how the condition put on it depends on it.

    `at` gives the line with a value of the unknown; `falls`: what is missing falls as that grows.
    """

    quantity: Literal["length", "clump_weight", "horizontal_force"]
    condition: Condition
    at: Callable[[float], Solution]
    falls: bool = False
    number: int | None = None

    def error(self, value: float) -> float:
        """Say what is missing at a value, with the sign that makes it rise with the value."""
        try:
            missing = self.condition.miss(self.at(value))[0]
        except NoEquilibriumError as stop:
            if self.quantity == "horizontal_force":
                raise  # no force mends what is missing
            # Too short a line pulls without bound; too little tension lifts nothing.
            missing = math.inf if stop.quantity == "length" else -math.inf
        return -missing if self.falls else missing

    def none(self, nearest: float, beyond: float | None = None) -> NoAnswerError:
        """Say that no value meets the condition, how near the nearest comes and what ends it."""
        reading = self.condition.reading(self.at(nearest))
        why = Message("catenary.none_nearer")
        if beyond is not None:
            try:
                self.at(beyond)
            except NoAnswerError as stop:
                why = Message("catenary.beyond_that", why=stop.message)
        return NoAnswerError(
            Message(
                "catenary.no_value",
                what=self.name,
                condition=self.condition.text,
                at=self.written(nearest),
                reading=reading,
                why=why,
            )
        )

    def jump(self, low: float, high: float) -> NoAnswerError:
        """Say that the line passes over the condition between two values."""
        before, after = (self.condition.reading(self.at(value)) for value in (low, high))
        return NoAnswerError(
            Message(
                "catenary.jumps",
                what=self.name,
                condition=self.condition.text,
                at=self.written(high),
                before=before,
                after=after,
            )
        )

    @property
    def name(self) -> str:
        """The unknown in words."""
        return Message(_NAMES[self.quantity])

    def written(self, value: float) -> str:
        """Write a value of the unknown with its unit."""
        return f"{value:.6g} {'m' if self.quantity == 'length' else 'N'}"


def find(sought: Sought, start: float, least: float) -> Found:
    """Find the value, above `least`, at which a condition is met, from `start` on.

    NoAnswerError: no value meets the condition; it says how near the nearest comes.
    """
    low, high = _bracket(sought, start, least)
    value = root(sought.error, low, high, xtol=ROUNDING * high, rtol=ROUNDING)
    solution = sought.at(value)
    left, size = sought.condition.miss(solution)
    if abs(left) > MET * size:
        raise sought.jump(*_closed_in(sought, low, high))
    return Found(
        sought.quantity, value, sought.condition.text, left / size, sought.number, solution=solution
    )


def _bracket(sought: Sought, start: float, least: float) -> tuple[float, float]:
    """Values with the error below and above 0, both finite."""
    low, high = _crossing(sought, start, least)
    while math.isinf(sought.error(low)) or math.isinf(sought.error(high)):
        closer = _halved(sought, low, high)
        if closer is None:
            raise (
                sought.none(high, low) if math.isinf(sought.error(low)) else sought.none(low, high)
            )
        low, high = closer
    return low, high


def _crossing(sought: Sought, start: float, least: float) -> tuple[float, float]:
    """Two values with the error below and above 0, by strides that double or halve."""
    error = sought.error(start)
    if error >= 0.0:
        return _downwards(sought, start, least)
    below = nearest = start
    if sought.quantity == "clump_weight":
        nearest = max(0.0, start, key=sought.error)  # more weight may raise the anchor angle
    value = start
    while (value := least + 2.0 * (value - least)) <= FAR * max(start, 1.0):
        try:
            further = sought.error(value)
        except NotConvergedError:
            continue  # so far from all that is built that digits may not carry the line
        if further >= 0.0:
            return below, value
        below, nearest = value, max(nearest, value, key=sought.error)
    raise sought.none(nearest)


def _downwards(sought: Sought, start: float, least: float) -> tuple[float, float]:
    high, low = start, least + 0.5 * (start - least)
    while sought.error(low) > 0.0:
        high, low = low, least + 0.5 * (low - least)
        if low - least < start / FAR:
            raise sought.none(high)
    return low, high


def _halved(sought: Sought, low: float, high: float) -> tuple[float, float] | None:
    """Half of a bracket that keeps the crossing; None where no number lies between its ends."""
    middle = 0.5 * (low + high)
    if not low < middle < high:
        return None
    return (middle, high) if sought.error(middle) <= 0.0 else (low, middle)


def _closed_in(sought: Sought, low: float, high: float) -> tuple[float, float]:
    """Two neighbouring numbers between which the error passes over 0."""
    while (closer := _halved(sought, low, high)) is not None:
        low, high = closer
    return low, high
