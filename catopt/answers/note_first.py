"""The first page of a note, the same for every kind, and who answers for it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

from catopt.answers.blocks import Block, Column, Points, Section, Table, Text, Verdict
from catopt.answers.check import governing_sentence, verdict_sentence
from catopt.answers.note import column, note_section, title_block, warnings_section
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Cited, Measure, Message, Several

if TYPE_CHECKING:
    from catopt.notes.origin import Origin
    from catopt.notes.sheet import Sheet

_DIGITS = 4
"""Of a number on the first page: more than what it rests on is known to."""


class Number(NamedTuple):
    """One of the four numbers that matter: its name, the key of its quantity, its value in SI."""

    name: str
    key: str
    value: float


@dataclass(frozen=True)
class FirstPage:
    """What the first page shows.

    Attributes
    ----------
    said : str
        The answer in a sentence.
    drawing : iterable of Block
        Of the mooring.
    force, reach : Number
        What pulls, and how far the mooring lets go.
    tension : float
        Largest at a fairlead, N.
    also : tuple of str
        What is to be read with the answer.
    not_covered : tuple of str
        What the answer leaves out, beside what every answer does.
    in_motion : bool
        Whether the lines were run in time, too.
    reserve : str
        What fails beside checks that pass; empty where nothing does.
    """

    said: str
    drawing: Iterable[Block]
    force: Number
    reach: Number
    tension: float
    also: tuple[str, ...] = ()
    not_covered: tuple[str, ...] = ()
    in_motion: bool = False
    reserve: str = ""


def opening(
    of: FirstPage,
    sheet: Sheet,
    facts: Sequence[tuple[str, str]],
    origin: Origin,
    warnings: tuple[str, ...],
) -> Iterator[Section]:
    """Begin a note: the first page, who answers for it, and what is to be known."""
    yield note_section("summary", _summary(of, sheet), "note_first.heading")
    yield note_section("identity", [_signed(), title_block(facts, origin)], "note.identity_heading")
    yield from warnings_section(warnings)


def about(key: str, value: float) -> Measure:
    """Say a value in SI with the digits that it is known to."""
    return Measure(key, value, digits=_rounded(key, value).digits)


def _rounded(key: str, value: float) -> Quantity:
    quantity = replace(QUANTITIES[key], symbol="")
    if not value or not math.isfinite(value):
        return quantity
    before = 1 + math.floor(math.log10(abs(quantity.to_field(value))))
    return replace(quantity, digits=min(quantity.digits, max(0, _DIGITS - before)))


def _summary(of: FirstPage, sheet: Sheet) -> Iterator[Block]:
    report = sheet.report
    yield Text(of.said)
    yield from (Text(each) for each in of.also)
    governing = governing_sentence(report)
    said = (verdict_sentence(report), governing) if governing else (verdict_sentence(report),)
    yield Verdict(Several(said, " "), report.passes if report.results else None, of.reserve)
    tension = Number(Message("columns.largest_tension"), "tension", of.tension)
    yield _four(of.force, tension, of.reach, _reserve(sheet))
    yield from of.drawing
    yield Points(tuple(_not_covered(of, sheet)), Message("note_first.not_covered"))


def _four(*numbers: Number) -> Table:
    return Table(
        "four",
        (
            column("page.what", (each.name for each in numbers)),
            Column(
                Message("columns.value"),
                tuple(each.value for each in numbers),
                units=tuple(_rounded(each.key, each.value) for each in numbers),
            ),
        ),
        only="not csv",
    )


def _reserve(sheet: Sheet) -> Number:
    factor = sheet.break_factor
    if factor is None or not math.isfinite(factor):
        least = min(each.grounded_length for each in sheet.intact)
        return Number(Message("note_first.least_grounded"), "grounded_length", least)
    return Number(Message("note_first.break_factor"), "safety_factor", factor)


def _not_covered(of: FirstPage, sheet: Sheet) -> Iterator[str]:
    yield from of.not_covered
    if not of.in_motion:
        yield Message("note_first.no_motion")
    if not sheet.report.results:
        yield Message("note_first.no_criterion")
    if sheet.anchor is None:
        yield Message("note_first.no_anchor")
    if sheet.lines > 1 and not sheet.judges_line_out:
        yield Message("note_first.no_line_out")
    if sheet.case.service is None:
        yield Message("note_first.no_wear")
    yield Message("note_first.never")


def _signed() -> Table:
    """Leave room for who answers for it."""
    names = ("revision", "date", "prepared", "checked", "approved")
    return Table(
        "signed",
        tuple(column(f"note_first.{name}", [Cited("\N{NO-BREAK SPACE}")]) for name in names),
        only="not csv",
    )
