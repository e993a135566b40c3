"""From what is said to a request: what follows from it, what is taken, and that it is told."""

from __future__ import annotations

import math
from typing import Any

import pytest

from catopt.errors import InputError
from catopt.loads import BuoyShape
from catopt.sizing import BuoyRequest, DragGround, GivenBuoy, SinkerGround, TankerRequest
from catopt.sizing.buoy import growth_weight, pose_buoy
from catopt.sizing.converge import Assumed
from catopt.sizing.input_values import input_values
from catopt.sizing.line_choice import sold
from catopt.sizing.requests import request_of
from tests.sizing.at_rest import size_buoy, size_tanker

SHIP: dict[str, Any] = {"length": 200.0, "breadth": 32.0, "draught": 12.0, "depth": 20.0}
BUOY: dict[str, Any] = {"buoy": "pillar 1.8 m", "depth": 12.0}
FORCE: dict[str, Any] = {"force": "5 kN", "reserve_buoyancy": "12 kN", "depth": 12.0}


def of_a_ship(**more: Any) -> TankerRequest:
    request = request_of(input_values("tanker", SHIP | more))
    assert isinstance(request, TankerRequest)
    return request


def of_a_buoy(given: Any = BUOY, /, **more: Any) -> BuoyRequest:
    request = request_of(input_values("buoy", given | more))
    assert isinstance(request, BuoyRequest)
    return request


def test_title_and_source_are_one_s_own_or_none() -> None:
    own = {"title": "Berth 3", "source": "Harbour survey of 2024"}
    for request in (of_a_ship(**own), of_a_buoy(**own)):
        assert (request.title, request.source) == ("Berth 3", "Harbour survey of 2024")
    for request in (of_a_ship(), of_a_buoy()):
        assert (request.title, request.source) == ("", "")


def test_a_case_says_where_its_figures_come_from() -> None:
    quick: dict[str, Any] = {"diameter_min": 0.06, "diameter_max": 0.07, "length_step": 27.5}
    own = size_tanker(**SHIP, **quick, source="Harbour survey of 2024", title="Berth 3")
    assert (own.case.source, own.case.title) == ("Harbour survey of 2024", "Berth 3")
    assert size_tanker(**SHIP, **quick).case.source == "catopt size tanker"


def test_a_buoy_s_case_says_where_its_figures_come_from() -> None:
    one = {"diameter_min": 0.02, "diameter_max": 0.024, "reserve_buoyancy": "30 kN"}
    named = size_buoy(**FORCE | one, source="Log of 2020", title="Reef")
    assert (named.case.source, named.case.title) == ("Log of 2020", "Reef")
    plain = size_buoy(**FORCE | one).case
    assert (plain.source, plain.title) == ("catopt size buoy", "buoy in 12 m of water")


@pytest.mark.parametrize(
    ("given", "hs", "hmax", "period"),
    [
        ({}, 2.0, 3.7, 5.1),  # 3.6 sqrt(2) = 5.09
        ({"hs": 2.25}, 2.25, 4.1625, 5.4),
        ({"hs": 0.0}, 0.0, 0.0, 1.0),
        ({"hmax": 1.85}, 1.0, 1.85, 3.6),
        ({"hmax": 7.4}, 4.0, 7.4, 7.2),
        ({"hmax": 0.0}, 0.0, 0.0, 1.0),
        ({"hs": 4.0, "hmax": 6.0}, 4.0, 6.0, 7.2),
        ({"hmax": 7.4, "period": 9.0}, 4.0, 7.4, 9.0),
    ],
)
def test_the_waves_that_are_not_given_follow_from_those_that_are(
    given: dict[str, float], hs: float, hmax: float, period: float
) -> None:
    """Hmax = 1.85 Hs (CALMAR); the period is 3.6 sqrt(Hs) to a tenth, 1 s at least."""
    for request in (of_a_ship(**given), of_a_buoy(**given)):
        sea = request.environment.sea
        assert (sea.hs, sea.hmax) == pytest.approx((hs, hmax), rel=1e-12)
        assert sea.period == pytest.approx(period, rel=1e-12)
        said = any("wave period" in each for each in request.defaults)
        assert said == ("period" not in given)


