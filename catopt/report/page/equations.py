"""The equation trail as tables."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from catopt.notes.line import Note
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table
from catopt.report.page.trail import Row, Step, digits, trail_of

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution

__all__ = ["equations", "followed", "steps_table"]


def equations(note: Note, words: Words) -> dict[str, Any]:
    """Build the steps, and for a line of several pieces what each contributes."""
    return followed(note.solution, words)


def followed(solution: Solution, words: Words) -> dict[str, Any]:
    """Follow a line through the equations: the steps, and its pieces where it has several."""
    trail = trail_of(solution)
    return {
        "steps": steps_table("trail", trail.steps, words),
        "rows": _rows(trail.rows, words) if trail.rows else None,
        "is_slack": solution.regime == "slack",
        "H": digits(solution.horizontal_force),
    }


def steps_table(
    key: str,
    steps: Iterable[Step],
    words: Words,
    *,
    is_numbered: bool = True,
    stated: str = "equations.stated",
) -> Table:
    """Tabulate steps: what comes out, its equation, its numbers put in, and what the solver has.

    Parameters
    ----------
    key : str
        Of the table.
    steps : iterable of Step
        A row each.
    words : Words
        Language.
    is_numbered : bool
        Whether the equations have numbers in docs/theory.md.
    stated : str
        Key of what stands beside each value.
    """
    headings = (
        Heading(words("table.what")),
        *((Heading(words("equations.equation")),) if is_numbered else ()),
        Heading(words("equations.put_in")),
        Heading(words("table.value"), is_number=True),
        Heading(words(stated), is_number=True),
    )
    return Table(key, headings, tuple(_step(step, words, is_numbered) for step in steps))


def _step(step: Step, words: Words, is_numbered: bool) -> tuple[Cell, ...]:
    return (
        Cell(words(step.name), style="words"),
        *((Cell(step.equation),) if is_numbered else ()),
        Cell(f"{step.formula}\n= {step.put_in}", style="formula"),
        _shown(step.value, step.unit),
        Cell("") if step.stated is None else _shown(step.stated, step.unit),
    )


def _shown(value: float, unit: str) -> Cell:
    """Show a value with its unit; an angle in degrees, but with its radians behind it."""
    if unit == "deg":
        return Cell(f"{digits(math.degrees(value))}°", value)
    return Cell(f"{digits(value)} {unit}".rstrip(), value)


def _rows(rows: tuple[Row, ...], words: Words) -> Table:
    headings = (
        Heading(words("equations.piece")),
        Heading(words("equations.lies")),
        *(
            Heading(text, is_number=True)
            for text in (
                "l (m)", "w (N/m)", "EA (N)", "V1 (N)", "V2 (N)", "T1 (N)", "T2 (N)", "Δx (m)",
                "Δz (m)",
            )
        ),
        Heading(words("equations.by")),
    )  # fmt: skip
    laid = []
    for row in rows:
        lies = words("equations.on_bed" if row.on_bed else "equations.hangs")
        EA = Cell("∞") if math.isinf(row.EA) else Cell(digits(row.EA), row.EA)
        numbers = (row.V1, row.V2, row.T1, row.T2, row.dx, row.dz)
        laid.append(
            (
                Cell(str(row.piece)),
                Cell(lies),
                Cell(digits(row.length), row.length),
                Cell(digits(row.weight), row.weight),
                EA,
                *(Cell(digits(value), value) for value in numbers),
                Cell(row.equation if row.on_bed else f"{row.equation}, C5"),
            )
        )
    return Table("pieces", headings, tuple(laid), words("equations.pieces"))
