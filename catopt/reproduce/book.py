"""The reproduction as a Markdown page.

The page holds neither times nor dates nor digits that rounding may change, so that it is the same
on every machine.
"""

from __future__ import annotations

from collections.abc import Sequence

from catopt.reproduce.items import Item, Reproduction, Study

_FURTHER_DIGITS = 3
_MOST_DECIMALS = 6
"""A print of more decimals is the output of a program; more of ours would be rounding."""

_VIEWS = {
    "lines": "To scale",
    "fitness": "Objective of the swarm over its iterations",
    "tension": "Tension of the swarm over its iterations",
    "plan": "Plan",
    "elevation": "Elevation",
}
"""What each figure shows."""

_METHODS = {
    "pso": "Particle swarm",
    "fem": "Finite elements",
    "analytic": "Analytic",
    "pso against fem": "Particle swarm against finite elements",
    "pso against analytic": "Particle swarm against analytic",
}


def book(reproduction: Reproduction) -> str:
    """Write the page.

    Parameters
    ----------
    reproduction : Reproduction
        What to show.

    Returns
    -------
    str
        Markdown, ending in a newline.
    """
    lines = [
        "# Published figures beside catopt's",
        "",
        "Written by `catopt reproduce --out reports`; a test fails when it is out of date.",
        "A number *reproduces* when ours, rounded to the printed decimals, has every digit of it.",
        reproduction.tally,
    ]
    for study in reproduction.studies:
        lines += ["", *_study(study)]
    return "\n".join(lines) + "\n"


def _study(study: Study) -> list[str]:
    lines = [
        f"## {study.name}: {study.title}",
        "",
        f"{study.source}: *{study.source_title}*, {study.source_where}; {study.where}.",
        "",
        *_table(
            ("input", "value", "unit", "origin"),
            [(given.quantity, given.value, given.unit, given.origin) for given in study.inputs],
        ),
    ]
    for method in dict.fromkeys(item.method for item in study.items):
        chosen = [item for item in study.items if item.method == method]
        lines += ["", f"### {_heading(method)}", "", *_comparison(chosen)]
    if study.findings:
        lines += ["", "### What was found", ""]
    lines += [f"{number}. {text}" for number, text in enumerate(study.findings, start=1)]
    for table in study.side_by_side:
        lines += ["", f"**{table.title}**", "", *_table(table.header, table.rows)]
    for view in views(study):
        lines += ["", f"![{_VIEWS[view]}: {study.title}]({study.name}_{view}.svg)"]
    return lines


def views(study: Study) -> list[str]:
    """Name the figures of a study by the ends of their files' names."""
    of_what = {
        "lines": study.drawn,
        "fitness": study.by_swarm,
        "tension": study.by_swarm,
        "plan": study.moorings,
        "elevation": study.moorings,
    }
    return [view for view, shown in of_what.items() if shown]


def _heading(method: str) -> str:
    """Name a method in words, with a capital."""
    return _METHODS.get(method, method[:1].upper() + method[1:])


def _comparison(items: Sequence[Item]) -> list[str]:
    header = ("quantity", "unit", "printed", "catopt", "unrounded", "catopt by", "verdict", "note")
    rows = [
        (
            item.quantity,
            item.unit,
            item.printed.text,
            item.judgement.computed_text,
            _unrounded(item),
            item.computed_by,
            item.verdict,
            item.note,
        )
        for item in items
    ]
    return _table(header, rows)


def _unrounded(item: Item) -> str:
    """Show a few digits more than were printed, unless they are chance."""
    is_long = item.printed.decimals > _MOST_DECIMALS
    if item.computed is None or is_long or "e" in item.printed.text:
        return ""
    return item.printed.rounding(item.computed, further=_FURTHER_DIGITS)


def _table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Lay out a Markdown table; a bar inside a cell is escaped."""
    cells = [[cell.replace("|", r"\|") or " " for cell in row] for row in (header, *rows)]
    lines = ["| " + " | ".join(row) + " |" for row in cells]
    return [lines[0], "|" + " --- |" * len(header), *lines[1:]]