@pytest.mark.parametrize(
    ("soil", "found", "said"),
    [
        (None, "sand", False),
        ("sand", "sand", False),
        ("soft clay", "soft clay", False),
        ("mud", "soft clay", True),
        ("soft mud", "soft clay", True),
    ],
)
def test_mud_alone_is_told_to_be_taken_for_soft_clay(
    soil: str | None, found: str, said: bool
) -> None:
    request = of_a_ship(soil=soil)
    assert isinstance(request.ground, DragGround)
    assert request.ground.soil == found
    assert any("taken as soft clay" in each for each in request.defaults) == said
    assert ("soil sand" in request.defaults) == (soil is None)


def test_a_sinker_is_on_no_clay_that_was_taken_for_mud() -> None:
    request = of_a_ship(anchor="sinker", friction=0.4)
    assert isinstance(request.ground, SinkerGround)
    assert request.ground.mu == 0.4
    assert not any(word in each for each in request.defaults for word in ("soil", "clay"))


def test_all_that_was_taken_is_told_and_nothing_that_was_given() -> None:
    taken = of_a_buoy().defaults
    assert taken == (
        "wind 25 m/s", "current 1 m/s", "Hs 2 m", "life 5 years", "wear 0.4 mm/year",
        "wave period 5.1 s", "no tide", "sinker friction 1.0, the code's own for any ground",
        "no return period", "chain open-link 4D Q2", "code IALA-CALMAR",
    )  # fmt: skip
    given = of_a_buoy(
        wind=20.0, current=0.5, hs=1.0, life=0.0, wear=0.0, period=6.0, low_water=10.0,
        friction=0.4, return_period="50 years", chain="chain studless R3", code="break/5",
    )  # fmt: skip
    assert given.defaults == ()  # no life: nothing is exceeded in it


def test_a_return_period_is_of_weather_that_is_given_and_is_used() -> None:
    """1 - 0.98^5 = 9.6 %; of weather that was taken there is no return period."""
    weather = {"wind": 30.0, "current": 1.0, "hs": 2.0}
    said = of_a_buoy(**weather, return_period="50 years").defaults
    assert "weather of 50 years, probability of exceedance 10% in 5 years" in said
    with pytest.raises(InputError, match="current and hs not given"):
        of_a_buoy(wind=30.0, return_period="50 years")


def test_the_largest_size_of_a_ship_s_chain_is_told_where_no_bound_is_given() -> None:
    """120 mm; a smallest size that is given moves it."""
    assert of_a_ship().defaults[-1] == "sizes up to 120 mm"
    for bound in ({"diameter_min": 0.05}, {"diameter_max": 0.1}):
        assert not any("sizes" in each for each in of_a_ship(**bound).defaults)
    bounds = {
        None: (None, 0.12),
        0.05: (0.05, 0.12),
        0.13: (0.13, 0.13),
    }
    for least, both in bounds.items():
        line = of_a_ship(diameter_min=least).line
        assert (line.diameter_min, line.diameter_max) == both
    assert of_a_ship(diameter_max=0.1).line.diameter_max == 0.1
    with pytest.raises(InputError, match="diameter_max"):
        of_a_ship(diameter_min=0.11, diameter_max=0.1)


def test_a_ship_in_ballast_shows_what_she_has_risen() -> None:
    """She rises 12 - 7 = 5 m: 32 m x 5 m more from ahead, 200 m x 5 m from abeam."""
    areas = {"frontal_area": 900.0, "lateral_area": 1500.0, "dwt": "40000 t"}
    loaded, ballast = of_a_ship(ballast_draught=7.0, **areas).ships
    assert (loaded.ship.frontal_area, loaded.ship.lateral_area) == (900.0, 1500.0)
    assert (ballast.ship.frontal_area, ballast.ship.lateral_area) == (1060.0, 2500.0)
    assert (loaded.wind_on, ballast.wind_on) == ("tanker loaded", "tanker ballast")
    assert (loaded.deadweight, ballast.deadweight) == (40e6, None)  # it is that of the cargo
    assert loaded.ship.name == ballast.ship.name == "tanker of 40,000 DWT"
    assert of_a_ship().ships[0].ship.name == "tanker"


