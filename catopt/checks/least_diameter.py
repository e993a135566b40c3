"""How far a segment may wear before it no longer passes: the diameter for an inspection."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from catopt.checks.criteria import Criteria, allowed_by
from catopt.checks.kinds import ROUNDING, Criterion, State
from catopt.checks.result import CheckReport
from catopt.model import Line, Segment, Service
from catopt.model.load import LoadCaseKind

_STEPS = 60
"""Halvings of the diameter: down to the last digit of double precision."""

_In = tuple[LoadCaseKind, State]


@dataclass(frozen=True)
class LeastDiameter:
    """How far a segment may wear."""

    segment: int
    """From 1 at the anchor."""
    diameter: float
    end_diameter: float
    """Nominal, new and at the end of the service life, m."""
    least: float | None
    """Smallest nominal diameter at which every check of its tension passes, m; None where it fails
    as it is new."""

    @property
    def room(self) -> float | None:
        """How much of the new diameter may wear off, m."""
        return None if self.least is None else self.diameter - self.least


def least_diameters(
    report: CheckReport, criteria: Criteria, line: Line
) -> tuple[LeastDiameter, ...]:
    """Find the diameter of every segment at which a check of its tension no longer passes.

    Tensions stay those of the new line: a worn one weighs less and pulls no more. A fibre rope, a
    segment without a diameter and one whose tension nothing limits have none. The report is of the
    line, or of a body on lines like it.
    """
    found = []
    for number, segment in enumerate(line.segments, start=1):
        if segment.nominal_diameter is None:
            continue
        strength = criteria.strength(segment)
        pulls = _pulls(report, number)
        wanted = [
            (criterion, pull)
            for (kind, state), pull in pulls.items()
            for criterion in criteria.of("tension", kind, state)
            if criterion.is_for(strength.kind)
        ]
        if strength.kind != "rope" and wanted and strength.end_diameter is not None:
            least = _least(segment, criteria, wanted)
            found.append(
                LeastDiameter(number, segment.nominal_diameter, strength.end_diameter, least)
            )
    return tuple(found)


def _pulls(report: CheckReport, segment: int) -> Mapping[_In, float]:
    """Largest tension of a segment by kind of load case and state, N."""
    kinds: dict[str, LoadCaseKind] = {each.name: each.kind for each in report.load_cases}
    found: dict[_In, float] = {}
    for each in report.results:
        if each.kind == "tension" and each.place.segment == segment:
            key = kinds.get(each.load_case, "extreme"), each.place.state
            found[key] = max(each.demand, found.get(key, 0.0))
    return found


def _least(
    segment: Segment, criteria: Criteria, wanted: list[tuple[Criterion, float]]
) -> float | None:
    new = segment.nominal_diameter
    assert new is not None

    def passes(diameter: float) -> bool:
        worn = replace(segment, wear_rate=new - diameter, wear_zone=None)
        strength = replace(criteria, service=Service(life=1.0)).strength(worn)
        return all(
            pull <= (1.0 + ROUNDING) * allowed_by(each, strength, "segment")
            for each, pull in wanted
        )

    if not passes(new):
        return None
    low, high = 0.0, new
    for _ in range(_STEPS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if passes(middle) else (middle, high)
    return high
