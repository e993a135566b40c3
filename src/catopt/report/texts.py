"""What a report says in words, in English and in Vietnamese, out of one table.

``texts.toml`` has three parts. Texts of templates and builders stand by a key, in both languages.
Names that the code makes in English (quantities, regimes, checks) stand by that name. Sentences
that it makes, such as warnings, stand by their pattern.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from string import Formatter
from typing import Any, Literal, NamedTuple, get_args

__all__ = ["LANGUAGES", "Language", "Phrase", "Words", "table"]

Language = Literal["en", "vi"]
LANGUAGES: tuple[Language, ...] = get_args(Language)

_SAID = "said"
"""A placeholder that begins so holds a sentence or a name, which is translated, too."""


class Phrase(NamedTuple):
    """A sentence that the code made, in the language of the report where the table has it.

    Attributes
    ----------
    text : str
        What it says.
    lang : str
        ``"en"`` where it had to stay English; empty where it is in the report's language.
    """

    text: str
    lang: str = ""


@cache
def table() -> dict[str, Any]:
    """Read the table of texts: parts, groups and keys as the file has them."""
    import tomllib
    from importlib.resources import files

    return tomllib.loads(files("catopt.report").joinpath("texts.toml").read_text("utf-8"))


class Words:
    """The texts of one language.

    Parameters
    ----------
    language : {"en", "vi"}
        Of the report.

    Attributes
    ----------
    language : str
        The same.
    """

    def __init__(self, language: Language = "en") -> None:
        self.language = language

    def __call__(self, key: str, /, **values: object) -> str:
        """Return a text by its key: ``words("line.heading")``.

        Parameters
        ----------
        key : str
            Group and name with a dot between them.
        **values
            What stands in the text's braces.

        Raises
        ------
        KeyError
            There is no such text, or a value for it is missing: a fault of the program.
        """
        group, _, name = key.partition(".")
        texts: Mapping[str, Mapping[str, Mapping[str, str]]] = table()["texts"]
        return texts[group][name][self.language].format(**values)

    def name(self, english: str) -> str:
        """Translate a name that the code has in English; as it is where the table lacks it."""
        if self.language == "en":
            return english
        names: Mapping[str, str] = table()["names"]
        return names.get(english, english)

    def heading(self, english: str) -> str:
        """Translate a heading that the code has in English: name, symbol and unit.

        ``"Span S (m)"`` becomes ``"Độ dạt ngang S (m)"``; what the table lacks stays as it is.
        """
        names: Mapping[str, str] = {} if self.language == "en" else table()["names"]
        if self.language == "en" or english in names:
            return names.get(english, english)
        label, unit = _split(english)
        name, _, symbol = label.rpartition(" ")
        for said, rest in ((label, ""), (name, f" {symbol}")):
            found = self.sentence(said)
            if said and not found.lang:
                return f"{found.text}{rest}{unit}"
        return english

    def sentence(self, english: str) -> Phrase:
        """Translate a sentence that the code made; English where the table has no pattern of it."""
        if self.language == "en" or not english:
            return Phrase(english)
        if english in table()["names"]:
            return Phrase(self.name(english))
        for pattern, text in _patterns():
            match = pattern.fullmatch(english)
            if match is not None:
                values = {
                    key: self.sentence(value).text if key.startswith(_SAID) else value
                    for key, value in match.groupdict().items()
                }
                return Phrase(text.format(**values))
        return Phrase(english, "en")


def _split(heading: str) -> tuple[str, str]:
    """Split a heading into its label and its unit in brackets, if it has one."""
    label, bracket, unit = heading.rpartition(" (")
    return (label, f"{bracket}{unit}") if bracket and unit.endswith(")") else (heading, "")


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    """Sentences with holes as regular expressions, each with its Vietnamese."""
    return tuple((_pattern(english), text) for english, text in table()["sentences"].items())


def _pattern(english: str) -> re.Pattern[str]:
    parts = []
    for literal, hole, _, _ in Formatter().parse(english):
        parts.append(re.escape(literal))
        if hole is not None:
            parts.append(f"(?P<{hole}>.+?)")
    return re.compile("".join(parts), re.DOTALL)
