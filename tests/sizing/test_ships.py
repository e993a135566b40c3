"""Kinds of ship, coefficients of their own and service types, as a sizing is told of them."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import pytest

from catopt.errors import InputError
from catopt.loads.ship_coefficients import SQUARE_ENDED
from catopt.sizing.converge import Assumed
from catopt.sizing.environment import SERVICE_TYPES, ServiceType, demands, left_out, mean_over
from catopt.sizing.file import read_sizing
from catopt.sizing.tanker import pose_tanker
from catopt.sizing.tanker_request import TankerRequest
from catopt.words import is_said, say

from .test_what_people_know import requested

HULL: dict[str, object] = {"length": 60.0, "breadth": 18.0, "draught": 3.5, "depth": 20.0}
HEAD = """
schema = "catopt.ship-coefficients/1"
name = "basin"
source = "report 12"
confidence = "A"
angles_from = "bow"
"""
WIND = """
[[wind]]
along_area = "frontal"
across_area = "lateral"
angles = [0, 180]
along = [-0.8, 0.6]
across = [0, 0]
"""
CURRENT = """
[[current]]
along_area = "breadth x draught"
across_area = "length x draught"
angles = [0, 180]
along = [-0.5, 0.5]
across = [0, 0]
yaw = [0, 0]
"""


asked = partial(requested, **HULL)


def told(**more: object) -> dict[str, str]:
    with pytest.raises(InputError) as refused:
        asked(**more)
    return {each.key: each.allowed for each in refused.value.problems}


def said(of: TankerRequest, key: str) -> list[str]:
    return [each for each in of.estimates if is_said(each, key)]


def coefficients(folder: Path, tables: str) -> str:
    path = folder / "own.toml"
    path.write_text(HEAD + tables, encoding="utf-8")
    return str(path)


# ------------------------------------------------------------------ kinds


def test_a_barge_has_four_to_six_times_a_ship_s_current_along_it() -> None:
    """In the sizing's own loads: 1/2 1025 1.0^2 18 x 3.5 x 1.00 = 32.3 kN, and a ship's 7.3."""
    forces = []
    for kind in ("barge", "general cargo"):
        request = asked(ship=kind, condition="loaded", current=1.0)
        (at,) = pose_tanker(request, Assumed()).loads
        forces.append(at.parts[0].of("current"))
    assert forces[0] == pytest.approx(0.5 * 1025.0 * 18.0 * 3.5, rel=1e-12)
    assert 4.0 < forces[0] / forces[1] < 6.0


def test_a_barge_is_a_box_loaded_alone() -> None:
    request = asked(ship="barge")
    (moored,) = request.ships
    assert moored.coefficients is SQUARE_ENDED
    assert moored.ship.displacement == 60.0 * 18.0 * 3.5
    assert said(request, "loads.estimated_box")
    assert said(request, "sizing.no_ballast")
    assert not said(request, "sizing.not_square_ended")
    assert [each.condition for each in asked(ship="barge", ballast_draught=1.0).ships] == [
        "loaded",
        "ballast",
    ]


@pytest.mark.parametrize(
    ("kind", "length", "warned"),
    [
        ("general cargo", 120.0, True),
        ("tanker", 120.0, False),
        ("tanker", 80.0, True),  # 4.4 breadths
    ],
)
def test_a_hull_that_may_be_a_barge_s_is_told(kind: str, length: float, warned: bool) -> None:
    assert bool(said(asked(ship=kind, length=length), "sizing.not_square_ended")) is warned


def test_what_is_not_known_of_barges_is_refused() -> None:
    whole = {"length": None, "breadth": None, "draught": None, "ship": "barge", "dwt": "3000 t"}
    assert "no table of barges" in told(**whole)["dwt"]
    assert "a barge" in told(ship="general cargo", dwt="3500 t")["dwt"]


# ------------------------------------------------------------------ coefficients


def test_a_file_of_coefficients_beside_the_sizing_s(tmp_path: Path) -> None:
    """Wind 1/2 1.221 25^2 x 0.8 AF, current 1/2 1025 x 0.5 B T, from ahead."""
    coefficients(tmp_path, WIND + CURRENT)
    file = tmp_path / "sizing.toml"
    file.write_text(
        '[ship]\nlength = "60 m"\nbreadth = "18 m"\ndraught = "3.5 m"\ncondition = ["loaded"]\n'
        'coefficients = "own.toml"\n[site]\nwater_depth = "20 m"\n',
        encoding="utf-8",
    )
    request = read_sizing(file)
    assert isinstance(request, TankerRequest)
    (at,) = pose_tanker(request, Assumed()).loads
    (part,) = at.parts
    area = request.ships[0].ship.frontal_area
    assert part.method == "basin"
    assert part.of("wind") == pytest.approx(0.5 * 1.221 * 625.0 * 0.8 * area, rel=1e-12)
    assert part.of("current") == pytest.approx(0.5 * 1025.0 * 0.5 * 63.0, rel=1e-12)


def test_coefficients_and_another_method_are_refused_together(tmp_path: Path) -> None:
    own = coefficients(tmp_path, WIND + CURRENT)
    assert told(coefficients=own, load_method="22TCN-222-95", wave_coefficient=0) == {
        "coefficients": "leave it out, or load_method, which it replaces"
    }


def test_a_barge_wants_both_tables(tmp_path: Path) -> None:
    own = coefficients(tmp_path, WIND)
    assert (
        "needs tables of wind and current" in told(ship="barge", coefficients=own)["coefficients"]
    )


def test_the_turning_is_that_of_the_table_or_of_ufc(tmp_path: Path) -> None:
    own = coefficients(tmp_path, WIND + CURRENT)
    turned = {"coefficients": own, "current_angle": "20 deg"}
    turning = asked(**turned).weathervaning.turning
    assert turning is not None
    assert turning.yaw is None
    assert "leave it out" in told(**turned, current_yaw="series-60")["current_yaw"]
    alone = coefficients(tmp_path, WIND)
    assert "missing" in told(coefficients=alone, current_angle="20 deg")["current_yaw"]


def test_what_is_wrong_in_a_file_of_coefficients_is_told_by_its_input(tmp_path: Path) -> None:
    own = coefficients(tmp_path, WIND.replace("angles", "angels"))
    with pytest.raises(InputError) as refused:
        asked(coefficients=own)
    found = {(each.key, each.found, each.allowed) for each in refused.value.problems}
    assert ("coefficients", "wind[0].angels an unknown key", "did you mean angles?") in found
    assert {each[0] for each in found} == {"coefficients"}


# ------------------------------------------------------------------ service type


def test_the_service_type_is_assumed_and_said() -> None:
    request = asked()
    assert request.service_type == "II"
    assert "service type II" in request.defaults
    assert said(request, "sizing.service_steady")
    given = asked(service_type="III")
    assert not any("service type" in each for each in given.defaults)
    (dynamic,) = said(given, "sizing.service_dynamic")
    assert "DYNAMIC METHODS are required" in dynamic
    assert "PHƯƠNG PHÁP ĐỘNG" in say(dynamic, "vi")


@pytest.mark.parametrize("of", SERVICE_TYPES)
def test_every_type_says_what_the_code_asks_for(of: ServiceType) -> None:
    keys = [getattr(each, "key", "") for each in demands(of, asked().environment)]
    first = "sizing.service_dynamic" if of in {"III", "IV"} else "sizing.service_steady"
    # The wind that is taken, 25 m/s, is more than the 34 kn of mild weather.
    beyond = ["sizing.service_beyond"] if of == "I" else []
    assert keys == [first, *beyond, "sizing.fishtailing"]


@pytest.mark.parametrize(
    ("wind", "current", "beyond"), [(17.4, 1.0, 0), (17.6, 1.0, 1), (5.0, 1.1, 1)]
)
def test_mild_weather_is_below_34_and_2_knots(wind: float, current: float, beyond: int) -> None:
    """34 kn are 17.49 m/s, 2 kn 1.029."""
    request = asked(wind=wind, current=current, service_type="I")
    assert len(said(request, "sizing.service_beyond")) == beyond


def test_a_gust_is_named_by_its_share() -> None:
    """NPD at 20 m/s of the hour: 3 s 1.324, 30 s 1.219; (1.324/1.219)^2 = 1.180 of the force."""
    env = asked(wind=mean_over(20.0, 3600.0, 30.0)).environment
    assert env.wind.speed == pytest.approx(20.0 * 1.219, abs=0.02)
    message = left_out(env)
    share = 100.0 * ((1.324 / 1.219) ** 2 - 1.0)
    assert message.values["share"] == pytest.approx(share, abs=0.3)
    assert said(asked(at_rest=True), "sizing.motions_left_out")
    assert left_out(asked(wind=0.0).environment).values["share"] == 0.0
