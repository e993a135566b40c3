"""Names of quantities and headings of columns, in every language."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from typing import Protocol

from catopt.quantities import Quantity
from catopt.words.message import Language, Message, Several, group, say, shown_name


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
        return shown_name(str(self), language)


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
    unit = quantity.si_unit if si else quantity.field_unit
    return f"{f'{say(name, language)} {quantity.symbol}'.rstrip()} ({unit})"


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
    lines = (say(problem_words(each), language).replace("\n", "\\n") for each in every)
    return "\n".join([say(head, language), *(f"  {each}" for each in lines)])


def problem_words(problem: _Problem) -> Message:
    """Say one thing that is wrong: where, what is there, and what would be right."""
    key = "refused.found" if problem.found else "refused.not_found"
    return Message(key, key=problem.key, found=problem.found, allowed=problem.allowed)
