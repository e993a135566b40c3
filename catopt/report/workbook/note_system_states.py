"""Sheets of a moored body's workbook with its other states: a line out, round, and pushed aside."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.notes.system import SystemNote
from catopt.quantities import QUANTITIES
from catopt.render.sheet import Book, Cell, Chart, Number, Series, Text
from catopt.render.texts import Words
from catopt.report.page.table import in_unit
from catopt.report.workbook.note_cells import number_of

if TYPE_CHECKING:
    from catopt.mooring.response import Response
    from catopt.mooring.restoring import RestoringCurve

__all__ = ["line_out_sheet", "restoring_sheet", "watch_circle_sheet"]

_SQUARE, _WIDE = (560, 520), (680, 420)
"""Pixels."""

ANGLE, LENGTH, TENSION, FORCE = (
    QUANTITIES[key] for key in ("angle", "offset", "tension", "horizontal_force")
)
VERTICAL, GROUNDED = QUANTITIES["vertical_force"], QUANTITIES["grounded_length"]


def line_out_sheet(book: Book, note: SystemNote) -> None:
    """Write what happens when each line is gone; no sheet where that was not asked."""
    if not note.report.line_out:
        return
    words = book.words
    sheet = book.sheet("Line out", words("system_workbook.line_out"))
    rows: list[Sequence[Cell]] = [
        (
            Number(each.missing + 1),
            *_response(each.response),
            Number(used, "0.000"),
            words.sentence(each.refusal).text,
        )
        for each, used in zip(note.report.line_out, note.left, strict=True)
    ]
    heads = _response_headings(words)
    sheet.grid(
        [
            words("system_line_out.gone"),
            *heads,
            words("checks.utilisation"),
            words("system_workbook.why"),
        ],
        rows,
        widths=[10, *[15.0] * len(heads), 13, 46],
        right=range(2 + len(heads)),
    )
    sheet.across(words("system_line_out.about"))


def _response(response: Response | None) -> Sequence[Cell]:
    """Lay out where the body is and what its lines carry; empty where it has no place of rest."""
    if response is None:
        return (None,) * 9
    return (
        number_of(LENGTH, response.x),
        number_of(LENGTH, response.y),
        number_of(ANGLE, response.yaw),
        number_of(LENGTH, response.offset),
        number_of(TENSION, response.largest_tension),
        Number(response.most_loaded + 1),
        number_of(TENSION, response.largest_anchor_tension),
        number_of(VERTICAL, response.largest_uplift),
        number_of(GROUNDED, response.least_grounded),
    )


def _response_headings(words: Words) -> list[str]:
    return [
        in_unit("x", LENGTH),
        in_unit("y", LENGTH),
        in_unit(words("system_workbook.yaw"), ANGLE),
        in_unit(words("system_results.offset"), LENGTH),
        in_unit(words("system_watch_circle.largest"), TENSION),
        words("system_lines.in_line"),
        in_unit(words("system_workbook.anchor_tension"), TENSION),
        in_unit(words("system_workbook.anchor_vertical"), VERTICAL),
        in_unit(words("system_line_out.least_grounded"), GROUNDED),
    ]


def watch_circle_sheet(book: Book, note: SystemNote) -> None:
    """Write where the force takes the body as it goes round, and draw both; or no sheet."""
    words, circle = book.words, note.report.circle
    if circle is None:
        return
    sheet = book.sheet("Watch circle", words("system_workbook.watch_circle"))
    rows: list[Sequence[Cell]] = [
        (number_of(ANGLE, direction), *_response(response))
        for direction, response in zip(circle.directions, circle.responses, strict=True)
    ]
    heads = [in_unit(words("system_watch_circle.towards"), ANGLE), *_response_headings(words)]
    sheet.grid(heads, rows, widths=[13.0] * len(heads), right=range(len(heads)))
    sheet.across(words("system_workbook.force_of", force=FORCE.format(circle.force, unit=True)))
    if note.solution.system.turns:
        sheet.across(words("system_restoring.turns"))
    column = len(heads) + 1
    zero = (
        (Text(words("system_plan.neutral"), "text"), note.solution.neutral),
        (Text(words("curve.reference"), "text"), note.solution.position),
    )
    top = sheet.grid(
        [words("workbook.mark"), "x (m)", "y (m)"],
        [(name, number_of(LENGTH, at.x), number_of(LENGTH, at.y)) for name, at in zero],
        column=column,
        right=(1, 2),
    )
    ends = (1, len(rows))
    marks = [
        Series(name.text, (top + row, top + row), column + 1, column + 2, "points", colour, 9)
        for row, ((name, _), colour) in enumerate(zip(zero, (2, 3), strict=True), start=1)
    ]
    track = Chart(
        words("system_workbook.places"), "x (m)", "y (m)",
        (Series(words("system_watch_circle.track"), ends, 1, 2), *marks), size=_SQUARE,
    )  # fmt: skip
    below = sheet.chart(track, row=top + 4, column=column)
    tension = Chart(
        heads[5], heads[0], heads[5],
        (Series(words("system_watch_circle.largest"), ends, 0, 5),), size=_WIDE,
        y_range=(0.0, None),
    )  # fmt: skip
    sheet.chart(tension, row=below, column=column)


def restoring_sheet(book: Book, note: SystemNote) -> None:
    """Write the restoring curves below each other, and draw them; no sheet without any."""
    if not note.report.curves:
        return
    words = book.words
    sheet = book.sheet("Restoring", words("system_workbook.restoring"))
    heads = [
        in_unit(words("system_workbook.along"), ANGLE),
        in_unit(words("system_restoring.offset"), LENGTH),
        in_unit(words("system_restoring.along"), FORCE),
        in_unit(words("system_restoring.across"), FORCE),
        in_unit(words("system_watch_circle.largest"), TENSION),
        words("system_lines.in_line"),
    ]
    rows = [row for curve in note.report.curves for row in _curve_rows(curve)]
    sheet.grid(heads, rows, widths=[14, 16, 16, 16, 16, 10], right=range(len(heads)))
    sheet.across(words("system_restoring.about"))
    if note.solution.system.turns:
        sheet.across(words("system_restoring.turns"))
    series, first = [], 1
    for colour, curve in enumerate(note.report.curves):
        last = first + len(curve.offset) - 1
        name = words("system_restoring.towards", angle=ANGLE.format(curve.direction, unit=True))
        series.append(Series(name, (first, last), 1, 2, colour=colour))
        first = last + 1
    chart = Chart(
        words("system_restoring.heading"), heads[1],
        in_unit(words("system_restoring.force"), FORCE), tuple(series), size=_WIDE,
    )  # fmt: skip
    sheet.chart(chart, row=1, column=len(heads) + 1)


def _curve_rows(curve: RestoringCurve) -> Iterator[Sequence[Cell]]:
    for index, response in enumerate(curve.responses):
        yield (
            number_of(ANGLE, curve.direction),
            number_of(LENGTH, curve.offset[index]),
            number_of(FORCE, curve.force[index]),
            number_of(FORCE, curve.force_across[index]),
            number_of(TENSION, response.largest_tension),
            Number(response.most_loaded + 1),
        )
