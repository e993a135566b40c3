"""Title block: what is calculated, from which file, by which version."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from catopt.answers.check import verdict_sentence
from catopt.notes.line import Note
from catopt.notes.origin import Origin
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, said
from catopt.report.wording.names import METHODS, how_it_hangs

__all__ = ["identity", "made_from", "title_block"]


def identity(note: Note, words: Words) -> dict[str, Any]:
    """Build the title block."""
    rows = [
        ("identity.source", Cell(note.case.source)),
        ("identity.date", Cell(note.origin.date)),
        ("identity.load_case", Cell(_load_case(note))),
        ("identity.design", Cell("" if note.chosen is None else str(note.chosen.number))),
        ("identity.regime", said(words.sentence(how_it_hangs(note.solution)))),
        ("identity.method", Cell(words.name(METHODS[note.solution.method]))),
        *made_from(note.origin),
    ]
    verdict = words.sentence(verdict_sentence(note.checks)) if note.checks.results else None
    return {
        "table": title_block(rows, words),
        "verdict": verdict,
        "passes": note.checks.passes,
    }


def made_from(origin: Origin) -> list[tuple[str, Cell]]:
    """List version and files by the keys of what they are called."""
    files = [f"{file.name}, SHA-256 {file.sha256}" for file in origin.files]
    return [
        ("identity.version", Cell(f"catopt {origin.version}")),
        *(("identity.file", Cell(text, style="hash")) for text in files),
    ]


def title_block(rows: Sequence[tuple[str, Cell]], words: Words) -> Table:
    """Lay the title block out; a row that says nothing is left out.

    Parameters
    ----------
    rows : sequence of (str, Cell)
        Key of what it is called, and what is said.
    words : Words
        Language.
    """
    laid = tuple((Cell(words(key)), cell) for key, cell in rows if cell.text)
    headings = (Heading(words("table.what")), Heading(words("table.words")))
    return Table("identity", headings, laid)


def _load_case(note: Note) -> str:
    return note.load_case if note.case.load is not None else ""
