"""docs/validation.md shows what the tests' data, the studies and the two models say today."""

from __future__ import annotations

import pytest

from tests.validation_page import EVIDENCE, PAGE, PARTS, ROOT, below, first_words, parts, up_to_date


@pytest.mark.slow  # solves all that the page tells of
def test_the_page_is_up_to_date() -> None:
    text = PAGE.read_text("utf-8")
    assert parts(text) == list(PARTS)
    assert text == up_to_date(text), "write it anew: python -m tests.validation_page"


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
