"""JSON Schemas (draft 2020-12) of the documents that the commands print with ``--json``."""

from __future__ import annotations

import json
from importlib.resources import files
from pathlib import Path
from typing import Any

from catopt.documents import MOST_BYTES_OF_DATA, parse_json, read_text
from catopt.errors import InputError, Problem, refused
from catopt.words import Message

__all__ = ["CASE_DIGEST", "is_ours", "names", "read_any", "read_document", "schema"]

CASE_DIGEST = "case_sha256"
"""Key under which a document in a result directory has the SHA-256 of the case that it is of."""

_SHOWN = 10
"""Faults that are told of one document."""


def names() -> tuple[str, ...]:
    """Names of all documents, such as ``"catopt.solution/1"``."""
    found = (entry.name for entry in files(__name__).iterdir())
    stems = sorted(name.removesuffix(".json") for name in found if name.endswith(".json"))
    return tuple("catopt." + stem.replace("-", "/") for stem in stems)


def schema(name: str) -> dict[str, Any]:
    """Read the schema of a document that has a name under its key ``schema``.

    InputError when there is no such document.
    """
    if name not in names():
        allowed = Message("refused.one_of", words=", ".join(names()))
        raise refused("name", repr(name), allowed)
    resource = name.removeprefix("catopt.").replace("/", "-") + ".json"
    document: dict[str, Any] = json.loads(files(__name__).joinpath(resource).read_text("utf-8"))
    return document


def read_document(path: Path, name: str) -> dict[str, Any]:
    """Read a document that a command wrote, and hold it to the schema of a name.

    InputError when it cannot be read, is no JSON, or is not as its schema has it: with the path of
    every key at fault.
    """
    from catopt.schemas.validation import inconsistencies

    document = read_any(path)
    if document.get("schema") != name:
        wanted = Message("refused_command.wanted", name=name)
        raise refused("schema", repr(document.get("schema")), wanted, str(path))
    problems = list(inconsistencies(document, schema(name)))
    if len(problems) > _SHOWN:
        more = Message("refused_command.more_kind", problems=len(problems) - _SHOWN)
        problems[_SHOWN:] = [Problem("document", "", more)]
    if problems:
        raise InputError(problems, str(path))
    return document


def is_ours(document: dict[str, Any]) -> bool:
    """Whether a document says that catopt wrote it."""
    return str(document.get("schema", "")) in names()


def read_any(path: Path) -> dict[str, Any]:
    """Read a JSON document, whoever wrote it; InputError when it cannot be read or is no JSON."""
    text = read_text(path, str(path), kind="document", most=MOST_BYTES_OF_DATA)
    return parse_json(text, str(path))
