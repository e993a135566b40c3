"""Case files as users break them, each with its whole message.

Beside every ``broken/NAME.toml`` stands ``broken/NAME.txt``, the message word for word.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from catopt.casefile import read_case
from catopt.errors import InputError, Problem
from catopt.words import Language, Message, say
from catopt.words.message import say_refusal

BROKEN = Path(__file__).parent / "broken"
NAMES = sorted(path.stem for path in BROKEN.glob("*.toml"))


@pytest.mark.parametrize("name", NAMES)
def test_the_message_is_exactly_this(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(BROKEN)
    with pytest.raises(InputError) as caught:
        read_case(f"{name}.toml")
    expected = (BROKEN / f"{name}.txt").read_text(encoding="utf-8")
    assert f"{caught.value}\n" == expected


def test_every_broken_file_has_its_message() -> None:
    assert sorted(path.stem for path in BROKEN.glob("*.txt")) == NAMES
    assert len(NAMES) >= 20


@pytest.mark.parametrize("name", NAMES)
def test_every_refusal_is_said_in_vietnamese(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """What would be right is a message, with a text in Vietnamese that is not the English one."""
    monkeypatch.chdir(BROKEN)
    with pytest.raises(InputError) as caught:
        read_case(f"{name}.toml")
    for problem in caught.value.problems:
        assert isinstance(problem.allowed, Message), problem.allowed
        assert say(problem.allowed, "vi") != problem.allowed
    said = say_refusal(caught.value.source, caught.value.problems, "vi")
    assert f"{len(caught.value.problems)} lỗi" in said
    below = said.partition("\n")[2]
    assert not re.search(r"\b(is required|must be|leave it|did you mean|missing|found)\b", below)
    english = say_refusal(caught.value.source, caught.value.problems)
    assert english == str(caught.value)


@pytest.mark.parametrize("language", ["en", "vi"])
def test_nothing_in_a_refusal_steers_a_terminal(language: Language) -> None:
    """A line break, a colour, a vertical tab, and a mark that turns the text about."""
    wrong = Problem("a\x0bb", "\x1b[31m\u202e\u200f", "one\ntwo")
    said = say_refusal("", [wrong], language)
    assert re.findall(r"[\x00-\x09\x0b-\x1f\u202e\u200f]", said) == []
    assert said.count("\n") == 1
    for each in (said, f"  {wrong}"):
        assert r"a\x0bb" in each
        assert r"\x1b[31m\u202e\u200f" in each
