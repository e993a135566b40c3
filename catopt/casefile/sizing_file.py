"""Reads a file that ``catopt size`` takes: what it gives, and every mistake in it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path as FilePath
from types import MappingProxyType
from typing import Any, Final, Literal

from pydantic import ValidationError

from catopt.casefile.document import as_in_file, table, value
from catopt.casefile.location import Finding, in_order_of
from catopt.casefile.names import stands_for
from catopt.casefile.schema import Table, entries
from catopt.casefile.sizing_schema import BuoySizingTable, TankerSizingTable
from catopt.casefile.structure import structure_findings
from catopt.documents import Path, parse_toml, read_text
from catopt.errors import InputError, Problem

__all__ = [
    "SIZING",
    "Moored",
    "SizingFile",
    "moored_in",
    "not_a_case",
    "parse_sizing",
    "read_sizing",
]

Moored = Literal["buoy", "tanker"]
"""What is to be moored."""

SIZING: Final = "sizing.toml"
"""Usual name of a sizing file, as ``case.toml`` is of a case file."""

_SCHEMAS: Final[Mapping[Moored, type[Table]]] = MappingProxyType(
    {"buoy": BuoySizingTable, "tanker": TankerSizingTable}
)

_OF_A_CASE: Final = ("load", "load_cases", "design", "find", "pso", "catalogue")
"""Sections that only a case file has."""


_INSTEAD: Final[Mapping[Path, tuple[Path, ...]]] = MappingProxyType(
    {("buoy", "name"): (("buoy", "horizontal_force"), ("buoy", "reserve_buoyancy"))}
)
"""Keys that may stand in place of others."""


@dataclass(frozen=True)
class SizingFile:
    """What a file gives.

    Attributes
    ----------
    moored : {"buoy", "tanker"}
        Which of the two kinds of file it is.
    source : str
        Its name, for messages.
    folder : str
        That paths in it count from.
    document : dict
        As the TOML reader returns it.
    values : mapping of tuple to object
        Every value without fault by its path, in SI.
    findings : tuple of Finding
        What is wrong.
    """

    moored: Moored
    source: str
    folder: str
    document: dict[str, Any]
    values: Mapping[Path, Any]
    findings: tuple[Finding, ...]

    def text(self, key: str) -> str:
        """Return a text at the top of the file; empty where there is none."""
        return str(self.values.get((key,), ""))

    def is_told(self, path: Path) -> bool:
        """Say whether a fault of the key, of its table or of keys in its place is told already."""
        told = [*(finding.path for finding in self.findings), *self._misspelt()]
        keys = (path, *_INSTEAD.get(path, ()))
        return any(key[: len(each)] == each for key in keys for each in told)

    def error(self, problems: Iterable[tuple[Path | None, Problem]] = ()) -> InputError:
        """Make one error of what is wrong in the file and of what came out on the way from it.

        Parameters
        ----------
        problems : iterable of (tuple or None, Problem)
            Each with the path of its key; None: of an option.
        """
        found = list(self.findings)
        others = []
        for path, problem in problems:
            if path is None:
                others.append(problem)
            elif not self.is_told(path):
                at = Finding(path, problem.found, problem.allowed)
                found.append(as_in_file(self.document, at))
        ordered = in_order_of(self.document, list(dict.fromkeys(found)))
        return InputError([*(each.as_problem() for each in ordered), *others], self.source)

    def _misspelt(self) -> Iterator[Path]:
        """List the keys that were meant by unknown ones."""
        top = _SCHEMAS[self.moored]
        for finding in self.findings:
            *above, key = finding.path
            schema: type[Table] | None = top
            for part in above:
                entry = None if schema is None else entries(schema).get(str(part))
                schema = None if entry is None else entry.table
            if schema is not None and str(key) not in entries(schema):
                meant = stands_for(schema, str(key), top)
                if meant is not None:
                    yield (*above, meant)


def moored_in(path: str | os.PathLike[str]) -> Moored | None:
    """Say what a file is to find the mooring of; None for a case file and for what is no TOML.

    Parameters
    ----------
    path : str or path
        Of any file.
    """
    try:
        document = parse_toml(read_text(FilePath(path), os.fspath(path)), os.fspath(path))
    except InputError:
        return None
    return _moored(document)


def not_a_case(document: dict[str, Any]) -> Problem | None:
    """Say of a document that is no case but a file for ``catopt size``, where it belongs.

    Parameters
    ----------
    document : dict
        As the TOML reader returns it.
    """
    moored = _moored(document)
    if moored is None:
        return None
    key = next(key for key in ("ship", "environment", "buoy") if key in document)
    allowed = (
        f"this file is for catopt size {moored}, which finds the line; with --save it writes a "
        "case file for the other commands"
    )
    return Problem(key, f"[{key}]", allowed)


def _moored(document: dict[str, Any]) -> Moored | None:
    has_line = "segments" in table(document, "line")
    if has_line or any(key in document for key in _OF_A_CASE):
        return None
    if "ship" in document:
        return "tanker"
    is_found = "environment" in document or {"name", "horizontal_force"} & {
        *table(document, "buoy")
    }
    return "buoy" if is_found else None


def read_sizing(path: str | os.PathLike[str], moored: Moored) -> SizingFile:
    """Read a file.

    Parameters
    ----------
    path : str or path
        The file, TOML in UTF-8.
    moored : {"buoy", "tanker"}
        Which of the two kinds of file it is.

    Raises
    ------
    InputError
        When it cannot be read, is no TOML or a file for something else. What else is wrong
        stands in its ``findings``.
    """
    source = os.fspath(path)
    text = read_text(FilePath(path), source)
    return parse_sizing(text, moored, source, folder=str(FilePath(path).parent))


def parse_sizing(text: str, moored: Moored, source: str = "", *, folder: str = "") -> SizingFile:
    """Read the text of a file; see `read_sizing`.

    Parameters
    ----------
    text : str
        TOML.
    moored : {"buoy", "tanker"}
        Which of the two kinds of file it is.
    source : str
        Its name, for messages.
    folder : str
        That paths in it count from; the working directory when left out.
    """
    document = parse_toml(text, source)
    other = _of_another_kind(document, moored)
    if other:
        raise InputError([other.as_problem()], source)
    schema = _SCHEMAS[moored]
    findings: list[Finding] = []
    try:
        schema.model_validate(document)
    except ValidationError as error:
        findings += structure_findings(error.errors(include_url=False), schema)
    findings += _contradictions(document, moored)
    values = MappingProxyType(dict(_values(schema, document)))
    return SizingFile(moored, source, folder, document, values, tuple(findings))


def _of_another_kind(document: dict[str, Any], moored: Moored) -> Finding | None:
    """Say what the file is for, when it is not for this."""
    if moored == "buoy" and "ship" in document:
        return Finding(("ship",), "a ship", "this file is for catopt size tanker")
    for key in _OF_A_CASE:
        if key in document:
            allowed = "this is a case file, for catopt solve, check and design: its line is known"
            return Finding((key,), f"[{key}]", allowed)
    return None


def _contradictions(document: dict[str, Any], moored: Moored) -> Iterator[Finding]:
    """List what does not go together: one of the two would be left out of account."""
    if moored == "tanker":
        if "anchor" in document and "sinker" in document:
            advice = "leave out [sinker] or [anchor]: the line is held by one of them"
            yield Finding(("sinker",), "[anchor] beside it", advice)
        return
    buoy, weather = table(document, "buoy"), table(document, "environment")
    if "name" in buoy and "keel_depth" in buoy:
        allowed = "leave it out, or name: it follows from the shape of the named buoy"
        yield as_in_file(document, Finding(("buoy", "keel_depth"), "", allowed))
    if "horizontal_force" in buoy and "name" not in buoy:
        for key in ("wind", "current", "marine_growth"):
            if key in weather:
                allowed = "leave it out, or buoy.horizontal_force, which has it all in it"
                yield as_in_file(document, Finding(("environment", key), "", allowed))


def _values(
    schema: type[Table], given: dict[str, Any], above: Path = ()
) -> Iterator[tuple[Path, Any]]:
    """List every value of a table and of those in it that is right in itself."""
    for key, entry in entries(schema).items():
        if entry.table is not None and isinstance(given.get(key), dict):
            yield from _values(entry.table, given[key], (*above, key))
        read = value(schema, key, given)
        if read is not None:
            yield (*above, key), read
