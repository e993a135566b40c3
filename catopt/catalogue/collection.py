"""A catalogue: families of components, what can be asked of them, and the one that comes along."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from catopt.catalogue.components import RECALLED, SPECS, Component, Figure, within
from catopt.catalogue.evaluation import Evaluation
from catopt.catalogue.family import ComponentName, Family, find_name, in_mm, meant, shared_names
from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import InputError, Problem
from catopt.model.kinds import Findings
from catopt.model.line import line_kind
from catopt.units import as_written
from catopt.words import Message

ALL = "all"
"""Key of `variants` that stands for every quantity with a variant of that name."""

NO_VARIANTS: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True)
class Catalogue:
    """Families of components in the order of the files; no two share a name."""

    families: tuple[Family, ...]

    def __post_init__(self) -> None:
        problems = [
            Problem(
                "family",
                as_written(name),
                Message("refused_sizing.name_already_give_another", owner=owner),
            )
            for name, owner in shared_names(self.families)
        ]
        if problems:
            raise InputError(problems, "catalogue")

    def with_families(self, other: Catalogue) -> Catalogue:
        """Add the families of another catalogue, which must have no name that is in this one."""
        return Catalogue((*self.families, *other.families))

    def parse_name(self, name: object) -> ComponentName:
        """Read the name of a component, such as ``"chain studless R3"``; else InputError."""
        return find_name(name, self.families)

    def family(self, name: object) -> Family:
        """Look a family up by any of its names; InputError gives the nearest."""
        found = self.parse_name(name).family
        return next(family for family in self.families if family.name == found)

    def component(
        self,
        family: str,
        diameter: float | str,
        *,
        grade: str | None = None,
        variants: Mapping[str, str] = NO_VARIANTS,
        water_density: float | str = SEA_WATER_DENSITY,
        allow_recalled: bool = False,
    ) -> Component:
        """Look a component up; see `catopt.catalogue.component`."""
        parsed = self.parse_name(family)
        found = self.family(parsed.family)
        check = Findings(f"component {found.name}")
        nominal = check.taken("diameter", diameter, "m", at_least=0.0)
        density = check.taken("water_density", water_density, "kg/m3", at_least=0.0)
        check.raise_if_any()
        grade = _grade(check, found, grade if grade is not None else parsed.grade)
        _check_diameter(check, found, nominal, self.families)
        check.number("water_density", density, "kg/m3", above=0.0)
        chosen = _choose(check, found, grade, variants, allow_recalled)
        check.raise_if_any()
        asked = frozenset(variants) - {ALL}
        evaluation = Evaluation(found, grade, nominal, chosen, asked, allow_recalled)
        return evaluation.component(density)

    def sold(
        self,
        family: str,
        *,
        grade: str | None = None,
        variants: Mapping[str, str] = NO_VARIANTS,
        water_density: float = SEA_WATER_DENSITY,
        allow_recalled: bool = False,
    ) -> tuple[Component, ...]:
        """List a family's components in the sizes that are sold, one grade or all.

        A size at which a needed figure has no value (a grade that is made in fewer sizes, a
        variant that covers fewer) is left out. InputError: no such family, grade or variant.
        """
        parsed = self.parse_name(family)
        found = self.family(parsed.family)
        check = Findings(f"component {found.name}")
        wanted = grade if grade is not None else parsed.grade
        grades: tuple[str | None, ...] = found.grades or (None,)
        if wanted is not None:
            grades = (_grade(check, found, wanted),)
        check.number("water_density", water_density, "kg/m3", above=0.0)
        chosen = {each: _choose(check, found, each, variants, allow_recalled) for each in grades}
        check.raise_if_any()
        asked = frozenset(variants) - {ALL}
        made = (
            Evaluation(found, each, diameter, chosen[each], asked, allow_recalled)
            for each in grades
            for diameter in found.sizes.diameters
        )
        return tuple(each.component(water_density) for each in made if each.is_made)


def _grade(check: Findings, family: Family, grade: str | None) -> str | None:
    """Note a problem unless the grade is one of the family's; return it as the family writes it."""
    if not family.grades:
        if grade is not None:
            check.add(
                "grade",
                as_written(grade),
                Message("refused_sizing.has_no_grades_leave_out", name=family.name),
            )
        return None
    allowed = Message("refused.one_of", words=", ".join(family.grades))
    if grade is None:
        check.add("grade", "", Message("refused.missing", wanted=allowed))
        return None
    by_plain = {each.casefold(): each for each in family.grades}
    if grade.casefold() not in by_plain:
        check.add("grade", as_written(grade), meant(allowed, grade, family.grades))
        return None
    return by_plain[grade.casefold()]


def _check_diameter(
    check: Findings, family: Family, diameter: float, families: Iterable[Family]
) -> None:
    """Note a problem unless the nominal diameter lies within the family's range.

    It names the families of the same kind that are known there.
    """
    before = len(check.problems)
    check.number("diameter", diameter, "m", above=0.0)
    if len(check.problems) > before:
        return
    if not within(diameter, family.range):
        low, high = map(in_mm, family.range)
        allowed = Message("refused.known", name=family.name, low=low, high=high)
        if within(diameter / 1e3, family.range):  # meant in mm
            allowed = Message("refused.known_in_m", known=allowed, meant=diameter / 1e3)
        else:
            others = ", ".join(
                each.name
                for each in families
                if within(diameter, each.range) and line_kind(each.name) == line_kind(family.name)
            )
            if others:
                allowed = Message("refused.known_others", known=allowed, names=others)
        check.add("diameter", in_mm(diameter), allowed)


def _choose(
    check: Findings,
    family: Family,
    grade: str | None,
    variants: Mapping[str, str],
    allow_recalled: bool,
) -> dict[str, Figure]:
    """Pick a figure for each quantity; note a problem for each variant that cannot be had."""
    chosen = {q: found for q in SPECS if (found := family.default(q, grade)) is not None}
    every = [figure for q in SPECS for figure in family.alternatives(q, grade)]
    everywhere = variants.get(ALL)
    if everywhere is not None:
        same = {each.quantity: each for each in every if each.variant == everywhere}
        if not same:
            _no_variant(check, ALL, everywhere, sorted({each.variant for each in every} - {""}))
        for figure in same.values():
            _bar_recalled(check, figure, allow_recalled)
        chosen |= same
    for quantity, variant in variants.items():
        if quantity == ALL:
            continue
        if quantity not in SPECS:
            allowed = meant(Message("refused.of_these", words=", ".join(SPECS)), quantity, SPECS)
            check.add("variants", as_written(quantity), allowed)
            continue
        own = {f.variant: f for f in reversed(family.alternatives(quantity, grade))}
        if variant in own:
            chosen[quantity] = own[variant]
            _bar_recalled(check, own[variant], allow_recalled)
        else:
            _no_variant(check, quantity, variant, filter(None, reversed(own)))
    return chosen


def _no_variant(check: Findings, quantity: str, variant: str, names: Iterable[str]) -> None:
    check.add(f"variants.{quantity}", as_written(variant), one_of_variants(names))


def one_of_variants(names: Iterable[str]) -> Message:
    """Say which variants there are to choose from, or that there is one figure only."""
    listed = ", ".join(names)
    return Message("refused.one_of", words=listed) if listed else Message("refused.one_figure")


def _bar_recalled(check: Findings, figure: Figure, allow_recalled: bool) -> None:
    if figure.confidence == RECALLED and not allow_recalled:
        why = Message("catalogue.only_recalled")
        check.add(f"variants.{figure.quantity}", as_written(figure.variant), why)
