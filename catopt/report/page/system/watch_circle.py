"""The watch circle: where the force takes the body as it goes round, and what the lines carry."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.figures.mooring import watch_round, watch_track
from catopt.notes.system import SystemNote
from catopt.quantities import QUANTITIES
from catopt.render.svg import svg
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, measured, number_heading

if TYPE_CHECKING:
    from catopt.mooring.response import Response
    from catopt.mooring.watch_circle import WatchCircle

__all__ = ["allowed_at_fairlead", "watch_circle"]

_EVERY = 10
"""One direction in so many stands in the table: 30 degrees of 120 directions."""
TENSION, OFFSET, ANGLE = QUANTITIES["tension"], QUANTITIES["offset"], QUANTITIES["angle"]


def watch_circle(note: SystemNote, words: Words) -> dict[str, Any] | None:
    """Build both figures and the table; None without a force or where it could not be computed."""
    circle = note.report.circle
    if circle is None:
        return None
    return {
        "track": svg(watch_track(note.solution, circle), words.language),
        "tension": svg(
            watch_round(note.solution, circle, allowed_at_fairlead(note)), words.language
        ),
        "table": _table(circle, words),
        "force": QUANTITIES["horizontal_force"].format(circle.force, unit=True),
        "turns": note.solution.system.turns,
    }


def allowed_at_fairlead(note: SystemNote) -> float | None:
    """Find the tension that the weakest line is allowed at its fairlead: MBL over the factor, N."""
    known = [leg.line.segments[-1].MBL for leg in note.solution.system.legs]
    if any(each is None for each in known):
        return None
    return min(each for each in known if each is not None) / note.solution.safety_factor


def _table(circle: WatchCircle, words: Words) -> Table:
    """Tabulate some directions, and those of the largest offset and the largest tension."""
    chosen = sorted({*range(0, len(circle.directions), _EVERY), circle.farthest, circle.hardest})
    rows = tuple(
        (measured(ANGLE, circle.directions[index]), *response_cells(circle.responses[index]))
        for index in chosen
    )
    headings = (
        number_heading(words("system_watch_circle.towards"), ANGLE),
        *response_headings(words),
    )
    return Table("watch_circle", headings, rows, words("system_watch_circle.some"))


def response_cells(response: Response | None) -> tuple[Cell, ...]:
    """Lay out where the body is and what its lines carry; dashes where it has no place of rest."""
    if response is None:
        return (*(measured(OFFSET, None) for _ in range(3)), measured(TENSION, None), Cell("–"),
                measured(QUANTITIES["grounded_length"], None))  # fmt: skip
    return (
        measured(OFFSET, response.x),
        measured(OFFSET, response.y),
        measured(OFFSET, response.offset),
        measured(TENSION, response.largest_tension),
        Cell(str(response.most_loaded + 1)),
        measured(QUANTITIES["grounded_length"], response.least_grounded),
    )


def response_headings(words: Words) -> tuple[Heading, ...]:
    """Head what `response_cells` lays out."""
    length, tension = OFFSET.field_unit, TENSION.field_unit
    return (
        Heading(f"x ({length})", is_number=True),
        Heading(f"y ({length})", is_number=True),
        Heading(f"{words('system_results.offset')} ({length})", is_number=True),
        Heading(f"{words('system_watch_circle.largest')} ({tension})", is_number=True),
        Heading(words("system_lines.in_line"), is_number=True),
        Heading(f"{words('system_line_out.least_grounded')} ({length})", is_number=True),
    )
