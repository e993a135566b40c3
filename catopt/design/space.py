"""The design space of a case: everything that a line may be made of, numbered."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

from catopt.catalogue import Catalogue, Component
from catopt.catalogue.choice import ChosenCatalogue, chosen
from catopt.catalogue.components import RECALLED, within
from catopt.checks.criteria import Criteria
from catopt.design.front import Genes
from catopt.errors import InputError, Problem
from catopt.model import Case, ClumpWeightChoice, Line, LoadCase, PointLoad, Segment, SegmentChoice
from catopt.model.kinds import Findings
from catopt.model.line import line_kind, weight_in_water
from catopt.model.network import Network
from catopt.model.plausible_ranges import NAMES
from catopt.words import Listed, Message, Several

GENES_EACH = 2
"""Genes of a segment, and of a clump weight."""

AT_END = 1e-9
"""Part of the line's length next to its ends in which no clump weight can hang."""


class Variable:
    """What two genes stand for: what a part is made of, and its length or place."""

    is_optional: bool
    """Whether the part may be absent."""
    name: str
    """For tables."""

    @property
    def values(self) -> tuple[Sequence[object], Sequence[object]]:
        """What the part may be made of, and its lengths or places."""
        raise NotImplementedError

    @property
    def sizes(self) -> tuple[int, int]:
        """How many values its two genes have."""
        kinds, places = self.values
        return len(kinds) + self.is_optional, max(len(places), 1)

    @property
    def count(self) -> int:
        """How many different parts it may be, absent included."""
        kinds, places = self.sizes
        return (kinds - self.is_optional) * places + self.is_optional


@dataclass(frozen=True)
class SegmentVariable(Variable):
    """What one segment may be."""

    options: tuple[Segment, ...]  # what it may be made of, each with the first of the lengths
    lengths: tuple[float, ...]  # unstretched, m, rising
    is_optional: bool = False
    name: str = ""

    @property
    def values(self) -> tuple[Sequence[Segment], Sequence[float]]:
        """Options and lengths."""
        return self.options, self.lengths

    def segment(self, kind: int, length: int) -> Segment | None:
        """Return the segment of two genes; None where it is absent."""
        option = kind - self.is_optional
        return None if option < 0 else replace(self.options[option], length=self.lengths[length])


@dataclass(frozen=True)
class ClumpWeightVariable(Variable):
    """What one clump weight may be; it has positions, or hangs at a joint.

    The joint is the upper end of that segment, counted from 1 at the anchor, or where that would be
    when it is absent.
    """

    masses: tuple[float, ...]  # in air, kg, rising
    submerged_weights: tuple[float, ...]  # of those masses, N
    positions: tuple[float, ...] = ()  # unstretched arc length from the anchor, m, rising
    joint: int = 0  # 0 when it has positions
    is_optional: bool = False
    name: str = ""
    friction: float | None = None  # Coulomb coefficient on the bed; None: that of the bed

    @property
    def values(self) -> tuple[Sequence[float], Sequence[float]]:
        """Masses and positions."""
        return self.masses, self.positions


@dataclass(frozen=True)
class LayoutVariable(Variable):
    """How many lines a body may have, and how far away their anchors may be.

    By radii, or by the horizontal force in each line with the body at its origin, from which the
    distance of the anchors follows.
    """

    azimuths: tuple[tuple[float, ...], ...]  # of each number of lines, rad; more lines come later
    radii: tuple[float, ...]  # from the body's origin to the anchors, m, rising
    pretensions: tuple[float, ...] = ()  # N, rising
    is_optional: bool = False
    name: str = ""

    @property
    def values(self) -> tuple[Sequence[object], Sequence[float]]:
        """Azimuths, and radii or pretensions."""
        return self.azimuths, self.pretensions or self.radii


