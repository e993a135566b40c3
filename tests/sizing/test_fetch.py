"""A sea raised by the wind over a fetch, in the place of a height that is given."""

from __future__ import annotations

from typing import Any

import pytest

from catopt.errors import InputError
from catopt.loads.wave_growth import grown_sea
from catopt.sizing import BuoyRequest, TankerRequest
from catopt.sizing.environment import mean_over
from catopt.sizing.input_values import input_values
from catopt.sizing.requests import request_of

BUOY: dict[str, Any] = {"buoy": "pillar 1.8 m", "depth": 12.0, "fetch": "20 km"}
SHIP: dict[str, Any] = {"dwt": "5000 t", "depth": 12.0, "fetch": "5 km"}


def of_a_buoy(**more: Any) -> BuoyRequest:
    request = request_of(input_values("buoy", BUOY | more))
    assert isinstance(request, BuoyRequest)
    return request


def of_a_ship(**more: Any) -> TankerRequest:
    request = request_of(input_values("tanker", SHIP | more))
    assert isinstance(request, TankerRequest)
    return request


@pytest.mark.parametrize(
    ("given", "wind", "depth"),
    [
        ({"wind": 20.0}, 20.0, 12.0),
        ({}, 25.0, 12.0),  # the wind that is taken
        ({"place": "Vung Tau"}, 31.0, 12.0),
        ({"wind": 20.0, "fetch_depth": "5 m", "low_water": 10.0}, 20.0, 5.0),
    ],
)
def test_the_sea_is_that_of_wind_fetch_and_depth(
    given: dict[str, Any], wind: float, depth: float
) -> None:
    """Height and peak period are those of the law, and the answer says of what they are."""
    request = of_a_buoy(**given)
    sea, grown = request.environment.sea, grown_sea(wind, 20e3, depth)
    assert (sea.hs, sea.period) == grown
    said = [str(each) for each in request.defaults if "km of water" in str(each)]
    assert len(said) == 1
    assert f"over 20 km of water {depth:g} m deep" in said[0]
    assert not [each for each in request.inputs if each.keyword == "hs"]


def test_the_wind_on_a_ship_is_turned_into_a_mean_of_ten_minutes() -> None:
    """The sea is of a mean of 10 min, the force on her of one of 30 s; a wind is of 30 s."""
    assert of_a_ship(wind=20.0, wind_mean="10 min").environment.sea.hs == pytest.approx(
        grown_sea(20.0, 5e3, 12.0).hs, rel=1e-12
    )
    slower = mean_over(20.0, 30.0, 600.0)
    assert slower < 19.0
    assert of_a_ship(wind=20.0).environment.sea.hs == grown_sea(slower, 5e3, 12.0).hs


def test_a_period_that_is_given_stands() -> None:
    assert of_a_buoy(period=7.0).environment.sea.period == 7.0


def test_a_fetch_counts_as_weather_of_a_return_period() -> None:
    """Wind, current and a fetch are all the weather that there is."""
    of_a_buoy(wind=20.0, current=1.0, return_period="50 years")
    with pytest.raises(InputError, match="current not given"):
        of_a_buoy(wind=20.0, return_period="50 years")


@pytest.mark.parametrize(
    ("given", "keys"),
    [
        ({"hs": 1.0}, ["fetch"]),
        ({"hmax": 1.0}, ["fetch"]),
        ({"wind": 0.0}, ["wind"]),
        ({"depth": None}, ["depth"]),
        ({"fetch": None, "fetch_depth": 5.0}, ["fetch_depth"]),
        ({"fetch": "20 kg"}, ["fetch"]),
        ({"buoy": None, "force": "5 kN", "reserve_buoyancy": "12 kN"}, ["fetch"]),
    ],
)
def test_each_mistake_is_told_once(given: dict[str, Any], keys: list[str]) -> None:
    with pytest.raises(InputError) as error:
        of_a_buoy(**given)
    assert [each.key for each in error.value.problems] == keys
