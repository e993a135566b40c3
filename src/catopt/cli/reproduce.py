"""``catopt reproduce``: published figures beside catopt's own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.options import JsonOption, LangOption, OutOption, ReportLanguage

if TYPE_CHECKING:
    from catopt.cli.output import Output

__all__ = ["reproduce"]


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
    from catopt.reproduce import reproduce as recompute

    output: Output = context.obj
    if out is not None:
        from catopt.report.files import check_directory

        check_directory(out)
    with output.progress("Swarm runs") as tell:
        result = recompute(name, progress=tell)
    if out is not None:
        from catopt.report.bundle import reproduction_bundle
        from catopt.report.files import write_files

        with output.progress("Tables and figures"):
            written = write_files(out, reproduction_bundle(result, lang.value))
        output.note(f"{len(written)} files written to {out}")
    if as_json:
        output.json(result.to_dict())
        return
    from catopt.cli.reproduction_view import show_reproduction
    from catopt.report.texts import Words

    show_reproduction(output, result, Words(lang.value))
