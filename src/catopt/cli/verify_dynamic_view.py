"""How a line in motion looks on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.report.tables.dynamic import DYNAMIC_QUANTITY_OF, dynamic_sentences

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.report.texts import Words
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification, OverRuns

__all__ = ["show_dynamic"]


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
    for part in found.parts:
        _part(output, words, part, with_name=bool(found.case.load_cases))


def _part(output: Output, words: Words, part: DynamicPart, *, with_name: bool) -> None:
    title = words("moving.under", name=part.name) if with_name else words("moving.heading")
    headings = [
        words("moving.head_mean"),
        words("moving.head_deviation"),
        words("moving.head_minimum"),
        words("moving.head_maximum"),
        words("moving.head_probable"),
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


def _row(words: Words, part: DynamicPart, each: OverRuns) -> tuple[str, ...]:
    quantity = DYNAMIC_QUANTITY_OF[each.quantity]
    change = part.change_of(each.quantity)
    values = (each.mean, each.std, each.minimum, each.maximum, each.most_probable_maximum)
    return (
        words.heading(f"{quantity.name} ({quantity.field_unit})"),
        *(quantity.format(value) for value in values),
        "-" if change is None else f"{change:.2%}",
    )
