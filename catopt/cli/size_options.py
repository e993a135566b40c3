"""The inputs of a sizing as options: made of their table (`catopt.sizing.inputs`)."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

from catopt.cli.answering import keyword
from catopt.cli.completion import of_input
from catopt.cli.options import in_environment
from catopt.sizing.inputs import Input, inputs_of
from catopt.words import Message, say

if TYPE_CHECKING:
    from catopt.casefile.reading import Moored

Command = TypeVar("Command", bound=Callable[..., None])

_NOTHING: Mapping[str, str] = MappingProxyType({})
_NO_OPTIONS = {"buoy": ("title", "source", "buoy"), "tanker": ("title", "source")}
_NAMED = ("depth", "draught", "dwt", "hs", "hmax", "soil")
"""Inputs that stand in what is said of others."""
_METAVARS = {"code": "NAME", "soil": "SOIL", "buoy": "BUOY", "sinker": "MATERIAL", "lines": "N"}


def as_option(name: str, index: int | None = None) -> str:
    """Write an input as an option; one of several values is ``--clump-weight (2)``."""
    flag = f"--{name.replace('_', '-')}"
    return flag if index is None else f"{flag} ({index + 1})"


def by_option(name: str, index: int | None = None) -> str:
    """Do the same where the name of a buoy stands alone."""
    return "BUOY" if name == "buoy" else as_option(name, index)


def _help_of(each: Input, taken: str | None) -> str:
    """Say what an option takes, and what is taken when it is left out, which may be given."""
    flags = {name: as_option(name) for name in _NAMED}
    left_out = Message(each.left_out, **flags) if each.left_out else each.default
    left_out = left_out if taken is None else taken
    is_shown = each.required or each.name == "buoy"
    said = (
        Message(f"inputs.{each.name}"),
        f": {', '.join(each.words)}" if each.words else "",
        Message("left_out.such_as", example=each.example) if is_shown else "",
        Message("left_out.if_left_out", taken=left_out) if left_out else "",
    )
    return "".join(say(part, in_environment()) for part in said) + "."


def with_inputs(
    moored: Moored, names: Collection[str] = (), taken: Mapping[str, str] = _NOTHING
) -> Callable[[Command], Command]:
    """Give a command the options of inputs in place of its ``**inputs``.

    Of all inputs where no `names` are given; `taken` is what is taken of those that are left out,
    by input, where that is not what a sizing takes.
    """

    def decorate(command: Command) -> Command:
        own = inspect.signature(command, eval_str=True).parameters.values()
        first = [each for each in own if each.kind is each.POSITIONAL_OR_KEYWORD]
        last = [each for each in own if each.kind is each.KEYWORD_ONLY]
        options = [
            _parameter(each, _help_of(each, taken.get(name)))
            for name, each in inputs_of(moored).items()
            if (name in names or not names) and name not in _NO_OPTIONS[moored]
        ]
        command.__signature__ = inspect.Signature([*first, *options, *last])  # type: ignore[attr-defined]
        return command

    return decorate


def _parameter(each: Input, words: str) -> inspect.Parameter:
    is_flag = each.takes == "FLAG"
    metavar = None if is_flag else _METAVARS.get(each.name, each.takes)
    kind: Any = bool if is_flag else list[str] | None if each.several else str | None
    option = typer.Option(
        as_option(each.name), metavar=metavar, help=words, **of_input(each.name, each.words)
    )
    return keyword(each.name, Annotated[kind, option], False if is_flag else None)


def typed(moored: Moored, options: Mapping[str, Any]) -> dict[str, object]:
    """Take what was typed, by input; options that are None, empty or False are left out."""
    from catopt.sizing.kinds import from_text

    inputs = inputs_of(moored)
    found: dict[str, object] = {}
    for name, value in options.items():
        if isinstance(value, list) and value:
            found[name] = [from_text(inputs[name], text) for text in value]
        elif isinstance(value, str):
            found[name] = from_text(inputs[name], value)
        elif value:
            found[name] = value
    return found
