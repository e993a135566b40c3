"""Every value of a file that a note rests on, as it stands there and in SI."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from catopt.casefile.schema import Table, entries
from catopt.documents import Path, dotted
from catopt.model.kinds import Kind, Measured
from catopt.units import as_written

_MOST = 8
"""Values of an array that are all shown; of a longer one the first two and the last are."""
_LONGEST = 160
"""Characters of a text that are shown; the whole of it stands in the case file below."""
_FREE_TEXT = {("title",), ("source",)}
"""What stands in the title block already."""


@dataclass(frozen=True)
class Input:
    """A value of a file: where it is, as it is written there, and in SI.

    `si` is a text for several values, None for what is not measured; `unit` the SI unit, empty for
    a pure number.
    """

    key: str
    given: str
    si: float | str | None = None
    unit: str = ""


def inputs_of(document: dict[str, Any], schema: type[Table]) -> tuple[Input, ...]:
    """List every value of a file, as the TOML reader returns it, that is no free text."""
    found = leaves(document, schema)
    return tuple(_input(*leaf) for leaf in found if leaf[0] not in _FREE_TEXT)


def leaves(
    document: dict[str, Any], schema: type[Table], path: Path = ()
) -> Iterator[tuple[Path, Kind | None, Any]]:
    """Yield every value of a case file with its path and its kind; arrays of values are whole."""
    known = entries(schema)
    for key, value in document.items():
        entry = known.get(key)
        inner = None if entry is None else entry.table
        here = (*path, key)
        if inner is not None and isinstance(value, dict):
            yield from leaves(value, inner, here)
        elif inner is not None and isinstance(value, list):
            for index, each in enumerate(value):
                yield from leaves(each, inner, (*here, index))
        else:
            yield here, None if entry is None else entry.kind, value


def _input(path: Path, kind: Kind | None, value: Any) -> Input:
    many = value if isinstance(value, list) else [value]
    given = _some(many, lambda each: as_written(each, _LONGEST))
    if not isinstance(kind, Measured):
        return Input(dotted(path), given)
    unit = kind.dimension.si_unit
    read = [kind.read(each) for each in many]
    if len(read) == 1:
        return Input(dotted(path), given, read[0], unit)
    return Input(dotted(path), given, _some(read, lambda each: f"{each:.9g} {unit}".rstrip()), unit)


def _some(values: Sequence[Any], show: Callable[[Any], str]) -> str:
    """Show all of a few values, or the ends of many with their number."""
    if len(values) <= _MOST:
        return ", ".join(show(value) for value in values)
    first, second, last = (show(values[index]) for index in (0, 1, -1))
    return f"{first}, {second}, … {last} ({len(values)})"
