"""Closed form and truss model beside each other, in a note."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers.blocks import Block, Column, Section, Table, Text, Verdict, Warnings
from catopt.answers.note import column, note_section
from catopt.quantities import QUANTITIES
from catopt.verify.compared import ROUNDING, worst_of
from catopt.verify.truss_words import QUANTITY_OF, part_sentence
from catopt.words import Message, Several, term

if TYPE_CHECKING:
    from catopt.verify.compared import Compared
    from catopt.verify.result import StaticComparison, Verification

_PART = replace(QUANTITIES["residual"], si_unit="-", field_unit="-", digits=1)
"""A difference over its scale."""


def truss_section(found: Verification | None, failure: str) -> Iterator[Section]:
    """Lay out one line by both models, or say that there is no answer; nothing where left out."""
    if failure:
        said = (Verdict(Message("note.verification_no_answer"), passes=False), Text(failure))
        yield note_section("verification", said, "note.verification_heading")
    elif found is not None:
        part = found.static
        blocks = (
            Text(Message("note.verification_about")),
            Verdict(part_sentence(part), part.is_settled),
            compared_table(part.quantities),
            *truss_closing(part),
            Text(Message("note.verification_legend"), is_small=True),
        )
        yield note_section("verification", blocks, "note.verification_heading")


def compared_table(quantities: Iterable[Compared], caption: str = "") -> Table:
    """Tabulate quantities by both models, and how far these are apart."""
    every = list(quantities)
    units = tuple(QUANTITY_OF[each.quantity] for each in every)
    closed, truss = (each.closed_form for each in every), (each.extrapolated for each in every)
    orders = (each.order for each in every)
    return Table(
        "verification",
        (
            column("columns.quantity", (_label(each) for each in every)),
            Column(Message("note.verification_closed_form"), tuple(closed), units=units),
            Column(Message("note.verification_truss"), tuple(truss), units=units),
            differences("note.verification_gap", [each.gap for each in every]),
            column("note.verification_order", (_order(each) for each in orders)),
            _verdicts([each.agrees for each in every]),
        ),
        caption,
        only="not csv",
    )


def _label(each: Compared) -> str:
    quantity = QUANTITY_OF[each.quantity]
    name = term(quantity.name)
    if not quantity.symbol:
        return name
    return Message("words.label", name=name, symbol=quantity.symbol)


def _order(order: float | None) -> str:
    """Write an order: it is of differences near rounding, and its digits beyond that are chance."""
    return "-" if order is None else f"{order:.2f}"


def differences(key: str, gaps: Iterable[float]) -> Column:
    """List differences over their scales; what is rounding is chance and has no value."""
    shown = tuple(f"<{ROUNDING:.0e}" if gap < ROUNDING else gap for gap in gaps)
    return Column(Message(key), shown, _PART)


def _verdicts(agree: Iterable[bool]) -> Column:
    passes = tuple(agree)
    words = ("note.verification_agrees" if each else "note.verification_differs" for each in passes)
    return Column(Message("columns.verdict"), tuple(map(Message, words)), passes=passes)


def largest_table(part: StaticComparison, caption: str) -> Table:
    """Tabulate the largest difference of each line."""
    every = [
        [each for each in part.quantities if each.line == index] for index in range(len(part.lines))
    ]
    worst = [worst_of(own) for own in every]
    return Table(
        "compared_lines",
        (
            column("columns.line", range(1, len(every) + 1)),
            column("columns.quantity", (term(QUANTITY_OF[of.quantity].name) for of in worst)),
            differences("note.verification_gap", [each.gap for each in worst]),
            _verdicts([all(each.agrees for each in own) for own in every]),
        ),
        caption,
        only="not csv",
    )


def truss_closing(part: StaticComparison) -> Iterator[Block]:
    """Say what was not extrapolated and what was remarked on, and tabulate the meshes."""
    if part.rough:
        names = Several((term(QUANTITY_OF[each.quantity].name) for each in part.rough), ", ")
        yield Text(Message("note.verification_rough", names=names))
    yield Warnings(tuple(part.remarks))
    gaps = [part.mesh_gap(number) for number in range(len(part.meshes))]
    yield Table(
        "meshes",
        (
            column("note.verification_bars", (mesh.elements for mesh in part.meshes)),
            column("note.verification_residual", (mesh.residual for mesh in part.meshes), _PART),
            differences("note.verification_largest", gaps),
        ),
        Message("note.verification_meshes"),
        only="not csv",
    )
