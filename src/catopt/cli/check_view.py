"""How a report of checks looks on a terminal."""

from __future__ import annotations

from textwrap import wrap
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.wording.checks import (
    QUANTITY_OF,
    governing_sentence,
    load_case_words,
    verdict_sentence,
)

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport, CheckResult, CheckSource
    from catopt.cli.output import Output
    from catopt.report.texts import Words

__all__ = ["show_report"]

_HEADING = 11
"""Characters to which a heading is folded."""

_CONFIDENCE = (
    "Confidence: A read in the document itself; B in two independent secondary sources, or in one "
    "and checked by numbers; C in one secondary source; R recalled, read in no document."
)


def show_report(output: Output, report: CheckReport, words: Words) -> None:
    """Print a report of checks for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    report : CheckReport
        What came out.
    words : Words
        Language.
    """
    output.text(report.title or words.name("Mooring line"), bold=True)
    output.line()
    if report.results:
        for index in range(len(report.solutions)):
            _load_case(output, words, report, index)
        _criteria(output, words, report)
    output.text(words.sentence(verdict_sentence(report)).text, bold=True)
    if report.results:
        output.text(words.sentence(governing_sentence(report)).text)
    for warning in report.warnings:
        output.text(words.sentence(f"Warning: {warning}.").text, bold=True)


def _load_case(output: Output, words: Words, report: CheckReport, index: int) -> None:
    name, _ = report.solutions[index]
    rows = [_row(words, result) for result in report.results if result.load_case == name]
    output.table(
        [_folded(words, each) for each in ("Check", "Demand", "Capacity", "Utilisation", "", "By")],
        rows,
        title=words.sentence(load_case_words(report, index)).text,
        numbers=[1, 2, 3],
    )


def _folded(words: Words, heading: str) -> str:
    """Fold a heading, so that 80 columns carry the table in every language."""
    return "\n".join(wrap(words.name(heading), _HEADING))


def _row(words: Words, result: CheckResult) -> tuple[str, ...]:
    quantity = QUANTITY_OF[result.kind]
    return (
        words.sentence(result.name).text,
        quantity.format(result.demand, unit=True),
        quantity.format(result.capacity, unit=True),
        QUANTITIES["utilisation"].format(result.utilisation),
        words.name("passes" if result.passes else "FAILS"),
        _by(words, result.source),
    )


def _by(words: Words, source: CheckSource) -> str:
    if source.confidence is None:
        return words.name(source.text)
    return f"{source.code} [{source.confidence}]"


def _criteria(output: Output, words: Words, report: CheckReport) -> None:
    """Say once how each capacity comes about, and where the criterion stands."""
    found = dict.fromkeys(
        (
            words.sentence(result.name).text,
            _by(words, result.source),
            words.sentence(result.note).text,
            words.name(result.source.text),
        )
        for result in report.results
    )
    rows = [
        (name, by, "; ".join(part for part in (note, text if text != by else "") if part))
        for name, by, note, text in found
    ]
    headings = [words.name(each) for each in ("Check", "By", "Capacity and source")]
    output.table(headings, rows, title=words.name("Criteria"))
    if any(result.source.confidence for result in report.results):
        output.text(words.name(_CONFIDENCE))
        output.line()
