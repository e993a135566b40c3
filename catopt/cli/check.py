"""``catopt check``: what a line withstands and keeps, by codes and by the case's own numbers."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from catopt.answers.check import check_answer
from catopt.casefile.reading import read_mooring_or_design
from catopt.cli.answering import FAILED, Asked, answering
from catopt.cli.completion import completed
from catopt.cli.options import CaseArgument, DesignOption, StrictOption, TablesOutOption
from catopt.cli.values import by_option
from catopt.model.network import Network

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
    """Check a line under every load case, or the lines of a mooring in every state."""
    from catopt.checks.case import check_case
    from catopt.checks.profiles import profiles_of

    asked.check_place()
    read = read_mooring_or_design(case, design)
    checks = replace(read.checks, allow_recalled=read.checks.allow_recalled or recalled)
    if code:
        checks = replace(checks, codes=tuple(code))
        with by_option(lambda _: "--code"):
            profiles_of(checks)
    read = replace(read, checks=checks)
    of_points = isinstance(read, Network)
    report = check_case(read)
    asked.give(check_answer(report, of_points=of_points), report.to_dict, read)
    if strict and not report.verdict:
        asked.leave(FAILED, report.judgement.said)
