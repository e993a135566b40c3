"""Completion of names by the shells' own protocol: what a shell asks and what it is given."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable

import pytest

from catopt.loads.sinker import SOIL_FRICTION

from .conftest import Run


def asked(shell: str, words: str) -> dict[str, str]:
    """Return what the script of a shell sets; what is typed last is begun, or a space."""
    begun = "" if words.endswith(" ") else words.split()[-1]
    return {
        "_CATOPT_COMPLETE": f"complete_{shell}",
        "COMP_WORDS": words,
        "COMP_CWORD": str(len(words.split()) - bool(begun)),
        "_TYPER_COMPLETE_ARGS": words,
        "_TYPER_COMPLETE_FISH_ACTION": "get-args",
        "_TYPER_COMPLETE_WORD_TO_COMPLETE": begun,
    }


Completed = Callable[[str, str], list[str]]


@pytest.fixture
def completed(run: Run, monkeypatch: pytest.MonkeyPatch) -> Completed:
    """Ask as a shell does, and take what it is given."""

    def complete(shell: str, words: str) -> list[str]:
        for name, value in asked(shell, words).items():
            monkeypatch.setenv(name, value)
        ran = run()
        assert (ran.status, ran.err) == (0, "")
        return ran.out.split("\n")[:-1]

    return complete


def test_a_shell_is_answered() -> None:
    """The one test that starts a process, as the shell does."""
    ran = subprocess.run(
        [sys.executable, "-m", "catopt"],
        env={**os.environ, **asked("bash", "catopt new size-")},
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    assert (ran.stdout, ran.stderr) == ("size-buoy\nsize-tanker\n", "")


@pytest.mark.parametrize(
    ("words", "some"),
    [
        ("catopt st", ["study"]),
        ("catopt new ", ["buoy", "size-tanker"]),
        ("catopt reproduce o", ["oc3", "oc4"]),
        ("catopt check case.toml --code API", ["API-RP-2SK"]),
        ("catopt size tanker --soil ", ["sand", "soft\\ clay"]),
        ("catopt size tanker --anchor Stev", ["Stevpris\\ Mk5"]),
        ("catopt size buoy --prefer l", ["lightest", "least-swing"]),
        ("catopt size buoy --sinker ", ["concrete", "steel"]),
        ("catopt size buoy --chain ", ["chain\\ studless\\ R3", "chain\\ open-link\\ 9D"]),
        ("catopt size buoy pil", ["pillar\\ 1.8\\ m"]),
        ('catopt size buoy "pil', ["pillar 1.8 m"]),  # an open quote needs no escape
        ("catopt loads buoy pil", ["pillar\\ 1.8\\ m"]),
        ("catopt size buoy --chain chain", ["chain\\ studless\\ R3"]),
        ("catopt catalog show chain", ["chain\\ studless"]),
        ("catopt export case.toml --to mo", ["moordyn", "moorpy"]),
        ("catopt solve --units t", ["tf"]),
    ],
)
def test_bash(completed: Completed, words: str, some: list[str]) -> None:
    found = completed("bash", words)
    assert set(some) <= set(found), found


@pytest.mark.parametrize(
    ("words", "none"),
    [
        ("catopt size buoy --soil ", ["medium\\ clay", "soft\\ clay"]),
        ("catopt size tanker --soil ", ["fine\\ or\\ silty\\ sand"]),
        ("catopt size tanker --anchor sinker --soil ", ["medium\\ clay"]),
        ("catopt check case.toml --code ", ["ISO-19901-7"]),
        ("catopt catalog show polyester ", ["R3", "4D"]),
    ],
)
def test_what_is_not_taken_is_not_offered(
    completed: Completed, words: str, none: list[str]
) -> None:
    found = completed("bash", words)
    assert not set(none) & set(found), found


def test_what_is_typed_already_says_what_is_offered(completed: Completed) -> None:
    assert "ISO-19901-7" in completed("bash", "catopt check case.toml --recalled --code ISO")
    assert completed("bash", "catopt size tanker --sinker concrete --soil fine")
    assert completed("bash", "catopt catalog show chain\\ studless R")
    every = completed("bash", "catopt size buoy --soil ")
    assert [each.replace("\\", "") for each in every] == list(SOIL_FRICTION)


@pytest.mark.parametrize(
    ("shell", "written"),
    [
        ("bash", "pillar\\ 1.8\\ m"),
        ("zsh", '"pillar 1.8 m"'),
        ("fish", "pillar 1.8 m"),
        ("powershell", "pillar` 1.8` m"),
    ],
)
def test_every_shell(completed: Completed, shell: str, written: str) -> None:
    assert written in "\n".join(completed(shell, "catopt size buoy pil"))
    assert "xyzzy" not in "\n".join(completed(shell, "catopt new xyzzy"))
