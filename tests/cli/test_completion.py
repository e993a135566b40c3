"""Completion of names by the shells' own protocol: what a shell asks and what it is given."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest


def completed(shell: str, words: str) -> list[str]:
    """Ask as the script of a shell does; what is typed last is begun, or a space."""
    count = len(words.split()) - (0 if words.endswith(" ") else 1)
    environment = {
        **os.environ,
        "_CATOPT_COMPLETE": f"complete_{shell}",
        "COMP_WORDS": words,
        "COMP_CWORD": str(count),
        "_TYPER_COMPLETE_ARGS": words,
        "_TYPER_COMPLETE_FISH_ACTION": "get-args",
        "_TYPER_COMPLETE_WORD_TO_COMPLETE": "" if words.endswith(" ") else words.split()[-1],
    }
    ran = subprocess.run(
        [sys.executable, "-m", "catopt"],
        env=environment,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=60,
        check=False,
    )
    assert ran.stderr == ""
    return ran.stdout.split("\n")[:-1]


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
        ("catopt size buoy pil", ["pillar\\ 1.8\\ m"]),
        ("catopt loads buoy pil", ["pillar\\ 1.8\\ m"]),
        ("catopt size buoy --chain chain", ["chain\\ studless\\ R3"]),
        ("catopt catalog show chain", ["chain\\ studless"]),
        ("catopt export case.toml --to mo", ["moordyn", "moorpy"]),
        ("catopt solve --units t", ["tf"]),
    ],
)
def test_bash(words: str, some: list[str]) -> None:
    found = completed("bash", words)
    assert set(some) <= set(found), found


def test_a_quote_that_is_open_needs_no_escape() -> None:
    assert "pillar 1.8 m" in completed("bash", 'catopt size buoy "pil')


@pytest.mark.parametrize(
    ("shell", "written"),
    [("zsh", '"pillar 1.8 m"'), ("fish", "pillar 1.8 m"), ("powershell", "pillar` 1.8` m")],
)
def test_other_shells(shell: str, written: str) -> None:
    found = "\n".join(completed(shell, "catopt size buoy pil"))
    assert written in found


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish", "powershell"])
def test_what_nothing_begins_with_gives_nothing(shell: str) -> None:
    assert "xyzzy" not in "\n".join(completed(shell, "catopt new xyzzy"))
