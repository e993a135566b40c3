"""Sheet of the note's workbook with the line by the particle swarm."""

from __future__ import annotations

import math
from collections.abc import Sequence

from catopt.catenary.solution import SwarmReport
from catopt.notes.line import Note
from catopt.render.sheet import Book, Cell, Chart, Number, Series, Sheet, Text
from catopt.report.page.swarm import CONVERGED, result_rows, setting_rows
from catopt.report.page.table import in_unit, label_of
from catopt.report.tables.summary import named
from catopt.report.workbook.note_cells import headed, number_of, unit_of
from catopt.words import Message, say

__all__ = ["swarm_sheet"]

_SMALL = "0.0E+00"
_CHART = (680, 400)
"""Pixels."""
_OBJECTIVE = named("objective", "Best objective")
_TENSION = named("tension", "Fairlead tension")


def swarm_sheet(book: Book, note: Note) -> None:
    """Write both methods beside each other, the runs, the settings, and how the best run fell.

    No sheet where the swarm was left out.
    """
    if note.swarm is None:
        return
    assert note.swarm.swarm is not None
    report, words = note.swarm.swarm, book.words
    sheet = book.sheet("Swarm")
    sheet.grid(
        [
            words("workbook.quantity"),
            words("workbook.unit"),
            words("swarm.by_swarm"),
            words("verification.closed_form"),
            words("swarm.difference"),
        ],
        [
            (
                label_of(words, quantity),
                Text(unit_of(quantity.field_unit), "text"),
                number_of(quantity, found),
                number_of(quantity, exact),
                Number(quantity.to_field(found - exact), _SMALL, f"=C{row}-D{row}"),
            )
            for row, (quantity, found, exact) in enumerate(result_rows(note), start=2)
        ],
        widths=[44, 12, 18, 18, 24],
        right=(2, 3, 4),
    )
    _runs(sheet, report)
    sheet.grid(
        [words("swarm.setting"), words("table.value")],
        [
            (words.heading(name), value if isinstance(value, str) else Number(value, is_left=True))
            for name, value in setting_rows(note.case.swarm)
        ],
        title=words("swarm.settings"),
    )
    for text in (words("swarm.about"), words("swarm.legend")):
        sheet.across(text)
    _history(sheet, report)


def _runs(sheet: Sheet, report: SwarmReport) -> None:
    words = sheet.book.words
    flown = report.iterations_flown or (report.iterations,) * len(report.objectives)
    rows: list[Sequence[Cell]] = [
        (
            Number(number, is_left=True),
            Text(words.name("yes" if number == report.best_run else "no"), "text"),
            number_of(_OBJECTIVE, f),
            Number(iterations),
            Text(words.name("yes" if f < CONVERGED else "no"), "text"),
        )
        for number, (f, iterations) in enumerate(
            zip(report.objectives, flown, strict=True), start=1
        )
    ]
    headings = [
        words.name("Run"),
        words.name("Best run"),
        in_unit(words("swarm.ended"), _OBJECTIVE),
        words.name("Iterations flown"),
        words("swarm.converged"),
    ]
    sheet.grid(headings, rows, title=words("swarm.runs"), right=(2, 3))
    told = [
        ("Best objective f", f"{report.objective:.3e} m"),
        ("Evaluations of f", str(report.evaluations)),
        (
            "Runs that reached f < 1e-9 m",
            words("terminal.of", part=report.converged_runs, whole=report.runs),
        ),
        ("Span against equation (5) of S1", f"{report.span_consistency:.1e} m"),
    ]
    for name, value in told:
        sheet.pair(words.heading(name), value)
    sheet.row += 1


def _history(sheet: Sheet, report: SwarmReport) -> None:
    """Write the best run iteration by iteration below the other tables, and draw it beside them."""
    words, column = sheet.book.words, 6
    history = report.best_objective_history
    rows = [
        (Number(n, is_left=True), number_of(_TENSION, T), number_of(_OBJECTIVE, f))
        for n, (f, T) in enumerate(zip(history, report.tension_history, strict=True), start=1)
    ]
    headings = [words.name("Iteration"), headed(words, _TENSION), headed(words, _OBJECTIVE)]
    sheet.row += 1
    title = words("swarm.curve", run=report.best_run)
    top = sheet.grid(headings, rows, title=title, right=(1, 2))
    place = (top + 1, top + len(rows))
    positive = [f for f in history if f > 0.0]
    log = None
    if positive:
        low, high = math.floor(math.log10(min(positive))), math.ceil(math.log10(max(positive)))
        log = (10.0**low, 10.0 ** max(high, low + 1))
    # A spreadsheet leaves out what is 0 on a logarithmic axis; the title says so.
    axis = sheet.book.said_heading("Best objective f (m)")
    said = say(Message("answers.no_zeros", axis=axis), sheet.book.words.language)
    fall = (Series(title, place, 0, 2, colour=0),)
    chart = Chart(said, headings[0], headings[2], fall, log, size=_CHART)
    row = sheet.chart(chart, row=1, column=column)
    tension = words.name(_TENSION.name)
    series = (Series(tension, place, 0, 1, colour=1),)
    chart = Chart(tension, headings[0], headings[1], series, size=_CHART)
    sheet.chart(chart, row=row, column=column)
