"""A sentence that is English wherever it is read as text, and can be said in another language.

Its key is ``GROUP.NAME``; ``texts/GROUP.toml`` has a table of that name with one text a language.
What stands in braces is put in, with Python's formats. A text that depends on a number is two of
them, ``one`` and ``many``, chosen by the value called ``count``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from string import Formatter
from types import MappingProxyType
from typing import Any, Final, Literal, Protocol, Self, get_args

from catopt.quantities import QUANTITIES, Quantity, Units, places_of

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


_SIZE = re.compile(r"(?P<grade>.*?) ?\b(?P<size>[\d.]+ mm)")


def display_name(name: str, language: Language) -> str:
    """Say a buoy of the library, or a component with its size; any other text stays as it is.

    A family without a size stays, too: so it is typed.

    Examples
    --------
    >>> display_name("chain studless R3 76 mm", "vi"), display_name("chain studless R3", "vi")
    ('xích không ngáng R3 76 mm', 'chain studless R3')
    """
    names = _names(language)
    if name in names and name[-1:] == "m":
        return names[name]
    if not name.endswith(" mm"):
        return name
    for english in names:
        if name.startswith(f"{english} ") and _SIZE.fullmatch(name[len(english) + 1 :]):
            return names[english] + name[len(english) :]
    return name


@cache
def _names(language: Language) -> Mapping[str, str]:
    """Names by their English, the longer ones first."""
    found = {str(texts["en"]): str(texts[language]) for texts in group("names").values()}
    return dict(sorted(found.items(), key=lambda each: -len(each[0])))


def typed_name(said: str) -> str:
    """Take a name or a word that is shown in another language back to the one in code and data.

    Other text stays as it is; capitals do not matter.

    Examples
    --------
    >>> typed_name("phao trụ 1.8 m"), typed_name("Xích không ngáng R3"), typed_name("cát")
    ('pillar 1.8 m', 'chain studless R3', 'sand')
    """
    from unicodedata import normalize

    shown = _shown()
    plain = normalize("NFC", said.strip()).casefold()
    family = next((name for name in shown if plain.startswith(f"{name} ")), "")
    if plain in shown or not family:
        return shown.get(plain, said)
    return shown[family] + normalize("NFC", said.strip())[len(family) :]


@cache
def _shown() -> Mapping[str, str]:
    """Names and terms of code and data by what they are in other languages, longer ones first."""
    found: dict[str, str] = {}
    for name in ("names", "terms"):
        for texts in group(name).values():
            if isinstance(english := texts["en"], str):
                for language in LANGUAGES[1:]:
                    found.setdefault(str(texts[language]).casefold(), english)
    return dict(sorted(found.items(), key=lambda each: -len(each[0])))


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
    {language: _Filled("," if language == "en" else "\u00a0") for language in LANGUAGES}
)
"""A comma is the decimal sign of many other languages: beside a point it would mislead."""


def _filled(key: str, values: Mapping[str, object]) -> str:
    return _FILLED["en"].vformat(text(key, "en", values), (), values)


@cache
def _bare(key: str) -> str:
    """Fill a text without holes, once: tables of loads name each number at every angle."""
    return _filled(key, {})


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
        english = _filled(key, values) if values else _bare(key)
        return cls.made_of(english, key=key, values=values)

    @classmethod
    def made_of(cls, english: str, **parts: Any) -> Self:
        """Keep what a message is made of as attributes; documents have it by the same names."""
        message = str.__new__(cls, english)
        vars(message).update(parts)
        return message

    def said(self, language: Language) -> str:
        """Say it in a language."""
        # What is wrong names what is to be typed: of its values only the messages are said.
        kind = Message if self.key.startswith("refused") else str
        values = {
            name: say(value, language) if isinstance(value, kind) else value
            for name, value in self.values.items()
        }
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


def given_keys(keys: Iterable[str]) -> Message:
    """Say which of several keys were given, or that none was."""
    there = tuple(keys)
    return Listed(there, "and") if there else Message("refused_file.none_of_them")


class Sentence(Message):
    """Words made a sentence: with a full stop, and a capital where it is required."""

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


class Translated(Message):
    """A text of a data file, which has it in every language: ``{ en = "...", vi = "..." }``.

    Raises KeyError where a language is missing.
    """

    texts: Mapping[Language, str]

    def __new__(cls, texts: Mapping[Language, str]) -> Translated:
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
    return said if isinstance(said, Cited) else display_name(said, language)


def is_said(said: str, key: str) -> bool:
    """Whether a text is the message of a key."""
    return isinstance(said, Message) and said.key == key


_LARGE = 1e6
"""From here on numbers have an exponent."""


_NOTHING = 1e-6
"""In words, whatever the unit: less is rounding."""


def number(value: float, spec: str) -> str:
    """Write a number by a format; of significant digits without an exponent for what is large.

    What is not zero has two digits that count where the format would make it zero.

    Examples
    --------
    >>> number(1000.0, ".3g"), number(123456.0, ".3g"), number(2.5e6, ".3g"), number(-1e-9, ".3f")
    ('1000', '123000', '2.5e+06', '0.000')
    >>> number(0.00412, ".2f")
    '0.0041'
    """
    text = format(value, spec)
    if spec[-1:] == "f" and abs(value) > _NOTHING and not text.strip("-0.,"):
        text = format(value, f".{places_of(value, 0, 2)}f")
    if text.startswith("-") and not text.strip("-0."):  # rounded to zero, which has no sign
        return text[1:]
    has_exponent = "e+" in text and spec[-1:] == "g"
    return f"{float(text):.0f}" if has_exponent and abs(value) < _LARGE else text


@dataclass(frozen=True)
class Measure:
    """A value of a quantity, said in the field's unit: ``7300 kN``.

    Examples
    --------
    >>> from catopt.words import Measure
    >>> f"{Measure('tension', 7.3e6):.4g}"
    '7300 kN'
    """

    quantity: str  # key of `catopt.quantities.QUANTITIES`
    value: float  # SI
    units: Units = ""  # in which it is said, in place of the field's
    digits: int | None = None  # behind the decimal point there, in place of the quantity's own

    def __format__(self, spec: str) -> str:
        """Say the value with its unit, by the format of a number; ``bare`` is without the unit."""
        own = QUANTITIES[self.quantity]
        if self.digits is not None:
            own = replace(own, digits=self.digits)
        quantity = own.in_units(self.units)
        if spec in {"", "bare"}:
            return quantity.format(self.value, unit=not spec)
        return f"{number(quantity.to_field(self.value), spec)} {quantity.field_unit}"

    def __str__(self) -> str:
        return f"{self}"


@dataclass(frozen=True)
class Unit:
    """The unit of a quantity, said where its values stand without: ``kN``."""

    quantity: Quantity

    def __str__(self) -> str:
        return self.quantity.field_unit


class Term(Message):
    """A word that code or data have in English: ``"sand"``, ``"tanker"``.

    It is looked up when it is said in another language, to the letter, among the headings, the
    names of quantities and the group ``terms``, as a whole or, of a name like ``"storm, high
    water"``, by all of its parts; what is in none of them is said as plain text is.
    """

    def __new__(cls, term: str) -> Term:
        """Take the word."""
        return cls.made_of(term, term=term)

    def said(self, language: Language) -> str:
        """Say it in a language."""
        known = _terms()
        parts = [str(self)] if self in known else self.split(", ")
        if all(part in known for part in parts):
            return ", ".join(Message(known[part]).said(language) for part in parts)
        return display_name(str(self), language)


def term(english: str) -> Message:
    """Return a word that code or data have in English as a message; a message stays what it is."""
    return english if isinstance(english, Message) else Term(english)


def is_term(english: str) -> bool:
    """Whether a word is one that code or data have, and not a user's own."""
    return english in _terms()


