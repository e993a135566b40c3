"""A catalogue: families of components, what can be asked of them, and the one that comes along."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

from catopt.catalogue.components import (
    NO_FIGURE,
    RECALLED,
    SPECS,
    Alternative,
    Component,
    Figure,
    Hydrodynamic,
    MeanLoadTerms,
    Provenance,
    Source,
    weakest,
    within,
)
from catopt.catalogue.family import ComponentName, Family, find_name, in_mm, meant, shared_names
from catopt.catalogue.formula import Coefficient, MeanLoad
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.errors import InputError, Problem, refused
from catopt.model.kinds import Findings
from catopt.model.line import line_kind
from catopt.units import as_written
from catopt.words import Cited, Message, is_said

WEIGHT_SOURCE = Source("CATOPT", "catopt, from mass and volume", Cited("catopt.catalogue"))
"""The submerged weight is no printed figure: it follows from two of them."""

_VALUES = ("MBL", "proof_load", "wet_strength_factor", "EA", "price")
_COEFFICIENTS = ("drag_normal", "drag_axial", "added_mass_normal", "added_mass_axial")


@dataclass(frozen=True)
class Evaluation:
    """The figures that were chosen of a family in a grade, at a nominal diameter, m."""

    family: Family
    grade: str | None
    diameter: float
    """Within the family's range."""
    chosen: Mapping[str, Figure]
    """By quantity: the variants asked for, else the defaults."""
    asked: frozenset[str] = frozenset()
    """Quantities whose variant was asked for by name: there an unknown value is an error."""
    allow_recalled: bool = False
    """Whether figures of confidence R may be used."""
    _known: dict[str, float] = field(default_factory=dict, repr=False, compare=False)

    def at(self, diameter: float) -> Evaluation:
        """Return the same choice at another nominal diameter."""
        return replace(self, diameter=diameter, _known={})

    def value(self, quantity: str) -> float:
        """Evaluate a quantity in SI; InputError says why it is not known."""
        if quantity not in self._known:
            lacks = self.why_not(quantity)
            if lacks:
                raise refused(quantity, "", lacks, self._name)
            self._known[quantity] = self.chosen[quantity].formula.value(self.diameter, self.value)
        return self._known[quantity]

    def why_not(self, quantity: str) -> str:
        """Say why a quantity is not known here; empty when it is."""
        figure = self.chosen.get(quantity)
        if figure is None:
            others = self.family.alternatives(quantity, self.grade)
            if not others:
                return Message(NO_FIGURE)
            names = ", ".join(each.variant for each in others)
            return Message("catalogue.no_default", variants=names)
        if figure.confidence == RECALLED and not self.allow_recalled:
            return Message("catalogue.only_recalled")
        if not figure.covers(self.diameter):
            low, high = (in_mm(end) for end in figure.range)
            values = {"low": low, "high": high, "diameter": in_mm(self.diameter)}
            others = self.family.alternatives(quantity, self.grade)
            reach = [
                e.variant for e in others if e.covers(self.diameter) and e.confidence != RECALLED
            ]
            if figure.variant and reach:
                values["others"] = ", ".join(reach)
                return Message("catalogue.known_from_others", variant=figure.variant, **values)
            if figure.variant:
                return Message("catalogue.known_from_by", variant=figure.variant, **values)
            return Message("catalogue.known_from", **values)
        return next((why for key in figure.formula.rests_on if (why := self.why_not(key))), "")

    @property
    def is_made(self) -> bool:
        """Whether what no component can do without, or was asked for, holds at this diameter."""
        needed = {key for key, spec in SPECS.items() if spec.needed or key == "MBL"} | self.asked
        return all(f.covers(self.diameter) for key in needed if (f := self.chosen.get(key)))

    def component(self, water_density: float) -> Component:
        """Put the component together.

        InputError: mass, volume or strength has no value here, or a variant that was asked for has
        none.
        """
        lacking = {key: why for key in SPECS if (why := self.why_not(key))}
        needed = {key for key, spec in SPECS.items() if spec.needed} | self.asked
        if "MBL" in lacking and "MBL" in self.chosen and not self._is_barred("MBL"):
            needed |= {"MBL"}  # a strength is known, but not here
        problems = [Problem(key, "", why) for key, why in lacking.items() if key in needed]
        if problems:
            raise InputError(problems, self._name)
        origins = {key: self._provenance(key) for key in SPECS if key not in lacking}
        missing = {
            key: why
            for key, why in lacking.items()
            if not (is_said(why, NO_FIGURE) and SPECS[key].of_some)
        }
        values: dict[str, Any] = {key: self._hydrodynamic(key) for key in _COEFFICIENTS}
        values |= {key: None if key in lacking else self.value(key) for key in _VALUES}
        mass, volume = origins["mass"], origins["volume_diameter"]
        origins["submerged_weight"] = Provenance(
            sources=(WEIGHT_SOURCE,),
            place="from the mass and the volume-equivalent diameter above",
            confidence=weakest([mass.confidence, volume.confidence]),
            formula=Message("catalogue.by_volume", weight="(m - rho_w pi D^2/4) g0 N/m"),
            range=(max(mass.range[0], volume.range[0]), min(mass.range[1], volume.range[1])),
        )
        section = math.pi * self.value("volume_diameter") ** 2 / 4.0
        return Component(
            name=self._name,
            family=self.family.name,
            grade=self.grade,
            nominal_diameter=self.diameter,
            mass=self.value("mass"),
            submerged_weight=(self.value("mass") - water_density * section) * STANDARD_GRAVITY,
            volume_diameter=self.value("volume_diameter"),
            water_density=water_density,
            EA_dynamic_terms=self._dynamic_terms(),
            **values,
            provenance=MappingProxyType(origins),
            missing=MappingProxyType(missing),
            _evaluation=self,
        )

    def alternatives(self) -> tuple[Alternative, ...]:
        """Evaluate every figure that is not in use, recalled ones included."""
        others = (
            figure
            for quantity in SPECS
            for figure in self.family.alternatives(quantity, self.grade)
            if figure is not self.chosen.get(quantity) or self._is_barred(quantity)
        )
        return tuple(self._alternative(figure) for figure in others)

    def _alternative(self, figure: Figure) -> Alternative:
        key = figure.quantity
        chosen = {**self.chosen, key: figure}
        other = replace(self, chosen=chosen, allow_recalled=True, _known={})
        reaches = not other.why_not(key)
        known = other._hydrodynamic(key) if isinstance(figure.formula, Coefficient) else None
        return Alternative(
            quantity=key,
            variant=figure.variant,
            value=other.value(key) if reaches else None,
            reference=known.diameter if known else None,
            provenance=other._provenance(key),
        )

    @property
    def _name(self) -> str:
        parts = (self.family.name, self.grade, in_mm(self.diameter))
        return " ".join(part for part in parts if part)

    def _is_barred(self, quantity: str) -> bool:
        """Whether a quantity is held back only because it, or what it rests on, is recalled."""
        if self.allow_recalled or not self.why_not(quantity):
            return False
        return not replace(self, allow_recalled=True, _known={}).why_not(quantity)

    def _hydrodynamic(self, quantity: str) -> Hydrodynamic | None:
        if self.why_not(quantity):
            return None
        formula = self.chosen[quantity].formula
        assert isinstance(formula, Coefficient)
        reference = formula.reference(self.diameter, self.value)
        return Hydrodynamic(formula.coefficient, reference, formula.name)

    def _dynamic_terms(self) -> MeanLoadTerms | None:
        if self.why_not("EA_dynamic"):
            return None
        formula = self.chosen["EA_dynamic"].formula
        assert isinstance(formula, MeanLoad)
        return MeanLoadTerms(formula.constant, formula.slope)

    def _chain_of(self, quantity: str) -> tuple[Figure, ...]:
        """List a figure and all that it rests on."""
        figure = self.chosen[quantity]
        below = (self._chain_of(key) for key in figure.formula.rests_on)
        return (figure, *(each for chain in below for each in chain))

    def _provenance(self, quantity: str) -> Provenance:
        figure = self.chosen[quantity]
        others = self.family.alternatives(quantity, self.grade)
        return Provenance(
            sources=figure.sources,
            place=figure.place,
            confidence=weakest(each.confidence for each in self._chain_of(quantity)),
            formula=figure.text,
            variant=figure.variant,
            alternatives=tuple(each.variant for each in others if each is not figure),
            reason=figure.reason if len(others) > 1 else "",
            range=figure.range,
            note=figure.note,
        )


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
