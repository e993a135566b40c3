"""The tables of docs/catalogue.md, made from the catalogue's data.

``python -m tests.catalogue.page`` brings it up to date, and docs/catalogue-verdicts.md with what
`tests.catalogue.reread` found when it read the open sources again.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from pathlib import Path

from catopt import catalogue
from catopt.catalogue.components import SPECS
from catopt.catalogue.document import Answer
from catopt.catalogue.fittings import anchor_types, fittings
from catopt.loads.sinker import ADHESION, SOIL_FRICTION

from .reread import entries, read_verdicts

PAGE = Path(__file__).parents[2] / "docs" / "catalogue.md"
VERDICTS_PAGE = PAGE.with_name("catalogue-verdicts.md")

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
    above = f" Above another source: {figure.exceeds}." if figure.exceeds else ""
    return f"{reason}{above} {figure.note}".rstrip()


def _anchors() -> str:
    rows = []
    for kind in anchor_types():
        holdings = "; ".join(
            f"{of.soil} {of.capacity / 1e3:.4g} kN (m/{of.of_mass:g} kg)^{of.exponent:g} "
            f"({of.data}, {of.confidence})"
            for of in kind.holdings
        )
        low, high = kind.range
        sold = f"{len(kind.masses)}, {low:g} to {high:g} ({kind.confidence})"
        rows.append((f"`{kind.name}`", sold, holdings, kind.note))
    return _table(("Anchor", "Masses sold (kg)", "Ultimate holding, horizontal pull", "Note"), rows)


def _fittings() -> str:
    rows = []
    for name in dict.fromkeys(each.name for each in fittings()):
        own = [each for each in fittings() if each.name == name]
        ends = f"{own[0].size * 1e3:g} to {own[-1].size * 1e3:g}"
        loads = f"{own[0].MBL / 1e3:g} to {own[-1].MBL / 1e3:g}"
        known = [w for w, f in (("proof load", "proof_load"), ("mass", "mass"), ("WLL", "WLL"))
                 if getattr(own[0], f) is not None]  # fmt: skip
        source = f"{_keys(own[0].sources)} ({own[0].confidence}): {own[0].place}. {own[0].note}"
        rows.append(
            (f"`{name}`", own[0].kind, f"{len(own)}, {ends}", loads, ", ".join(known), source)
        )
    heads = ("Fitting", "Kind", "Sizes (mm)", "MBL (kN)", "Also given", "Source and place")
    return _table(heads, rows)


def _sinkers() -> str:
    def ends(span: tuple[float, float]) -> str:
        return f"{span[0]:g}" if span[0] == span[1] else f"{span[0]:g} to {span[1]:g}"

    rows = [
        (
            row.soil,
            f"**{ends(row.formed)}** ({row.source.confidence})",
            ends(row.cast),
            "-" if row.steel is None else f"{row.steel:g}",
            row.source.text,
        )
        for row in SOIL_FRICTION.values()
    ]
    rows += [
        (
            each.soil,
            f"**{_kilopascals(each.concrete)}**",
            _kilopascals(each.concrete),
            _kilopascals(each.steel),
            each.source.text,
        )
        for each in ADHESION.values()
    ]
    heads = ("Soil", "Concrete, precast", "Concrete, cast in place", "Steel, cast iron", "Source")
    return _table(heads, rows)


def _kilopascals(span: tuple[float, float]) -> str:
    return f"{span[0] / 1e3:g} to {span[1] / 1e3:g} kPa"


def verdicts_page() -> str:
    """Write the page of verdicts anew."""
    found = read_verdicts()
    rows = []
    for entry in entries():
        own = [f"{key} {found.get((entry.name, key), (NOT_READ,))[0]}" for key in entry.sources]
        rows.append((entry.name, entry.confidence, str(entry.origins), "; ".join(own)))
    heads = ("Entry", "Conf.", "Origins", "Sources read again (numbers compared)")
    return f"{_VERDICTS}\n{_table(heads, rows)}"


_VERDICTS = """# The catalogue beside its sources

Each open source that can be cloned is read again by `python -m tests.catalogue.reread DIR` and
compared, number by number, with every entry that names it; a figure that was changed since asks to
be read again, and a test fails on one that contradicts its source. Sources that are pages of the
web or scans are not read by machine: they were read by eye. *Origins* counts documents that do not
go back to each other: B takes two, or one and a check by numbers. Of a program (MPO, DDJ, DDJR,
BEM) a number is only looked for among all that it has, at any power of ten: a weaker check.
"""

NOT_READ = "not read by machine"


def _sources() -> str:
    parts = Answer("list", catalogue.families(), fittings=fittings())
    held = {
        s for k in anchor_types() for s in (*k.sources, *(e for h in k.holdings for e in h.sources))
    }
    every = sorted({*parts.sources, *held}, key=lambda source: source.key)
    rows = (
        (
            source.key,
            source.title,
            source.place + (f"; origin {source.origin}" if source.origin else ""),
        )
        for source in every
    )
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
    "anchors": _anchors,
    "fittings": _fittings,
    "sinkers": _sinkers,
    "sources": _sources,
}

if __name__ == "__main__":
    PAGE.write_text(up_to_date(PAGE.read_text("utf-8")), encoding="utf-8")
    VERDICTS_PAGE.write_text(verdicts_page(), encoding="utf-8")
