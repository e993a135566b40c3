"""A sentence that is English wherever it is read as text, and can be said in another language."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import Literal

from catopt.words.texts import LANGUAGES, Language, text


class Message(str):
    """A sentence by its key and values; as a `str` it is the English one.

    It compares, prints and is written as its English. Joining or formatting it into another string
    leaves plain English: a message that holds others takes them as values.

    Parameters
    ----------
    key : str
        ``GROUP.NAME`` in the table of texts.
    **values
        What stands in the braces of its text: numbers, a user's own words, other messages.

    Attributes
    ----------
    key : str
        The same.
    values : mapping
        The same.

    Raises
    ------
    KeyError
        There is no such text, or a value for it is missing: a fault of the program.

    Examples
    --------
    >>> from catopt.words import Message, say
    >>> warning = Message("catenary.rises", height=0.25)
    >>> print(warning)
    the line rises 0.25 m above the water surface; its weight there is taken as submerged
    >>> say(warning, "vi").startswith("dây nhô lên 0.25 m")
    True
    """

    key: str
    values: Mapping[str, object]

    def __new__(cls, key: str, /, **values: object) -> Message:
        """Fill the English text."""
        message = super().__new__(cls, text(key, "en", values).format(**values))
        message.key, message.values = key, values
        return message

    def said(self, language: Language) -> str:
        """Say it in a language."""
        values = {name: _said(value, language) for name, value in self.values.items()}
        return text(self.key, language, values).format(**values)

    def __reduce__(self) -> tuple[object, ...]:
        """Keep key and values when it is copied, or sent to another process."""
        return _remade, (self.key, dict(self.values))


class Several(Message):
    """Messages, or a user's own words, one after the other with a separator between them."""

    parts: tuple[str, ...]
    separator: str

    def __new__(cls, parts: Iterable[str], separator: str = "; ") -> Several:
        """Join the English texts."""
        kept = tuple(parts)
        message = str.__new__(cls, separator.join(kept))
        message.key, message.values = "", {}
        message.parts, message.separator = kept, separator
        return message

    def said(self, language: Language) -> str:
        """Say each in a language."""
        return self.separator.join(say(part, language) for part in self.parts)

    def __reduce__(self) -> tuple[object, ...]:
        """Keep the parts when it is copied, or sent to another process."""
        return Several, (self.parts, self.separator)


class Listed(Message):
    """Parts of a list, the last two with a word between them: ``a, b and c``.

    The word is "and" or "or"; in English it stands between all of them.
    """

    parts: tuple[str, ...]
    last: Literal["and", "or"]

    def __new__(cls, parts: Iterable[str], last: Literal["and", "or"]) -> Listed:
        """List the English texts."""
        kept = tuple(parts)
        message = str.__new__(cls, f" {last} ".join(kept))
        message.key, message.values = _WORDS[last], {}
        message.parts, message.last = kept, last
        return message

    def said(self, language: Language) -> str:
        """Say each in a language."""
        *first, last = (say(part, language) for part in self.parts)
        word = text(self.key, language, {})
        return f"{', '.join(first)} {word} {last}" if first else last

    def __reduce__(self) -> tuple[object, ...]:
        """Keep the parts when it is copied, or sent to another process."""
        return Listed, (self.parts, self.last)


_WORDS = {"and": "words.and", "or": "words.or"}


class Sentence(Message):
    """Words made a sentence: with a full stop, and a capital where it is wanted."""

    words: str
    capital: bool

    def __new__(cls, words: str, *, capital: bool = False) -> Sentence:
        """End the English text."""
        message = str.__new__(cls, _ended(words, capital))
        message.key, message.values = "", {}
        message.words, message.capital = words, capital
        return message

    def said(self, language: Language) -> str:
        """Say the words in a language."""
        return _ended(say(self.words, language), self.capital)

    def __reduce__(self) -> tuple[object, ...]:
        """Keep the words when it is copied, or sent to another process."""
        return partial(Sentence, capital=self.capital), (self.words,)


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
        kept: dict[Language, str] = {language: texts[language] for language in LANGUAGES}
        message = str.__new__(cls, kept["en"])
        message.key, message.values, message.texts = "", {}, kept
        return message

    def said(self, language: Language) -> str:
        """Say it in a language."""
        return self.texts[language]

    def __reduce__(self) -> tuple[object, ...]:
        """Keep the texts when it is copied, or sent to another process."""
        return Told, (self.texts,)


class Cited(str):
    """What is the same in every language: the title of a document, a formula without words."""

    __slots__ = ()


def say(said: str, language: Language) -> str:
    """Say a message in a language; any other text, a user's own words, stays as it is."""
    if not isinstance(said, Message):
        return said
    return str(said) if language == "en" else said.said(language)


def is_said(said: str, key: str) -> bool:
    """Whether a text is the message of a key."""
    return isinstance(said, Message) and said.key == key


def _said(value: object, language: Language) -> object:
    return say(value, language) if isinstance(value, str) else value


def _remade(key: str, values: Mapping[str, object]) -> Message:
    return Message(key, **values)
