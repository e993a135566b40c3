"""What a shell completes: the names that a refusal would list.

A name with a space is written as the shell takes it: escaped in bash and PowerShell; zsh and fish
do that themselves.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import typer

from catopt.sizing.inputs import SINKER, Input


def completed(names: str | tuple[str, ...]) -> Callable[[Any, str], list[str]]:
    """Make what completes one of several names, or one of a kind, looked up when it is required.

    Of a kind those that the command takes with what is typed already.
    """

    # Typer finds its context by its type, which cannot be imported for a type checker alone.
    def complete(ctx: typer.Context, incomplete: str) -> list[str]:
        typed = ctx.params
        known = dict.fromkeys(_names(names, typed) if isinstance(names, str) else names)
        shell = os.environ.get("_CATOPT_COMPLETE", "").rpartition("_")[2]
        words = os.environ.get("COMP_WORDS", "")
        is_quoted = words.count('"') % 2 == 1 or words.count("'") % 2 == 1
        escapes = {} if is_quoted else {"bash": "\\", "powershell": "`", "pwsh": "`"}
        space = f"{escapes.get(shell, '')} "
        return [name.replace(" ", space) for name in known if name.startswith(incomplete)]

    return complete


_OF_INPUTS = ("buoy", "chain", "anchor", "code")
"""Inputs of a sizing that are names of a kind."""


def _names(kind: str, typed: Mapping[str, Any]) -> Iterable[str]:
    """Look up all names of a kind; a component of the catalogue is a family with its grade."""
    match kind:
        case "template":
            from catopt.casefile.writing import TEMPLATES

            return TEMPLATES
        case "study":
            from catopt.reproduce.studies import names

            return names()
        case "code":
            from catopt.checks.profiles import profiles

            recalled = bool(typed.get("recalled"))
            return (profile.name for profile in profiles() if recalled or not profile.is_recalled)
        case "buoy":
            from catopt.loads import buoys

            return (buoy.name for buoy in buoys())
        case "anchor":
            from catopt.loads.drag_anchor import ANCHORS

            return ANCHORS
        case "anchor.soil" if typed.get("anchor") != SINKER and not typed.get("sinker"):
            from catopt.loads.drag_anchor import SOILS

            return SOILS
        case "anchor.soil" | "sinker.soil":
            from catopt.loads.sinker import SOIL_FRICTION

            return SOIL_FRICTION
    from catopt.catalogue import families
    from catopt.catalogue.finding import component_names

    if kind == "family":
        return (family.name for family in families())
    if kind == "grade":
        own = [family for family in families() if family.name == typed.get("family")]
        return (grade for family in own or families() for grade in family.grades)
    return component_names()


def of_input(each: Input) -> dict[str, Any]:
    """Say, for the option of a sizing's input, what completes it."""
    if each.words:
        return {"autocompletion": completed(each.words)}
    kind = each.key if each.name == "soil" else each.name
    known = kind in _OF_INPUTS or each.name == "soil"
    return {"autocompletion": completed(kind)} if known else {}
