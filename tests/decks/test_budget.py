"""A deck of any size and shape is read or refused in time that grows with it."""

from __future__ import annotations

import time

import pytest

from catopt import InputError
from catopt.decks.reading import Asked, is_deck, read_deck
from tests.decks.own import MAP, MOORDYN

ASKED = Asked(gravity=9.80665, density=1025.0, depth=320.0)
OC3 = MAP.format(
    types="0.09 77.7066 384.243e6 0.001 0 0 0 0",
    anchor="853.87 0",
    fairlead="5.2 0 -70",
    length=902.2,
)
MOST_SECONDS = 5.0
"""The slowest took 12 s and more before; 0.2 s now."""


@pytest.mark.parametrize(
    "text",
    [
        "-" * 80_000,
        "\n" * 80_000 + "--- LINE DICTIONARY ---\n- SOLVER OPTIONS\n",
        (" " * 40_000 + "\n") * 2 + "--- LINE DICTIONARY ---\n- SOLVER OPTIONS\n",
    ],
    ids=["dashes", "blank lines", "blanks"],
)
def test_whether_a_text_is_a_deck_takes_linear_time(text: str) -> None:
    start = time.process_time()
    if is_deck(text):
        with pytest.raises(InputError):
            read_deck(text, "deck.txt", ASKED)
    assert time.process_time() - start < MOST_SECONDS


def test_copies_have_a_ceiling() -> None:
    assert read_deck(OC3 + "\nrepeat 120 240\n", "oc3.map", ASKED).case.system.legs[2]
    start = time.process_time()
    with pytest.raises(InputError, match="100,000 is too many"):
        read_deck(OC3 + "\nrepeat " + "120 " * 100_000, "oc3.map", ASKED)
    assert time.process_time() - start < MOST_SECONDS


@pytest.mark.parametrize("far", ["1e23", "-1e7", "1_0", "\uff11\uff10", "1e400"])
def test_a_coordinate_beyond_all_is_refused(far: str) -> None:
    deck = OC3.replace("853.87", far)
    assert deck != OC3
    with pytest.raises(InputError, match="line "):
        read_deck(deck, "oc3.map", ASKED)


def test_a_thousand_wrong_rows_are_told_in_a_few_lines() -> None:
    first = next(line for line in MOORDYN.split("\n") if "Fixed" in line)
    rows = "".join(first.replace(first.split()[0], f"{k}x", 1) + " x\n" for k in range(900, 1900))
    with pytest.raises(InputError) as caught:
        read_deck(MOORDYN.replace(first + "\n", rows, 1), "many.txt")
    assert len(f"{caught.value}") < 20_000
