"""The questions of ``catopt size`` at a terminal, each with an example and its unit."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from .conftest import Run
from .test_transcripts import run_as

ASKED = {
    "buoy": [
        ("pillar 1.8 m", "pillar 2.4 m"), ("12 m", "twelve"), ("12 m", "12 m"),
        ("12 m", "10 m"), ("25 m/s", ""), ("1 m/s", ""), ("2 m", "1.5 m"),
        ("fine or silty sand", "clean fine to medium sand"), ("60 m", ""),
    ],
    "tanker": [
        ("50000 t", ""), ("234 m", "120 m"), ("31.3 m", "18 m"), ("12.4 m", "7 m"),
        ("22 m", "22 m"), ("22 m", "20 m"), ("25 m/s", "20 m/s"), ("1 m/s", ""), ("2 m", ""),
        ("450 m", ""),
    ],
}  # fmt: skip
"""What stands in each question, in its order, and the answer."""


@pytest.mark.parametrize("language", ["en", "vi"])
@pytest.mark.parametrize("moored", list(ASKED))
def test_every_question_has_an_example_with_its_unit(
    run: Run, inside: Path, moored: str, language: str
) -> None:
    del inside
    answers = [answer for _, answer in ASKED[moored]]
    ran = run_as(
        run, ["size", moored, "--at-rest", "--period", "6 s", "--lang", language, "--json"], answers
    )
    assert ran.status == 0, ran.err
    questions = re.sub(r"  \S.*\n", "", ran.err).split(": ")[: len(answers)]
    shown = [(example, each) for (example, _), each in zip(ASKED[moored], questions, strict=True)]
    assert [pair for pair in shown if pair[0] not in pair[1]] == []
    if language == "vi":
        assert not re.search(r"\b(such as|wanted|found)\b", ran.err)
        assert moored == "tanker" or "cần chiều dài" in ran.err


@pytest.mark.parametrize(
    ("depth", "meant"), [("12m", "--depth 12m?"), ("12 m", '--depth "12 m"?'), ("deep", "")]
)
def test_a_bare_depth_is_told_its_option(run: Run, depth: str, meant: str) -> None:
    ran = run("size", "buoy", "pillar 1.8 m", depth)
    assert ran.status == 2
    assert ran.out == ""
    assert ("Did you mean" in ran.err) == bool(meant)
    assert meant in ran.err


def test_a_bare_depth_is_told_its_option_in_vietnamese(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CATOPT_LANG", "vi")
    ran = run("size", "buoy", "pillar 1.8 m", "12m")
    assert "Có phải ý là --depth 12m?" in ran.err
