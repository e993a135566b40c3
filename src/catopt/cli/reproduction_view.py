"""How a reproduction looks on a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from textwrap import wrap
from typing import TYPE_CHECKING

from catopt.report.wording.reproduction import said_among_numbers, said_note

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.report.texts import Words
    from catopt.reproduce import Item, Reproduction, Study

__all__ = ["notes_of", "show_reproduction"]

_TALLY = {
    "reproduces": "reproduce",
    "differs": "differ",
    "not reproducible": "cannot be reproduced",
}

_HEADINGS = {"Quantity": 9, "Printed": 9, "catopt": 9, "Unit": 4, "catopt by": 9, "Verdict": 9}
"""Headings and the characters to which each is folded; all English ones stand on one line."""

_BY = {
    "pso": "reproduce.by_swarm",
    "closed-form": "reproduce.by_closed_form",
    "truss": "reproduce.by_truss",
}
"""Short words for how a number was computed: 80 columns carry the longest quantity beside them."""


def show_reproduction(output: Output, result: Reproduction, words: Words) -> None:
    """Print every study: what went in, each printed number beside ours, and what was found.

    Parameters
    ----------
    output : Output
        Where to.
    result : Reproduction
        What came out.
    words : Words
        Language.
    """
    for study in result.studies:
        _study(output, words, study)
    verdicts: list[str] = [item.verdict for item in result.items]
    counts = ", ".join(f"{verdicts.count(each)} {said}" for each, said in _TALLY.items())
    tally = f"Of {len(verdicts)} printed numbers {counts}."
    output.text(words.sentence(tally).text, bold=True)


def _study(output: Output, words: Words, study: Study) -> None:
    output.text(f"{study.name}: {words.name(study.title)}", bold=True)
    where = f"{study.source}, {words.name(study.where)}"
    output.text(f"{where}: {study.source_title}. {study.source_where}.")
    output.line()
    rows = [
        (
            words.sentence(each.quantity).text,
            f"{said_among_numbers(words, each.value)} {each.unit}".rstrip(),
            words.sentence(each.origin).text,
        )
        for each in study.inputs
    ]
    headings = [words.name(each) for each in ("Input", "Value", "Origin")]
    output.table(headings, rows, numbers=[1])
    for method in dict.fromkeys(item.method for item in study.items):
        _comparison(output, words, method, [item for item in study.items if item.method == method])
    for number, finding in enumerate(study.findings, start=1):
        output.text(f"{number}. {words.sentence(finding).text}")
    output.line()
    for table in study.side_by_side:
        header = [said_among_numbers(words, each) for each in table.header]
        cells = [[said_among_numbers(words, cell) for cell in row] for row in table.rows]
        title = words.sentence(table.title).text
        output.table(header, cells, title=title, numbers=range(1, len(header)))


def _comparison(output: Output, words: Words, method: str, items: Sequence[Item]) -> None:
    rows = [
        (
            item.quantity,
            item.printed.text,
            said_among_numbers(words, item.judgement.computed_text) or "-",
            item.unit,
            _by(words, item),
            words.name(item.verdict),
        )
        for item in items
    ]
    output.table(
        ["\n".join(wrap(words.name(name), width)) for name, width in _HEADINGS.items()],
        rows,
        title=words.sentence(f"Printed for {method}").text,
        numbers=[1, 2],
    )
    notes = list(notes_of(words, items))
    for which, note in notes:
        output.text(f"  {which}: {note}.")
    if notes:
        output.line()


def _by(words: Words, item: Item) -> str:
    if item.computed_by in _BY:
        return words(_BY[item.computed_by])
    return words.name(item.computed_by) if item.computed_by else "-"


def notes_of(words: Words, items: Sequence[Item]) -> Iterator[tuple[str, str]]:
    """Yield every note of a table of printed numbers once for the run of rows that share it.

    Parameters
    ----------
    words : Words
        Language.
    items : sequence of Item
        The rows of one table.

    Yields
    ------
    tuple of str
        What numbers it is of, and the note.
    """
    for note, run in groupby(items, key=lambda item: said_note(words, item)):
        if note:
            yield _which(words, list(run), items), note


def _which(words: Words, run: Sequence[Item], items: Sequence[Item]) -> str:
    first, last = run[0].quantity, run[-1].quantity
    if len(run) == 1:
        return first
    if len(run) == len(items):
        return words("reproduce.all", count=len(run))
    return words("reproduce.from_to", first=first, last=last)
