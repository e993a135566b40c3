"""Options that several commands share, and what is read for a command."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from catopt.errors import InputError, Problem
from catopt.model.kinds import Findings
from catopt.numerals import bare_number
from catopt.units import Dimension, as_written, to_si
from catopt.words import Message
from catopt.words.texts import LANGUAGES, Language

if TYPE_CHECKING:
    from catopt.model import Case

LANGUAGE_VARIABLE = "CATOPT_LANG"
"""Environment variable with the language of a user who does not type it each time."""


def in_environment() -> Language:
    """Language that the environment names; English where it names none, or none that there is."""
    named = os.environ.get(LANGUAGE_VARIABLE, "").strip()
    return next((each for each in LANGUAGES if each == named), "en")


def asked_language(arguments: Sequence[str]) -> Language:
    """Language that is asked for, before any of the arguments is read.

    By ``--lang`` among them, or by the environment where they name none that there is.
    """
    typed = [each.removeprefix("--lang=") for each in arguments if each.startswith("--lang=")]
    typed += [each for option, each in pairwise(arguments) if option == "--lang"]
    known = [each for each in LANGUAGES if each in typed]
    return known[-1] if known else in_environment()


LangOption = Annotated[
    Language, typer.Option("--lang", metavar="LANGUAGE", envvar=LANGUAGE_VARIABLE)
]
UnitsOption = Annotated[
    Literal["tf", "kN", "si"] | None,
    typer.Option("--units", metavar="UNITS", envvar="CATOPT_UNITS", show_envvar=False),
]
JsonOption = Annotated[bool, typer.Option("--json")]
FullOption = Annotated[bool, typer.Option("--full", envvar="CATOPT_FULL", show_envvar=False)]
OutOption = Annotated[Path | None, typer.Option("--out", metavar="DIR")]
TablesOutOption = Annotated[Path | None, typer.Option("--out", metavar="DIR", help="tables_out")]
PlaceOption = Annotated[Path | None, typer.Option("--out", metavar="PLACE")]

CaseArgument = Annotated[Path, typer.Argument(metavar="CASE")]
DesignOption = Annotated[int | None, typer.Option("--design", metavar="K")]
LoadCaseOption = Annotated[str | None, typer.Option("--load-case", metavar="NAME")]
StrictOption = Annotated[bool, typer.Option("--strict")]
OnceOption = Annotated[bool, typer.Option("--once")]
CountOption = Annotated[int | None, typer.Option(metavar="N")]
LengthOption = Annotated[str | None, typer.Option(metavar="LENGTH")]
ForceOption = Annotated[str | None, typer.Option(metavar="FORCE")]


def refused(option: str, found: str, allowed: str) -> InputError:
    """Make the error of one option that is wrong."""
    return InputError([Problem(option, found, allowed)], "options")


def refuse(problems: Iterable[Problem]) -> None:
    """Raise InputError with what is wrong with options, if anything is."""
    every = tuple(problems)
    if every:
        raise InputError(every, "options")


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


def positive(
    found: Findings, option: str, text: str | None, dimension: Dimension, unit: str
) -> float | None:
    """Read an option above 0 in SI; None where it is left out or, which is noted, wrong."""
    try:
        value = in_si({option: (text, dimension)}).get(option)
    except InputError as error:
        found.problems += error.problems
        return None
    if value is not None:
        found.number(option, value, unit, above=0.0)
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
        problems = [replace(each, key=option(each.key)) for each in error.problems]
        raise InputError(problems, source or error.source) from error


def read_known(path: Path, design: int | None = None) -> Case:
    """Read a case, or a design of a result directory, whose codes all are known and allowed."""
    from catopt.casefile.reading import read_case_or_design

    return with_known_codes(read_case_or_design(path, design))


def with_known_codes(case: Case) -> Case:
    """Return a case whose codes all are known and allowed, also where none is judged by."""
    if case.checks.codes:
        from catopt.checks.profiles import profiles_of

        profiles_of(case.checks)
    return case


def in_state(case: Case, name: str | None) -> Case:
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
