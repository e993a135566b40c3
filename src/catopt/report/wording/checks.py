"""Checks in words and in the field's units: the one list behind their tables.

Light on purpose: the terminal shows it without pandas.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport, CheckResult, CheckSource
    from catopt.report.texts import Words

__all__ = [
    "QUANTITY_OF",
    "governing_sentence",
    "load_case_words",
    "source_words",
    "verdict_sentence",
]

QUANTITY_OF: Mapping[str, Quantity] = MappingProxyType(
    {
        "tension": QUANTITIES["tension"],
        "uplift_angle": QUANTITIES["angle"],
        "uplift_force": QUANTITIES["vertical_force"],
        "grounded_length": QUANTITIES["grounded_length"],
        "offset": QUANTITIES["span"],
        "buoyancy": QUANTITIES["vertical_force"],
        "sliding": QUANTITIES["point_weight"],
        "holding": QUANTITIES["horizontal_force"],
    }
)
"""What demand and capacity of each kind of check are."""


def verdict_sentence(report: CheckReport) -> str:
    """Say whether all checks are passed: ``"2 of 9 checks fail."``."""
    count, failed = len(report.results), len(report.failed)
    if not count:
        return "Nothing was checked."
    if failed:
        return f"{failed} of {count} checks {'fails' if failed == 1 else 'fail'}."
    return "The one check passes." if count == 1 else f"All {count} checks pass."


def governing_sentence(report: CheckReport) -> str:
    """Say which check governs, and how far it is used; empty when nothing was checked."""
    found = report.governing
    if found is None:
        return ""
    used = found.utilisation
    how = f"utilisation {used:.3f}" if used is not None else _beside(found)
    return f"Governing: {found.name} in load case {found.load_case}, {how} ({found.source.text})."


def _beside(result: CheckResult) -> str:
    quantity = QUANTITY_OF[result.kind]
    demand, capacity = (
        quantity.format(value, unit=True) for value in (result.demand, result.capacity)
    )
    return f"{demand} beside {capacity}"


def load_case_words(report: CheckReport, index: int) -> str:
    """Name a load case with its force: ``"storm (extreme), horizontal force 450.000 kN"``."""
    name, solution = report.solutions[index]
    kind = f" ({report.load_cases[index].kind})" if report.load_cases else ""
    force = QUANTITIES["horizontal_force"].format(solution.horizontal_force, unit=True)
    height = f"{solution.fairlead_height:g} m"
    return f"Load case {name}{kind}: horizontal force {force}, fairlead height {height}"


def source_words(source: CheckSource, words: Words) -> str:
    """Say where a criterion comes from; a document is cited as it is called."""
    return words.name(source.text) if source.confidence is None else source.text
