"""docs/questions.md asks the same in its case files as in Python."""

from __future__ import annotations

import re

import pytest

from catopt import solve_case
from catopt.casefile import parse_case
from tests.snippets import FENCE, ROOT

PAGE = (ROOT / "docs" / "questions.md").read_text(encoding="utf-8")
TANKER = (ROOT / "cases" / "tanker-20m" / "case.toml").read_text(encoding="utf-8")


def sections() -> dict[str, dict[str, str]]:
    """Fenced blocks of each section that has a piece of a case file, by language."""
    found = {}
    for part in PAGE.split("\n## ")[1:]:
        blocks = {match["info"]: match["body"] for match in FENCE.finditer(part)}
        if "toml" in blocks:
            found[part.splitlines()[0]] = blocks
    return found


def test_every_question_of_a_case_file_has_its_section() -> None:
    asked = " ".join(blocks["toml"] for blocks in sections().values())
    for word in (
        "horizontal_force",
        "span",
        "fairlead_tension",
        "anchor_angle",
        "grounded_length",
        '"length"',
        '"clump_weight"',
        '"touchdown_force"',
        '"limit_force"',
    ):
        assert word in asked


@pytest.mark.parametrize("question", sections())
def test_the_case_file_gives_what_python_prints(question: str) -> None:
    """What Python prints is held against Python by the test of all snippets."""
    blocks = sections()[question]
    text, count = re.subn(r"\[load\]\nhorizontal_force = .*\n", lambda _: blocks["toml"], TANKER)
    assert count == 1
    solution = solve_case(parse_case(text))
    if solution.found is not None:
        assert blocks["text"].startswith(f"{solution.found.value:.2f} {solution.found.unit} ")
        assert solution.found.condition in blocks["text"]
    else:
        assert f"span {solution.span:.3f} m" in blocks["text"]
