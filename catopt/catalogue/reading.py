"""Reads files of families: the catalogue's own and a user's, every error at once."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from catopt.catalogue.collection import Catalogue
from catopt.catalogue.components import CONFIDENCES, SPECS, Figure, Source, within
from catopt.catalogue.family import Family, Sizes, in_mm
from catopt.catalogue.formula import (
    ChainLoad,
    ChainModulus,
    Coefficient,
    Constant,
    Density,
    Formula,
    MeanLoad,
    Multiple,
    Polynomial,
    Rows,
)
from catopt.catalogue.table import TomlTable
from catopt.documents import read_text
from catopt.model.kinds import Findings
from catopt.units import UNITS, Dimension
from catopt.words import Message

_POWER = re.compile(r"d([0-3])")
_DIAMETER = re.compile(r"(?:(\d+(?:\.\d+)?) )?d(/pi)?")

_UNITS: Mapping[str, Mapping[str, float]] = {
    "kg/m": UNITS[Dimension.MASS_PER_LENGTH],
    "N": UNITS[Dimension.FORCE],
    "USD/m": {"USD/m": 1.0},
}
"""Units that rows may be in, by the SI unit of the quantity."""

_OF_ONE_NUMBER: Mapping[str, Callable[[float], Formula]] = {
    "chain_load": ChainLoad,
    "density": Density,
    "value": Constant,
}

_EXTRA = {"rows": ("unit",), "times": ("of",), "coefficient": ("diameter",)}


def read_formula(figure: TomlTable, quantity: str) -> Formula | None:
    """Read the formula of a figure; None when something is wrong with it, which was then noted."""
    table = figure.table("formula")
    spec = SPECS[quantity]
    if table is None:
        if not figure.has("formula"):
            figure.problem("formula", Message("refused_file.one_by", forms=", ".join(spec.forms)))
        return None
    forms = [key for key in table.values if key in spec.forms]
    powers = [key for key in forms if _POWER.fullmatch(key)]
    kinds = (["power"] if powers else []) + [key for key in forms if key not in powers]
    table.only(*spec.forms, *(e for key in forms for e in _EXTRA.get(key, ())))
    if len(kinds) != 1:
        figure.problem("formula", Message("refused.exactly_one", ways=", ".join(spec.forms)))
        return None
    if powers:
        return _polynomial(table, powers)
    kind = kinds[0]
    match kind:
        case "rows":
            return _rows(table, spec.unit)
        case "times":
            factor, other = table.number("times", above=0.0), table.word("of", spec.of)
            return None if factor is None or other is None else Multiple(factor, other)
        case "coefficient":
            return _coefficient(table)
        case "chain_modulus":
            pair = table.numbers(kind, 2)
            return ChainModulus(*pair) if pair else None
        case "mean_load":
            pair = table.numbers(kind, 2)
            return MeanLoad(*pair) if pair else None
    value = table.number(kind, above=0.0)
    return None if value is None else _OF_ONE_NUMBER[kind](value)


def _polynomial(table: TomlTable, powers: list[str]) -> Polynomial | None:
    read = [(int(key[1:]), table.number(key)) for key in sorted(powers)]
    terms = tuple((power, value) for power, value in read if value is not None)
    return Polynomial(terms) if len(terms) == len(powers) else None


def _rows(table: TomlTable, si_unit: str) -> Rows | None:
    rows = table.rows("rows")
    units = _UNITS[si_unit]
    unit = table.word("unit", tuple(units))
    if not rows or unit is None:
        return None
    return Rows(
        tuple(diameter / 1e3 for diameter, _ in rows),
        tuple(value * units[unit] for _, value in rows),
    )


def _coefficient(table: TomlTable) -> Coefficient | None:
    value, name = table.number("coefficient", above=0.0), table.text("diameter")
    if value is None or name is None:
        return None
    if name == "volume":
        return Coefficient(value, None, name)
    parts = _DIAMETER.fullmatch(name)
    if parts is None:
        table.problem("diameter", Message("refused_file.a_diameter"))
        return None
    ratio = float(parts[1] or 1.0) / (math.pi if parts[2] else 1.0)
    return Coefficient(value, ratio, name)


SCHEMA = "catopt.families/1"
"""What a file of families has under its key ``schema``."""

KIND = "families file"
"""What it is called in messages."""

_TABLES = (".csv", ".xlsx")
"""Endings of files that are tables of sizes (`catopt.catalogue.stock`)."""

_OWN = ("sources.toml", "chain.toml", "buoy_chain.toml", "wire.toml", "fibre.toml")


def read_standard() -> Catalogue:
    """Read the families that come with catopt."""
    sources: dict[str, Source] = {}
    families: list[Family] = []
    for name in _OWN:
        found, sources = _parse(own_text(name), f"catopt's {name}", sources)
        families += found
    return Catalogue(tuple(families))


@cache
def own_sources() -> dict[str, Source]:
    """Read the documents that catopt's own data files name, by key."""
    return _parse(own_text(_OWN[0]), f"catopt's {_OWN[0]}", {})[1]


