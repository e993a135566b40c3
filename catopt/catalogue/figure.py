"""A figure of the catalogue with its source, and how far it is to be trusted."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, get_args

from catopt.catalogue.formula import Formula

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
