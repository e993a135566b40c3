"""Check a case in every load case, and how far its segments may wear."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace

from catopt.catenary.case import as_found, solve_case
from catopt.catenary.solution import Solution
from catopt.checks.criteria import Criteria, allowed_by, criteria_of
from catopt.checks.evaluation import (
    IN_LOAD_CASE,
    Lifted,
    evaluate,
    in_load_case,
    of_criteria,
    of_other_states,
    of_uplift,
)
from catopt.checks.kinds import (
    ROUNDING,
    Criterion,
    Place,
    State,
)
from catopt.checks.result import CheckReport, CheckResult
from catopt.errors import FloatsUpError, NoEquilibriumError, NotConvergedError
from catopt.model import Anchor, Case, Line, LoadCase, Segment, Service
from catopt.model.load import LoadCaseKind
from catopt.words import Message

LOAD = "load"
"""Name of the load case of a case that has only its ``[load]``."""


def check_line(line: Line, case: Case, anchor: Anchor | None = None) -> CheckReport:
    """Check another line, such as one that a search has found, in the place of a case's own.

    So an anchor, where one is given.
    """
    return check_case(replace(case, line=line, anchor=anchor or case.anchor))


def check_case(case: Case) -> CheckReport:
    """Check a case by every criterion under every load case, or a body in every state.

    The line is solved in closed form; the lines of a body are checked with all there and with each
    of them gone in turn, each state by the criteria for it. A line without load cases is checked
    under its load, as an extreme one; where the case seeks something, the line that was found is
    checked.

    Parameters
    ----------
    case : Case
        As read by `catopt.read_case`.

    Returns
    -------
    CheckReport
        A check that is failed is a result, too.

    Raises
    ------
    InputError
        A code is not known, or a criterion needs a strength, a diameter or a factor that is
        missing; all of them at once.
    NoEquilibriumError, NotConvergedError
        As for `solve`; the message names the load case.
    """
    if case.system is not None:
        from catopt.checks.system import check_system

        return check_system(case)
    case = as_found(case)
    criteria = criteria_of(case)
    states = case.load_cases or (LoadCase(LOAD, 1.0),)
    kinds, of_mooring = {each.kind for each in states}, {each.state for each in states}
    strengths = criteria.strengths(case.line, kinds, of_mooring)
    of_condition = {
        each: criteria.in_condition(each).strengths(case.line, kinds, of_mooring)
        for each in {state.condition for state in states}
    }
    results: list[CheckResult] = []
    solutions: list[tuple[str, Solution]] = []
    lifted: list[Lifted] = []
    for each in states:
        name, kind, place = each.name, each.kind, Place(each.state)
        with _under(name):
            solution = solve_case(case.under(each) if case.load_cases else case)
        solutions.append((name, solution))
        where = Message("checks.named_case" if case.load_cases else "checks.under_load", name=name)
        lifted.append(Lifted(where, each.state, kind, solution))
        results += evaluate(
            solution,
            criteria,
            of_condition[each.condition],
            case.anchor,
            load_case=name,
            kind=kind,
            place=place,
        )
    return CheckReport(
        title=case.title,
        results=tuple(results),
        solutions=tuple(solutions),
        warnings=(
            *of_criteria(criteria, case.line, strengths),
            *(() if "one_line_out" in of_mooring else of_other_states(criteria)),
            *of_uplift(lifted, criteria, case.anchor),
            *_warned(solutions),
        ),
        load_cases=case.load_cases,
    )


@contextmanager
def _under(load_case: str) -> Iterator[None]:
    """Name the load case in what goes wrong."""
    try:
        yield
    except NoEquilibriumError as error:
        said = in_load_case(load_case, error.args[0])
        raise NoEquilibriumError(said, error.quantity, error.missing) from error
    except (FloatsUpError, NotConvergedError) as error:
        raise type(error)(in_load_case(load_case, error.args[0])) from error


def is_of_load(warning: str) -> bool:
    """Whether a warning is of the load of a case without load cases."""
    return (
        isinstance(warning, Message)
        and warning.key == IN_LOAD_CASE
        and warning.values["name"] == LOAD
    )


def _warned(solutions: Sequence[tuple[str, Solution]]) -> Iterator[str]:
    """Pass on what is to be known of each equilibrium."""
    for name, solution in solutions:
        for warning in solution.warnings:
            yield in_load_case(name, warning)


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
