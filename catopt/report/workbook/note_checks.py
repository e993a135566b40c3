"""Sheets of the note's workbook that judge: checks, the front, and the truss model."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from catopt.answers.check import QUANTITY_OF, load_case_table
from catopt.answers.design import OBJECTIVES
from catopt.figures.front import composition
from catopt.notes.line import Chosen, Note
from catopt.quantities import QUANTITIES
from catopt.render.sheet import Book, Cell, Chart, Number, Series, Sheet, Text
from catopt.render.texts import Words
from catopt.report.page.front_figure import (
    further_objectives,
    verdict_cell,
)
from catopt.report.page.verification import rough_words
from catopt.report.tables.verify import QUANTITY_OF as COMPARED
from catopt.report.tables.verify import part_sentence
from catopt.report.workbook.note_cells import headed, number_of, unit_of

if TYPE_CHECKING:
    from catopt.checks.result import CheckResult
    from catopt.verify.compared import Compared
    from catopt.verify.result import StaticComparison

__all__ = [
    "check_row",
    "checks_grid",
    "checks_sheet",
    "compared_sheet",
    "front_sheet",
    "load_cases_sheet",
    "neighbours_sheet",
    "no_answer_sheet",
    "verification_sheet",
]

_FRONT = (680, 420)
"""Pixels."""


def checks_sheet(book: Book, note: Note) -> None:
    """Write every check with its verdict; how far it is used is a formula. No sheet for none."""
    if not note.checks.results:
        return
    words = book.words
    sheet = book.sheet("Checks")
    rows = [
        check_row(check, row, words, governs=check is note.checks.governing)
        for row, check in enumerate(note.checks.results, start=2)
    ]
    checks_grid(sheet, rows, words("identity.load_case"), 16.0)
    for text in (words("checks.legend"), words("workbook.governs")):
        sheet.across(text)


def checks_grid(sheet: Sheet, rows: Sequence[Sequence[Cell]], of: str, width: float) -> None:
    """Write checks under their headings, at the top of a sheet.

    Parameters
    ----------
    sheet : Sheet
        Still empty.
    rows : sequence
        As `check_row` makes them.
    of : str
        Heading of the first column: what each check is of.
    width : float
        Of that column, in characters.
    """
    words = sheet.book.words
    sheet.grid(
        [
            of,
            words("checks.check"),
            words("checks.demand"),
            words("checks.capacity"),
            words("workbook.unit"),
            words("checks.utilisation"),
            words("checks.verdict"),
            words("checks.source"),
            words("checks.note"),
        ],
        rows,
        widths=[width, 34, 16, 16, 8, 14, 18, 46, 40],
        right=(2, 3, 5),
    )


def load_cases_sheet(book: Book, note: Note) -> None:
    """Write the line under each load case; no sheet where there is one alone."""
    if len(note.checks.solutions) > 1:
        book.sheet("Load cases").table(load_case_table(note.checks).to_dataframe())


def check_row(check: CheckResult, row: int, words: Words, *, governs: bool) -> Sequence[Cell]:
    """Lay a check out that stands in a row of the sheet, counted from 1."""
    quantity = QUANTITY_OF[check.kind]
    used = check.utilisation
    formula = "" if used is None else f"=C{row}/D{row}"
    verdict = words("checks.passes" if check.passes else "checks.fails")
    return (
        check.load_case,
        words.sentence(check.name).text,
        number_of(quantity, check.demand),
        number_of(quantity, check.capacity),
        Text(quantity.field_unit, "text"),
        Number(used, "0.000", formula),
        Text(f"{verdict} *" if governs else verdict, "good" if check.passes else "bad"),
        words.name(check.source.text),
        words.sentence(check.note).text,
    )


def front_sheet(book: Book, chosen: Chosen | None) -> None:
    """Write every design of the front, and draw two objectives of them; no sheet without one."""
    if chosen is None:
        return
    document, number = chosen.document, chosen.number
    words = book.words
    sheet = book.sheet("Front")
    front = document["front"]
    keys = [*document["objectives"], *further_objectives(document)]
    sinker = any(point.get("sinker") for point in front)
    rows = [
        (
            Number(index),
            *(number_of(OBJECTIVES[key], point[key]) for key in keys),
            composition(point),
            *((_sinker(point),) if sinker else ()),
            words.sentence(point["governing"]).text,
        )
        for index, point in enumerate(front, start=1)
    ]
    sheet.grid(
        [
            words("identity.design"),
            *(headed(words, OBJECTIVES[key]) for key in keys),
            words("front.made"),
            *((f"{words('front.sinker')} ({QUANTITIES['mass'].field_unit})",) if sinker else ()),
            words("checks.governing"),
        ],
        rows,
        widths=[11, *[13.0] * len(keys), 46.0, *[13.0] * sinker, 46.0],
        right=range(1, 1 + len(keys)),
    )
    best = document["recommended"] + 1
    places = [((1, len(front)), "front.design", 0, 6), ((best, best), "front.recommended", 1, 11)]
    if number != best:
        places.append(((number, number), "front.chosen", 2, 10))
    series = tuple(
        Series(words(text, number=rows[0]), rows, 1, 2, "points", colour, size)
        for rows, text, colour, size in places
    )
    x, y = (headed(words, OBJECTIVES[key]) for key in document["objectives"][:2])
    sheet.chart(
        Chart(words("front.heading"), x, y, series, size=_FRONT),
        row=1,
        column=len(rows[0]) + 1,
    )


def _sinker(point: dict[str, Any]) -> Number:
    return number_of(QUANTITIES["mass"], (point.get("sinker") or {}).get("mass_kg"))


def neighbours_sheet(book: Book, chosen: Chosen | None) -> None:
    """Write why a design is recommended and what one step does to it; no sheet without a front."""
    if chosen is None:
        return
    document = chosen.document
    words = book.words
    sheet = book.sheet("Neighbours")
    keys = [*document["objectives"], *further_objectives(document)]
    steps = [(words.sentence(each["change"]).text, each) for each in document.get("neighbours", ())]
    if document.get("present") is not None:
        steps.append((words("workbook.present"), document["present"]))
    sheet.grid(
        [
            words("front.change"),
            *(headed(words, OBJECTIVES[key]) for key in keys),
            words("checks.utilisation"),
            words("checks.verdict"),
        ],
        [
            (
                change,
                *(number_of(OBJECTIVES[key], step.get(key)) for key in keys),
                Number(step["utilisation"], "0.000"),
                Text(verdict_cell(step, words).text, "good" if step["feasible"] else "bad"),
            )
            for change, step in steps
        ],
        widths=[50, *[14.0] * len(keys), 14, 60],
        right=range(1, 2 + len(keys)),
    )
    number = document["recommended"] + 1
    told = [words("front.why", number=number), document.get("recommendation", "")]
    for text in (*told, *document.get("ends", ())):
        if text:
            sheet.across(words.sentence(text).text)


def verification_sheet(book: Book, note: Note) -> None:
    """Write the closed form of the line beside the truss model; no sheet where it was left out."""
    if note.verification is not None:
        compared_sheet(book, note.verification.static, "verification")
    elif note.verification_failure:
        no_answer_sheet(book, note.verification_failure, "verification")


def compared_sheet(
    book: Book, part: StaticComparison, group: str, of: Sequence[Cell] | None = None
) -> None:
    """Write the closed form beside the truss model.

    Parameters
    ----------
    book : Book
        Where to.
    part : StaticComparison
        Both on every mesh.
    group : str
        Of the texts: ``"verification"`` of a line, ``"system_verification"`` of a body.
    of : sequence of Cell, optional
        What each quantity is of, in a column before the others: the number of a line, or the body.
    """
    words = book.words
    sheet = book.sheet("Verification")
    meshes = [mesh.elements for mesh in part.meshes]
    headings = [
        words("workbook.quantity"),
        words("workbook.unit"),
        words("verification.closed_form"),
        words("verification.truss"),
        *(words("workbook.bars", count=count) for count in meshes),
        words("verification.gap"),
        words("verification.order"),
        words("checks.verdict"),
    ]
    rows = [_compared_row(each, words) for each in part.quantities]
    widths = [34.0, 8.0, *[15.0] * (len(meshes) + 2), 16.0, 11.0, 14.0]
    right = [*range(2, 6 + len(meshes))]
    if of is not None:
        headings = [words("system_lines.line"), *headings]
        rows = [(first, *row) for first, row in zip(of, rows, strict=True)]
        widths = [10.0, 30.0, *widths[1:]]
        right = [0, *(column + 1 for column in right)]
    sheet.grid(headings, rows, widths=widths, right=right)
    sheet.across(words.sentence(part_sentence(part)).text, "good" if part.is_settled else "bad")
    remarks = (words.sentence(remark).text for remark in part.remarks)
    for text in (rough_words(part, words), *remarks, words(f"{group}.legend")):
        if text:
            sheet.across(text)
    _mesh_grid(sheet, part)


def no_answer_sheet(book: Book, why: str, group: str) -> None:
    """Write that the truss model has no answer, and why; `group` as for `compared_sheet`."""
    sheet = book.sheet("Verification")
    sheet.set_widths([120.0])
    sheet.across(book.words(f"{group}.no_answer"), "bad")
    sheet.across(book.words.sentence(why).text)


def _mesh_grid(sheet: Sheet, part: StaticComparison) -> None:
    """Write the meshes of the truss model below what is there."""
    words = sheet.book.words
    sheet.row += 1
    sheet.grid(
        [
            words("verification.bars"),
            "",
            words("verification.residual"),
            words("verification.largest"),
        ],
        [
            (
                Number(mesh.elements),
                None,
                Number(mesh.residual, "0.0E+00"),
                Number(part.mesh_gap(number), "0.0E+00"),
            )
            for number, mesh in enumerate(part.meshes)
        ],
        title=words("verification.meshes"),
        right=(0, 2, 3),
    )


def _compared_row(each: Compared, words: Words) -> Sequence[Cell]:
    """Lay one quantity out, on every mesh."""
    quantity = COMPARED[each.quantity]
    verdict = words("verification.agrees" if each.agrees else "verification.differs")
    return (
        words.name(quantity.name),
        Text(unit_of(quantity.field_unit), "text"),
        number_of(quantity, each.closed_form),
        number_of(quantity, each.extrapolated),
        *(number_of(quantity, value) for value in each.fem),
        Number(each.gap, "0.0E+00"),
        Number(each.order, "0.00"),
        Text(verdict, "good" if each.agrees else "bad"),
    )
