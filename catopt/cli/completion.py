"""What a shell completes: the names that a refusal would list.

A name with a space is written as the shell takes it: escaped in bash and PowerShell; zsh and fish
do that themselves.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import Any

Completer = Callable[[str], list[str]]


def completed(names: Callable[[], Iterable[str]]) -> Completer:
    """Make what completes one of several names; they are looked up when they are wanted."""

    def complete(incomplete: str) -> list[str]:
        return [_as_typed(name) for name in dict.fromkeys(names()) if name.startswith(incomplete)]

    return complete


def _as_typed(name: str) -> str:
    """Write a name as the shell that asks takes it."""
    shell = os.environ.get("_CATOPT_COMPLETE", "").rpartition("_")[2]
    typed = os.environ.get("COMP_WORDS", "")
    is_quoted = typed.count('"') % 2 == 1 or typed.count("'") % 2 == 1
    if " " not in name or is_quoted:
        return name
    escape = {"bash": "\\", "powershell": "`", "pwsh": "`"}.get(shell, "")
    return name.replace(" ", f"{escape} ")


def templates() -> Iterable[str]:
    """Names of templates."""
    from catopt.casefile.new_case import TEMPLATES

    return TEMPLATES


def studies() -> Iterable[str]:
    """Names of published studies."""
    from catopt.reproduce.studies import names

    return names()


def codes() -> Iterable[str]:
    """Names of profiles of criteria."""
    from catopt.checks.profiles import profiles

    return (each.name for each in profiles())


def buoys() -> Iterable[str]:
    """Names of buoys of the library."""
    from catopt.loads import buoys

    return (each.name for each in buoys())


def anchors() -> Iterable[str]:
    """Names of drag anchors."""
    from catopt.loads.holding_data import ANCHORS

    return ANCHORS


def soils() -> Iterable[str]:
    """Names of soils, under drag anchors and under sinkers."""
    from catopt.loads.holding_data import SOILS
    from catopt.loads.sinker import SOIL_FRICTION

    return (*SOILS, *SOIL_FRICTION)


def families() -> Iterable[str]:
    """Names of families of the catalogue."""
    from catopt.catalogue import families

    return (each.name for each in families())


def components() -> Iterable[str]:
    """Names of components: a family with its grade."""
    from catopt.catalogue import families

    return (f"{each.name} {grade}".rstrip() for each in families() for grade in each.grades)


def grades() -> Iterable[str]:
    """Grades of all families."""
    from catopt.catalogue import families

    return (grade for each in families() for grade in each.grades if grade)


_OF_INPUTS: dict[str, Callable[[], Iterable[str]]] = {
    "buoy": buoys,
    "chain": components,
    "anchor": anchors,
    "soil": soils,
    "code": codes,
}


def of_input(name: str, words: tuple[str, ...]) -> dict[str, Any]:
    """Say, for the option of a sizing's input, what completes it."""
    if words:
        return {"autocompletion": completed(lambda: words)}
    return {"autocompletion": completed(_OF_INPUTS[name])} if name in _OF_INPUTS else {}
