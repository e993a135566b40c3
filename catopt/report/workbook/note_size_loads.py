"""Sheets of a sizing's workbook with its loads: forces, their sums, the numbers put in."""

from __future__ import annotations

from collections.abc import Sequence

from catopt.notes.size import SizeNote
from catopt.quantities import QUANTITIES
from catopt.render.sheet import (
    Book,
    Cell,
    Number,
    Text,
    number_pattern,
)
from catopt.report.page.sizing.load_case import load_case_words
from catopt.report.page.sizing.loads import forces, what_is_pushed
from catopt.report.page.sizing.put_in import put_in, typeset_formula, typeset_unit
from catopt.report.page.table import in_unit
from catopt.report.workbook.note_cells import headed, number_of

__all__ = ["loads_sheet", "numbers_sheet"]

FORCE = QUANTITIES["horizontal_force"]


def loads_sheet(book: Book, note: SizeNote) -> None:
    """Write every force with its formula, and the sum of each part as a formula of the sheet."""
    words = book.words
    sheet = book.sheet("Loads", words("size_loads.heading"))
    pushed = what_is_pushed(note, words)
    pattern = number_pattern(FORCE)
    rows: list[Sequence[Cell]] = []
    for each in note.sizing.settled.posed.loads:
        said = load_case_words(each.load_case, words)
        for on, part in zip(pushed, each.parts, strict=True):
            first = len(rows) + 2
            for of, force in forces(part):
                rows.append(
                    (
                        said,
                        on,
                        words.sentence(of.name).text,
                        number_of(FORCE, force),
                        typeset_formula(of.formula),
                        put_in(of.formula, of.numbers),
                        f"{of.source.document}, {of.source.clause}",
                        Text(of.source.confidence, "text"),
                        words.sentence(of.note).text,
                    )
                )
            total = FORCE.to_field(part.horizontal_force)
            formula = f"=SUM(D{first}:D{len(rows) + 1})"
            label = Text(words("size_loads.total"), "good")
            rows.append((said, on, label, Number(total, pattern, formula), *[None] * 5))
        if each.given:
            label = Text(words("size_loads.given"), "good")
            rows.append((said, None, label, number_of(FORCE, each.given), *[None] * 5))
    headings = [
        words("identity.load_case"),
        words("size_loads.on"),
        words("size_loads.name"),
        headed(words, FORCE),
        words("components.formula"),
        words("equations.put_in"),
        words("components.source"),
        words("components.confidence"),
        words("checks.note"),
    ]
    sheet.grid(headings, rows, widths=[18, 12, 26, 12, 20, 28, 36, 12, 24], right=(3,))
    sheet.across(words("size_loads.legend"))
    _sums(book, note)


def _sums(book: Book, note: SizeNote) -> None:
    """Write the sum of each load case, and what one of several lines is sized for."""
    words = book.words
    sheet = book.sheet("Sums", words("size_loads.sums_tab"))
    sizing = note.sizing
    forces_of = {s.name: s.horizontal_force for s in sizing.settled.posed.case.load_cases}
    depth = QUANTITIES["water_depth"]
    sheet.grid(
        [
            words("identity.load_case"),
            in_unit(words("size_loads.depth"), depth),
            in_unit(words("size_loads.sum"), FORCE),
            in_unit(words("size_loads.line"), FORCE),
        ],
        [
            (
                load_case_words(each.load_case, words),
                number_of(depth, each.depth),
                number_of(FORCE, each.horizontal_force),
                number_of(FORCE, forces_of[each.load_case]),
            )
            for each in sizing.settled.posed.loads
        ],
        widths=[30, 18, 18, 18],
        right=(1, 2, 3),
    )


def numbers_sheet(book: Book, note: SizeNote) -> None:
    """Write every number that was put into a formula, in SI and with all digits."""
    words = book.words
    pushed = what_is_pushed(note, words)
    rows: list[Sequence[Cell]] = [
        (
            load_case_words(each.load_case, words),
            on,
            words.sentence(of.name).text,
            Text(typeset_formula(number.symbol), "text"),
            words.sentence(number.meaning).text,
            Number(number.value),
            Text(typeset_unit(number.unit), "text"),
        )
        for each in note.sizing.settled.posed.loads
        for on, part in zip(pushed, each.parts, strict=True)
        for of in part.components
        for number in of.numbers
    ]
    if not rows:
        return
    sheet = book.sheet("Numbers", words("size_loads.numbers"))
    sheet.grid(
        [
            words("identity.load_case"),
            words("size_loads.on"),
            words("size_loads.name"),
            words("size_loads.symbol"),
            words("size_loads.meaning"),
            words("workbook.si"),
            words("workbook.si_unit"),
        ],
        rows,
        widths=[20, 14, 34, 12, 50, 22, 10],
        right=(5,),
    )
