"""The mooring line: segments from the anchor to the fairlead, and what hangs on them."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from catopt.errors import InputError, Problem
from catopt.model.drag_method import DRAG_METHODS, DragMethod, drag_misfits
from catopt.model.validity import Findings
from catopt.model.wear import WEAR_ZONES

HIGHEST_COV: Final = 0.25
"""Coefficient of variation from which c (3 - 6 c) falls: more scatter would make more strength."""


TESTS: Final = ("MBL_mean", "MBL_cov")
"""Statistics of break tests."""


def break_test_misfits(given: Collection[str]) -> list[Problem]:
    """List which of the statistics of break tests is missing beside the other."""
    missing = [key for key in TESTS if key not in given]
    if len(missing) != 1:
        return []
    return [Problem(missing[0], "", "missing; MBL_mean and MBL_cov go together")]


@dataclass(frozen=True)
class Segment:
    """A uniform stretch of chain, wire or rope.

    Attributes
    ----------
    length : float
        Unstretched length, m.
    submerged_weight : float
        Weight in water per unstretched length, N/m; negative when it floats.
    EA : float
        Axial stiffness, N; infinite for an inextensible segment.
    mass : float or None
        Mass in air per unstretched length, kg/m; None when not known.
    MBL : float or None
        Minimum breaking load, N; None when not known.
    name : str
        Free text, for tables.
    component : str
        Family and grade in the catalogue; empty when the figures are the user's own.
    nominal_diameter : float or None
        Of the bar of a chain's links, or of the rope as sold, m; None when not known.
    proof_load : float or None
        N; None when not known.
    price : float or None
        Material only, USD/m; None when not known.
    wear_rate : float or None
        Loss of nominal diameter, m/s; None: that of the case's service.
    wear_zone : str or None
        One of `WEAR_ZONES`, for the table of wear that the case's service names.
    drag_diameter : float or None
        That both drag coefficients refer to, m; None when not known.
    drag_normal, drag_axial : float or None
        Drag coefficients across and along the line; None when not known.
    added_mass_normal, added_mass_axial : float or None
        Added-mass coefficients across and along the line, on the displaced water; None when not
        known.
    drag_method : {"given", "roughness"}
        Whether the coefficients are given, or follow from the three that come next: recalled
        formulas of S4, docs/dynamics.md, for wires and ropes.
    roughness : float or None
        Height of what is rough on the surface, m.
    keulegan_carpenter : float or None
        KC = v T/D of the flow to and fro, v being the amplitude of its velocity, D the drag
        diameter.
    wake_amplification : float or None
        Factor psi on the drag of a steady flow; None: by the KC, below 12.
    MBL_mean, MBL_cov : float or None
        Mean (N) and coefficient of variation of the breaking loads of a series of tests; None when
        not known.
    """

    length: float
    submerged_weight: float
    EA: float = math.inf
    mass: float | None = None
    MBL: float | None = None
    name: str = ""
    component: str = ""
    nominal_diameter: float | None = None
    proof_load: float | None = None
    price: float | None = None
    wear_rate: float | None = None
    wear_zone: str | None = None
    drag_diameter: float | None = None
    drag_normal: float | None = None
    drag_axial: float | None = None
    added_mass_normal: float | None = None
    added_mass_axial: float | None = None
    drag_method: DragMethod = "given"
    roughness: float | None = None
    keulegan_carpenter: float | None = None
    wake_amplification: float | None = None
    MBL_mean: float | None = None
    MBL_cov: float | None = None

    def __post_init__(self) -> None:
        found = Findings("Segment", self)
        found.number("length", self.length, "m", above=0.0)
        found.number("submerged_weight", self.submerged_weight, "N/m")
        found.number("EA", self.EA, "N", above=0.0, infinite=True)
        found.numbers(self, "kg/m", "mass", at_least=0.0)
        found.numbers(self, "N", "MBL", "MBL_mean", above=0.0)
        found.numbers(self, "", "MBL_cov", at_least=0.0, at_most=HIGHEST_COV)
        found.problems += break_test_misfits({k for k in TESTS if getattr(self, k) is not None})
        found.numbers(self, "m", "nominal_diameter", above=0.0)
        found.numbers(self, "N", "proof_load", above=0.0)
        found.numbers(self, "USD/m", "price", at_least=0.0)
        found.numbers(self, "m/s", "wear_rate", at_least=0.0)
        if self.wear_zone is not None and self.wear_zone not in WEAR_ZONES:
            found.add("wear_zone", f'"{self.wear_zone}"', "one of " + ", ".join(WEAR_ZONES))
        self._check_drag(found)
        found.raise_if_any()

    @property
    def tested_strength(self) -> float | None:
        """Characteristic strength by tests, mu (1 - c (3 - 6 c)) (DNV-OS-E301, 2008, C), N.

        None without tests.
        """
        if self.MBL_mean is None or self.MBL_cov is None:
            return None
        return self.MBL_mean * (1.0 - self.MBL_cov * (3.0 - 6.0 * self.MBL_cov))

    def _check_drag(self, found: Findings) -> None:
        found.numbers(self, "m", "drag_diameter", above=0.0)
        found.numbers(self, "", "drag_normal", "drag_axial", at_least=0.0)
        found.numbers(self, "", "added_mass_normal", "added_mass_axial", at_least=0.0)
        found.word("drag_method", self.drag_method, DRAG_METHODS)
        found.numbers(self, "m", "roughness", at_least=0.0)
        found.numbers(self, "", "keulegan_carpenter", at_least=0.0)
        found.numbers(self, "", "wake_amplification", above=0.0)
        if not found.problems:
            given = {key: value for key, value in vars(self).items() if value not in (None, "")}
            found.problems += drag_misfits(given)


_DRAG = ("drag_area", "drag_coefficient")


@dataclass(frozen=True)
class PointLoad:
    """A clump weight (sinker) or a buoy fixed to the line.

    Attributes
    ----------
    position : float
        Unstretched arc length from the anchor, m; strictly between the ends of the line.
    submerged_weight : float
        Weight in water, N; negative for a buoy.
    mass : float or None
        Mass in air, kg; None when not known.
    name : str
        Free text, for tables.
    friction : float or None
        Coulomb coefficient of the body on the bed where it rests there; None: that of the bed.
    drag_area, drag_coefficient : float or None
        Area A, m2, and the coefficient Cd that goes with it, in all directions: for a line in
        motion; the two are given together. None: no drag.
    added_mass_coefficient : float
        Ca on the displaced water, in all directions.
    """

    position: float
    submerged_weight: float
    mass: float | None = None
    name: str = ""
    friction: float | None = None
    drag_area: float | None = None
    drag_coefficient: float | None = None
    added_mass_coefficient: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("PointLoad", self)
        found.number("position", self.position, "m", above=0.0)
        found.number("submerged_weight", self.submerged_weight, "N")
        found.numbers(self, "kg", "mass", at_least=0.0)
        found.numbers(self, "", "friction", at_least=0.0)
        found.number("drag_area", self.drag_area or 0.0, "m2", at_least=0.0)
        found.number("drag_coefficient", self.drag_coefficient or 0.0, "", at_least=0.0)
        found.number("added_mass_coefficient", self.added_mass_coefficient, "", at_least=0.0)
        for given, other in (_DRAG, _DRAG[::-1]):
            if getattr(self, given) is not None and getattr(self, other) is None:
                found.add(other, "", f"missing; goes with {given}")
        found.raise_if_any()

    @property
    def drag_product(self) -> float:
        """Cd A, m2."""
        return (self.drag_coefficient or 0.0) * (self.drag_area or 0.0)


END_ROUNDING = 1e-14
"""Of a line's length, which is a sum of lengths: nearer to its ends no place is told from them."""


