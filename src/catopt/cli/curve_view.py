"""How a load curve looks on a terminal."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

from catopt.quantities import Quantity
from catopt.report.load_curve import OFFSET, SPAN, Column, at_marks, at_points
from catopt.report.summary import found
from catopt.report.words import REGIMES

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.cli.output import Output

__all__ = ["show_curve"]

_ROWS = 20


def show_curve(output: Output, result: CaseCurve) -> None:
    """Print a load curve for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    result : CaseCurve
        What came out.
    """
    curve, reference = result.curve, result.reference
    output.text(result.case.title or "Mooring line", bold=True)
    output.text(
        f"Load curve by closed form, {len(curve.span)} points evenly over the {result.over}."
    )
    output.text(f"Range: {result.range_words}.")
    for entry in found(reference):
        value = entry.quantity.format(entry.value, unit=True)
        assert reference.found is not None
        output.text(f"{entry.quantity.name}: {value}, for the {reference.found.condition}.")
    if result.over == "offset":
        output.text(f"Offset 0 is at a span of {SPAN.format(reference.span, unit=True)}.")
    output.text(f"At the lower end of the range {REGIMES[curve.regime[0]]}.")
    output.line()
    _points(output, result)
    _marks(output, result)


def _points(output: Output, result: CaseCurve) -> None:
    columns = _shown(result, at_points(result))
    count = len(result.curve.span)
    rows = sorted({round(k * (count - 1) / (_ROWS - 1)) for k in range(_ROWS)})
    cells = [[_cell(quantity, values[row]) for quantity, values in columns] for row in rows]
    title = "Points" if len(rows) == count else f"{len(rows)} of {count} points"
    headings = [_heading(quantity) for quantity, _ in columns]
    output.table(headings, cells, title=title, numbers=range(len(columns)))


def _marks(output: Output, result: CaseCurve) -> None:
    marks = result.curve.marks
    if not marks:
        output.text("No regime changes and no limit is reached in this range.")
        return
    columns = _shown(result, at_marks(result))
    cells = [
        [mark.event, *(quantity.format(values[row]) for quantity, values in columns)]
        for row, mark in enumerate(marks)
    ]
    headings = ["What happens", *(_heading(quantity) for quantity, _ in columns)]
    output.table(headings, cells, title="Marks", numbers=range(1, len(headings)))


def _shown(result: CaseCurve, columns: Iterable[Column]) -> list[Column]:
    """Leave out the offset, or where it was stepped the span, for 80 columns carry no more."""
    hidden = SPAN if result.over == "offset" else OFFSET
    return [column for column in columns if column[0] != hidden]


def _cell(quantity: Quantity, value: float) -> str:
    return quantity.format(None if math.isnan(value) else value)


def _heading(quantity: Quantity) -> str:
    return f"{quantity.symbol or quantity.name}\n({quantity.field_unit})"
