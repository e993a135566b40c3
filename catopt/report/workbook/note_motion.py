"""Sheet of the note's workbook with the line in motion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from catopt.figures.motion import around_the_largest, envelope
from catopt.notes.line import Note
from catopt.quantities import QUANTITIES
from catopt.render.sheet import Book, Cell, Chart, Number, Series, Sheet, Text
from catopt.render.texts import Words
from catopt.report.page.motion import STATISTICS, at_rest, known_of, outcome_rows, run_rows
from catopt.report.page.motion_drive import Row, drive_rows, model_rows, segment_rows
from catopt.report.page.motion_extremes import extreme_headings, extreme_rows
from catopt.report.tables.dynamic import DYNAMIC_QUANTITY_OF, dynamic_sentences
from catopt.report.tables.summary import named
from catopt.report.workbook.note_cells import headed, number_of, unit_of
from catopt.units import lasting

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.notes.motion import InMotion
    from catopt.verify.dynamic_result import DynamicPart

__all__ = ["motion_sheet"]

_TENSION = QUANTITIES["tension"]
_CHART = (720, 380)
"""Pixels."""
_BESIDE = 9
"""Column of the charts, beside the tables."""
_ENVELOPE = ("in_motion.high", "in_motion.low", "in_motion.still")
_MOST = 300
"""Samples around the largest tension."""


def motion_sheet(book: Book, note: Note) -> None:
    """Write statistics, utilisation, what drives the line and its model; draw its tension.

    No sheet where the line was not set in motion.
    """
    moved = note.motion
    if moved is None:
        return
    words = book.words
    sheet = book.sheet("Motion")
    for part, solution in zip(moved.found.parts, moved.solutions, strict=True):
        _statistics(sheet, moved, part, solution)
    _uses(sheet, moved)
    index = moved.governing
    part, solution = moved.found.parts[index], moved.solutions[index]
    _extremes(sheet, part)
    _list(sheet, "in_motion.outcome", outcome_rows(part))
    _list(sheet, "in_motion.drive", drive_rows(moved, words))
    _list(sheet, "in_motion.model", model_rows(moved, part.runs[0], words))
    _segments(sheet, moved)
    _runs(sheet, part)
    told = [words.sentence(each).text for each in (*dynamic_sentences(part), *part.remarks)]
    for text in (words("in_motion.about"), *told, *known_of(note, part, words)):
        sheet.across(text)
    _drawn(sheet, part, solution)


def _statistics(sheet: Sheet, moved: InMotion, part: DynamicPart, solution: Solution) -> None:
    words = sheet.book.words
    rest = at_rest(solution)
    rows: list[Sequence[Cell]] = []
    for each in part.quantities:
        quantity = DYNAMIC_QUANTITY_OF[each.quantity]
        numbers = (
            rest[each.quantity], each.mean, each.std, each.minimum, each.maximum,
            each.most_probable_maximum,
        )  # fmt: skip
        change = part.change_of(each.quantity)
        rows.append(
            (
                words.name(quantity.name),
                Text(unit_of(quantity.field_unit), "text"),
                *(number_of(quantity, value) for value in numbers),
                None if change is None else Number(change, "0.00%"),
            )
        )
    title = ""
    if len(moved.found.parts) > 1:
        title = words("checks.under", name=part.name)
    sheet.grid(
        [
            words("workbook.quantity"),
            words("workbook.unit"),
            *(words(key, time=lasting(part.duration_of_interest)) for key in STATISTICS),
        ],
        rows,
        title=title,
        widths=[40, 24, *[14.0] * len(STATISTICS)],
        right=range(2, 2 + len(STATISTICS)),
    )


def _uses(sheet: Sheet, moved: InMotion) -> None:
    """Write what each segment carries under each load case; how far it is used is a formula."""
    words = sheet.book.words
    first = sheet.row + 3  # below the title and the headings, counted from 1
    flat = [
        (part.name, use)
        for part, uses in zip(moved.found.parts, moved.uses, strict=True)
        for use in uses
    ]
    rows: list[Sequence[Cell]] = []
    for row, (name, use) in enumerate(flat, start=first):
        used = use.utilisation
        formula = "" if used is None else f"=D{row}/F{row}"
        key = "" if used is None else "checks.passes" if used <= 1.0 else "checks.fails"
        rows.append(
            (
                name,
                use.name,
                Number(use.number),
                number_of(_TENSION, use.largest),
                number_of(_TENSION, use.at_rest),
                number_of(_TENSION, use.capacity),
                Number(used, "0.000", formula),
                Text(words(key), "bad" if key.endswith("fails") else "good") if key else None,
            )
        )
    unit = f" ({_TENSION.field_unit})"
    sheet.grid(
        [
            words("identity.load_case"),
            words("components.name"),
            words("components.segment"),
            headed(words, named("tension", "Largest tension", "")),
            words("in_motion.rest") + unit,
            words("workbook.allowed") + unit,
            words("checks.utilisation"),
            words("checks.verdict"),
        ],
        rows,
        title=words("in_motion.uses"),
        right=range(2, 7),
    )


def _extremes(sheet: Sheet, part: DynamicPart) -> None:
    """Write what the extremes are and what they rest on, in the units of the headings."""
    words, rows = sheet.book.words, extreme_rows(part)
    if not rows:
        return
    quantities = [DYNAMIC_QUANTITY_OF[each.quantity] for each in part.quantities if each.tail]
    laid: list[Sequence[Cell]] = []
    for key, cells in rows:
        pure = key in ("in_motion.peaks_above", "in_motion.weibull_shape")
        numbers = (
            Number(cell.si) if pure else number_of(quantity, cell.si)
            for quantity, cell in zip(quantities, cells, strict=True)
        )
        laid.append((words(key), *numbers))
    headings = [words("table.what"), *extreme_headings(part, words)]
    title = words("in_motion.extremes", time=lasting(part.duration_of_interest))
    sheet.grid(headings, laid, title=title, right=range(1, 1 + len(quantities)))


def _list(sheet: Sheet, title: str, rows: Sequence[Row]) -> None:
    """Write what is called so and what it is; numbers in SI beside it."""
    words = sheet.book.words
    laid: list[Sequence[Cell]] = [
        (words(key), cell.text, None if cell.si is None else Number(cell.si)) for key, cell in rows
    ]
    headings = [words("table.what"), words("table.value"), words("workbook.si")]
    sheet.grid(headings, laid, title=words(title), right=(2,))


def _segments(sheet: Sheet, moved: InMotion) -> None:
    words = sheet.book.words
    coefficient = QUANTITIES["coefficient"]
    drag, volume = QUANTITIES["drag_diameter"], QUANTITIES["volume_diameter"]
    quantities = (
        QUANTITIES["mass_per_length"], QUANTITIES["EA"], drag, coefficient, coefficient,
        volume, coefficient, coefficient,
    )  # fmt: skip
    rows: list[Sequence[Cell]] = [
        (
            f"{number}: {segment.name or segment.component}",
            *(number_of(q, value) for q, value in zip(quantities, numbers, strict=True)),
        )
        for number, (segment, numbers) in enumerate(segment_rows(moved), start=1)
    ]
    across, along = words("in_motion.across"), words("in_motion.along")
    headings = [
        words("components.segment"),
        *(headed(words, each) for each in quantities[:3]),
        f"C_D, {across}",
        f"C_D, {along}",
        headed(words, volume),
        f"C_A, {across}",
        f"C_A, {along}",
    ]
    title = words("in_motion.segments")
    sheet.grid(headings, rows, title=title, right=range(1, 1 + len(quantities)))
    sheet.across(words("in_motion.coefficients"))
    sheet.row += 1


def _runs(sheet: Sheet, part: DynamicPart) -> None:
    words = sheet.book.words
    rows: list[Sequence[Cell]] = [
        (
            Number(run.number + 1, is_left=True), number_of(_TENSION, still), Number(when, "0.00"),
            number_of(_TENSION, largest), Number(slack, "0.00"), Number(steps), Number(halvings),
        )
        for run, (largest, when, still, slack, steps, halvings) in zip(
            part.runs, run_rows(part), strict=True
        )
    ]  # fmt: skip
    unit = f" ({_TENSION.field_unit})"
    headings = [
        words.name("Run"),
        words.name("Largest quasi-static fairlead tension") + unit,
        words("in_motion.when"),
        words.name("Largest fairlead tension") + unit,
        f"{words.name('Slack in all')} (s)",
        words.name("Steps"),
        words.name("Halvings"),
    ]
    sheet.grid(headings, rows, title=words("in_motion.run_table"), right=range(1, 7))


def _drawn(sheet: Sheet, part: DynamicPart, solution: Solution) -> None:
    """Write the tension around its largest value and the envelope below all, and draw them."""
    sheet.row += 1
    top, history = _history(sheet, part)
    row = sheet.chart(history, row=1, column=_BESIDE)
    sheet.chart(_envelope(sheet, part, solution, top), row=row, column=_BESIDE)


def _history(sheet: Sheet, part: DynamicPart) -> tuple[int, Chart]:
    """Write the series; return the row of its heading, and its chart."""
    words = sheet.book.words
    run = part.governing
    history = run.history
    rows: list[Sequence[Cell]] = [
        (
            Number(float(history.time[k]), "0.000"),
            number_of(_TENSION, float(history.fairlead_tension[k, 0])),
            number_of(_TENSION, _known(float(run.quasi_static[k]))),
        )
        for k in around_the_largest(run, _MOST)
    ]
    unit = f" ({_TENSION.field_unit})"
    headings = [
        words("in_motion.time"),
        words.name("Fairlead tension") + unit,
        words.name("Quasi-static fairlead tension") + unit,
    ]
    title = words("in_motion.history")
    top = sheet.grid(headings, rows, title=title, right=range(3))
    place = (top + 1, top + len(rows))
    series = [Series(words("in_motion.dynamic"), place, 0, 1, colour=0)]
    if np.isfinite(run.quasi_static).any():
        series.append(Series(words("in_motion.quasi_static"), place, 0, 2, colour=1))
    return top, Chart(title, headings[0], _label(words), tuple(series), size=_CHART)


def _envelope(sheet: Sheet, part: DynamicPart, solution: Solution, top: int) -> Chart:
    """Write the envelope beside the series, its heading in the same row; return its chart."""
    words = sheet.book.words
    arc, high, low = envelope(part)
    profile = solution.profile(161)
    still = np.interp(arc, profile.s, profile.tension)
    s = QUANTITIES["s"]
    rows: list[Sequence[Cell]] = [
        (number_of(s, at), *(number_of(_TENSION, float(value)) for value in values))
        for at, *values in zip(arc, high, low, still, strict=True)
    ]
    unit, keys = f" ({_TENSION.field_unit})", _ENVELOPE
    headings = [headed(words, s), *(words(key) + unit for key in keys)]
    title, column = words("in_motion.envelope"), 4
    sheet.grid(headings, rows, title=title, column=column, row=top - 1, right=range(4))
    place = (top + 1, top + len(rows))
    series = tuple(
        Series(words(key), place, column, column + 1 + k, colour=k) for k, key in enumerate(keys)
    )
    return Chart(title, headings[0], _label(words), series, size=_CHART)


def _known(value: float) -> float | None:
    return value if value == value else None


def _label(words: Words) -> str:
    return headed(words, _TENSION)
