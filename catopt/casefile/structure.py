"""Reads the tables of a file by their schema, with every fault of their form."""

from __future__ import annotations

from typing import Any, TypeVar

from catopt.casefile.location import Finding, header, missing
from catopt.casefile.names import hint, stands_for
from catopt.casefile.schema import MOST_FINDINGS, Entry, LoadTable, Table, entries
from catopt.documents import Path
from catopt.errors import InputError
from catopt.units import as_written
from catopt.words import Message

AnyTable = TypeVar("AnyTable", bound=Table)


def read_tables(document: dict[str, Any], top: type[AnyTable]) -> tuple[AnyTable, list[Finding]]:
    """Read a document by the schema of the whole file, with what is wrong in its form.

    What is wrong is left out of the table, which is for use where nothing is.
    """
    reader = _Reader(top)
    table = reader.table((), top, document)
    return table, reader.findings[:MOST_FINDINGS]


class _Reader:
    def __init__(self, top: type[Table]) -> None:
        self.top = top
        self.findings: list[Finding] = []

    def table(self, path: Path, schema: type[AnyTable], given: dict[str, Any]) -> AnyTable:
        """Read a table.

        A missing key is not reported when an unknown key beside it is a misspelling of it, or
        belongs to a later version and would stand for it: one mistake, one message.
        """
        if len(self.findings) >= MOST_FINDINGS:
            return schema({})
        known = entries(schema)
        unknown = [key for key in given if key not in known]
        if len(unknown) > MOST_FINDINGS:
            many = Message("refused.many_unknown_keys", count=len(unknown))
            self.findings.append(Finding((*path, unknown[0]), Message("refused.unknown_key"), many))
            return schema({})
        meant = {stands_for(schema, key, self.top) for key in unknown}
        read = {}
        for key, entry in known.items():
            here = (*path, key)
            if key in given:
                read[key] = self._entry(here, entry, given[key])
            elif entry.required and key not in meant:
                self.findings.append(Finding(here, "", missing(_wanted(here, entry))))
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
            one = self._one((*path, index), entry, each, Message("refused.table"))
            sound += [one] if len(self.findings) == noted else []
        if len(sound) > entry.size.most:
            del self.findings[before:]
            values = {"wanted": _wanted(path, entry), "most": entry.size.most}
            self._note(path, given, Message("refused.and_most", **values))
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
            return Finding(here, as_written(given), Message(schema.elsewhere[key]))
        if key not in schema.later:
            return Finding(here, Message("refused.unknown_key"), hint(schema, key, self.top))
        later = Message("refused.later")
        if instead := schema.later[key]:
            is_value = entries(schema)[instead].table is None
            name = instead if is_value else header((*path, instead))
            later = Message("refused.later_instead", name=name)
        return Finding(here, as_written(given), later)


def _wanted(path: Path, entry: Entry) -> str:
    if entry.kind is not None:
        said = entry.kind.wanted
        return Message("refused.in_brackets", wanted=said) if entry.array else said
    line = header(path, array=entry.array)
    if entry.array:
        return Message("refused.double_brackets", line=line)
    if entry.table is LoadTable:
        keys = ", ".join(entries(LoadTable))
        return Message("refused.table_with_one_of", line=line, keys=keys)
    return Message("refused.table_named", line=line)
