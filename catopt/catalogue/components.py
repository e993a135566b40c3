"""A component: a family in one grade and diameter, every figure with its source and trust."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, get_args

from catopt.catalogue.formula import Formula
from catopt.display import Tabled
from catopt.errors import InputError, Problem
from catopt.model import Segment
from catopt.model.kinds import (
    Density,
    Length,
    MassPerLength,
    NotNegative,
    Price,
    Strength,
    Weight,
)
from catopt.records import Record
from catopt.records import within as within_part
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catalogue.collection import Evaluation

Confidence = Literal["A", "B", "C", "R"]
"""A: read in the primary or official document. B: read in two independent secondary sources, or in
one and checked by numbers. C: read in one secondary source. R: recalled, read in no document."""

CONFIDENCES: tuple[Confidence, ...] = get_args(Confidence)
"""From the strongest to the weakest."""

RECALLED: Confidence = "R"
"""What is used only when it is asked for."""


def weakest(confidences: Iterable[Confidence]) -> Confidence:
    """Pick the least trusted; A of none at all."""
    order = [CONFIDENCES.index(each) for each in confidences]
    return CONFIDENCES[max(order, default=0)]


@dataclass(frozen=True)
class Spec:
    """What a quantity of the catalogue is, in the words that head a table."""

    words: str
    unit: str
    """SI; empty for a pure number."""
    forms: tuple[str, ...]
    """Keys that its formula may have."""
    of: tuple[str, ...] = ()
    """Quantities that it may be a multiple of."""
    needed: bool = False
    """Whether every family has to have it."""
    of_some: bool = False
    """Whether it is of some kinds of line only, so that a family without it lacks nothing."""


_POWERS = ("d0", "d1", "d2", "d3")
_LOADS = (*_POWERS, "chain_load", "rows")

SPECS: dict[str, Spec] = {
    "mass": Spec("mass in air per length", "kg/m", (*_POWERS, "rows"), needed=True),
    "volume_diameter": Spec("volume-equivalent diameter", "m", (*_POWERS, "density"), needed=True),
    "MBL": Spec("minimum breaking load", "N", (*_LOADS, "times"), ("proof_load",)),
    "proof_load": Spec("proof load", "N", _LOADS, of_some=True),
    "wet_strength_factor": Spec("strength in water over dry", "", ("value",), of_some=True),
    "EA": Spec("axial stiffness", "N", (*_POWERS, "chain_modulus", "rows", "times"), ("MBL",)),
    "EA_dynamic": Spec("dynamic axial stiffness", "N", ("mean_load",), of_some=True),
    "drag_normal": Spec("drag across the line", "", ("coefficient",)),
    "drag_axial": Spec("drag along the line", "", ("coefficient",)),
    "added_mass_normal": Spec("added mass across the line", "", ("coefficient",)),
    "added_mass_axial": Spec("added mass along the line", "", ("coefficient",)),
    "price": Spec("price per length", "USD/m", (*_POWERS, "rows", "times"), ("mass", "MBL")),
}
"""Every quantity that a figure may be of, in the order of the tables."""


@dataclass(frozen=True)
class Source:
    """A document that figures rest on."""

    key: str
    """Short name, by which figures name it."""
    title: str
    """What it is."""
    place: str
    """Where it is found."""
    origin: str = ""
    """What it was copied from; sources of one origin count once for confidence B."""


@dataclass(frozen=True)
class Figure(Record):
    """One quantity, of `SPECS`, of one or more families, by the nominal diameter."""

    DOCUMENT = (
        "quantity grades variant default text=formula confidence source_keys=sources place range "
        "reason note"
    )

    quantity: str
    """What it is of."""
    variant: str
    """Name among several figures of the same quantity; may be empty when there is one."""
    families: tuple[str, ...]
    grades: tuple[str, ...]
    """Grades that it holds for; all when empty."""
    formula: Formula
    range: tuple[Length, Length]
    """Smallest and largest nominal diameter that it holds for; it is never evaluated outside."""
    sources: tuple[Source, ...]
    """Documents that have it, at `place`."""
    place: str
    """Where in its sources."""
    confidence: Confidence
    """Of the figure itself."""
    default: bool = True
    """Whether it is used when no variant is named."""
    reason: str = ""
    """Why it is the default, where there are several."""
    note: str = ""
    """What else to know."""
    checked: str = ""
    """How a figure of one origin was checked by numbers, which makes it one of confidence B."""
    exceeds: str = ""
    """Why a default of strength may be above another source that was read; empty: it is not."""

    @property
    def origins(self) -> frozenset[str]:
        """What its sources go back to: copies of one document count once."""
        return frozenset(source.origin or source.key for source in self.sources)

    @property
    def source_keys(self) -> tuple[str, ...]:
        """Keys of the sources that have it."""
        return tuple(source.key for source in self.sources)

    @property
    def text(self) -> str:
        """By the nominal diameter d, with unit."""
        return self.formula.text(SPECS[self.quantity].unit)

    def holds_for(self, grade: str | None) -> bool:
        """Whether it is a figure of a grade."""
        return not self.grades or grade in self.grades

    def covers(self, diameter: float) -> bool:
        """Whether a nominal diameter in m lies within its range."""
        return within(diameter, self.range)


def within(diameter: float, span: tuple[float, float]) -> bool:
    """Whether a diameter lies in a range, its ends and rounding included."""
    low, high = span
    return low * (1.0 - _ROUNDING) <= diameter <= high * (1.0 + _ROUNDING)


_ROUNDING = 1e-9
"""Relative: 17.5 mm as 17.5 times 1e-3 is not the double nearest to 0.0175."""


NO_FIGURE = "catalogue.no_figure"
"""Key of why a quantity is not known for which no source was found."""


@dataclass(frozen=True)
class Hydrodynamic(Record):
    """A coefficient of drag or added mass, with the diameter that it is referred to."""

    DOCUMENT = "coefficient diameter name=diameter_name"

    coefficient: NotNegative
    """A pure number."""
    diameter: Length
    """That the coefficient is referred to."""
    name: str
    """Which diameter that is: ``"d"`` for the nominal one, ``"2.65 d"``, ``"d/pi"``, or
    ``"volume"`` for the volume-equivalent one."""


@dataclass(frozen=True)
class Provenance(Record):
    """Where one figure of a component comes from: documents that have it, and where in them."""

    DOCUMENT = "variant formula confidence source_keys=sources place range reason note"

    sources: tuple[Source, ...]
    place: str
    """Where in its sources."""
    confidence: Confidence
    """Of the figure and of all that it rests on: the weakest."""
    formula: str
    """By the nominal diameter d, with unit."""
    range: tuple[Length, Length]
    """Smallest and largest nominal diameter that it holds for."""
    variant: str = ""
    """Name among the alternatives; may be empty when there is none."""
    alternatives: tuple[str, ...] = ()
    """Names of the other variants."""
    reason: str = ""
    """Why this one is the default; empty when it is not or has no alternative."""
    note: str = ""
    """What else to know."""

    @property
    def source_keys(self) -> tuple[str, ...]:
        """Keys of the sources that have it."""
        return tuple(source.key for source in self.sources)

    @property
    def is_recalled(self) -> bool:
        """Whether it was read in no document."""
        return self.confidence == RECALLED


@dataclass(frozen=True)
class OriginOf(Record):
    """Where the figure of a quantity comes from."""

    DOCUMENT = f"quantity {within_part('origin', Provenance.DOCUMENT)}"

    quantity: str
    """What it is of."""
    origin: Provenance


class Unknown(NamedTuple):
    """A quantity that is not known."""

    quantity: str
    """What it is."""
    reason: str
    """Why it is not known."""


class MeanLoadTerms(NamedTuple):
    """Dynamic stiffness of fibre rope: (constant + slope Lm) MBL, Lm = mean tension over MBL."""

    constant: float
    """A pure number."""
    slope: float
    """A pure number; Lm is a fraction."""


@dataclass(frozen=True)
class Alternative(Record):
    """Another figure that a source has for a quantity of a component."""

    DOCUMENT = (
        "quantity value unit reference=reference_diameter_m "
        f"{within_part('provenance', Provenance.DOCUMENT)}"
    )

    quantity: str
    """What it is of."""
    variant: str
    value: float | None
    """SI, at the component's diameter; None where it does not reach."""
    reference: Length | None
    """Of a coefficient: the diameter that it is referred to."""
    provenance: Provenance

    @property
    def unit(self) -> str:
        """SI; empty for a pure number."""
        return SPECS[self.quantity].unit


