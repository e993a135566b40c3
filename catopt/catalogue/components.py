"""A component: a family in one grade and one nominal diameter, every figure with its source."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from catopt.catalogue.figure import RECALLED, Confidence, Source
from catopt.errors import InputError, Problem
from catopt.model import Segment
from catopt.words import Message

NO_FIGURE = "catalogue.no_figure"
"""Key of why a quantity is not known for which no source was found."""


@dataclass(frozen=True)
class Hydrodynamic:
    """A coefficient of drag or added mass.

    Attributes
    ----------
    coefficient : float
        A pure number.
    diameter : float
        The diameter that it is referred to, m.
    name : str
        Which diameter that is: ``"d"`` for the nominal one, ``"2.65 d"``, ``"d/pi"``, or
        ``"volume"`` for the volume-equivalent one.
    """

    coefficient: float
    diameter: float
    name: str


@dataclass(frozen=True)
class Provenance:
    """Where one figure of a component comes from.

    Attributes
    ----------
    sources : tuple of Source
        Documents that have it.
    place : str
        Where in them.
    confidence : {"A", "B", "C", "R"}
        Of the figure and of all that it rests on: the weakest.
    formula : str
        In words, with unit.
    variant : str
        Name among the alternatives; may be empty when there is none.
    alternatives : tuple of str
        Names of the other variants.
    reason : str
        Why this one is the default; empty when it is not or has no alternative.
    range : tuple of float
        Nominal diameters that it holds for, m.
    note : str
        What else to know.
    """

    sources: tuple[Source, ...]
    place: str
    confidence: Confidence
    formula: str
    variant: str
    alternatives: tuple[str, ...]
    reason: str
    range: tuple[float, float]
    note: str

    @property
    def is_recalled(self) -> bool:
        """Whether it was read in no document."""
        return self.confidence == RECALLED


@dataclass(frozen=True)
class Alternative:
    """Another figure that a source has for a quantity of a component.

    Attributes
    ----------
    quantity, variant : str
        What it is of, and its name.
    value : float or None
        SI, at the component's diameter; None where it does not reach.
    reference : float or None
        Of a coefficient: the diameter that it is referred to, m.
    provenance : Provenance
        Where it comes from.
    """

    quantity: str
    variant: str
    value: float | None
    reference: float | None
    provenance: Provenance


class _Figures(Protocol):
    """The figures of a family that were chosen, at a nominal diameter (`Evaluation`)."""

    def at(self, diameter: float) -> _Figures: ...
    def value(self, quantity: str) -> float: ...
    def alternatives(self) -> tuple[Alternative, ...]: ...


@dataclass(frozen=True)
class Component:
    """Chain, wire or rope of one family, grade and nominal diameter, in SI.

    A quantity that is not known is None, and `missing` says why.

    Attributes
    ----------
    name : str
        Family, grade and diameter: ``"chain studless R3 76 mm"``.
    family, grade : str, str or None
        As the catalogue names them.
    nominal_diameter : float
        Of the bar of a chain's links, or of the rope as sold, m.
    mass : float
        In air, per length, kg/m.
    submerged_weight : float
        Per length, N/m; negative when it floats. Mass less displaced water, by the
        volume-equivalent diameter, times g0.
    volume_diameter : float
        Volume-equivalent diameter: of a cylinder that displaces as much water, m.
    water_density : float
        kg/m3.
    MBL : float or None
        Minimum breaking load, new; of fibre rope, dry; N.
    proof_load : float or None
        Proof load, new, N.
    wet_strength_factor : float or None
        Share of the MBL that is left in water; None where water takes nothing.
    EA : float or None
        Axial stiffness; of fibre rope the quasi-static one, N.
    EA_dynamic_terms : tuple of float or None
        a and b of the dynamic stiffness (a + b Lm) MBL, Lm = mean tension over MBL.
    drag_normal, drag_axial : Hydrodynamic or None
        Drag coefficients across and along the line, with their diameters.
    added_mass_normal, added_mass_axial : Hydrodynamic or None
        Added-mass coefficients across and along the line, with their diameters.
    price : float or None
        Material only, USD/m; `provenance` names the year.
    provenance : mapping of str to Provenance
        By quantity, of everything that is known.
    missing : mapping of str to str
        By quantity, why it is not known; a kind of line that has no such quantity lacks nothing.
    """

    name: str
    family: str
    grade: str | None
    nominal_diameter: float
    mass: float
    submerged_weight: float
    volume_diameter: float
    water_density: float
    MBL: float | None
    proof_load: float | None
    wet_strength_factor: float | None
    EA: float | None
    EA_dynamic_terms: tuple[float, float] | None
    drag_normal: Hydrodynamic | None
    drag_axial: Hydrodynamic | None
    added_mass_normal: Hydrodynamic | None
    added_mass_axial: Hydrodynamic | None
    price: float | None
    provenance: Mapping[str, Provenance] = field(repr=False, compare=False)
    missing: Mapping[str, str] = field(repr=False, compare=False)
    _evaluation: _Figures = field(repr=False, compare=False)

    @property
    def MBL_in_water(self) -> float | None:
        """MBL of the new component as it hangs in water: of nylon less than the dry one; N."""
        if self.MBL is None or self.wet_strength_factor is None:
            return self.MBL
        return self.MBL * self.wet_strength_factor

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

    def segment(self, length: float, name: str | None = None) -> Segment:
        """Make a segment of a line.

        Parameters
        ----------
        length : float
            Unstretched, m.
        name : str, optional
            For tables; the component's own when left out.

        Returns
        -------
        Segment
            With the MBL in water, and all that is known of it for motion, both coefficients of
            drag on the diameter of the normal one; inextensible where EA is not known.
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
        added = {
            key: None
            if each is None
            else each.coefficient * (each.diameter / self.volume_diameter) ** 2
            for key, each in (
                ("added_mass_normal", self.added_mass_normal),
                ("added_mass_axial", self.added_mass_axial),
            )
        }
        return {
            "drag_diameter": self.drag_diameter,
            "drag_normal": None if drag is None else drag.coefficient,
            "drag_axial": axial,
            **added,
        }

    def dynamic_EA(self, mean_tension: float) -> float | None:
        """Stiffness of fibre rope against quick changes of tension."""
        if self.EA_dynamic_terms is None or self.MBL is None:
            return None
        constant, slope = self.EA_dynamic_terms
        return (constant + slope * mean_tension / self.MBL) * self.MBL

    def MBL_at(self, diameter: float) -> float | None:
        """Minimum breaking load at another nominal diameter, such as one worn down.

        Parameters
        ----------
        diameter : float
            m.

        Returns
        -------
        float or None
            N, by the same figures; None where the MBL is not known.

        Raises
        ------
        InputError
            The diameter lies outside the range of the figure.
        """
        return self._at("MBL", diameter)

    def proof_load_at(self, diameter: float) -> float | None:
        """Proof load at another nominal diameter; as `MBL_at`."""
        return self._at("proof_load", diameter)

    def need(self, *quantities: str) -> None:
        """Make sure that some quantities are known.

        Raises
        ------
        InputError
            With every one that is not, and why.
        """
        lacking = [key for key in quantities if key not in self.provenance]
        unknown = Message(NO_FIGURE)
        problems = [Problem(key, "", self.missing.get(key, unknown)) for key in lacking]
        if problems:
            raise InputError(problems, self.name)

    def _at(self, quantity: str, diameter: float) -> float | None:
        if quantity not in self.provenance:
            return None
        return self._evaluation.at(diameter).value(quantity)
