"""What came out: the line as a whole, its segments and point loads, and the load cases."""

from __future__ import annotations

from typing import Any

from catopt.notes.line import Note
from catopt.quantities import QUANTITIES
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, label_of, measured, shown_si, units
from catopt.report.tables.summary import Entry, found, named, residuals
from catopt.report.tables.summary import results as entries

__all__ = ["load_cases", "results"]


def results(note: Note, words: Words) -> dict[str, Any]:
    """Build the tables of results."""
    solution = note.solution
    listed = (*found(solution), *entries(solution), *residuals(solution))
    rows = tuple(_row(entry, words) for entry in listed if entry.value is not None)
    headings = (
        Heading(words("table.what")),
        Heading(words("table.value"), is_number=True),
        Heading(words("inputs.si"), is_number=True),
    )
    return {
        "table": Table("results", headings, rows),
        "point_loads": _point_loads(note, words) if solution.point_loads else None,
        "condition": None if solution.found is None else words.sentence(solution.found.condition),
    }


def _row(entry: Entry, words: Words) -> tuple[Cell, ...]:
    assert entry.value is not None
    quantity = entry.quantity
    label = label_of(words, quantity)
    ways = (quantity, *entry.also)
    shown = " = ".join(each.format(entry.value, unit=True) for each in ways)
    return (
        Cell(label, style="words"),
        Cell(shown, entry.value),
        Cell(shown_si(entry.value, quantity.si_unit)),
    )


def _point_loads(note: Note, words: Words) -> Table:
    quantities = [QUANTITIES[key] for key in ("x", "z", "seabed_reaction")]
    rows = []
    for index, load in enumerate(note.solution.point_loads, start=1):
        values = zip(quantities, (load.x, load.z, load.seabed_reaction), strict=True)
        name = f"{index} {load.name}".strip()
        rows.append((Cell(name), *(measured(quantity, value) for quantity, value in values)))
    headings = (
        Heading(words("components.number")),
        *(units(words, quantity) for quantity in quantities),
    )
    return Table("point_load_results", headings, tuple(rows), words("components.point_loads"))


def load_cases(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the table of load cases; None where there is only one."""
    states = note.checks.solutions
    if len(states) < 2:
        return None
    quantities = (
        QUANTITIES["horizontal_force"],
        QUANTITIES["fairlead_height"],
        QUANTITIES["span"],
        named("tension", "Fairlead tension"),
        named("horizontal_force", "Anchor horizontal force", ""),
        named("vertical_force", "Anchor vertical force", ""),
        QUANTITIES["grounded_length"],
    )
    rows = []
    marked = None
    for index, (name, solution) in enumerate(states):
        values = (
            solution.horizontal_force,
            solution.fairlead_height,
            solution.span,
            solution.fairlead.tension,
            solution.anchor.horizontal_force,
            solution.anchor.vertical_force,
            solution.grounded_length,
        )
        kind = note.checks.load_cases[index].kind
        cells = (measured(each, value) for each, value in zip(quantities, values, strict=True))
        rows.append((Cell(name), Cell(words.name(kind)), *cells))
        marked = index if name == note.load_case else marked
    headings = (
        Heading(words("identity.load_case")),
        Heading(words("load_cases.kind")),
        *(units(words, quantity) for quantity in quantities),
    )
    return {"table": Table("load_cases", headings, tuple(rows), marked=marked)}
