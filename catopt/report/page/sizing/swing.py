"""The swing radius with its parts."""

from __future__ import annotations

from typing import Any

from catopt.notes.size import SizeNote
from catopt.quantities import QUANTITIES
from catopt.render.texts import Words
from catopt.report.page.sizing.load_case import load_case_words
from catopt.report.page.table import Cell, Heading, Table, measured, number_heading

__all__ = ["PARTS", "swing"]


PARTS = {
    "line at low water": "size_swing.line",
    "offset of the body": "size_swing.body",
    "hawser": "size_swing.hawser",
    "ship": "size_swing.ship",
}
"""Keys of what the parts are called."""


def swing(note: SizeNote, words: Words) -> dict[str, Any]:
    """Build the table of the parts and their sum."""
    found = note.sizing.swing
    length = QUANTITIES["length"]
    rows = [
        (Cell(words(PARTS[name]), style="words"), measured(length, value))
        for name, value in found.parts
    ]
    total = (Cell(words("size_swing.total"), style="words"), measured(length, found.total))
    headings = (
        Heading(words("size_swing.part")),
        number_heading(words("size_swing.length"), length),
    )
    caption = words("checks.under", name=load_case_words(found.load_case, words))
    excursion = note.sizing.excursion
    return {
        "table": Table("size_swing", headings, (*rows, total), caption, len(rows)),
        "excursion": None if excursion is None else length.format(excursion, unit=True),
        "of_body": note.sizing.pattern is not None,
    }
