"""The lines of a body in motion: a row a line, where the body goes, the governing line in time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from catopt.figures.motion import history, track
from catopt.notes.system import SystemNote
from catopt.render.svg import svg
from catopt.render.texts import Phrase, Words
from catopt.report.page.motion import STATISTICS
from catopt.report.page.table import Cell, Heading, Table, label_of, measured, number_heading
from catopt.report.tables.dynamic import (
    DYNAMIC_QUANTITY_OF,
    motion_sentences,
    proof_sentences,
    stopped_sentence,
)
from catopt.units import lasting

if TYPE_CHECKING:
    from catopt.verify.dynamic_result import DynamicVerification

__all__ = ["body_table", "lines_table", "motion", "said_of"]

_TENSION = DYNAMIC_QUANTITY_OF["fairlead_tension"]


def motion(note: SystemNote, words: Words) -> dict[str, Any] | None:
    """Build the part of the lines in motion; None where nobody asked for it."""
    found = note.motion
    if found is None:
        return None
    governing = found.governing
    assert governing.line is not None
    at_rest = note.solution.lines[governing.line - 1].tension
    stopped = None if found.is_complete else words.sentence(stopped_sentence(found))
    remarks = dict.fromkeys(each for part in found.parts for each in part.remarks)
    return {
        "stopped": stopped,
        "passes": found.verdict == "converged",
        "sentences": list(said_of(found, words)),
        "lines": lines_table(note, words),
        "body": body_table(found, words),
        "history": svg(history(governing, at_rest), words.language),
        "history_of": words("system_motion.history", line=governing.line),
        "track": svg(track(found), words.language),
        "remarks": [words.sentence(each) for each in remarks],
    }


def said_of(found: DynamicVerification, words: Words) -> Iterator[Phrase]:
    """Yield what is said of the governing line, and of the one that is proven least."""
    governing, doubted = found.governing, found.least_proven
    for part, sentences in (
        (governing, motion_sentences(governing)),
        (doubted, proof_sentences(doubted)),
    ):
        for sentence in sentences:
            said = words.sentence(sentence)
            text = words("moving.of_line", number=part.line, said=said.text)
            yield Phrase(text, said.lang)


def lines_table(note: SystemNote, words: Words) -> Table:
    """Tabulate the fairlead tension of every line, the governing one marked.

    Parameters
    ----------
    note : SystemNote
        With its lines in motion.
    words : Words
        Language.
    """
    found = note.motion
    assert found is not None
    time = lasting(found.parts[0].duration_of_interest)
    *of_tension, change_heading = (words(key, time=time) for key in STATISTICS)
    headings = (
        Heading(words.name("Line"), is_number=True),
        *(number_heading(label, _TENSION) for label in of_tension),
        Heading(change_heading, is_number=True),
        number_heading(words.name("Quasi-static fairlead tension"), _TENSION),
        Heading(words("in_motion.amplification"), is_number=True),
        Heading(f"{words.name('Slack in all')} (s)", is_number=True),
    )
    rows = []
    for part, at_rest in zip(found.parts, note.solution.lines, strict=True):
        each, larger = part.of("fairlead_tension"), part.amplification
        change = part.change_of(each.quantity)
        numbers = (
            at_rest.tension, each.mean, each.std, each.minimum, each.maximum,
            each.most_probable_maximum,
        )  # fmt: skip
        rows.append(
            (
                Cell(str(part.line), part.line),
                *(measured(_TENSION, value) for value in numbers),
                Cell("–") if change is None else Cell(f"{change:.2%}", change),
                measured(_TENSION, part.quasi_static_max),
                Cell("–") if larger is None else Cell(f"{larger:.3f}", larger),
                Cell(f"{part.slack_time:.1f}", part.slack_time),
            )
        )
    caption = words("moving.lines", unit=_TENSION.field_unit)
    marked = found.parts.index(found.governing)
    return Table("system_motion_lines", headings, tuple(rows), caption, marked)


def body_table(found: DynamicVerification, words: Words) -> Table:
    """Tabulate where the body's origin goes."""
    headings = (
        Heading(words("workbook.quantity")),
        *(Heading(words(key), is_number=True) for key in STATISTICS[1:5]),
    )
    rows = []
    for each in found.body:
        quantity = DYNAMIC_QUANTITY_OF[each.quantity]
        label = f"{label_of(words, quantity)} ({quantity.field_unit})"
        numbers = (each.mean, each.std, each.minimum, each.maximum)
        rows.append((Cell(label, style="words"), *(measured(quantity, v) for v in numbers)))
    return Table("system_motion_body", headings, tuple(rows), words("moving.body"))
