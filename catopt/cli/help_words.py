"""Words of ``--help``, and of what typer cannot read, in the language of CATOPT_LANG."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from contextvars import ContextVar
from importlib.resources import files
from itertools import takewhile
from textwrap import wrap
from typing import Any, Final

import typer
import typer.main
from typer.core import TyperCommand, TyperGroup

from catopt.cli.options import in_environment
from catopt.cli.output import terminal_width
from catopt.words import Language, Message, say

HELP_ALL: Final = "--help-all"
"""In place of ``--help``: all of it."""
WHOLE: Final[ContextVar[bool]] = ContextVar("WHOLE", default=False)
"""Whether all of a help is asked for."""
HELP_LINES = 24
_MOST_WIDE = 80
"""Columns of a help on a wide terminal."""
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
    return tomllib.loads(files("catopt.cli").joinpath("help.toml").read_text("utf-8"))


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
    for parameter in command.params:  # a help that is there may be the key of a shared one
        texts = own.get(parameter.name) or shared.get(parameter.help or parameter.name)
        if texts:
            parameter.help = texts[language]
    for name, subcommand in getattr(command, "commands", {}).items():
        _put(subcommand, below[name], below[name], shared)


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
    last = say(Message("answers.help_all", command=f"{command} {HELP_ALL}"), in_environment())
    width = min(terminal_width(), _MOST_WIDE)
    for count in range(len(entries), 0, -1):
        also = wrap(", ".join(named[count:]), width - 4, break_on_hyphens=False)
        laid = [
            *head,
            "",
            *(_entry(*entry, width) for entry in entries[:count]),
            *(f"  {entry}" for entry in also),
            last,
        ]
        if len(laid) <= HELP_LINES:
            break
    return "\n".join(laid)


def _entry(line: str, below: str, width: int) -> str:
    """Take the first line of an entry, within a width; where more follows, say so."""
    if not re.search(r" {2,}\S", line.strip()):  # the option is too long to have words beside it
        line = f"{line}  {below.strip()}"
    elif not below.startswith("    "):
        return line
    cut = line if len(line) <= width - 4 else line[: width - 3].rpartition(" ")[0]
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
    for entry in below.values():
        _in_vietnamese(entry)


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


_REFUSED: Final = (
    (r"No such option: (\S+)", r"Không có tùy chọn \1"),
    (r"No such command (.+?)\.", r"Không có lệnh \1."),
    (r"\(Possible options: (.*)\)", r"(các tùy chọn gần giống: \1)"),
    (r"Did you mean (.+)\?", r"Có phải ý là \1?"),
    (r"Missing (?:argument|option|parameter) ('.*?')\.?", r"Thiếu \1."),
    (r"Choose from:", r"Chọn một trong:"),
    (r"\(env var: (.*?)\)", r"(biến môi trường: \1)"),
    (r"Invalid value for (.*?): ", r"Giá trị sai của \1: "),
    (r"('.*?') is not one of (.*)", r"\1 không phải là một trong \2"),
    (r"Input should be a valid integer\b.*", r"cần số nguyên"),
    (r"Input should be a valid number\b.*", r"cần một số"),
    (r"Option ('.*?') requires an argument\.?", r"Tùy chọn \1 cần một giá trị."),
    (r"Option ('.*?') requires (\d+) arguments\.?", r"Tùy chọn \1 cần \2 giá trị."),
    (r"Got unexpected extra arguments?(?:\(s\))? \((.*?)\)", r"Thừa tham số: \1"),
)
"""What typer says of a command line that it cannot read."""


def run(command: Any, language: Language, **options: Any) -> int:
    """Run the command line; returns the exit status, with what typer refuses said in a language."""
    try:
        status = command(standalone_mode=False, **options)
    except typer.Abort:
        return 1
    except Exception as error:
        if not hasattr(error, "format_message"):
            raise
        return _tell(error, language)
    return status if isinstance(status, int) else 0


def _meant(said: str, context: Any) -> str:
    """Say which option a bare length may be meant for: the depth, where the command takes one."""
    from catopt.errors import InputError
    from catopt.units import Dimension, bare_number, to_si

    found = re.fullmatch(r"Got unexpected extra arguments?(?:\(s\))? \((\S+(?: m)?)\)\.?", said)
    options = {name for parameter in context.command.params for name in parameter.opts}
    if found is None or "--depth" not in options:
        return ""
    try:
        to_si(bare_number(found[1]), Dimension.LENGTH)
    except InputError:
        return ""
    quote = '"' if " " in found[1] else ""
    return f". Did you mean --depth {quote}{found[1]}{quote}?"


def _tell(error: Any, language: Language) -> int:
    context = getattr(error, "ctx", None)
    if type(error).__name__ == "NoArgsIsHelpError" or context is None:
        error.show()
    else:
        said, usage = error.format_message().replace("Value error, ", ""), context.get_usage()
        said += _meant(said, context)
        hint, label = f"Try '{context.command_path} -h' for help.", "Error"
        if language == "vi":
            for english, vietnamese in _REFUSED:
                said = re.sub(english, vietnamese, said)
            usage = usage.replace("Usage: ", f"{_OWN['Usage']}: ").replace("[OPTIONS]", _OPTIONS)
            usage = usage.replace("COMMAND [ARGS]...", _BELOW)
            hint, label = f"Gõ '{context.command_path} --help' để xem hướng dẫn.", "Lỗi"
        typer.echo(f"{usage}\n{hint}\n\n{label}: {said}", err=True)
    return int(error.exit_code)
