"""Searches a catalogue for components that are strong or light enough."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from catopt.catalogue.collection import NO_VARIANTS, Catalogue
from catopt.catalogue.components import Component
from catopt.catalogue.family import Family
from catopt.catalogue.figure import SPECS
from catopt.catalogue.standard import standard
from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import InputError, Problem
from catopt.model.validity import Findings
from catopt.units import as_written
from catopt.words import Message


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
            variants=held_by(each, its_grade, variants),
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
    for grade in grades or ():
        if grade.casefold() not in possible:
            listed = (
                Message("refused.one_of", words=", ".join(possible.values()))
                if possible
                else Message("refused_sizing.no_grades")
            )
            check.add("grade", as_written(grade), listed)
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
        if not any(held_by(family, grade, {quantity: variant}) for family, grade in wanted):
            known = quantity in SPECS or quantity == "all"
            what = (
                Message("refused_sizing.none_these_families_has")
                if known
                else Message("refused.of_these", words=", ".join(SPECS))
            )
            check.add(f"variants.{quantity}", as_written(variant), what)


def held_by(family: Family, grade: str | None, variants: Mapping[str, str]) -> dict[str, str]:
    """Keep the variants that a family has; the others keep their defaults."""
    own = {(f.quantity, f.variant) for q in SPECS for f in family.alternatives(q, grade)}
    names = {variant for _, variant in own}
    return {
        quantity: variant
        for quantity, variant in variants.items()
        if (quantity, variant) in own or (quantity == "all" and variant in names)
    }
