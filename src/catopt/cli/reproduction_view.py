"""How a reproduction looks on a terminal."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.reproduce import Item, Reproduction, Study

__all__ = ["show_reproduction"]

_TALLY = {
    "reproduces": "reproduce",
    "differs": "differ",
    "not reproducible": "cannot be reproduced",
}


def show_reproduction(output: Output, result: Reproduction) -> None:
    """Print every study: what went in, each printed number beside ours, and what was found."""
    for study in result.studies:
        _study(output, study)
    verdicts: list[str] = [item.verdict for item in result.items]
    counts = ", ".join(f"{verdicts.count(each)} {words}" for each, words in _TALLY.items())
    output.text(f"Of {len(verdicts)} printed numbers {counts}.", bold=True)


def _study(output: Output, study: Study) -> None:
    output.text(f"{study.name}: {study.title}", bold=True)
    output.text(f"{study.source}, {study.where}: {study.source_title}. {study.source_where}.")
    output.line()
    rows = [
        (each.quantity, f"{each.value} {each.unit}".rstrip(), each.origin) for each in study.inputs
    ]
    output.table(["Input", "Value", "Origin"], rows, numbers=[1])
    for method in dict.fromkeys(item.method for item in study.items):
        _comparison(output, method, [item for item in study.items if item.method == method])
    for number, finding in enumerate(study.findings, start=1):
        output.text(f"{number}. {finding}")
    output.line()
    for table in study.side_by_side:
        numbers = range(1, len(table.header))
        output.table(table.header, table.rows, title=table.title, numbers=numbers)


def _comparison(output: Output, method: str, items: Sequence[Item]) -> None:
    rows = [
        (
            item.quantity,
            item.printed.text,
            item.judgement.computed_text or "-",
            item.unit,
            item.computed_by or "-",
            item.verdict,
        )
        for item in items
    ]
    output.table(
        ["Quantity", "Printed", "catopt", "Unit", "catopt by", "Verdict"],
        rows,
        title=f"Printed for {method}",
        numbers=[1, 2],
    )
    for item in items:
        if item.note:
            output.text(f"  {item.quantity}: {item.note}.")
    output.line()
