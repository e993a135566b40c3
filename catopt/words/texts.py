"""The table of texts: every message in every language, by its key.

A key is ``GROUP.NAME``; ``texts/GROUP.toml`` has a table of that name with one text a language.
What stands in braces is put in, with Python's formats. A text that depends on a number is two of
them, ``one`` and ``many``, chosen by the value called ``count``.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, Literal, get_args

Language = Literal["en", "vi"]
LANGUAGES: tuple[Language, ...] = get_args(Language)

Text = str | Mapping[Literal["one", "many"], str]


def groups() -> list[str]:
    """List the names of the groups."""
    from importlib.resources import files

    places = files("catopt.words").joinpath("texts").iterdir()
    return sorted(place.name.removesuffix(".toml") for place in places)


@cache
def group(name: str) -> Mapping[str, Mapping[Language, Text]]:
    """Read one file of texts; FileNotFoundError, a fault of the program, where there is none."""
    import tomllib
    from importlib.resources import files

    read: dict[str, Any] = tomllib.loads(
        files("catopt.words").joinpath("texts", f"{name}.toml").read_text("utf-8")
    )
    return read


def text(key: str, language: Language, values: Mapping[str, object]) -> str:
    """Look up the text of a key ``GROUP.NAME``, with its holes, in a language.

    ``count`` among the values chooses between the texts for one and for many. Raises KeyError, a
    fault of the program, where there is no such text.
    """
    where, _, name = key.partition(".")
    found = group(where)[name][language]
    if isinstance(found, str):
        return found
    return found["one" if values["count"] == 1 else "many"]
