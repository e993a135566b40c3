"""The table of texts: every message in every language, by its key.

A key is ``GROUP.NAME``; ``texts/GROUP.toml`` has a table of that name with one text a language.
What stands in braces is put in, with Python's formats. A text that depends on a number is two of
them, ``one`` and ``many``, chosen by the value called ``count``.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, Literal, get_args

__all__ = ["LANGUAGES", "Language", "group", "groups", "text"]

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
    """Read one file of texts.

    Raises
    ------
    FileNotFoundError
        There is no such group: a fault of the program.
    """
    import tomllib
    from importlib.resources import files

    read: dict[str, Any] = tomllib.loads(
        files("catopt.words").joinpath("texts", f"{name}.toml").read_text("utf-8")
    )
    return read


def text(key: str, language: Language, values: Mapping[str, object]) -> str:
    """Look up the text of a key, with its holes.

    Parameters
    ----------
    key : str
        ``GROUP.NAME``.
    language : {"en", "vi"}
        In which it is wanted.
    values : mapping
        What is put in; ``count`` chooses between the texts for one and for many.

    Raises
    ------
    KeyError
        There is no such text: a fault of the program.
    """
    where, _, name = key.partition(".")
    found = group(where)[name][language]
    if isinstance(found, str):
        return found
    return found["one" if values["count"] == 1 else "many"]
