"""Looks into the document of a case file as the TOML reader returns it, however broken it is.

What is missing or wrong in itself is passed over: it is reported by its own key.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import Any

from catopt.casefile.location import Finding, parts
from catopt.casefile.names import stands_for
from catopt.casefile.schema import MOST_LISTED, MOST_TABLES, Table, entries
from catopt.documents import Path
from catopt.errors import InputError, Problem
from catopt.units import as_written

Place = tuple[Path, dict[str, Any]]
"""A table of the document with its path."""


def table(document: dict[str, Any], key: str) -> dict[str, Any]:
    """Return a table; an empty one where there is none."""
    found = document.get(key)
    return found if isinstance(found, dict) else {}


def tables(parent: dict[str, Any], *path: str) -> list[Place]:
    """List the tables of an array, each with its path; the last key of the path is the array's.

    There are none when one of them is no table, or when they are too many.
    """
    array = parent.get(path[-1])
    if not isinstance(array, list) or len(array) > MOST_TABLES:
        return []
    if not all(isinstance(each, dict) for each in array):
        return []
    return [((*path, index), each) for index, each in enumerate(array)]


def value(schema: type[Table], key: str, given: dict[str, Any]) -> Any:
    """Return a value as the model takes it; None when it is missing or wrong in itself.

    An array gives a list, and None when one of its values is wrong.
    """
    entry = entries(schema)[key]
    if entry.kind is None or key not in given:
        return None
    try:
        if not entry.array:
            return entry.kind.read(given[key])
        if not isinstance(given[key], list) or len(given[key]) > MOST_LISTED:
            return None
        return [entry.kind.read(each) for each in given[key]]
    except InputError:
        return None


def number(schema: type[Table], key: str, given: dict[str, Any]) -> float | None:
    """Return a value in SI; None when it is missing or wrong in itself."""
    found = value(schema, key, given)
    return found if isinstance(found, float) else None


def text(schema: type[Table], key: str, given: dict[str, Any]) -> str | None:
    """Return a text; None when it is missing or wrong in itself."""
    found = value(schema, key, given)
    return found if isinstance(found, str) else None


def values(schema: type[Table], given: dict[str, Any]) -> dict[str, Any]:
    """Return what is given of the keys of a table; None of what cannot be read."""
    return {key: value(schema, key, given) for key in entries(schema) if key in given}


def misspelt(schema: type[Table], keys: Collection[str], given: dict[str, Any]) -> bool:
    """Whether one of the keys is there under another name, which is reported already."""
    unknown = [key for key in given if key not in entries(schema)]
    return any(stands_for(schema, key) in keys for key in unknown)


def refusals(part: Callable[..., object], **given: Any) -> Sequence[Problem]:
    """List what a part of the model refuses in what is given."""
    try:
        part(**given)
    except InputError as error:
        return error.problems
    return ()


def in_file(
    document: dict[str, Any], problems: Iterable[Problem], *at: str | int
) -> Iterator[Finding]:
    """Place what the model refuses in the file, by its keys below a path."""
    for problem in problems:
        path = (*at, *parts(problem.key))
        yield as_in_file(document, Finding(path, problem.found, problem.allowed))


def as_in_file(document: dict[str, Any], finding: Finding) -> Finding:
    """Show what the file has at the place of a finding, where that is a single value."""
    place: Any = document
    for part in finding.path:
        if isinstance(place, dict):
            place = place.get(str(part))
        elif isinstance(place, list) and isinstance(part, int) and part < len(place):
            place = place[part]
        else:
            place = None
    if place is None or isinstance(place, dict | list):
        return finding
    return finding._replace(found=as_written(place))
