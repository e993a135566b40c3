"""What a report says in words, in English and in Vietnamese, out of one table.

The table is the files of ``vocabulary/`` taken together: texts of templates and views by a key, in
both languages; what stands in braces is put in. What the code itself says is in `catopt.words`:
messages, and the words that it has in English.

Vietnamese terms are those of the sources: góc nghiêng dây neo tại đáy, độ dạt ngang, lực căng, khối
gia tải, neo, phao, xích, mực nước, tải trọng, hệ số an toàn. Numbers keep the decimal point.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

from catopt.words import LANGUAGES, Language, Message, is_term, say, term

__all__ = ["LANGUAGES", "Language", "Phrase", "Words", "table"]


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

    places = files("catopt.render").joinpath("vocabulary").iterdir()
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
        return english if self.language == "en" else say(term(english), self.language)

    def heading(self, english: str) -> str:
        """Translate a heading that the code has in English: name, symbol and unit.

        ``"Span S (m)"`` becomes ``"Độ dạt ngang S (m)"``; what the table lacks stays as it is.
        """
        if self.language == "en" or isinstance(english, Message) or is_term(english):
            return self.name(english)
        label, unit = _split(english)
        name, _, symbol = label.rpartition(" ")
        for said, rest in ((label, ""), (name, f" {symbol}")):
            if is_term(said):
                return f"{self.name(said)}{rest}{unit}"
        return english

    def sentence(self, english: str) -> Phrase:
        """Say a message, or a word that the code has in English; any other text stays as it is."""
        if self.language == "en" or not english:
            return Phrase(english)
        if isinstance(english, Message) or is_term(english):
            return Phrase(self.name(english))
        return Phrase(english, "en")

    def warning(self, said: str) -> str:
        """Say that something is a warning."""
        return self.sentence(Message("answers.warning", warning=said)).text


def _split(heading: str) -> tuple[str, str]:
    """Split a heading into its label and its unit in brackets, if it has one."""
    label, bracket, unit = heading.rpartition(" (")
    return (label, f"{bracket}{unit}") if bracket and unit.endswith(")") else (heading, "")