@dataclass(frozen=True)
class Line:
    """A mooring line.

    Attributes
    ----------
    segments : tuple of Segment
        From the anchor to the fairlead; at least one. Any iterable is taken.
    point_loads : tuple of PointLoad
        In any order; they are kept sorted by position.
    """

    segments: tuple[Segment, ...]
    point_loads: tuple[PointLoad, ...] = ()

    def __init__(self, segments: Iterable[Segment], point_loads: Iterable[PointLoad] = ()) -> None:
        loads = tuple(sorted(point_loads, key=lambda load: load.position))
        object.__setattr__(self, "segments", tuple(segments))
        object.__setattr__(self, "point_loads", loads)
        self._check()

    def _check(self) -> None:
        found = Findings("Line")
        if not self.segments:
            found.add("segments", "none", "a line has at least one segment")
        for index, load in enumerate(self.point_loads):
            nearest = min(load.position, self.length - load.position)
            if self.segments and not nearest > END_ROUNDING * self.length:
                found.add(
                    f"point_loads[{index}].position",
                    f"{load.position:g} m",
                    f"must lie between the ends of the line, which is {self.length:g} m long, and "
                    "farther from them than its rounding",
                )
        for lower, upper in pairwise(self.point_loads):
            if lower.position == upper.position and lower.friction != upper.friction:
                found.add(
                    "point_loads.friction",
                    f"{lower.friction} and {upper.friction} at {lower.position:g} m",
                    "point loads in one place lie on the bed with one friction: give both the same",
                )
        if found.problems:
            raise InputError(found.problems, "Line")

    @property
    def length(self) -> float:
        """Unstretched length, m."""
        return math.fsum(segment.length for segment in self.segments)

    @property
    def submerged_weight(self) -> float:
        """Weight in water of the whole line with its point loads, N."""
        return math.fsum(
            [
                *(segment.length * segment.submerged_weight for segment in self.segments),
                *(load.submerged_weight for load in self.point_loads),
            ]
        )

    @property
    def mass(self) -> float | None:
        """Mass in air of all segments and point loads, kg; None when one of them is not known."""
        masses = [
            *(None if s.mass is None else s.length * s.mass for s in self.segments),
            *(load.mass for load in self.point_loads),
        ]
        known = [mass for mass in masses if mass is not None]
        return math.fsum(known) if len(known) == len(masses) else None
