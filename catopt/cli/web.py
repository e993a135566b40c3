"""``catopt web`` and ``catopt app``: the page."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from catopt.cli.output import Output

__all__ = ["page_app", "web"]


def web(
    context: typer.Context,
    out: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write the page as a folder for a web server."),
    ] = None,
    single: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the page as one .html that opens from disk."),
    ] = None,
    taken_from: Annotated[
        Path | None,
        typer.Option(
            "--from",
            metavar="DIR",
            help="Folder with the files of Pyodide and Python that are fetched from the npm "
            "registry and PyPI when this is left out.",
        ),
    ] = None,
) -> None:
    """Write the page that sizes and computes moorings in the browser.

    Nothing has to be installed to open it, and it asks no server for anything. What it is made of
    is pinned by SHA-256; docs/page.md has sizes and times.
    """
    from catopt.errors import InputError, Problem
    from catopt.report.files import check_directory, write_files
    from catopt.web.build import fetched, pieces
    from catopt.web.document import document

    output: Output = context.obj
    if (out is None) == (single is None):
        raise InputError(
            [Problem("--out", "", "give either --out DIR or --single FILE")], "options"
        )
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
    port: Annotated[int, typer.Option(metavar="N", help="Port; 0: any that is free.")] = 0,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Open the browser, too.")
    ] = True,
) -> None:
    """Open the page with catopt itself behind it; Ctrl-C ends it.

    Only this machine is answered, and only under the address that is printed. It computes what the
    page of catopt web computes in the browser, sooner.
    """
    import webbrowser

    from catopt.errors import InputError, Problem
    from catopt.web.server import PageServer

    output: Output = context.obj
    try:
        server = PageServer(port)
    except (OSError, OverflowError) as error:
        allowed = "give a port from 0 to 65535 that no other program uses"
        raise InputError([Problem("--port", f"{port} ({error})", allowed)], "options") from error
    with server:
        output.text(server.address)
        if browser:
            webbrowser.open(server.address)
        server.serve_forever()
