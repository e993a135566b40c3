"""Each check of a line in one load case: demand, capacity and by how much the limit is overrun."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from catopt.catenary.solution import Solution
from catopt.checks.criteria import Criteria, allowed_by
from catopt.checks.criterion import CHECK_KINDS, CheckKind, Criterion
from catopt.checks.excess import (
    buoyancy_excess,
    grounded_excess,
    holding_excess,
    sliding_excess,
    span_excess,
    tension_excess,
    uplift_angle_excess,
    uplift_force_excess,
)
from catopt.checks.result import CheckResult
from catopt.checks.state import Place
from catopt.checks.strength import Strength
from catopt.model import Anchor, Segment
from catopt.model.anchor import sinker_needed
from catopt.model.load_case import LoadCaseKind
from catopt.words import Measure, Message, Several

_STRENGTHS = {"MBL": "checks.MBL", "proof_load": "checks.proof_load"}
_BY_ITSELF = Place()


@dataclass(frozen=True)
class _Measured:
    """A demand beside its capacity, of one criterion."""

    name: str
    demand: float
    capacity: float
    unit: str
    excess: float
    note: str
    segment: int | None = None


def evaluate(
    solution: Solution,
    criteria: Criteria,
    strengths: Sequence[Strength],
    anchor: Anchor | None,
    *,
    load_case: str,
    kind: LoadCaseKind,
    place: Place = _BY_ITSELF,
) -> tuple[CheckResult, ...]:
    """Check a line at rest by every criterion that is for its load case and its state.

    Strengths are those of its segments, from the anchor to the fairlead; results come in the order
    of `CHECK_KINDS`, tensions by segment. By `place` it is a line of a body, in a state; then
    nothing is compared with the reserve of buoyancy, which all lines share.

    Raises
    ------
    InputError
        A strength that a criterion needs is not known.
    """
    return tuple(
        _result(check, criterion, found, load_case, place)
        for check in CHECK_KINDS
        if place.line is None or check != "buoyancy"
        for criterion, found in _measured(
            check, list(criteria.of(check, kind, place.state)), solution, strengths, anchor
        )
    )


def evaluate_tension(
    criterion: Criterion,
    segment: Segment,
    strength: Strength,
    tension: float,
    *,
    mean_share: float = 1.0,
    load_case: str,
    place: Place,
) -> CheckResult:
    """Check the tension of one segment by one criterion.

    The tension is the largest, N, and `mean_share` the mean over it, from 0 to 1. Place says line,
    state and number of the segment. Refused when the strength is not known.
    """
    assert place.segment is not None
    index = place.segment - 1
    found = _tension(criterion, segment, index, strength, tension, mean_share)
    return _result("tension", criterion, found, load_case, place)


def _result(
    check: CheckKind, criterion: Criterion, found: _Measured, load_case: str, place: Place
) -> CheckResult:
    return CheckResult(
        name=found.name,
        kind=check,
        load_case=load_case,
        demand=found.demand,
        capacity=found.capacity,
        unit=found.unit,
        excess=found.excess,
        source=criterion.source,
        note=Several(part for part in (found.note, criterion.note) if part),
        place=replace(place, segment=found.segment),
    )


def _measured(
    check: CheckKind,
    wanted: Sequence[Criterion],
    solution: Solution,
    strengths: Sequence[Strength],
    anchor: Anchor | None,
) -> Iterator[tuple[Criterion, _Measured]]:
    """Measure one check by each of its criteria."""
    if check == "tension":
        for index, strength in enumerate(strengths):
            for criterion in wanted:
                if criterion.is_for(strength.kind):
                    segment, largest = solution.line.segments[index], solution.segments[index]
                    tension = largest.max_tension
                    yield criterion, _tension(criterion, segment, index, strength, tension)
        return
    for criterion in wanted:
        yield criterion, _of_line(check, criterion.value, solution, anchor)


def _of_line(
    check: CheckKind, value: float, solution: Solution, anchor: Anchor | None
) -> _Measured:
    """Measure a check of the line as a whole."""
    match check:
        case "uplift_angle":
            return _uplift_angle(value, solution)
        case "uplift_force":
            return _uplift_force(value, solution)
        case "grounded_length":
            return _grounded_length(value, solution)
        case "span":
            return _span(value, solution)
        case "buoyancy":
            return _buoyancy(value, solution)
        case "sliding":
            assert anchor is not None
            return _sliding(value, solution, anchor)
        case _:
            assert anchor is not None
            return _holding(value, solution, anchor)


def _tension(
    criterion: Criterion,
    segment: Segment,
    index: int,
    strength: Strength,
    demand: float,
    mean_share: float = 1.0,
) -> _Measured:
    """Largest tension of a segment <= strength at the end of life / factor."""
    capacity = allowed_by(criterion, strength, f"line.segments[{index}]", mean_share)
    assert criterion.of != ""
    by_tests = criterion.takes_tests and strength.tested is not None
    full = strength.tested if by_tests else strength.need(criterion.of, "", "")
    said = "checks.tested" if by_tests else _STRENGTHS[criterion.of]
    note = Message(said, strength=Measure("MBL", full or 0.0), factor=criterion.value)
    if criterion.part != 1.0 and not by_tests:
        note = Message("checks.part_of", part=criterion.part, strength=note)
    if criterion.mean_factor is not None:
        values = {"factor": criterion.mean_factor, "share": mean_share}
        note = Message("checks.on_the_mean", strength=note, **values)
    return _Measured(
        Message("checks.tension", segment=segment_words(segment, index)),
        demand,
        capacity,
        "N",
        tension_excess(demand, capacity),
        Several((note, strength.note), ", ") if strength.note else note,
        segment=index + 1,
    )


def segment_words(segment: Segment, index: int) -> Message:
    """Name a segment: ``segment 2 (chain studless R3 76 mm)``; the index is from 0 at the anchor.

    Its own name goes before component and nominal diameter.
    """
    diameter = segment.nominal_diameter
    size = "" if diameter is None else f"{diameter * 1e3:.4g} mm"
    words = segment.name or " ".join(part for part in (segment.component, size) if part)
    key = "checks.named_segment" if words else "checks.segment"
    return Message(key, number=index + 1, name=words)


def _uplift_angle(limit: float, solution: Solution) -> _Measured:
    """Inclination of the line at the anchor <= limit."""
    angle = solution.anchor.angle
    excess = uplift_angle_excess(angle, limit)
    return _Measured(Message("checks.uplift_angle"), angle, limit, "rad", excess, "")


def _uplift_force(limit: float, solution: Solution) -> _Measured:
    """Vertical pull of the line on the anchor <= limit."""
    vertical = solution.anchor.vertical_force
    excess = uplift_force_excess(vertical, solution.anchor.horizontal_force, limit)
    return _Measured(Message("checks.uplift_force"), vertical, limit, "N", excess, "")


def _grounded_length(wanted: float, solution: Solution) -> _Measured:
    """Wanted length <= unstretched length that lies on the bed."""
    lies = solution.grounded_length
    excess = grounded_excess(lies, wanted)
    return _Measured(
        Message("checks.grounded_length"), wanted, lies, "m", excess, Message("checks.wanted")
    )


def _span(limit: float, solution: Solution) -> _Measured:
    """Span <= limit."""
    span = solution.span
    return _Measured(Message("checks.span"), span, limit, "m", span_excess(span, limit), "")


def _buoyancy(reserve: float, solution: Solution) -> _Measured:
    """Vertical pull at the fairlead <= reserve buoyancy."""
    vertical = solution.fairlead.vertical_force
    excess = buoyancy_excess(vertical, reserve)
    return _Measured(Message("checks.buoyancy"), vertical, reserve, "N", excess, "")


def _sliding(factor: float, solution: Solution, anchor: Anchor) -> _Measured:
    """Weight that the sinker needs, V + SF H / mu <= its weight in water."""
    assert anchor.submerged_weight is not None
    assert anchor.friction is not None
    pull = solution.anchor
    needed = sinker_needed(pull.horizontal_force, pull.vertical_force, anchor.friction, factor)
    return _Measured(
        Message("checks.sliding"),
        needed,
        anchor.submerged_weight,
        "N",
        sliding_excess(needed, anchor.submerged_weight),
        Message("checks.sinker_needed", factor=factor, friction=anchor.friction),
    )


def _holding(factor: float, solution: Solution, anchor: Anchor) -> _Measured:
    """Horizontal pull on the drag anchor <= ultimate holding capacity / factor."""
    assert anchor.holding_capacity is not None
    pull = solution.anchor.horizontal_force
    return _Measured(
        Message("checks.holding"),
        pull,
        anchor.holding_capacity / factor,
        "N",
        holding_excess(pull, factor, anchor.holding_capacity),
        Message(
            "checks.capacity", capacity=Measure("tension", anchor.holding_capacity), factor=factor
        ),
    )
