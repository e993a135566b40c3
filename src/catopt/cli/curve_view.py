"""How a load curve looks on a terminal."""

from __future__ import annotations

import math
from collections.abc import Iterable
from textwrap import wrap
from typing import TYPE_CHECKING

from catopt.quantities import Quantity
from catopt.report.tables.load_curve import OFFSET, SPAN, Column, at_marks, at_points
from catopt.report.tables.summary import found
from catopt.report.texts import Words
from catopt.report.wording.names import REGIMES

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.cli.output import Output

__all__ = ["show_curve"]

_ROWS = 20

_HEADING = {"en": 15, "vi": 10}
"""Characters to which a heading is folded, by language."""


def show_curve(output: Output, result: CaseCurve, words: Words) -> None:
    """Print a load curve for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    result : CaseCurve
        What came out.
    words : Words
        Language.
    """
    curve, reference = result.curve, result.reference
    output.text(result.case.title or words.name("Mooring line"), bold=True)
    made = f"Load curve by closed form, {len(curve.span)} points evenly over the {result.over}."
    output.text(words.sentence(made).text)
    spread = words.sentence(result.range_words).text
    output.text(words("load_curve.range", range=spread))
    for entry in found(reference):
        value = entry.quantity.format(entry.value, unit=True)
        assert reference.found is not None
        name = words.heading(entry.quantity.name)
        condition = words.sentence(reference.found.condition).text
        output.text(words("load_curve.found", name=name, value=value, condition=condition))
    if result.over == "offset":
        output.text(words("load_curve.zero", span=SPAN.format(reference.span, unit=True)))
    regime = words.name(REGIMES[curve.regime[0]])
    output.text(words("load_curve.lower_end", regime=regime))
    output.line()
    _points(output, words, result)
    _marks(output, words, result)


def _points(output: Output, words: Words, result: CaseCurve) -> None:
    columns = _shown(result, at_points(result))
    count = len(result.curve.span)
    rows = sorted({round(k * (count - 1) / (_ROWS - 1)) for k in range(_ROWS)})
    cells = [[_cell(quantity, values[row]) for quantity, values in columns] for row in rows]
    title = words("load_curve.points")
    if len(rows) < count:
        title = words("load_curve.some", shown=len(rows), count=count)
    headings = _headings(words, columns)
    output.table(headings, cells, title=title, numbers=range(len(columns)))


def _marks(output: Output, words: Words, result: CaseCurve) -> None:
    marks = result.curve.marks
    if not marks:
        output.text(words("load_curve.no_marks"))
        return
    columns = _shown(result, at_marks(result))
    cells = [
        [
            words.sentence(mark.event).text,
            *(quantity.format(values[row]) for quantity, values in columns),
        ]
        for row, mark in enumerate(marks)
    ]
    headings = [words("load_curve.event"), *_headings(words, columns)]
    output.table(headings, cells, title=words.name("Marks"), numbers=range(1, len(headings)))


def _shown(result: CaseCurve, columns: Iterable[Column]) -> list[Column]:
    """Leave out the offset, or where it was stepped the span, for 80 columns carry no more."""
    hidden = SPAN if result.over == "offset" else OFFSET
    return [column for column in columns if column[0] != hidden]


def _cell(quantity: Quantity, value: float) -> str:
    return quantity.format(None if math.isnan(value) else value)


def _headings(words: Words, columns: Iterable[Column]) -> list[str]:
    """Say what the columns hold, each with its unit in the last row of all."""
    room = _HEADING[words.language]
    folded = [
        [*wrap(quantity.symbol or words.name(quantity.name), room), f"({quantity.field_unit})"]
        for quantity, _ in columns
    ]
    most = max(map(len, folded))
    return ["\n".join([*[""] * (most - len(lines)), *lines]) for lines in folded]
