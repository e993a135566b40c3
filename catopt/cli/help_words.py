"""``--help`` in Vietnamese, for those who set CATOPT_LANG=vi."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any, Final

_OWN: Final = {
    "Usage": "Cách dùng",
    "Options": "Tùy chọn",
    "Arguments": "Tham số",
    "Commands": "Lệnh",
}
"""Headings that typer writes."""
_ADDED: Final = {
    "env var: ": "biến môi trường: ",
    "default: ": "mặc định: ",
    "required": "bắt buộc",
}
"""What typer adds to the help of an option, in brackets at its end."""


@cache
def vietnamese() -> Mapping[str, str]:
    """Read the paragraphs of the help, by what the English ones say."""
    text = files("catopt.cli").joinpath("help_vi.toml").read_text("utf-8")
    found: dict[str, str] = tomllib.loads(text)
    return found


def paragraphs(text: str) -> list[str]:
    """Split a help into paragraphs, each on one line."""
    return [" ".join(each.split()) for each in text.split("\n\n")]


def in_vietnamese(text: str) -> str:
    """Take a help paragraph by paragraph; one that is not in the table stays."""
    return "\n\n".join(vietnamese().get(each, each) for each in paragraphs(text))


def put_into_vietnamese(command: Any) -> None:
    """Put the help of a command and of all below it into Vietnamese, by typer's own attributes."""
    for of, key in (
        (command, "help"),
        (command, "short_help"),
        (command, "epilog"),
        *((each, "help") for each in command.params),
    ):
        text = getattr(of, key, None)
        if text:
            setattr(of, key, in_vietnamese(text))
    command.options_metavar = "[TÙY CHỌN]"
    context = command.context_class
    formatter = _formatter(context.formatter_class)
    command.context_class = type(context.__name__, (context,), {"formatter_class": formatter})
    below = getattr(command, "commands", {})
    if below:
        command.subcommand_metavar = "LỆNH [THAM SỐ]..."
    for each in below.values():
        put_into_vietnamese(each)


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
        return vietnamese().get(text, text)
    for word, said in _ADDED.items():
        added = added.replace(word, said)
    return f"{help_text}{mark}{added}"
