"""A ship, as far as wind and current mind it."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType

from catopt.model.kinds import Findings
from catopt.words import Message

PROPELLER_AREA_RATIOS = MappingProxyType(
    {
        "destroyer": 100.0,
        "cruiser": 160.0,
        "carrier": 125.0,
        "cargo": 240.0,
        "tanker": 270.0,
        "submarine": 125.0,
    }
)
"""LwL B over the propellers' projected area (UFC 4-159-03 of 2005, page 92, A)."""


@dataclass(frozen=True)
class Ship:
    """A ship afloat; lengths in m, areas in m2."""

    name: str
    length_overall: float
    length_waterline: float
    breadth: float
    draught: float
    displacement: float
    """Volume displaced, m3."""
    midship_area: float
    """Of the section amidships under water."""
    lateral_area: float
    frontal_area: float
    """Both above water, as the wind sees them from the side and from ahead."""
    propeller: str | None = None
    """Kind for the propeller's area, a key of `PROPELLER_AREA_RATIOS`; None: no propeller, or one
    that is not locked."""
    lateral_centre: float = 0.0
    """Of the lateral area above water, m forward of midships."""

    def __post_init__(self) -> None:
        found = self._findings()
        for key in ("length_overall", "length_waterline"):
            found.number(key, getattr(self, key), "m", above=0.0, at_most=600.0)
        for key in ("breadth", "draught"):
            found.number(key, getattr(self, key), "m", above=0.0, at_most=100.0)
        found.number("displacement", self.displacement, "m3", above=0.0)
        for key in ("midship_area", "lateral_area", "frontal_area"):
            found.number(key, getattr(self, key), "m2", above=0.0)
        half = 0.5 * self.length_overall
        found.number("lateral_centre", self.lateral_centre, "m", at_least=-half, at_most=half)
        if self.propeller is not None:
            found.word("propeller", self.propeller, tuple(PROPELLER_AREA_RATIOS))
        if not found.problems:
            self._check_form(found)
        found.raise_if_any()

    def _check_form(self, found: Findings) -> None:
        """Note what no hull can be."""
        box = self.length_waterline * self.breadth * self.draught
        section = self.breadth * self.draught
        limits = (
            ("length_waterline", "m", self.length_overall, "refused_sizing.longer_than_ship"),
            ("displacement", "m3", box, "refused_sizing.beyond_the_box"),
            ("midship_area", "m2", section, "refused_sizing.above_section"),
            ("draught", "m", self.breadth, "refused_sizing.above_breadth"),
        )
        for key, unit, most, words in limits:
            value = getattr(self, key)
            if value > most:
                found.add(key, f"{value:g} {unit}", Message(words, limit=most))

    def check_afloat(self, depth: float) -> None:
        """Raise InputError unless there is water, of a depth in m, under the keel."""
        found = self._findings()
        found.number("depth", depth, "m", above=0.0)
        if not found.problems and self.draught >= depth:
            aground = Message("refused_sizing.water_m_deep_ship_would", depth=depth)
            found.add("draught", f"{self.draught:g} m", aground)
        found.raise_if_any()

    def _findings(self) -> Findings:
        return Findings(f"ship {self.name}".rstrip())
