"""How far a chain may wear until a check first fails."""

from __future__ import annotations

from dataclasses import replace

from catopt.checks.case import check_case
from catopt.errors import NoAnswerError
from catopt.model import Case, Service
from catopt.sizing.settle import Settled, point_diameter

_STEPS = 24
"""Halvings of the diameter: to a ten millionth of it."""


def least_diameter(settled: Settled) -> float | None:
    """Find the diameter that the chain may wear to before a check of its worn line fails, m.

    None where nothing wears, or where no check of the worn line fails however thin it gets.
    """
    case = settled.case
    if case.service is None:
        return None
    worn = replace(
        case,
        design=None,
        load_cases=tuple(each for each in case.load_cases if each.condition == "worn"),
    )
    new = point_diameter(settled.point)
    low, high = 0.0, new  # high passes: it is the new line's, or nearly
    for _ in range(_STEPS):
        middle = 0.5 * (low + high)
        if _passes(worn, new - middle):
            high = middle
        else:
            low = middle
    return high if low > 0.0 else None


def _passes(case: Case, loss: float) -> bool:
    """Whether the line with so much less diameter, m, keeps every check."""
    try:
        return check_case(replace(case, service=Service(life=1.0, wear_rate=loss))).passes
    except NoAnswerError:
        return False
