"""Every command in both languages: every text is there and fits, and the numbers are the same."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

from .conftest import CHAIN_AND_WIRE, Run
from .test_catalog import QUESTIONS
from .test_lang import SOLVED
from .test_lang_catalog import MORE
from .test_lang_curve import BIGHTS, BUOYED, CURVES
from .test_lang_loads import ASKED
from .test_lang_system import CASE_TEXTS, EVERYTHING, FSO
from .vietnamese import numbers, said_alike

FILES = {
    "chain-and-wire.toml": CHAIN_AND_WIRE,
    "buoyed.toml": BUOYED,
    "bights.toml": BIGHTS,
    "ship.toml": """
[site]
water_depth = "22 m"
[ship]
length = "234 m"
breadth = "31.3 m"
draught = "12.4 m"
""",
    **{f"{name}.toml": text for name, text in CASE_TEXTS.items()},
}
COMMANDS: list[Sequence[object]] = [
    *SOLVED,
    *(["catalog", *question] for question in (*QUESTIONS, *MORE)),
    *(["curve", *arguments] for arguments in CURVES),
    *(list(arguments) for arguments in ASKED.values()),
    *(["system", case, *EVERYTHING] for case in (FSO, *(f"{name}.toml" for name in CASE_TEXTS))),
]


def first_of_each() -> Iterator[Any]:
    """Yield them all, with all but the first of each command among the slow ones."""
    seen = set()
    for command in COMMANDS:
        marks = [pytest.mark.slow] if command[0] in seen else []
        seen.add(command[0])
        yield pytest.param(command, marks=marks, id=" ".join(map(str, command)))


@pytest.mark.parametrize("command", list(first_of_each()))
def test_languages_differ_in_words_alone(
    run: Run, command: Sequence[object], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, text in FILES.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    # Figures are drawn from the English in every language and take most of the time.
    monkeypatch.setattr("catopt.render.picture.pictures", lambda *_, **__: {})
    english, said = (run(*command, "--lang", each, "--out", each) for each in ("en", "vi"))
    assert (english.status, said.status) == (0, 0), said.err
    assert "…" not in said.out
    assert max(map(len, said.out.splitlines())) <= 80
    if command[0] == "curve":
        assert said_alike(english.out, said.out) <= {english.out.splitlines()[0]}
    files = {path.name: path.read_bytes() for path in (tmp_path / "en").iterdir()}
    assert files.keys() == {path.name for path in (tmp_path / "vi").iterdir()}
    for name, written in files.items():
        other = (tmp_path / "vi" / name).read_bytes()
        if name.endswith(".xlsx"):
            assert written != other
            assert numbers(written) == numbers(other) != []
        else:
            assert written == other


@pytest.mark.parametrize(
    "command",
    [
        *SOLVED[5:7],
        *(["catalog", *question] for question in QUESTIONS[:7:3]),
        ["curve", *CURVES[6]],
        *ASKED.values(),
        ["system", FSO, *EVERYTHING],
    ],
    ids=lambda command: " ".join(map(str, command)),
)
def test_the_document_is_the_same_in_both_languages(
    run: Run, command: Sequence[object], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "ship.toml").write_text(FILES["ship.toml"], encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert run(*command, "--json", "--lang", "vi").out == run(*command, "--json").out
