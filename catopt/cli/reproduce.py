"""``catopt reproduce``: published figures beside catopt's own."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.completion import completed, studies
from catopt.cli.options import JsonOption, LangOption, OutOption, ReportLanguage

if TYPE_CHECKING:
    from catopt.reproduce import Reproduction


def reproduce(
    context: typer.Context,
    name: Annotated[
        str | None,
        typer.Argument(
            metavar="NAME",
            autocompletion=completed(studies),
            help="One study, such as buoy_9p5m; all when left out.",
        ),
    ] = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Recompute published figures and judge each printed number.

    A number reproduces when catopt's, rounded to the printed decimals, has every printed digit.
    """
    from catopt.answers.reproduction import reproduction_answer
    from catopt.cli.result_files import Asked
    from catopt.reproduce import reproduce as recompute

    asked = Asked(context.obj, lang, as_json, out)
    with asked.output.progress("Swarm runs") as tell:
        result = recompute(name, progress=tell)
    asked.give(reproduction_answer(result), result.to_dict, further=partial(_further, result))


def _further(result: Reproduction) -> dict[str, bytes]:
    """Make the book, and the drawings of the studies."""
    from catopt.report.bundle import reproduction_pictures
    from catopt.reproduce import book

    return {"reproduction.md": book(result).encode()} | reproduction_pictures(result)
