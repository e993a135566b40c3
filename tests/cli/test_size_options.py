"""The options that ``catopt size`` and ``catopt loads`` share stand in one place."""

from __future__ import annotations

from typing import Any

import typer.main

from catopt.cli.loads import loads
from catopt.cli.size import size
from catopt.cli.size_options import DEFAULTS, MEASURES
from catopt.units import Dimension


def parameters() -> list[Any]:
    """List the parameters of the four commands."""
    groups: list[Any] = [typer.main.get_command(each) for each in (size, loads)]
    return [each for group in groups for one in group.commands.values() for each in one.params]


def test_every_option_with_a_unit_takes_what_the_table_says() -> None:
    taken = {
        each.opts[0]: each.metavar
        for each in parameters()
        if each.metavar in Dimension.__members__ and not isinstance(each.default, float)
    }
    taken.pop("--chain")  # a length for the loads, a name for the sizing
    assert taken == MEASURES


def test_an_option_of_two_commands_takes_the_same_in_both() -> None:
    names: dict[str, set[str]] = {}
    for each in parameters():
        names.setdefault(each.opts[0], set()).add(each.metavar)
    differing = {name for name, metavars in names.items() if len(metavars) > 1}
    # The name of a buoy stands alone or as an option; loads take the size of a chain.
    assert differing <= {"--chain", "name"}


def test_what_is_taken_is_said_in_the_help() -> None:
    """Of the sizing; the loads take nothing."""
    group: Any = typer.main.get_command(size)
    for command in group.commands.values():
        told = {each.opts[0]: each.help for each in command.params}
        for option, default in DEFAULTS.items():
            assert default in told[option]
