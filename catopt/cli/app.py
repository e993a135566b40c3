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
from catopt.cli.options import in_environment
from catopt.cli.output import Output
from catopt.cli.report import report
from catopt.cli.reproduce import reproduce
from catopt.cli.size import size
from catopt.cli.solve import solve
from catopt.cli.study import study
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
    help="Sizes mooring lines, checks them by named codes, and writes the note for the checker.",
    epilog="Exit status: 0 done; 2 the input is wrong; 3 the input is right but no equilibrium "
    "exists; 4 a solver did not converge; 130 interrupted; 1 a fault of catopt's own.",
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


# Each in one line, groups last as typer has them; the own help of each says more.
for _name, _command, _short in (
    ("new", new, "Write a commented file to start from."),
    ("solve", in_units(solve), "Solve a mooring line at rest."),
    ("curve", in_units(curve), "The forces of a line over its span."),
    ("check", in_units(check), "Check a line, or all lines of a body, by named codes."),
    ("design", in_units(design), "Search the best lines, or moorings, that can be bought."),
    ("system", in_units(system), "Find where a body on several lines comes to rest."),
    ("verify", in_units(verify), "Compare with the truss model, at rest or in motion."),
    ("fatigue", in_units(fatigue), "Damage of each segment in a year of sea states."),
    ("study", in_units(study), "Compute a case again and again, with what varies in it."),
    ("report", in_units(report), "Write the calculation note."),
    ("export", export, "Write lines for another program, or as a drawing."),
    ("import", import_deck, "Read another program's file, write it as a case."),
    ("reproduce", reproduce, "Recompute published figures, number by number."),
    ("app", page_app, "Open the page in the browser, for buoy, ship and lines."),
    ("web", web, "Write that page as a file or a folder."),
    ("compile", compile_all, "Compile everything now, once for this machine."),
):
    app.command(_name, short_help=_short)(_command)
app.add_typer(size, short_help="Size the mooring of a buoy or a ship.")
app.add_typer(loads, short_help="Wind, current and waves on a buoy or a ship.")
app.add_typer(catalog, short_help="Look up chain, wire and rope, each figure with its source.")

command = typer.main.get_command(app)
"""The command line, built once: that takes longer than most answers."""
if in_environment() == "vi":
    from catopt.cli.help_words import put_into_vietnamese

    put_into_vietnamese(command)
