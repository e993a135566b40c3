"""A load curve as named columns: the one list behind its tables on the terminal and in files.

Light on purpose: the terminal shows it without pandas.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.tables.summary import named

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve

__all__ = ["FAIRLEAD_TENSION", "FORCE", "OFFSET", "SPAN", "Column", "at_marks", "at_points"]

Column = tuple[Quantity, Sequence[float]]
"""A quantity and its values in SI; nan where there is none."""

SPAN, OFFSET = QUANTITIES["span"], QUANTITIES["offset"]
FORCE, FAIRLEAD_TENSION = QUANTITIES["horizontal_force"], named("tension", "Fairlead tension")


def at_points(result: CaseCurve) -> tuple[Column, ...]:
    """List what is known of every point, by rising span."""
    curve = result.curve
    return (
        (SPAN, curve.span.tolist()),
        (OFFSET, result.offset.tolist()),
        (FORCE, curve.horizontal_force.tolist()),
        (FAIRLEAD_TENSION, curve.fairlead_tension.tolist()),
        (named("tension", "Anchor tension", "TA"), curve.anchor_tension.tolist()),
        (named("angle", "Inclination at the anchor", "theta0"), curve.anchor_angle.tolist()),
        (QUANTITIES["grounded_length"], curve.grounded_length.tolist()),
        (QUANTITIES["stiffness"], curve.stiffness.tolist()),
    )


def at_marks(result: CaseCurve) -> tuple[Column, ...]:
    """List where the marks are."""
    marks, zero = result.curve.marks, result.reference.span
    return (
        (SPAN, [mark.span for mark in marks]),
        (OFFSET, [mark.span - zero for mark in marks]),
        (FORCE, [mark.horizontal_force for mark in marks]),
        (FAIRLEAD_TENSION, [mark.fairlead_tension for mark in marks]),
    )
