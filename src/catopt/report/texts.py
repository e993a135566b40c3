"""What a report says in words, in English and in Vietnamese, out of one table.

The table is the files of ``vocabulary/`` taken together, each with up to three parts. Under
``[texts.GROUP]`` texts of templates and views stand by a key, in both languages; what stands in
braces is put in. Under ``[names]`` what the code calls things in English (quantities, regimes,
checks), with the Vietnamese. Under ``[sentences]`` sentences that the code makes, such as warnings,
by their pattern: what a placeholder holds goes over as it is, but is itself translated where its
name begins with ``said``.

Vietnamese terms are those of the sources: góc nghiêng dây neo tại đáy, độ dạt ngang, lực căng, khối
gia tải, neo, phao, xích, mực nước, tải trọng, hệ số an toàn. Numbers keep the decimal point.
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
    """Read the table of texts: parts, groups and keys of all files of ``vocabulary/``.

    Raises
    ------
    ValueError
        A text stands in two files: a fault of the program.
    """
    import tomllib
    from importlib.resources import files

    places = files("catopt.report").joinpath("vocabulary").iterdir()
    whole: dict[str, Any] = {}
    for place in sorted(places, key=lambda each: each.name):
        _put_in(whole, tomllib.loads(place.read_text("utf-8")), place.name)
    return whole


def _put_in(whole: dict[str, Any], part: Mapping[str, Any], file: str) -> None:
    """Put what a file has in; a table that the whole has already grows."""
    for key, value in part.items():
        is_text = isinstance(value, str) or set(value) == set(LANGUAGES)
        if is_text and key in whole:
            raise ValueError(f"{file}: {key!r} stands in another file of texts already")
        if is_text:
            whole[key] = value
        else:
            _put_in(whole.setdefault(key, {}), value, file)


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
        """Translate a sentence that the code made; English where the table has no pattern of it.

        A sentence that the table has without a full stop is found with one, too.
        """
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
        if english.endswith("."):
            bare = self.sentence(english[:-1])
            return Phrase(english, "en") if bare.lang else Phrase(f"{bare.text}.")
        return Phrase(english, "en")

    def sentences(self, english: str) -> str:
        """Translate sentences that semicolons join, each by itself; what has no pattern stays.

        The shortest that the table has is taken first, for the holes of one must not swallow the
        next; some have a semicolon of their own.
        """
        if self.language == "en":
            return english
        parts, told = english.split("; "), []
        while parts:
            tried = range(1, len(parts) + 1)
            count = next((n for n in tried if _is_known("; ".join(parts[:n]))), 1)
            told.append(self.sentence("; ".join(parts[:count])).text)
            parts = parts[count:]
        return "; ".join(told)


def _is_known(english: str) -> bool:
    """Whether the table has a name or a sentence with all that it holds."""
    if english in table()["names"]:
        return True
    for pattern, _ in _patterns():
        match = pattern.fullmatch(english)
        if match is not None:
            held = match.groupdict().items()
            return all(_is_known(value) for key, value in held if key.startswith(_SAID))
    return english.endswith(".") and _is_known(english[:-1])


def _split(heading: str) -> tuple[str, str]:
    """Split a heading into its label and its unit in brackets, if it has one."""
    label, bracket, unit = heading.rpartition(" (")
    return (label, f"{bracket}{unit}") if bracket and unit.endswith(")") else (heading, "")


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    """Sentences with holes as regular expressions, each with its Vietnamese; the fullest first.

    Of two that fit, the one that says more itself is meant: its holes are the smaller ones.
    """
    told: Mapping[str, str] = table()["sentences"]
    fullest = sorted(told, key=_words_of_its_own, reverse=True)
    return tuple((_pattern(english), told[english]) for english in fullest)


def _words_of_its_own(pattern: str) -> int:
    """Count the letters of a pattern that stand outside of its holes."""
    return sum(len(literal) for literal, _, _, _ in Formatter().parse(pattern))


def _pattern(english: str) -> re.Pattern[str]:
    parts = []
    for literal, hole, _, _ in Formatter().parse(english):
        parts.append(re.escape(literal))
        if hole is not None:
            parts.append(f"(?P<{hole}>.+?)")
    return re.compile("".join(parts), re.DOTALL)
