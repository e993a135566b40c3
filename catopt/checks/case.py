"""Check a case in every load case, its lines in motion, and how far its segments may wear."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from catopt.catenary.case import STRENGTH_OF_NEW, as_found, solve_case
from catopt.catenary.solution import Solution
from catopt.checks.criteria import Criteria, criteria_of, motion_profile
from catopt.checks.evaluation import (
    IN_LOAD_CASE,
    Lifted,
    check_buoyancy,
    check_tensions,
    evaluate,
    in_load_case,
    of_codes,
    of_criteria,
    of_other_states,
    of_uplift,
    result_of,
)
from catopt.checks.kinds import (
    OF_LINE,
    USER,
    CheckKind,
    Demand,
    Place,
    State,
    ratio_exceedance,
)
from catopt.checks.profiles import profiles_of
from catopt.checks.result import CheckReport, CheckResult
from catopt.errors import FloatsUpError, InputError, NoEquilibriumError, NotConvergedError, Problem
from catopt.model import Anchor, Case, Line, LoadCase
from catopt.model.load import LoadCaseKind
from catopt.model.network import Network
from catopt.words import Listed, Message, is_said

LOAD = "load"
"""Name of the load case of a case that has only its ``[load]``."""


def check_line(line: Line, case: Case, anchor: Anchor | None = None) -> CheckReport:
    """Check another line, such as one that a search has found, in the place of a case's own.

    So an anchor, where one is given.
    """
    return check_case(replace(case, line=line, anchor=anchor or case.anchor))


def check_case(case: Case | Network) -> CheckReport:
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

    Examples
    --------
    >>> import catopt
    >>> report = catopt.check_case(catopt.read_case("cases/tanker-20m-sinker/case.toml"))
    >>> report.passes, [result.kind for result in report.results]
    (True, ['tension'])
    """
    if isinstance(case, Network):
        from catopt.checks.system import check_network

        return check_network(case)
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
        try:
            solution = solve_case(case.under(each) if case.load_cases else case)
        except NoEquilibriumError as error:
            said = in_load_case(name, said=error.args[0])
            raise NoEquilibriumError(said, error.quantity, error.missing) from error
        except (FloatsUpError, NotConvergedError) as error:
            raise type(error)(in_load_case(name, said=error.args[0])) from error
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
            *_of_solutions(solutions),
        ),
        load_cases=case.load_cases,
        case=case,
    )


def _of_solutions(solutions: Sequence[tuple[str, Solution]]) -> Iterator[Message]:
    """Yield what is to be known of equilibria, once for all load cases in which it is.

    That strengths are those of the new line is none of it: the checks take wear off them.
    """
    cases: dict[str, list[str]] = {}
    for name, solution in solutions:
        for said in solution.warnings:
            if not is_said(said, STRENGTH_OF_NEW):
                cases.setdefault(said, []).append(name)
    for said, names in cases.items():
        yield in_load_case(*names, said=said)


def is_of_load(warning: str) -> bool:
    """Whether a warning is of the load of a case without load cases."""
    return (
        isinstance(warning, Message)
        and warning.key == IN_LOAD_CASE
        and warning.values["name"] == LOAD
    )


class Pull(NamedTuple):
    """Largest forces at an end of a line, each by itself, N, and the largest angle, rad."""

    horizontal_force: float
    vertical_force: float
    angle: float


class Carried(NamedTuple):
    """What a line came to in motion: largest values each by itself, and the least on the bed."""

    anchor: Pull
    fairlead: Pull
    grounded_length: float
    """Least unstretched length on the bed, m."""
    span: float
    """Largest horizontal distance of its ends, m."""
    least_tension: float
    """At the fairlead, the least of all, N."""
    slide: float | None = None
    """Way that what holds it slides in the storm, m; None where that was not followed."""
    heel: float | None = None
    """Mean heel of the buoy at its end, rad; None of what is none."""


@dataclass(frozen=True)
class LineInMotion:
    """What a line that was run in time came to."""

    line: Line
    """Its segments from the anchor to the fairlead."""
    largest: tuple[float, ...]
    """Largest tension of each segment, N."""
    mean: tuple[float, ...] | None
    """Mean tension of each, that under the mean loads, N; None where it is not known, and the whole
    then takes the factor on what is dynamic."""
    load_case: str
    number: int | None = None
    """Of a body with several lines: which, from 1."""
    carried: Carried | None = None
    """What else is judged; None: its tensions alone."""
    one_parts: bool = True
    """Whether the line of the mooring that is to part does so in its runs."""

    @property
    def tensions(self) -> Iterator[tuple[float, float]]:
        """Largest tension of each segment, N, with the mean over it, from 0 to 1."""
        for largest, mean in zip(
            self.largest, self.mean or (0.0,) * len(self.largest), strict=True
        ):
            yield largest, min(1.0, mean / largest) if largest > 0.0 else 0.0


