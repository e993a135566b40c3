"""The ship of a run is the one that the loads at rest are of, whatever was given of her."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from catopt import size_buoy, size_tanker
from catopt.casefile import parse_case, write_case
from catopt.errors import InputError
from catopt.loads import SurfaceCurrent, Wind, parse_ship_coefficients, ship_loads
from catopt.loads.environment import Headings, SeaState
from catopt.sizing.input_values import input_values
from catopt.sizing.requests import request_of
from catopt.sizing.result import Sizing
from catopt.sizing.ship_afloat import ship_afloat
from catopt.sizing.tanker_request import TankerRequest
from catopt.verify.two_scales import moored_ship
from tests.sizing.alone import alone

SHIP: dict[str, Any] = {
    "dwt": "50000 t", "depth": "20 m", "hs": "1.5 m", "wind": "20 m/s", "current": "1.2 m/s",
}  # fmt: skip

OWN = """
schema = "catopt.ship-coefficients/1"
name = "ours"
source = "a test"
confidence = "C"
angles_from = "bow"
[[wind]]
along_area = "frontal"
across_area = "lateral"
angles = [0.0, 90.0, 180.0]
along = [-1.9, 0.0, 0.9]
across = [0.0, 1.1, 0.0]
yaw = [0.0, -0.05, 0.0]
[[current]]
along_area = "breadth x draught"
across_area = "length x draught"
angles = [0.0, 90.0, 180.0]
along = [-2.5, 0.0, 2.0]
across = [0.0, 1.7, 0.0]
yaw = [0.0, 0.1, 0.0]
"""

OPTIONS: dict[str, dict[str, Any]] = {
    "none": {},
    "general cargo": {"ship": "general cargo", "dwt": "20000 t"},
    "bulk carrier": {"ship": "bulk carrier"},
    "ballast": {"condition": "ballast"},
    "ballast draught": {"condition": "ballast", "ballast_draught": "7.5 m"},
    "dimensions": {
        "dwt": None, "length": "180 m", "breadth": "31 m", "draught": "10 m",
        "moulded_depth": "17 m", "fairlead": "8 m",
    },
    "barge": {
        "dwt": None, "ship": "barge", "length": "90 m", "breadth": "27 m", "draught": "4.5 m",
        "moulded_depth": "6 m",
    },
    "areas": {"frontal_area": "900 m^2", "lateral_area": "2500 m^2"},
    "lighter water": {"water_density": 1000},
    "10 min wind": {"wind_mean": "10 min"},
    "file": {"coefficients": OWN},
    "from the side": {"current_angle": "50 deg", "current_yaw": "Clarke-lever"},
    "series-60": {"wind_angle": "40 deg", "current_yaw": "series-60"},
    "file from the side": {"current_angle": "60 deg", "coefficients": OWN},
}  # fmt: skip


def sized(tmp_path: Path, options: dict[str, Any]) -> tuple[TankerRequest, Sizing]:
    every = SHIP | options | {"at_rest": True}  # the run's ship is that of the written case
    given = {key: value for key, value in every.items() if value is not None}
    if "coefficients" in given:
        path = tmp_path / "own.toml"
        path.write_text(given["coefficients"], encoding="utf-8")
        given["coefficients"] = str(path)
    request = request_of(input_values("tanker", given))
    assert isinstance(request, TankerRequest)
    with alone():
        return request, size_tanker(request)


@pytest.mark.parametrize("name", OPTIONS)
def test_the_mean_of_a_run_is_the_force_at_rest(tmp_path: Path, name: str) -> None:
    """Wind and current, part by part, where the run has her lie, under the wind's mean of an hour.

    The run reads the case as it is written; the force at rest is that of the request.
    """
    request, of = sized(tmp_path, OPTIONS[name])
    for loads in of.settled.posed.loads:
        case = ship_afloat(request, of.settled, None, loads.load_case)
        assert case is not None
        moored, _ = moored_ship(parse_case(write_case(case)))
        ship = next(each for each in request.ships if each.condition == loads.condition)
        assert case.floater is not None
        wind_from = math.atan2(-moored.ship.wind[1], -moored.ship.wind[0])
        flow = moored.ship.current
        current_from = math.atan2(-flow[1], -flow[0])
        for heading in (wind_from, current_from, current_from - 0.4):
            wind, current = moored.ship.blown(heading)
            found = ship_loads(
                ship.ship,
                Wind(math.hypot(*moored.ship.wind)),
                SurfaceCurrent(request.environment.current.speed),
                SeaState(8.0, 0.0),
                loads.depth,
                wind_on=ship.wind_on,
                # A turn that is all but none, so that what is across is said, too.
                headings=Headings(wind_from, current_from, 0.3).seen_at(heading),
                water_density=request.environment.water_density,
                coefficients=ship.coefficients,
            )
            for kind, (along, across, _) in (("wind", wind), ("current", current)):
                parts = [each for each in found.components if each.kind == kind]
                surge = math.fsum(each.force for each in parts if each.axis == "surge")
                sway = math.fsum(each.force for each in parts if each.axis == "sway")
                scale = 2e-3 * math.hypot(surge, sway)
                assert along == pytest.approx(surge, rel=2e-3, abs=scale), (name, kind, heading)
                assert across == pytest.approx(-sway, rel=2e-3, abs=scale), (name, kind, heading)


def test_the_bow_is_one_place_at_rest_and_in_motion(tmp_path: Path) -> None:
    """Half the waterline before midships, where the ship turns about at rest."""
    case = sized(tmp_path, {})[1].ship_case
    assert case is not None
    assert case.floater is not None
    assert case.floater.ship is not None
    assert case.floater.ship.mooring_point == pytest.approx(0.5 * 0.97 * 210.0)


@pytest.mark.parametrize(
    "other",
    [
        {"load_method": "22TCN-222-95", "wave_coefficient": 0.1, "recalled": True},
        {"load_method": "UFC-4-159-03", "recalled": True},
        {"load_method": ["UFC-Blendermann", "22TCN-222-95"], "wave_coefficient": 0.1},
    ],
)
def test_a_method_that_a_run_has_not_is_refused(other: dict[str, Any]) -> None:
    """22TCN has no mean drift and UFC's wind no heading: what is named is honoured or refused."""
    with pytest.raises(InputError, match="UFC-Blendermann"):
        size_tanker(**SHIP, **other, in_motion=True, seeds=1, run_time="2 min")


def test_tables_of_no_file_are_refused(tmp_path: Path) -> None:
    """What was made in Python cannot be written for `catopt verify`, nor dropped."""
    request, of = sized(tmp_path, {"coefficients": OWN})
    own = parse_ship_coefficients(OWN)
    ships = tuple(replace(each, coefficients=own) for each in request.ships)
    assert ship_afloat(request, of.settled, None) is not None
    assert ship_afloat(replace(request, ships=ships), of.settled, None) is None


def test_growth_that_runs_know_nothing_of_is_refused() -> None:
    """It was listed as given, and the hull that ran was clean."""
    with pytest.raises(InputError, match="runs do not include marine growth"):
        size_buoy(
            "pillar 2.4 m", depth="12 m", hs="1 m", growth="100 mm", in_motion=True, seeds=1,
            run_time="1 min",
        )  # fmt: skip


@pytest.mark.parametrize("soil", ["rock", "gravel", "đá"])
def test_a_soil_in_which_no_drag_anchor_bites_says_what_holds_there(soil: str) -> None:
    """It was an unknown word."""
    with pytest.raises(InputError, match="no drag anchor has figures in rock or gravel"):
        size_tanker(**SHIP, soil=soil)
