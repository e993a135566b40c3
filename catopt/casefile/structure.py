"""Turns what pydantic found wrong into findings in the user's terms."""

from __future__ import annotations

from collections.abc import Sequence

from pydantic_core import ErrorDetails

from catopt.casefile.fields import REFUSED
from catopt.casefile.location import Finding, header
from catopt.casefile.names import hint, stands_for
from catopt.casefile.schema import CaseTable, Entry, LoadTable, Table, entries
from catopt.documents import Path
from catopt.units import as_written

_MOST = 200
"""Findings of one file: a file with more has one fault, that it is another kind of file."""


def structure_findings(
    errors: Sequence[ErrorDetails], top: type[Table] = CaseTable
) -> list[Finding]:
    """Translate pydantic's errors of a file, whose schema is `top`.

    A missing key is not reported when an unknown key beside it is a misspelling of it, or belongs
    to a later version and would stand for it: one mistake, one message.
    """
    errors = errors[:_MOST]
    unknown = [_path(error) for error in errors if error["type"] == "extra_forbidden"]
    meant = {(*path[:-1], _stands_for(path, top)) for path in unknown}
    return [
        _finding(error, top)
        for error in errors
        if not (error["type"] == "missing" and _path(error) in meant)
    ]


def _finding(error: ErrorDetails, top: type[Table]) -> Finding:
    path, given = _path(error), error["input"]
    if error["type"] == REFUSED:
        return Finding(path, error["ctx"]["found"], error["ctx"]["allowed"])
    if error["type"] == "extra_forbidden":
        return _unknown(path, given, top)
    if error["type"] == "missing":
        return Finding(path, "", f"missing; {_wanted(path, top)}")
    most = f"; {error['ctx']['max_length']} are the most" if error["type"] == "too_long" else ""
    return Finding(path, as_written(given), _wanted(path, top) + most)  # no table, or no such array


def _unknown(path: Path, given: object, top: type[Table]) -> Finding:
    table, key = _table(path[:-1], top), str(path[-1])
    if key in table.elsewhere:
        return Finding(path, as_written(given), table.elsewhere[key])
    if key not in table.later:
        return Finding(path, "an unknown key", hint(table, key, top))
    instead = _stands_for(path, top)
    advice = f"; give {_name_of(path[:-1], instead, top)} instead" if instead else ""
    return Finding(path, as_written(given), "this version of catopt does not know it yet" + advice)


def _stands_for(path: Path, top: type[Table]) -> str:
    """Return the key that an unknown key was to give."""
    return stands_for(_table(path[:-1], top), str(path[-1]), top) or ""


def _wanted(path: Path, top: type[Table]) -> str:
    if isinstance(path[-1], int):
        return "a table is wanted"
    entry = _entry(path, top)
    if entry.kind is not None:
        return entry.kind.wanted + (", in brackets" if entry.array else "")
    line = header(path, array=entry.array)
    if entry.array:
        return f"write {line}, in double brackets, once for each"
    if entry.table is LoadTable:
        return f"a table {line} with one of {', '.join(entries(LoadTable))} is wanted"
    return f"a table {line} is wanted"


def _name_of(parent: Path, key: str, top: type[Table]) -> str:
    path = (*parent, key)
    return key if _entry(path, top).table is None else header(path)


def _entry(path: Path, top: type[Table]) -> Entry:
    return entries(_table(path[:-1], top))[str(path[-1])]


def _table(path: Path, top: type[Table]) -> type[Table]:
    """Return the schema of the table at a path."""
    table = top
    for part in path:
        if isinstance(part, str):
            inner = entries(table)[part].table
            assert inner is not None, path
            table = inner
    return table


def _path(error: ErrorDetails) -> Path:
    return error["loc"]
