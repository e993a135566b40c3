"""Where in a case file something stands."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

from catopt.documents import Path, dotted
from catopt.errors import InputError, Problem
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
    """Say that a key is missing, and what is wanted."""
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
        raise InputError([each.as_problem() for each in ordered], source)


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
