"""Check a body with several lines, or lines between points: with all there, with each gone."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from catopt.checks.criteria import HORIZONTAL_PULL, Criteria, Strength, criteria_of
from catopt.checks.evaluation import (
    Lifted,
    check_afloat,
    check_buoyancy,
    check_floats,
    evaluate,
    of_criteria,
    of_transient,
    of_uplift,
)
from catopt.checks.kinds import ROUNDING, Criterion, Place, State
from catopt.checks.result import AtLevels, CheckReport, CheckResult, line_in_state
from catopt.errors import InputError, Problem
from catopt.model import Anchor, Case, Leg, Line
from catopt.model.network import Network
from catopt.mooring.afloat_words import bodies_said, floats_said
from catopt.mooring.case import LineOut, SystemReport, one_line_out, report_system
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_out import NetworkOut, each_line_out
from catopt.mooring.network_rest import LinesAtRest
from catopt.mooring.restoring import WatchCircle
from catopt.mooring.solution import SystemSolution, of_line
from catopt.words import Measure, Message


@dataclass(frozen=True)
class InState:
    """The body in one state."""

    place: Place
    solution: SystemSolution | None
    """None where it does not come to rest."""
    numbers: tuple[int, ...]
    """Of the lines that are there, from 1."""
    refusal: str = ""
    """Why there is no solution."""
    under: Message | None = None
    """The load that it is under, where there are several."""

    @property
    def name(self) -> Message:
        """The state in words, with its load where there are several."""
        said = state_words(self.place)
        if self.under is None:
            return said
        return Message("checks.state_under", state=said, load=self.under)


def state_words(place: Place) -> Message:
    """Name a state of a mooring: ``"intact"``, ``"line 2 out"``."""
    gone = place.missing
    return Message("checks.intact") if gone is None else Message("checks.line_out", number=gone)


def check_system(case: Case, report: SystemReport | None = None) -> CheckReport:
    """Check a moored body by every criterion, each in the state that it is for.

    Every line is checked as the balance has it, with all lines there and, where a criterion is for
    that, with each of them gone in turn; a reserve of buoyancy against the vertical pull of all.
    Where the body finds no rest without a line, that is a failed check.

    The report is what `report_system` gave for it; what it lacks is solved here. Raises what
    `check_case` and `report_system` raise.
    """
    system, criteria = case.own_system, criteria_of(case)
    legs = system.legs
    damaged = for_line_out(criteria, len(legs)) if system.judged_line_out else ()
    known = strengths_of_lines(criteria, legs, damaged)
    report = report or report_system(case)
    lost = report.line_out or one_line_out(system) if damaged else ()
    states = tuple(_states(report.solution, lost))
    results: list[CheckResult] = []
    solved: list[tuple[Lifted, Place]] = []
    for state in states:
        if state.solution is None:
            results += lost_results(state.place, state.refusal, damaged)
            continue
        for number, line in zip(state.numbers, state.solution.lines, strict=True):
            place = replace(state.place, line=number)
            where = line_in_state(number, state.name)
            solved.append((Lifted(where, place.state, "extreme", line.solution), place))
        results += check_state(state, criteria, known, case.anchor)
    lines = {line: of_criteria(criteria, line, strengths) for line, strengths in known.items()}
    warnings = (
        *(warning for reported in lines.values() for warning in reported),
        *(
            of_line_out(criteria, damaged, len(legs))
            if system.judged_line_out
            else (Message("checks.line_out_not_asked"),)
        ),
        *of_transient(criteria),
        *of_uplift((each for each, _ in solved), criteria, case.anchor),
        *report.solution.warnings,
    )
    return CheckReport(
        title=case.title,
        results=tuple(results),
        solutions=tuple((each.where, each.solution) for each, _ in solved),
        warnings=tuple(dict.fromkeys(warnings)),
        places=tuple(place for _, place in solved),
        case=case,
    )


def check_state(
    state: InState,
    criteria: Criteria,
    strengths: Mapping[Line, Sequence[Strength]],
    anchor: Anchor | None,
) -> Iterator[CheckResult]:
    """Check a body that has come to rest in one state: each of its lines, then all together.

    Strengths are of the segments of each different line; the anchor is what holds each.
    """
    assert state.solution is not None
    for number, line in zip(state.numbers, state.solution.lines, strict=True):
        yield from evaluate(
            line.solution,
            criteria,
            strengths[line.leg.line],
            anchor,
            load_case=state.name,
            kind="extreme",
            place=replace(state.place, line=number),
        )
    # The vertical pull of all lines against the reserve of buoyancy, if that is given.
    pulls = (line.solution.fairlead.vertical_force for line in state.solution.lines)
    yield from check_buoyancy(pulls, criteria, state.name, state.place)


def for_line_out(criteria: Criteria, lines: int) -> tuple[Criterion, ...]:
    """List the criteria for one line out; of one line, those that codes have for nothing else."""
    return tuple(
        each
        for each in criteria.all
        if "one_line_out" in each.states
        and (lines > 1 or ("intact" not in each.states and each.source != HORIZONTAL_PULL))
    )


def checked_states(damaged: tuple[Criterion, ...]) -> tuple[State, ...]:
    """States in which lines are judged; `damaged`: the criteria for one line out."""
    return ("intact", "one_line_out") if damaged else ("intact",)


def strengths_of_lines(
    criteria: Criteria, legs: Sequence[Leg], damaged: tuple[Criterion, ...]
) -> dict[Line, tuple[Strength, ...]]:
    """Find the strengths of each different line of a body; InputError as for `check_case`."""
    states = checked_states(damaged)
    return {line: criteria.strengths(line, {"extreme"}, states) for line in {e.line for e in legs}}


def _states(solution: SystemSolution, lost: Sequence[LineOut]) -> Iterator[InState]:
    everything = tuple(range(1, len(solution.lines) + 1))
    yield InState(Place(), solution, everything)
    for each in lost:
        missing = each.missing + 1
        left = tuple(number for number in everything if number != missing)
        place = Place("one_line_out", missing=missing)
        yield InState(place, each.solution, left, each.refusal)


def lost_results(
    place: Place, refusal: str, damaged: tuple[Criterion, ...]
) -> Iterator[CheckResult]:
    """Fail every source of criteria for one line out: without this line there is no equilibrium."""
    for source in dict.fromkeys(each.source for each in damaged):
        yield CheckResult(
            name=Message("checks.equilibrium"),
            kind="equilibrium",
            load_case=state_words(place),
            demand=1.0,
            capacity=0.0,
            unit="",
            exceedance=1.0,
            source=source,
            note=refusal,
            place=place,
        )


def of_line_out(
    criteria: Criteria, damaged: tuple[Criterion, ...], lines: int
) -> Iterator[Message]:
    """Say which codes have no factor for one line out, or that nothing has."""
    if not damaged and criteria.all:
        yield Message("checks.one_line" if lines == 1 else "checks.line_out_not_judged")
        return
    judging = {each.source.code for each in damaged}
    coded = (each.source for each in criteria.all if each.source.confidence is not None)
    for code in dict.fromkeys(source.code for source in coded):
        if code not in (*judging, HORIZONTAL_PULL.code):
            yield Message("checks.intact_only", code=code)


def check_network(
    network: Network,
    rest: LinesAtRest | None = None,
    line_out: Sequence[NetworkOut] | None = None,
) -> CheckReport:
    """Check lines between points by every criterion, each in the state that it is for.

    Tensions are checked of every line, all else of those that end at an anchor, at that end. Where
    a criterion is for one line out, each line is gone in turn, and what finds no rest without it is
    a failed check; a body that is held stays where it is.

    `rest` is what `at_rest` gave for it, `line_out` what `each_line_out` did; what is left out is
    solved here. Raises what `check_case` and `at_rest` raise.
    """
    criteria = criteria_of_network(network)
    count = len(network.lines)
    damaged = for_line_out(criteria, count)
    rest = rest or at_rest(network)
    strengths = _strengths(criteria, network, rest, checked_states(damaged))
    gone = (each_line_out(network) if line_out is None else line_out) if damaged else ()
    results: list[CheckResult] = []
    solved: list[tuple[Lifted, Place, bool]] = []
    # A line that ends at no anchor is checked by its tensions alone.
    tensions = replace(
        criteria, all=tuple(each for each in criteria.all if each.check == "tension")
    )
    for place, found, numbers, refusal in _network_states(rest, gone):
        if found is None:
            results += lost_results(place, refusal, damaged)
            continue
        for k, (number, line) in enumerate(zip(numbers, found.lines, strict=True)):
            own, anchored = replace(place, line=number + 1), found.is_anchored(k)
            where = line_in_state(number + 1, state_words(place))
            solved.append((Lifted(where, place.state, "extreme", line), own, anchored))
            results += evaluate(
                line,
                criteria if anchored else tensions,
                strengths[number],
                network.anchor,
                load_case=state_words(place),
                kind="extreme",
                place=own,
            )
        results += check_afloat(found.bodies, state_words(place), place)
        results += check_floats(found.floats, state_words(place), place)
    warnings = (
        *bodies_said(rest, under=True),
        *floats_said(rest, under=True),
        *_of_fairleads(network),
        *(
            said
            for run, known in zip(rest.runs, strengths, strict=True)
            for said in of_criteria(criteria, run.line, known)
        ),
        *of_line_out(criteria, damaged, count),
        *(_of_states(rest, gone) if damaged else ()),
        *of_transient(criteria),
        *of_uplift((each for each, _, anchored in solved if anchored), criteria, network.anchor),
        *_of_anchors(criteria, rest),
        *(Message("mooring.body_drifts", name=b.body.name) for b in rest.bodies if not b.is_held),
        *_of_joints(rest),
        *(
            of_line(number, warning)
            for number, line in enumerate(rest.lines, start=1)
            for warning in line.warnings
        ),
    )
    return CheckReport(
        title=network.title,
        results=tuple(results),
        solutions=tuple((each.where, each.solution) for each, _, _ in solved),
        warnings=tuple(dict.fromkeys(warnings)),
        places=tuple(place for _, place, _ in solved),
        case=network,
    )


M = TypeVar("M", Case, Network)


def check_at_levels(
    report: CheckReport, check: Callable[[M], CheckReport], mooring: M, levels: Sequence[float]
) -> AtLevels:
    """Check a mooring that has been checked at its own water level at others, m above it, too."""
    others: tuple[CheckReport, ...] = tuple(check(mooring.raised(level)) for level in levels)
    results: tuple[CheckResult, ...] = tuple(
        replace(each, load_case=Message("checks.state_under", state=each.load_case, load=load))
        for load, other in zip(map(_level_words, levels), others, strict=True)
        for each in other.results
    )
    warnings = (*report.warnings, *(said for other in others for said in other.others))
    every = (*report.results, *results)
    whole = replace(report, results=every, warnings=tuple(dict.fromkeys(warnings)))
    return AtLevels(whole, others)


def with_circle(report: CheckReport, circle: WatchCircle | None) -> CheckReport:
    """Say of checks where the load from another side is harder on a line than its own."""
    if circle is None or not report.results:
        return report
    own = [
        segment.max_tension
        for (_, solution), place in zip(report.solutions, report.places, strict=True)
        if place.state == "intact"
        for segment in solution.segments
    ]
    hardest = circle.responses[circle.hardest].largest_tension
    if hardest <= max(own) * (1.0 + ROUNDING):
        return report
    angle = Measure("angle", circle.directions[circle.hardest])
    tension = Measure("tension", hardest)
    said = Message("checks.other_directions", angle=angle, tension=tension)
    return replace(report, warnings=(said, *report.warnings))


def _level_words(level: float) -> Message:
    return Message("checks.water_level", level=Measure("height", level))


def criteria_of_network(network: Network) -> Criteria:
    """Gather all that a file of points and lines asks of them; as `criteria_of`."""
    return criteria_of(network)


def _network_states(
    rest: LinesAtRest, gone: Sequence[NetworkOut]
) -> Iterator[tuple[Place, LinesAtRest | None, tuple[int, ...], str]]:
    """Yield each state with the lines at rest and their numbers, from 0."""
    yield Place(), rest, tuple(range(len(rest.runs))), ""
    for each in gone:
        place = Place("one_line_out", missing=each.missing + 1)
        yield place, each.rest, each.left, each.refusal


def _strengths(
    criteria: Criteria, network: Network, rest: LinesAtRest, states: Sequence[State]
) -> tuple[tuple[Strength, ...], ...]:
    """Find the strengths of all lines as they run, from their anchors; InputError names the keys.

    A line that was given from its other end has its segments the other way round in the file.
    """
    found, problems = [], list[Problem]()
    for k, (run, given) in enumerate(zip(rest.runs, network.lines, strict=True)):
        try:
            found.append(criteria.strengths(run.line, {"extreme"}, states))
        except InputError as error:
            is_turned = network.numbers[given.start] != run.first
            last = len(run.line.segments) - 1 if is_turned else None
            problems += (replace(each, key=_key(each.key, k, last)) for each in error.problems)
    if problems:
        raise InputError(tuple(problems), "checks")
    return tuple(found)


def _key(key: str, line: int, last: int | None) -> str:
    """Name a key of a line as the file has it; `last`: its last segment, where it is turned."""

    def placed(found: re.Match[str]) -> str:
        number = int(found[1])
        return f"lines[{line}].segments[{number if last is None else last - number}]"

    return re.sub(r"^line\.segments\[(\d+)\]", placed, key)


def _of_states(rest: LinesAtRest, gone: Sequence[NetworkOut]) -> Iterator[Message]:
    """Say that the body stays where it is held, and which lines hang loose without another."""
    if rest.has_held_body:
        yield Message("checks.held_line_out")
    for each in gone:
        if each.loose:
            loose = ", ".join(f"{number + 1}" for number in each.loose)
            yield Message("checks.loose", number=each.missing + 1, lines=loose)
        if each.stopped_short:
            yield each.why_lost


def _of_anchors(criteria: Criteria, rest: LinesAtRest) -> Iterator[Message]:
    """Say which anchors are not judged: of rows from anchor to anchor, the farther one."""
    points = rest.network.points
    if all(each.check == "tension" for each in criteria.all):
        return
    for number, run in enumerate(rest.runs, start=1):
        if points[run.second].kind == "anchor":
            name = points[run.second].name
            yield Message("checks.anchor_not_judged", number=number, name=name)


def _of_fairleads(network: Network) -> Iterator[Message]:
    """Say which fairleads lie below the keel or above the deck of a body, as it floats unpulled."""
    depth = network.site.water_depth
    for body in network.bodies:
        if not body.floats:
            continue
        _, draught, freeboard = body.afloat
        over = {p.name: p.place[2] - depth for p in network.points if p.body == body.name}
        for key, ways in (
            ("below_keel", {name: -height - draught for name, height in over.items()}),
            ("above_deck", {name: height - freeboard for name, height in over.items()}),
        ):
            beyond = {name: way for name, way in ways.items() if way > ROUNDING * depth}
            if beyond:
                yield Message(
                    f"mooring.fairleads_{key}",
                    name=body.name,
                    draught=draught,
                    freeboard=freeboard,
                    depth=depth,
                    points=", ".join(beyond),
                    by=max(beyond.values()),
                )


def _of_joints(rest: LinesAtRest) -> Iterator[Message]:
    """Say which joints something pulls out of the water."""
    depth = rest.network.site.water_depth
    for point, (_, _, height) in zip(rest.network.points, rest.joints.places, strict=True):
        if point.kind == "joint" and height > depth:
            yield Message("mooring.joint_above_water", name=point.name, height=height - depth)
