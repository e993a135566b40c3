"""A ship counts loaded and in ballast unless one is named; states are told by fields, not text."""

from __future__ import annotations

from functools import partial
from typing import Any

import pytest

from catopt.errors import InputError
from catopt.sizing.converge import Assumed
from catopt.sizing.tanker import pose_tanker
from catopt.sizing.tanker_request import TankerRequest
from catopt.words import is_said, say
from tests.sizing.at_rest import size_tanker

from .test_what_people_know import requested

SHIP: dict[str, Any] = {"dwt": "50000 t", "depth": "20 m"}


asked = partial(requested, **SHIP)


def draughts(of: TankerRequest) -> dict[str, float]:
    return {each.condition: each.ship.draught for each in of.ships}


def test_the_draught_in_ballast_is_estimated_and_said() -> None:
    """2.0 + 0.02 x 0.97 x 210 m; the deck is 16.4 m above the keel."""
    request = asked()
    assert draughts(request) == {"loaded": 12.6, "ballast": pytest.approx(6.074, abs=1e-12)}
    assert [each.fairlead for each in request.ships] == pytest.approx([3.8, 10.326], abs=1e-12)
    (said,) = (each for each in request.estimates if is_said(each, "sizing.ballast_estimated"))
    assert "6.07 m, ESTIMATED" in said
    assert "[B]" in said
    assert "ƯỚC TÍNH" in say(said, "vi")


@pytest.mark.parametrize(
    ("given", "found"),
    [
        ({"ballast_draught": "6.1 m"}, {"loaded": 12.6, "ballast": 6.1}),
        ({"condition": "loaded"}, {"loaded": 12.6}),
        ({"condition": ("ballast",), "ballast_draught": 7.0}, {"ballast": 7.0}),
        # Of a small ship the rule gives more than the loaded draught: 2.0 + 0.02 x 0.97 x 30 m.
        (
            {"dwt": None, "length": 30.0, "breadth": 8.0, "draught": 2.4},
            {"loaded": 2.4},
        ),
    ],
)
def test_one_condition_may_be_named(given: dict[str, object], found: dict[str, float]) -> None:
    assert draughts(asked(**given)) == found


def test_what_cannot_be_estimated_is_said() -> None:
    small = asked(dwt=None, length=30.0, breadth=8.0, draught=2.4)
    assert any(is_said(each, "sizing.no_ballast") for each in small.estimates)


@pytest.mark.parametrize(
    ("given", "key", "allowed"),
    [
        ({"condition": "loaded", "ballast_draught": 6.0}, "ballast_draught", "leave it out"),
        ({"ballast_draught": 13.0}, "ballast_draught", "not above the loaded draught, 12.6 m"),
        (
            {
                "condition": "ballast",
                "dwt": None,
                "length": 30.0,
                "breadth": 8.0,
                "draught": 2.4,
            },
            "ballast_draught",
            "missing; it cannot be estimated for this ship",
        ),
        ({"condition": "light"}, "condition[0]", "one of loaded, ballast is required"),
    ],
)
def test_what_contradicts_is_refused(given: dict[str, Any], key: str, allowed: str) -> None:
    with pytest.raises(InputError) as refused:
        asked(**given)
    (problem,) = refused.value.problems
    assert problem.key == key
    assert problem.allowed.startswith(allowed)


@pytest.mark.parametrize(
    ("low", "buoy", "states"),
    [
        (None, None, [("loaded", "high"), ("ballast", "high")]),
        (
            "18 m",
            None,
            [("loaded", "high"), ("loaded", "low"), ("ballast", "high"), ("ballast", "low")],
        ),
        # A buoy follows the crests: still water is a state of its own.
        (
            None,
            "mooring buoy 5.0 m",
            [("loaded", "high"), ("loaded", "low"), ("ballast", "high"), ("ballast", "low")],
        ),
    ],
)
def test_states_are_told_by_fields(
    low: str | None, buoy: str | None, states: list[tuple[str, str]]
) -> None:
    request = asked(low_water=low, buoy=buoy)
    posed = pose_tanker(request, Assumed(), request.reserve_buoyancy)
    assert [(each.condition, each.water) for each in posed.loads] == states


def test_the_cable_of_her_own_is_that_of_the_loaded_ship() -> None:
    """EN 2,990 of the loaded ship; in ballast alone there is none to compare with."""
    by = {each: size_tanker(**SHIP, condition=each) for each in ("loaded", "ballast")}
    assert "EN 2,990" in by["loaded"].practice
    assert by["ballast"].practice == ""
    for of in by.values():  # a line on a drag anchor has no sinker to be made fast to
        assert any("shackle" in each for each in of.fittings)
        assert not any("sinker ring" in each for each in of.fittings)
