"""The words of ``--help``, in the language of CATOPT_LANG: read when help is asked for."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from contextvars import ContextVar
from importlib.resources import files
from itertools import starmap, takewhile
from textwrap import wrap
from typing import Any, Final

import typer
import typer.main
from typer.core import TyperCommand, TyperGroup

from catopt.cli.options import in_environment
from catopt.words import Message, say

HELP_ALL: Final = "--help-all"
"""In place of ``--help``: all of it."""
WHOLE: Final[ContextVar[bool]] = ContextVar("WHOLE", default=False)
"""Whether all of a help is asked for."""
HELP_LINES, HELP_WIDTH = 24, 80
_MOST_ABOUT = 3
"""Lines of a help that say what the command is for."""

_OWN: Final = {
    "Usage": "Cách dùng",
    "Options": "Tùy chọn",
    "Arguments": "Tham số",
    "Commands": "Lệnh",
    "Show this message and exit.": "Hiện trang này rồi thoát.",
}
"""Headings that typer writes, and its own option."""
_OPTIONS, _BELOW = "[TÙY CHỌN]", "LỆNH [THAM SỐ]..."
_ADDED: Final = {
    "env var: ": "biến môi trường: ",
    "default: ": "mặc định: ",
    "required": "bắt buộc",
}
"""What typer adds to the help of an option, in brackets at its end."""


def table() -> dict[str, Any]:
    """Read the help: by command, its parts and options, each in both languages."""
    read = files("catopt.cli").joinpath("help.toml").read_text("utf-8")
    return tomllib.loads(read)


def put_words(command: Any) -> None:
    """Put their help into the whole command line, by typer's own attributes."""
    read = table()
    _put(command, read["catopt"], read, read["shared"])


def _put(
    command: Any, own: Mapping[str, Any], below: Mapping[str, Any], shared: Mapping[str, Any]
) -> None:
    language = in_environment()
    for key in {"help", "short_help", "epilog"} & own.keys():
        setattr(command, key, own[key][language])
    for each in command.params:  # a help that is there may be the key of a shared one
        texts = own.get(each.name) or shared.get(each.help or each.name)
        if texts:
            each.help = texts[language]
    for name, each in getattr(command, "commands", {}).items():
        _put(each, below[name], below[name], shared)


def on_a_screen(whole: str, command: str) -> str:
    """Shorten a help to a screen: an option a line, and of those without room their names."""
    lines = whole.splitlines()
    if len(lines) <= HELP_LINES:
        return whole
    about = list(takewhile(str.strip, lines[lines.index("") + 1 :]))[:_MOST_ABOUT]
    head = [*takewhile(str.strip, lines), *about]
    entries = [
        (line, below)
        for line, below in zip(lines, [*lines[1:], ""], strict=True)
        if re.match(r"  \S.*\S {2,}\S|  --?\w\S*( \S+)?$", line) and line not in head
    ]
    entries.sort(key=lambda each: each[0].strip().startswith("-"))  # options behind commands
    named = [
        re.findall(r"--?\w[\w-]*|^\w[\w-]*", line.strip().partition("  ")[0])[-1]
        for line, _ in entries
    ]
    key = "answers.help_all"
    last = say(Message(key, command=f"{command} {HELP_ALL}"), in_environment())
    for count in range(len(entries), 0, -1):
        also = wrap(", ".join(named[count:]), HELP_WIDTH - 4, break_on_hyphens=False)
        laid = [*head, "", *starmap(_entry, entries[:count]), *(f"  {each}" for each in also), last]
        if len(laid) <= HELP_LINES:
            break
    return "\n".join(laid)


def _entry(line: str, below: str) -> str:
    """Take the first line of an entry; where more follows, say so."""
    goes_on = below.startswith("    ") or not re.search(r" {2,}\S", line.strip())
    if not re.search(r" {2,}\S", line.strip()):  # the option is too long to have words beside it
        line, goes_on = f"{line}  {below.strip()}", True
    if not goes_on:
        return line
    cut = line if len(line) <= HELP_WIDTH - 4 else line[: HELP_WIDTH - 3].rpartition(" ")[0]
    return f"{cut.rstrip()} ..."


class _WithWords:
    """A command that puts the words into the help before it shows any of it."""

    def get_help(self, ctx: Any) -> str:
        put_words(ctx.find_root().command)
        whole: str = super().get_help(ctx)  # type: ignore[misc]
        return whole if WHOLE.get() else on_a_screen(whole, ctx.command_path)

    def shell_complete(self, ctx: Any, incomplete: str) -> Any:
        put_words(ctx.find_root().command)
        return super().shell_complete(ctx, incomplete)  # type: ignore[misc]


class WithWords(_WithWords, TyperCommand):
    """A command whose help is in the table."""


class GroupWithWords(_WithWords, TyperGroup):
    """A group of commands whose help is in the table."""


def usage_in_vietnamese(usage: str) -> str:
    """Put typer's own words of a line of usage into Vietnamese."""
    for word, said in (
        ("Usage: ", f"{_OWN['Usage']}: "),
        ("[OPTIONS]", _OPTIONS),
        ("COMMAND [ARGS]...", _BELOW),
    ):
        usage = usage.replace(word, said)
    return usage


def group(name: str, kind: type[GroupWithWords] = GroupWithWords) -> typer.Typer:
    """Make a group of commands."""
    return typer.Typer(
        name=name,
        cls=kind,
        rich_markup_mode=None,
        no_args_is_help=True,
        add_completion=False,
    )


def built(app: typer.Typer) -> Any:
    """Build a command, or a group with all below it, in the language of the environment."""
    command = typer.main.get_command(app)
    if in_environment() == "vi":
        _in_vietnamese(command)
    return command


def _in_vietnamese(command: Any) -> None:
    """Make typer's own words Vietnamese, of a command and of all below it."""
    command.options_metavar = _OPTIONS
    context = command.context_class
    formatter = _formatter(context.formatter_class)
    command.context_class = type(context.__name__, (context,), {"formatter_class": formatter})
    below = getattr(command, "commands", {})
    if below:
        command.subcommand_metavar = _BELOW
    for each in below.values():
        _in_vietnamese(each)


def _formatter(kind: Any) -> Any:
    """Make a formatter whose own words are Vietnamese."""

    class Formatter(kind):  # type: ignore[misc]
        def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
            super().write_usage(prog, args, prefix or f"{_OWN['Usage']}: ")

        def write_heading(self, heading: str) -> None:
            super().write_heading(_OWN.get(heading, heading))

        def write_dl(self, rows: Any, *args: Any, **options: Any) -> None:
            said = [(first, _of_typer(second)) for first, second in rows]
            super().write_dl(said, *args, **options)

    return Formatter


def _of_typer(text: str) -> str:
    """Put what typer adds to the help of an option into Vietnamese."""
    help_text, mark, added = text.rpartition("  [")
    if not mark:
        return _OWN.get(text, text)
    for word, said in _ADDED.items():
        added = added.replace(word, said)
    return f"{help_text}{mark}{added}"
