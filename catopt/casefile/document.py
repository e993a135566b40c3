"""Looks into the document of a case file as the TOML reader returns it, however broken it is.

What is missing or wrong in itself is passed over: it is reported by its own key.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from catopt.casefile.location import Finding, missing, parts
from catopt.casefile.names import stands_for
from catopt.casefile.schema import (
    MOST_FINDINGS,
    MOST_LISTED,
    MOST_TABLES,
    CaseTable,
    Table,
    entries,
)
from catopt.documents import Path
from catopt.errors import InputError, Problem
from catopt.units import as_written


def table(document: dict[str, Any], key: str) -> dict[str, Any]:
    """Return a table; an empty one where there is none."""
    found = document.get(key)
    return found if isinstance(found, dict) else {}


@dataclass(frozen=True)
class Section:
    """A table of the document, with its schema and its path; of the whole file to begin with."""

    given: dict[str, Any]
    schema: type[Table] = CaseTable
    path: Path = ()

    def __contains__(self, key: str) -> bool:
        return key in self.given

    def table(self, key: str) -> Section:
        """Return a table in this one; an empty one where there is none."""
        inner = entries(self.schema)[key].table
        assert inner is not None
        return Section(table(self.given, key), inner, (*self.path, key))

    def tables(self, key: str) -> list[Section]:
        """List the tables of an array; none when one of them is no table, or they are too many."""
        inner, array = entries(self.schema)[key].table, self.given.get(key)
        assert inner is not None
        if not isinstance(array, list) or len(array) > MOST_TABLES:
            return []
        if not all(isinstance(each, dict) for each in array):
            return []
        return [Section(each, inner, (*self.path, key, k)) for k, each in enumerate(array)]

    def value(self, key: str) -> Any:
        """Return a value as the model takes it; None when it is missing or wrong in itself.

        An array gives a list, and None when one of its values is wrong.
        """
        entry, given = entries(self.schema)[key], self.given.get(key)
        if entry.kind is None or key not in self:
            return None
        try:
            if not entry.array:
                return entry.kind.read(given)
            if not isinstance(given, list) or len(given) > MOST_LISTED:
                return None
            return [entry.kind.read(each) for each in given]
        except InputError:
            return None

    def number(self, key: str) -> float | None:
        """Return a value in SI; None when it is missing or wrong in itself."""
        found = self.value(key)
        return found if isinstance(found, float) else None

    def values(self) -> dict[str, Any]:
        """Return what is given of the keys of the table; None of what cannot be read."""
        return {key: self.value(key) for key in entries(self.schema) if key in self}

    def misspelt(self, *keys: str) -> bool:
        """Whether a key, one of all where none is named, is there under another name.

        That is reported already.
        """
        known = entries(self.schema)
        unknown = [key for key in self.given if key not in known]
        if len(unknown) > MOST_FINDINGS:
            return True  # another kind of file, and reported as such
        return any(stands_for(self.schema, key) in (keys or known) for key in unknown)

    def lacks(self, *keys: str) -> bool:
        """Whether none of the keys is there, under its own or another name."""
        return not any(key in self for key in keys) and not self.misspelt(*keys)

    def wrong(self, key: str, allowed: str) -> Finding:
        """Note what a key has, and what is allowed."""
        return Finding((*self.path, key), as_written(self.given[key]), allowed)

    def missing(self, key: str, why: str) -> Finding:
        """Note that a key is missing."""
        return Finding((*self.path, key), "", missing(why))

    def refused(self, problems: Iterable[Problem]) -> Iterator[Finding]:
        """Place what the model refuses by its keys in this table, as the file has it there."""
        for problem in problems:
            below = parts(problem.key)
            finding = Finding(below, problem.found, problem.allowed)
            yield as_in_file(self.given, finding)._replace(path=(*self.path, *below))


def refusals(part: Callable[..., object], **given: Any) -> Sequence[Problem]:
    """List what a part of the model refuses in what is given."""
    try:
        part(**given)
    except InputError as error:
        return error.problems
    return ()


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
