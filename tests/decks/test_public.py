"""Public decks: read, and solved to 1e-6 of what MoorPy 1.3.0 finds, save one that it misses."""

from __future__ import annotations

import math
from typing import Any

import pytest

from catopt import solve_case
from catopt.decks.reading import read_deck

from .public import PUBLIC, deck_text

SAID = {"version", "weight", "drag", "segments", "one_line", "above_water", "held_mass"} | {
    "anchor_above_bed"
}
"""All that has to be said of a deck with nothing but its lines."""


@pytest.mark.parametrize("of", PUBLIC, ids=lambda of: of["file"].rsplit("/", 1)[-1])
def test_statics_are_those_of_moorpy(of: dict[str, Any]) -> None:
    found = read_deck(deck_text(of), "deck.txt")
    assert {remark.key.removeprefix("decks.") for remark in found.remarks} <= SAID
    solved = solve_case(found.case)
    close = 1e-6 * math.hypot(of["H"], of["V"])
    if "otherwise" in of:
        assert abs(solved.horizontal_force - of["H"]) > 1e-3 * of["H"]
        return
    assert solved.horizontal_force == pytest.approx(of["H"], abs=close)
    assert solved.fairlead.vertical_force == pytest.approx(of["V"], abs=close)


def test_how_many_there_are() -> None:
    assert len({of["file"] for of in PUBLIC}) >= 20
