"""The calculation note of a moored body as a workbook: a sheet for each part, native charts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.casefile.location import dotted
from catopt.casefile.schema import CaseTable
from catopt.quantities import QUANTITIES, Quantity
from catopt.report.page.inputs import FREE_TEXT, leaves
from catopt.report.page.line_drawing import grounded_ends
from catopt.report.page.system.checks import governing_words, of_what
from catopt.report.page.system.identity import identity
from catopt.report.page.system.note import SystemNote
from catopt.report.page.system.results import Value, rule_words, values_of
from catopt.report.page.verification import rough_words
from catopt.report.tables.summary import named
from catopt.report.tables.verify import part_sentence
from catopt.report.texts import Language, Words
from catopt.report.workbook.note import catalogue_of, components_of, input_rows
from catopt.report.workbook.note_cells import number_of, unit_of
from catopt.report.workbook.note_checks import check_row, compared_row, mesh_grid
from catopt.report.workbook.sheet import Book, Cell, Chart, Number, Series, Sheet, Style, Text

if TYPE_CHECKING:
    from catopt.mooring.response import Response
    from catopt.mooring.restoring import RestoringCurve
    from catopt.mooring.solution import LegState

__all__ = ["system_note_workbook"]

_SUMMARY = (52.0, 15.0, 10.0, 22.0, 10.0)
"""Widths of the summary's columns: quantity, value, unit, the same in SI."""
_SQUARE, _WIDE = (560, 520), (680, 420)
"""Pixels."""

ANGLE, LENGTH, TENSION, FORCE = (
    QUANTITIES[key] for key in ("angle", "offset", "tension", "horizontal_force")
)
VERTICAL, SPAN, GROUNDED = (
    QUANTITIES[key] for key in ("vertical_force", "span", "grounded_length")
)


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
    words = Words(language)
    book = Book(note.title or words(note.untitled), words, typeset=True)
    _summary(book, note)
    _inputs(book, note)
    parts = components_of(book, note.loaded.solution)
    parts.across(words("system_line_trail.of_line", line=note.solution.most_loaded + 1))
    catalogue_of(book, note.case)
    _lines(book, note)
    if note.checks.results:
        _checks(book, note)
    if note.report.line_out:
        _line_out(book, note)
    if note.report.circle is not None:
        _watch_circle(book, note)
    if note.report.curves:
        _restoring(book, note)
    if note.verification is not None or note.verification_failure:
        _verification(book, note)
    return book.close()


# ------------------------------------------------------------------ summary and inputs


def _summary(book: Book, note: SystemNote) -> None:
    """Write the title, what decides, warnings, the title block and the results of the body."""
    words = book.words
    sheet = book.sheet("Summary")
    sheet.worksheet.set_portrait()
    sheet.worksheet.fit_to_pages(1, 1)
    sheet.set_widths(_SUMMARY)
    sheet.across(note.title or words(note.untitled), "large")
    sheet.across(words(note.kind), "grey")
    block = identity(note, words)
    looks: dict[str, Style] = {"passes": "good", "fails": "bad"}
    for said, style in block["verdicts"]:
        sheet.across(said.text, looks.get(style, "wrapped"))
    if note.warnings:
        sheet.row += 1
        sheet.across(words("warnings.heading"), "title")
        for warning in note.warnings:
            sheet.across(words.sentence(warning).text)
    sheet.row += 1
    sheet.across(words("system_identity.heading"), "title")
    for label, value in block["table"].rows:
        sheet.pair(label.text, value.text)
    sheet.row += 1
    sheet.across(words("system_results.heading"), "title")
    headings = ("workbook.quantity", "workbook.value", "workbook.unit", "workbook.si")
    sheet.grid(
        [words(key) for key in (*headings, "workbook.si_unit")],
        list(_results(note, words)),
        widths=_SUMMARY,
        right=(1, 3),
    )
    if note.report.rule.why_not:
        why = words.sentence(note.report.rule.why_not).text
        sheet.across(f"{words('system_results.no_rule')} {why}.")
    if rule_words(note, words):
        sheet.across(rule_words(note, words))


def _results(note: SystemNote, words: Words) -> Iterator[Sequence[Cell]]:
    for each in values_of(note):
        yield _result(words(each.key), each)
    most_loaded = Number(note.solution.most_loaded + 1)
    yield Text(words("system_workbook.most_loaded"), "text"), most_loaded, None, None, None
    rule = note.report.rule
    if rule.horizontal_force is not None and rule.line is not None:
        name = words("system_workbook.by_rule", line=rule.line + 1)
        yield _result(name, Value("", FORCE, rule.horizontal_force))


def _result(name: str, each: Value) -> Sequence[Cell]:
    return (
        Text(name, "text"),
        number_of(each.quantity, each.value),
        Text(unit_of(each.quantity.field_unit), "text"),
        Number(each.value),
        Text(unit_of(each.quantity.si_unit), "text"),
    )


def _inputs(book: Book, note: SystemNote) -> None:
    """Write every value of the case file as it stands there and in SI."""
    words = book.words
    rows = [
        row
        for path, kind, value in leaves(note.origin.inputs, CaseTable)
        if path not in {(key,) for key in FREE_TEXT}
        for row in input_rows(dotted(path), kind, value)
    ]
    keys = ("inputs.key", "inputs.given", "inputs.si", "workbook.si_unit")
    book.sheet("Inputs").grid(
        [words(key) for key in keys], rows, widths=[44, 60, 22, 12], right=(2,)
    )


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
            *(_in_unit(name, quantity) for name, quantity in columns),
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


