"""Files made to take long: refused before they are parsed, in words."""

from __future__ import annotations

import time

import pytest

from catopt.casefile.reading import parse_case
from catopt.decks.deck import Notes
from catopt.decks.tree import parse_yaml
from catopt.documents import MOST_BYTES, MOST_ENTRIES, parse_toml
from catopt.errors import InputError

DOTS = {
    "bare": ".".join(["a"] * 20_000) + " = 1",
    "quoted": ".".join(['"a b"', "'c'"] * 10_000) + " = 1",
    "spaced": " . ".join(["a"] * 20_000) + " = 1",
    "table": "[" + ".".join(["a"] * 20_000) + "]",
    "inline": "x = {" + ".".join(["a"] * 20_000) + " = 1}",
}


def seconds(text: str) -> tuple[float, str]:
    start = time.process_time()
    with pytest.raises(InputError) as refused:
        parse_toml(text, "file")
    return time.process_time() - start, str(refused.value)


@pytest.mark.parametrize("name", DOTS)
def test_a_key_of_many_parts_is_refused_at_once(name: str) -> None:
    took, said = seconds(DOTS[name])
    assert took < 1.0
    assert "more than 20 parts" in said


def test_too_many_entries_are_refused_at_once() -> None:
    took, said = seconds("\n".join(f"a{k} = 1" for k in range(MOST_ENTRIES + 1)))
    assert took < 1.0
    assert "at most 200,000 are allowed" in said
    start = time.process_time()
    with pytest.raises(InputError, match="are allowed"):
        parse_yaml("\n".join(f"a{k}: 1" for k in range(MOST_ENTRIES + 1)), Notes())
    assert time.process_time() - start < 1.0


def test_a_file_of_another_kind_is_refused_as_one() -> None:
    """Of each of 20,000 keys it took a tenth of a second to say what it may have meant."""
    start = time.process_time()
    with pytest.raises(InputError) as refused:
        parse_case("\n".join(f"k{k} = 1" for k in range(20_000)))
    assert time.process_time() - start < 5.0
    assert "one of 20000 unknown keys" in str(refused.value)
    assert len(refused.value.problems) == 1


@pytest.mark.parametrize(
    "text",
    [
        "a" * (MOST_BYTES - 5) + " = 1",
        'a = "' + ".".join(["a"] * 1_000_000) + '"',
        "a = 'x. " + "word. " * 1000 + "'",
        ".".join(f"a{k}" for k in range(20)) + " = 1",
    ],
)
def test_what_is_long_but_plain_is_read(text: str) -> None:
    start = time.process_time()
    assert parse_toml(text, "file")
    assert time.process_time() - start < 10.0
