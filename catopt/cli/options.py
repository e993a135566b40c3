"""Options that several commands share."""

from __future__ import annotations

import os
from enum import StrEnum
from pathlib import Path
from typing import Annotated, Literal

import typer


class ReportLanguage(StrEnum):
    """Language of what a person reads."""

    ENGLISH = "en"
    VIETNAMESE = "vi"


LANGUAGE_VARIABLE = "CATOPT_LANG"
"""Environment variable with the language of a user who does not type it each time."""


def in_environment() -> Literal["en", "vi"]:
    """Language that the environment names; English where it names none, or none that there is."""
    return "vi" if os.environ.get(LANGUAGE_VARIABLE, "").strip() == "vi" else "en"


JsonOption = Annotated[
    bool,
    typer.Option(
        "--json",
        help="Print one JSON document on standard output and nothing else there.",
    ),
]

OutOption = Annotated[
    Path | None,
    typer.Option(
        "--out",
        metavar="DIR",
        help="Also write tables (CSV and one .xlsx), figures and the JSON document here. "
        "Files of the same name are replaced.",
    ),
]

TablesOutOption = Annotated[
    Path | None,
    typer.Option(
        "--out",
        metavar="DIR",
        help="Also write tables (CSV and one .xlsx) and the JSON document here. Files of the same "
        "name are replaced.",
    ),
]

CaseArgument = Annotated[
    Path,
    typer.Argument(
        metavar="CASE",
        help="Case file (TOML), or an input file of another program; with --design a directory "
        "that catopt design --out wrote.",
    ),
]

DesignOption = Annotated[
    int | None,
    typer.Option(
        "--design",
        metavar="K",
        help="Take design K of the front in the result directory CASE, by its number there.",
    ),
]

OnceOption = Annotated[
    bool,
    typer.Option(
        "--once",
        help="Of --dynamic: run the line once, without the proof at half the step; the answer says "
        "so.",
    ),
]

LangOption = Annotated[
    ReportLanguage,
    typer.Option(
        "--lang",
        metavar="LANGUAGE",
        envvar=LANGUAGE_VARIABLE,
        help="Language of the tables and of the workbook: en, or vi for Vietnamese. JSON and CSV "
        "are the same in both.",
    ),
]
