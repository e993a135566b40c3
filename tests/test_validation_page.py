"""docs/validation.md shows what the tests' data, the studies and the two models say today."""

from __future__ import annotations

import pytest

from tests.validation_page import EVIDENCE, PAGE, PARTS, ROOT, below, first_words, parts

LONG = ("beside", "studies")
"""Parts that take seconds: every printed example is solved for them."""


def test_the_page_has_every_part_once() -> None:
    assert [part for part, _ in parts(PAGE.read_text("utf-8"))] == list(PARTS)


@pytest.mark.parametrize(
    "part",
    [pytest.param(part, marks=pytest.mark.slow) if part in LONG else part for part in PARTS],
)
def test_a_part_of_the_page_is_up_to_date(part: str) -> None:
    shown = dict(parts(PAGE.read_text("utf-8")))[part]
    assert shown == PARTS[part]().strip("\n"), "write it anew: python -m tests.validation_page"


def test_every_test_that_the_page_names_is_there_and_says_what_it_shows() -> None:
    named = [ROOT / "tests" / f"{name}.py" for names in EVIDENCE.values() for name in names]
    assert len(set(named)) == len(named)
    assert [path for path in named if not first_words(path).endswith(".")] == []


@pytest.mark.parametrize(
    ("gap", "words"),
    [
        (0.0, "below 1e-9"),
        (9.9e-10, "below 1e-9"),
        (1.1e-9, "below 1e-8"),
        (7e-7, "below 1e-6"),
        (0.5, "below 1e0"),
    ],
)
def test_a_difference_is_told_by_the_power_of_ten_above_it(gap: float, words: str) -> None:
    assert below(gap) == words
