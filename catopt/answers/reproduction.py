"""What published figures beside catopt's own consist of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, named, section, tabulate, texts
from catopt.words import Message, Several, term

if TYPE_CHECKING:
    from catopt.reproduce import Item, Reproduction, Study

_NUMBER = named("coefficient")
"""What makes numbers that are written with the digits of a print stand flush right."""

_BY = {
    "pso": Message("reproduction.by_swarm"),
    "closed-form": Message("reproduction.by_closed_form"),
    "truss": Message("reproduction.by_truss"),
}
"""Short words for how a number was computed: 80 columns carry the longest quantity beside them."""


def reproduction_answer(result: Reproduction) -> blocks.Answer:
    """Lay out studies: what went in, each printed number beside ours, and what was found."""
    verdicts: list[str] = [item.verdict for item in result.items]
    tally = Message(
        "reproduction.tally",
        numbers=len(verdicts),
        reproduce=verdicts.count("reproduces"),
        differ=verdicts.count("differs"),
        neither=verdicts.count("not reproducible"),
    )
    of, findings = Rows(result.studies).within("findings")
    columns = (of.texts("study", "name"), texts("finding", findings.rows))
    return answered(
        "reproduction",
        term("Published figures beside catopt's"),
        section("terms.comparison", _comparison(result.items)),
        section("captions.inputs", _inputs(result.studies)),
        section("terms.findings", tabulate("findings", *columns, only="workbook")),
        *(blocks.Section(study.name, tuple(_study(study))) for study in result.studies),
        section("terms.findings", blocks.Verdict(tally, "differs" not in verdicts)),
    )


# ------------------------------------------------------------------ tables of files


def _comparison(items: Sequence[Item]) -> blocks.Table:
    of = Rows(items)
    return tabulate(
        "reproduction",
        *of.own("source", "name", "quantity"),
        of.texts("method", lambda each: term(each.method)),
        of.texts("unit"),
        of.of_row("printed", "printed.text"),
        of.of_row("computed_rounded_as_printed", "judgement.computed_text"),
        of.of_row("computed"),
        of.texts("computed_by", lambda each: term(each.computed_by)),
        of.texts("verdict", lambda each: term(each.verdict)),
        of.texts("note"),
        only="files",
    )


def _inputs(studies: Sequence[Study]) -> blocks.Table:
    each_study, of = Rows(studies).within("inputs")
    return tabulate(
        "inputs",
        each_study.texts("study", "name"),
        *of.own("quantity"),
        of.of_row("value"),
        *of.own("unit", "origin"),
        only="workbook",
    )


# ------------------------------------------------------------------ what people see of a study


def _study(study: Study) -> Iterator[blocks.Block]:
    source = Message(
        "reproduction.source",
        source=study.source,
        where=study.where,
        title=study.source_title,
        publication=study.source_where,
    )
    yield blocks.Text(source, Several((study.name, study.title), ": "), "people")
    of = Rows(study.inputs)
    yield tabulate(
        f"{study.name}_inputs",
        of.texts("input", "quantity"),
        of.texts(
            "value", lambda of: Several(filter(None, (of.value, of.unit)), " "), quantity=_NUMBER
        ),
        of.texts("origin"),
        only="people",
    )
    for method in dict.fromkeys(item.method for item in study.items):
        yield from _printed_for(method, [item for item in study.items if item.method == method])
    if study.findings:
        numbered = (
            Message("reproduction.finding", number=number, finding=finding)
            for number, finding in enumerate(study.findings, start=1)
        )
        yield blocks.Text(Several(numbered, "\n"), Message("terms.findings"), "people")
    yield from _side_by_side(study)


def _printed_for(method: str, items: Sequence[Item]) -> Iterator[blocks.Block]:
    of = Rows(items)
    yield tabulate(
        f"{items[0].name}_{method}",
        of.texts("quantity"),
        of.texts("printed", "printed.text", quantity=_NUMBER),
        of.texts(
            Several(("catopt",)),
            lambda item: item.judgement.computed_text or "-",
            quantity=_NUMBER,
        ),
        of.texts("unit"),
        of.texts(
            "catopt_by", lambda item: _BY.get(item.computed_by, term(item.computed_by or "-"))
        ),
        of.texts("verdict", lambda item: term(item.verdict)),
        caption=Message("reproduction.printed_for", method=term(method)),
        only="people",
    )
    notes = [Message("reproduction.note", which=of, note=note) for of, note in notes_of(items)]
    if notes:
        yield blocks.Text(Several(notes, "\n"), only="people")


def notes_of(items: Sequence[Item]) -> Iterator[tuple[str, str]]:
    """Yield every note of a table of printed numbers once for the run of rows that share it.

    What numbers it is of, and the note.
    """
    for note, run in groupby(items, key=lambda item: item.note):
        first, *others = (item.quantity for item in run)
        which = first
        if others:
            which = Message("reproduction.from_to", first=first, last=others[-1])
        if 1 < len(items) == 1 + len(others):
            which = Message("reproduction.all", numbers=len(items))
        if note:
            yield which, note


def _side_by_side(study: Study) -> Iterator[blocks.Table]:
    """Yield the answers of several models; a file of their own (CSV) they have not."""
    for number, each in enumerate(study.side_by_side, start=1):
        headings = [Several((name,)) for name in each.header]
        columns = tuple(map(texts, headings, zip(*each.rows, strict=True)))
        table = tabulate(
            f"{study.name}_{number}", *columns, caption=Several((each.title,)), only="workbook"
        )
        flush_right = (replace(column, quantity=_NUMBER) for column in columns[1:])
        yield replace(table, columns=(columns[0], *flush_right), only="people")
        yield table
