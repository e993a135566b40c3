"""What notes say: said/*.txt, by the note and by one of its sections or tables.

The lines below ``NOTE > SECTION`` are found in its text, those after ``!`` are not. ``[STYLE]``
begins all that the section has of a style, one after another. Of a table, ``A | B`` are the first
cells of a row, and of a ``(whole)`` one all rows stand there; ``{2.0}`` is the value behind a cell,
to its last digit. A ``*`` stands for anything; ``# slow`` goes before a note that takes long.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

import pytest

from .notes import page_named
from .page_reader import ReadCell

SAID = Path(__file__).parent / "said"


def blocks() -> Iterator[Any]:
    """Yield what is said in the notes of lines, bodies and sizings, and of motion."""
    told = (path.read_text("utf-8").rstrip("\n") for path in sorted(SAID.glob("*.txt")))
    for block in "\n\n".join(told).split("\n\n"):
        heading, *lines = (each for each in block.split("\n") if not each.startswith("# "))
        marks = [pytest.mark.slow] if block.startswith("# slow") else []
        yield pytest.param(*heading.split(" > "), lines, id=heading, marks=marks)


@pytest.mark.parametrize(("name", "place", "lines"), list(blocks()))
def test_what_is_said(name: str, place: str, lines: list[str]) -> None:
    page = page_named(name)
    key, *whole = place.split(" (")
    if whole or " | " in lines[0]:
        told_in_table(page.table(key).rows, [each.split(" | ") for each in lines], bool(whole))
        return
    text = page.sections[place].replace("\N{NO-BREAK SPACE}", " ")
    styled: dict[str, list[str]] = {}
    for line in lines:
        if found := re.match(r"\[(\w+)\] (.*)", line):
            styled.setdefault(found[1], []).append(found[2])
        elif line.startswith("! "):
            assert line[2:] not in text
        else:
            assert line in text
    for style, wanted in styled.items():
        for each, words in zip(page.styled(style, place), wanted, strict=True):
            assert fnmatchcase(each.text, words)


def told_in_table(rows: list[list[ReadCell]], told: list[list[str]], whole: bool) -> None:
    if whole:
        assert [len(row) for row in rows] == [len(wanted) for wanted in told]
        assert all(map(is_told, rows, told))
    for wanted in told:
        assert any(is_told(row, wanted) for row in rows), wanted


def is_told(row: list[ReadCell], wanted: list[str]) -> bool:
    """Compare the first cells of a row, by what they show or by the values behind them."""
    return len(row) >= len(wanted) and all(
        cell.value == float(each[1:-1]) if each.startswith("{") else fnmatchcase(cell.text, each)
        for cell, each in zip(row, wanted, strict=False)
    )
