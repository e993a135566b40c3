"""Looks into the document of a file as the TOML reader returns it, however broken it is."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeVar

from catopt.casefile.schema import (
    MOST_FINDINGS,
    MOST_LISTED,
    MOST_TABLES,
    CaseTable,
    Entry,
    LoadTable,
    TableSchema,
    VariantsTable,
    entries,
)
from catopt.documents import Path, dotted
from catopt.errors import InputError, Problem
from catopt.model.plausible_ranges import NAMES, accepting
from catopt.units import as_written
from catopt.words import Message


class Finding(NamedTuple):
    """A problem that still knows its path."""

    path: Path
    found: str
    allowed: str

    def as_problem(self) -> Problem:
        """Return it as the caller gets to see it."""
        return Problem(dotted(self.path), self.found, self.allowed)


def parts(key: str) -> Path:
    """Read ``line.segments[0].length`` as a path; for the model's own keys, which are bare."""
    found = re.findall(r"\[(\d+)\]|([^.\[\]]+)", key)
    return tuple(int(index) if index else name for index, name in found)


def missing(wanted: str) -> Message:
    """Say that a key is missing, and what is required."""
    return Message("refused.missing", wanted=wanted)


def header(path: Path, *, array: bool = False) -> str:
    """Write the line that opens a table: ``[site]``, or ``[[line.segments]]`` for an array."""
    if not path:
        return Message("refused.top_of_file")
    name = dotted(tuple(part for part in path if isinstance(part, str)))
    return f"[[{name}]]" if array else f"[{name}]"


def refuse(document: dict[str, Any], findings: list[Finding], source: str) -> None:
    """Raise InputError if there are findings: with each of them once, in the file's order."""
    if findings:
        ordered = in_order_of(document, list(dict.fromkeys(findings)))
        raise InputError([finding.as_problem() for finding in ordered], source)


def in_order_of(document: dict[str, Any], findings: list[Finding]) -> list[Finding]:
    """Sort findings as their keys stand in the document; missing keys last in their table."""
    return sorted(findings, key=lambda finding: _rank(document, finding.path))


def _rank(document: dict[str, Any], path: Path) -> tuple[int, ...]:
    rank: list[int] = []
    place: Any = document
    for part in path:
        if isinstance(part, int):
            rank.append(part)
            place = place[part] if isinstance(place, list) and part < len(place) else None
        else:
            keys = list(place) if isinstance(place, dict) else []
            rank.append(keys.index(part) if part in keys else len(keys))
            place = place.get(part) if isinstance(place, dict) else None
    return tuple(rank)


_SIMILAR = 0.6
"""Share of letters in common (difflib's ratio) from which a key counts as misspelt."""

_SHORT = 4
"""Letters of a word that is another word when its first letter is another: wind is not find."""


def stands_for(
    table: type[TableSchema], key: str, top: type[TableSchema] = CaseTable
) -> str | None:
    """Return the key of `table` that `key` is a misspelling of or the symbol for, if any.

    `top` is the schema of the whole file.
    """
    own = list(entries(table))
    if key in table.symbols:
        return table.symbols[key]
    plain, by_plain = _plain(key), {_plain(known): known for known in own}
    if plain in by_plain:
        return by_plain[plain]
    alike = [own for own in by_plain if plain in (f"{own}s", own.removesuffix("s"))]
    if len(alike) == 1:
        return by_plain[alike[0]]  # one of several, or several of one
    longer = [known for known in own if known.endswith(f"_{plain}")]
    if len(longer) == 1:
        return longer[0]  # friction for seabed_friction
    begun = [known for known in own if len(plain) > 2 and known.startswith(plain)]
    if len(begun) == 1:
        return begun[0]  # seg for segment
    if any(_elsewhere(key, top)):
        return None  # right elsewhere, so hardly a misspelling
    from difflib import get_close_matches

    likely = [known for known in by_plain if len(plain) > _SHORT or known[1:] != plain[1:]]
    close = get_close_matches(plain, likely, n=1, cutoff=_SIMILAR)
    return by_plain[close[0]] if close else None


