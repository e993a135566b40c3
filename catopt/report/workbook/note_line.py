"""Sheets of the note's workbook that draw the line: its shape, its tension, its load curve."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

from catopt.answers.curve import points_table
from catopt.answers.solution import profile_table
from catopt.figures.line import FAR, touchdowns
from catopt.notes.line import Note
from catopt.quantities import QUANTITIES
from catopt.render.sheet import Book, Cell, Chart, Series, Sheet, Text
from catopt.report.page.figures import capacities
from catopt.report.page.table import called, in_unit
from catopt.report.tables.load_curve import FAIRLEAD_TENSION, FORCE, OFFSET, SPAN, at_marks
from catopt.report.workbook.note_cells import headed, number_of

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve

__all__ = ["curve_sheet", "line_sheet"]

_DRAWING = (760, 380)
_CURVE = (680, 420)
"""Pixels."""


def line_sheet(book: Book, note: Note) -> None:
    """Write the shape and the tension along the line, and draw both."""
    sheet = book.sheet("Line")
    frame = profile_table(note.solution).to_dataframe()
    sheet.table(frame)
    column = len(frame.columns) + 1
    place = _Places(sheet, note, column)
    row = sheet.chart(_shape(place, len(frame)), row=place.end, column=column)
    sheet.chart(_tension(place, len(frame)), row=row, column=column)


class _Places:
    """The tables on the sheet of the line from which its charts take their marks."""

    def __init__(self, sheet: Sheet, note: Note, column: int) -> None:
        words, solution = sheet.book.words, note.solution
        self.book, self.note, self.column = sheet.book, note, column
        x, z, s, T = (QUANTITIES[key] for key in ("x", "z", "s", "tension"))
        depth = note.case.site.water_depth
        marks = [
            (words("workbook.bed"), 0.0, 0.0),
            (words("workbook.bed"), solution.span, 0.0),
            (words("line.surface"), 0.0, depth),
            (words("line.surface"), solution.span, depth),
            (words("workbook.anchor"), 0.0, solution.anchor_height),
            (words("line.fairlead"), solution.span, solution.fairlead_height),
            *((words("tension.touchdown"), at, 0.0) for at, _ in touchdowns(solution)),
            *(
                (called(words, given.submerged_weight, given.name), load.x, load.z)
                for given, load in zip(solution.line.point_loads, solution.point_loads, strict=True)
            ),
        ]
        top = sheet.grid(
            [words("workbook.mark"), *(headed(words, q) for q in (x, z))],
            [(Text(name, "text"), number_of(x, at), number_of(z, up)) for name, at, up in marks],
            column=column,
            right=(1, 2),
        )
        self.marks = top + 1
        self.touchdowns = len(touchdowns(solution))
        self.allowed = capacities(note)
        rows: list[Sequence[Cell]] = []
        start = 0.0
        for segment, capacity in zip(solution.segments, self.allowed, strict=True):
            ends = (start, start + segment.length)
            rows += [(number_of(s, at), number_of(T, capacity)) for at in ends]
            start += segment.length
        top = sheet.grid(
            [headed(words, s), in_unit(words("workbook.allowed"), T)],
            rows,
            column=column + 4,
            right=(0, 1),
        )
        self.capacities = (top + 1, top + len(rows))
        self.end = max(self.marks + len(marks), top + len(rows) + 1) + 1

    def mark(self, name: str, first: int, count: int, colour: int, *, line: bool = False) -> Series:
        """Take some of the marks as a series."""
        rows = (self.marks + first, self.marks + first + count - 1)
        style: Literal["line", "points"] = "line" if line else "points"
        return Series(name, rows, self.column + 1, self.column + 2, style, colour, size=9)


def _shape(place: _Places, points: int) -> Chart:
    words, solution = place.book.words, place.note.solution
    series = [
        Series(words("line.hangs"), (1, points), 1, 2, colour=0),
        place.mark(words("line.surface"), 2, 2, 4, line=True),
        place.mark(words("workbook.bed"), 0, 2, 5, line=True),
        place.mark(words("workbook.ends"), 4, 2, 0),
    ]
    if place.touchdowns:
        series.append(place.mark(words("tension.touchdown"), 6, place.touchdowns, 2))
    if solution.point_loads:
        first = 6 + place.touchdowns
        series.append(place.mark(words("tension.load"), first, len(solution.point_loads), 1))
    x, z = (headed(words, QUANTITIES[key]) for key in ("x", "z"))
    return Chart(words("workbook.shape"), x, z, tuple(series), size=_DRAWING)


def _tension(place: _Places, points: int) -> Chart:
    words, solution = place.book.words, place.note.solution
    tension = QUANTITIES["tension"]
    series = [Series(words.name("Tension"), (1, points), 0, 3, colour=0)]
    largest = max(segment.max_tension for segment in solution.segments)
    drawn = [each for each in place.allowed if each is not None and each <= FAR * largest]
    if drawn:
        s = place.column + 4
        series.append(Series(words("tension.capacity"), place.capacities, s, s + 1, colour=1))
    top = 1.1 * tension.to_field(max(largest, *drawn)) if drawn else None
    return Chart(
        words("tension.heading"),
        headed(words, QUANTITIES["s"]),
        headed(words, tension),
        tuple(series),
        size=_DRAWING,
        y_range=(0.0, top),
    )


def curve_sheet(book: Book, curve: CaseCurve | None) -> None:
    """Write the load curve and its marks, and draw it with the case itself; no sheet without it."""
    if curve is None:
        return
    words = book.words
    sheet = book.sheet("Curve")
    frame = points_table(curve).to_dataframe()
    sheet.table(frame)
    x, *ys = (list(frame.columns).index(q.heading) for q in (SPAN, FORCE, FAIRLEAD_TENSION))
    column = len(frame.columns) + 1
    reference = curve.reference
    here = (
        Text(words("curve.reference"), "text"),
        number_of(SPAN, reference.span),
        number_of(OFFSET, 0.0),
        number_of(FORCE, reference.horizontal_force),
        number_of(FAIRLEAD_TENSION, reference.fairlead.tension),
    )
    marks: list[Sequence[Cell]] = [
        (
            Text(words.sentence(mark.event).text, "text"),
            *(number_of(quantity, values[index]) for quantity, values in at_marks(curve)),
        )
        for index, mark in enumerate(curve.curve.marks)
    ]
    quantities = (SPAN, OFFSET, FORCE, FAIRLEAD_TENSION)
    sheet.grid(
        [words("curve.event"), *(headed(words, q) for q in quantities)],
        [here, *marks],
        column=column,
        right=range(1, 5),
    )
    series = (
        *(
            Series(words(name), (1, len(frame)), x, y, colour=index)
            for index, (name, y) in enumerate(
                zip(("curve.horizontal", "curve.tension"), ys, strict=True)
            )
        ),
        Series(words("curve.reference"), (1, 1), column + 1, column + 3, "points", 3, 9),
        Series(words("curve.reference"), (1, 1), column + 1, column + 4, "points", 3, 9),
    )
    chart = Chart(
        words("curve.heading"),
        headed(words, SPAN),
        in_unit(words("curve.force"), FORCE),
        series,
        size=_CURVE,
        y_range=(0.0, None),
        hidden=(3,),
    )
    sheet.chart(chart, row=len(marks) + 3, column=column)
