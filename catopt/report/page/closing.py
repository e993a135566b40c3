"""The end of the note: warnings, and the case file in full."""

from __future__ import annotations

from typing import Any, Protocol

from catopt.notes.origin import Origin
from catopt.render.texts import Words

__all__ = ["Made", "case_file", "warnings"]


class Made(Protocol):
    """What every kind of note has."""

    @property
    def origin(self) -> Origin:
        """The files that it rests on."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """What an engineer should know before using it."""


def warnings(note: Made, words: Words) -> dict[str, Any] | None:
    """List what an engineer should know; None where there is nothing to say."""
    if not note.warnings:
        return None
    return {"warnings": [words.sentence(warning) for warning in note.warnings]}


def case_file(note: Made, words: Words) -> dict[str, Any] | None:  # noqa: ARG001 - as all builders
    """Show the file as it was read; None where all was given by options."""
    return {"file": note.origin.files[0]} if note.origin.files else None
