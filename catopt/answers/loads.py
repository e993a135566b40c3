"""What the loads of wind, current and waves consist of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Block,
    Section,
    Table,
    Text,
    Warnings,
    measured,
    of_row,
    texts,
)
from catopt.words import Message, Several, term

if TYPE_CHECKING:
    from catopt.loads.component import LoadComponent, Loads

__all__ = ["forces_table", "loads_answer", "numbers_table"]


def loads_answer(of: Loads) -> Answer:
    """Lay out the forces on a buoy or a ship, each with its formula, numbers and source.

    Parameters
    ----------
    of : Loads
        What came out.
    """
    forces = Message("terms.forces")
    return Answer(
        "loads",
        of.title,
        (
            Section(forces, (forces_table(of), _how(of))),
            Section(Message("columns.numbers"), (numbers_table(of),)),
            Section(Message("terms.notes"), (_notes_table(of), *_notes(of))),
        ),
    )


def forces_table(of: Loads) -> Table:
    """Tabulate the forces, a row each, and their sum."""
    every = of.components
    return Table(
        "loads",
        (
            texts("force", [*(each.name for each in every), term("horizontal force")]),
            texts("axis", [*(term(each.axis) for each in every), ""]),
            measured(
                "horizontal_force",
                [*(each.force for each in every), of.horizontal_force],
                "force",
                symbol="F",
            ),
            texts("conf", [*(each.source.confidence for each in every), ""], only="people"),
            texts("formula", [*(each.formula for each in every), ""], only="files"),
            texts("numbers", [*(each.numbers_text for each in every), ""], only="files"),
            texts("source", [*(each.source.text for each in every), ""], only="files"),
            texts("note", [*(each.note for each in every), ""], only="files"),
        ),
        Message("terms.forces"),
    )


def numbers_table(of: Loads) -> Table:
    """Tabulate every number that was put in, in SI and with all digits."""
    rows = [(each.name, number) for each in of.components for number in each.numbers]
    numbers = [number for _, number in rows]
    return Table(
        "numbers",
        (
            texts("force", [name for name, _ in rows]),
            texts("symbol", [each.symbol for each in numbers]),
            texts("meaning", [each.meaning for each in numbers]),
            of_row("value", [each.value for each in numbers]),
            texts("unit", [each.unit or "-" for each in numbers]),
        ),
        only="files",
    )


def _notes_table(of: Loads) -> Table:
    """Tabulate assumptions and warnings."""
    kinds = {"assumption": of.assumptions, "warning": of.warnings, "recalled (R)": of.recalled}
    rows = [(term(kind), said) for kind, every in kinds.items() for said in every]
    return Table(
        "notes",
        (texts("kind", [kind for kind, _ in rows]), texts("text", [said for _, said in rows])),
        only="files",
    )


def _how(of: Loads) -> Text:
    """Explain each force: its formula, the numbers put in and the source."""
    explained = Several((_explained(each) for each in of.components), "\n")
    return Text(explained, Message("loads.how"), "people")


def _explained(of: LoadComponent) -> Message:
    head = Message("loads.follows", force=of.name, formula=of.formula)
    below = (of.numbers_text, of.source.text, of.note)
    return Several((head, *(part for part in below if part)), "\n  ")


def _notes(of: Loads) -> Iterator[Block]:
    for assumption in of.assumptions:
        yield Text(assumption, only="people")
    warnings = list(of.warnings)
    if of.recalled:
        warnings.append(Message("loads.recalled", names=Several(of.recalled, ", ")))
    yield Warnings(tuple(warnings), "people")