def test_a_ship_s_deck_is_three_tenths_of_the_draught_above_the_water() -> None:
    """Its depth is 1.3 draughts: 15.6 m; with 15 m of house 18.6 m x 32 m show from ahead."""
    loaded, ballast = of_a_ship(ballast_draught=7.0).ships
    assert (loaded.fairlead, ballast.fairlead) == pytest.approx((3.6, 8.6), rel=1e-12)
    assert loaded.ship.frontal_area == pytest.approx(32.0 * 18.6, rel=1e-12)
    assert ballast.ship.frontal_area == pytest.approx(32.0 * 23.6, rel=1e-12)
    deep_hull = of_a_ship(ballast_draught=7.0, moulded_depth=17.0).ships
    assert [each.fairlead for each in deep_hull] == [5.0, 10.0]
    assert deep_hull[0].ship.frontal_area == pytest.approx(32.0 * 20.0, rel=1e-12)


def test_a_fairlead_that_is_given_rises_with_the_ship() -> None:
    """It is that of the loaded ship, 2 m up; 0 is given too."""
    assert [each.fairlead for each in of_a_ship(ballast_draught=7.0, fairlead=2.0).ships] == [
        2.0,
        7.0,
    ]
    assert of_a_ship(fairlead=0.0).ships[0].fairlead == 0.0


def test_each_draught_is_held_against_the_water_at_low_water() -> None:
    for more, key in (
        ({"low_water": 12.0}, "draught"),
        ({"draught": 5.0, "moulded_depth": 16.0, "ballast_draught": 6.0, "low_water": 6.0}, None),
    ):
        with pytest.raises(InputError) as caught:
            of_a_ship(**more)
        keys = [each.key for each in caught.value.problems]
        assert keys == [key or "ballast_draught"]
    assert len(of_a_ship(low_water=12.01).ships) == 2


def test_a_force_that_is_given_has_wind_and_current_in_it() -> None:
    request = of_a_buoy(FORCE)
    assert request.buoy == GivenBuoy(5e3, 12e3, 0.0)
    assert (request.environment.wind.speed, request.environment.current.speed) == (0.0, 0.0)
    shaped = of_a_buoy()
    assert (shaped.environment.wind.speed, shaped.environment.current.speed) == (25.0, 1.0)


def test_growth_and_tide_are_those_that_are_given_or_none() -> None:
    assert of_a_buoy().marine_growth == 0.0
    assert of_a_buoy(growth="50 mm").marine_growth == 0.05


def test_growth_weighs_on_hull_and_chain_and_takes_of_the_reserve() -> None:
    """50 mm on a bar of 30 mm under a pull of 5 kN.

    2 x (1325 - 1025) g x pi/4 (0.13^2 - 0.03^2) = 73.9 N/m on what hangs; on the wetted hull
    300 g x 0.05 = 147 N/m2.
    """
    request = of_a_buoy(growth="50 mm")
    shape, rho = request.buoy, 1025.0
    assert isinstance(shape, BuoyShape)
    grown = growth_weight(request, Assumed(0.030, 5e3))
    (chain,) = (e for e in sold(request.line, rho) if e.nominal_diameter == 0.030)
    ring = 2.0 * 300.0 * 9.80665 * math.pi / 4.0 * (0.13**2 - 0.03**2)
    assert ring == pytest.approx(73.9, abs=0.05)
    wet = math.pi * shape.outline(high=shape.afloat(5e3, rho).draught)
    wet += math.pi / 4.0 * shape.widest**2
    by_hand = ring * 5e3 / chain.submerged_weight + 300.0 * 9.80665 * 0.05 * wet
    assert grown == pytest.approx(by_hand, rel=1e-12)
    assert growth_weight(of_a_buoy(), Assumed(0.030, 5e3)) == 0.0
    with pytest.raises(InputError, match="more than the reserve buoyancy"):
        pose_buoy(of_a_buoy(growth="400 mm"), Assumed(0.030, 5e3))
    case = pose_buoy(request, Assumed(0.030, 5e3)).case
    assert case.buoy is not None
    assert case.buoy.reserve_buoyancy == pytest.approx(request.reserve_buoyancy - grown)
    levels = of_a_buoy(low_water=10.0).environment.levels
    assert (levels.low, levels.high) == (10.0, 12.0)
    assert of_a_buoy().environment.levels.low == 12.0


