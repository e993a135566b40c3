"""A sentence that is English wherever it is read as text, and can be said in another language."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from string import Formatter
from types import MappingProxyType
from typing import Any, Literal, Self

from catopt.words.measure import number
from catopt.words.names import shown_name
from catopt.words.texts import LANGUAGES, Language, text


class _Filled(Formatter):
    """Fills a text as `str.format` does; no number has an exponent that people do not read.

    `thousands` stands between the digits of a number whose format asks for commas.
    """

    def __init__(self, thousands: str = ",") -> None:
        self._thousands = thousands

    def format_field(self, value: Any, format_spec: str) -> Any:
        if isinstance(value, float | int) and format_spec:
            return number(value, format_spec).replace(",", self._thousands)
        return super().format_field(value, format_spec)


_FILLED: Mapping[Language, _Filled] = MappingProxyType(
    {each: _Filled("," if each == "en" else "\N{NO-BREAK SPACE}") for each in LANGUAGES}
)
"""A comma is the decimal sign of many other languages: beside a point it would mislead."""


class Message(str):
    """A sentence by its key and values; as a `str` it is the English one.

    It compares, prints and is written as its English. Joining or formatting it into another string
    leaves plain English: a message that holds others takes them as values.

    `key` is ``GROUP.NAME`` in the table of texts; `values` stand in the braces of its text:
    numbers, a user's own words, other messages. KeyError, a fault of the program, where there is no
    such text or a value for it is missing.

    Examples
    --------
    >>> from catopt.words import Message, say
    >>> warning = Message("catenary.rises", height=0.25)
    >>> print(warning)
    the line rises 0.25 m above the water surface; its weight there is taken as submerged
    >>> say(warning, "vi").startswith("dây nhô lên 0.25 m")
    True
    """

    key: str = ""
    values: Mapping[str, object] = MappingProxyType({})

    def __new__(cls, key: str, /, **values: object) -> Message:
        """Fill the English text."""
        english = _FILLED["en"].vformat(text(key, "en", values), (), values)
        return cls.made_of(english, key=key, values=values)

    @classmethod
    def made_of(cls, english: str, **parts: Any) -> Self:
        """Keep what a message is made of as attributes; documents have it by the same names."""
        message = str.__new__(cls, english)
        vars(message).update(parts)
        return message

    def said(self, language: Language) -> str:
        """Say it in a language."""
        is_typed = self.key.startswith("refused")  # what is wrong names what is to be typed
        values = {name: _said(value, language, is_typed) for name, value in self.values.items()}
        return _FILLED[language].vformat(text(self.key, language, values), (), values)

    def __reduce__(self) -> tuple[object, ...]:
        """Keep what it is made of when it is copied, or sent to another process."""
        return str.__new__, (type(self), str(self)), vars(self)


class Several(Message):
    """Messages, or a user's own words, one after the other with a separator between them."""

    parts: tuple[str, ...]
    separator: str

    def __new__(cls, parts: Iterable[str], separator: str = "; ") -> Several:
        """Join the English texts."""
        kept = tuple(parts)
        return cls.made_of(separator.join(kept), separator=separator, parts=kept)

    def said(self, language: Language) -> str:
        """Say each in a language."""
        return self.separator.join(say(part, language) for part in self.parts)


class Listed(Message):
    """Parts of a list, the last two with a word between them: ``a, b and c``.

    The word is "and" or "or"; in English it stands between all of them.
    """

    parts: tuple[str, ...]
    last: Literal["and", "or"]

    def __new__(cls, parts: Iterable[str], last: Literal["and", "or"]) -> Listed:
        """List the English texts."""
        kept = tuple(parts)
        return cls.made_of(f" {last} ".join(kept), last=last, parts=kept)

    def said(self, language: Language) -> str:
        """Say each in a language."""
        *first, last = (say(part, language) for part in self.parts)
        word = text(f"words.{self.last}", language, {})
        return f"{', '.join(first)} {word} {last}" if first else last


class Sentence(Message):
    """Words made a sentence: with a full stop, and a capital where it is wanted."""

    words: str
    capital: bool

    def __new__(cls, words: str, *, capital: bool = False) -> Sentence:
        """End the English text."""
        return cls.made_of(_ended(words, capital), words=words, capital=capital)

    def said(self, language: Language) -> str:
        """Say the words in a language."""
        return _ended(say(self.words, language), self.capital)


def _ended(words: str, capital: bool) -> str:
    first = words[:1].upper() if capital else words[:1]
    return f"{first}{words[1:].rstrip('.')}."


class Told(Message):
    """A text of a data file, which has it in every language: ``{ en = "...", vi = "..." }``.

    Raises KeyError where a language is missing.
    """

    texts: Mapping[Language, str]

    def __new__(cls, texts: Mapping[Language, str]) -> Told:
        """Take the English text."""
        kept = {language: texts[language] for language in LANGUAGES}
        return cls.made_of(kept["en"], texts=kept)

    def said(self, language: Language) -> str:
        """Say it in a language."""
        return self.texts[language]


class Cited(str):
    """What is the same in every language: the title of a document, a formula without words."""

    __slots__ = ()


def say(said: str, language: Language) -> str:
    """Say a message in a language; any other text, a user's own words, stays as it is.

    A component with its size, or a buoy of the library, is shown by its name there.
    """
    if language == "en":
        return str(said) if isinstance(said, Message) else said
    if isinstance(said, Message):
        return said.said(language)
    return said if isinstance(said, Cited) else shown_name(said, language)


def is_said(said: str, key: str) -> bool:
    """Whether a text is the message of a key."""
    return isinstance(said, Message) and said.key == key


def _said(value: object, language: Language, is_typed: bool) -> object:
    if not isinstance(value, str) or (is_typed and not isinstance(value, Message)):
        return value
    return say(value, language)