@dataclass(frozen=True)
class Component(Tabled, Record):
    """Chain, wire or rope of one family, grade and nominal diameter, in SI.

    A quantity that is not known is None, and `missing` says why.
    """

    DOCUMENT = (
        "name family grade nominal_diameter mass submerged_weight water_density volume_diameter "
        "MBL MBL_in_water proof_load EA EA_dynamic_terms=EA_dynamic(constant slope) drag_normal "
        "drag_axial added_mass_normal added_mass_axial price recalled origins=provenance "
        "unknown=missing(quantity reason) alternatives"
    )

    name: str
    """Family, grade and diameter: ``"chain studless R3 76 mm"``."""
    family: str
    """Name of its family."""
    grade: str | None
    """None in a family without grades."""
    nominal_diameter: Length
    """Of the bar of a chain's links, or of the rope as sold."""
    mass: MassPerLength
    """In air, per length."""
    submerged_weight: Weight
    """Per length, in water; negative when it floats. Mass less displaced water, by the
    volume-equivalent diameter, times g0."""
    volume_diameter: Length
    """Volume-equivalent diameter: of a cylinder that displaces as much water."""
    water_density: Density
    """For the submerged weight."""
    MBL: Strength | None
    """Minimum breaking load, new; of fibre rope, dry."""
    proof_load: Strength | None
    """Proof load, new."""
    wet_strength_factor: float | None
    """Share of the MBL that is left in water; None where water takes nothing."""
    EA: Strength | None
    """Axial stiffness; of fibre rope the quasi-static one."""
    EA_dynamic_terms: MeanLoadTerms | None
    """Dynamic stiffness of fibre rope: (constant + slope Lm) MBL, Lm = mean tension over MBL."""
    drag_normal: Hydrodynamic | None
    """Drag across the line."""
    drag_axial: Hydrodynamic | None
    """Drag along the line."""
    added_mass_normal: Hydrodynamic | None
    """Added mass across the line."""
    added_mass_axial: Hydrodynamic | None
    """Added mass along the line."""
    price: Price | None
    """Material only; `provenance` names the year."""
    provenance: Mapping[str, Provenance] = field(repr=False, compare=False)
    """By quantity, of everything that is known."""
    missing: Mapping[str, str] = field(repr=False, compare=False)
    """By quantity, why it is not known; a kind of line that has no such quantity lacks nothing."""
    _evaluation: Evaluation = field(repr=False, compare=False)

    @property
    def origins(self) -> tuple[OriginOf, ...]:
        """Where each figure comes from."""
        return tuple(OriginOf(*each) for each in self.provenance.items())

    @property
    def unknown(self) -> tuple[Unknown, ...]:
        """What is not known, and why."""
        return tuple(Unknown(*each) for each in self.missing.items())

    @property
    def MBL_in_water(self) -> Strength | None:
        """MBL of the new component as it hangs in water: of nylon less than the dry one."""
        if self.MBL is None or self.wet_strength_factor is None:
            return self.MBL
        return self.MBL * self.wet_strength_factor

    @property
    def EA_bounds(self) -> tuple[float, float] | None:
        """Least and greatest EA that any source read has for it, N; None where EA is not known.

        The least is on the safe side for an offset, the greatest for a tension.
        """
        if self.EA is None:
            return None
        read = (a for a in self.alternatives if a.quantity == "EA" and not a.provenance.is_recalled)
        values = [self.EA, *(each.value for each in read if each.value is not None)]
        return min(values), max(values)

    @property
    def drag_diameter(self) -> float | None:
        """Diameter that the normal drag coefficient is referred to, m."""
        return None if self.drag_normal is None else self.drag_normal.diameter

    @property
    def recalled(self) -> tuple[str, ...]:
        """Quantities that rest on a figure read in no document (confidence R)."""
        return tuple(key for key, origin in self.provenance.items() if origin.is_recalled)

    @property
    def alternatives(self) -> tuple[Alternative, ...]:
        """What the variants that were not chosen give, recalled ones included."""
        return self._evaluation.alternatives()

    def segment(self, length: float | str, name: str | None = None) -> Segment:
        """Make a segment of a line of an unstretched length, m; its name is for tables.

        It has the MBL in water, and all that is known of it for motion, both coefficients of drag
        on the diameter of the normal one; it is inextensible where EA is not known.
        """
        return Segment(
            length=length,
            submerged_weight=self.submerged_weight,
            EA=math.inf if self.EA is None else self.EA,
            mass=self.mass,
            MBL=self.MBL_in_water,
            name=self.name if name is None else name,
            component=" ".join(part for part in (self.family, self.grade) if part),
            nominal_diameter=self.nominal_diameter,
            proof_load=self.proof_load,
            price=self.price,
            **self._hydrodynamic(),
        )

    def _hydrodynamic(self) -> dict[str, Any]:
        """Coefficients on the one diameter of the model; added mass on the displaced water."""
        drag, along = self.drag_normal, self.drag_axial
        axial = None
        if drag is not None and along is not None:
            axial = along.coefficient * (along.diameter / drag.diameter)
        on_volume = [
            each and each.coefficient * (each.diameter / self.volume_diameter) ** 2
            for each in (self.added_mass_normal, self.added_mass_axial)
        ]
        return {
            "drag_diameter": self.drag_diameter,
            "drag_normal": drag and drag.coefficient,
            "drag_axial": axial,
            "added_mass_normal": on_volume[0],
            "added_mass_axial": on_volume[1],
        }

    def dynamic_EA(self, mean_tension: float) -> float | None:
        """Stiffness of fibre rope against quick changes of tension."""
        if self.EA_dynamic_terms is None or self.MBL is None:
            return None
        constant, slope = self.EA_dynamic_terms
        return (constant + slope * mean_tension / self.MBL) * self.MBL

    def MBL_at(self, diameter: float) -> float | None:
        """Minimum breaking load, N, at another nominal diameter, m, such as one worn down.

        By the same figures, in whose range the diameter has to lie; None where it is not known.
        """
        return self._at("MBL", diameter)

    def proof_load_at(self, diameter: float) -> float | None:
        """Proof load at another nominal diameter; as `MBL_at`."""
        return self._at("proof_load", diameter)

    def need(self, *quantities: str) -> None:
        """Raise InputError with every one of some quantities that is not known, and why."""
        lacking = [key for key in quantities if key not in self.provenance]
        unknown = Message(NO_FIGURE)
        problems = [Problem(key, "", self.missing.get(key, unknown)) for key in lacking]
        if problems:
            raise InputError(problems, self.name)

    def _at(self, quantity: str, diameter: float) -> float | None:
        if quantity not in self.provenance:
            return None
        return self._evaluation.at(diameter).value(quantity)
