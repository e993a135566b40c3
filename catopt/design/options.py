"""From a case to its design space: what the catalogue sells within the bounds of each choice."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from catopt.catalogue import Catalogue, Component
from catopt.catalogue.choice import ChosenCatalogue, chosen
from catopt.catalogue.figure import RECALLED, within
from catopt.checks.criteria import Criteria
from catopt.design.space import ClumpWeightVariable, DesignSpace, SegmentVariable
from catopt.errors import InputError, Problem
from catopt.model import Case, ClumpWeightChoice, LoadCase, Segment, SegmentChoice
from catopt.model.immersion import weight_in_water
from catopt.model.line_kind import line_kind
from catopt.model.validity import Findings
from catopt.words import Listed, Message, Several


def resolve(
    case: Case, criteria: Criteria, states: Sequence[LoadCase]
) -> tuple[DesignSpace, tuple[str, ...]]:
    """Look up what each segment and clump weight of a case's design may be.

    The space of all designs, components in the order of the case and each in rising size, and the
    warnings: figures that were read in no document, stiffnesses that are not known. InputError with
    every problem: no such component, nothing sold within the bounds, a clump weight that floats, a
    figure that an objective or a check needs and the catalogue does not have.
    """
    assert case.design is not None
    found = Findings("design")
    catalogue = chosen(case.catalogue, case.site.water_density)
    warnings: list[str] = []
    variables = []
    for index, choice in enumerate(case.design.segments):
        key = f"design.segments[{index}]"
        components = list(_components(choice, catalogue, key, found))
        warnings += _doubts(components, catalogue.families)
        options = [
            replace(each.segment(choice.lengths[0]), **_wear(case, index, each))
            for each in components
        ]
        if not choice.components:
            options = list(_own(case, index, choice, key, found))
        lacking: dict[tuple[str, str], list[str]] = {}
        for where, allowed, name in (
            *_lacking_figures(options, components, case.design.objectives, key),
            *_lacking_strengths(options, criteria, states, key),
        ):
            lacking.setdefault((where, allowed), []).append(name)
        for (where, allowed), names in lacking.items():
            found.add(where, _listed(names), allowed)
        variables.append(
            SegmentVariable(tuple(options), choice.lengths, choice.optional, choice.name)
        )
    weights = [
        _clump_weight(choice, case, f"design.clump_weights[{index}]", found)
        for index, choice in enumerate(case.design.clump_weights)
    ]
    found.raise_if_any()
    return DesignSpace(tuple(variables), tuple(weights)), tuple(dict.fromkeys(warnings))


def _components(
    choice: SegmentChoice, catalogue: ChosenCatalogue, key: str, found: Findings
) -> Iterator[Component]:
    """Components of a choice, family by family, in rising diameter."""
    limits = (choice.diameter_min or 0.0, choice.diameter_max or math.inf)
    for number, name in enumerate(choice.components):
        place = f"{key}.components[{number}]"
        try:
            if choice.diameters:
                components = [catalogue.component(name, each) for each in choice.diameters]
            else:
                sold = catalogue.sold(name)
                components = [each for each in sold if within(each.nominal_diameter, limits)]
        except InputError as error:
            found.problems += [Problem(place, p.found, p.allowed) for p in error.problems]
            continue
        if not components:
            found.add(
                place, f'"{name}"', Message("refused_case.no_size_sold", choice=_bounds(choice))
            )
        yield from components


def _bounds(choice: SegmentChoice) -> Message:
    parts = []
    if choice.diameter_min is not None:
        parts.append(Message("refused_case.from_mm", least=choice.diameter_min * 1e3))
    if choice.diameter_max is not None:
        parts.append(Message("refused_case.up_to_mm", most=choice.diameter_max * 1e3))
    return Several(parts, " ") if parts else Message("refused_case.give_diameters")


def _wear(case: Case, index: int, component: Component) -> dict[str, Any]:
    """Wear that the case's line has of its own at this place.

    It goes with the place in the water, not with the size; but what steel loses to corrosion says
    nothing of a fibre rope.
    """
    if index >= len(case.line.segments):
        return {}
    own = case.line.segments[index]
    if line_kind(component.family) == "rope" and line_kind(own.component) != "rope":
        return {}
    return {"wear_rate": own.wear_rate, "wear_zone": own.wear_zone}


def _own(
    case: Case, index: int, choice: SegmentChoice, key: str, found: Findings
) -> Iterator[Segment]:
    """Yield the segment of the case's line at this place, whose length alone varies."""
    if index < len(case.line.segments):
        segment = case.line.segments[index]
        yield replace(segment, length=choice.lengths[0], name=segment.name or choice.name)
    else:
        allowed = Message(
            "refused_case.missing_line_segments_has_only", segments=len(case.line.segments)
        )
        found.add(f"{key}.components", "", allowed)


