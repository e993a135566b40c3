"""The questions of ``catopt size`` at a terminal, each with an example and its unit."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from .conftest import Run
from .test_transcripts import run_as

ASKED = {
    "buoy": [
        ("60 m", ""), ("pillar 1.8 m", "pillar 2.4 m"), ("12 m", "twelve"), ("12 m", "12 m"),
        ("12 m", "10 m"), ("25 m/s", ""), ("1 m/s", ""), ("2 m", "1.5 m"),
        ("fine or silty sand", "clean fine to medium sand"),
    ],
    "tanker": [
        ("450 m", ""), ("50000 t", ""), ("234 m", "120 m"), ("31.3 m", "18 m"), ("12.4 m", "7 m"),
        ("22 m", "22 m"), ("22 m", "20 m"), ("25 m/s", "20 m/s"), ("1 m/s", ""), ("2 m", ""),
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
