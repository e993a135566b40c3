"""The help of every command, and its copy in docs/commands.md.

``python -m tests.cli.command_page`` brings the copy up to date.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any
from unittest import mock

from catopt.__main__ import main
from catopt.cli.app import command

PAGE = Path(__file__).parents[2] / "docs" / "commands.md"

_BLOCK = re.compile(r"```text\n\$ (catopt[a-z ]*) --help-all\n(.*?)```", re.DOTALL)


def commands() -> list[str]:
    """Every command that has a help of its own, as it is typed; a group before its commands."""
    return list(_typed(whole(), "catopt"))


def whole() -> Any:
    """Return the command line with every command loaded."""
    for name in command.commands:
        command.resolve_command(None, [name])
    return command


def _typed(one: Any, typed: str) -> Iterator[str]:
    yield typed
    for name, below in getattr(one, "commands", {}).items():
        yield from _typed(below, f"{typed} {name}")


def help_of(command: str) -> str:
    """Help of a command at a fixed width."""
    out = StringIO()
    environment = {"COLUMNS": "100", "NO_COLOR": "1", "TERM": "dumb"}
    with mock.patch.dict(os.environ, environment), redirect_stdout(out):
        assert main([*command.split()[1:], "--help-all"]) == 0
    return out.getvalue()


def blocks(page: str) -> dict[str, str]:
    """Help that a page shows, by command."""
    return {command.strip(): text for command, text in _BLOCK.findall(page)}


def up_to_date(page: str) -> str:
    """Put the real help in the place of what a page shows."""
    return _BLOCK.sub(
        lambda found: f"```text\n$ {found[1]} --help-all\n{help_of(found[1].strip())}```", page
    )


if __name__ == "__main__":
    PAGE.write_text(up_to_date(PAGE.read_text("utf-8")), encoding="utf-8")
