"""``catopt reproduce``: published figures beside catopt's own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.options import JsonOption, LangOption, OutOption, ReportLanguage

if TYPE_CHECKING:
    from catopt.cli.output import Output


def reproduce(
    context: typer.Context,
    name: Annotated[
        str | None,
        typer.Argument(metavar="NAME", help="One study, such as buoy_9p5m; all when left out."),
    ] = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Recompute published figures and judge each printed number.

    A number reproduces when catopt's, rounded to the printed decimals, has every printed digit.
    """
    from catopt.answers.reproduction import reproduction_answer
    from catopt.render.terminal import show
    from catopt.reproduce import reproduce as recompute

    output: Output = context.obj
    if out is not None:
        from catopt.report.files import check_directory

        check_directory(out)
    with output.progress("Swarm runs") as tell:
        result = recompute(name, progress=tell)
    answer = reproduction_answer(result)
    if out is not None:
        from catopt.render.files import files_of
        from catopt.report.bundle import reproduction_pictures
        from catopt.report.files import write_files
        from catopt.reproduce import book

        with output.progress("Tables and figures"):
            files = files_of(answer, result.to_dict(), lang.value)
            files |= {"reproduction.md": book(result).encode()} | reproduction_pictures(result)
            written = write_files(out, files)
        output.note(f"{len(written)} files written to {out}")
    if as_json:
        output.json(result.to_dict())
    else:
        show(output, answer, lang.value)
