"""The body and all its lines by the truss model, beside the closed form."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.notes.system import SystemNote
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table
from catopt.report.page.verification import (
    compared_table,
    difference_cell,
    mesh_table,
    rough_words,
)
from catopt.report.tables.verify import QUANTITY_OF, part_sentence
from catopt.verify.compared import worst_of

if TYPE_CHECKING:
    from catopt.verify.result import StaticComparison

__all__ = ["verification"]


def verification(note: SystemNote, words: Words) -> dict[str, Any] | None:
    """Build the tables of both models, or say that there is no answer; None where left out.

    The body and the most loaded line stand in full, every other line with its largest difference.
    """
    if note.verification_failure:
        return {"failure": words.sentence(note.verification_failure)}
    part = note.compared
    if part is None:
        return None
    loaded = note.solution.most_loaded
    body = [each for each in part.quantities if each.line is None]
    line = [each for each in part.quantities if each.line == loaded]
    return {
        "failure": None,
        "verdict": words.sentence(part_sentence(part)),
        "agrees": part.is_settled,
        "body": compared_table(body, words, words("system_verification.body")),
        "line": compared_table(line, words, words("system_verification.line", line=loaded + 1)),
        "lines": _lines(part, words),
        "meshes": mesh_table(part, words),
        "rough": rough_words(part, words),
        "remarks": [words.sentence(remark) for remark in part.remarks],
    }


def _lines(part: StaticComparison, words: Words) -> Table:
    """Tabulate the largest difference of each line."""
    rows = []
    for index in range(len(part.lines)):
        own = [each for each in part.quantities if each.line == index]
        worst = worst_of(own)
        agrees = all(each.agrees for each in own)
        rows.append(
            (
                Cell(str(index + 1)),
                Cell(words.name(QUANTITY_OF[worst.quantity].name)),
                difference_cell(worst.gap),
                Cell(
                    words("verification.agrees" if agrees else "verification.differs"),
                    style="passes" if agrees else "fails",
                ),
            )
        )
    headings = (
        Heading(words("system_lines.line")),
        Heading(words("workbook.quantity")),
        Heading(words("verification.gap"), is_number=True),
        Heading(words("checks.verdict")),
    )
    return Table("compared_lines", headings, tuple(rows), words("system_verification.lines"))
