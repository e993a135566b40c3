"""Title block: what is calculated, from which file, by which version."""

from __future__ import annotations

from typing import Any

from catopt.report.check_words import verdict_sentence
from catopt.report.page.note import Note
from catopt.report.page.table import Cell, Heading, Table, said
from catopt.report.texts import Words
from catopt.report.words import METHODS, REGIMES

__all__ = ["identity"]


def identity(note: Note, words: Words) -> dict[str, Any]:
    """Build the title block."""
    rows = [
        ("identity.source", Cell(note.case.source)),
        ("identity.date", Cell(note.date)),
        ("identity.load_case", Cell(_load_case(note))),
        ("identity.design", Cell("" if note.chosen is None else str(note.chosen.number))),
        ("identity.regime", said(words.sentence(REGIMES[note.solution.regime]))),
        ("identity.method", Cell(words.name(METHODS[note.solution.method]))),
        ("identity.version", Cell(f"catopt {note.version}")),
        *((
            "identity.file", Cell(f"{file.name}, SHA-256 {file.sha256}", style="hash")
        ) for file in note.files),
    ]  # fmt: skip
    laid = tuple((Cell(words(key)), cell) for key, cell in rows if cell.text)
    headings = (Heading(words("table.what")), Heading(words("table.words")))
    verdict = words.sentence(verdict_sentence(note.checks)) if note.checks.results else None
    return {
        "table": Table("identity", headings, laid),
        "verdict": verdict,
        "passes": note.checks.passes,
    }


def _load_case(note: Note) -> str:
    return note.load_case if note.case.load is not None else ""
