"""How a buoy floats in the steady storm, by hand."""

from __future__ import annotations

import math
from typing import Any

import pytest

import catopt
from catopt.checks.verdict import Matter, not_judged
from catopt.loads.buoy_heel import heel_at_rest
from catopt.loads.buoy_shape import BuoyShape
from catopt.sizing.floating import FloatsInStorm

RHO, G = 1025.0, 9.80665


def drum(**more: Any) -> BuoyShape:
    """Build a cylinder of 2 m, 1.5 m high, of 2 t, with a tower of 2 m: all by hand below."""
    form: dict[str, Any] = {
        "hull_diameter": 2.0,
        "hull_depth": 1.5,
        "mass": 2000.0,
        "least_freeboard": 0.2,
    }
    form |= {"tower_height": 2.0, "tower_width": 0.5, "centre_of_gravity": 0.5}
    return BuoyShape("drum", **(form | more))


def test_heel_is_moment_over_slope() -> None:
    """Of 2 t, under a pull of 5 kN.

    T = (2000 + 5000/g) / (rho pi) m, K = rho g (I + V (T/2 - G)) + 5 kN x 0.5 m. The current pushes
    at T/2, the wind at the middle of hull and tower above the water.
    """
    pull, wind, current = 5e3, 300.0, 2e3
    volume = (2000.0 + pull / G) / RHO
    draught = volume / math.pi
    slope = RHO * G * (math.pi / 4.0 + volume * (draught / 2.0 - 0.5)) + pull * 0.5
    hull, tower = 2.0 * (1.5 - draught), 0.5 * 2.0
    high = (hull * 0.5 * (1.5 + draught) + tower * 2.5) / (hull + tower)
    by_hand = math.atan((wind * high + current * draught / 2.0) / slope)
    assert math.degrees(by_hand) == pytest.approx(9.0, abs=2.0)  # a heel that one would expect
    assert heel_at_rest(drum(), RHO, pull, wind, current) == pytest.approx(by_hand, rel=2e-3)


def test_a_buoy_that_would_not_float_upright_has_none() -> None:
    assert heel_at_rest(drum(centre_of_gravity=1.45), RHO, 0.0, 300.0, 2e3) is None


def test_a_pull_at_the_foot_rights_it() -> None:
    heels = [heel_at_rest(drum(), RHO, pull, 300.0, 2e3) or 0.0 for pull in (0.0, 5e3, 10e3)]
    assert heels == sorted(heels, reverse=True)


@pytest.mark.parametrize(("wind", "is_large"), [("8 m/s", False), ("25 m/s", True)])
def test_a_large_heel_is_named_unless_it_is_judged(wind: str, *, is_large: bool) -> None:
    """The slope of the upright buoy holds up to some 15 deg; beyond, the figure is an estimate."""
    found = catopt.size_buoy("pillar 1.8 m", depth="12 m", wind=wind, hs="1 m", at_rest=True)
    assert found.floats is not None
    assert found.floats.heel is not None
    assert (math.degrees(found.floats.heel) > 15.0) is is_large
    named = [each.said for each in found.judgement.not_judged if each.subject == "deck"]
    assert [f"{math.degrees(found.floats.heel):.0f} deg" in each for each in named] == [
        True
    ] * is_large


@pytest.mark.parametrize(("wind", "awash"), [("25 m/s", False), ("31 m/s", True)])
def test_a_deck_edge_under_water_keeps_the_verdict_amber(wind: str, *, awash: bool) -> None:
    """0.5 D sin a against the freeboard's f cos a, less 0.05 m of run-up at 1 m/s."""
    found = catopt.size_buoy("pillar 1.8 m", depth="12 m", wind=wind, at_rest=True)
    floats = found.floats
    assert floats is not None
    assert floats.heel is not None
    dips = 0.9 * math.sin(floats.heel) + 1.0 / (2.0 * G)
    under = dips > floats.freeboard * math.cos(floats.heel)
    named = [each.said for each in found.judgement.not_judged if each.subject == "deck"]
    assert under is awash is any("under water" in each for each in named)
    assert found.judgement.colour == "amber"
    if awash:
        assert "deck edge 0.07 m under water" in named[0]


def test_a_buoy_that_cannot_float_upright_is_said_in_the_verdict() -> None:
    floats = FloatsInStorm("storm", 0.0, 0.5, 0.5, 0.2, None, 0.05, None)
    assert "upright" in str(floats.awash)
    (left,) = not_judged(Matter(deck=floats.awash, who="size"))
    assert (left.said, left.how) == (floats.awash, "a wider buoy, --in-motion --centre-of-gravity")
