"""How a line in motion looks on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.report.tables.dynamic import (
    DYNAMIC_QUANTITY_OF,
    dynamic_sentences,
    motion_sentences,
    proof_sentences,
)
from catopt.units import lasting

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.render.texts import Words
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification, OverRuns

__all__ = ["show_dynamic"]

_OF_LINES = (
    "moving.head_line",
    "moving.head_mean",
    "moving.head_deviation",
    "moving.head_maximum",
    "moving.head_still",
    "moving.head_amplification",
    "moving.head_slack",
    "moving.head_change",
)
_OF_BODY = (
    "moving.head_mean",
    "moving.head_deviation",
    "moving.head_minimum",
    "moving.head_maximum",
)
_TENSION = DYNAMIC_QUANTITY_OF["fairlead_tension"]


def show_dynamic(output: Output, found: DynamicVerification, words: Words) -> None:
    """Print a line in motion for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    found : DynamicVerification
        What came out.
    words : Words
        Language.
    """
    output.line()
    if found.case.system is not None:
        _body(output, words, found)
        return
    for part in found.parts:
        _part(output, words, part, with_name=bool(found.case.load_cases))


def _body(output: Output, words: Words, found: DynamicVerification) -> None:
    """Print all lines of a body, one a row, where the body goes, and how it was proven."""
    output.table(
        [words(key) for key in _OF_LINES],
        [_line_row(part) for part in found.parts],
        title=words("moving.lines", unit=_TENSION.field_unit),
        numbers=range(8),
    )
    output.table(
        ["", *(words(key) for key in _OF_BODY)],
        [_row(words, None, each)[:5] for each in found.body],
        title=words("moving.body"),
        numbers=range(1, 5),
    )
    governing, doubted = found.governing, found.least_proven
    output.text(_runs(words, governing))
    output.text(words("moving.drag_area"))
    for part, sentences in (
        (governing, motion_sentences(governing)),
        (doubted, proof_sentences(doubted)),
    ):
        for sentence in sentences:
            said = words.sentence(sentence).text
            output.text(words("moving.of_line", number=part.line, said=said), bold=True)
    for remark in dict.fromkeys(each for part in found.parts for each in part.remarks):
        output.text(words("verified.note", remark=words.sentence(remark).text))
    output.line()


def _line_row(part: DynamicPart) -> tuple[str, ...]:
    each = part.of("fairlead_tension")
    larger, change = part.amplification, part.change_of("fairlead_tension")
    return (
        str(part.line),
        *(_TENSION.format(value) for value in (each.mean, each.std, each.maximum)),
        _TENSION.format(part.quasi_static_max),
        "-" if larger is None else f"{larger:.2f}",
        f"{part.slack_time:.1f}",
        "-" if change is None else f"{change:.2%}",
    )


def _part(output: Output, words: Words, part: DynamicPart, *, with_name: bool) -> None:
    title = words("moving.under", name=part.name) if with_name else words("moving.heading")
    headings = [
        words("moving.head_mean"),
        words("moving.head_deviation"),
        words("moving.head_minimum"),
        words("moving.head_maximum"),
        words("moving.head_probable", time=lasting(part.duration_of_interest)),
        words("moving.head_change"),
    ]
    output.table(
        ["", *headings],
        [_row(words, part, each) for each in part.quantities],
        title=title,
        numbers=range(1, 7),
    )
    output.text(_runs(words, part))
    output.text(words("moving.drag_area"))
    for sentence in dynamic_sentences(part):
        output.text(words.sentence(sentence).text, bold=True)
    for remark in part.remarks:
        output.text(words("verified.note", remark=words.sentence(remark).text))
    output.line()


def _runs(words: Words, part: DynamicPart) -> str:
    """Say how the line was run."""
    history = part.runs[-1].history
    told = {
        "time": f"{history.time[-1]:.0f}",
        "step": f"{history.step:.3g}",
        "bars": part.elements,
        "since": f"{history.since:.0f}",
    }
    if len(part.runs) > 1:
        return words("moving.runs", count=len(part.runs), **told)
    return words("moving.run", **told)


def _row(words: Words, part: DynamicPart | None, each: OverRuns) -> tuple[str, ...]:
    quantity = DYNAMIC_QUANTITY_OF[each.quantity]
    change = None if part is None else part.change_of(each.quantity)
    values = (each.mean, each.std, each.minimum, each.maximum, each.most_probable_maximum)
    return (
        words.heading(f"{quantity.name} ({quantity.field_unit})"),
        *(quantity.format(value) for value in values),
        "-" if change is None else f"{change:.2%}",
    )