def own_text(name: str) -> str:
    """Read one of catopt's own data files."""
    return files("catopt.catalogue").joinpath("data", name).read_text(encoding="utf-8")


def read_families(
    path: str | os.PathLike[str], known: Mapping[str, Source] | None = None
) -> Catalogue:
    """Read a file of families; see `catopt.catalogue.read_families`."""
    source = os.fspath(path)
    if Path(path).suffix.lower() in _TABLES:
        from catopt.catalogue.stock import read_stock

        return read_stock(Path(path), source)
    return parse_families(read_text(Path(path), source, kind=KIND), source, known)


def parse_families(
    text: str, source: str = "", known: Mapping[str, Source] | None = None
) -> Catalogue:
    """Read the text of a file of families; it may name known sources beside its own.

    InputError with every problem of the text.
    """
    found, _ = _parse(text, source, known or {})
    return Catalogue(tuple(found))


def _parse(
    text: str, source: str, known: Mapping[str, Source]
) -> tuple[list[Family], dict[str, Source]]:
    """Read families, and the sources known after them."""
    document, findings = TomlTable.of_file(text, source, SCHEMA, ("sources", "family", "figure"))
    sources = {**known, **_sources(document)}
    drafts = [_draft(table, sources) for table in document.tables("family", required=False)]
    by_name = {draft.name: draft for draft in drafts if draft.name}
    figures = [_figure(t, sources, by_name) for t in document.tables("figure", required=False)]
    findings.raise_if_any()
    families = []
    for draft in drafts:
        first, last = draft.range
        own = (  # each ends at the latest where the family ends
            replace(each, range=(max(each.range[0], first), min(each.range[1], last)))
            for each in figures
            if each and draft.name in each.families
        )
        families.append(replace(draft, figures=tuple(own)))
    for index, family in enumerate(families):
        _check_family(findings, f"family[{index}]", family)
    findings.raise_if_any()
    return families, sources


# ------------------------------------------------------------------ parts of a file


def _sources(document: TomlTable) -> dict[str, Source]:
    found = {}
    for key, table in document.named("sources"):
        table.only("title", "place", "origin")
        origin = table.text("origin", required=False) or ""
        found[key] = Source(key, table.cited("title") or "", table.cited("place") or "", origin)
    return found


def _draft(table: TomlTable, sources: Mapping[str, Source]) -> Family:
    """Read a family before its figures are gathered."""
    table.only("name", "title", "also", "grades", "range_mm", "sizes", "note")
    span = table.span_mm("range_mm") or (0.0, 0.0)
    return Family(
        name=table.text("name") or "",
        title=table.said("title") or "",
        also=table.texts("also"),
        grades=table.texts("grades"),
        range=span,
        sizes=_sizes(table, sources, span),
        figures=(),
        note=table.said("note", required=False) or "",
    )


def _sizes(family: TomlTable, sources: Mapping[str, Source], span: tuple[float, float]) -> Sizes:
    table = family.table("sizes")
    if table is None:
        return Sizes()
    table.only("mm", "source", "place", "confidence")
    diameters = table.rising_mm("mm")
    outside = [in_mm(diameter) for diameter in diameters if span[1] and not within(diameter, span)]
    if outside:
        table.problem("mm", Message("refused_file.outside_range", key="range_mm", size=outside[0]))
    return Sizes(diameters, **cited(table, sources))


def cited(table: TomlTable, sources: Mapping[str, Source]) -> dict[str, Any]:
    """Read where an entry comes from: sources, place and confidence."""
    return {
        "sources": _named_sources(table, sources),
        "place": table.cited("place") or "",
        "confidence": table.word("confidence", CONFIDENCES) or CONFIDENCES[-1],
    }


def _named_sources(table: TomlTable, sources: Mapping[str, Source]) -> tuple[Source, ...]:
    """Read the sources that a figure names."""
    keys = table.texts("source", required=True)
    for key in keys:
        if key not in sources:
            values = {"name": key, "listed": ", ".join(sources) or Message("refused_file.none_yet")}
            table.problem("source", Message("refused_file.no_source", table="[sources]", **values))
    return tuple(sources[key] for key in keys if key in sources)