def check_motion(case: Case | Network, lines: Sequence[LineInMotion]) -> CheckReport:
    """Check lines in motion by the numbers of a case and the factors of the codes it names.

    A code's factors for dynamic analysis are taken; where it has none, those for lines at rest, or
    the case's `motion_code` in its place.
    Uplift, length on the bed, span, buoyancy and what holds the line are judged by the least
    favourable value of each at any step, as if they came together. A load case is judged in its own
    state and condition, as at rest; a run in which a line breaks in the transient state, and the
    broken line not at all, unless it broke by its tension.

    The lines are every line under every load case. InputError as for `check_case`.
    """
    criteria = criteria_of(case, analysis="dynamic")
    breaks, by_MBL = _broken(case), case.dynamics is not None and case.dynamics.broken_by == "MBL"
    broken = breaks if all(each.one_parts for each in lines) else None
    judged = [each for each in lines if broken is None or by_MBL or not _breaks(each, broken)]
    load_cases = {each.name: each for each in case.load_cases}
    load = LoadCase(LOAD, 1.0)
    results: list[CheckResult] = []
    for moved in judged:
        load_case = load_cases.get(moved.load_case, load)
        kind = load_case.kind
        gone = None if broken is None or _breaks(moved, broken) else broken
        state: State = load_case.state if gone is None else "transient"
        place = Place(state, moved.number, gone)
        in_condition = criteria.in_condition(load_case.condition)
        results += check_tensions(
            moved.line,
            list(criteria.of("tension", kind, state)),
            in_condition.strengths(moved.line, {kind}, {state}),
            moved.tensions,
            load_case=moved.load_case,
            place=place,
        )
        results += _others(case, criteria, moved, kind, place)
    if case.system is not None:
        # The largest vertical pulls of all lines, as if at one time, against the buoyancy.
        carried = [each.carried for each in judged if each.carried is not None]
        if judged and len(carried) == len(judged):
            pulls = (each.fairlead.vertical_force for each in carried)
            place = Place("intact" if broken is None else "transient", None, broken)
            results += check_buoyancy(pulls, criteria, judged[0].load_case, place)
    warnings = [*_of_codes(case, criteria)]
    if broken is not None:
        warnings.append(Message("checks.motion_breaks" if judged else "checks.motion_all_lost"))
    elif breaks is not None:
        warnings.append(Message("checks.motion_does_not_break"))
    on_mean = any(each.mean_factor is not None for each in criteria.all)
    if on_mean and any(each.mean is None for each in judged):
        warnings.append(Message("checks.motion_no_mean"))
    return CheckReport(
        case.title, tuple(results), (), tuple(warnings), case=case, is_in_motion=True
    )


def _breaks(moved: LineInMotion, broken: int) -> bool:
    """Whether a line is the one that breaks: the only one, or by its number."""
    return (moved.number or broken) == broken


def _others(
    case: Case | Network, criteria: Criteria, moved: LineInMotion, kind: LoadCaseKind, place: Place
) -> Iterator[CheckResult]:
    """Check what is not a tension, as of a line at rest."""
    if moved.carried is None:
        return
    for check, row in OF_LINE.items():
        if check != "buoyancy" or place.line is None:
            for criterion in criteria.of(check, kind, place.state):
                found = row.measure(criterion.value, moved.carried, case.anchor)
                yield result_of(check, criterion, found, moved.load_case, place)
    ways: tuple[tuple[CheckKind, float | None], ...] = (
        ("slide", moved.carried.slide),
        ("heel", moved.carried.heel),
    )
    for way, value in ways:
        if value is None:
            continue
        for criterion in criteria.of(way, kind, place.state):
            found = Demand(value, criterion.value, ratio_exceedance(value, criterion.value))
            yield result_of(way, criterion, found, moved.load_case, place)


def check_strengths(case: Case | Network) -> None:
    """Refuse, before lines are run in time, a case whose tensions cannot be judged.

    Raises what `check_motion` raises.
    """
    criteria = criteria_of(case, analysis="dynamic")
    kinds = {each.kind for each in case.load_cases} or {"extreme"}
    problems: list[Problem] = []
    for key, line in dict.fromkeys(case.keyed_lines):
        try:
            criteria.strengths(line, kinds, _states(case))
        except InputError as error:
            problems += (
                replace(p, key=p.key.replace("line.", f"{key}.", 1)) for p in error.problems
            )
    if problems:
        raise InputError(tuple(problems), "checks")


def _states(case: Case | Network) -> set[State]:
    """States of the mooring in which a case in motion is judged."""
    of_cases: set[State] = {each.state for each in case.load_cases} or {"intact"}
    if _broken(case) is None:
        return of_cases
    assert case.dynamics is not None
    return {"transient"} if case.dynamics.broken_by == "time" else {"transient", *of_cases}


def _broken(case: Case | Network) -> int | None:
    return None if case.dynamics is None else case.dynamics.broken_line


def _of_codes(case: Case | Network, criteria: Criteria) -> Iterator[Message]:
    """Say that no code is named, or which of those named have nothing for this."""
    if not case.checks.codes:
        yield Message("checks.motion_no_code")
        return
    at_rest_alone = [each.name for each in profiles_of(case.checks) if not each.is_for_motion]
    by = motion_profile(case.checks)
    if by is not None and at_rest_alone:
        yield Message("checks.motion_by_other", codes=Listed(at_rest_alone, "and"), code=by.name)
    tensions = [each for each in criteria.all if each.check == "tension" and each.source != USER]
    at_rest = (each.source.code for each in tensions if each.analysis != "dynamic")
    yield from of_codes("checks.motion_at_rest", at_rest)
    states = _states(case)
    judging = {each.source.code for each in tensions if states & set(each.states)}
    silent = (each.source.code for each in tensions if each.source.code not in judging)
    yield from of_codes("checks.motion_not_transient", silent)