def test_a_hawser_of_50_m_is_taken_where_there_is_a_buoy() -> None:
    assert of_a_ship().hawser == 0.0
    at_buoy = {"buoy": "mooring buoy 5.0 m"}
    assert of_a_ship(**at_buoy).hawser == 50.0
    assert of_a_ship(**at_buoy, hawser="80 m").hawser == 80.0
    assert of_a_ship(**at_buoy, hawser=0.0).hawser == 0.0


def test_clump_weights_are_those_that_are_given() -> None:
    assert of_a_ship().clump_masses == ()
    assert of_a_ship(clump_weight=["10 t", "5 t"]).clump_masses == (10e3, 5e3)


def test_a_buoy_s_chain_is_one_that_she_is_made_for_unless_another_is_asked_for() -> None:
    """A pillar of 1.8 m has 20 to 30 mm; of one by its force nothing is known."""
    bounds = {
        (): (0.02, 0.03),
        (("diameter_min", 0.024),): (0.024, 0.03),
        (("diameter_max", 0.028),): (0.02, 0.028),
        (("diameter_min", 0.014), ("diameter_max", 0.06)): (0.014, 0.06),
        # A bound that is given may lie beyond the buoy's other one, which then says nothing.
        (("diameter_min", 0.038),): (0.038, None),
        (("diameter_max", 0.018),): (None, 0.018),
    }
    for given, both in bounds.items():
        line = of_a_buoy(**dict(given)).line
        assert (line.diameter_min, line.diameter_max) == both
    free = of_a_buoy(FORCE).line
    assert (free.diameter_min, free.diameter_max) == (None, None)


@pytest.mark.parametrize(
    ("given", "found"),
    [
        ({}, (2.0, 3.0)),
        ({"scope_min": 2.5}, (2.5, 3.0)),
        ({"scope_max": 4.0}, (2.0, 4.0)),
        ({"scope_min": 0.0}, (0.0, 3.0)),
        # One that is given moves the usual other one.
        ({"scope_min": 5.0}, (5.0, 5.0)),
        ({"scope_max": 1.5}, (1.5, 1.5)),
    ],
)
def test_a_buoy_s_line_is_of_two_to_three_depths_unless_another_scope_is_asked_for(
    given: dict[str, float], found: tuple[float, float]
) -> None:
    assert of_a_buoy(**given).line.scope == found


def test_of_two_scopes_that_are_given_the_largest_is_no_less() -> None:
    with pytest.raises(InputError) as caught:
        of_a_buoy(scope_min=4.0, scope_max=3.0)
    assert {each.key: each.allowed for each in caught.value.problems} == {
        "scope_max": "below scope_min, 4"
    }


@pytest.mark.parametrize(
    ("prefer", "chain", "found"),
    [
        (None, "chain studless R3", "practice"),
        (None, "chain studless R3S", "practice"),
        ("cheapest", "chain studless R3", "cheapest"),
        ("practice", "chain studless R3S", "practice"),
        ("shortest", "chain studless R3S", "shortest"),
        ("lightest", "chain studless R3", "lightest"),
        ("least-swing", "chain studless R3S", "least-swing"),
    ],
)
def test_a_ship_s_line_is_what_is_laid_unless_another_is_asked_for(
    prefer: str | None, chain: str, found: str
) -> None:
    line = of_a_ship(prefer=prefer, chain=chain).line
    assert (line.prefer, line.looks_for, line.swing_price) == (found, found, 0.0)


