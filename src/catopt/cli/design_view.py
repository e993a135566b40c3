"""How the front of a design search looks on a terminal."""

from __future__ import annotations

from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.wording.design import (
    CHECK_KINDS,
    anchor_words,
    check_kinds,
    clump_weight_words,
    objective_quantities,
    said_change,
    said_governing,
    segment_words,
    tightest,
)

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.design.result import DesignPoint, DesignResult, Neighbour
    from catopt.report.texts import Words

__all__ = ["show_design"]

_MOST_ROWS = 15
"""Designs of a front that a terminal shows."""
_HEADING = 14
"""Characters to which the name of an objective is folded."""


def show_design(output: Output, result: DesignResult, out: Path | None, words: Words) -> None:
    """Print a front for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    result : DesignResult
        The answer.
    out : Path or None
        Where all of it was written, if it was.
    words : Words
        Language.
    """
    output.text(result.case.title or words.name("Mooring line"), bold=True)
    output.text(words.sentence(_how(result)).text)
    output.line()
    _front(output, words, result, out)
    _recommended(output, words, result)
    for end in result.ends:
        output.text(words.sentence(end).text)
    output.line()
    _neighbours(output, words, result)
    for warning in result.warnings:
        output.text(words.sentence(f"Warning: {warning}.").text, bold=True)


def _how(result: DesignResult) -> str:
    share = "every one" if result.is_exact else f"{result.evaluations:,}"
    front = "exact front" if result.is_exact else "front found"
    return (
        f"{result.designs:,} designs, {share} evaluated by {result.method}; "
        f"{result.feasible:,} pass every check in every load case; "
        f"{len(result.front):,} of them are on the {front}."
    )


def _front(output: Output, words: Words, result: DesignResult, out: Path | None) -> None:
    shown = _shown(len(result.front), result.recommended)
    quantities = _wanted(result)
    headings = [words.name("No."), *_headings(words, result), words.name("Line, from the anchor")]
    rows = [
        [
            f"{'*' if index == result.recommended else ''}{index + 1}",
            *(quantity.format(point.objectives[key]) for key, quantity in quantities),
            _composition(words, point),
        ]
        for index in shown
        for point in (result.front[index],)
    ]
    numbers = range(len(quantities) + 1)
    output.table(headings, rows, title=words.name("Front (* recommended)"), numbers=numbers)
    if len(shown) < len(result.front):
        where = f"{out / 'front.csv'} has all" if out is not None else "--out and --json give all"
        told = f"{len(shown)} of {len(result.front):,} designs are shown; {where}."
        output.text(words.sentence(told).text)
        output.line()


def _headings(words: Words, result: DesignResult) -> list[str]:
    return [
        "\n".join([*wrap(words.name(q.name), _HEADING), f"({q.field_unit})"])
        for _, q in _wanted(result)
    ]


def _wanted(result: DesignResult) -> list[tuple[str, Quantity]]:
    """Keep to the objectives that were made small: 80 columns carry no more."""
    return objective_quantities(result)[: len(result.objectives)]


def _shown(count: int, recommended: int) -> list[int]:
    """Choose indices evenly along the front, with its ends and the recommended design."""
    if count <= _MOST_ROWS:
        return list(range(count))
    steps = _MOST_ROWS - 2
    return sorted({round(step * (count - 1) / steps) for step in range(steps + 1)} | {recommended})


def _composition(words: Words, point: DesignPoint) -> str:
    anchor = words.sentence(anchor_words(point)).text
    parts = [*_segments(words, point), *_clump_weights(words, point), anchor]
    return "; ".join(part for part in parts if part)


def _segments(words: Words, point: DesignPoint) -> list[str]:
    """Say what each segment is; one that has a name is called by it in every language."""
    return [
        said if segment.name else words.sentence(said).text
        for segment, said in zip(point.line.segments, segment_words(point.line), strict=True)
    ]


def _clump_weights(words: Words, point: DesignPoint) -> list[str]:
    return [words.sentence(said).text for said in clump_weight_words(point.line)]


def _verdict(words: Words, step: Neighbour) -> str:
    """Say whether a changed design is feasible, and by what it fails when it is not."""
    if step.point is None:
        return words.sentence(step.reason).text
    report = step.point.checks
    worst = report.governing
    if report.passes or worst is None:
        return words.name("passes")
    used = worst.utilisation
    how = "" if used is None else f", {words.name('utilisation')} {used:.3f}"
    return f"{words.name('fails')}: {said_governing(words, worst)}{how}"


def _recommended(output: Output, words: Words, result: DesignResult) -> None:
    point = result.front[result.recommended]
    chosen = f"Recommended: design {result.recommended + 1}"
    output.text(words.sentence(chosen).text, bold=True)
    output.text(words.sentence(result.recommendation).text)
    output.line()
    rows = [
        (f"{words.name('Segment')} {n}", text)
        for n, text in enumerate(_segments(words, point), start=1)
    ]
    rows += [(words.name("Clump weight"), text) for text in _clump_weights(words, point)]
    if point.anchor is not None:
        rows.append((words.name("Anchor"), words.sentence(anchor_words(point)).text))
    for key, quantity in objective_quantities(result):
        rows.append(
            (words.heading(quantity.label), quantity.format(point.objectives[key], unit=True))
        )
    output.table(["", ""], rows)
    checks = [(kind, tightest(point.checks, kind)) for kind in check_kinds([point.checks])]
    output.table(
        [words.name(each) for each in ("Check", "Utilisation", "Load case", "Source")],
        [
            (
                words.name(CHECK_KINDS[kind]),
                QUANTITIES["utilisation"].format(check.utilisation),
                check.load_case,
                words.name(check.source.text),
            )
            for kind, check in checks
            if check is not None
        ],
        title=words.name("Its tightest check of each kind"),
        numbers=[1],
    )
    output.text(f"{words.name('Governing')}: {said_governing(words, point.governing)}.")


def _neighbours(output: Output, words: Words, result: DesignResult) -> None:
    quantities = _wanted(result)
    rows = [
        [
            said_change(words, step),
            *(
                quantity.format(None if step.point is None else step.point.objectives.get(key))
                for key, quantity in quantities
            ),
            _verdict(words, step),
        ]
        for step in (*result.neighbours, result.present)
    ]
    headings = [words.name("Change"), *_headings(words, result), words.name("Verdict")]
    numbers = range(1, len(quantities) + 1)
    title = words.name("One size or one step up or down from it, and the line in the file")
    output.table(headings, rows, title=title, numbers=numbers)
