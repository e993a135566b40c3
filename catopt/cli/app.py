"""The command line as a whole: global options and the list of commands."""

from __future__ import annotations

from collections.abc import Callable
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
from catopt.cli.help_words import GroupWithWords, WithWords, in_vietnamese
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
from catopt.cli.verify import verify
from catopt.cli.web import page_app, web

# Without rich markup the help imports no rich, and its text is the same on every terminal.
app = typer.Typer(
    name="catopt",
    cls=GroupWithWords,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"catopt {__version__}")
        raise typer.Exit


_VERSION = typer.Option("--version", callback=_version, is_eager=True)


@app.callback()
def catopt(
    context: typer.Context,
    version: Annotated[bool, _VERSION] = False,  # noqa: ARG001 - its callback answers
    debug: Annotated[bool, typer.Option("--debug")] = False,
) -> None:
    """Take the global options."""
    output = context.ensure_object(Output)
    output.debug = debug
    output.listen()


_COMMANDS: dict[str, Callable[..., None]] = {
    "new": new,
    "solve": solve,
    "curve": curve,
    "check": check,
    "design": design,
    "system": system,
    "verify": verify,
    "fatigue": fatigue,
    "study": study,
    "report": report,
    "export": export,
    "import": import_deck,
    "reproduce": reproduce,
    "app": page_app,
    "web": web,
    "compile": compile_all,
}
for _name, _command in _COMMANDS.items():
    app.command(_name, cls=WithWords)(_command)
for _group in (size, loads, catalog):  # groups come last, as typer lists them
    app.add_typer(_group)

command = typer.main.get_command(app)
"""The command line, built once: that takes longer than most answers."""
if in_environment() == "vi":
    in_vietnamese(command)
