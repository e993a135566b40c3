"""Which file is one for ``catopt size``, and what it is to find the mooring of."""

from __future__ import annotations

import os
from pathlib import Path as FilePath
from typing import Any, Final, Literal

from catopt.casefile.document import table
from catopt.documents import parse_toml, read_text
from catopt.errors import InputError, Problem
from catopt.words import Message

Moored = Literal["buoy", "tanker"]
"""What is to be moored."""

SIZING: Final = "sizing.toml"
"""Usual name of a sizing file, as ``case.toml`` is of a case file."""

_OF_A_CASE: Final = ("load", "load_cases", "design", "find", "pso", "catalogue")
"""Sections that only a case file has."""


def moored_in(path: str | os.PathLike[str]) -> Moored | None:
    """Say what a file is to find the mooring of; None for a case file and for what is no TOML."""
    try:
        document = parse_toml(read_text(FilePath(path), os.fspath(path)), os.fspath(path))
    except InputError:
        return None
    return moored_of(document)


def not_a_case(document: dict[str, Any]) -> Problem | None:
    """Say of a document that is no case but a file for ``catopt size``, where it belongs."""
    moored = moored_of(document)
    if moored is None:
        return None
    key = next(key for key in ("ship", "environment", "buoy") if key in document)
    allowed = Message("refused.for_size", moored=moored)
    return Problem(key, f"[{key}]", allowed)


def case_key(document: dict[str, Any]) -> tuple[str, ...]:
    """Find a key that only a case file has; empty where there is none."""
    known = next((key for key in _OF_A_CASE if key in document), None)
    if known is not None:
        return (known,)
    return ("line", "segments") if "segments" in table(document, "line") else ()


def moored_of(document: dict[str, Any]) -> Moored | None:
    """Say what a document of a file is to find the mooring of; None for that of a case."""
    if case_key(document):
        return None
    if "ship" in document:
        return "tanker"
    is_found = "environment" in document or {"name", "horizontal_force"} & {
        *table(document, "buoy")
    }
    return "buoy" if is_found else None
