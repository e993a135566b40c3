"""One quantity by the closed form and by the truss model on every mesh.

With an error c n^-p, three meshes of n, 2n and 4n bars give

    p = log2 |(q1 - q2)/(q2 - q3)|          observed order
    q = q3 + (q3 - q2)/(2^p - 1)            Richardson's estimate

The estimate is only worth something where the error falls as smoothly as theory says, p = 2.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from catopt.largest import largest
from catopt.model.kinds import NotNegative, Positive
from catopt.records import From, Record

Unit = Literal["N", "m", "rad", "Nm"]

ORDER = 2.0
"""Of bars with half of their load at each end."""

SMOOTH = 0.25
"""How far the observed order may be from that of theory for the meshes to be extrapolated."""

ROUNDING = 1e-10
"""Tolerance of the truss model: what is below it, over the scale, is rounding."""

NOISE = 10.0 * ROUNDING
"""Change from mesh to mesh that is rounding, over the scale."""


@dataclass(frozen=True)
class Compared(Record):
    """One quantity by both models."""

    DOCUMENT = (
        "quantity line+1 named_point=point? unit closed_form fem order is_smooth extrapolated "
        "difference_before difference scale allowed agrees"
    )

    quantity: str
    """Such as fairlead_tension; shape is the largest distance of a node from the closed form's
    point of the same arc length. Keys of documents are this and the unit."""
    unit: Unit
    """Of the numbers below."""
    closed_form: float
    """In unit."""
    fem: Annotated[tuple[float, ...], From(2)]
    """In unit: on each mesh, from the coarsest."""
    scale: Positive
    """In unit: what the difference is measured by: the fairlead tension, the line's length."""
    tolerance: Positive
    """Allowed difference over the scale."""
    line: int | None = None
    """Of several lines: which one; None for a body or a joint, or where there is one line."""
    limit: float | None = None
    """Extrapolated in another way than from the values themselves (the shape: node by node)."""
    theory: float = ORDER
    """Order by which the error should fall."""
    point: str = ""
    """Name of the joint or body, of points joined by lines."""

    @property
    def named_point(self) -> str | None:
        """Name of the joint or body, of points joined by lines."""
        return self.point or None

    @property
    def key(self) -> str:
        """Name with the unit, as documents have it: ``"span_m"``."""
        return f"{self.quantity}_{self.unit}"

    @property
    def order(self) -> float | None:
        """Observed, from the last three meshes; None where their change is rounding."""
        return observed_order(self.fem, NOISE * self.scale)

    @property
    def is_smooth(self) -> bool:
        """Whether the order is that of theory, so that the meshes are extrapolated."""
        order = self.order
        return order is None or abs(order - self.theory) <= SMOOTH

    @property
    def extrapolated(self) -> float:
        """In unit: Richardson's estimate, or the finest mesh's value where not smooth."""
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
    def difference_before(self) -> float:
        """In unit: finest mesh minus closed form."""
        return self.fem[-1] - self.closed_form

    @property
    def difference(self) -> float:
        """In unit: extrapolated minus closed form."""
        return self.extrapolated - self.closed_form

    @property
    def allowed(self) -> Positive:
        """In unit: tolerance times scale."""
        return self.tolerance * self.scale

    @property
    def gap(self) -> NotNegative:
        """Size of the difference over the scale."""
        return abs(self.difference) / self.scale

    @property
    def gap_before(self) -> float:
        """Size of the difference of the finest mesh over the scale."""
        return abs(self.difference_before) / self.scale

    @property
    def is_resolved(self) -> bool:
        """Whether a difference is more than what the truss model itself may still be off by.

        Of an error that falls smoothly that is what was extrapolated; otherwise three times the
        last change, which is what follows it at order 0.4.
        """
        own = self.left if self.is_smooth else 3.0 * self.left
        return abs(self.difference) > own

    @property
    def severity(self) -> float:
        """The gap over its tolerance."""
        return self.gap / self.tolerance

    @property
    def agrees(self) -> bool:
        """Whether the difference is within what is allowed."""
        return self.gap <= self.tolerance


def worst_of(quantities: Iterable[Compared]) -> Compared:
    """Return the quantity with the largest gap over its tolerance; of those alike the first."""
    listed = list(quantities)
    resolved = ROUNDING / min(each.tolerance for each in listed)
    return largest(listed, lambda each: each.severity, resolved)


def observed_order(values: Sequence[float], noise: float) -> float | None:
    """Order by which the last three values close up.

    None where there are fewer than three values or the last change is rounding; infinite never: a
    change that comes after none counts as order minus infinity, not smooth.
    """
    if len(values) < 3:
        return None
    first, second = values[-3] - values[-2], values[-2] - values[-1]
    if abs(second) <= noise:
        return None
    return math.log2(max(abs(first), noise) / abs(second))


def extrapolated(values: Sequence[float], order: float = ORDER) -> float:
    """Richardson's estimate from the last two values, by the order by which the error falls."""
    gain = math.pow(2.0, order) - 1.0
    return values[-1] + (values[-1] - values[-2]) / gain