def _in_unit(name: str, quantity: Quantity) -> str:
    return f"{name} ({quantity.field_unit})"


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
    keys = ("check", "demand", "capacity", "utilisation", "verdict", "source", "note")
    heads = {key: words(f"checks.{key}") for key in keys}
    sheet.grid(
        [
            words("system_lines.line"), heads["check"], heads["demand"], heads["capacity"],
            words("workbook.unit"), heads["utilisation"], heads["verdict"], heads["source"],
            heads["note"],
        ],
        rows,
        widths=[10, 34, 16, 16, 8, 14, 18, 46, 40],
        right=(2, 3, 5),
    )  # fmt: skip
    about = (words("system_checks.about"), governing_words(note, words), words("checks.legend"))
    for text in (*about, words("workbook.governs")):
        sheet.across(text)


# ------------------------------------------------------------------ other states of the body


def _line_out(book: Book, note: SystemNote) -> None:
    """Write what happens when each line is gone."""
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
        _in_unit("x", LENGTH),
        _in_unit("y", LENGTH),
        _in_unit(words("system_workbook.yaw"), ANGLE),
        _in_unit(words("system_results.offset"), LENGTH),
        _in_unit(words("system_watch_circle.largest"), TENSION),
        words("system_lines.in_line"),
        _in_unit(words("system_workbook.anchor_tension"), TENSION),
        _in_unit(words("system_workbook.anchor_vertical"), VERTICAL),
        _in_unit(words("system_line_out.least_grounded"), GROUNDED),
    ]


def _watch_circle(book: Book, note: SystemNote) -> None:
    """Write where the force takes the body as it goes round, and draw both."""
    words, circle = book.words, note.report.circle
    assert circle is not None
    sheet = book.sheet("Watch circle", words("system_workbook.watch_circle"))
    rows: list[Sequence[Cell]] = [
        (number_of(ANGLE, direction), *_response(response))
        for direction, response in zip(circle.directions, circle.responses, strict=True)
    ]
    heads = [_in_unit(words("system_watch_circle.towards"), ANGLE), *_response_headings(words)]
    sheet.grid(heads, rows, widths=[13.0] * len(heads), right=range(len(heads)))
    sheet.across(words("system_workbook.force_of", force=FORCE.format(circle.force, unit=True)))
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


def _restoring(book: Book, note: SystemNote) -> None:
    """Write the restoring curves below each other, and draw them."""
    words = book.words
    sheet = book.sheet("Restoring", words("system_workbook.restoring"))
    heads = [
        _in_unit(words("system_workbook.along"), ANGLE),
        _in_unit(words("system_restoring.offset"), LENGTH),
        _in_unit(words("system_restoring.along"), FORCE),
        _in_unit(words("system_restoring.across"), FORCE),
        _in_unit(words("system_watch_circle.largest"), TENSION),
        words("system_lines.in_line"),
    ]
    rows = [row for curve in note.report.curves for row in _curve_rows(curve)]
    sheet.grid(heads, rows, widths=[14, 16, 16, 16, 16, 10], right=range(len(heads)))
    sheet.across(words("system_restoring.about"))
    series, first = [], 1
    for colour, curve in enumerate(note.report.curves):
        last = first + len(curve.offset) - 1
        name = words("system_restoring.towards", angle=ANGLE.format(curve.direction, unit=True))
        series.append(Series(name, (first, last), 1, 2, colour=colour))
        first = last + 1
    chart = Chart(
        words("system_restoring.heading"), heads[1],
        _in_unit(words("system_restoring.force"), FORCE), tuple(series), size=_WIDE,
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


def _verification(book: Book, note: SystemNote) -> None:
    """Write the closed form beside the truss model, or that the truss model has no answer."""
    words, part = book.words, note.compared
    sheet = book.sheet("Verification")
    if part is None:
        sheet.set_widths([120.0])
        sheet.across(words("system_verification.no_answer"), "bad")
        sheet.across(words.sentence(note.verification_failure).text)
        return
    meshes = [mesh.elements for mesh in part.meshes]
    sheet.grid(
        [
            words("system_lines.line"),
            words("workbook.quantity"),
            words("workbook.unit"),
            words("verification.closed_form"),
            words("verification.truss"),
            *(words("workbook.bars", count=count) for count in meshes),
            words("verification.gap"),
            words("verification.order"),
            words("checks.verdict"),
        ],
        [
            (
                Text(words("system_workbook.body"), "text")
                if each.line is None
                else Number(each.line + 1),
                *compared_row(each, words),
            )
            for each in part.quantities
        ],
        widths=[10, 30, 8, *[15.0] * (len(meshes) + 2), 16, 11, 14],
        right=(0, *range(3, 7 + len(meshes))),
    )
    sheet.across(words.sentence(part_sentence(part)).text, "good" if part.is_settled else "bad")
    remarks = (words.sentence(remark).text for remark in part.remarks)
    for text in (rough_words(part, words), *remarks, words("system_verification.legend")):
        if text:
            sheet.across(text)
    mesh_grid(sheet, part)