def hint(table: type[TableSchema], key: str, top: type[TableSchema] = CaseTable) -> str:
    """Say what to do about a key that `table` does not have."""
    near = stands_for(table, key, top)
    if near is not None:
        return Message("refused.did_you_mean", near=near)
    places = list(_elsewhere(key, top))
    if places:
        *others, last = places
        if not others:
            return Message("refused.move", place=last)
        return Message("refused.move_or", places=", ".join(others), last=last)
    return Message("refused.allowed_here", keys=", ".join(entries(table)))


def _plain(key: str) -> str:
    return key.casefold().replace("-", "_").replace(" ", "_")


def _elsewhere(
    key: str, table: type[TableSchema], path: Path = (), *, array: bool = False
) -> Iterator[str]:
    """List the tables in which `key` would be right, by the lines that open them."""
    for name, entry in entries(table).items():
        below = (*path, name)
        if table is VariantsTable:
            continue  # its keys are names of quantities
        if name == key:
            is_table = entry.table is not None
            yield header(below, array=entry.array) if is_table else header(path, array=array)
        if entry.table is not None:
            yield from _elsewhere(key, entry.table, below, array=entry.array)


AnyTable = TypeVar("AnyTable", bound=TableSchema)


def read_tables(document: dict[str, Any], top: type[AnyTable]) -> tuple[AnyTable, list[Finding]]:
    """Read a document by the schema of the whole file, with what is wrong in its form.

    What is wrong is left out of the table, which is for use where nothing is.
    """
    reader = _Reader(top)
    table = reader.table((), top, document)
    return table, reader.findings[:MOST_FINDINGS]


class _Reader:
    def __init__(self, top: type[TableSchema]) -> None:
        self.top = top
        self.findings: list[Finding] = []

    def table(self, path: Path, schema: type[AnyTable], given: dict[str, Any]) -> AnyTable:
        """Read a table.

        A missing key is not reported when an unknown key beside it is a misspelling of it: one
        mistake, one message.
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
        for key in unknown:
            if key in schema.elsewhere:
                self._note((*path, key), given[key], Message(schema.elsewhere[key]))
            else:
                why = hint(schema, key, self.top)
                self.findings.append(Finding((*path, key), Message("refused.unknown_key"), why))
        return schema(read)

    def _entry(self, path: Path, entry: Entry, given: Any) -> Any:
        """Read what a key gives; an array as a list."""
        if not entry.array:
            return self._one(path, entry, given, _wanted(path, entry))
        if not isinstance(given, list):
            self._note(path, given, _wanted(path, entry))
            return None
        before, sound = len(self.findings), []
        for index, item in enumerate(given):
            noted = len(self.findings)
            one = self._one((*path, index), entry, item, Message("refused.table"))
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


def table(document: dict[str, Any], key: str) -> dict[str, Any]:
    """Return a table; an empty one where there is none."""
    found = document.get(key)
    return found if isinstance(found, dict) else {}


@dataclass(frozen=True)
class FileSection:
    """A table of the document, with its schema and its path; of the whole file to begin with."""

    given: dict[str, Any]
    schema: type[TableSchema] = CaseTable
    path: Path = ()

    def __contains__(self, key: str) -> bool:
        return key in self.given

    def table(self, key: str) -> FileSection:
        """Return a table in this one; an empty one where there is none."""
        inner = entries(self.schema)[key].table
        assert inner is not None
        return FileSection(table(self.given, key), inner, (*self.path, key))

    def tables(self, key: str) -> list[FileSection]:
        """List the tables of an array; none when one of them is no table, or they are too many."""
        inner, array = entries(self.schema)[key].table, self.given.get(key)
        assert inner is not None
        if not isinstance(array, list) or len(array) > MOST_TABLES:
            return []
        if not all(isinstance(item, dict) for item in array):
            return []
        return [FileSection(item, inner, (*self.path, key, k)) for k, item in enumerate(array)]

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
            return [entry.kind.read(item) for item in given]
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
    """List what a part of the model refuses in what is given, implausible values apart."""
    try:
        with accepting(NAMES):  # those are told with the others of a file
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
