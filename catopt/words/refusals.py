"""Why an input is refused, in a language: the head, and every problem below it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from catopt.words.message import Message, say
from catopt.words.texts import Language


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
    head = Message("refused.head", source=f"{source}: " if source else "", count=len(every))
    return "\n".join([say(head, language), *(f"  {_said(each, language)}" for each in every)])


def _said(problem: _Problem, language: Language) -> str:
    key = "refused.found" if problem.found else "refused.not_found"
    values = {"key": problem.key, "found": problem.found, "allowed": problem.allowed}
    return say(Message(key, **values), language).replace("\n", "\\n")
