"""What published figures beside catopt's own consist of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Section,
    Table,
    Text,
    Verdict,
    named,
    of_row,
    texts,
)
from catopt.words import Message, Several, term

if TYPE_CHECKING:
    from catopt.reproduce import Item, Reproduction, Study

_BY = {
    "pso": "reproduction.by_swarm",
    "closed-form": "reproduction.by_closed_form",
    "truss": "reproduction.by_truss",
}
"""Short words for how a number was computed: 80 columns carry the longest quantity beside them."""


def reproduction_answer(result: Reproduction) -> Answer:
    """Lay out studies: what went in, each printed number beside ours, and what was found."""
    return Answer(
        "reproduction",
        term("Published figures beside catopt's"),
        (
            Section(Message("terms.comparison"), (_comparison(result.items),)),
            Section(Message("captions.inputs"), (_inputs(result.studies),)),
            Section(Message("terms.findings"), (_findings(result.studies),)),
            *(Section(study.name, tuple(_study(study))) for study in result.studies),
            Section(Message("terms.findings"), (_tally(result.items),)),
        ),
    )


# ------------------------------------------------------------------ tables of files


def _comparison(items: Sequence[Item]) -> Table:
    rounded = [each.judgement.computed_text for each in items]
    return Table(
        "reproduction",
        (
            texts("source", [each.source for each in items]),
            texts("name", [each.name for each in items]),
            texts("quantity", [each.quantity for each in items]),
            texts("method", [term(each.method) for each in items]),
            texts("unit", [each.unit for each in items]),
            of_row("printed", [each.printed.text for each in items]),
            of_row("computed_rounded_as_printed", rounded),
            of_row("computed", [each.computed for each in items]),
            texts("computed_by", [term(each.computed_by) for each in items]),
            texts("verdict", [term(each.verdict) for each in items]),
            texts("note", [each.note for each in items]),
        ),
        only="files",
    )


def _inputs(studies: Sequence[Study]) -> Table:
    rows = [(study, given) for study in studies for given in study.inputs]
    inputs = [given for _, given in rows]
    return Table(
        "inputs",
        (
            texts("study", [study.name for study, _ in rows]),
            texts("quantity", [each.quantity for each in inputs]),
            of_row("value", [each.value for each in inputs]),
            texts("unit", [each.unit for each in inputs]),
            texts("origin", [each.origin for each in inputs]),
        ),
        only="workbook",
    )


def _findings(studies: Sequence[Study]) -> Table:
    rows = [(study.name, finding) for study in studies for finding in study.findings]
    return Table(
        "findings",
        (
            texts("study", [name for name, _ in rows]),
            texts("finding", [finding for _, finding in rows]),
        ),
        only="workbook",
    )


# ------------------------------------------------------------------ what people see of a study


def _study(study: Study) -> Iterator[Block]:
    source = Message(
        "reproduction.source",
        source=study.source,
        where=study.where,
        title=study.source_title,
        publication=study.source_where,
    )
    yield Text(source, Several((study.name, study.title), ": "), "people")
    inputs = study.inputs
    values = tuple(Several(filter(None, (each.value, each.unit)), " ") for each in inputs)
    yield Table(
        f"{study.name}_inputs",
        (
            texts("input", [each.quantity for each in inputs]),
            _flush_right(Message("columns.value"), values),
            texts("origin", [each.origin for each in inputs]),
        ),
        only="people",
    )
    for method in dict.fromkeys(item.method for item in study.items):
        yield from _printed_for(method, [item for item in study.items if item.method == method])
    if study.findings:
        numbered = (
            Message("reproduction.finding", number=number, finding=finding)
            for number, finding in enumerate(study.findings, start=1)
        )
        yield Text(Several(numbered, "\n"), Message("terms.findings"), "people")
    yield from _side_by_side(study)


def _printed_for(method: str, items: Sequence[Item]) -> Iterator[Block]:
    computed = tuple(item.judgement.computed_text or "-" for item in items)
    by = [_short(item.computed_by) for item in items]
    yield Table(
        f"{items[0].name}_{method}",
        (
            texts("quantity", [item.quantity for item in items]),
            _flush_right(Message("columns.printed"), tuple(item.printed.text for item in items)),
            _flush_right(Several(("catopt",)), computed),
            texts("unit", [item.unit for item in items]),
            texts("catopt_by", by),
            texts("verdict", [term(item.verdict) for item in items]),
        ),
        Message("reproduction.printed_for", method=term(method)),
        only="people",
    )
    notes = [
        Message("reproduction.note", which=which, note=note) for which, note in notes_of(items)
    ]
    if notes:
        yield Text(Several(notes, "\n"), only="people")


def _short(computed_by: str) -> str:
    return Message(_BY[computed_by]) if computed_by in _BY else term(computed_by or "-")


def _flush_right(name: Message, values: tuple[str, ...]) -> Column:
    """Make a column of numbers that are written with the digits of a print."""
    return Column(name, values, named("coefficient"))


def notes_of(items: Sequence[Item]) -> Iterator[tuple[str, str]]:
    """Yield every note of a table of printed numbers once for the run of rows that share it.

    What numbers it is of, and the note.
    """
    for note, run in groupby(items, key=lambda item: item.note):
        if note:
            yield _which(list(run), items), note


def _which(run: Sequence[Item], items: Sequence[Item]) -> str:
    first, last = run[0].quantity, run[-1].quantity
    if len(run) == 1:
        return first
    if len(run) == len(items):
        return Message("reproduction.all", numbers=len(run))
    return Message("reproduction.from_to", first=first, last=last)


def _side_by_side(study: Study) -> Iterator[Table]:
    """Yield the answers of several models; a file of their own (CSV) they have not."""
    for number, each in enumerate(study.side_by_side, start=1):
        first, *others = (Several((name,)) for name in each.header)
        words, *cells = zip(*each.rows, strict=True)
        columns = (
            Column(first, words),
            *(_flush_right(name, below) for name, below in zip(others, cells, strict=True)),
        )
        table = Table(f"{study.name}_{number}", columns, Several((each.title,)), only="people")
        plain = tuple(replace(column, quantity=None) for column in columns)
        yield table
        yield replace(table, columns=plain, only="workbook")


def _tally(items: Sequence[Item]) -> Verdict:
    verdicts: list[str] = [item.verdict for item in items]
    said = Message(
        "reproduction.tally",
        numbers=len(verdicts),
        reproduce=verdicts.count("reproduces"),
        differ=verdicts.count("differs"),
        neither=verdicts.count("not reproducible"),
    )
    return Verdict(said, "differs" not in verdicts)
