"""The checks of a moored body, line by line."""

from __future__ import annotations

from typing import Any

from catopt.answers.check import QUANTITY_OF
from catopt.notes.checking import BODY, line_name
from catopt.notes.system import SystemNote
from catopt.render.texts import Words
from catopt.report.page.checks import check_cells, check_headings
from catopt.report.page.table import Cell, Heading, Table

__all__ = ["checks", "governing_words", "of_what"]


def checks(note: SystemNote, words: Words) -> dict[str, Any] | None:
    """Build the table of all checks; None where the case asks for none."""
    report = note.checks
    if not report.results:
        return None
    rows = tuple(
        (Cell(of_what(each.load_case, note, words)), *check_cells(each, words))
        for each in report.results
    )
    headings = (Heading(words("system_lines.line")), *check_headings(words))
    marked = next(
        (index for index, each in enumerate(report.results) if each is report.governing), None
    )
    return {
        "table": Table("checks", headings, rows, marked=marked),
        "governing": governing_words(note, words),
        "passes": report.passes,
    }


def of_what(name: str, note: SystemNote, words: Words) -> str:
    """Say of which line a check is, or that it is of the body."""
    if name == BODY:
        return words("system_checks.body")
    names = [line_name(index) for index in range(len(note.solution.lines))]
    return str(names.index(name) + 1)


def governing_words(note: SystemNote, words: Words) -> str:
    """Say which check governs."""
    found = note.checks.governing
    if found is None:
        return ""
    name = words.sentence(found.name).text
    where = of_what(found.load_case, note, words)
    if found.load_case != BODY:
        where = words("system_checks.of_line", line=where)
    quantity = QUANTITY_OF[found.kind]
    return words(
        "system_checks.governs",
        check=name,
        where=where,
        demand=quantity.format(found.demand, unit=True),
        capacity=quantity.format(found.capacity, unit=True),
    )
