"""What a shell completes: the names that a refusal would list.

A name with a space is written as the shell takes it: escaped in bash and PowerShell; zsh and fish
do that themselves.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import Any


def completed(names: str | tuple[str, ...]) -> Callable[[str], list[str]]:
    """Make what completes one of several names, or one of a kind, looked up when it is required."""

    def complete(incomplete: str) -> list[str]:
        known = dict.fromkeys(_names(names) if isinstance(names, str) else names)
        shell = os.environ.get("_CATOPT_COMPLETE", "").rpartition("_")[2]
        typed = os.environ.get("COMP_WORDS", "")
        is_quoted = typed.count('"') % 2 == 1 or typed.count("'") % 2 == 1
        escapes = {} if is_quoted else {"bash": "\\", "powershell": "`", "pwsh": "`"}
        space = f"{escapes.get(shell, '')} "
        return [name.replace(" ", space) for name in known if name.startswith(incomplete)]

    return complete


_OF_INPUTS = ("buoy", "chain", "anchor", "soil", "code")
"""Inputs of a sizing that are names of a kind."""


def _names(kind: str) -> Iterable[str]:
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

            return (each.name for each in profiles())
        case "buoy":
            from catopt.loads import buoys

            return (each.name for each in buoys())
        case "anchor":
            from catopt.loads.drag_anchor import ANCHORS

            return ANCHORS
        case "soil":  # under drag anchors and under sinkers
            from catopt.loads.drag_anchor import SOILS
            from catopt.loads.sinker import SOIL_FRICTION

            return (*SOILS, *SOIL_FRICTION)
    from catopt.catalogue import families
    from catopt.catalogue.finding import component_names

    if kind == "family":
        return (each.name for each in families())
    if kind == "grade":
        return (grade for each in families() for grade in each.grades)
    return component_names()


def of_input(name: str, words: tuple[str, ...]) -> dict[str, Any]:
    """Say, for the option of a sizing's input, what completes it."""
    if words:
        return {"autocompletion": completed(words)}
    return {"autocompletion": completed(name)} if name in _OF_INPUTS else {}
