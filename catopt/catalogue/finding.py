"""Finds what is strong or light enough, or what somebody names as it is said."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Final, TypeAlias

from catopt.catalogue.collection import ALL, NO_VARIANTS, Catalogue
from catopt.catalogue.components import SPECS, Component, within
from catopt.catalogue.family import Family, in_mm, nearest, words_of
from catopt.catalogue.fittings import AnchorType, Fitting, anchor_types, fittings
from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import InputError, Problem
from catopt.model.kinds import Findings
from catopt.units import as_written
from catopt.words import LANGUAGES, Message, Several, say, term


@cache
def standard() -> Catalogue:
    """Return the catalogue that comes with catopt; it is read once."""
    from catopt.catalogue.reading import read_standard

    return read_standard()


def component_names() -> tuple[str, ...]:
    """List what a case may name: every family that comes along, with its grade where it has any."""
    named = ((each.name, grade) for each in standard().families for grade in each.grades or ("",))
    return tuple(f"{name} {grade}".rstrip() for name, grade in named)


def search(
    *,
    MBL_at_least: float | None = None,
    proof_load_at_least: float | None = None,
    mass_at_most: float | None = None,
    price_at_most: float | None = None,
    diameter_at_least: float | None = None,
    diameter_at_most: float | None = None,
    family: str | Sequence[str] | None = None,
    grade: str | Sequence[str] | None = None,
    variants: Mapping[str, str] = NO_VARIANTS,
    water_density: float = SEA_WATER_DENSITY,
    allow_recalled: bool = False,
    all_sizes: bool = False,
    among: Catalogue | None = None,
) -> tuple[Component, ...]:
    """Find components, in the sizes that are sold, that meet every limit; the lightest first.

    Parameters
    ----------
    MBL_at_least, proof_load_at_least : float, optional
        N. The MBL is that in water, which for nylon is less than the dry one.
    mass_at_most : float, optional
        In air, kg/m.
    price_at_most : float, optional
        USD/m. A component without price does not meet it.
    diameter_at_least, diameter_at_most : float, optional
        Nominal, m.
    family, grade : str or sequence of str, optional
        Only these.
    variants, water_density, allow_recalled
        As for `component`; a family that lacks a variant keeps its default.
    all_sizes : bool
        Every size that meets the limits, instead of the smallest of each family and grade.
    among : Catalogue, optional
        Instead of catopt's own.

    Raises
    ------
    InputError
        With every problem of the limits, names and variants.
    """
    catalogue = among or standard()
    limits = [
        ("MBL_at_least", "MBL_in_water", MBL_at_least, "N"),
        ("proof_load_at_least", "proof_load", proof_load_at_least, "N"),
        ("mass_at_most", "mass", mass_at_most, "kg/m"),
        ("price_at_most", "price", price_at_most, "USD/m"),
        ("diameter_at_least", "nominal_diameter", diameter_at_least, "m"),
        ("diameter_at_most", "nominal_diameter", diameter_at_most, "m"),
    ]
    check = Findings("search")
    for key, _, limit, unit in limits:
        if limit is not None:
            check.number(key, limit, unit, at_least=0.0)
    check.number("water_density", water_density, "kg/m3", above=0.0)
    wanted = list(_wanted(check, catalogue, _several(family), _several(grade)))
    _check_variants(check, wanted, variants)
    check.raise_if_any()

    def meets(component: Component) -> bool:
        for key, name, limit, _ in limits:
            value = getattr(component, name)
            if limit is not None and (
                value is None or (value < limit if key.endswith("least") else value > limit)
            ):
                return False
        return True

    found: list[Component] = []
    for each, its_grade in wanted:
        components = catalogue.sold(
            each.name,
            grade=its_grade,
            variants=own_variants(each, its_grade, variants),
            water_density=water_density,
            allow_recalled=allow_recalled,
        )
        fitting = [component for component in components if meets(component)]
        found += fitting if all_sizes else fitting[:1]
    return tuple(sorted(found, key=lambda component: component.mass))


def _several(names: str | Sequence[str] | None) -> Sequence[str] | None:
    return [names] if isinstance(names, str) else names


def _wanted(
    check: Findings,
    catalogue: Catalogue,
    families: Sequence[str] | None,
    grades: Sequence[str] | None,
) -> Iterator[tuple[Family, str | None]]:
    """List families with their grades, as far as they were asked for."""
    named: list[tuple[Family, str | None]] = []
    for name in families or ():
        try:
            parsed = catalogue.parse_name(name)
        except InputError as error:
            check.problems += [Problem("family", p.found, p.allowed) for p in error.problems]
            continue
        named.append((catalogue.family(parsed.family), parsed.grade))
    if families is None:
        named = [(family, None) for family in catalogue.families]
    possible = {grade.casefold(): grade for family, _ in named for grade in family.grades}
    allowed = Message("refused_sizing.no_grades")
    if possible:
        allowed = Message("refused.one_of", words=", ".join(possible.values()))
    for grade in grades or ():
        if grade.casefold() not in possible:
            check.add("grade", as_written(grade), allowed)
    asked = None if grades is None else {grade.casefold() for grade in grades}
    for family, of_name in named:
        for each in [of_name] if of_name else (family.grades or (None,)):
            if asked is None or (each is not None and each.casefold() in asked):
                yield family, each


def _check_variants(
    check: Findings, wanted: Iterable[tuple[Family, str | None]], variants: Mapping[str, str]
) -> None:
    """Note a problem for each variant that none of the families has."""
    for quantity, variant in variants.items():
        if not any(own_variants(family, grade, {quantity: variant}) for family, grade in wanted):
            allowed = Message("refused_sizing.none_these_families_has")
            if quantity not in (*SPECS, ALL):
                allowed = Message("refused.of_these", words=", ".join(SPECS))
            check.add(f"variants.{quantity}", as_written(variant), allowed)


def own_variants(family: Family, grade: str | None, variants: Mapping[str, str]) -> dict[str, str]:
    """Keep the variants that a family has; the others keep their defaults."""
    own = {(f.quantity, f.variant) for q in SPECS for f in family.alternatives(q, grade)}
    names = {variant for _, variant in own}
    return {
        quantity: variant
        for quantity, variant in variants.items()
        if (quantity, variant) in own or (quantity == ALL and variant in names)
    }


def variants_of(family: Family, grade: str | None) -> tuple[str, ...]:
    """List the variants of figures that a family has beside the usual ones."""
    every = (each.variant for q in SPECS for each in family.alternatives(q, grade))
    return tuple(dict.fromkeys(name for name in every if name))


_NUMBER = r"(\d+(?:[.,]\d+)?|\d+/0*[1-9]\d*)"
_SIZE: Final = re.compile(rf'(?:dn|ø)?{_NUMBER}(mm|cm|in|")?')
_MASS: Final = re.compile(rf"{_NUMBER}(t|kg|tonnes?|tan)")
_APART: Final = re.compile(
    rf"(?<![\w.,]){_NUMBER}\s+(mm|cm|in|t|kg|tonnes?|tấn)(?!\w)|\b(dn|ø)\s+(?=\d)"
)
"""A number apart from its unit, or DN apart from its number."""

_UNITS: Final = {"mm": 1e-3, "cm": 1e-2, "in": 25.4e-3, '"': 25.4e-3, "": 1e-3}

_FILLERS: Final = frozenset({
    "for", "of", "a", "an", "the", "in", "on", "size", "sizes", "grade", "class", "dia",
    "diameter", "cỡ", "cấp", "loại", "đường", "kính", "trong", "trên", "nền", "bằng", "cho",
})  # fmt: skip
"""Words that name nothing; Vietnamese with their accents, without which cap is a rope, too."""

SOILS: Final[Mapping[str, str]] = {
    "sand": "sand", "cát": "sand", "cat": "sand", "clay": "soft clay", "mud": "soft clay",
    "soft": "soft clay", "bùn": "soft clay", "bun": "soft clay", "sét": "soft clay",
    "set": "soft clay", "medium": "medium clay",
}  # fmt: skip
"""Soils of a drag anchor by what people call them; of clays that are not named the softest."""

MOST_ROWS: Final = 60
"""Rows of components and of fittings in an answer; `Found.left_out` counts what is beyond."""


_Asked: TypeAlias = tuple[Family, tuple[str | None, ...]]
"""A family with the grades that were asked for."""

_Named: TypeAlias = Family | AnchorType | Fitting
"""What goes by a name, a title and other names."""


@dataclass(frozen=True)
class Query:
    """What was asked for, in SI; None where it was not said."""

    words: tuple[str, ...]
    size: float | None
    mass: float | None
    numbers: tuple[str, ...] = ()
    """Bare numbers, of which one may be a grade."""
    soil: str | None = None


@dataclass(frozen=True)
class Found:
    """What goes by a name."""

    query: Query
    components: tuple[Component, ...]
    anchors: tuple[AnchorType, ...]
    fittings: tuple[Fitting, ...]
    left_out: int = 0
    """Components and fittings beyond `MOST_ROWS` of each, which a size or a grade would show."""


def find(text: str, among: Catalogue | None = None) -> Found:
    """Find components, anchors and fittings by what they are called.

    Raises
    ------
    InputError
        When nothing goes by the name, or nothing of that name has the size; the message has the
        nearest.
    """
    query = read_query(text)
    catalogue = among or standard()
    families = [] if query.mass is not None else _matching(query, catalogue.families)
    anchors = () if query.size is not None else tuple(_anchors(query))
    parts = () if query.mass is not None else tuple(_fittings(query))
    components = [
        c for family, grades in families for c in _sized(catalogue, family, grades, query)
    ]
    if not (components or anchors or parts):
        raise InputError([_problem(text, query, families, catalogue)], "catalogue")
    left_out = sum(max(len(each) - MOST_ROWS, 0) for each in (components, parts))
    return Found(query, tuple(components[:MOST_ROWS]), anchors, parts[:MOST_ROWS], left_out)


def read_query(text: str) -> Query:
    """Read what is asked for: words, a size or a mass."""
    joined = _APART.sub(lambda m: f"{m[1] or ''}{m[2] or ''}{m[3] or ''}", text.casefold())
    words: list[str] = []
    numbers: list[str] = []
    size = mass = soil = None
    for word in joined.replace("-", " ").split():
        plain = words_of(word)[0] if words_of(word) else ""
        of_mass, of_size = _MASS.fullmatch(plain), _SIZE.fullmatch(word.strip(",;"))
        if of_mass:
            mass = _value(of_mass[1]) * (1.0 if of_mass[2] == "kg" else 1e3)
        elif of_size and (of_size[2] or not word[0].isdigit()):
            size = _value(of_size[1]) * _UNITS[of_size[2] or ""]
        elif of_size:
            numbers.append(of_size[1])
        elif word in SOILS and soil is None:
            soil = SOILS[word]
            words.append(plain)
        elif word not in _FILLERS and plain:
            words.append(plain)
    if size is None and mass is None and numbers:
        size = _value(numbers[0]) / 1e3
    return Query(tuple(words), size, mass, tuple(numbers), soil)


def _value(number: str) -> float:
    top, _, bottom = number.replace(",", ".").partition("/")
    return float(top) / float(bottom or 1.0)


def _words(of: _Named) -> frozenset[str]:
    """List what a thing may be called by: the words of its names and of its title."""
    titles = (say(of.title, language) for language in LANGUAGES)
    return frozenset(word for each in (of.name, *of.also, *titles) for word in words_of(each))


def _matching(query: Query, families: Iterable[Family]) -> list[_Asked]:
    """Find families that have every word, with the grades that were asked for."""
    found: list[_Asked] = []
    for family in families:
        known = _words(family)
        by_plain = {each.casefold(): each for each in family.grades}
        asked = tuple(by_plain[w] for w in (*query.words, *query.numbers) if w in by_plain)
        rest = [word for word in query.words if word not in by_plain]
        if rest and all(word in known for word in rest):
            found.append((family, asked or tuple(family.grades) or (None,)))
    return found


def _sized(
    catalogue: Catalogue, family: Family, grades: tuple[str | None, ...], query: Query
) -> Iterator[Component]:
    """Look the size up in every grade; all that are sold where no size was named."""
    size = query.size
    of_grade = {_value(n) / 1e3 for n in query.numbers if n in family.grades}
    if size in of_grade:
        others = [n for n in query.numbers if n not in family.grades]
        size = _value(others[0]) / 1e3 if others else None
    for grade in grades:
        if size is None:
            yield from catalogue.sold(family.name, grade=grade)
        elif within(size, family.range):
            # A figure may reach further by another of its sources than by the usual one.
            for variants in ({}, *({ALL: each} for each in variants_of(family, grade))):
                try:
                    yield catalogue.component(family.name, size, grade=grade, variants=variants)
                    break
                except InputError:  # a grade or a figure that does not reach this size
                    continue


def _anchors(query: Query) -> Iterator[AnchorType]:
    """Find kinds that have every word, but those of a soil."""
    wanted = [word for word in query.words if word not in SOILS]
    for each in anchor_types():
        known = _words(each) | {"anchor", "neo"}
        if wanted and all(word in known for word in wanted):
            yield each


def _fittings(query: Query) -> Iterator[Fitting]:
    for each in fittings():
        known = _words(each)
        right = query.size is None or abs(each.size - query.size) <= _HALF_A_MM
        if query.words and right and all(word in known for word in query.words):
            yield each


_LEAST_HINT: Final = 4
"""Letters of a word that may have been meant: shorter ones are like too many others."""

_HALF_A_MM = 0.5e-3
"""A fitting is looked up by the size printed, in whole mm."""


def _sizes_of(parts: Iterable[Fitting]) -> Iterator[Message]:
    """Say of each fitting how many sizes it has, and between which."""
    by_name: dict[str, list[float]] = {}
    for each in parts:
        by_name.setdefault(each.name, []).append(each.size)
    for name, sizes in by_name.items():
        ends = {"low": in_mm(min(sizes)), "high": in_mm(max(sizes))}
        yield Message("catalogue.sizes_of", name=term(name), count=len(sizes), **ends)


def _problem(text: str, query: Query, families: list[_Asked], catalogue: Catalogue) -> Problem:
    """Say why nothing was found, with the nearest."""
    if query.size is not None:
        known = [
            *(Several((family.name, family.known_range), " ") for family, _ in families),
            *_sizes_of(_fittings(replace(query, size=None))),
        ]
        if known:
            allowed = Message("catalogue.not_this_size", known=Several(known, "; "))
            return Problem("size", in_mm(query.size), allowed)
    things: tuple[_Named, ...] = (*catalogue.families, *anchor_types(), *fittings())
    every = {word for each in things for word in _words(each)}
    odd = [word for word in query.words if word not in every]
    near = [(word, nearest(word, every)) for word in odd]
    hints = [
        Message("catalogue.for_word", good=good, word=word)
        for word, good in near
        if good and len(good) >= _LEAST_HINT
    ]
    key = "catalogue.nothing_but" if hints else "catalogue.nothing_found"
    return Problem("component", as_written(text), Message(key, hints=Several(hints, ", ")))