def _figure(
    table: TomlTable, sources: Mapping[str, Source], drafts: Mapping[str, Family]
) -> Figure | None:
    table.only(
        "family", "grade", "quantity", "variant", "default", "reason", "formula", "range_mm",
        "source", "place", "confidence", "note", "checked", "exceeds",
    )  # fmt: skip
    quantity = table.word("quantity", tuple(SPECS))
    families = [drafts[n] for n in table.texts("family", required=True) if _knows(table, drafts, n)]
    grades = _figure_grades(table, families)
    formula = read_formula(table, quantity) if quantity else None
    named = _named_sources(table, sources)
    place, confidence = table.cited("place"), table.word("confidence", CONFIDENCES)
    default = table.flag("default")
    span = _span(table, formula, families)
    if not (quantity and families and formula and named and place and confidence and span):
        return None
    return Figure(
        quantity=quantity,
        variant=table.text("variant", required=False) or "",
        families=tuple(draft.name for draft in families),
        grades=grades,
        formula=formula,
        range=span,
        sources=named,
        place=place,
        confidence=confidence,
        default=True if default is None else default,
        reason=table.said("reason", required=False) or "",
        note=table.said("note", required=False) or "",
        checked=table.text("checked", required=False) or "",
        exceeds=table.said("exceeds", required=False) or "",
    )


def _span(
    table: TomlTable, formula: Formula | None, families: Sequence[Family]
) -> tuple[float, float] | None:
    """Read the range of a figure: as far as its rows or its families go, unless it is given."""
    rows = formula.diameters if isinstance(formula, Rows) else (0.0, math.inf)
    whole = (rows[0], rows[-1])
    if not table.has("range_mm"):
        return whole
    span = table.span_mm("range_mm")
    if span is None:
        return None
    limits: dict[str, tuple[float, float]] = {Message("refused_file.rows_of_formula"): whole}
    # A range of a family that is a problem already is (0, 0).
    limits |= {
        Message("refused_file.range_of", key="range_mm", name=d.name): d.range
        for d in families
        if d.range[1] > 0.0
    }
    for what, limit in limits.items():
        if not (within(span[0], limit) and within(span[1], limit)):
            table.problem("range_mm", Message("refused_file.within", what=what))
    return span


def _knows(table: TomlTable, drafts: Mapping[str, Family], name: str) -> bool:
    if name in drafts:
        return True
    listed = ", ".join(f'"{each}"' for each in drafts) or Message("refused_file.none_yet")
    table.problem("family", Message("refused_file.no_family", name=name, listed=listed))
    return False


def _figure_grades(table: TomlTable, families: Sequence[Family]) -> tuple[str, ...]:
    grades = table.texts("grade")
    for grade in grades:
        for draft in families:
            if grade not in draft.grades:
                listed = ", ".join(draft.grades) or Message("refused.none")
                values = {"name": draft.name, "grade": grade, "listed": listed}
                table.problem("grade", Message("refused_file.no_grade", **values))
    return grades


# ------------------------------------------------------------------ what a family must have


def _check_family(findings: Findings, path: str, family: Family) -> None:
    """Note a problem for each quantity without a figure, and for each choice left open."""
    for quantity, spec in SPECS.items():
        for grade in family.grades or (None,):
            what = f"{quantity} of grade {grade}" if grade else quantity
            found = family.alternatives(quantity, grade)
            if spec.needed and family.default(quantity, grade) is None:
                lacks = Message("refused_sizing.has_no_default_figure", name=family.name, what=what)
                findings.add(path, "", lacks)
            if len(found) > 1:
                _check_choice(findings, path, what, found)
            for figure in found:
                _check_positive(findings, path, figure, what)
                _check_rests(findings, path, family, grade, figure, what)


def _check_choice(findings: Findings, path: str, what: str, found: Sequence[Figure]) -> None:
    names = [figure.variant for figure in found]
    defaults = [figure for figure in found if figure.default]
    if not all(names) or len(set(names)) < len(names):
        wrong = Message("refused_sizing.has_figures_give_each_variant", what=what, found=len(found))
    elif len(defaults) > 1:
        key = "refused_sizing.has_defaults_set_default_false"
        wrong = Message(key, what=what, defaults=len(defaults))
    elif defaults and not defaults[0].reason:
        key = "refused_sizing.has_choice_give_default_reason"
        wrong = Message(key, what=what, value=names[0])
    else:
        return
    findings.add(path, "", wrong)


def _check_positive(findings: Findings, path: str, figure: Figure, what: str) -> None:
    """Note a problem where a figure that stands for itself is not positive in its range."""
    if figure.formula.rests_on:
        return
    for end in figure.range:
        value = figure.formula.value(end, _nothing)
        if not value > 0.0:
            found = f"{value:g} {SPECS[figure.quantity].unit}".rstrip()
            key = "refused_sizing.must_be_positive_not_at"
            findings.add(path, found, Message(key, what=what, end=in_mm(end)))


def _nothing(quantity: str) -> float:
    raise AssertionError(f"rests on {quantity} after all")


def _check_rests(
    findings: Findings, path: str, family: Family, grade: str | None, figure: Figure, what: str
) -> None:
    for other in figure.formula.rests_on:
        if not family.alternatives(other, grade):
            lacks = Message("refused_sizing.taken_from_which_there_no", what=what, other=other)
            findings.add(path, "", lacks)
