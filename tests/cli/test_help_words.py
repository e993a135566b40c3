"""`--help` in Vietnamese: every word of it, and no word for what is not there."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from typing import Any

import pytest

from catopt.cli.app import command
from catopt.cli.help_words import in_vietnamese, paragraphs, vietnamese

TELL = """
import json
from catopt.cli.app import command
from tests.cli.test_help_words import texts_of
print(json.dumps(texts_of(command)))
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


@pytest.fixture(scope="module")
def in_both() -> list[tuple[str, str, str]]:
    """Where each help stands, in English and in Vietnamese."""
    ran = subprocess.run(
        [sys.executable, "-c", TELL],
        env={**os.environ, "CATOPT_LANG": "vi", "PYTHONUTF8": "1"},
        capture_output=True,
        check=True,
        encoding="utf-8",
    )
    said = json.loads(ran.stdout)
    english = texts_of(command)
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


def test_no_vietnamese_help_is_of_words_that_are_gone() -> None:
    used = {one for english in texts_of(command).values() for one in paragraphs(english)}
    assert set(vietnamese()) - used == {"Show this message and exit."}


def test_names_that_are_typed_stay_as_they_are() -> None:
    """Options, files and words of options within a help are the same in both languages."""
    for english, said in vietnamese().items():
        for word in english.replace(",", " ").replace(";", " ").replace(":", " ").split():
            name = word.strip('."()')
            if name.startswith(("--", "[")) and name not in ("[OPTIONS]",):
                assert name in said, (name, said)


def test_the_help_of_a_command_has_no_english_heading() -> None:
    ran = subprocess.run(
        [sys.executable, "-m", "catopt", "export", "--help"],
        env={**os.environ, "CATOPT_LANG": "vi", "PYTHONUTF8": "1", "COLUMNS": "80"},
        capture_output=True,
        check=True,
        encoding="utf-8",
    )
    assert ran.stdout.startswith("Cách dùng: catopt export [TÙY CHỌN] {CASE}")
    assert "bắt buộc]" in ran.stdout
    assert "Hiện trang này rồi thoát." in ran.stdout
    assert not {"Usage", "Options", "Arguments", "required", "default"} & set(
        ran.stdout.replace("[", " ").replace("]", " ").replace(":", " ").split()
    )
    assert max(map(len, ran.stdout.splitlines())) <= 80


def test_what_is_not_in_the_table_stays() -> None:
    assert in_vietnamese("Case file (TOML).\n\nNever heard of.") == (
        "Tệp số liệu (TOML).\n\nNever heard of."
    )
