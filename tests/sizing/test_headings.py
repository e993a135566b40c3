"""A ship on one point, pushed from different directions: the worst heading."""

from __future__ import annotations

import math
from typing import Any

import pytest

from catopt.answers.blocks import Trail
from catopt.answers.note_size import size_note_answer
from catopt.errors import InputError
from catopt.loads import YAW_TYPES, Afloat, Headings, Turning, every_lying
from catopt.notes.line import Given, size_note
from catopt.notes.origin import Asked
from catopt.sizing.input_values import input_values
from catopt.sizing.requests import request_of
from catopt.sizing.result import Sizing
from catopt.sizing.tanker_request import TankerRequest
from catopt.words import say
from tests.sizing.at_rest import size_tanker

SHIP: dict[str, Any] = {
    "dwt": "50000 t",
    "depth": "20 m",
    "low_water": "18 m",
    "ballast_draught": "6.1 m",
}
SCAN: dict[str, Any] = {"scan": "30 deg", "current_yaw": "series-60"}


@pytest.fixture(scope="module")
def turned() -> Sizing:
    return size_tanker(**SHIP, **SCAN)


def test_each_load_case_has_the_largest_force_of_all_directions_and_headings(
    turned: Sizing,
) -> None:
    request = request_of(input_values("tanker", {**SHIP, **SCAN}))
    assert isinstance(request, TankerRequest)
    env = request.environment
    round_ = [Headings(current=math.remainder(k * math.pi / 6.0, math.tau)) for k in range(12)]
    for loads, moored in zip(
        turned.settled.posed.loads, (each for each in request.ships for _ in range(2)), strict=True
    ):
        forces = [
            each.loads.horizontal_force
            for each in every_lying(
                [Afloat(moored.condition, moored.ship, moored.wind_on)],
                *(env.wind, env.current, env.sea),
                [loads.depth],
                round_,
                methods=["UFC-Blendermann"],
                turning=Turning(YAW_TYPES["series-60"]),
            )
        ]
        assert loads.horizontal_force == pytest.approx(max(forces), rel=1e-9)
        assert len(forces) >= 12
    carried = {each.name: each.horizontal_force for each in turned.case.load_cases}
    for loads in turned.settled.posed.loads:
        # With the dynamic factor that goes with UFC, 2.00/1.67.
        force = 1.2 * loads.horizontal_force
        assert carried[loads.load_case] == pytest.approx(force, rel=1e-12)


def test_the_answer_says_which_heading_and_draught_governed(turned: Sizing) -> None:
    worst = max(turned.settled.posed.loads, key=lambda each: each.horizontal_force)
    lying = worst.lying
    assert lying is not None
    said = turned.assumptions[0]
    assert "of 12 directions of the current and every stable heading" in said
    assert f"{worst.horizontal_force / 1e3:.1f} kN, loaded, low water" in said
    current, bow = (math.degrees(each) for each in (lying.directions.current, lying.heading))
    assert f"current from {current:.0f} deg, waves from 0 deg, bow to {bow:.0f} deg" in said
    assert "đầy tải, mực nước thấp" in say(said, "vi")
    assert "recalled (R)" in turned.assumptions[1]
    heading = turned.to_dict()["loads"][1]["heading"]
    assert heading["heading_rad"] == lying.heading
    assert heading["condition"] == "loaded"


def test_a_scan_asks_for_no_less_than_everything_from_one_side(turned: Sizing) -> None:
    """The first direction of the scan is that of wind and waves."""
    ahead = size_tanker(**SHIP)
    for one, other in zip(turned.settled.posed.loads, ahead.settled.posed.loads, strict=True):
        assert one.horizontal_force >= other.horizontal_force
    assert (turned.point.line.mass or 0.0) > (ahead.point.line.mass or 0.0)
    assert ahead.assumptions[0].startswith("The ship weathervanes and lies head to wind")


def test_the_note_adds_forces_along_and_across_the_ship_up(turned: Sizing) -> None:
    answer = size_note_answer(size_note(turned, Given(), Asked(verify=False)))
    trails = [b for s in answer.sections for b in s.blocks if isinstance(b, Trail)]
    loads = [each for each in trails if each.name == "size_load"]
    for at, trail in zip(turned.settled.posed.loads, loads, strict=True):
        along, across, total = trail.steps[-3:]
        assert sum(term for (term,) in along.terms) == pytest.approx(along.value, rel=1e-12)
        assert sum(term for (term,) in across.terms) == pytest.approx(across.value, rel=1e-12)
        assert along.value is not None
        assert across.value is not None
        assert total.value == pytest.approx(math.hypot(along.value, across.value), rel=1e-12)
        assert total.value == pytest.approx(at.horizontal_force, rel=1e-12)


@pytest.mark.parametrize(
    ("inputs", "told"),
    [
        (
            {"current_angle": "90 deg"},
            {"current_yaw": "missing; Clarke-lever, one of series-60, FFG"},
        ),
        (
            {"current_yaw": "FFG"},
            {"current_yaw": "leave it out, or give one of wind_angle, current_angle, wave_angle"},
        ),
        (
            {"scan": "0.5 deg", "current_yaw": "VLCC"},
            {"scan": "a step of 1 to 180 deg is required", "current_yaw": "one of series-60, FFG"},
        ),
        (
            {**SCAN, "load_method": ["UFC-4-159-03"]},
            {"wind_angle": "UFC-4-159-03 has coefficients here for wind along the ship only"},
        ),
    ],
)
def test_what_cannot_be_turned_is_refused(inputs: dict[str, Any], told: dict[str, str]) -> None:
    with pytest.raises(InputError) as caught:
        size_tanker(**SHIP, **inputs)
    found = {each.key: each.allowed for each in caught.value.problems}
    assert found.keys() == told.keys()
    assert all(words in found[key] for key, words in told.items())


def test_a_sinker_s_usual_factor_is_cited_by_its_source() -> None:
    """IALA's 1.5 (CALMAR 6.2.6), where nobody gave another."""
    sizing = size_tanker(dwt="50000 t", depth="20 m", anchor="sinker")
    sliding = [each for each in sizing.point.checks.results if each.kind == "sliding"]
    assert sliding
    assert all("CALMAR" in each.source.text and "6.2.6" in each.source.text for each in sliding)


def test_the_forces_that_the_page_prints(turned: Sizing) -> None:
    """docs/sizing.md, headings: 800 kN, loaded at low water, where 349 kN come from one side."""
    worst = max(turned.settled.posed.loads, key=lambda each: each.horizontal_force)
    assert (worst.load_case, round(worst.horizontal_force / 1e3)) == ("loaded, low water", 800)
    ahead = size_tanker(**SHIP).settled.posed.loads
    assert round(max(each.horizontal_force for each in ahead) / 1e3) == 349
