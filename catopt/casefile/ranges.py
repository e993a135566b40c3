"""Values to choose from: one, several, or a range with its step."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from catopt.casefile.document import Finding, Section
from catopt.casefile.schema import Values
from catopt.units import as_written
from catopt.words import Message

MOST_VALUES = 10_000
"""Values that a range may be made of."""

_HITS = 1e-9
"""Part of a step by which the last value may miss the end of its range: rounding, no more."""

_DIGITS = 14
"""Of the values inside a range: one less than double precision holds for certain, so that 0.1 m and
two steps of 0.1 m are 0.3 m."""


def wanted(values: Values) -> str:
    """Say in words in which ways a quantity may be given."""
    low, high, step = values.range
    return f"{values.many}, {values.one}, or {low} with {high} and {step}"


def is_given(values: Values, section: Section) -> bool:
    """Whether a table has any of the keys."""
    return any(key in section for key in values.keys)


def values_of(values: Values, given: dict[str, Any]) -> tuple[float, ...]:
    """Return the values, rising; empty where none is given, in SI and without fault."""
    if values.many in given:
        return tuple(sorted(given[values.many]))
    if values.one in given:
        return (given[values.one],)
    low, high, step = (given.get(key) for key in values.range)
    return () if low is None or high is None or step is None else _steps(low, high, step)


def read(values: Values, section: Section) -> tuple[float, ...]:
    """Return the values of a table of the document; empty where they are not clear."""
    if not is_given(values, section) or any(findings(values, section)):
        return ()
    given = {key: section.value(key) for key in values.keys if key in section}
    return () if None in given.values() else values_of(values, given)


def findings(values: Values, section: Section, *, required: bool = False) -> Iterator[Finding]:
    """Find values given in two ways, in half of one, twice, or (where required) not at all."""
    ranged = [key for key in values.range if key in section]
    singly = [key for key in (values.one, values.many) if key in section]
    if required and section.lacks(*values.keys):
        yield section.missing(values.many, Message("refused.ways_wanted", ways=wanted(values)))
    elif len(singly) + bool(ranged) > 1:
        found = " and ".join([*singly, *ranged])
        yield Finding(section.path, found, Message("refused.one_way", ways=wanted(values)))
    elif ranged and not section.misspelt(*values.keys):
        yield from _range_findings(values, section)
    yield from duplicates(section, values.many)


def _range_findings(values: Values, section: Section) -> Iterator[Finding]:
    low_key, high_key, step_key = values.range
    together = f"{low_key}, {high_key} and {step_key} go together"
    yield from (section.missing(key, together) for key in values.range if key not in section)
    yield from upside_down(section, low_key, high_key)
    low, high, step = (section.number(key) for key in values.range)
    if low is None or high is None or step is None or high < low:
        return
    if (high - low) / step >= MOST_VALUES - 1 + _HITS:
        count = f"{(high - low) / step + 1.0:.6g}"
        yield section.wrong(
            step_key, Message("refused.too_many_values", count=count, most=MOST_VALUES)
        )


def upside_down(section: Section, low_key: str, high_key: str) -> Iterator[Finding]:
    """Find an upper bound below the lower one."""
    low, high = section.number(low_key), section.number(high_key)
    if low is not None and high is not None and high < low:
        shown = as_written(section.given[low_key]).strip('"')
        yield section.wrong(high_key, Message("refused.at_least_key", key=low_key, shown=shown))


def duplicates(section: Section, key: str) -> Iterator[Finding]:
    """Find values of an array that stand there already, however they are written."""
    read = section.value(key) or []
    for index, each in enumerate(read):
        if each in read[:index]:
            shown = as_written(section.given[key][index])
            path = (*section.path, key, index)
            yield Finding(path, shown, Message("refused.stands_already"))


def _steps(low: float, high: float, step: float) -> tuple[float, ...]:
    """Step from `low` to `high`, which is the last value when a step meets it."""
    count = math.floor((high - low) / step + _HITS)
    inside = [float(f"{low + k * step:.{_DIGITS}g}") for k in range(1, count)]
    if count == 0:
        return (low,)
    last = low + count * step
    meets = abs(last - high) <= _HITS * step
    return (low, *inside, high if meets else float(f"{last:.{_DIGITS}g}"))
