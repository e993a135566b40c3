"""Horizontal force and fairlead tension over the span: the load curve of the line."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.figures.curve import load_curve
from catopt.notes.line import Note
from catopt.render.svg import svg
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, measured, said, units
from catopt.report.tables.load_curve import at_marks, at_points

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve

__all__ = ["curve_figure"]

_ROWS = 15
"""Points of the curve in the table, about."""


def curve_figure(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the figure and its tables; None where there is no curve."""
    curve = note.curve
    if curve is None:
        return None
    # The table of marks says what their numbers are.
    chart = replace(load_curve(curve), notes=())
    return {
        "figure": svg(chart, words.language),
        "marks": _mark_table(curve, words) if curve.curve.marks else None,
        "points": _point_table(curve, words),
    }


def _mark_table(curve: CaseCurve, words: Words) -> Table:
    columns = at_marks(curve)
    rows = []
    for index, mark in enumerate(curve.curve.marks):
        numbers = (measured(quantity, values[index]) for quantity, values in columns)
        rows.append((Cell(str(index + 1)), said(words.sentence(mark.event), "words"), *numbers))
    headings = (
        Heading(words("components.number")),
        Heading(words("curve.event")),
        *(units(words, quantity) for quantity, _ in columns),
    )
    return Table("marks", headings, tuple(rows), words("curve.marks"))


def _point_table(curve: CaseCurve, words: Words) -> Table:
    """Tabulate some points of the curve, both ends among them."""
    columns = at_points(curve)
    count = len(columns[0][1])
    step = max(1, round(count / _ROWS))
    chosen = sorted({*range(0, count, step), count - 1})
    rows = tuple(
        tuple(
            measured(quantity, None if values[i] != values[i] else values[i])
            for quantity, values in columns
        )
        for i in chosen
    )
    headings = tuple(units(words, quantity) for quantity, _ in columns)
    return Table("curve", headings, rows, words("curve.points"))
