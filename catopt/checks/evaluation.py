"""Hold demands against capacities, and say what else is to be known of a check."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final, NamedTuple

from catopt.catalogue.components import RECALLED
from catopt.catenary.solution import Solution
from catopt.checks.criteria import UPLIFT, Criteria, Strength, allowed_by
from catopt.checks.kinds import (
    CHECK_KINDS,
    OF_LINE,
    QUANTITY_OF,
    USER,
    CheckKind,
    Criterion,
    Demand,
    Place,
    State,
    ratio_exceedance,
)
from catopt.checks.result import CheckResult
from catopt.largest import largest
from catopt.model import Anchor, Line, Segment
from catopt.model.load import LoadCaseKind
from catopt.words import Listed, Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.mooring.network_rest import BodyAtRest, FloatAtRest

NO_CHECK: Final = "checks.none"
"""Key of the warning that nothing is checked."""

IN_LOAD_CASE: Final = "checks.in_load_case"
"""Key of what is said of one load case."""

_LEVEL = 1e-9
"""rad; an inclination that is rounding."""


def in_load_case(*load_cases: str, said: str) -> Message:
    """Say of which load case, or cases, something is said."""
    if len(load_cases) == 1:
        return Message(IN_LOAD_CASE, name=load_cases[0], said=said)
    names = Several((Message("checks.quoted", name=each) for each in load_cases), ", ")
    return Message("checks.in_load_cases", names=names, said=said)


def of_criteria(criteria: Criteria, line: Line, strengths: Sequence[Strength]) -> Iterator[str]:
    """Say what is to be known of the criteria, and which segments none of them covers."""
    if not criteria.all:
        yield Message(NO_CHECK)
    yield from criteria.warnings
    table = None if criteria.service is None else criteria.service.table
    if table is not None and table.confidence == RECALLED:
        yield Message("checks.wear_table_recalled", source=term(table.source))
    for index, strength in enumerate(strengths):
        covered = any(
            each.check == "tension" and each.is_for(strength.kind) for each in criteria.all
        )
        if criteria.all and not covered:
            words = segment_words(line.segments[index], index)
            yield Message("checks.no_strength_criterion", segment=words)


def of_other_states(criteria: Criteria) -> Iterator[Message]:
    """Say which codes are for one line out, too: a line by itself is not judged by that."""
    yield from _only_for(criteria, "one_line_out", "checks.line_by_itself")
    yield from of_transient(criteria)


def of_transient(criteria: Criteria) -> Iterator[Message]:
    """Say which codes have factors for the transient state: nothing at rest is judged by them."""
    yield from _only_for(criteria, "transient", "checks.transient_not_judged")


def _only_for(criteria: Criteria, state: State, said: str) -> Iterator[Message]:
    """Name the codes that have criteria for one state alone."""
    found = (each.source.code for each in criteria.all if each.states == (state,))
    yield from of_codes(said, found)


def of_codes(said: str, codes: Iterable[str]) -> Iterator[Message]:
    """Say something of codes, each named once; nothing where there are none."""
    named = tuple(dict.fromkeys(codes))
    if named:
        yield Message(said, codes=Listed(named, "and"))


class Lifted(NamedTuple):
    """A line that may lift its anchor."""

    where: str
    """Load case, or line and state, in words."""
    state: State
    kind: LoadCaseKind
    solution: Solution


def of_uplift(
    solved: Iterable[Lifted], criteria: Criteria, anchor: Anchor | None
) -> Iterator[Message]:
    """Say where an anchor is lifted most and no check is on that, or is lifted though it drags.

    Of every line in every state; a sinker's check on sliding covers its uplift.
    """
    lifted = [each for each in solved if each.solution.anchor.angle > _LEVEL]
    if not lifted or (anchor is not None and anchor.kind == "sinker"):
        return
    free = [
        each
        for each in lifted
        if not any(True for check in UPLIFT for _ in criteria.of(check, each.kind, each.state))
    ]
    if free or anchor is not None:
        worst = largest(free or lifted, lambda each: each.solution.anchor.angle)
        pull = worst.solution.anchor
        yield Message(
            "checks.uplift_unchecked" if free else "checks.drag_anchor_lifted",
            where=worst.where,
            angle=Measure("angle", pull.angle),
            force=Measure("vertical_force", pull.vertical_force),
        )


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
    nothing is compared with the reserve of buoyancy, which all lines share. InputError: a strength
    that a criterion needs is not known.
    """
    largest = [(each.max_tension, 1.0) for each in solution.segments]
    of_tension = list(criteria.of("tension", kind, place.state))
    yield from check_tensions(
        solution.line, of_tension, strengths, largest, load_case=load_case, place=place
    )
    for check in CHECK_KINDS:
        if check in OF_LINE and (place.line is None or check != "buoyancy"):
            for criterion in criteria.of(check, kind, place.state):
                found = OF_LINE[check].measure(criterion.value, solution, anchor)
                yield result_of(check, criterion, found, load_case, place)