def test_a_ship_s_line_is_balanced_where_it_is_not_run() -> None:
    assert of_a_ship(at_rest=True).line.looks_for == "balanced"
    assert of_a_ship(at_rest=True, prefer="shortest").line.looks_for == "shortest"


def test_a_buoy_s_line_is_that_of_practice_unless_another_is_asked_for() -> None:
    """Of 2.5 depths; nothing of it hangs on a price."""
    assert of_a_buoy().line.looks_for == "practice"
    assert of_a_buoy(prefer="lightest").line.looks_for == "lightest"
    assert (of_a_buoy().scope, of_a_buoy(scope=2.0).scope) == (2.5, 2.0)


def test_a_price_of_swing_makes_the_cheapest_line_the_one_that_is_looked_for() -> None:
    line = of_a_ship(swing_price=500.0).line
    assert (line.prefer, line.swing_price) == ("cheapest", 500.0)


def test_the_allowance_for_motion_is_that_of_the_code_unless_another_is_given() -> None:
    """IALA has none of its own; UFC's and API's are 2.00/1.67, and so is one without any."""
    assert of_a_buoy().line.allowance == 1.0
    assert of_a_ship().line.allowance == 1.2
    assert of_a_ship(code="break/5").line.allowance == 1.0
    for code in ("API-RP-2SK", "DNV-OS-E301-2008-CC1"):
        line = of_a_ship(code=code).line
        assert line.allowance == 1.2
        assert line.motion.startswith("API-RP-2SK: ")
    given = of_a_ship(dynamic_factor=1.0).line
    assert (given.allowance, given.motion) == (1.0, "given")


def test_a_wind_of_30_s_needs_no_word_and_another_has_one() -> None:
    """Of an hour, 20 m/s, 30 s have 1.219 times as much (engineering facts)."""
    for mean in (None, 30.0):
        request = of_a_ship(wind=20.0, wind_mean=mean)
        assert request.environment.wind.speed == 20.0
        assert not any("as a mean of" in each for each in request.estimates)
    raised = of_a_ship(wind=20.0, wind_mean="3600 s")
    assert raised.environment.wind.speed == pytest.approx(1.219 * 20.0, abs=5.1e-4 * 20.0)
    assert any("Wind of 20 m/s averaged over" in each for each in raised.estimates)
    still = of_a_ship(wind=0.0, wind_mean="600 s")
    assert still.environment.wind.speed == 0.0


@pytest.mark.parametrize(
    ("name", "directions"),
    [
        ("wind_angle", (math.pi / 6.0, 0.0, 0.0)),
        ("current_angle", (0.0, math.pi / 6.0, 0.0)),
        ("wave_angle", (0.0, 0.0, math.pi / 6.0)),
    ],
)
def test_what_comes_from_no_side_that_is_given_comes_from_ahead(
    name: str, directions: tuple[float, float, float]
) -> None:
    (found,), turning = of_a_ship(**{name: "30 deg"}, current_yaw="series-60").weathervaning
    assert (found.wind, found.current, found.waves) == pytest.approx(directions, rel=1e-12)
    assert turning is not None
    assert of_a_ship().weathervaning.turning is None


@pytest.mark.parametrize(
    ("depth", "said"), [("40.5 ft", "40.5 ft"), ("12,5 m", "12.5 m"), (12, "12 m")]
)
def test_a_title_has_the_depth_in_the_unit_in_which_it_was_given(depth: object, said: str) -> None:
    found = size_buoy("pillar 1.8 m", depth=depth, at_rest=True)
    assert found.case.title == f"pillar 1.8 m in {said} of water"
