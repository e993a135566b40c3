"""Check a body with several lines: every line, with all there and with each of them gone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from catopt.checks.criteria import HORIZONTAL_PULL, Criteria, criteria_of
from catopt.checks.criterion import Criterion, Place, State
from catopt.checks.evaluation import check_buoyancy, evaluate
from catopt.checks.remarks import Lifted, of_criteria, of_transient, of_uplift
from catopt.checks.result import CheckReport, CheckResult, line_in_state
from catopt.checks.strength import Strength
from catopt.model import Anchor, Case, Line
from catopt.mooring.case import SystemReport, report_system
from catopt.mooring.line_out import LineOut, one_line_out
from catopt.mooring.solution import SystemSolution
from catopt.words import Message


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
    assert case.system is not None
    criteria = criteria_of(case)
    legs = case.system.legs
    damaged = for_line_out(criteria, len(legs)) if case.system.judged_line_out else ()
    wanted: tuple[State, ...] = ("intact", "one_line_out") if damaged else ("intact",)
    known = {line: criteria.strengths(line, {"extreme"}, wanted) for line in {e.line for e in legs}}
    report = report or report_system(case)
    lost = report.line_out or one_line_out(case.system) if damaged else ()
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
        *(warning for told in lines.values() for warning in told),
        *(
            of_line_out(criteria, damaged, len(legs))
            if case.system.judged_line_out
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
    yield from _of_the_body(state, criteria)


def for_line_out(criteria: Criteria, lines: int) -> tuple[Criterion, ...]:
    """List the criteria for one line out; of one line, those that are for nothing else."""
    return tuple(
        each
        for each in criteria.all
        if "one_line_out" in each.states and (lines > 1 or "intact" not in each.states)
    )


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
            excess=1.0,
            source=source,
            note=refusal,
            place=place,
        )


def _of_the_body(state: InState, criteria: Criteria) -> Iterator[CheckResult]:
    """Hold the vertical pull of all lines against the reserve of buoyancy, if that is given."""
    assert state.solution is not None
    pulls = (line.solution.fairlead.vertical_force for line in state.solution.lines)
    yield from check_buoyancy(pulls, criteria, state.name, state.place)


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
