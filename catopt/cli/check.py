"""``catopt check``: what a line withstands and keeps, by codes and by the case's own numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.completion import codes, completed
from catopt.cli.options import (
    CaseArgument,
    DesignOption,
    JsonOption,
    LangOption,
    ReportLanguage,
    TablesOutOption,
)

if TYPE_CHECKING:
    from catopt.model import Case

FAILED = 3
"""Of --strict: the input is right, but the line does not keep what is asked of it."""


def check(
    context: typer.Context,
    case: CaseArgument,
    code: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME",
            autocompletion=completed(codes),
            help="Profile of criteria, such as IALA-CALMAR; several may be given. In place of the "
            "codes of the case; its own numbers stay. docs/checks.md has them all.",
        ),
    ] = None,
    recalled: Annotated[
        bool,
        typer.Option("--recalled", help="Also allow profiles that were read in no document (R)."),
    ] = False,
    design: DesignOption = None,
    strict: Annotated[
        bool,
        typer.Option(
            "--strict", help="End with exit status 3 when a check fails; the answer is printed."
        ),
    ] = False,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
) -> None:
    """Check a line under every load case, or the lines of a body in every state.

    Prints demand, capacity and utilisation of every check with its source, and which one governs.
    A check that fails is an answer: the exit status is 0 unless --strict is given.
    """
    from catopt.answers.check import check_answer, verdict_sentence
    from catopt.casefile.design_directory import read_case_or_design
    from catopt.checks.case import check_case
    from catopt.cli.result_files import Asked

    asked = Asked(context.obj, lang, as_json, out)
    read = _with_codes(read_case_or_design(case, design), code, recalled=recalled)
    report = check_case(read)
    asked.give(check_answer(report), report.to_dict, read)
    if strict and not report.passes:
        asked.output.note(f"catopt: {verdict_sentence(report)}")
        raise typer.Exit(FAILED)


def _with_codes(case: Case, codes: list[str] | None, *, recalled: bool) -> Case:
    """Put the options in place of the case's codes; a wrong one is told by its option."""
    from dataclasses import replace

    from catopt.checks.profiles import profiles_of
    from catopt.errors import InputError, Problem

    checks = replace(case.checks, allow_recalled=case.checks.allow_recalled or recalled)
    if codes:
        checks = replace(checks, codes=tuple(codes))
        try:
            profiles_of(checks)
        except InputError as error:
            problems = [Problem("--code", each.found, each.allowed) for each in error.problems]
            raise InputError(problems, "options") from error
    return replace(case, checks=checks)
