"""The table of the help: every text in both languages, and no text for what is not there."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from typing import Any

import pytest

from catopt.cli.help_words import put_words, table

from .command_page import whole

TELL = """
import json
from catopt.cli.help_words import put_words
from tests.cli.command_page import whole
from tests.cli.test_help_words import texts_of
put_words(whole())
print(json.dumps(texts_of(whole())))
"""


def texts_of(command: Any, path: str = "catopt") -> dict[str, str]:
    """Every help of a command and of all below it, by where it stands."""
    found = {
        f"{path} {key}": getattr(command, key)
        for key in ("help", "short_help", "epilog")
        if getattr(command, key, None)
    }
    found |= {
        f"{path} {each.name}": each.help for each in command.params if getattr(each, "help", None)
    }
    for name, each in getattr(command, "commands", {}).items():
        found |= texts_of(each, f"{path} {name}")
    return found


def paragraphs(text: str) -> list[str]:
    """Split a help into paragraphs, each on one line."""
    return [" ".join(each.split()) for each in text.split("\n\n")]


def texts_of_table(read: dict[str, Any], place: str = "") -> dict[str, dict[str, str]]:
    """Every text of the table, in its languages, by its key."""
    if isinstance(read.get("en"), str):
        return {place: read}
    found: dict[str, dict[str, str]] = {}
    for key, below in read.items():
        found |= texts_of_table(below, f"{place}.{key}".lstrip("."))
    return found


def in_vietnamese(*arguments: str) -> str:
    """Run Python where the user has set the language; return what it prints."""
    settings = {"CATOPT_LANG": "vi", "PYTHONUTF8": "1", "COLUMNS": "80"}
    return subprocess.run(
        [sys.executable, *arguments], env={**os.environ, **settings},
        capture_output=True, check=True, encoding="utf-8",
    ).stdout  # fmt: skip


@pytest.fixture(scope="module")
def in_both() -> list[tuple[str, str, str]]:
    """Where each help stands, in English and in Vietnamese."""
    said = json.loads(in_vietnamese("-c", TELL))
    put_words(whole())
    english = texts_of(whole())
    assert said.keys() == english.keys()
    return [(where, english[where], said[where]) for where in english]


def test_every_help_is_in_vietnamese(in_both: list[tuple[str, str, str]]) -> None:
    assert len(in_both) > 250
    untold = [
        (where, one)
        for where, english, other in in_both
        for one, said in zip(paragraphs(english), paragraphs(other), strict=True)
        if said == one
    ]
    assert not untold


def test_no_help_is_of_what_is_gone(in_both: list[tuple[str, str, str]]) -> None:
    english = {text.strip() for _, text, _ in in_both}
    assert [key for key, each in texts_of_table(table()).items() if each["en"] not in english] == []


def test_every_option_and_every_command_has_its_help(in_both: list[tuple[str, str, str]]) -> None:
    """None shows the docstring of its function, or the key of a text."""
    words = {each["en"] for each in texts_of_table(table()).values()}
    without = [where for where, english, _ in in_both if english not in words]
    assert all(re.match(r"catopt (size|loads) (buoy|tanker|ship) ", where) for where in without)


def test_names_that_are_typed_stay_as_they_are() -> None:
    """Options, files and words of options within a help are the same in both languages."""
    for texts in texts_of_table(table()).values():
        english, said = texts["en"], texts["vi"]
        for word in english.replace(",", " ").replace(";", " ").replace(":", " ").split():
            name = word.strip('."()')
            if name.startswith(("--", "[")) and name not in ("[OPTIONS]",):
                assert name in said, (name, said)


def test_the_help_of_a_command_has_no_english_heading() -> None:
    shown = in_vietnamese("-m", "catopt", "export", "--help-all")
    assert shown.startswith("Cách dùng: catopt export [TÙY CHỌN] {CASE}")
    assert "bắt buộc]" in shown
    assert "Hiện trang này rồi thoát." in shown
    assert not {"Usage", "Options", "Arguments", "required", "default"} & set(
        shown.replace("[", " ").replace("]", " ").replace(":", " ").split()
    )
    assert max(map(len, shown.splitlines())) <= 80
