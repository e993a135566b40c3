"""One quantity by the closed form and by the truss model on every mesh."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from catopt.verify.richardson import ORDER, extrapolated, observed_order

__all__ = ["NOISE", "SMOOTH", "Compared", "Unit"]

Unit = Literal["N", "m", "rad", "Nm"]

SMOOTH = 0.25
"""How far the observed order may be from that of theory for the meshes to be extrapolated."""

NOISE = 1e-9
"""Change from mesh to mesh that is rounding, over the scale: ten times the truss's tolerance."""


@dataclass(frozen=True)
class Compared:
    """One quantity by both models.

    Attributes
    ----------
    quantity : str
        What it is, such as ``"fairlead_tension"``; keys of documents are this and the unit.
    unit : str
        ``"N"``, ``"m"``, ``"rad"`` or ``"Nm"``.
    closed_form : float or None
        None where the closed form refuses.
    fem : tuple of float
        By the truss model on each mesh, from the coarsest.
    scale : float
        What a difference is measured by: the fairlead tension, the line's length.
    tolerance : float
        Allowed difference over the scale.
    line : int or None
        Of a system: which of its lines, from 0; None for the body, or where there is one line.
    limit : float or None
        Extrapolated in another way than from the values themselves (the shape: node by node).
    theory : float
        Order by which the error should fall.
    """

    quantity: str
    unit: Unit
    closed_form: float | None
    fem: tuple[float, ...]
    scale: float
    tolerance: float
    line: int | None = None
    limit: float | None = None
    theory: float = ORDER

    @property
    def key(self) -> str:
        """Name with the unit, as documents have it: ``"span_m"``."""
        return f"{self.quantity}_{self.unit}"

    @property
    def order(self) -> float | None:
        """Observed order of the last three meshes; None where their change is rounding."""
        return observed_order(self.fem, NOISE * self.scale)

    @property
    def is_smooth(self) -> bool:
        """Whether the error falls as theory says, so that meshes may be extrapolated."""
        order = self.order
        return order is None or abs(order - self.theory) <= SMOOTH

    @property
    def extrapolated(self) -> float:
        """The truss model's answer: Richardson's estimate; the finest mesh where not smooth."""
        if not self.is_smooth or self.order is None:
            return self.fem[-1]
        return extrapolated(self.fem, self.theory) if self.limit is None else self.limit

    @property
    def left(self) -> float:
        """What finer meshes would still change about the finest one, estimated."""
        if self.is_smooth and self.order is not None:
            return abs(self.extrapolated - self.fem[-1])
        return abs(self.fem[-1] - self.fem[-2]) if len(self.fem) > 1 else 0.0

    @property
    def difference_before(self) -> float | None:
        """Finest mesh minus closed form."""
        return None if self.closed_form is None else self.fem[-1] - self.closed_form

    @property
    def difference(self) -> float | None:
        """Truss model's answer minus closed form."""
        return None if self.closed_form is None else self.extrapolated - self.closed_form

    @property
    def allowed(self) -> float:
        """Largest difference that counts as agreement."""
        return self.tolerance * self.scale

    @property
    def gap(self) -> float:
        """Size of the difference over the scale; without closed form what meshes still change."""
        difference = self.difference
        return (self.left if difference is None else abs(difference)) / self.scale

    @property
    def agrees(self) -> bool:
        """Whether the gap is within the tolerance."""
        return self.gap <= self.tolerance
