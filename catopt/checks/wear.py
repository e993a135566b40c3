"""How far segments may wear: the one limit that a note tabulates and an advice names."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Final

from catopt.catalogue.practice import condition as kept_condition
from catopt.checks.case import check_case
from catopt.checks.criteria import Criteria, allowed_by, criteria_of
from catopt.checks.kinds import ROUNDING, Criterion, State
from catopt.checks.result import CheckReport
from catopt.errors import NoAnswerError
from catopt.model import Case, Line, Segment, Service
from catopt.model.line import line_kind
from catopt.model.load import LoadCaseKind
from catopt.words import Message

_STEPS: Final = 60
"""Halvings of the diameter: down to the last digit of double precision."""
_SOLVED_STEPS: Final = 24
"""Where each is a line that is solved anew: to a ten millionth."""


@dataclass(frozen=True)
class LeastDiameter:
    """How far a segment may wear."""

    segment: int
    """From 1 at the anchor."""
    diameter: float
    end_diameter: float
    """Nominal, new and at the end of the service life, m."""
    least: float | None
    """Smallest nominal diameter at which every check is known to pass, at rest and, of lines that
    were run, in motion, m; None where one fails as it is new."""
    by: str = ""
    """What decides it, in words."""
    discard: float | None = None
    """At which authorities take a chain out, m; None of what is none."""

    @property
    def limit(self) -> float | None:
        """Diameter at which it is to be changed, m; None where a check fails as it is new."""
        return None if self.least is None else max(self.least, self.discard or 0.0)

    @property
    def is_by_checks(self) -> bool:
        """Whether a check, and not what authorities discard, decides that."""
        return self.least is not None and self.least > (self.discard or 0.0)

    @property
    def reason(self) -> str:
        """What decides that, in words."""
        if self.least is None or self.is_by_checks:
            return self.by
        return Message("wear.discard", part=100.0 * kept_condition().discard)

    @property
    def room(self) -> float | None:
        """How much of the new diameter may wear off, m."""
        return None if self.limit is None else self.diameter - self.limit


def least_diameters(
    report: CheckReport,
    criteria: Criteria,
    line: Line,
    case: Case | None = None,
    moved: CheckReport | None = None,
) -> tuple[LeastDiameter, ...]:
    """Find the diameter of every segment at which a check no longer passes.

    Tensions are those of the new line, which pulls no less than a worn one. Where the `case` of one
    line is given, the worn line is solved anew, too, and every check of it counts: it weighs less,
    and lifts and slides what holds it sooner. Where its checks in motion, `moved`, are given, so do
    their tensions, and no segment may wear beyond the end of its life, to which it was run.

    A fibre rope, a segment without a diameter and one whose tension nothing limits have none. The
    report is of the line, or of a body on lines like it.
    """
    found = []
    for number, segment in enumerate(line.segments, start=1):
        new = segment.nominal_diameter
        if new is None:
            continue
        strength = criteria.strength(segment)
        wanted = _wanted(report, criteria, segment, number)
        end = strength.end_diameter
        if strength.kind == "rope" or not wanted or end is None:
            continue
        limits = [_by_tension(segment, criteria, wanted, "wear.tension")]
        if case is not None and not case.several_lines:
            limits.append(_by_checks(case, line, number))
        if moved is not None and moved.case is not None:
            limits += _in_motion(moved, segment, number, end)
        known = [each for each in limits if each[0] is not None]
        least, by = max(known, key=lambda each: each[0] or 0.0, default=(None, ""))
        if len(known) < len(limits):
            least, by = None, next(each[1] for each in limits if each[0] is None)
        is_chain = line_kind(segment.name or segment.component) == "chain"
        discard = kept_condition().discard * new if is_chain else None
        found.append(LeastDiameter(number, new, end, least, by, discard))
    return tuple(found)


_Limit = tuple[float | None, str]
"""A diameter, m, None where even the new one fails, and what decides it."""


def _wanted(
    report: CheckReport, criteria: Criteria, segment: Segment, number: int
) -> list[tuple[Criterion, float]]:
    """List the criteria on the tension of a segment, each with the largest tension it is for."""
    kind_of = criteria.strength(segment).kind
    return [
        (criterion, pull)
        for (kind, state), pull in _pulls(report, number).items()
        for criterion in criteria.of("tension", kind, state)
        if criterion.is_for(kind_of)
    ]


def _pulls(report: CheckReport, segment: int) -> dict[tuple[LoadCaseKind, State], float]:
    """Largest tension of a segment by kind of load case and state, N."""
    kinds: dict[str, LoadCaseKind] = {each.name: each.kind for each in report.load_cases}
    found: dict[tuple[LoadCaseKind, State], float] = {}
    for each in report.results:
        if each.kind == "tension" and each.place.segment == segment:
            key = kinds.get(each.load_case, "extreme"), each.place.state
            found[key] = max(each.demand, found.get(key, 0.0))
    return found


def _by_tension(
    segment: Segment, criteria: Criteria, wanted: list[tuple[Criterion, float]], by: str
) -> _Limit:
    new = segment.nominal_diameter
    assert new is not None

    def passes(diameter: float) -> bool:
        worn = replace(segment, wear_rate=new - diameter, wear_zone=None)
        strength = replace(criteria, service=Service(life=1.0)).strength(worn)
        # Of a factor on the mean and one on the rest the stricter, whatever the mean is.
        return all(
            pull
            <= (1.0 + ROUNDING)
            * min(allowed_by(each, strength, "segment", share) for share in (0.0, 1.0))
            for each, pull in wanted
        )

    return _bisected(passes, new, _STEPS), Message(by)


def _by_checks(case: Case, line: Line, number: int) -> _Limit:
    """Solve and check the line with a segment worn, in every load case that is not of a new one."""
    new = line.segments[number - 1].nominal_diameter
    assert new is not None
    states = tuple(
        replace(each, condition="worn") for each in case.load_cases if each.condition != "new"
    )
    if not states:  # the load alone, or nothing but new: the tension decides
        return 0.0, ""

    def worn(diameter: float) -> Case:
        segments = (
            each
            if each.nominal_diameter is None
            else replace(each, wear_rate=new - diameter if k == number else 0.0, wear_zone=None)
            for k, each in enumerate(line.segments, start=1)
        )
        return replace(
            case,
            design=None,
            line=replace(line, segments=tuple(segments)),
            load_cases=states,
            service=Service(life=1.0),
        )

    def passes(diameter: float) -> bool:
        try:
            return check_case(worn(diameter)).passes
        except NoAnswerError:
            return False

    least = _bisected(passes, new, _SOLVED_STEPS)
    thinner = 0.999 * (new if least is None else least)
    try:
        failed = check_case(worn(thinner)).failed
    except NoAnswerError:
        failed = ()
    by = Message(f"checks.{failed[0].kind}_short") if failed else Message("wear.no_rest")
    return least, by


def _in_motion(moved: CheckReport, segment: Segment, number: int, end: float) -> Iterator[_Limit]:
    """Yield what its tensions in motion allow, and how thin it was run."""
    assert moved.case is not None
    criteria = criteria_of(moved.case, analysis="dynamic")
    wanted = _wanted(moved, criteria, segment, number)
    if wanted:
        yield _by_tension(segment, criteria, wanted, "wear.tension_in_motion")
    yield end, Message("wear.run_to")


def _bisected(passes: Callable[[float], bool], new: float, steps: int) -> float | None:
    """Find the smallest diameter that passes, m; None where even the new one fails."""
    if not passes(new):
        return None
    low, high = 0.0, new
    for _ in range(steps):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if passes(middle) else (middle, high)
    return high
