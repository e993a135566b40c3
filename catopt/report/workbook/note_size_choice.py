"""Sheets of a sizing's workbook with what was chosen: the size, what holds it, where it swings."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from catopt.answers.check import QUANTITY_OF
from catopt.notes.size import SizeNote
from catopt.quantities import QUANTITIES, Quantity
from catopt.render.sheet import (
    Book,
    Cell,
    Chart,
    Number,
    Series,
    Sheet,
    Style,
    Text,
    number_pattern,
)
from catopt.render.texts import Words
from catopt.report.page.sizing.candidates import ROLES, candidate_verdict, failing_words
from catopt.report.page.sizing.hold import held, steps
from catopt.report.page.sizing.load_case import load_case_words
from catopt.report.page.sizing.pattern import line_rows
from catopt.report.page.sizing.put_in import typeset_unit
from catopt.report.page.sizing.swing import PARTS
from catopt.report.page.table import in_unit
from catopt.report.workbook.note_cells import headed, number_of, unit_of
from catopt.sizing.candidates import Candidate

if TYPE_CHECKING:
    from catopt.mooring.solution import SystemSolution
    from catopt.sizing.pattern import Pattern

__all__ = ["candidates_sheet", "hold_sheet", "pattern_sheet", "swing_sheet"]

_CHART = (620, 380)
"""Pixels."""

FORCE, LENGTH, MASS = (QUANTITIES[key] for key in ("horizontal_force", "length", "mass"))
TENSION, ANGLE = QUANTITIES["tension"], QUANTITIES["angle"]


def candidates_sheet(book: Book, note: SizeNote) -> None:
    """Write the recommended size between its neighbours, with a chart, and the steps that fail."""
    words = book.words
    sheet = book.sheet("Candidates", words("size_candidates.heading"))
    of = note.sizing
    span = QUANTITIES["span"]
    diameter = QUANTITIES["nominal_diameter"]
    headings = [
        words("size_candidates.which"),
        words("size_candidates.chain"),
        headed(words, diameter),
        headed(words, LENGTH),
        in_unit(words.name("Mass in air"), MASS),
        in_unit(f"{words.name('Largest span')} S", span),
        headed(words, FORCE),
        in_unit(words("size_candidates.anchor"), MASS),
        words("checks.verdict"),
    ]
    rows = [_candidate(each, words) for each in of.candidates]
    widths = [28.0, 28.0, *[12.0] * 6, 36.0]
    sheet.grid(headings, rows, widths=widths, right=range(2, 8))
    if of.limits:
        _limits(sheet, note)
    if all(each.settled is not None for each in of.candidates):
        best = next(i for i, each in enumerate(of.candidates, 1) if each.role == "recommended")
        series = (
            Series(words("size_candidates.table"), (1, len(rows)), 4, 5, "points", 0),
            Series(words("size_candidates.recommended"), (best, best), 4, 5, "points", 1, 11),
        )
        chart = Chart(
            words("size_candidates.heading"), headings[4], headings[5], series, size=_CHART
        )
        sheet.chart(chart, row=sheet.row, column=0)


def _limits(sheet: Sheet, note: SizeNote) -> None:
    """Write the steps from the recommended line that fail, and by what."""
    words = sheet.book.words
    rows: list[Sequence[Cell]] = []
    for each in note.sizing.limits:
        quantity = FORCE if each.check is None else QUANTITY_OF[each.check.kind]
        rows.append(
            (
                words.sentence(each.change).text,
                failing_words(each, words).text,
                number_of(quantity, None if each.check is None else each.check.demand),
                number_of(quantity, None if each.check is None else each.check.capacity),
                Text("" if each.check is None else quantity.field_unit, "text"),
            )
        )
    sheet.grid(
        [
            words("front.change"),
            words("size_candidates.fails_by"),
            words("checks.demand"),
            words("checks.capacity"),
            words("workbook.unit"),
        ],
        rows,
        title=words("size_candidates.limits"),
        right=(2, 3),
    )


def _candidate(of: Candidate, words: Words) -> Sequence[Cell]:
    point = None if of.settled is None else of.settled.point
    style: Style = "bad" if point is None else "good"
    verdict = Text(candidate_verdict(of, words).text, style)
    role, diameter = words(ROLES[of.role]), number_of(QUANTITIES["nominal_diameter"], of.diameter)
    if point is None:
        return role, of.component, diameter, *[None] * 5, verdict
    hardest = max(solution.horizontal_force for _, solution in point.checks.solutions)
    return (
        role,
        of.component,
        diameter,
        number_of(LENGTH, point.line.length),
        number_of(MASS, point.line.mass),
        number_of(QUANTITIES["span"], point.objectives["offset_m"]),
        number_of(FORCE, hardest),
        number_of(MASS, None if point.anchor is None else point.anchor.mass),
        verdict,
    )


def hold_sheet(book: Book, note: SizeNote) -> None:
    """Write the steps to the sinker or the drag anchor; no sheet where nothing was sized."""
    listed = steps(note)
    if not listed:
        return
    words = book.words
    sheet = book.sheet("Anchor", words("size_hold.heading"))
    rows: list[Sequence[Cell]] = [
        (
            words(each.key),
            Text(f"{each.symbol} = {each.equation}" if each.equation else each.symbol, "text"),
            each.put_in,
            number_of(each.quantity, each.value),
            Text(unit_of(typeset_unit(each.quantity.field_unit)), "text"),
            Number(each.value),
            words.name(each.source),
        )
        for each in listed
    ]
    sheet.grid(
        [
            words("table.what"),
            words("components.formula"),
            words("equations.put_in"),
            words("workbook.value"),
            words("workbook.unit"),
            words("workbook.si"),
            words("components.source"),
        ],
        rows,
        widths=[36, 22, 34, 13, 8, 20, 38],
        right=(3, 5),
    )
    sheet.across(held(note, words))


def swing_sheet(book: Book, note: SizeNote) -> None:
    """Write the parts of the swing radius; their sum is a formula."""
    words = book.words
    swing = note.sizing.swing
    sheet = book.sheet("Swing radius", words("size_swing.heading"))
    rows: list[Sequence[Cell]] = [
        (words(PARTS[name]), number_of(LENGTH, length)) for name, length in swing.parts
    ]
    total = Number(swing.total, number_pattern(LENGTH), f"=SUM(B2:B{len(rows) + 1})")
    rows.append((Text(words("size_swing.total"), "good"), total))
    if note.sizing.excursion is not None:
        is_body = note.sizing.pattern is not None
        said = words("size_pattern.offset" if is_body else "size_swing.way")
        rows.append((said, number_of(LENGTH, note.sizing.excursion)))
    headings = [
        words("size_swing.part"),
        in_unit(words("size_swing.length"), LENGTH),
    ]
    sheet.grid(headings, rows, widths=[60, 16], right=(1,))
    sheet.across(words("checks.under", name=load_case_words(swing.load_case, words)))


def pattern_sheet(book: Book, note: SizeNote) -> None:
    """Write the body in each load case, and what each line pulls; no sheet for one line."""
    of = note.sizing.pattern
    if of is None or note.around is None:
        return
    words = book.words
    sheet = book.sheet("Pattern", words("size_pattern.heading"))
    _states(sheet, of)
    for label, value in (
        (words("size_pattern.count"), Number(float(of.lines))),
        (in_unit(words("size_pattern.radius"), LENGTH), number_of(LENGTH, of.anchor_radius)),
        (in_unit(words("size_pattern.pretension"), FORCE), number_of(FORCE, of.pretension)),
    ):
        sheet.write(sheet.row, 0, Text(label))
        sheet.write(sheet.row, 1, value)
        sheet.row += 1
    sheet.row += 1
    _line_pulls(
        sheet,
        note.around,
        words("size_pattern.lines", load_case=load_case_words(of.hardest.load_case, words)),
    )


def _states(sheet: Sheet, of: Pattern) -> None:
    """Write the body at rest in each load case."""
    words = sheet.book.words
    columns: tuple[tuple[str, Quantity, str], ...] = (
        (words("size_pattern.force"), FORCE, "force"),
        (words("size_pattern.by_rule"), FORCE, "rule_force"),
        (words("size_pattern.by_equilibrium"), FORCE, "line_force"),
        (words.name(TENSION.name), TENSION, "tension"),
        (words("size_pattern.direction"), ANGLE, "direction"),
        (words("size_pattern.offset"), LENGTH, "offset"),
        (words("size_pattern.pull"), FORCE, "pull"),
    )
    sheet.grid(
        [
            words("identity.load_case"),
            *(in_unit(label, quantity) for label, quantity, _ in columns),
        ],
        [
            (
                load_case_words(state.load_case, words),
                *(number_of(quantity, getattr(state, key)) for _, quantity, key in columns),
            )
            for state in of.states
        ],
        widths=[26, *[17.0] * len(columns)],
        right=range(1, 1 + len(columns)),
    )


def _line_pulls(sheet: Sheet, around: SystemSolution, title: str) -> None:
    """Write the pull of each line on the body, with its two parts."""
    words = sheet.book.words
    quantities = (ANGLE, FORCE, TENSION, FORCE, FORCE)
    labels = (words("size_pattern.towards"), words.name(FORCE.name), words.name(TENSION.name))
    sheet.grid(
        [
            words("components.number"),
            *(
                in_unit(label, quantity)
                for label, quantity in zip((*labels, "Hx", "Hy"), quantities, strict=True)
            ),
        ],
        [
            (
                Number(number),
                *(number_of(q, value) for q, value in zip(quantities, each, strict=True)),
            )
            for number, each in enumerate(line_rows(around), start=1)
        ],
        title=title,
        right=range(6),
    )
