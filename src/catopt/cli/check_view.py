"""How a report of checks looks on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.check_words import (
    QUANTITY_OF,
    governing_sentence,
    load_case_words,
    verdict_sentence,
)

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport, CheckResult, CheckSource
    from catopt.cli.output import Output

__all__ = ["show_report"]


def show_report(output: Output, report: CheckReport) -> None:
    """Print a report of checks for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    report : CheckReport
        What came out.
    """
    output.text(report.title or "Mooring line", bold=True)
    output.line()
    if report.results:
        for index in range(len(report.solutions)):
            _load_case(output, report, index)
        _criteria(output, report)
    output.text(verdict_sentence(report), bold=True)
    if report.results:
        output.text(governing_sentence(report))
    for warning in report.warnings:
        output.text(f"Warning: {warning}.", bold=True)


def _load_case(output: Output, report: CheckReport, index: int) -> None:
    name, _ = report.solutions[index]
    rows = [_row(result) for result in report.results if result.load_case == name]
    output.table(
        ["Check", "Demand", "Capacity", "Utilisation", "", "By"],
        rows,
        title=load_case_words(report, index),
        numbers=[1, 2, 3],
    )


def _row(result: CheckResult) -> tuple[str, ...]:
    quantity = QUANTITY_OF[result.kind]
    return (
        result.name,
        quantity.format(result.demand, unit=True),
        quantity.format(result.capacity, unit=True),
        QUANTITIES["utilisation"].format(result.utilisation),
        "passes" if result.passes else "FAILS",
        _by(result.source),
    )


def _by(source: CheckSource) -> str:
    if source.confidence is None:
        return source.text
    return f"{source.code} [{source.confidence}]"


def _criteria(output: Output, report: CheckReport) -> None:
    """Say once how each capacity comes about, and where the criterion stands."""
    found = dict.fromkeys(
        (result.name, _by(result.source), result.note, result.source.text)
        for result in report.results
    )
    rows = [
        (name, by, "; ".join(part for part in (note, text if text != by else "") if part))
        for name, by, note, text in found
    ]
    output.table(["Check", "By", "Capacity and source"], rows, title="Criteria")
    if any(result.source.confidence for result in report.results):
        output.text(
            "Confidence: A read in the document itself; B in two independent secondary sources, or "
            "in one and checked by numbers; C in one secondary source; R recalled, read in no "
            "document."
        )
        output.line()
