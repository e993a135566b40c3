"""Check a case: every criterion in every load case, on the line in closed form."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Final

from catopt.catenary.case import solve_case
from catopt.catenary.solution import Solution
from catopt.checks.criteria import Criteria, criteria_of
from catopt.checks.evaluation import evaluate, segment_words
from catopt.checks.result import CheckReport, CheckResult
from catopt.checks.strength import Strength
from catopt.errors import (
    FloatsUpError,
    InputError,
    NoEquilibriumError,
    NotConvergedError,
    Problem,
)
from catopt.model import Anchor, Case, Line, Load
from catopt.model.load_case import LoadCaseKind
from catopt.words import Message

__all__ = ["LOAD", "NO_CHECK", "check_case", "check_line", "is_of_load"]

LOAD = "load"
"""Name of the load case of a case that has only its ``[load]``."""

NO_CHECK: Final = "checks.none"
"""Key of the warning that nothing is checked."""

IN_LOAD_CASE: Final = "checks.in_load_case"
"""Key of what is said of one load case."""


def check_line(line: Line, case: Case, anchor: Anchor | None = None) -> CheckReport:
    """Check another line in the place of a case's own.

    Parameters
    ----------
    line : Line
        Such as one that a search has found.
    case : Case
        Site, load cases and criteria.
    anchor : Anchor, optional
        In the place of the case's own.
    """
    return check_case(replace(case, line=line, anchor=anchor or case.anchor))


def check_case(case: Case) -> CheckReport:
    """Check a case by every criterion under every load case.

    The line is solved in closed form. Without load cases it is checked under its load, as an
    extreme one; where the case seeks something, the line that was found is checked.

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
    case = _found(case)
    criteria = criteria_of(case)
    strengths = _strengths(case.line, criteria, {kind for (_, kind), _ in _states(case)})
    results: list[CheckResult] = []
    solutions: list[tuple[str, Solution]] = []
    for (name, kind), state in _states(case):
        with _under(name):
            solution = solve_case(state)
        solutions.append((name, solution))
        results += evaluate(solution, criteria, strengths, case.anchor, load_case=name, kind=kind)
    return CheckReport(
        title=case.title,
        results=tuple(results),
        solutions=tuple(solutions),
        warnings=(*_warnings(case, criteria, strengths), *_warned(solutions)),
        load_cases=case.load_cases,
    )


def _found(case: Case) -> Case:
    """Put what a case seeks in its place, so that it is an ordinary case."""
    if case.find is None:
        return case
    solution = solve_case(case)
    load = Load(horizontal_force=solution.horizontal_force)
    return replace(case, line=solution.line, load=load, find=None)


def _states(case: Case) -> Iterator[tuple[tuple[str, LoadCaseKind], Case]]:
    """Yield name and kind of every load case, with the case in that state."""
    for state in case.load_cases:
        yield (state.name, state.kind), case.under(state)
    if not case.load_cases:
        yield (LOAD, "extreme"), case


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


def in_load_case(load_case: str, said: str) -> Message:
    """Say of which load case something is said."""
    return Message(IN_LOAD_CASE, name=load_case, said=said)


def is_of_load(warning: str) -> bool:
    """Whether a warning is of the load of a case without load cases."""
    return (
        isinstance(warning, Message)
        and warning.key == IN_LOAD_CASE
        and warning.values["name"] == LOAD
    )


def _strengths(line: Line, criteria: Criteria, kinds: set[LoadCaseKind]) -> tuple[Strength, ...]:
    """Find the strength of every segment; all that is missing is told at once."""
    problems: dict[Problem, None] = {}
    strengths = []
    for index, segment in enumerate(line.segments):
        key = f"line.segments[{index}]"
        try:
            strength = criteria.strength(segment, key)
        except InputError as error:
            problems |= dict.fromkeys(error.problems)
            continue
        strengths.append(strength)
        problems |= dict.fromkeys(criteria.lacking(strength, kinds, key))
    if problems:
        raise InputError(tuple(problems), "checks")
    return tuple(strengths)


def _warnings(case: Case, criteria: Criteria, strengths: Sequence[Strength]) -> Iterator[str]:
    """Say what an engineer should know of the criteria."""
    if not criteria.all:
        yield Message(NO_CHECK)
    yield from criteria.warnings
    for index, strength in enumerate(strengths):
        covered = any(
            each.check == "tension" and each.is_for(strength.kind) for each in criteria.all
        )
        if criteria.all and not covered:
            words = segment_words(case.line.segments[index], index)
            yield Message("checks.no_strength_criterion", segment=words)


def _warned(solutions: Sequence[tuple[str, Solution]]) -> Iterator[str]:
    """Pass on what is to be known of each equilibrium."""
    for name, solution in solutions:
        for warning in solution.warnings:
            yield in_load_case(name, warning)
