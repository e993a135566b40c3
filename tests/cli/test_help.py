"""docs/commands.md shows the help of every command as it is."""

from __future__ import annotations

from typing import Any

import pytest
import typer

from catopt.cli.help_words import put_words

from .command_page import PAGE, blocks, commands, help_of, whole
from .conftest import Run

WRITTEN_WITH = "0.29"
"""typer whose layout the page shows; another one may set brackets and spaces otherwise."""


def words(text: str) -> str:
    """Undo the breaking of lines, which a hyphen may end."""
    return " ".join(text.split()).replace("- ", "-")


def shown() -> dict[str, str]:
    """Read what the page shows, by command."""
    return blocks(PAGE.read_text("utf-8"))


def test_every_command_is_on_the_page() -> None:
    assert sorted(shown()) == sorted(commands())


@pytest.mark.skipif(
    not typer.__version__.startswith(f"{WRITTEN_WITH}."), reason=f"typer is not {WRITTEN_WITH}"
)
@pytest.mark.parametrize("command", commands())
def test_the_help_on_the_page_is_the_real_one(command: str) -> None:
    """When it is not: python -m tests.cli.command_page writes it anew."""
    assert words(shown()[command]) == words(help_of(command))


@pytest.mark.parametrize("command", commands()[1:])
def test_every_option_and_its_help_is_on_the_page(command: str) -> None:
    """Whatever lays the help out, these words are ours."""
    found: Any = whole()
    put_words(found)
    for name in command.split()[1:]:
        found = found.commands[name]
    text = words(shown()[command])
    assert words(found.help.replace("\f", "")) in text
    for parameter in found.params:
        assert words(parameter.help) in text
        for name in parameter.opts:
            assert parameter.param_type_name == "argument" or name in text


def test_a_changed_help_is_noticed() -> None:
    changed = PAGE.read_text("utf-8").replace("--seed N", "--sead N")
    assert words(blocks(changed)["catopt solve"]) != words(help_of("catopt solve"))


def test_every_command_has_its_line(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    shown = run("--help").out
    assert "..." not in shown.partition("Commands:")[2]
    assert max(map(len, shown.splitlines())) <= 80


@pytest.mark.parametrize("language", ["en", "vi"])
@pytest.mark.parametrize("command", commands())
def test_the_short_help_is_a_screen_that_names_every_option(
    run: Run, monkeypatch: pytest.MonkeyPatch, command: str, language: str
) -> None:
    """What has no room is in the long one, which the last line says how to get."""
    monkeypatch.setenv("CATOPT_LANG", language)
    monkeypatch.setenv("COLUMNS", "80")
    lines = run(*command.split()[1:], "--help").out.splitlines()
    assert len(lines) <= 24
    assert max(map(len, lines)) <= 80
    found: Any = whole()
    for name in command.split()[1:]:
        found = found.commands[name]
    text = " ".join(lines)
    assert all(each.opts[0] in text for each in found.params if each.opts[0].startswith("--"))
    assert all(name in text for name in getattr(found, "commands", {}))
    long = run(*command.split()[1:], "--help-all").out.splitlines()
    assert long == lines or f"{command} --help-all" in lines[-1]
