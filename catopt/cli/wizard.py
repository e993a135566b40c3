"""Asks on a terminal for what a command was not told, each with its default."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from catopt.errors import InputError, Problem
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.render.texts import Words
    from catopt.units import Dimension

__all__ = ["Question", "ask", "is_watched"]


class Question(NamedTuple):
    """What is asked.

    Attributes
    ----------
    option : str
        Name of the option that it is an answer to.
    words : str
        The question, in English.
    default : str
        Taken at the return key; empty where an answer is needed.
    dimension : Dimension or None
        Of the value; None for a text.
    choices : tuple of str
        Texts to choose from; empty: any.
    """

    option: str
    words: str
    default: str
    dimension: Dimension | None = None
    choices: tuple[str, ...] = ()


def is_watched() -> bool:
    """Say whether somebody can answer: standard input is a terminal."""
    return bool(sys.stdin is not None and sys.stdin.isatty())


def ask(
    questions: Sequence[Question], given: Mapping[str, str | None], words: Words
) -> dict[str, str]:
    """Ask every question whose option was not given; on standard error.

    Parameters
    ----------
    questions : sequence of Question
        In order.
    given : mapping of str to str or None
        Options as they were given; None: left out.
    words : Words
        Language.

    Returns
    -------
    dict of str to str
        Answers by option, defaults among them.
    """
    return {
        each.option: _answer(each, words) for each in questions if given.get(each.option) is None
    }


def _answer(question: Question, words: Words) -> str:
    """Ask until the answer can be read."""
    if question.choices:
        _say(f"  {words.name('one of')}: {'; '.join(question.choices)}\n")
    offered = f" [{question.default}]" if question.default else ""
    while True:
        _say(f"{words.name(question.words)}{offered}: ")
        line = sys.stdin.readline()
        if not line:
            raise InputError([Problem(question.option, "", "missing; nobody answered")], "options")
        answer = line.strip() or question.default
        wrong = words.sentence(_wrong(question, answer)).text
        if not wrong:
            return answer
        _say(f"  {wrong}\n")


def _say(words: str) -> None:
    sys.stderr.write(words)
    sys.stderr.flush()


def _wrong(question: Question, answer: str) -> str:
    """Say what is wrong with an answer; empty when nothing is."""
    if not answer:
        return "an answer is wanted"
    if question.choices and answer not in question.choices:
        return Message("answers.none_of_them", answer=answer)
    if question.dimension is None:
        return ""
    from catopt.cli.values import in_si

    try:
        in_si({question.option: (answer, question.dimension)})
    except InputError as error:
        return "; ".join(str(problem) for problem in error.problems)
    return ""
