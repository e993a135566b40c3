"""Notes of every kind by their names, each computed once, with their pages and workbooks."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from catopt.answers.blocks import Answer
from catopt.casefile.reading import moored_in
from catopt.cli.note_kind import answer_of, has_table, note_of_sizing
from catopt.errors import NotConvergedError
from catopt.notes.line import Note, SizeNote, read_note
from catopt.notes.system import SystemNote, read_system_note
from catopt.render.page import page
from catopt.render.workbook import workbook
from catopt.words import Language

from .page_reader import ReadPage, read_page

CASES = Path(__file__).parents[2] / "cases"
"""Case files that come with catopt."""
OWN = Path(__file__).parent / "cases"
"""Case files and sizing files beside these tests, each of a line that hangs in another way."""
RESULT = OWN / "result"
"""A directory as ``catopt design --out`` writes it, with a front of three designs by hand."""

TURRET = "fso-rang-dong"
"""Nine lines in three bundles, force along one of them."""
SHIPPED = ("buoy-9.5m", "buoy-9.5m-slack", "ship-200m-sinker", "tanker-20m", "tanker-20m-sinker")
LINES = (*SHIPPED, "leg", "raised", "slack", "friction", "states")
IN_MOTION = ("harmonic", "random")
"""Two load cases in two seas each, led by a ship."""
MOVING = (*IN_MOTION, "regular", "recorded", "overloaded", "by-code", "one-draw", "sought")
OWN_BODIES = ("arms", "raised-anchors", "idle", "pulled", "lone")
BODIES = (TURRET, "lee", *OWN_BODIES)
OWN_SIZINGS = ("given", "hawser", "six", "sinker")
SIZINGS = ("size-buoy", "size-tanker", *OWN_SIZINGS)
OF_LINES = ("leg", "states", "slack", "friction", "designed", "swarm", *IN_MOTION)
NOTES = (*OF_LINES, *OWN_BODIES, "size-buoy", *OWN_SIZINGS)
"""Notes of every kind, of which every face is looked at."""
LONG = ("leg", "states", *IN_MOTION, "arms", "raised-anchors", "pulled", "hawser", "six")
"""They take seconds each; in motion, and verified under many loads."""


def case_path(name: str) -> Path:
    """Return the path of a case, or of the directory of a design search."""
    if name == "designed":
        return RESULT
    own = OWN / f"{name}.toml"
    return own if own.exists() else next((CASES / name).glob("*.toml"))


def each_note(names: Sequence[str] = NOTES) -> list[Any]:
    """List notes, with those that take long among the slow tests."""
    return [pytest.param(name, marks=pytest.mark.slow) if name in LONG else name for name in names]


@cache
def note_named(name: str) -> Any:
    """Compute the note of a line, of a body or of a sizing: who names it knows its kind."""
    path = case_path(name)
    moored = moored_in(path)
    if moored is not None:
        return note_of_sizing(path, moored)
    if has_table(path, "system"):
        return read_system_note(path)
    if name in (*MOVING, "swarm"):
        return read_note(path, swarm=name == "swarm", motion=name != "swarm", verify=False)
    return read_note(path)


def body_note(name: str) -> SystemNote:
    """Return the note of a moored body."""
    note: SystemNote = note_named(name)
    return note


def stop(monkeypatch: pytest.MonkeyPatch, place: str, why: str) -> None:
    """Let a solver have no answer."""

    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError(why)

    monkeypatch.setattr(place, stops)


@cache
def answer_named(name: str) -> Answer:
    """Lay a note out."""
    return answer_of(note_named(name))


@cache
def page_named(name: str, language: Language = "en") -> ReadPage:
    """Read the page of a note back."""
    return shown(note_named(name), language)


def shown(note: Note | SystemNote | SizeNote, language: Language = "en") -> ReadPage:
    """Read the page of any note back."""
    return read_page(page_of(note, language))


def page_of(note: Note | SystemNote | SizeNote, language: Language = "en") -> bytes:
    """Render the page of a note."""
    return page(answer_of(note), language)


def workbook_of(note: Note | SystemNote | SizeNote, language: Language = "en") -> bytes:
    """Lay the workbook of a note out."""
    return workbook(answer_of(note), language)
