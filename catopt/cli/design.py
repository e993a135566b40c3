"""``catopt design``: the lines that are best in mass and offset at once."""

from __future__ import annotations

from enum import StrEnum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.options import JsonOption, LangOption, OutOption, ReportLanguage

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.design.result import DesignResult
    from catopt.model import Case

INTERRUPTED = 130
"""128 + SIGINT; the front so far is printed all the same."""


class SearchMethod(StrEnum):
    """How the designs are searched."""

    AUTO = "auto"
    ENUMERATION = "enumeration"
    NSGA2 = "nsga2"
    SWARM = "swarm"


def design(
    context: typer.Context,
    case: Annotated[
        Path, typer.Argument(metavar="CASE", help="Case file (TOML) with a table [design].")
    ],
    method: Annotated[
        SearchMethod | None,
        typer.Option(
            metavar="METHOD",
            help="enumeration of every design, nsga2, swarm, or auto: enumeration where it is "
            "quick enough; overrides the case.",
        ),
    ] = None,
    evaluations: Annotated[
        int | None,
        typer.Option(metavar="N", help="nsga2 and swarm: designs evaluated; overrides the case."),
    ] = None,
    seed: Annotated[
        int | None, typer.Option(metavar="N", help="nsga2 and swarm: seed; overrides the case.")
    ] = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Search the lines that are best in mass and offset at once.

    Every line is made of components that are sold and passes every check in every load case; the
    answer is the front between the objectives, with one design recommended. Ctrl-C ends the search
    and keeps the front so far (exit status 130).
    """
    from catopt.answers.design import design_answer
    from catopt.cli.result_files import Asked, refuse_own_case

    asked = Asked(context.obj, lang, as_json, out)
    if out is not None:
        refuse_own_case(out)
    result = _searched(_asked(case, method, evaluations, seed), asked.output)
    asked.give(design_answer(result), result.to_dict, further=partial(_further, result))
    if result.interrupted:
        asked.output.note("The front is that of the designs evaluated so far.")
        raise typer.Exit(INTERRUPTED)


def _asked(
    path: Path, method: SearchMethod | None, evaluations: int | None, seed: int | None
) -> Case:
    """Read the case and put the options in place of its settings."""
    from dataclasses import replace

    from catopt.casefile import read_case
    from catopt.cli.values import by_option
    from catopt.errors import InputError, Problem

    case = read_case(path)
    if case.design is None:
        allowed = "missing; a table [design] says what may vary (docs/case-file.md)"
        raise InputError([Problem("design", "", allowed)], str(path))
    options: dict[str, Any] = {
        "method": None if method is None else method.value,
        "evaluations": evaluations,
        "seed": seed,
    }
    given = {key: value for key, value in options.items() if value is not None}
    with by_option():
        return replace(case, design=replace(case.design, **given))


def _searched(case: Case, output: Output) -> DesignResult:
    from catopt.design.near_miss import NoFeasibleDesignError
    from catopt.design.search import design_case

    try:
        with output.progress("Designs") as tell:
            result = design_case(case, progress=tell, announce=output.note)
    except NoFeasibleDesignError as error:
        if not error.interrupted:
            raise
        # Of those that were not evaluated one may pass, which status 3 would deny.
        output.note(f"catopt: {error}")
        raise typer.Exit(INTERRUPTED) from None
    # Beside the answer, not in it: the same seed is to give the same answer to the last byte.
    output.note(f"{result.evaluations:,} designs evaluated in {result.seconds:.1f} s")
    return result


def _further(result: DesignResult) -> dict[str, bytes]:
    """Draw the front, and write the case that ``catopt solve DIR --design K`` needs."""
    from catopt.casefile import write_case
    from catopt.casefile.design_directory import DESIGN_CASE
    from catopt.report.bundle import design_pictures

    return design_pictures(result) | {DESIGN_CASE: write_case(result.case).encode()}
