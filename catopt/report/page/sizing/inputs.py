"""What a sizing was given: the keys of its file, and the options that were typed."""

from __future__ import annotations

from typing import Any

from catopt.casefile.schema import Table as Schema
from catopt.casefile.sizing_schema import BuoySizingTable, TankerSizingTable
from catopt.notes.size import SizeNote
from catopt.render.texts import Words
from catopt.report.page.inputs import inputs_table
from catopt.report.page.table import Cell, Heading, Table

__all__ = ["inputs", "schema_of"]


def schema_of(note: SizeNote) -> type[Schema]:
    """Return what the file of the sizing may hold."""
    return TankerSizingTable if note.sizing.kind == "tanker" else BuoySizingTable


def inputs(note: SizeNote, words: Words) -> dict[str, Any]:
    """Build the tables of the file's values and of the options."""
    has_file = bool(note.origin.files)
    table = inputs_table(note.origin.inputs, schema_of(note), words) if has_file else None
    return {"table": table, "options": _options(note, words) if note.options else None}


def _options(note: SizeNote, words: Words) -> Table:
    headings = (Heading(words("size_inputs.option")), Heading(words("inputs.given")))
    rows = tuple((Cell(name), Cell(value)) for name, value in note.options)
    return Table("size_options", headings, rows, words("size_inputs.typed"))