def check_tensions(
    line: Line,
    criteria: Sequence[Criterion],
    strengths: Sequence[Strength],
    tensions: Iterable[tuple[float, float]],
    *,
    load_case: str,
    place: Place,
) -> Iterator[CheckResult]:
    """Check the tension of each segment: the largest, N <= strength at the end of life / factor.

    Tensions are the largest of each segment, N, with the mean over it, from 0 to 1. Refused when a
    strength is not known.
    """
    each_segment = zip(line.segments, strengths, tensions, strict=True)
    for index, (segment, strength, (tension, mean_share)) in enumerate(each_segment):
        name = Message("checks.tension", segment=segment_words(segment, index))
        at = replace(place, segment=index + 1)
        for criterion in criteria:
            if criterion.is_for(strength.kind):
                found = _tension(criterion, strength, tension, mean_share, index)
                yield result_of("tension", criterion, found, load_case, at, name)


def _tension(
    criterion: Criterion, strength: Strength, tension: float, mean_share: float, index: int
) -> Demand:
    assert criterion.of != ""
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
    return Demand(tension, capacity, ratio_exceedance(tension, capacity), note)


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
        exceedance=found.exceedance,
        source=criterion.source,
        note=Several(part for part in (found.note, criterion.note) if part),
        place=place,
    )


def check_buoyancy(
    pulls: Iterable[float], criteria: Criteria, load_case: str, place: Place
) -> Iterator[CheckResult]:
    """Hold the vertical pulls of all lines of a body, N, against its reserve of buoyancy."""
    pull = math.fsum(pulls)
    for criterion in criteria.of("buoyancy", "extreme", place.state):
        found = Demand(pull, criterion.value, ratio_exceedance(pull, criterion.value))
        yield result_of("buoyancy", criterion, found, load_case, place)


def check_afloat(
    bodies: Iterable[BodyAtRest], load_case: str, place: Place
) -> Iterator[CheckResult]:
    """Hold the vertical pull of the lines of each body against its reserve of buoyancy.

    One that floats deeper as it is pulled fails as soon as it is under water, where its lines pull
    with all its reserve.
    """
    for each in bodies:
        floating = each.floating
        if floating.reserve is None:
            continue
        # One that keeps its height has no freeboard to lose.
        height = math.fsum(each.body.afloat[1:]) if each.body.floats else 0.0
        used, sunk = (floating.pull, floating.reserve), (-(floating.freeboard or 0.0), height)
        yield _check_float(each.body.name, used, sunk, load_case, place)


def check_floats(
    floats: Iterable[FloatAtRest], load_case: str, place: Place
) -> Iterator[CheckResult]:
    """Hold what lines use of each float of a known height against its buoyancy.

    One without a height may be meant to be under water, as a buoy below the surface is.
    """
    for each in floats:
        if each.of.float_height is None:
            continue
        used, sunk = (each.used, each.buoyancy), (each.under, each.of.float_height)
        yield _check_float(each.name, used, sunk, load_case, place)


def _check_float(
    name: str,
    used: tuple[float, float],
    sunk: tuple[float, float],
    load_case: str,
    place: Place,
) -> CheckResult:
    """Hold what is used of a buoyancy against all of it, N; what is under water fails.

    `sunk`: by how much it is under, over its height, m.
    """
    (pull, reserve), (under, height) = used, sunk
    found = Demand(pull, reserve, ratio_exceedance(pull, reserve))
    if under > 0.0:
        said = Message("checks.under_water", under=Measure("height", under))
        found = found._replace(exceedance=max(found.exceedance, under / height), note=said)
    own = Criterion("buoyancy", reserve, USER)
    return result_of(
        "buoyancy", own, found, load_case, place, Message("checks.buoyancy_of", name=name)
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
