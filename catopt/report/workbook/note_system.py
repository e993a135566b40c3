"""The calculation note of a moored body as a workbook: a sheet for each part, native charts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.casefile.schema import CaseTable
from catopt.figures.line import grounded_ends
from catopt.notes.system import SystemNote
from catopt.quantities import QUANTITIES, Quantity
from catopt.render.sheet import Book, Cell, Chart, Number, Series, Sheet, Style, Text
from catopt.render.texts import Language, Words
from catopt.report.page.system.checks import governing_words, of_what
from catopt.report.page.system.identity import identity
from catopt.report.page.system.motion import body_table, lines_table, said_of
from catopt.report.page.system.results import rule_words, values_of
from catopt.report.page.table import in_unit
from catopt.report.tables.summary import named
from catopt.report.workbook.note_cells import number_of
from catopt.report.workbook.note_checks import (
    check_row,
    checks_grid,
    compared_sheet,
    no_answer_sheet,
)
from catopt.report.workbook.note_components import catalogue_sheet, components_sheet
from catopt.report.workbook.note_opening import (
    inputs_grid,
    new_book,
    summary_sheet,
    title_rows,
    value_grid,
    value_row,
    warning_rows,
)
from catopt.report.workbook.note_system_states import (
    line_out_sheet,
    restoring_sheet,
    watch_circle_sheet,
)

if TYPE_CHECKING:
    from catopt.mooring.solution import LegState

__all__ = ["system_note_workbook"]

_SUMMARY = (52.0, 15.0, 10.0, 22.0, 10.0)
"""Widths of the summary's columns: quantity, value, unit, the same in SI."""
_SQUARE = (560, 520)
"""Pixels."""

ANGLE, LENGTH, FORCE = (QUANTITIES[key] for key in ("angle", "offset", "horizontal_force"))
_TENSION = QUANTITIES["tension"]
SPAN, GROUNDED = QUANTITIES["span"], QUANTITIES["grounded_length"]


def system_note_workbook(note: SystemNote, language: Language = "en") -> bytes:
    """Lay the calculation note of a moored body out.

    The same note gives the same bytes.

    Parameters
    ----------
    note : SystemNote
        What it shows.
    language : {"en", "vi"}
        Of its words.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Summary, Inputs, Components and Lines; Catalogue, Checks,
        Line out, Watch circle, Restoring and Verification where there is something to show.
    """
    book = new_book(note, language)
    _summary(book, note)
    _inputs(book, note)
    parts = components_sheet(book, note.loaded.solution)
    parts.across(book.words("system_line_trail.of_line", line=note.solution.most_loaded + 1))
    catalogue_sheet(book, note.case)
    _lines(book, note)
    if note.checks.results:
        _checks(book, note)
    line_out_sheet(book, note)
    watch_circle_sheet(book, note)
    restoring_sheet(book, note)
    if note.verification is not None or note.verification_failure:
        _verification(book, note)
    if note.motion is not None:
        _motion(book, note)
    return book.close()


# ------------------------------------------------------------------ summary and inputs


def _summary(book: Book, note: SystemNote) -> None:
    """Write the title, what decides, warnings, the title block and the results of the body."""
    words = book.words
    sheet = summary_sheet(book, note, _SUMMARY)
    block = identity(note, words)
    looks: dict[str, Style] = {"passes": "good", "fails": "bad"}
    for said, style in block["verdicts"]:
        sheet.across(said.text, looks.get(style, "wrapped"))
    warning_rows(sheet, note)
    sheet.row += 1
    sheet.across(words("system_identity.heading"), "title")
    title_rows(sheet, block["table"])
    sheet.row += 1
    sheet.across(words("system_results.heading"), "title")
    value_grid(sheet, list(_results(note, words)), _SUMMARY)
    if note.report.rule.why_not:
        why = words.sentence(note.report.rule.why_not).text
        sheet.across(f"{words('system_results.no_rule')} {why}.")
    if rule_words(note, words):
        sheet.across(rule_words(note, words))


def _results(note: SystemNote, words: Words) -> Iterator[Sequence[Cell]]:
    for each in values_of(note):
        yield value_row(Text(words(each.key), "text"), each.quantity, each.value)
    most_loaded = Number(note.solution.most_loaded + 1)
    yield Text(words("system_workbook.most_loaded"), "text"), most_loaded, None, None, None
    rule = note.report.rule
    if rule.horizontal_force is not None and rule.line is not None:
        name = words("system_workbook.by_rule", line=rule.line + 1)
        yield value_row(Text(name, "text"), FORCE, rule.horizontal_force)


def _inputs(book: Book, note: SystemNote) -> None:
    """Write every value of the case file as it stands there and in SI."""
    inputs_grid(book.sheet("Inputs"), note.origin.inputs, CaseTable)


# ------------------------------------------------------------------ the lines


