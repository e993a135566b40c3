"""The case file's values, as given there and in SI."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from catopt.casefile.fields import Kind, Measured
from catopt.casefile.schema import CaseTable, Table, entries
from catopt.documents import Path, dotted
from catopt.notes.line import Note
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, shown_si
from catopt.report.page.table import Table as ShownTable
from catopt.units import as_written

__all__ = ["given_values", "inputs", "inputs_table", "leaves", "some"]

_MOST = 8
"""Values of an array that are all shown; of a longer one the first two and the last are."""
_LONGEST = 160
"""Characters of a text that are shown; the whole of it stands in the case file below."""
_FREE_TEXT = {("title",), ("source",)}
"""What stands in the title block already."""


def inputs(note: Note, words: Words) -> dict[str, Any]:
    """Build the table of inputs of a line's case."""
    return {
        "table": inputs_table(note.origin.inputs, CaseTable, words),
        "design": None if note.chosen is None else note.chosen.number,
    }


def inputs_table(document: dict[str, Any], schema: type[Table], words: Words) -> ShownTable:
    """Tabulate every value of a file that is no free text.

    Parameters
    ----------
    document : dict
        The file as the TOML reader returns it.
    schema : type of Table
        What the file may hold.
    words : Words
        Language.
    """
    rows = []
    for path, kind, value in given_values(document, schema):
        many = value if isinstance(value, list) else [value]
        rows.append((Cell(dotted(path)), Cell(some(many, _given)), _si(kind, many)))
    headings = (
        Heading(words("inputs.key")),
        Heading(words("inputs.given")),
        Heading(words("inputs.si"), is_number=True),
    )
    return ShownTable("inputs", headings, tuple(rows))


def given_values(
    document: dict[str, Any], schema: type[Table]
) -> Iterator[tuple[Path, Kind | None, Any]]:
    """Yield the `leaves` of a file that are no free text."""
    return (leaf for leaf in leaves(document, schema) if leaf[0] not in _FREE_TEXT)


def leaves(
    document: dict[str, Any], schema: type[Table], path: Path = ()
) -> Iterator[tuple[Path, Kind | None, Any]]:
    """Yield every value of a case file with its path and its kind; arrays of values are whole.

    Parameters
    ----------
    document : dict
        A table as the TOML reader returns it.
    schema : type of Table
        What the table may hold.
    path : tuple
        Where it stands.
    """
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


def _si(kind: Kind | None, values: Sequence[Any]) -> Cell:
    """Show values in SI; nothing for what is not measured."""
    if not isinstance(kind, Measured):
        return Cell("")
    unit = kind.dimension.si_unit
    read = [kind.read(value) for value in values]
    shown = some(read, lambda value: shown_si(value, unit))
    return Cell(shown, read[0] if len(read) == 1 else None)


def _given(value: Any) -> str:
    return as_written(value, _LONGEST)


def some(values: Sequence[Any], show: Any) -> str:
    """Show all of a few values, or the ends of many with their number."""
    if len(values) <= _MOST:
        return ", ".join(show(value) for value in values)
    first, second, last = (show(values[index]) for index in (0, 1, -1))
    return f"{first}, {second}, … {last} ({len(values)})"
