"""A ship, as far as wind and current mind it."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType

from catopt.model.validity import Findings

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
    """A ship afloat.

    Attributes
    ----------
    name : str
        For titles.
    length_overall, length_waterline, breadth, draught : float
        m.
    displacement : float
        Volume displaced, m3.
    midship_area : float
        Of the section amidships under water, m2.
    lateral_area, frontal_area : float
        Above water as the wind sees them from the side and from ahead, m2.
    propeller : str or None
        Kind for the propeller's area, a key of `PROPELLER_AREA_RATIOS`; None: no propeller, or one
        that is not locked.
    lateral_centre : float
        Of the lateral area above water, m forward of midships.
    """

    name: str
    length_overall: float
    length_waterline: float
    breadth: float
    draught: float
    displacement: float
    midship_area: float
    lateral_area: float
    frontal_area: float
    propeller: str | None = None
    lateral_centre: float = 0.0

    def __post_init__(self) -> None:
        found = Findings(f"ship {self.name}".rstrip())
        for key in ("length_overall", "length_waterline"):
            found.number(key, getattr(self, key), "m", above=0.0, at_most=600.0)
        for key in ("breadth", "draught"):
            found.number(key, getattr(self, key), "m", above=0.0, at_most=100.0)
        found.number("displacement", self.displacement, "m3", above=0.0)
        for key in ("midship_area", "lateral_area", "frontal_area"):
            found.number(key, getattr(self, key), "m2", above=0.0)
        half = 0.5 * self.length_overall
        found.number("lateral_centre", self.lateral_centre, "m", at_least=-half, at_most=half)
        if self.propeller is not None and self.propeller not in PROPELLER_AREA_RATIOS:
            found.add(
                "propeller", repr(self.propeller), "one of " + ", ".join(PROPELLER_AREA_RATIOS)
            )
        if not found.problems:
            self._check_form(found)
        found.raise_if_any()

    def _check_form(self, found: Findings) -> None:
        """Note what no hull can be."""
        if self.length_waterline > self.length_overall:
            found.add(
                "length_waterline",
                f"{self.length_waterline:g} m",
                f"longer than the ship, {self.length_overall:g} m",
            )
        box = self.length_waterline * self.breadth * self.draught
        if self.displacement > box:
            found.add(
                "displacement",
                f"{self.displacement:g} m3",
                f"above length x breadth x draught, {box:.0f} m3: it is a volume",
            )
        section = self.breadth * self.draught
        if self.midship_area > section:
            found.add(
                "midship_area", f"{self.midship_area:g} m2", f"above breadth x draught, {section:g}"
            )
        if self.draught > self.breadth:
            found.add("draught", f"{self.draught:g} m", f"above the breadth, {self.breadth:g} m")

    def check_afloat(self, depth: float) -> None:
        """Make sure that there is water under the keel.

        Parameters
        ----------
        depth : float
            Of the water, m.

        Raises
        ------
        InputError
            When there is none.
        """
        found = Findings(f"ship {self.name}".rstrip())
        found.number("depth", depth, "m", above=0.0)
        if not found.problems and self.draught >= depth:
            found.add(
                "draught",
                f"{self.draught:g} m",
                f"the water is {depth:g} m deep: the ship would be aground",
            )
        found.raise_if_any()
