"""``catopt fatigue``: how long a line lasts in the sea states of a year."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.options import (
    JsonOption,
    LangOption,
    ReportLanguage,
    TablesOutOption,
)

if TYPE_CHECKING:
    pass

FAILED = 3
"""Of --strict: the input is right, but the line does not last."""

STOPPED = 4
"""A maximum hangs on the step or the bars, so that the damage is not proven."""


def fatigue(
    context: typer.Context,
    case: Annotated[Path, typer.Argument(metavar="CASE", help="Case file (TOML) with [fatigue].")],
    load_case: Annotated[
        str | None,
        typer.Option(
            "--load-case",
            metavar="NAME",
            help="Load case under which the line lies; needed where there are several.",
        ),
    ] = None,
    once: Annotated[
        bool,
        typer.Option(
            "--once",
            help="Run each sea state once, without the proof at half the step; the answer says so.",
        ),
    ] = False,
    workers: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            help="Run the seeds ([dynamics] runs) of a sea state in N processes side by side; "
            "where it saves time on all cores when left out.",
        ),
    ] = None,
    strict: Annotated[
        bool,
        typer.Option(
            "--strict",
            help="End with exit status 3 when the line does not last; the answer is printed.",
        ),
    ] = False,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
) -> None:
    """Find the damage of each segment in a year of the sea states of [fatigue], and its life.

    Runs the line in time in each sea state, as verify --dynamic does, and counts the cycles of its
    tension by rainflow. Prints damage, life and utilisation by segment, the curve and where it was
    taken, and what each sea state does.
    """
    from catopt.answers.fatigue import fatigue_answer, fatigue_sentence
    from catopt.casefile import read_case
    from catopt.cli.result_files import Asked
    from catopt.cli.state import with_known_codes
    from catopt.verify.fatigue import verify_fatigue
    from catopt.words import say

    asked = Asked(context.obj, lang, as_json, out)
    output = asked.output
    read = with_known_codes(read_case(case))
    with output.progress("Sea states") as tell:
        report = verify_fatigue(
            read,
            load_case=load_case,
            proof="none" if once else "step",
            workers=workers,
            progress=tell,
            announce=lambda words: output.note(f"catopt: {say(words, lang.value)}"),
        )
    asked.give(fatigue_answer(report), report.to_dict, read)
    if report.verdict == "not converged" or (strict and not report.passes):
        output.note(f"catopt: {say(fatigue_sentence(report), lang.value)}")
        raise typer.Exit(STOPPED if report.verdict == "not converged" else FAILED)
