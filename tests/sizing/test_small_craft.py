"""Small craft: estimates scale with the ship, and a line is no heavier than she carries."""

from __future__ import annotations

import math
from functools import partial

import pytest

from catopt.catalogue.practice import own_cable
from catopt.errors import NoAnswerError
from catopt.loads.ship import estimated_tanker, estimates
from tests.cli.conftest import Run, run, words
from tests.sizing.at_rest import size_tanker

__all__ = ("run",)

BOAT = ("--length", "15 m", "--breadth", "3.3 m", "--draught", "1.1 m", "--depth", "8 m")


@pytest.mark.parametrize(
    ("length", "breadth", "draught"), [(15, 3.3, 1.1), (12, 4, 1.8), (8, 2.5, 1)]
)
def test_the_deckhouse_goes_with_a_small_ship(
    length: float, breadth: float, draught: float
) -> None:
    """L/90 of 15 m x 25 m: at 15 m 2.5 x 4.17 m; AF = 3.3 (0.33 + 2.5) = 9.339 m2."""
    ship = estimated_tanker("b", length, breadth, draught, moulded_depth=1.3 * draught)
    house, long = 15.0 * length / 90.0, 25.0 * length / 90.0
    assert ship.frontal_area == pytest.approx(breadth * (0.3 * draught + house), rel=1e-12)
    lateral = 0.3 * draught * length + house * long
    assert ship.lateral_area == pytest.approx(lateral, rel=1e-12)
    assert ship.lateral_centre == pytest.approx(
        -house * long * 0.5 * (length - long) / lateral, rel=1e-12
    )


def test_the_wind_on_a_small_boat_is_said_to_rest_on_scaled_areas(run: Run) -> None:
    """1/2 1.221 x 30^2 x 9.339 m2 x 0.9 = 4.618 kN, after Blendermann's tanker, loaded."""
    said = words(run("loads", "ship", *BOAT, "--wind", "30 m/s").out)
    assert "4.618" in said
    assert "shorter than the ships of 90 m" in said
    areas = ("--frontal-area", "10 m^2", "--lateral-area", "30 m^2")
    assert "shorter than" not in words(run("loads", "ship", *BOAT, "--wind", "30 m/s", *areas).out)


def test_the_first_screen_says_by_what_the_chain_is_bounded(run: Run) -> None:
    said = words(run("size", "tanker", *BOAT, "--at-rest", "--wind", "30 m/s").out)
    assert "sizes up to 20.2 mm, 2 times her own cable of 10 mm" in said
    assert "windage scaled down from ships of 90 m and more" in said
    own = run(
        "size", "tanker", *BOAT, "--at-rest", "--wind", "30 m/s", "--diameter-max", "40 mm"
    ).out
    assert "her own cable of" not in words(own)


def test_a_ship_of_the_table_keeps_her_house() -> None:
    """At 90 m the figures are those of all ships above; a metre less scales them by 89/90."""
    for length, height in ((90.0, 15.0), (234.0, 15.0), (89.0, 15.0 * 89.0 / 90.0)):
        ship = estimated_tanker("t", length, 13.0, 6.0, moulded_depth=7.8)
        assert ship.frontal_area == pytest.approx(13.0 * (1.8 + height), rel=1e-12)
        assert f"{height:.3g} m high" in estimates(length)[1]


def test_a_small_boat_is_not_given_a_ship_s_chain() -> None:
    """Her EN: 43.3 t to the power of 2/3, 2 x 9.339, 15.4/10: 32.5; 12.5 mm of EN 50 by its root.

    That is 10.1 mm of her own, twice which is 20.2 mm; the room for swinging then stops it.
    """
    volume = 0.8 * 0.97 * 15.0 * 3.3 * 1.1
    lateral = 15.0 * 0.33 + 15.0 * 25.0 * (15.0 / 90.0) ** 2
    number = (volume * 1.025) ** (2.0 / 3.0) + 2.0 * 9.339 + lateral / 10.0
    cable = own_cable(volume * 1025.0, 9.339, lateral)
    assert cable == pytest.approx(0.0125 * math.sqrt(number / 50.0), rel=1e-9)
    assert cable is not None
    boat = partial(size_tanker, length=15.0, breadth=3.3, draught=1.1, depth=8.0, wind=30.0)
    chosen = boat().settled.point.line.segments[0].nominal_diameter
    assert chosen is not None
    assert chosen <= 2.0 * cable
    with pytest.raises(NoAnswerError):
        boat(max_swing=60.0)


def test_what_hangs_in_deep_water_does_not_pull_a_boat_under() -> None:
    with pytest.raises(NoAnswerError, match="pulls the bow down"):
        size_tanker(length=15.0, breadth=3.3, draught=1.1, depth=500.0, wind=30.0)
