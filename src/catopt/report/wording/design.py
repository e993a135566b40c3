"""A design in words and numbers: the one list behind its tables on paper and on a terminal.

Light on purpose: the terminal shows it without pandas.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING

from catopt.checks.excess import ROUNDING
from catopt.quantities import QUANTITIES, Quantity
from catopt.report.tables.summary import named
from catopt.ties import largest

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport, CheckResult
    from catopt.design.result import DesignPoint, DesignResult, Neighbour
    from catopt.model import Line
    from catopt.report.texts import Words

__all__ = [
    "CHECK_KINDS",
    "OBJECTIVES",
    "anchor_words",
    "change_words",
    "check_kinds",
    "clump_weight_words",
    "governing_words",
    "objective_quantities",
    "said_change",
    "said_governing",
    "segment_words",
    "tightest",
    "verdict",
]

OBJECTIVES: dict[str, Quantity] = {
    "mass_kg": named("mass", "Mass in air", ""),
    "offset_m": named("offset", "Largest span", "S"),
    "excursion_m": QUANTITIES["excursion"],
    "cost_USD": QUANTITIES["cost"],
}
"""What each objective is called and printed in, by its key in the answer."""

CHECK_KINDS = {
    "tension": "Tension",
    "uplift_angle": "Uplift angle",
    "uplift_force": "Uplift force",
    "grounded_length": "Grounded length",
    "offset": "Offset",
    "buoyancy": "Reserve buoyancy",
    "sliding": "Sliding",
    "holding": "Holding",
}
"""Headings of the checks by kind, in the order of tables."""

_LEFT_OUT = " left out"
"""Ends what a search says of a part that it took out."""


def segment_words(line: Line) -> list[str]:
    """Say what each segment is: ``"chain studless R3 76 mm, 45 m"``."""
    return [
        f"{segment.name or f'segment {number}'}, {segment.length:g} m"
        for number, segment in enumerate(line.segments, start=1)
    ]


def clump_weight_words(line: Line) -> list[str]:
    """Say what hangs on the line: ``"2 t at 7 m"``, with the mass in air."""
    return [
        f"{_weight(load.mass, load.submerged_weight)} at {load.position:g} m"
        for load in line.point_loads
    ]


def anchor_words(point: DesignPoint) -> str:
    """Say what holds the line; empty when the case has no anchor."""
    anchor = point.anchor
    if anchor is None:
        return ""
    if anchor.kind == "sinker":
        return f"sinker {_weight(anchor.mass, anchor.submerged_weight or 0.0)}"
    return "drag anchor"


def _weight(mass: float | None, submerged_weight: float) -> str:
    if mass is not None:
        return f"{mass / 1e3:g} t"
    return f"{submerged_weight / 1e3:g} kN in water"


def check_kinds(reports: Iterable[CheckReport]) -> list[str]:
    """List the kinds of checks that were made, in the order of tables."""
    made = {result.kind for report in reports for result in report.results}
    return [kind for kind in CHECK_KINDS if kind in made]


def tightest(report: CheckReport, kind: str) -> CheckResult | None:
    """Return the check of a kind that is nearest to its limit, over segments and load cases."""
    made = [result for result in report.results if result.kind == kind]
    return largest(made, lambda result: result.excess, ROUNDING) if made else None


def governing_words(result: CheckResult | None) -> str:
    """Say which check governs: ``"tension, segment 1 (storm)"``."""
    return "" if result is None else f"{result.name} ({result.load_case})"


def said_governing(words: Words, result: CheckResult | None) -> str:
    """Say in a language which check governs; the load case keeps its name."""
    return "" if result is None else f"{words.sentence(result.name).text} ({result.load_case})"


def change_words(change: str, words: Words) -> str:
    """Say what is changed: ``"chain: 29 m for 28.5 m"``, with the user's own names in it."""
    part, between, added = change.partition(" put in: ")
    if between:
        return words("front.put_in", part=_part(part, words), added=added)
    if change.endswith(_LEFT_OUT):
        return words("front.taken_out", part=_part(change.removesuffix(_LEFT_OUT), words))
    part, colon, rest = change.partition(": ")
    new, between, old = rest.rpartition(" for ")
    if colon and between:
        return words("front.step", part=_part(part, words), new=new, old=old)
    return change


def _part(name: str, words: Words) -> str:
    """Say which part; one without a name of the user's goes by its number."""
    numbered = re.fullmatch(r"(segment|clump weight) (\d+)", name)
    if numbered is None:
        return name
    kind = "front.segment" if numbered[1] == "segment" else "front.clump"
    return f"{words(kind)} {numbered[2]}"


def said_change(words: Words, neighbour: Neighbour) -> str:
    """Say in a language what is changed; components keep their names."""
    if words.language == "en":
        return neighbour.change
    said = change_words(neighbour.change, words)
    return words.name(said) if said == neighbour.change else said


def verdict(neighbour: Neighbour) -> str:
    """Say whether a changed design is feasible, and by what it fails when it is not."""
    if neighbour.point is None:
        return neighbour.reason
    report = neighbour.point.checks
    worst = report.governing
    if report.passes or worst is None:
        return "passes"
    how = "" if worst.utilisation is None else f", utilisation {worst.utilisation:.3f}"
    return f"fails: {governing_words(worst)}{how}"


def objective_quantities(result: DesignResult) -> list[tuple[str, Quantity]]:
    """Pair each objective with its quantity: those wanted first, then what else is known."""
    known = result.front[0].objectives if result.front else {}
    keys = [*result.objectives, *(key for key in known if key not in result.objectives)]
    return [(key, OBJECTIVES[key]) for key in keys]