@dataclass(frozen=True)
class DesignSpace:
    """All designs: of one line by itself, or of several such lines about a body."""

    segments: tuple[SegmentVariable, ...]  # from the anchor up; one at least is always there
    clump_weights: tuple[ClumpWeightVariable, ...] = ()
    layout: LayoutVariable | None = None  # None for one line by itself

    @property
    def variables(self) -> tuple[SegmentVariable | ClumpWeightVariable | LayoutVariable, ...]:
        """Segments, clump weights and layout, in the order of their genes."""
        layout = () if self.layout is None else (self.layout,)
        return (*self.segments, *self.clump_weights, *layout)

    @property
    def sizes(self) -> tuple[int, ...]:
        """How many values each gene has."""
        return tuple(size for variable in self.variables for size in variable.sizes)

    @property
    def count(self) -> int:
        """How many designs there are in canonical form.

        Those with a clump weight beyond the end of the line count too; they are never feasible.
        """
        return math.prod(variable.count for variable in self.variables)

    def canonical(self, genes: Genes) -> Genes:
        """Set the second gene of each absent part to 0, in a copy."""
        result = np.array(genes, dtype=np.int64)
        for index, variable in enumerate(self.variables):
            if variable.is_optional:
                first = GENES_EACH * index
                result[result[:, first] == 0, first + 1] = 0
        return result

    def genes_between(self, first: int, end: int) -> Genes:
        """Genes of the designs number `first` to `end` (not included); see `genes_of`."""
        return self.genes_of(np.arange(first, end, dtype=np.int64))

    def genes_of(self, numbers: NDArray[np.int64]) -> Genes:
        """Genes of designs by their number, in canonical form.

        Every design of the space has one number from 0 to below `count`; the last variable changes
        fastest.
        """
        left = numbers
        genes = np.zeros((left.size, len(self.sizes)), dtype=np.int64)
        for index in reversed(range(len(self.variables))):
            variable = self.variables[index]
            left, own = np.divmod(left, variable.count)
            if variable.is_optional:
                # 0 is absent; the rest counts through what it is made of, with each of its places.
                own = own - 1
            kind, place = np.divmod(own, variable.sizes[1])
            is_absent = own < 0
            genes[:, GENES_EACH * index] = np.where(is_absent, 0, kind + variable.is_optional)
            genes[:, GENES_EACH * index + 1] = np.where(is_absent, 0, place)
        return genes

    def flaw(self, genes: tuple[int, ...]) -> str:
        """Say why a design is none: a clump weight hangs at or beyond an end; else empty."""
        lengths = self._lengths(genes)
        total = sum(lengths)
        for number, (variable, position, _) in enumerate(self._hung(genes, lengths), start=1):
            if not AT_END * total < position <= (1.0 - AT_END) * total:
                name = variable.name or Message("design.clump_weight", number=number)
                values = {"part": name, "position": position, "total": total}
                return Message("design.beyond_the_line", **values)
        return ""

    def line(self, genes: tuple[int, ...]) -> Line:
        """Build the line of a design; InputError when it has a flaw."""
        loads = [
            PointLoad(
                position,
                variable.submerged_weights[mass],
                variable.masses[mass],
                variable.name,
                variable.friction,
                accept=NAMES,  # a file's were looked at when it was read
            )
            for variable, position, mass in self._hung(genes, self._lengths(genes))
        ]
        return Line([segment for segment in self._segments(genes) if segment is not None], loads)

    def _segments(self, genes: tuple[int, ...]) -> list[Segment | None]:
        """Return each segment, None where it is absent."""
        pairs = zip(genes[::GENES_EACH], genes[1::GENES_EACH], strict=True)
        return [each.segment(*pair) for each, pair in zip(self.segments, pairs, strict=False)]

    def _lengths(self, genes: tuple[int, ...]) -> list[float]:
        """Length of each segment, 0 where it is absent, m."""
        return [0.0 if each is None else each.length for each in self._segments(genes)]

    def _hung(
        self, genes: tuple[int, ...], lengths: list[float]
    ) -> list[tuple[ClumpWeightVariable, float, int]]:
        """List the clump weights that are there: which, its arc length (m), the index of its mass.

        A joint is where segments have been summed to, one after the other, as the kernel does.
        """
        joints = list(accumulate(lengths))
        hung = []
        for index, variable in enumerate(self.clump_weights, start=len(self.segments)):
            kind, place = genes[GENES_EACH * index : GENES_EACH * (index + 1)]
            mass = kind - variable.is_optional
            if mass >= 0:
                at_joint = variable.joint > 0
                position = joints[variable.joint - 1] if at_joint else variable.positions[place]
                hung.append((variable, position, mass))
        return hung


