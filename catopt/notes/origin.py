"""Where a note comes from: the files that it rests on with their values, when it was made."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from catopt._version import __version__
from catopt.casefile.design_directory import DESIGN_CASE
from catopt.casefile.schema import CaseTable, Table, entries
from catopt.casefile.sizing_file import SIZING
from catopt.documents import MOST_BYTES_OF_DATA, dotted, parse_toml, read_text
from catopt.documents import Path as Keys
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


@dataclass(frozen=True)
class SourceFile:
    """A file that the note rests on: its name, its text and the SHA-256 of its bytes."""

    name: str
    text: str
    sha256: str


@dataclass(frozen=True)
class Origin:
    """What a note rests on: its files, the case file first, with every value of that.

    The date is as it was given, empty when none was; the version is that of catopt.
    """

    files: tuple[SourceFile, ...]
    inputs: tuple[Input, ...] = ()
    date: str = ""
    version: str = __version__


def origin_of(
    files: tuple[SourceFile, ...], date: str = "", schema: type[Table] = CaseTable
) -> Origin:
    """Say where a note comes from; the first of the files, as its schema has it, has its inputs."""
    document = parse_toml(files[0].text, files[0].name)
    return Origin(files, inputs_of(document, schema), _writable(date))


def read_source(path: Path) -> SourceFile:
    """Read a file that a note rests on; InputError where it cannot be read."""
    text = read_text(path, str(path), most=MOST_BYTES_OF_DATA)
    return SourceFile(_writable(path.name), text, hashlib.sha256(path.read_bytes()).hexdigest())


def _writable(text: str) -> str:
    """Replace what no file can hold: bytes of a name or an option that are no text."""
    return text.encode("utf-8", "replace").decode("utf-8")


def file_name(path: Path, design: int | None) -> str:
    """Name the page of a case: that of the file, or of the folder of a file with the usual name.

    With the number of the design, if it is one.
    """
    place = path.resolve()
    name = place.name if place.is_dir() else place.stem
    if place.name in (DESIGN_CASE, SIZING) and not place.is_dir():
        name = place.parent.name or name
    return f"{name}.html" if design is None else f"{name}-design-{design}.html"


# ------------------------------------------------------------------ values of a file


def inputs_of(document: dict[str, Any], schema: type[Table]) -> tuple[Input, ...]:
    """List every value of a file, as the TOML reader returns it, that is no free text."""
    found = leaves(document, schema)
    return tuple(_input(*leaf) for leaf in found if leaf[0] not in _FREE_TEXT)


def leaves(
    document: dict[str, Any], schema: type[Table], path: Keys = ()
) -> Iterator[tuple[Keys, Kind | None, Any]]:
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


def _input(path: Keys, kind: Kind | None, value: Any) -> Input:
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
