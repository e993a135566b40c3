"""Notes of every kind by their names, each computed once."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import pytest

from catopt.answers.blocks import Answer
from catopt.cli.note_kind import answer_of
from catopt.notes.line import read_note
from catopt.words import Language

from . import further_cases, page_cases, size_page_cases, system_page_cases
from .page_reader import ReadPage, read_page
from .rendered import page_of

if TYPE_CHECKING:
    from catopt.cli.note_kind import AnyNote

OF_A_LINE = ("leg", "states", "slack", "friction", "designed")
FURTHER = ("swarm", "harmonic", "random")
OF_A_BODY = ("arms", "raised", "idle", "pulled", "lone")
SIZINGS = ("size-buoy", "given", "hawser", "six", "sinker")
NOTES = (*OF_A_LINE, *FURTHER, *OF_A_BODY, *SIZINGS)
LONG = ("leg", "states", "harmonic", "random", "arms", "raised", "pulled", "hawser", "six")
"""They take seconds each; in motion, and verified under many loads."""


def each_note(names: Sequence[str] = NOTES) -> list[Any]:
    """List notes, with those that take long among the slow tests."""
    return [pytest.param(name, marks=pytest.mark.slow) if name in LONG else name for name in names]


@cache
def note_named(name: str) -> AnyNote:
    """Compute the note of a line, of a body or of a sizing."""
    if name == "designed":
        with TemporaryDirectory() as folder:
            return read_note(page_cases.design_directory(Path(folder)))
    if name in FURTHER:
        return further_cases.further_note(name)
    if name in OF_A_BODY:
        return system_page_cases.known_note(name)
    if name in size_page_cases.EVERY:
        return size_page_cases.known_size_note(name)
    return page_cases.known_note(name)


@cache
def answer_named(name: str) -> Answer:
    """Lay a note out."""
    return answer_of(note_named(name))


@cache
def page_named(name: str, language: Language = "en") -> ReadPage:
    """Read the page of a note back."""
    return read_page(page_of(note_named(name), language))