def _lines(book: Book, note: SystemNote) -> None:
    """Write what each line carries, and draw them from above."""
    words, factor = book.words, note.solution.safety_factor
    sheet = book.sheet("Lines", words("system_workbook.lines"))
    columns: list[tuple[str, Quantity]] = [
        (words("system_lines.azimuth"), ANGLE),
        (words("system_workbook.direction"), ANGLE),
        *(
            (words.name(quantity.name), quantity)
            for quantity in (
                FORCE, named("tension", "Fairlead tension"),
                named("vertical_force", "Fairlead vertical force"),
                named("tension", "Anchor tension"),
                named("horizontal_force", "Anchor horizontal force"),
                named("vertical_force", "Anchor vertical force"), SPAN, GROUNDED,
            )
        ),
    ]  # fmt: skip
    rows: list[Sequence[Cell]] = []
    for number, line in enumerate(note.solution.lines, start=1):
        own = line.solution
        values = (
            line.leg.azimuth, line.direction, line.horizontal_force, line.tension,
            own.fairlead.vertical_force, own.anchor.tension, own.anchor.horizontal_force,
            own.anchor.vertical_force, own.span, own.grounded_length,
        )  # fmt: skip
        cells = [number_of(q, value) for (_, q), value in zip(columns, values, strict=True)]
        used = Number(line.utilisation(factor), "0.000")
        rows.append((Number(number), line.leg.name, *cells, used))
    sheet.grid(
        [
            words("system_lines.line"),
            words("system_workbook.name"),
            *(in_unit(name, quantity) for name, quantity in columns),
            words("checks.utilisation"),
        ],
        rows,
        widths=[8, 16, *[13.0] * len(columns), 13],
        right=(0, *range(2, 3 + len(columns))),
    )
    is_known = any(line.utilisation(factor) is not None for line in note.solution.lines)
    shown = QUANTITIES["safety_factor"].format(factor)
    sheet.across(words("system_lines.used" if is_known else "system_lines.unknown", factor=shown))
    _plan(sheet, note)


def _plan(sheet: Sheet, note: SystemNote) -> None:
    """Write where each line is from above, and draw it."""
    words = sheet.book.words
    sheet.row += 1
    places = [place for line in note.solution.lines for place in _places(line)]
    body = (note.solution.position.x, note.solution.position.y)
    numbered = [
        (index, *place)
        for index, line in enumerate(note.solution.lines, start=1)
        for place in _places(line)
    ]
    rows: list[Sequence[Cell]] = [
        (Number(index), Text(words(key), "text"), number_of(LENGTH, x), number_of(LENGTH, y))
        for index, key, x, y in numbered
    ]
    rows.append(
        (None, Text(words("system_workbook.body"), "text"), *(number_of(LENGTH, v) for v in body))
    )
    top = sheet.grid(
        [words("system_lines.line"), words("workbook.mark"), "x (m)", "y (m)"],
        rows,
        right=(0, 2, 3),
    )
    series, row = [], top + 1
    for line in note.solution.lines:
        count = len(_places(line))
        if count > 2:
            series.append(Series(words("line.lies"), (row + 1, row + 2), 2, 3, colour=1))
        hangs = [(row + count - 2, row + count - 1)]
        if count > 2 and _places(line)[0][1:] != _places(line)[1][1:]:
            hangs.append((row, row + 1))
        series += [Series(words("system_plan.hangs"), ends, 2, 3) for ends in hangs]
        row += count
    series.append(Series(words("system_plan.body"), (row, row), 2, 3, "points", 3, 9))
    names = [each.name for each in series]
    hidden = tuple(index for index, name in enumerate(names) if name in names[:index])
    assert row == top + 1 + len(places)
    chart = Chart(
        words("system_workbook.plan"), "x (m)", "y (m)", tuple(series), size=_SQUARE, hidden=hidden
    )
    sheet.chart(chart, row=top, column=5)


def _places(line: LegState) -> list[tuple[str, float, float]]:
    """Find where a line is moored, where it lies, and where it meets the body: key, x and y."""
    lying = grounded_ends(line.solution)
    ends = [] if not lying else [line.at(lying[0][0]), line.at(lying[-1][1])]
    return [
        ("system_plan.anchor", *line.leg.anchor),
        *(("line.lies", *place) for place in ends),
        ("line.fairlead", *line.fairlead),
    ]


def _checks(book: Book, note: SystemNote) -> None:
    """Write every check with its verdict; how far it is used is a formula."""
    words = book.words
    sheet = book.sheet("Checks")
    governing = note.checks.governing
    rows = [
        check_row(
            replace(check, load_case=of_what(check.load_case, note, words)),
            row,
            words,
            governs=check is governing,
        )
        for row, check in enumerate(note.checks.results, start=2)
    ]
    checks_grid(sheet, rows, words("system_lines.line"), 10.0)
    about = (words("system_checks.about"), governing_words(note, words), words("checks.legend"))
    for text in (*about, words("workbook.governs")):
        sheet.across(text)


def _verification(book: Book, note: SystemNote) -> None:
    """Write the closed form beside the truss model, or that the truss model has no answer."""
    if note.compared is None:
        no_answer_sheet(book, note.verification_failure, "system_verification")
        return
    body = Text(book.words("system_workbook.body"), "text")
    of = [body if each.line is None else Number(each.line + 1) for each in note.compared.quantities]
    compared_sheet(book, note.compared, "system_verification", of)


# ------------------------------------------------------------------ in motion


def _motion(book: Book, note: SystemNote) -> None:
    """Write a row a line, where the body goes, and what is to be known."""
    found, words = note.motion, book.words
    assert found is not None
    sheet = book.sheet("Motion")
    unit = f" ({_TENSION.field_unit})"
    for table in (lines_table(note, words), body_table(found, words)):
        is_tension = [heading.text.endswith(unit) for heading in table.headings]
        rows: list[Sequence[Cell]] = [
            [
                number_of(_TENSION, each.si) if of_tension
                else each.text if each.si is None
                else Number(each.si)
                for each, of_tension in zip(row, is_tension, strict=True)
            ]
            for row in table.rows
        ]  # fmt: skip
        headings = [each.text for each in table.headings]
        sheet.grid(headings, rows, title=table.caption, right=range(1, len(headings)))
    for said in said_of(found, words):
        sheet.across(said.text)
    for remark in dict.fromkeys(each for part in found.parts for each in part.remarks):
        sheet.across(words.sentence(remark).text)
