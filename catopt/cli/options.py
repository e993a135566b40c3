"""Options that several commands share; their words, as all of the help, are in ``help.toml``."""

from __future__ import annotations

import os
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Literal

import typer

from catopt.words.message import LANGUAGES, Language

LANGUAGE_VARIABLE = "CATOPT_LANG"
"""Environment variable with the language of a user who does not type it each time."""


def in_environment() -> Language:
    """Language that the environment names; English where it names none, or none that there is."""
    named = os.environ.get(LANGUAGE_VARIABLE, "").strip()
    return next((language for language in LANGUAGES if language == named), "en")


def asked_language(arguments: Sequence[str]) -> Language:
    """Language that is asked for, before any of the arguments is read.

    By ``--lang`` among them, or by the environment where they name none that there is.
    """
    typed = [
        argument.removeprefix("--lang=") for argument in arguments if argument.startswith("--lang=")
    ]
    typed += [argument for option, argument in pairwise(arguments) if option == "--lang"]
    known = [language for language in LANGUAGES if language in typed]
    return known[-1] if known else in_environment()


LangOption = Annotated[
    Language, typer.Option("--lang", metavar="LANGUAGE", envvar=LANGUAGE_VARIABLE)
]
UnitsOption = Annotated[
    Literal["tf", "kN", "si"] | None,
    typer.Option("--units", metavar="UNITS", envvar="CATOPT_UNITS"),
]
JsonOption = Annotated[bool, typer.Option("--json")]
FullOption = Annotated[bool, typer.Option("--full", envvar="CATOPT_FULL")]
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
