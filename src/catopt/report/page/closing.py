"""The end of the note: warnings, and the case file in full."""

from __future__ import annotations

from typing import Any

from catopt.report.page.note import Note
from catopt.report.texts import Words

__all__ = ["case_file", "warnings"]


def warnings(note: Note, words: Words) -> dict[str, Any] | None:
    """List what an engineer should know; None where there is nothing to say."""
    if not note.warnings:
        return None
    return {"warnings": [words.sentence(warning) for warning in note.warnings]}


def case_file(note: Note, words: Words) -> dict[str, Any]:  # noqa: ARG001 - as all builders
    """Show the case file as it was read."""
    return {"file": note.files[0]}
