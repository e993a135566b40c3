"""Sheets of the note's workbook with the parts of a line, and where their figures come from."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from catopt.answers.solution import point_loads_table, segments_table
from catopt.quantities import QUANTITIES
from catopt.render.sheet import Book, Cell, Number, Sheet, Text
from catopt.report.page.components import figures_of, looked_up, point_load_quantities, sources_of
from catopt.report.page.table import called
from catopt.report.workbook.note_cells import headed, number_of

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.model import Case, Line

__all__ = ["catalogue_sheet", "components_sheet"]


def components_sheet(book: Book, solution: Solution) -> Sheet:
    """Write the figures of a line's parts, and what they carry; return the sheet."""
    words = book.words
    sheet = book.sheet("Components")
    line = solution.line
    keys = ("nominal_diameter", "length", "submerged_weight", "mass_per_length", "EA", "MBL")
    quantities = [QUANTITIES[key] for key in (*keys, "proof_load")]
    rows: list[Sequence[Cell]] = []
    for index, s in enumerate(line.segments, start=1):
        own = (
            s.nominal_diameter, s.length, s.submerged_weight, s.mass, s.EA, s.MBL, s.proof_load
        )  # fmt: skip
        numbers = [number_of(q, value) for q, value in zip(quantities, own, strict=True)]
        rows.append((Number(index), s.name or s.component, *numbers))
    headings = [words("components.segment"), words("components.name")]
    widths = (12, 34, 16, 16, 16, 16, 16, 16, 16)
    flush = range(2, 2 + len(quantities))
    sheet.grid([*headings, *(headed(words, q) for q in quantities)], rows,
        widths=widths, right=flush,
    )  # fmt: skip
    if line.point_loads:
        _point_loads(sheet, line)
    sheet.table(segments_table(solution).to_dataframe(), title=words("workbook.carried"))
    if line.point_loads:
        sheet.table(
            point_loads_table(solution).to_dataframe(), title=words("workbook.loads_carried")
        )
    return sheet


def _point_loads(sheet: Sheet, line: Line) -> None:
    words = sheet.book.words
    quantities = point_load_quantities(line)
    rows: list[Sequence[Cell]] = []
    for index, load in enumerate(line.point_loads, start=1):
        figures = (load.position, load.submerged_weight, load.mass, load.friction)
        values = zip(quantities, figures, strict=False)
        name = called(words, load.submerged_weight, load.name)
        rows.append((Number(index), name, *(number_of(q, value) for q, value in values)))
    headings = [words("components.number"), words("components.name")]
    sheet.grid(
        [*headings, *(headed(words, q) for q in quantities)],
        rows,
        title=words("components.point_loads"),
        right=range(2, 2 + len(quantities)),
    )


def catalogue_sheet(book: Book, case: Case) -> None:
    """Write where every figure of the catalogue comes from that a case rests on; or no sheet."""
    words = book.words
    parts = list(looked_up(case))
    if not parts:
        return
    sheet = book.sheet("Catalogue")
    rows: list[Sequence[Cell]] = [
        (
            part.component.name,
            words.name(each.name),
            number_of(each.quantity, each.value),
            Text(each.quantity.field_unit, "text"),
            each.formula,
            Text(each.confidence, "text"),
            each.source or words("components.case_file"),
        )
        for part in parts
        for each in figures_of(part)
    ]
    sheet.grid(
        [
            words("workbook.component"),
            words("components.quantity"),
            words("components.value"),
            words("workbook.unit"),
            words("components.formula"),
            words("components.confidence"),
            words("components.source"),
        ],
        rows,
        widths=[30, 30, 14, 9, 34, 14, 60],
        right=(2,),
    )
    told = [f"{s.key}: {s.title}{f'. {s.place}' if s.place else ''}" for s in sources_of(parts)]
    for text in (words("components.legend"), *told):
        sheet.across(text)
