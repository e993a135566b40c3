"""What the note rests on: the parts of the lines, and every value of the case file."""

from __future__ import annotations

from typing import Any

from catopt.casefile.schema import CaseTable
from catopt.notes.system import SystemNote
from catopt.render.texts import Words
from catopt.report.page.components import parts_of
from catopt.report.page.inputs import inputs_table

__all__ = ["components", "inputs"]


def components(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the tables of what the lines are made of; a case file has all of them alike."""
    return parts_of(note.case, note.case.line, words)


def inputs(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the table of inputs."""
    return {"table": inputs_table(note.origin.inputs, CaseTable, words), "design": None}
