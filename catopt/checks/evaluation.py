"""Each check of a line in one load case: demand, capacity and by how much the limit is overrun."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from catopt.catenary.solution import Solution
from catopt.checks.criteria import Criteria, allowed_by
from catopt.checks.criterion import Criterion, Place
from catopt.checks.excess import tension_excess
from catopt.checks.kinds import CHECK_KINDS, OF_LINE, QUANTITY_OF, CheckKind, Demand
from catopt.checks.result import CheckResult
from catopt.checks.strength import Strength
from catopt.model import Anchor, Segment
from catopt.model.load_case import LoadCaseKind
from catopt.words import Measure, Message, Several

_BY_ITSELF = Place()


def evaluate(
    solution: Solution,
    criteria: Criteria,
    strengths: Sequence[Strength],
    anchor: Anchor | None,
    *,
    load_case: str,
    kind: LoadCaseKind,
    place: Place = _BY_ITSELF,
) -> Iterator[CheckResult]:
    """Check a line at rest by every criterion that is for its load case and its state.

    Strengths are those of its segments, from the anchor to the fairlead; results come in the order
    of `CHECK_KINDS`, tensions by segment. By `place` it is a line of a body, in a state; then
    nothing is compared with the reserve of buoyancy, which all lines share.

    Raises
    ------
    InputError
        A strength that a criterion needs is not known.
    """
    for index, strength in enumerate(strengths):
        segment, largest = solution.line.segments[index], solution.segments[index].max_tension
        at = replace(place, segment=index + 1)
        for criterion in criteria.of("tension", kind, place.state):
            if criterion.is_for(strength.kind):
                yield check_tension(
                    criterion, segment, strength, largest, load_case=load_case, place=at
                )
    for check in CHECK_KINDS:
        if check in OF_LINE and (place.line is None or check != "buoyancy"):
            for criterion in criteria.of(check, kind, place.state):
                found = OF_LINE[check].measure(criterion.value, solution, anchor)
                yield result_of(check, criterion, found, load_case, place)


def check_tension(
    criterion: Criterion,
    segment: Segment,
    strength: Strength,
    tension: float,
    *,
    mean_share: float = 1.0,
    load_case: str,
    place: Place,
) -> CheckResult:
    """Check the tension of one segment: the largest, N <= strength at the end of life / factor.

    `mean_share` is the mean over the largest, from 0 to 1. Place says line, state and number of the
    segment. Refused when the strength is not known.
    """
    assert place.segment is not None
    assert criterion.of != ""
    index = place.segment - 1
    capacity = allowed_by(criterion, strength, f"line.segments[{index}]", mean_share)
    by_tests = criterion.takes_tests and strength.tested is not None
    full = strength.tested if by_tests else strength.need(criterion.of, "", "")
    said = "tested" if by_tests else criterion.of
    note = Message(f"checks.{said}", strength=Measure("MBL", full or 0.0), factor=criterion.value)
    if criterion.part != 1.0 and not by_tests:
        note = Message("checks.part_of", part=criterion.part, strength=note)
    if criterion.mean_factor is not None:
        values = {"factor": criterion.mean_factor, "share": mean_share}
        note = Message("checks.on_the_mean", strength=note, **values)
    if strength.note:
        note = Several((note, strength.note), ", ")
    found = Demand(tension, capacity, tension_excess(tension, capacity), note)
    name = Message("checks.tension", segment=segment_words(segment, index))
    return result_of("tension", criterion, found, load_case, place, name)


def result_of(
    check: CheckKind,
    criterion: Criterion,
    found: Demand,
    load_case: str,
    place: Place,
    name: str = "",
) -> CheckResult:
    """Make the result of a criterion; its name is that of the kind of check unless given."""
    return CheckResult(
        name=name or Message(f"checks.{check}"),
        kind=check,
        load_case=load_case,
        demand=found.demand,
        capacity=found.capacity,
        unit=QUANTITY_OF[check].si_unit,
        excess=found.excess,
        source=criterion.source,
        note=Several(part for part in (found.note, criterion.note) if part),
        place=place,
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
