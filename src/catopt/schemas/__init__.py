"""JSON Schemas (draft 2020-12) of the documents that the commands print with ``--json``."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any

from catopt.errors import InputError, Problem

__all__ = ["names", "schema"]


def names() -> tuple[str, ...]:
    """Names of all documents, such as ``"catopt.solution/1"``."""
    found = (entry.name for entry in files(__name__).iterdir())
    stems = sorted(name.removesuffix(".json") for name in found if name.endswith(".json"))
    return tuple("catopt." + stem.replace("-", "/") for stem in stems)


def schema(name: str) -> dict[str, Any]:
    """Read the schema of a document.

    Parameters
    ----------
    name : str
        What the document has under its key ``schema``.

    Raises
    ------
    InputError
        There is no such document.
    """
    if name not in names():
        raise InputError([Problem("name", repr(name), f"one of {', '.join(names())} is wanted")])
    resource = name.removeprefix("catopt.").replace("/", "-") + ".json"
    document: dict[str, Any] = json.loads(files(__name__).joinpath(resource).read_text("utf-8"))
    return document
