"""Why an input is refused, in a language: the head, and every problem below it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from catopt.words.labels import term
from catopt.words.message import Message, Several, say
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
    head = Message(
        "refused.head", source=Several((term(source), ": "), "") if source else "", count=len(every)
    )
    lines = (say(problem_words(each), language).replace("\n", "\\n") for each in every)
    return "\n".join([say(head, language), *(f"  {each}" for each in lines)])


def problem_words(problem: _Problem) -> Message:
    """Say one thing that is wrong: where, what is there, and what would be right."""
    key = "refused.found" if problem.found else "refused.not_found"
    return Message(key, key=problem.key, found=problem.found, allowed=problem.allowed)
