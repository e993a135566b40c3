"""The restoring curves: what it takes to hold the body at offsets along the force and across it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.figures.mooring import restoring as restoring_chart
from catopt.notes.line import MOST_FORCE
from catopt.notes.system import SystemNote
from catopt.quantities import QUANTITIES
from catopt.render.svg import svg
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, measured, number_heading

if TYPE_CHECKING:
    from catopt.mooring.restoring import RestoringCurve

__all__ = ["restoring"]

_EVERY = 4
"""One point in so many stands in the table; both ends and the middle are among them."""
FORCE, OFFSET, TENSION = (QUANTITIES[key] for key in ("horizontal_force", "offset", "tension"))


def restoring(note: SystemNote, words: Words) -> dict[str, Any] | None:
    """Build the figure and its tables; None where no curve could be computed."""
    curves = note.report.curves
    if not curves:
        return None
    chart = restoring_chart(curves, note.solution, MOST_FORCE)
    return {
        "figure": svg(chart, words.language),
        "tables": [_table(curve, words) for curve in curves],
        "turns": note.solution.system.turns,
    }


def _towards(curve: RestoringCurve, words: Words) -> str:
    angle = QUANTITIES["angle"].format(curve.direction, unit=True)
    return words("system_restoring.towards", angle=angle)


def _table(curve: RestoringCurve, words: Words) -> Table:
    rows = tuple(
        (
            measured(OFFSET, curve.offset[index]),
            measured(FORCE, curve.force[index]),
            measured(FORCE, curve.force_across[index]),
            measured(TENSION, curve.responses[index].largest_tension),
            Cell(str(curve.responses[index].most_loaded + 1)),
        )
        for index in range(0, len(curve.offset), _EVERY)
    )
    headings = (
        number_heading(words("system_restoring.offset"), OFFSET),
        number_heading(words("system_restoring.along"), FORCE),
        number_heading(words("system_restoring.across"), FORCE),
        number_heading(words("system_watch_circle.largest"), FORCE),
        Heading(words("system_lines.in_line"), is_number=True),
    )
    return Table("restoring", headings, rows, _towards(curve, words))
