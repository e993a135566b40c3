"""Values to choose from: one, several, or a range with its step."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from catopt.casefile.document import Place, misspelt, number, value
from catopt.casefile.location import Finding
from catopt.casefile.schema import Table
from catopt.units import as_written

MOST_VALUES = 10_000
"""Values that a range may be made of."""

_HITS = 1e-9
"""Part of a step by which the last value may miss the end of its range: rounding, no more."""

_DIGITS = 14
"""Of the values inside a range: one less than double precision holds for certain, so that 0.1 m and
two steps of 0.1 m are 0.3 m."""


@dataclass(frozen=True)
class Values:
    """The keys that give the values of one quantity, of which one way is chosen.

    Attributes
    ----------
    one, many : str
        Key of a single value, and of an array; a range has keys that begin with `one`.
    """

    one: str
    many: str

    @property
    def range(self) -> tuple[str, str, str]:
        """Keys of a range: smallest, largest, step."""
        return f"{self.one}_min", f"{self.one}_max", f"{self.one}_step"

    @property
    def keys(self) -> tuple[str, ...]:
        """All of them."""
        return self.many, self.one, *self.range

    @property
    def wanted(self) -> str:
        """The ways, in words."""
        low, high, step = self.range
        return f"{self.many}, {self.one}, or {low} with {high} and {step}"

    def is_given(self, table: dict[str, Any]) -> bool:
        """Whether a table has any of the keys."""
        return any(key in table for key in self.keys)

    def of(self, given: dict[str, Any]) -> tuple[float, ...]:
        """Return the values, rising; empty where none is given, in SI and without fault."""
        if self.many in given:
            return tuple(sorted(given[self.many]))
        if self.one in given:
            return (given[self.one],)
        low, high, step = (given.get(key) for key in self.range)
        return () if low is None or high is None or step is None else _steps(low, high, step)

    def read(self, schema: type[Table], table: dict[str, Any]) -> tuple[float, ...]:
        """Return the values of a table of the document; empty where they are not clear."""
        place: Place = ((), table)
        if not self.is_given(table) or any(self.findings(schema, place)):
            return ()
        given = {key: value(schema, key, table) for key in self.keys if key in table}
        return () if None in given.values() else self.of(given)

    def findings(
        self, schema: type[Table], place: Place, *, required: bool = False
    ) -> Iterator[Finding]:
        """Find values given in two ways, in half of one, twice, or (where required) not at all."""
        path, table = place
        ranged = [key for key in self.range if key in table]
        singly = [key for key in (self.one, self.many) if key in table]
        unclear = misspelt(schema, self.keys, table)
        if not ranged and not singly and required and not unclear:
            yield Finding((*path, self.many), "", f"missing; {self.wanted} is wanted")
        elif len(singly) + bool(ranged) > 1:
            found = " and ".join([*singly, *ranged])
            yield Finding(path, found, f"only one way is wanted: {self.wanted}")
        elif ranged and not unclear:
            yield from self._range_findings(schema, place)
        yield from duplicates(schema, place, self.many)

    def _range_findings(self, schema: type[Table], place: Place) -> Iterator[Finding]:
        path, table = place
        low_key, high_key, step_key = self.range
        together = f"missing; {low_key}, {high_key} and {step_key} go together"
        yield from (Finding((*path, key), "", together) for key in self.range if key not in table)
        low, high, step = (number(schema, key, table) for key in self.range)
        if low is None or high is None:
            return
        if high < low:
            shown = as_written(table[low_key]).strip('"')
            allowed = f"must be {low_key} or more, which is {shown}"
            yield Finding((*path, high_key), as_written(table[high_key]), allowed)
        elif step is not None and (high - low) / step >= MOST_VALUES - 1 + _HITS:
            count = f"{(high - low) / step + 1.0:.6g}"
            allowed = f"makes {count} values; {MOST_VALUES} are the most"
            yield Finding((*path, step_key), as_written(table[step_key]), allowed)


LENGTHS = Values("length", "lengths")
MASSES = Values("mass", "masses")
POSITIONS = Values("position", "positions")
RADII = Values("anchor_radius", "anchor_radii")
PRETENSIONS = Values("pretension", "pretensions")


def duplicates(schema: type[Table], place: Place, key: str) -> Iterator[Finding]:
    """Find values of an array that stand there already, however they are written."""
    path, table = place
    read = value(schema, key, table) or []
    for index, each in enumerate(read):
        if each in read[:index]:
            shown = as_written(table[key][index])
            yield Finding((*path, key, index), shown, "stands there already; leave it out")


def _steps(low: float, high: float, step: float) -> tuple[float, ...]:
    """Step from `low` to `high`, which is the last value when a step meets it."""
    count = math.floor((high - low) / step + _HITS)
    inside = [float(f"{low + k * step:.{_DIGITS}g}") for k in range(1, count)]
    if count == 0:
        return (low,)
    last = low + count * step
    meets = abs(last - high) <= _HITS * step
    return (low, *inside, high if meets else float(f"{last:.{_DIGITS}g}"))
