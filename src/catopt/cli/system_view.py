"""How a moored body looks on a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from textwrap import wrap
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.tables.system import (
    Column,
    body,
    circle_columns,
    curve_columns,
    level_columns,
    line_columns,
    line_out_columns,
)

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.mooring.case import SystemReport
    from catopt.report.texts import Words

__all__ = ["show_system"]

_EVERY = 10
"""One direction of the watch circle in so many is shown: 30 degrees."""

_CURVE_EVERY = 2


def show_system(output: Output, report: SystemReport, words: Words) -> None:
    """Print a moored body for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    report : SystemReport
        What came out.
    words : Words
        Language.
    """
    solution = report.solution
    count = len(solution.lines)
    output.text(report.case.title or words.name("Moored body"), bold=True)
    freedom = "x, y and yaw" if solution.system.turns else "x and y"
    lines = f"{count} line{'' if count == 1 else 's'}"
    solved = f"Solved by closed form; {lines}, the body free in {freedom}."
    output.text(words.sentence(solved).text)
    output.line()
    rows = [
        (words.heading(entry.quantity.label), entry.quantity.format(entry.value, unit=True))
        for entry in body(report)
    ]
    output.table(["", ""], rows, title=words.name("Body"), numbers=[1])
    _table(output, words, "Lines", line_columns(report))
    if report.line_out:
        _table(output, words, "One line out", line_out_columns(report))
        for each in report.line_out:
            if each.response is None:
                lost = f"Without line {each.missing + 1} there is no equilibrium: {each.refusal}"
                output.text(words.sentence(lost).text)
    if report.circle is not None:
        force = QUANTITIES["horizontal_force"].format(report.circle.force, unit=True)
        thinned = _thinned(circle_columns(report), _EVERY)
        _table(output, words, f"A force of {force} in every direction", thinned)
    for curve in report.curves:
        angle = QUANTITIES["angle"].format(curve.direction, unit=True)
        thinned = _thinned(curve_columns(curve), _CURVE_EVERY)
        _table(output, words, f"Held at offsets towards {angle}", thinned)
    if report.levels:
        _table(output, words, "Water levels", level_columns(report))
    if report.rule.horizontal_force is None:
        why = f"The rule of practice for load sharing does not apply: {report.rule.why_not}."
        output.text(words.sentence(why).text)
    left = f"Residual of the balance: {solution.residual.force:.2e} N"
    output.text(words.sentence(left).text)
    if solution.system.turns:
        left = f"Residual of the moments: {solution.residual.moment:.2e} N m"
        output.text(words.sentence(left).text)
    for warning in solution.warnings:
        output.text(words.sentence(f"Warning: {warning}.").text, bold=True)


def _thinned(columns: Iterable[Column], every: int) -> list[Column]:
    return [(what, values[::every]) for what, values in columns]


def _table(output: Output, words: Words, title: str, columns: Iterable[Column]) -> None:
    headings, cells = [], []
    for what, values in columns:
        if isinstance(what, str):
            headings.append("\n".join(words.name(what).split()))
            cells.append([str(value) for value in values])
        else:
            shown = [what.format(value if isinstance(value, float) else None) for value in values]
            label = what.symbol or _folded(words.name(what.name), shown)
            headings.append(f"{label}\n({what.field_unit})")
            cells.append(shown)
    rows = list(zip(*cells, strict=True))
    said = words.sentence(title).text
    output.table(headings, rows, title=said, numbers=range(len(headings)))


def _folded(heading: str, cells: Sequence[str]) -> str:
    """Fold a heading to what stands below it: a table of eight columns is to fit 80."""
    parts = heading.replace("Utilisation", "Utili- sation").split()
    return "\n".join(wrap(" ".join(parts), max(map(len, (*parts, *cells)))))