def _lacking_figures(
    options: list[Segment], components: list[Component], objectives: tuple[str, ...], key: str
) -> Iterator[tuple[str, str, str]]:
    """Yield what the objectives need and an option lacks: where, why, and the option's name."""
    for objective, quantity in (("mass", "mass"), ("cost", "price")):
        for index, option in enumerate(options):
            if objective in objectives and getattr(option, quantity) is None:
                why = components[index].missing.get(quantity, "") if components else ""
                allowed = f"no {quantity} is known, which the objective {objective} needs"
                allowed += f" ({why})" if why else ""
                yield key, allowed, option.name or "the line's segment"


def _lacking_strengths(
    options: list[Segment], criteria: Criteria, states: Sequence[LoadCase], key: str
) -> Iterator[tuple[str, str, str]]:
    """Yield what the criteria need and an option lacks: where, why, and the option's name."""
    looked_at = {each.kind for each in states}, key, {each.state for each in states}
    for option in options:
        try:
            problems = list(criteria.lacking(criteria.strength(option, key), *looked_at))
        except InputError as error:
            problems = list(error.problems)
        for problem in problems:
            yield problem.key, problem.allowed, option.name or "the line's segment"


def _listed(names: list[str]) -> str:
    if len(names) <= 2:
        return Listed(names, "and")
    return Message("design.first_to_last", first=names[0], last=names[-1], count=len(names))


def _doubts(components: list[Component], catalogue: Catalogue) -> Iterator[str]:
    """Warn of what was read in no document, and of line that has to be taken as inextensible."""
    recalled: dict[tuple[str, ...], list[str]] = {}
    unknown = []
    for component in components:
        used = tuple(q for q in component.recalled if q in _USED)
        if used:
            recalled.setdefault(used, []).append(component.name)
        if component.EA is None:
            unknown.append(component.name)
        if catalogue.family(component.family).sizes.confidence == RECALLED:
            yield Message("design.recalled_sizes", family=component.family)
    for quantities, names in recalled.items():
        told = ", ".join(quantities)
        yield Message("design.recalled", components=_listed(names), quantities=told)
    if unknown:
        yield Message("design.no_EA", components=_listed(unknown))


_USED = ("mass", "volume_diameter", "MBL", "proof_load", "wet_strength_factor", "EA", "price")
"""Quantities that a design is found by."""


def _clump_weight(
    choice: ClumpWeightChoice, case: Case, key: str, found: Findings
) -> ClumpWeightVariable:
    water = case.site.water_density
    if choice.density <= water:
        allowed = Message("refused_case.clump_weight_sinks_above_kg", water=water)
        found.add(f"{key}.density", f"{choice.density:g} kg/m3", allowed)
    return ClumpWeightVariable(
        choice.masses,
        tuple(weight_in_water(mass, choice.density, water) for mass in choice.masses),
        choice.positions,
        choice.joint or 0,
        choice.optional,
        choice.name,
        choice.friction,
    )
