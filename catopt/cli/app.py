"""The command line as a whole: global options and the list of commands."""

from __future__ import annotations

from importlib import import_module
from typing import Annotated, Any

import typer

from catopt._version import identity
from catopt.cli.help_words import GroupWithWords, WithWords, built
from catopt.cli.output import Printer

_PLACES = {
    "new": "new.new",
    "solve": "solve.solve",
    "find": "find.find",
    "curve": "curve.curve",
    "check": "check.check",
    "design": "design.design",
    "system": "system.system",
    "verify": "verify.verify",
    "fatigue": "fatigue.fatigue",
    "study": "study.study",
    "report": "report.report",
    "export": "export.export",
    "import": "import_deck.import_deck",
    "reproduce": "reproduce.reproduce",
    "app": "web.page_app",
    "web": "web.web",
    "compile": "compile.compile_all",
    "size": "size.size",
    "loads": "loads.loads",
    "catalog": "catalog.catalog",
}
"""Each command as it is listed, with the module of this folder and what it is called there."""


class _Listed(WithWords):
    """A command of which only its line in the list is there."""


class _Commands(GroupWithWords):
    """All commands; the module of one is loaded when it is asked for."""

    def resolve_command(self, ctx: Any, args: Any) -> Any:
        name, found, rest = super().resolve_command(ctx, args)
        if name is not None and isinstance(found, _Listed):
            module, _, function = _PLACES[name].partition(".")
            place = getattr(import_module(f"catopt.cli.{module}"), function)
            if not isinstance(place, typer.Typer):  # a command that is in no group
                alone = typer.Typer(rich_markup_mode=None, add_completion=False)
                alone.command(name, cls=WithWords)(place)
                place = alone
            found = self.commands[name] = built(place)
        return name, found, rest


# Without rich markup the help imports no rich, and its text is the same on every terminal.
app = typer.Typer(
    name="catopt",
    cls=_Commands,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"catopt {identity()}\n{_computing_with()}")
        raise typer.Exit


def _computing_with() -> str:
    """Name Python and the libraries that decide digits and speed, each with its version."""
    from importlib.metadata import PackageNotFoundError, version
    from platform import python_version

    said = [f"Python {python_version()}"]
    for name in ("numpy", "scipy", "numba"):
        try:
            said.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            said.append(f"{name} -")
    return ", ".join(said)


_VERSION = typer.Option("--version", callback=_version, is_eager=True)


@app.callback()
def catopt(
    context: typer.Context,
    version: Annotated[bool, _VERSION] = False,  # noqa: ARG001 - its callback answers
    debug: Annotated[bool, typer.Option("--debug")] = False,
) -> None:
    """Take the global options."""
    output = context.ensure_object(Printer)
    output.debug = debug
    output.listen()


command = built(app)
"""The command line, built once: that takes longer than most answers."""
command.commands |= {name: _Listed(name) for name in _PLACES}
