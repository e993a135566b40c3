"""What the loads of wind, current and waves consist of."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from operator import attrgetter
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import (
    Rows,
    answered,
    labelled,
    measured,
    named,
    section,
    tabulate,
    texts,
)
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.loads.component import LoadComponent, Loads
    from catopt.loads.weathervane import ShipHeading


def loads_answer(of: Loads, *others: Loads, lyings: Sequence[ShipHeading] = ()) -> blocks.Answer:
    """Lay out the forces on a buoy or a ship, each with its formula, numbers and source.

    `others` are by other methods and stand in the same tables; `lyings` are the cases of which the
    worst is laid out.
    """
    every = (of, *others)
    how = Several(map(_explained, _components(every)), "\n")
    kinds = {
        "assumption": [said for each in every for said in each.assumptions],
        "warning": [said for each in every for said in each.warnings],
        "recalled (R)": [name for each in every for name in each.recalled],
    }
    words = ((term(kind), said) for kind, listed in kinds.items() for said in listed)
    whole = answered(
        "loads",
        of.title,
        *_headings(of, lyings),
        section(
            "terms.forces",
            forces_table(*every),
            blocks.Text(how, Message("loads.how"), "people"),
        ),
        section("columns.numbers", numbers_table(*every)),
        section("terms.notes", notes_table(words), *_notes(every)),
    )
    return replace(whole, card=tuple(_card(whole, every)))


def _card(whole: blocks.Answer, every: Sequence[Loads]) -> Iterator[blocks.CardBlock]:
    """Say what each method comes to, each force, and what was assumed."""
    forces = [
        blocks.Fact(
            labelled(term("horizontal force"), of.method if len(every) > 1 else ""),
            of.horizontal_force,
            named("horizontal_force", ""),
        )
        for of in every
    ]
    yield blocks.Facts("total", tuple(forces))
    lying, *_ = whole.sections
    for each in lying.blocks:
        if isinstance(each, blocks.Text) and not each.caption:
            yield blocks.Brief((each.said,), lines=2)
    yield forces_table(*every)
    notes = list(_notes(every))
    for each in reversed(notes):
        if isinstance(each, blocks.Warnings):
            yield from blocks.briefly(each.said, blocks.TO_BE_KNOWN, 3)
    assumed = (each.said for each in notes if isinstance(each, blocks.Text))
    yield from blocks.briefly(assumed, Message("answers.card_assumed"), 3)


def _headings(of: Loads, lyings: Sequence[ShipHeading]) -> Iterator[blocks.Section]:
    """Tabulate how the ship lies under each set of directions, and mark what is laid out."""
    if not lyings:
        return
    lying = Rows(lyings)
    k = next(k for k, each in enumerate(lyings) if each.loads.components == of.components)
    depths = lying.read("depth")
    table = tabulate(
        "headings",
        lying.texts("condition", lambda each: term(each.afloat.condition)),
        *([measured("water_depth", depths, symbol="")] if len(set(depths)) > 1 else []),
        lying.measured("angle", "directions.wind", "wind_from", symbol=""),
        lying.measured("angle", "directions.current", "current_from", symbol=""),
        lying.measured("angle", "directions.waves", "waves_from", symbol=""),
        lying.measured("angle", "heading", "heading", symbol=""),
        lying.measured("horizontal_force", "loads.horizontal_force", "force", symbol="F"),
        lying.texts("method", "loads.method", priority=1),
        caption=Message("loads.how_it_lies"),
        marked=k,
    )
    worst = lyings[k]
    said = Message(
        "loads.worst",
        force=Measure("horizontal_force", worst.loads.horizontal_force),
        condition=term(worst.afloat.condition),
        current=math.degrees(worst.directions.current),
        heading=math.degrees(worst.heading),
    )
    yield section("terms.headings", table, blocks.Text(said, only="people"))


def forces_table(*by: Loads) -> blocks.Table:
    """Tabulate the forces by one method or several, a row each, and their sum."""
    rows = [(of, each) for of in by for each in (*of.components, None)]
    methods, every = [of.method for of, _ in rows], [each for _, each in rows]
    forces = [of.horizontal_force if each is None else each.force for of, each in rows]
    total = term("horizontal force")

    def of_each(name: str, path: str, only: blocks.For = "files") -> blocks.Column:
        values = ["" if each is None else attrgetter(path)(each) for each in every]
        return texts(name, values, only=only)

    return tabulate(
        "loads",
        *([texts("method", methods, only="people")] if len(by) > 1 else []),
        texts("force", [total if each is None else each.name for each in every]),
        texts("axis", ["" if each is None else term(each.axis) for each in every]),
        measured("horizontal_force", forces, "force", symbol="F"),
        of_each("conf", "source.confidence", "people"),
        of_each("formula", "formula"),
        of_each("numbers", "numbers_text"),
        of_each("source", "source.text"),
        of_each("note", "note"),
        texts("method", methods, only="files"),
        caption=Message("terms.forces"),
    )


def numbers_table(*by: Loads) -> blocks.Table:
    """Tabulate every number that was put in, in SI and with all digits."""
    of, numbers = Rows(_components(by)).within("numbers")
    return tabulate(
        "numbers",
        of.texts("force", "name"),
        *numbers.own("symbol", "meaning"),
        numbers.of_row("value"),
        numbers.texts("unit", lambda each: each.unit or "-"),
        only="files",
    )


def _components(by: Iterable[Loads]) -> Iterable[LoadComponent]:
    """List the forces; what methods have in common, once."""
    return dict.fromkeys(each for of in by for each in of.components)


def notes_table(rows: Iterable[tuple[str, str]]) -> blocks.Table:
    """Tabulate what is said in words, each once, behind what kind of words it is."""
    once = dict.fromkeys(rows)
    kinds, said = ([row[at] for row in once] for at in range(2))
    return tabulate("notes", texts("kind", kinds), texts("text", said), only="files")


def _explained(of: LoadComponent) -> Message:
    """Explain a force: its formula, the numbers put in and the source."""
    head = Message("loads.follows", force=of.name, formula=of.formula)
    below = (of.numbers_text, of.source.text, of.note)
    return Several((head, *(part for part in below if part)), "\n  ")


def _notes(by: Sequence[Loads]) -> Iterator[blocks.Block]:
    for assumption in dict.fromkeys(each for of in by for each in of.assumptions):
        yield blocks.Text(assumption, only="people")
    warnings = list(dict.fromkeys(each for of in by for each in of.warnings))
    for of in by:
        if of.recalled:
            key = "loads.recalled_by" if len(by) > 1 else "loads.recalled"
            names = Several(of.recalled, ", ")
            warnings.append(Message(key, method=of.method, names=names))
    yield blocks.Warnings(tuple(warnings), "people")
