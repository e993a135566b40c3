"""An unknown of a line that a condition fixes: all its values, or why there is none.

The whole range of the unknown is looked at, from next to nothing to a thousand million times its
natural size, with the very ends of where the line has an answer; between two values on either side
of the condition lies a root. Where what is missing only rises or falls, that proves that there is
none; where it may turn, what was looked at is said.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal, NamedTuple, Protocol

from catopt.catenary.roots import root
from catopt.catenary.solution import FoundQuantity, Solution
from catopt.display import Tabled
from catopt.errors import (
    InputError,
    NoAnswerError,
    NoEquilibriumError,
    NotConvergedError,
    TableEndsError,
)
from catopt.words import Message, Several

ROUNDING = 4.0 * 2.0**-52
GRID = (
    *(10.0 ** (k / 3.0) for k in range(-27, -12)),
    *(10.0 ** (k / 16.0) for k in range(-64, 33)),
    *(10.0 ** (k / 3.0) for k in range(7, 28)),
)
"""Values that are tried, over the natural size of the unknown: closest where answers lie.

A sixth of them do where what is missing only rises or falls."""
MET = 1e-8
"""What may be left of a condition, over the size it is measured by."""


@dataclass(frozen=True)
class Found(Tabled, FoundQuantity):
    """An unknown that meets a condition, with the line that has it."""

    solution: Solution = field(kw_only=True)

    def alone(self) -> FoundQuantity:
        """Return the quantity without its line."""
        return FoundQuantity(self.quantity, self.value, self.condition, self.residual, self.number)


class Condition(NamedTuple):
    """What is asked of a line, in words (`text`).

    Of a line `miss` gives what is missing of it, positive above it, and the size it is measured by;
    `reading` puts into words what the line has of the quantity. `holds_below`: a line of which
    less than nothing is missing has what is asked for, too, as all that lie at the anchor have an
    angle of 0 there.
    """

    text: str
    miss: Callable[[Solution], tuple[float, float]]
    reading: Callable[[Solution], str]
    holds_below: bool = False


_NAMES = {
    "length": "catenary.length",
    "clump_weight": "figures.clump",
    "horizontal_force": "catenary.horizontal_force",
}


@dataclass(frozen=True)
class Sought:
    """An unknown (as in `FoundQuantity`), and how the condition put on it depends on it.

    `at` gives the line with a value of the unknown; `turns`: what is missing may both rise and fall
    with it.
    """

    quantity: Literal["length", "clump_weight", "horizontal_force"]
    condition: Condition
    at: Callable[[float], Solution]
    turns: bool = True
    number: int | None = None

    def missing(self, value: float) -> float:
        """Say what is missing at a value; not finite where the line has no answer there."""
        try:
            return self.condition.miss(self.line(value))[0]
        except (NotConvergedError, InputError):
            return math.nan  # digits may not carry a line so far from all that is built
        except TableEndsError:
            return math.inf  # it is pulled beyond all that is known of it
        except NoEquilibriumError as stop:
            if self.quantity == "horizontal_force":
                raise  # no force mends what is missing
            # Too short a line pulls without bound; too little tension lifts nothing.
            return math.inf if stop.quantity == "length" else -math.inf

    def line(self, value: float) -> Solution:
        """Solve the line at a value, or a few digits beside it where it is solved only there."""
        for beside in (1.0, 1.0 + 2.0**-46):
            with contextlib.suppress(NotConvergedError):
                return self.at(value * beside)
        return self.at(value * (1.0 - 2.0**-46))

    @property
    def name(self) -> str:
        """The unknown in words."""
        return Message(_NAMES[self.quantity])

    def written(self, value: float) -> str:
        """Write a value of the unknown with its unit."""
        return f"{value:.6g} {'m' if self.quantity == 'length' else 'N'}"

    def words(self, value: float) -> dict[str, str]:
        """Name the unknown, the condition and a value, for a refusal."""
        return {"what": self.name, "condition": self.condition.text, "at": self.written(value)}


class Missing(Protocol):
    """What is missing of a condition, over an unknown above 0."""

    @property
    def turns(self) -> bool:
        """Whether it may both rise and fall."""

    def missing(self, value: float) -> float:
        """Say what is missing at a value."""


class Trial(NamedTuple):
    """A value of an unknown and what is missing there."""

    value: float
    missing: float


def find(sought: Sought, start: float, scale: float, least: float) -> Found:
    """Find the smallest value at which a condition is met; the others are named as a warning.

    All from `least` on are looked at: `start`, and `least` and a multiple of `scale` each.

    NoAnswerError: no value meets the condition; it says how near the nearest comes.
    """
    tried = _tried(sought, start, scale, least)
    jumps, found = [], []
    for low, high in crossings(sought, tried):
        value = _root(sought, low, high)
        left, size = _left(sought, value)
        if abs(left) <= MET * size:
            found.append((value, left / size if size > 0.0 else 0.0))
        else:
            jumps.append((low, high))
    if not found and sought.condition.holds_below and tried[0].missing <= 0.0:
        if least == 0.0:
            raise _every(sought, tried[0].value)
        found.append((tried[0].value, 0.0))  # no shorter one is a line
    if not found:
        raise _jump(sought, *jumps[0]) if jumps else _none(sought, tried)
    (value, left), *others = found
    solution = sought.line(value)
    if others:
        said = ", ".join(sought.written(each) for each, _ in others)
        values = {"what": sought.name, "condition": sought.condition.text, "others": said}
        reported = Message("catenary.other_values", **values, smallest=sought.written(value))
        solution = solution.with_warnings((reported,))
    return Found(
        sought.quantity, value, sought.condition.text, left, sought.number, solution=solution
    )


def _tried(sought: Sought, start: float, scale: float, least: float) -> list[Trial]:
    """Try the whole range; where the line has an answer at one of two neighbours, up to its end."""
    grid = GRID if sought.turns else GRID[::6]
    values = sorted({least, least * (1.0 + 1e-12), start, *(least + part * scale for part in grid)})
    tried = [Trial(value, sought.missing(value)) for value in values if value > 0.0 or least == 0.0]
    tried = [each for each in tried if not math.isnan(each.missing)]
    if not tried:
        sought.line(start)  # which says itself what keeps every value from an answer
    closed = []
    for one, other in pairwise(tried):
        closed.append(one)
        if math.isinf(one.missing) != math.isinf(other.missing):
            closed += _closed_in(sought, one, other, lambda each: math.isinf(each.missing))
    return [each for each in (*closed, *tried[-1:]) if not math.isinf(each.missing)] or tried


def crossings(sought: Missing, tried: list[Trial]) -> list[tuple[Trial, Trial]]:
    """Pairs of values on either side of the condition, also where it is met only in between."""
    pairs = [
        (one, other)
        for one, other in pairwise(tried)
        if (one.missing > 0.0) != (other.missing > 0.0)
    ]
    if sought.turns:
        for before, middle, after in zip(tried, tried[1:], tried[2:], strict=False):
            sides = {each.missing > 0.0 for each in (before, middle, after)}
            nearest = min(abs(before.missing), abs(after.missing))
            if len(sides) == 1 and abs(middle.missing) < nearest:
                turning = _turning(sought, before, middle, after)
                if (turning.missing > 0.0) != (middle.missing > 0.0):
                    pairs += [(before, turning), (turning, after)]
    return sorted(pairs)


def _turning(sought: Missing, before: Trial, middle: Trial, after: Trial) -> Trial:
    """Go to where least is missing between three values, or just past the condition."""
    above = middle.missing > 0.0
    while after.value - before.value > 1e-7 * after.value:
        upwards = after.value - middle.value > middle.value - before.value
        value = 0.618 * middle.value + 0.382 * (after.value if upwards else before.value)
        new = Trial(value, sought.missing(value))
        if (new.missing > 0.0) != above or not math.isfinite(new.missing):
            return new if math.isfinite(new.missing) else middle
        if abs(new.missing) < abs(middle.missing):
            before, middle, after = (middle, new, after) if upwards else (before, new, middle)
        else:
            before, after = (before, new) if upwards else (new, after)
    return middle


def _root(sought: Sought, low: Trial, high: Trial) -> float:
    """Return the value between two at which nothing is missing; either side of a jump."""
    try:
        xtol = ROUNDING * high.value
        return root(sought.missing, low.value, high.value, xtol=xtol, rtol=ROUNDING)
    except NotConvergedError:
        ends = _closed_in(sought, low, high, lambda each: each.missing > 0.0)
        return min(ends, key=lambda each: abs(each.missing)).value


def _left(sought: Sought, value: float) -> tuple[float, float]:
    """Say what is left of the condition at a value, and the size that is measured by."""
    try:
        return sought.condition.miss(sought.line(value))
    except (NoEquilibriumError, NotConvergedError):
        return math.inf, 1.0


def _closed_in(
    sought: Sought, low: Trial, high: Trial, is_it: Callable[[Trial], bool]
) -> tuple[Trial, Trial]:
    """Two neighbouring numbers between which something changes that is so at one of two."""
    while low.value < (middle := 0.5 * (low.value + high.value)) < high.value:
        new = Trial(middle, sought.missing(middle))
        if math.isnan(new.missing):
            break
        if is_it(new) == is_it(low):
            low = new
        else:
            high = new
    return low, high


def _none(sought: Sought, tried: list[Trial]) -> NoAnswerError:
    """Say that no value meets the condition, how near the nearest comes and what ends it."""
    nearest = min(tried, key=lambda each: abs(each.missing))
    reading = sought.condition.reading(sought.line(nearest.value))
    why = Message("catenary.none_nearer")
    if sought.turns:
        low, high = (sought.written(each.value) for each in (tried[0], tried[-1]))
        why = Message("catenary.none_of_those_tried", count=len(tried), low=low, high=high)
    for factor in (1.0 - 1e-9, 1.0 + 1e-9):
        try:
            sought.line(nearest.value * factor)
        except NoEquilibriumError as stop:
            beyond = Message("catenary.beyond_that", why=stop.message)
            why = Several((why, beyond), "; ") if sought.turns else beyond
            break
        except (NotConvergedError, InputError):
            continue
    said = sought.words(nearest.value)
    return NoAnswerError(Message("catenary.no_value", **said, reading=reading, why=why))


def _every(sought: Sought, value: float) -> NoAnswerError:
    """Say that the condition is met however small the unknown is."""
    reading = sought.condition.reading(sought.line(value))
    return NoAnswerError(Message("catenary.every_value", **sought.words(value), reading=reading))


def _jump(sought: Sought, low: Trial, high: Trial) -> NoAnswerError:
    """Say that the line passes over the condition between two values."""
    low, high = _closed_in(sought, low, high, lambda each: each.missing > 0.0)
    before, after = (sought.condition.reading(sought.line(each.value)) for each in (low, high))
    said = sought.words(high.value)
    return NoAnswerError(Message("catenary.jumps", **said, before=before, after=after))
