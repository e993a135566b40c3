"""How a moored body looks on a terminal."""

from __future__ import annotations

from collections.abc import Iterable
from textwrap import wrap
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.system import (
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

__all__ = ["show_system"]

_EVERY = 10
"""One direction of the watch circle in so many is shown: 30 degrees."""

_CURVE_EVERY = 2

_NARROW = 9
"""Letters of a heading on one line: a table of eight columns is to fit 80."""


def show_system(output: Output, report: SystemReport) -> None:
    """Print a moored body for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    report : SystemReport
        What came out.
    """
    solution = report.solution
    count = len(solution.lines)
    output.text(report.case.title or "Moored body", bold=True)
    freedom = "x, y and yaw" if solution.system.turns else "x and y"
    lines = f"{count} line{'' if count == 1 else 's'}"
    output.text(f"Solved by closed form; {lines}, the body free in {freedom}.")
    output.line()
    rows = [
        (entry.quantity.label, entry.quantity.format(entry.value, unit=True))
        for entry in body(report)
    ]
    output.table(["", ""], rows, title="Body", numbers=[1])
    _table(output, "Lines", line_columns(report))
    if report.line_out:
        _table(output, "One line out", line_out_columns(report))
        for each in report.line_out:
            if each.response is None:
                output.text(
                    f"Without line {each.missing + 1} there is no equilibrium: {each.refusal}"
                )
    if report.circle is not None:
        force = QUANTITIES["horizontal_force"].format(report.circle.force, unit=True)
        thinned = _thinned(circle_columns(report), _EVERY)
        _table(output, f"A force of {force} in every direction", thinned)
    for curve in report.curves:
        angle = QUANTITIES["angle"].format(curve.direction, unit=True)
        _table(
            output, f"Held at offsets towards {angle}", _thinned(curve_columns(curve), _CURVE_EVERY)
        )
    if report.levels:
        _table(output, "Water levels", level_columns(report))
    if report.rule.horizontal_force is None:
        output.text(f"The rule of practice for load sharing does not apply: {report.rule.why_not}.")
    output.text(f"Residual of the balance: {solution.residual.force:.2e} N")
    if solution.system.turns:
        output.text(f"Residual of the moments: {solution.residual.moment:.2e} N m")
    for warning in solution.warnings:
        output.text(f"Warning: {warning}.", bold=True)


def _thinned(columns: Iterable[Column], every: int) -> list[Column]:
    return [(what, values[::every]) for what, values in columns]


def _table(output: Output, title: str, columns: Iterable[Column]) -> None:
    headings, cells = [], []
    for what, values in columns:
        if isinstance(what, str):
            headings.append("\n".join(what.split()))
            cells.append([str(value) for value in values])
        else:
            name = what.name.replace("Utilisation", "Utili- sation")
            words = what.symbol or "\n".join(wrap(name, _NARROW))
            headings.append(f"{words}\n({what.field_unit})")
            cells.append(
                [what.format(value if isinstance(value, float) else None) for value in values]
            )
    output.table(
        headings, list(zip(*cells, strict=True)), title=title, numbers=range(len(headings))
    )
