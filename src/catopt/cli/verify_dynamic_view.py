"""How a line in motion looks on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.report.dynamic import DYNAMIC_QUANTITY_OF, dynamic_sentences

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification, OverRuns

__all__ = ["show_dynamic"]


def show_dynamic(output: Output, found: DynamicVerification) -> None:
    """Print a line in motion for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    found : DynamicVerification
        What came out.
    """
    output.line()
    for part in found.parts:
        _part(output, part, with_name=bool(found.case.load_cases))


def _part(output: Output, part: DynamicPart, *, with_name: bool) -> None:
    title = f"Load case {part.name}: line in motion" if with_name else "Line in motion"
    output.table(
        ["", "\nMean", "Standard\ndeviation", "\nMin.", "\nMax.", "Most prob.\nmax."],
        [_row(each) for each in part.quantities],
        title=title,
        numbers=range(1, 6),
    )
    history = part.runs[-1].history
    count = f"{len(part.runs)} runs" if len(part.runs) > 1 else "1 run"
    output.text(
        f"{count} of {history.time[-1]:.0f} s in steps of {history.step:.3g} s, "
        f"{part.elements} bars; statistics from {history.since:.0f} s on."
    )
    for sentence in dynamic_sentences(part):
        output.text(sentence, bold=True)
    for remark in part.remarks:
        output.text(f"Note: {remark}.")
    output.line()


def _row(each: OverRuns) -> tuple[str, ...]:
    quantity = DYNAMIC_QUANTITY_OF[each.quantity]
    values = (each.mean, each.std, each.minimum, each.maximum, each.most_probable_maximum)
    return (
        f"{quantity.name} ({quantity.field_unit})",
        *(quantity.format(value) for value in values),
    )
