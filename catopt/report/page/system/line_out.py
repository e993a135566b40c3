"""One line out: the system without each of its lines, at rest again under the same load."""

from __future__ import annotations

from typing import Any

from catopt.notes.system import SystemNote
from catopt.render.texts import Words
from catopt.report.page.system.watch_circle import response_cells, response_headings
from catopt.report.page.table import Cell, Heading, Table
from catopt.ties import first_largest

__all__ = ["line_out"]


def line_out(note: SystemNote, words: Words) -> dict[str, Any] | None:
    """Build the table, and say why the body does not come to rest without a line."""
    gone = note.report.line_out
    if not gone:
        return None
    rows = []
    for each, used in zip(gone, note.left, strict=True):
        shown = Cell("–" if used is None else f"{used:.3f}", used, bar=used)
        rows.append((Cell(str(each.missing + 1)), *response_cells(each.response), shown))
    headings = (
        Heading(words("system_line_out.gone")),
        *response_headings(words),
        Heading(words("checks.utilisation"), is_number=True),
    )
    tensions = [0.0 if each.response is None else each.response.largest_tension for each in gone]
    worst = first_largest(tensions) if any(tensions) else None
    refused = [
        (words("system_line_out.refused", line=each.missing + 1), words.sentence(each.refusal))
        for each in gone
        if each.response is None
    ]
    return {
        "table": Table("line_out", headings, tuple(rows), marked=worst),
        "refused": refused,
    }
