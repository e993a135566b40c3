"""The tables of docs/catalogue.md, made from the catalogue's data.

``python -m tests.catalogue.page`` brings the page up to date.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from pathlib import Path

from catopt import catalogue
from catopt.catalogue.document import Answer
from catopt.catalogue.figure import SPECS

PAGE = Path(__file__).parents[2] / "docs" / "catalogue.md"

_PART = re.compile(
    r"(<!-- (?P<name>[a-z]+): python -m tests\.catalogue\.page -->\n).*?(<!-- end -->)", re.DOTALL
)


def up_to_date(page: str) -> str:
    """Put the real tables in the place of what a page shows."""
    return _PART.sub(lambda found: f"{found[1]}\n{PARTS[found['name']]()}\n{found[3]}", page)


def parts(page: str) -> list[str]:
    """Names of the parts that a page has."""
    return [found["name"] for found in _PART.finditer(page)]


def _families() -> str:
    return _table(
        ("Family", "What it is", "Grades", "d (mm)", "Sizes sold", "Where the sizes are from"),
        (
            (
                f"`{family.name}`",
                family.title,
                ", ".join(family.grades),
                _mm(family.range),
                str(len(family.sizes.diameters)),
                f"{_keys(family.sizes.sources)} ({family.sizes.confidence})",
            )
            for family in catalogue.families()
        ),
    )


def _figures() -> str:
    return "\n".join(_of_family(family) for family in catalogue.families())


def _of_family(family: catalogue.Family) -> str:
    rows = (
        (
            SPECS[figure.quantity].words,
            ", ".join(figure.grades) or "all",
            _variant(figure),
            figure.text,
            _mm(figure.range),
            figure.confidence,
            f"{_keys(figure.sources)}: {figure.place}.{_remark(figure)}",
        )
        for figure in sorted(family.figures, key=lambda f: list(SPECS).index(f.quantity))
    )
    columns = ("Figure", "Grades", "Variant", "Formula", "d (mm)", "Conf.", "Source and place")
    head = f"### {family.name}\n\n{family.note}\n" if family.note else f"### {family.name}\n"
    return f"{head}\n{_table(columns, rows)}"


def _variant(figure: catalogue.Figure) -> str:
    if not figure.variant:
        return ""
    return f"**{figure.variant}**" if figure.default else figure.variant


def _remark(figure: catalogue.Figure) -> str:
    reason = f" Default: {figure.reason}." if figure.reason else ""
    return f"{reason} {figure.note}".rstrip()


def _sources() -> str:
    answer = Answer("list", catalogue.families())
    rows = ((source.key, source.title, source.place) for source in answer.sources)
    return _table(("Key", "Document", "Where"), rows)


def _table(columns: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    heading = list(columns)
    lines = [heading, ["---"] * len(heading), *rows]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in lines)


def _mm(ends: tuple[float, float]) -> str:
    low, high = (f"{round(end * 1e3, 6):g}" for end in ends)
    return f"{low} to {high}"


def _keys(sources: Iterable[catalogue.Source]) -> str:
    return ", ".join(source.key for source in sources)


PARTS: dict[str, Callable[[], str]] = {
    "families": _families,
    "figures": _figures,
    "sources": _sources,
}

if __name__ == "__main__":
    PAGE.write_text(up_to_date(PAGE.read_text("utf-8")), encoding="utf-8")
