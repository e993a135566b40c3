"""The verification: the closed form beside the truss model, quantity by quantity."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from catopt.notes.line import Note
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, label_of, measured
from catopt.report.tables.verify import QUANTITY_OF, in_parts, part_sentence
from catopt.verify.compared import ROUNDING

if TYPE_CHECKING:
    from catopt.verify.compared import Compared
    from catopt.verify.result import StaticComparison

__all__ = ["compared_table", "difference_cell", "mesh_table", "rough_words", "verification"]


def verification(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the tables of both models, or say that there is no answer; None where left out."""
    if note.verification_failure:
        return {"failure": words.sentence(note.verification_failure)}
    if note.verification is None:
        return None
    part = note.verification.static
    return {
        "failure": None,
        "verdict": words.sentence(part_sentence(part)),
        "agrees": part.is_settled,
        "quantities": compared_table(part.quantities, words),
        "meshes": mesh_table(part, words),
        "rough": rough_words(part, words),
        "remarks": [words.sentence(remark) for remark in part.remarks],
    }


def rough_words(part: StaticComparison, words: Words) -> str:
    """Name the quantities that are not extrapolated; empty where all are."""
    names = ", ".join(words.name(QUANTITY_OF[each.quantity].name) for each in part.rough)
    return words("verification.rough", names=names) if names else ""


def compared_table(quantities: Iterable[Compared], words: Words, caption: str = "") -> Table:
    """Tabulate quantities by both models, and how far these are apart."""
    headings = (
        Heading(words("workbook.quantity")),
        Heading(words("verification.closed_form"), is_number=True),
        Heading(words("verification.truss"), is_number=True),
        Heading(words("verification.gap"), is_number=True),
        Heading(words("verification.order"), is_number=True),
        Heading(words("checks.verdict")),
    )
    rows = tuple(_row(each, words) for each in quantities)
    return Table("verification", headings, rows, caption)


def _row(each: Compared, words: Words) -> tuple[Cell, ...]:
    quantity = QUANTITY_OF[each.quantity]
    agrees = words("verification.agrees" if each.agrees else "verification.differs")
    # The order is of differences near rounding: its digits beyond these are chance.
    order = "–" if each.order is None else f"{each.order:.2f}"
    return (
        Cell(label_of(words, quantity), style="words"),
        measured(quantity, each.closed_form, unit=True),
        measured(quantity, each.extrapolated, unit=True),
        difference_cell(each.gap),
        Cell(order),
        Cell(agrees, style="passes" if each.agrees else "fails"),
    )


def mesh_table(part: StaticComparison, words: Words) -> Table:
    """Tabulate the meshes of the truss model."""
    headings = (
        Heading(words("verification.bars"), is_number=True),
        Heading(words("verification.residual"), is_number=True),
        Heading(words("verification.largest"), is_number=True),
    )
    rows = tuple(
        (
            Cell(str(mesh.elements), mesh.elements),
            Cell(f"{mesh.residual:.1e}", mesh.residual),
            difference_cell(part.mesh_gap(number)),
        )
        for number, mesh in enumerate(part.meshes)
    )
    return Table("meshes", headings, rows, words("verification.meshes"))


def difference_cell(gap: float) -> Cell:
    """Show a difference over its scale; what is rounding is chance and has no value."""
    return Cell(f"<{ROUNDING:.0e}") if gap < ROUNDING else Cell(in_parts(gap), gap)
