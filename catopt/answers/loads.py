"""What the loads of wind, current and waves consist of."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Section,
    Table,
    Text,
    Warnings,
    measured,
    of_row,
    texts,
)
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.loads.component import LoadComponent, Loads
    from catopt.loads.weathervane import Lying


def loads_answer(of: Loads, *others: Loads, lyings: Sequence[Lying] = ()) -> Answer:
    """Lay out the forces on a buoy or a ship, each with its formula, numbers and source.

    `others` are by other methods and stand in the same tables; `lyings` are the cases of which the
    worst is laid out.
    """
    forces = Message("terms.forces")
    every = (of, *others)
    return Answer(
        "loads",
        of.title,
        (
            *_headings(of, lyings),
            Section(forces, (forces_table(*every), _how(every))),
            Section(Message("columns.numbers"), (numbers_table(*every),)),
            Section(Message("terms.notes"), (_notes_table(every), *_notes(every))),
        ),
    )


def _headings(of: Loads, lyings: Sequence[Lying]) -> Iterator[Section]:
    """Tabulate how the ship lies under each set of directions, and mark what is laid out."""
    if not lyings:
        return
    forces = [each.loads.horizontal_force for each in lyings]
    worst = next(k for k, each in enumerate(lyings) if each.loads.components == of.components)
    directions = [each.directions for each in lyings]

    def angles(name: str, values: Iterable[float]) -> Column:
        return measured("angle", values, name, symbol="")

    table = Table(
        "headings",
        (
            texts("condition", (term(each.afloat.condition) for each in lyings)),
            *_depths(lyings),
            angles("wind_from", (each.wind for each in directions)),
            angles("current_from", (each.current for each in directions)),
            angles("waves_from", (each.waves for each in directions)),
            angles("heading", (each.heading for each in lyings)),
            measured("horizontal_force", forces, "force", symbol="F"),
            texts("method", (each.loads.method for each in lyings), priority=1),
        ),
        Message("loads.how_it_lies"),
        marked=worst,
    )
    said = Message(
        "loads.worst",
        force=Measure("horizontal_force", forces[worst]),
        condition=term(lyings[worst].afloat.condition),
        current=math.degrees(directions[worst].current),
        heading=math.degrees(lyings[worst].heading),
    )
    yield Section(Message("terms.headings"), (table, Text(said, only="people")))


def _depths(lyings: Sequence[Lying]) -> Iterator[Column]:
    """Tabulate the depths of the water where there are several."""
    depths = [each.depth for each in lyings]
    if len(set(depths)) > 1:
        yield measured("water_depth", depths, symbol="")


def forces_table(*by: Loads) -> Table:
    """Tabulate the forces by one method or several, a row each, and their sum."""
    rows = [(of, each) for of in by for each in (*of.components, None)]
    every = [each for _, each in rows]
    methods = [of.method for of, _ in rows]

    def of_each(value: Callable[[LoadComponent], str]) -> list[str]:
        return ["" if each is None else value(each) for each in every]

    forces = [of.horizontal_force if each is None else each.force for of, each in rows]
    total = term("horizontal force")
    return Table(
        "loads",
        (
            *((texts("method", methods, only="people"),) if len(by) > 1 else ()),
            texts("force", [total if each is None else each.name for each in every]),
            texts("axis", of_each(lambda each: term(each.axis))),
            measured("horizontal_force", forces, "force", symbol="F"),
            texts("conf", of_each(lambda each: each.source.confidence), only="people"),
            texts("formula", of_each(lambda each: each.formula), only="files"),
            texts("numbers", of_each(lambda each: each.numbers_text), only="files"),
            texts("source", of_each(lambda each: each.source.text), only="files"),
            texts("note", of_each(lambda each: each.note), only="files"),
            texts("method", methods, only="files"),
        ),
        Message("terms.forces"),
    )


def numbers_table(*by: Loads) -> Table:
    """Tabulate every number that was put in, in SI and with all digits."""
    rows = [(each.name, number) for each in _components(by) for number in each.numbers]
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


def _components(by: Iterable[Loads]) -> Iterable[LoadComponent]:
    """List the forces; what methods have in common, once."""
    return dict.fromkeys(each for of in by for each in of.components)


def _notes_table(by: Sequence[Loads]) -> Table:
    rows = dict.fromkeys(
        (term(kind), said)
        for kind, every in (
            ("assumption", [said for of in by for said in of.assumptions]),
            ("warning", [said for of in by for said in of.warnings]),
            ("recalled (R)", [name for of in by for name in of.recalled]),
        )
        for said in every
    )
    return Table(
        "notes",
        (texts("kind", [kind for kind, _ in rows]), texts("text", [said for _, said in rows])),
        only="files",
    )


def _how(by: Sequence[Loads]) -> Text:
    """Explain each force: its formula, the numbers put in and the source."""
    explained = Several((_explained(each) for each in _components(by)), "\n")
    return Text(explained, Message("loads.how"), "people")


def _explained(of: LoadComponent) -> Message:
    head = Message("loads.follows", force=of.name, formula=of.formula)
    below = (of.numbers_text, of.source.text, of.note)
    return Several((head, *(part for part in below if part)), "\n  ")


def _notes(by: Sequence[Loads]) -> Iterator[Block]:
    for assumption in dict.fromkeys(each for of in by for each in of.assumptions):
        yield Text(assumption, only="people")
    warnings = list(dict.fromkeys(each for of in by for each in of.warnings))
    for of in by:
        if of.recalled:
            key = "loads.recalled_by" if len(by) > 1 else "loads.recalled"
            names = Several(of.recalled, ", ")
            warnings.append(Message(key, method=of.method, names=names))
    yield Warnings(tuple(warnings), "people")
