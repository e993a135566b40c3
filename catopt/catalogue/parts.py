"""Reads catopt's own files of anchors and fittings, which name the sources of the catalogue."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.resources import files
from typing import Any

from catopt.catalogue.figure import CONFIDENCES, Source
from catopt.catalogue.reading import own_sources
from catopt.catalogue.table import Table
from catopt.model.validity import Findings


def read_own(
    name: str, schema: str, keys: Sequence[str]
) -> tuple[Table, Findings, dict[str, Source]]:
    """Open one of catopt's own data files, with what is wrong with it and the sources by key."""
    text = files("catopt.catalogue").joinpath("data", name).read_text(encoding="utf-8")
    document, findings = Table.of_file(text, f"catopt's {name}", schema, keys)
    return document, findings, own_sources()


def cited(table: Table, sources: dict[str, Source]) -> dict[str, Any]:
    """Read where an entry comes from: sources, place and confidence."""
    return {
        "sources": tuple(sources[key] for key in table.texts("source", required=True)),
        "place": table.cited("place") or "",
        "confidence": table.word("confidence", CONFIDENCES) or CONFIDENCES[-1],
    }
