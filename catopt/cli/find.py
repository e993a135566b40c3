"""``catopt find``: which value of a number of a file gives what is asked of its answer."""

from __future__ import annotations

from typing import Annotated

import typer

from catopt.answers.finding import finding_answer
from catopt.cli.answering import Asked, answering
from catopt.cli.options import CaseArgument, OutOption


@answering(OutOption)
def find(
    asked: Asked,
    case: CaseArgument,
    key: Annotated[str, typer.Argument(metavar="KEY")],
    until: Annotated[str, typer.Option(metavar="PART.QUANTITY=VALUE")],
    start: Annotated[str | None, typer.Option("--from", metavar="VALUE")] = None,
    stop: Annotated[str | None, typer.Option("--to", metavar="VALUE")] = None,
) -> None:
    """Find every value of one number of a file that gives what is asked of its answer."""
    from catopt.study.finding import find_value

    asked.check_place(for_case=True)
    found = find_value(case, key, until, start, stop)
    asked.give(finding_answer(found), found.to_dict, found.mooring())
