"""Asks on a terminal for what a sizing needs and was not told, each with its default."""

from __future__ import annotations

import sys
from collections.abc import Mapping

from catopt.casefile.reading import Moored
from catopt.cli.values import refused
from catopt.errors import InputError, Problem
from catopt.sizing.input_values import Spelling, is_needless
from catopt.sizing.inputs import Input, inputs_of
from catopt.sizing.kinds import choices_of, from_text, kind_of
from catopt.words import Cited, Language, Message, say, term
from catopt.words.message import problem_words

_OWN = "own"
"""Answer of one whose buoy is not in the library."""


def answered(
    moored: Moored,
    typed: Mapping[str, object],
    given: Mapping[str, object],
    spell: Spelling,
    language: Language,
) -> dict[str, object]:
    """Ask on standard error, when what is required was not given and somebody can answer.

    `typed` are inputs as they were typed, `given` all that are known, those of a file among them.
    Returns what was typed with the answers, defaults among them.
    """
    answers = dict(typed)
    inputs = inputs_of(moored)
    is_known = {**given, **answers}
    missing = [
        name
        for name, row in inputs.items()
        if row.required and name not in is_known and not is_needless(row, is_known)
    ]
    if not missing or sys.stdin is None or not sys.stdin.isatty():
        return answers
    # What is moored, where and in what weather come first; the room is a question of its own.
    for name, row in sorted(inputs.items(), key=lambda pair: pair[0] == "max_swing"):
        is_known = {**given, **answers}
        is_held = name == "max_swing" and str(is_known.get("lines", 1)) != "1"  # by several lines
        if row.asked and name not in is_known and not is_needless(row, is_known) and not is_held:
            default = str(row.example) if name == "buoy" else row.default
            if name == "low_water":
                default = str(is_known["depth"])
            answers[name] = _answer(row, spell(name), default, language)
            if answers[name] in {_OWN, ""}:
                del answers[name]
    return answers


def _answer(each: Input, spelled: str, default: str, language: Language) -> object:
    """Ask until the answer can be read; the return key gives the default, if there is one."""
    choices = (*choices_of(each), *([_OWN] if each.name == "buoy" else []))
    if choices:
        _say(f"  {say(term('one of'), language)}: {'; '.join(choices)}\n")
    if default:
        beside = Message("left_out.offered", default=Cited(default))
    else:
        of_all = each.required or each.name == "buoy"
        key = "left_out.asked" if of_all else "left_out.asked_or_blank"
        beside = Message(key, example=Cited(each.example))
    question = say(Message(f"inputs.{each.name}"), language) + say(beside, language)
    while True:
        _say(f"{question}: ")
        line = sys.stdin.readline()
        if not line:
            raise refused(spelled, "", Message("refused_command.missing_nobody_answered"))
        answer = from_text(each, line.strip() or default)
        wrong = _wrong(each, spelled, answer, choices)
        if not wrong:
            return answer
        _say(f"  {say(wrong, language)}\n")


def _say(words: str) -> None:
    sys.stderr.write(words)
    sys.stderr.flush()


def _wrong(each: Input, spelled: str, answer: object, choices: tuple[str, ...]) -> str:
    """Say what is wrong with an answer; empty when nothing is."""
    if answer == "":
        return term("an answer is required") if each.required else ""
    if choices:
        return "" if answer in choices else Message("answers.none_of_them", answer=answer)
    try:
        kind_of(each).read(answer)
    except InputError as error:
        (problem,) = error.problems
        return problem_words(Problem(spelled, problem.found, problem.allowed))
    return ""
