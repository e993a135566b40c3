"""What is read for a command: options with units, and the case in the state that it asks for."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from catopt.errors import InputError, Problem
from catopt.model.kinds import Findings
from catopt.units import Dimension, as_written, bare_number, to_si
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.model import Case
    from catopt.model.network import Network

Moored = TypeVar("Moored", bound="Case | Network")


def refused(option: str, found: str, allowed: str) -> InputError:
    """Make the error of one option that is wrong."""
    return InputError([Problem(option, found, allowed)], "options")


def refuse(problems: Iterable[Problem]) -> None:
    """Raise InputError with what is wrong with options, if anything is."""
    every = tuple(problems)
    if every:
        raise InputError(every, "options")


def for_one_line(given: Mapping[str, object]) -> None:
    """Refuse options, by their names, that only one line has; None is not given."""
    why = Message("refused_command.for_one_line")
    refuse(
        Problem(f"--{key}", str(value), why) for key, value in given.items() if value is not None
    )


def in_si(given: Mapping[str, tuple[str | None, Dimension]]) -> dict[str, float]:
    """Read options, by their names, in SI: each a bare number or one with a unit, or left out.

    Raises InputError with every one that is wrong.
    """
    values: dict[str, float] = {}
    problems: list[Problem] = []
    for option, (text, dimension) in given.items():
        if text is None:
            continue
        try:
            values[option] = to_si(bare_number(text), dimension, option)
        except InputError as error:
            problems += error.problems
    refuse(problems)
    return values


def positive(found: Findings, option: str, text: str | None, of: Dimension) -> float | None:
    """Read an option above 0 in SI; None where it is left out or, which is noted, wrong."""
    try:
        value = in_si({option: (text, of)}).get(option)
    except InputError as error:
        found.problems += error.problems
        return None
    if value is not None:
        found.number(option, value, of.si_unit, above=0.0)
    return value


def given_ones(**options: Any) -> dict[str, Any]:
    """Return the options that were given."""
    return {name: value for name, value in options.items() if value is not None}


@contextmanager
def by_option(
    option: Callable[[str], str] = "--{}".format, source: str = "options"
) -> Iterator[None]:
    """Tell what is wrong with a setting by its option: that of its name, if none other is named."""
    try:
        yield
    except InputError as error:
        problems = [replace(problem, key=option(problem.key)) for problem in error.problems]
        raise InputError(problems, source or error.source) from error


def with_known_codes(case: Moored) -> Moored:
    """Return a case whose codes all are known and allowed, also where none is judged by."""
    if case.checks.codes:
        from catopt.checks.profiles import profiles_of

        profiles_of(case.checks)
    return case


def in_state(case: Any, name: str | None) -> Any:
    """Return a case under the load case that ``--load-case`` names; as it is without a name.

    Raises InputError where the case has no such load case, or seeks something.
    """
    if name is None:
        return case
    states = {state.name: state for state in case.load_cases}
    if name in states and case.find is None:
        return case.under(states[name])
    allowed = Message("refused_command.case_has_no_load_cases")
    if name in states and case.find is not None:
        allowed = Message(
            "refused_command.case_seeks_something_leave_out", quantity=case.find.quantity
        )
    elif states:
        allowed = Message("refused.one_of", words=", ".join(states))
    raise refused("--load-case", as_written(name), allowed)
