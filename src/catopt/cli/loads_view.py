"""How loads look on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.loads.component import LoadComponent, Loads
    from catopt.report.texts import Words

__all__ = ["show_loads"]


def show_loads(output: Output, of: Loads, words: Words) -> None:
    """Print loads for a reader: each force with its formula, numbers and source.

    Parameters
    ----------
    output : Output
        Where to.
    of : Loads
        What came out.
    words : Words
        Language; formulas, numbers and sources are the same in all.
    """
    output.text(words.sentence(of.title).text, bold=True)
    output.line()
    rows = [_row(words, each) for each in of.components]
    total = QUANTITIES["horizontal_force"].format(of.horizontal_force)
    output.table(
        [words("loads.force"), "kN", ""],
        [*rows, (words.name("horizontal force"), total, "")],
        title=words("loads.forces"),
        numbers=[1],
    )
    output.text(words("loads.how"), bold=True)
    for each in of.components:
        output.text(f"{words.name(each.name)}: {each.formula}")
        output.text(f"  {each.numbers_text}")
        output.text(f"  {each.source.text}")
        if each.note:
            output.text(f"  {words.sentence(each.note).text}")
    output.line()
    for assumption in of.assumptions:
        output.text(words.sentence(assumption).text)
    for warning in of.warnings:
        output.text(words("loads.warning", text=words.sentence(warning).text), bold=True)
    if of.recalled:
        names = ", ".join(words.name(each) for each in of.recalled)
        output.text(words("loads.recalled", names=names), bold=True)


def _row(words: Words, each: LoadComponent) -> tuple[str, str, str]:
    axis = "" if each.axis == "along" else f"{words.name(each.axis)} "
    force = QUANTITIES["horizontal_force"].format(each.force)
    return words.name(each.name), force, f"{axis}[{each.source.confidence}]"
