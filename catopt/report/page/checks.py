"""The checks: demand beside capacity, how far each is used, and where it comes from."""

from __future__ import annotations

from typing import Any

from catopt.answers.check import QUANTITY_OF, governing_sentence
from catopt.checks.result import CheckResult
from catopt.notes.line import Note
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, measured, said

__all__ = ["check_cells", "check_headings", "checks"]


def checks(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the table of checks of each load case; None where nothing was checked."""
    report = note.checks
    if not report.results:
        return None
    tables = []
    for name, _ in report.solutions:
        results = [result for result in report.results if result.load_case == name]
        rows = tuple(check_cells(result, words) for result in results)
        marked = next((i for i, each in enumerate(results) if each is report.governing), None)
        caption = words("checks.under", name=name) if len(report.solutions) > 1 else ""
        tables.append(Table("checks", check_headings(words), rows, caption, marked))
    governing = report.governing
    return {
        "tables": [each for each in tables if each.rows],
        "governing": words.sentence(governing_sentence(report)),
        "passes": report.passes,
        "has_governing": governing is not None,
    }


def check_headings(words: Words) -> tuple[Heading, ...]:
    """Head the columns of a check."""
    return (
        Heading(words("checks.check")),
        Heading(words("checks.demand"), is_number=True),
        Heading(words("checks.capacity"), is_number=True),
        Heading(words("checks.utilisation"), is_number=True),
        Heading(words("checks.verdict")),
        Heading(words("checks.source")),
        Heading(words("checks.note")),
    )


def check_cells(result: CheckResult, words: Words) -> tuple[Cell, ...]:
    """Lay a check out."""
    quantity = QUANTITY_OF[result.kind]
    used = result.utilisation
    shown = "–" if used is None else f"{used:.3f}"
    verdict = words("checks.passes" if result.passes else "checks.fails")
    own = result.source.confidence is None
    return (
        said(words.sentence(result.name), "words"),
        measured(quantity, result.demand, unit=True),
        measured(quantity, result.capacity, unit=True),
        Cell(shown, used, bar=used),
        Cell(verdict, style="passes" if result.passes else "fails"),
        Cell(words.name(result.source.text), lang="" if own else "en", style="words"),
        said(words.sentence(result.note), "words"),
    )
