"""A component: a family in one grade and diameter, every figure with its source and trust."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, get_args

from catopt.catalogue.formula import Formula
from catopt.errors import InputError, Problem
from catopt.model import Segment
from catopt.shown import Tabled
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catalogue.evaluation import Evaluation

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
    """A document: its short name, what it is, and where it is found."""

    key: str
    title: str
    place: str
    origin: str = ""
    """What it was copied from; sources of one origin count once for confidence B."""


@dataclass(frozen=True)
class Figure:
    """One quantity, of `SPECS`, of one or more families, by the nominal diameter."""

    quantity: str
    variant: str
    """Name among several figures of the same quantity; may be empty when there is one."""
    families: tuple[str, ...]
    grades: tuple[str, ...]
    """Grades that it holds for; all when empty."""
    formula: Formula
    range: tuple[float, float]
    """Smallest and largest nominal diameter, m. It is never evaluated outside."""
    sources: tuple[Source, ...]
    """Documents that have it, at `place`."""
    place: str
    confidence: Confidence
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
    def text(self) -> str:
        """The formula in words."""
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
class Hydrodynamic:
    """A coefficient of drag or added mass, with the diameter that it is referred to, m."""

    coefficient: float
    diameter: float
    name: str
    """Which diameter that is: ``"d"`` for the nominal one, ``"2.65 d"``, ``"d/pi"``, or
    ``"volume"`` for the volume-equivalent one."""


@dataclass(frozen=True)
class Provenance:
    """Where one figure of a component comes from: documents that have it, and where in them."""

    sources: tuple[Source, ...]
    place: str
    confidence: Confidence
    """Of the figure and of all that it rests on: the weakest."""
    formula: str
    """In words, with unit."""
    range: tuple[float, float]
    """Nominal diameters that it holds for, m."""
    variant: str = ""
    """Name among the alternatives; may be empty when there is none."""
    alternatives: tuple[str, ...] = ()
    """Names of the other variants."""
    reason: str = ""
    """Why this one is the default; empty when it is not or has no alternative."""
    note: str = ""
    """What else to know."""

    @property
    def is_recalled(self) -> bool:
        """Whether it was read in no document."""
        return self.confidence == RECALLED


@dataclass(frozen=True)
class Alternative:
    """Another figure that a source has for a quantity of a component."""

    quantity: str
    variant: str
    value: float | None
    """SI, at the component's diameter; None where it does not reach."""
    reference: float | None
    """Of a coefficient: the diameter that it is referred to, m."""
    provenance: Provenance


@dataclass(frozen=True)
class Component(Tabled):
    """Chain, wire or rope of one family, grade and nominal diameter, in SI.

    Densities in kg/m3. A quantity that is not known is None, and `missing` says why.
    """

    name: str
    """Family, grade and diameter: ``"chain studless R3 76 mm"``."""
    family: str
    grade: str | None
    nominal_diameter: float
    """Of the bar of a chain's links, or of the rope as sold, m."""
    mass: float
    """In air, per length, kg/m."""
    submerged_weight: float
    """Per length, N/m; negative when it floats. Mass less displaced water, by the volume-equivalent
    diameter, times g0."""
    volume_diameter: float
    """Volume-equivalent diameter: of a cylinder that displaces as much water, m."""
    water_density: float
    MBL: float | None
    """Minimum breaking load, new; of fibre rope, dry; N."""
    proof_load: float | None
    """Proof load, new, N."""
    wet_strength_factor: float | None
    """Share of the MBL that is left in water; None where water takes nothing."""
    EA: float | None
    """Axial stiffness; of fibre rope the quasi-static one, N."""
    EA_dynamic_terms: tuple[float, float] | None
    """a and b of the dynamic stiffness (a + b Lm) MBL, Lm = mean tension over MBL."""
    drag_normal: Hydrodynamic | None
    """Across the line, as that of added mass is; axial ones are along it."""
    drag_axial: Hydrodynamic | None
    added_mass_normal: Hydrodynamic | None
    added_mass_axial: Hydrodynamic | None
    price: float | None
    """Material only, USD/m; `provenance` names the year."""
    provenance: Mapping[str, Provenance] = field(repr=False, compare=False)
    """By quantity, of everything that is known."""
    missing: Mapping[str, str] = field(repr=False, compare=False)
    """By quantity, why it is not known; a kind of line that has no such quantity lacks nothing."""
    _evaluation: Evaluation = field(repr=False, compare=False)

    @property
    def MBL_in_water(self) -> float | None:
        """MBL of the new component as it hangs in water: of nylon less than the dry one; N."""
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
        """What the variants that were not chosen give here, recalled ones included."""
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