def resolve(
    case: Case | Network, criteria: Criteria, states: Sequence[LoadCase]
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
        key = f"design.{case.design.varied}[{index}]"
        components = list(_components(choice, catalogue, key, found))
        warnings += _doubts(components, catalogue.families)
        options = [
            replace(each.segment(choice.lengths[0]), **_wear(case.segment_for(index), each))
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
            allowed = Message("refused_case.no_size_sold", choice=_bounds(choice))
            found.add(place, f'"{name}"', allowed)
        yield from components


def _bounds(choice: SegmentChoice) -> Message:
    parts = []
    if choice.diameter_min is not None:
        parts.append(Message("refused_case.from_mm", least=choice.diameter_min * 1e3))
    if choice.diameter_max is not None:
        parts.append(Message("refused_case.up_to_mm", most=choice.diameter_max * 1e3))
    return Several(parts, " ") if parts else Message("refused_case.give_diameters")


def _wear(own: Segment | None, component: Component) -> dict[str, Any]:
    """Wear that the case's line has of its own at this place.

    It goes with the place in the water, not with the size; but what steel loses to corrosion says
    nothing of a fibre rope.
    """
    if own is None:
        return {}
    if line_kind(component.family) == "rope" and line_kind(own.component) != "rope":
        return {}
    return {"wear_rate": own.wear_rate, "wear_zone": own.wear_zone}


def _own(
    case: Case | Network, index: int, choice: SegmentChoice, key: str, found: Findings
) -> Iterator[Segment]:
    """Yield the segment of the case's line at this place, whose length alone varies."""
    if (segment := case.segment_for(index)) is not None:
        yield replace(segment, length=choice.lengths[0], name=segment.name or choice.name)
    else:
        count = len(case.every_line[0].segments)
        allowed = Message("refused_case.missing_line_segments_has_only", segments=count)
        found.add(f"{key}.components", "", allowed)


def _lacking_figures(
    options: list[Segment], components: list[Component], objectives: tuple[str, ...], key: str
) -> Iterator[tuple[str, str, str]]:
    """Yield what the objectives need and an option lacks: where, why, and the option's name."""
    for objective, quantity in (("mass", "mass"), ("cost", "price")):
        for index, option in enumerate(options):
            if objective in objectives and getattr(option, quantity) is None:
                why = components[index].missing.get(quantity, "") if components else ""
                allowed = Message(f"refused_case.no_{quantity}_for_it", objective=objective)
                if why:
                    allowed = Message("refused_case.because", what=allowed, why=why)
                yield key, allowed, option.name or Message("refused_case.own_segment")


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
            own = option.name or Message("refused_case.own_segment")
            yield problem.key, problem.allowed, own


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
        reported = ", ".join(quantities)
        yield Message("design.recalled", components=_listed(names), quantities=reported)
    if unknown:
        yield Message("design.no_EA", components=_listed(unknown))


_USED = ("mass", "volume_diameter", "MBL", "proof_load", "wet_strength_factor", "EA", "price")
"""Quantities that a design is found by."""


def _clump_weight(
    choice: ClumpWeightChoice, case: Case | Network, key: str, found: Findings
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
