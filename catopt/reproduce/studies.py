"""Which published calculations can be recomputed, by name, and the reproduction as a page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from catopt.errors import refused
from catopt.mooring.case import load_sharing_factor
from catopt.progress import Progress
from catopt.reproduce import (
    buoy_9p5m,
    calmar,
    fso_rang_dong,
    fso_rang_dong_dynamic,
    reference_moorings,
    ship_lines,
    ship_loads,
)
from catopt.reproduce.items import Item, Reproduction, Study, compare, published, study_of
from catopt.words import Message

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
        in_words = _METHODS.get(method, method[:1].upper() + method[1:])
        lines += ["", f"### {in_words}", "", *_comparison(chosen)]
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


def load_sharing() -> Study:
    """Add up the lines of the loaded half of S4's ring of lines, and judge the printed factors."""
    source = published("load_sharing")
    numbers = [int(lines) for lines in source.series["lines"]]
    factors = {f"FT_over_F_{lines}_lines": load_sharing_factor(lines) for lines in numbers}
    return study_of(
        source,
        compare(source, "N/4 rule", factors, computed_by="the rule's sum"),
        (
            Message("reproduce.line_force_ft_points_along"),
            Message("reproduce.rule_holds_for_equal_lines"),
        ),
    )


_STUDIES: dict[str, Callable[[], Study]] = {
    buoy_9p5m.NAME: buoy_9p5m.study,
    "ship_200m": ship_lines.ship_200m,
    "tanker_20m": ship_lines.tanker_20m,
    "tanker_20m_loads": ship_loads.tanker_20m_loads,
    "tanker_20m_sinker": ship_lines.tanker_20m_sinker,
    "load_sharing": load_sharing,
    fso_rang_dong.NAME: fso_rang_dong.study,
    "fso_rang_dong_loads": ship_loads.fso_rang_dong_loads,
    fso_rang_dong_dynamic.NAME: fso_rang_dong_dynamic.study,
    **{name: partial(reference_moorings.study, name) for name in reference_moorings.NAMES},
    "bridle": reference_moorings.bridle,
    reference_moorings.CHAIN: reference_moorings.chain_study,
    reference_moorings.CABLE: reference_moorings.cable_study,
    calmar.NAME: calmar.study,
}


def names() -> tuple[str, ...]:
    """Names that `reproduce` knows."""
    return tuple(_STUDIES)


def reproduce(name: str | None = None, *, progress: Progress | None = None) -> Reproduction:
    """Recompute what was published.

    Parameters
    ----------
    name : str, optional
        One study; all of them when left out.
    progress : callable, optional
        Told of the swarm runs done and wanted, as they are done.

    Raises
    ------
    InputError
        No study has that name.
    """
    if name is not None and name not in _STUDIES:
        from catopt.catalogue.family import meant

        allowed = meant(Message("refused.one_of", words=", ".join(names())), name, names())
        raise refused("name", repr(name), allowed, "reproduce")
    wanted = names() if name is None else (name,)
    by_swarm = {buoy_9p5m.NAME: partial(buoy_9p5m.study, progress)}
    return Reproduction(tuple((_STUDIES | by_swarm)[study]() for study in wanted))
