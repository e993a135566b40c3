"""How loads look on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.loads.component import LoadComponent, Loads

__all__ = ["show_loads"]


def show_loads(output: Output, of: Loads) -> None:
    """Print loads for a reader: each force with its formula, numbers and source.

    Parameters
    ----------
    output : Output
        Where to.
    of : Loads
        What came out.
    """
    output.text(of.title, bold=True)
    output.line()
    rows = [_row(each) for each in of.components]
    total = QUANTITIES["horizontal_force"].format(of.horizontal_force)
    output.table(
        ["Force", "kN", ""],
        [*rows, ("horizontal force", total, "")],
        title="Forces",
        numbers=[1],
    )
    output.text("How each was reckoned", bold=True)
    for each in of.components:
        output.text(f"{each.name}: {each.formula}")
        output.text(f"  {each.numbers_text}")
        output.text(f"  {each.source.text}")
        if each.note:
            output.text(f"  {each.note}")
    output.line()
    for assumption in of.assumptions:
        output.text(assumption)
    for warning in of.warnings:
        output.text(f"Warning: {warning}", bold=True)
    if of.recalled:
        names = ", ".join(of.recalled)
        output.text(f"Warning: recalled figures (R), read in no document: {names}", bold=True)


def _row(each: LoadComponent) -> tuple[str, str, str]:
    axis = "" if each.axis == "along" else f"{each.axis} "
    force = QUANTITIES["horizontal_force"].format(each.force)
    return each.name, force, f"{axis}[{each.source.confidence}]"
