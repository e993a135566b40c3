"""``catopt web`` and ``catopt app``: the page."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from catopt.cli.output import Printer
from catopt.cli.values import refused
from catopt.words import Message


def web(
    context: typer.Context,
    out: Annotated[Path | None, typer.Option(metavar="DIR")] = None,
    single: Annotated[Path | None, typer.Option(metavar="FILE")] = None,
    taken_from: Annotated[Path | None, typer.Option("--from", metavar="DIR")] = None,
) -> None:
    """Write the page that sizes and computes moorings in the browser."""
    from catopt.report.bundle import check_directory, write_files
    from catopt.web.build import document, fetched, pieces

    output: Printer = context.obj
    if (out is None) == (single is None):
        raise refused("--out", "", Message("refused_command.give_either_out_dir_or"))
    folder = out if single is None else single.parent
    assert folder is not None
    check_directory(folder)
    with output.progress("Page"):
        made = pieces(lambda part: fetched(part, taken_from))
        if single is not None:
            places = write_files(folder, {single.name: document(made).encode()})
        else:
            packed = {f"{name}.gz": data for name, data in made.items()}
            places = write_files(folder, {"index.html": document(list(made)).encode()})
            places += write_files(folder / "pack", packed)
    for place in places:
        output.text(str(place))


def page_app(
    context: typer.Context,
    port: Annotated[int, typer.Option(metavar="N")] = 0,
    browser: Annotated[bool, typer.Option("--browser/--no-browser")] = True,
) -> None:
    """Open the page with catopt itself behind it; Ctrl-C ends it."""
    import webbrowser

    from catopt.web.build import PageServer

    output: Printer = context.obj
    try:
        server = PageServer(port)
    except (OSError, OverflowError) as error:
        allowed = Message("refused_command.give_port_from_0_65535")
        raise refused("--port", f"{port} ({error})", allowed) from error
    with server:
        output.text(server.address)
        if browser:
            webbrowser.open(server.address)
        server.serve_forever()
