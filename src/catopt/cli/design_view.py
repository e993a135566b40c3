"""How the front of a design search looks on a terminal."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.design_words import (
    CHECK_KINDS,
    anchor_words,
    check_kinds,
    clump_weight_words,
    governing_words,
    objective_quantities,
    segment_words,
    tightest,
    verdict,
)

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.design.result import DesignPoint, DesignResult

__all__ = ["show_design"]

_MOST_ROWS = 15
"""Designs of a front that a terminal shows."""


def show_design(output: Output, result: DesignResult, out: Path | None) -> None:
    """Print a front for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    result : DesignResult
        The answer.
    out : Path or None
        Where all of it was written, if it was.
    """
    output.text(result.case.title or "Mooring line", bold=True)
    output.text(_how(result))
    output.line()
    _front(output, result, out)
    _recommended(output, result)
    for end in result.ends:
        output.text(end)
    output.line()
    _neighbours(output, result)
    for warning in result.warnings:
        output.text(f"Warning: {warning}.", bold=True)


def _how(result: DesignResult) -> str:
    share = "every one" if result.is_exact else f"{result.evaluations:,}"
    front = "exact front" if result.is_exact else "front found"
    return (
        f"{result.designs:,} designs, {share} evaluated by {result.method}; "
        f"{result.feasible:,} pass every check in every load case; "
        f"{len(result.front):,} of them are on the {front}."
    )


def _front(output: Output, result: DesignResult, out: Path | None) -> None:
    shown = _shown(len(result.front), result.recommended)
    quantities = _wanted(result)
    headings = ["No.", *_headings(result), "Line, from the anchor"]
    rows = [
        [
            f"{'*' if index == result.recommended else ''}{index + 1}",
            *(quantity.format(point.objectives[key]) for key, quantity in quantities),
            _composition(point),
        ]
        for index in shown
        for point in (result.front[index],)
    ]
    numbers = range(len(quantities) + 1)
    output.table(headings, rows, title="Front (* recommended)", numbers=numbers)
    if len(shown) < len(result.front):
        where = f"{out / 'front.csv'} has all" if out is not None else "--out and --json give all"
        output.text(f"{len(shown)} of {len(result.front):,} designs are shown; {where}.")
        output.line()


def _headings(result: DesignResult) -> list[str]:
    return [f"{q.name}\n({q.field_unit})" for _, q in _wanted(result)]


def _wanted(result: DesignResult) -> list[tuple[str, Quantity]]:
    """Keep to the objectives that were made small: 80 columns carry no more."""
    return objective_quantities(result)[: len(result.objectives)]


def _shown(count: int, recommended: int) -> list[int]:
    """Choose indices evenly along the front, with its ends and the recommended design."""
    if count <= _MOST_ROWS:
        return list(range(count))
    steps = _MOST_ROWS - 2
    return sorted({round(step * (count - 1) / steps) for step in range(steps + 1)} | {recommended})


def _composition(point: DesignPoint) -> str:
    parts = [*segment_words(point.line), *clump_weight_words(point.line), anchor_words(point)]
    return "; ".join(part for part in parts if part)


def _recommended(output: Output, result: DesignResult) -> None:
    point = result.front[result.recommended]
    output.text(f"Recommended: design {result.recommended + 1}", bold=True)
    output.text(f"{result.recommendation}")
    output.line()
    rows = [(f"Segment {n}", text) for n, text in enumerate(segment_words(point.line), start=1)]
    rows += [("Clump weight", text) for text in clump_weight_words(point.line)]
    if point.anchor is not None:
        rows.append(("Anchor", anchor_words(point)))
    for key, quantity in objective_quantities(result):
        rows.append((quantity.label, quantity.format(point.objectives[key], unit=True)))
    output.table(["", ""], rows)
    checks = [(kind, tightest(point.checks, kind)) for kind in check_kinds([point.checks])]
    output.table(
        ["Check", "Utilisation", "Load case", "Source"],
        [
            (
                CHECK_KINDS[kind],
                QUANTITIES["utilisation"].format(check.utilisation),
                check.load_case,
                check.source.text,
            )
            for kind, check in checks
            if check is not None
        ],
        title="Its tightest check of each kind",
        numbers=[1],
    )
    output.text(f"Governing: {governing_words(point.governing)}.")


def _neighbours(output: Output, result: DesignResult) -> None:
    quantities = _wanted(result)
    rows = [
        [
            step.change,
            *(
                quantity.format(None if step.point is None else step.point.objectives.get(key))
                for key, quantity in quantities
            ),
            verdict(step),
        ]
        for step in (*result.neighbours, result.present)
    ]
    headings = ["Change", *_headings(result), "Verdict"]
    numbers = range(1, len(quantities) + 1)
    title = "One size or one step up or down from it, and the line in the file"
    output.table(headings, rows, title=title, numbers=numbers)
