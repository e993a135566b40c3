"""Reads the tables of a file by their schema, with every fault of their form."""

from __future__ import annotations

from typing import Any, TypeVar

from catopt.casefile.location import Finding, header
from catopt.casefile.names import hint, stands_for
from catopt.casefile.schema import Entry, LoadTable, Table, entries
from catopt.documents import Path
from catopt.errors import InputError
from catopt.units import as_written

_MOST = 200
"""Findings of one file: a file with more has one fault, that it is another kind of file."""

AnyTable = TypeVar("AnyTable", bound=Table)


def read_tables(document: dict[str, Any], top: type[AnyTable]) -> tuple[AnyTable, list[Finding]]:
    """Read a document by the schema of the whole file, with what is wrong in its form.

    What is wrong is left out of the table, which is for use where nothing is.
    """
    reader = _Reader(top)
    table = reader.table((), top, document)
    return table, reader.findings[:_MOST]


class _Reader:
    def __init__(self, top: type[Table]) -> None:
        self.top = top
        self.findings: list[Finding] = []

    def table(self, path: Path, schema: type[AnyTable], given: dict[str, Any]) -> AnyTable:
        """Read a table.

        A missing key is not reported when an unknown key beside it is a misspelling of it, or
        belongs to a later version and would stand for it: one mistake, one message.
        """
        if len(self.findings) >= _MOST:
            return schema({})
        known = entries(schema)
        unknown = [key for key in given if key not in known]
        meant = {stands_for(schema, key, self.top) for key in unknown}
        read = {}
        for key, entry in known.items():
            here = (*path, key)
            if key in given:
                read[key] = self._entry(here, entry, given[key])
            elif entry.required and key not in meant:
                self.findings.append(Finding(here, "", f"missing; {_wanted(here, entry)}"))
        self.findings += (self._unknown(path, schema, key, given[key]) for key in unknown)
        return schema(read)

    def _entry(self, path: Path, entry: Entry, given: Any) -> Any:
        """Read what a key gives; an array as a list."""
        if not entry.array:
            return self._one(path, entry, given, _wanted(path, entry))
        if not isinstance(given, list):
            self._note(path, given, _wanted(path, entry))
            return None
        before, sound = len(self.findings), []
        for index, each in enumerate(given):
            noted = len(self.findings)
            one = self._one((*path, index), entry, each, "a table is wanted")
            sound += [one] if len(self.findings) == noted else []
        if len(sound) > entry.size.most:
            del self.findings[before:]
            most = f"; {entry.size.most} are the most"
            self._note(path, given, _wanted(path, entry) + most)
        elif len(self.findings) == before and len(sound) < entry.size.fewest:
            self._note(path, given, _wanted(path, entry))
        return sound

    def _one(self, path: Path, entry: Entry, given: Any, wanted: str) -> Any:
        """Read one value or one table."""
        if entry.kind is not None:
            try:
                return entry.kind.read(given)
            except InputError as error:
                self.findings += (Finding(path, p.found, p.allowed) for p in error.problems)
        elif entry.table is not None and isinstance(given, dict):
            return self.table(path, entry.table, given)
        else:
            self._note(path, given, wanted)
        return None

    def _note(self, path: Path, given: Any, allowed: str) -> None:
        self.findings.append(Finding(path, as_written(given), allowed))

    def _unknown(self, path: Path, schema: type[Table], key: str, given: Any) -> Finding:
        here = (*path, key)
        if key in schema.elsewhere:
            return Finding(here, as_written(given), schema.elsewhere[key])
        if key not in schema.later:
            return Finding(here, "an unknown key", hint(schema, key, self.top))
        advice = ""
        if instead := schema.later[key]:
            is_value = entries(schema)[instead].table is None
            name = instead if is_value else header((*path, instead))
            advice = f"; give {name} instead"
        return Finding(
            here, as_written(given), f"this version of catopt does not know it yet{advice}"
        )


def _wanted(path: Path, entry: Entry) -> str:
    if entry.kind is not None:
        return entry.kind.wanted + (", in brackets" if entry.array else "")
    line = header(path, array=entry.array)
    if entry.array:
        return f"write {line}, in double brackets, once for each"
    if entry.table is LoadTable:
        return f"a table {line} with one of {', '.join(entries(LoadTable))} is wanted"
    return f"a table {line} is wanted"