@cache
def _terms() -> Mapping[str, str]:
    """Keys of the terms by their English; the first of several that are alike."""
    found: dict[str, str] = {}
    for name in ("terms", "columns", "quantities"):
        for key, texts in group(name).items():
            english = texts["en"]
            if isinstance(english, str):
                found.setdefault(english, f"{name}.{key}")
    return found


def quantity_name(key: str) -> Message:
    """Return the name of a quantity, by its key, as a message: ``Tension``."""
    return Message(f"quantities.{key}")


def heading(name: str, quantity: Quantity, language: Language = "en", *, si: bool = False) -> str:
    """Say the heading of a column of numbers: name, symbol and unit, or the SI unit.

    The name is a message or a user's own words; an empty symbol is left out.

    Examples
    --------
    >>> from catopt.quantities import QUANTITIES
    >>> from catopt.words import Message, heading
    >>> name = Message("columns.fairlead_tension")
    >>> heading(name, QUANTITIES["tension"])
    'Fairlead tension T (kN)'
    >>> heading(name, QUANTITIES["tension"], "vi")
    'Lực căng tại điểm treo T (kN)'
    """
    unit = say(term(quantity.si_unit if si else quantity.field_unit), language)
    return f"{f'{say(name, language)} {quantity.symbol}'.rstrip()} ({unit})"


TURNING: Final = "\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
"""Marks that turn the direction of writing, and so what a reader takes a text for."""
_ESCAPED: Final = {
    code: ascii(chr(code))[1:-1] for code in (*range(0x20), *range(0x7F, 0xA0), *map(ord, TURNING))
}
"""How what steers a terminal is told: control characters, and marks that turn the text about."""


def on_one_line(text: str) -> str:
    """Write a text so that nothing in it steers a terminal, a line break neither."""
    return text.translate(_ESCAPED)


class _Problem(Protocol):
    @property
    def key(self) -> str: ...
    @property
    def found(self) -> str: ...
    @property
    def allowed(self) -> str: ...


def say_refusal(source: str, problems: Iterable[_Problem], language: Language = "en") -> str:
    """Say all that is wrong with an input, as its error does in English."""
    every = tuple(problems)
    place = Several((term(source), ": "), "") if source else ""
    head = Message("refused.head", source=place, count=len(every))
    lines = (on_one_line(say(problem_words(problem), language)) for problem in every)
    return "\n".join([say(head, language), *(f"  {line}" for line in lines)])


def problem_words(problem: _Problem) -> Message:
    """Say one thing that is wrong: where, what is there, and what would be right."""
    key = "refused.found" if problem.found else "refused.not_found"
    return Message(key, key=problem.key, found=problem.found, allowed=problem.allowed)
