"""``catopt check``: what a line withstands and keeps, by codes and by the case's own numbers."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.answering import FAILED, Asked, answering
from catopt.cli.completion import completed
from catopt.cli.options import CaseArgument, DesignOption, StrictOption, TablesOutOption
from catopt.errors import InputError, Problem

if TYPE_CHECKING:
    from catopt.model import Case

_CODE = typer.Option(metavar="NAME", autocompletion=completed("code"))


@answering(TablesOutOption)
def check(
    asked: Asked,
    case: CaseArgument,
    code: Annotated[list[str] | None, _CODE] = None,
    recalled: Annotated[bool, typer.Option("--recalled")] = False,
    design: DesignOption = None,
    strict: StrictOption = False,
) -> None:
    """Check a line under every load case, or the lines of a body in every state."""
    from catopt.answers.check import check_answer, verdict_sentence
    from catopt.casefile.design_directory import read_case_or_design
    from catopt.checks.case import check_case

    asked.check_place()
    read = _with_codes(read_case_or_design(case, design), code, recalled=recalled)
    report = check_case(read)
    asked.give(check_answer(report), report.to_dict, read)
    if strict and not report.passes:
        asked.leave(FAILED, verdict_sentence(report))


def _with_codes(case: Case, codes: list[str] | None, *, recalled: bool) -> Case:
    """Put the options in place of the case's codes; a wrong one is told by its option."""
    from catopt.checks.profiles import profiles_of

    checks = replace(case.checks, allow_recalled=case.checks.allow_recalled or recalled)
    if codes:
        checks = replace(checks, codes=tuple(codes))
        try:
            profiles_of(checks)
        except InputError as error:
            problems = [Problem("--code", each.found, each.allowed) for each in error.problems]
            raise InputError(problems, "options") from error
    return replace(case, checks=checks)
