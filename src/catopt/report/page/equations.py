"""The equation trail as tables."""

from __future__ import annotations

import math
from typing import Any

from catopt.report.page.note import Note
from catopt.report.page.table import Cell, Heading, Table
from catopt.report.page.trail import Row, Step, digits, trail_of
from catopt.report.texts import Words

__all__ = ["equations"]


def equations(note: Note, words: Words) -> dict[str, Any]:
    """Build the steps, and for a line of several pieces what each contributes."""
    trail = trail_of(note.solution)
    headings = (
        Heading(words("table.what")),
        Heading(words("equations.equation")),
        Heading(words("equations.put_in")),
        Heading(words("table.value"), is_number=True),
        Heading(words("equations.stated"), is_number=True),
    )
    steps = Table("trail", headings, tuple(_step(step, words) for step in trail.steps))
    return {
        "steps": steps,
        "rows": _rows(trail.rows, words) if trail.rows else None,
        "is_slack": note.solution.regime == "slack",
        "H": digits(note.solution.horizontal_force),
    }


def _step(step: Step, words: Words) -> tuple[Cell, ...]:
    return (
        Cell(words(step.name), style="words"),
        Cell(step.equation),
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
