"""The command line as a whole: global options and the list of commands."""

from __future__ import annotations

from typing import Annotated

import typer
import typer.main

from catopt._version import __version__
from catopt.cli.catalog import catalog
from catopt.cli.check import check
from catopt.cli.compile import compile_all
from catopt.cli.curve import curve
from catopt.cli.design import design
from catopt.cli.export import export
from catopt.cli.fatigue import fatigue
from catopt.cli.import_deck import import_deck
from catopt.cli.loads import loads
from catopt.cli.new import new
from catopt.cli.output import Output
from catopt.cli.report import report
from catopt.cli.reproduce import reproduce
from catopt.cli.size import size
from catopt.cli.solve import solve
from catopt.cli.system import system
from catopt.cli.units_option import in_units
from catopt.cli.verify import verify
from catopt.cli.web import page_app, web

# Without rich markup the help imports no rich, and its text is the same on every terminal.
app = typer.Typer(
    name="catopt",
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Sizes catenary mooring lines: closed form, particle swarm, published figures.",
    epilog="Exit status: 0 done; 2 the input is wrong; 3 the input is right but no equilibrium "
    "exists; 4 a solver did not converge; 1 a fault of catopt's own.",
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"catopt {__version__}")
        raise typer.Exit


@app.callback()
def catopt(
    context: typer.Context,
    version: Annotated[  # noqa: ARG001 - its callback answers
        bool,
        typer.Option(
            "--version", callback=_version, is_eager=True, help="Print the version and exit."
        ),
    ] = False,
    debug: Annotated[
        bool, typer.Option("--debug", help="Show the traceback of a fault of catopt's own.")
    ] = False,
) -> None:
    """Take the global options."""
    output = context.ensure_object(Output)
    output.debug = debug
    output.tell_when_compiling()
    output.tell_of_decks()


for _command in (
    solve, curve, design, check, verify, fatigue, system, report, export, reproduce, new,
):  # fmt: skip
    app.command()(_command if _command in (export, new, reproduce) else in_units(_command))
app.command("import")(import_deck)
app.command()(web)
app.command("app")(page_app)
app.command("compile")(compile_all)
app.add_typer(catalog)
app.add_typer(loads)
app.add_typer(size)

command = typer.main.get_command(app)
"""The command line, built once: that takes longer than most answers."""
