"""Bounds, defaults and steps of what a sizing takes: each is kept, and not a bit more."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from functools import partial
from typing import Any

import pytest

from catopt.errors import InputError
from catopt.loads import Headings, SeaState, SurfaceCurrent, WaterLevels, Wind, buoy
from catopt.loads.ship_loads import TCN
from catopt.sizing import (
    BuoyRequest,
    DragGround,
    Environment,
    GivenBuoy,
    LineChoice,
    SinkerGround,
    TankerRequest,
)
from catopt.sizing.alternatives import Alternative
from catopt.sizing.environment import current_headings, mean_over, usual_period
from catopt.sizing.line_choice import longest_useful, round_step, sold
from tests.sizing.at_rest import size_tanker
from tests.sizing.test_consistency import LOADED, SHIP, deep

YEAR = 365.25 * 86400.0
"""s, the Julian one."""


def told(make: Callable[[], object]) -> dict[str, str]:
    """Return what is wrong, by its key."""
    with pytest.raises(InputError) as caught:
        make()
    return {each.key: each.allowed for each in caught.value.problems}


def ship_s(**changes: Any) -> TankerRequest:
    """Make a tanker's request at a buoy, so that a hawser has something to go to."""
    plain = TankerRequest((LOADED,), deep(), buoy=buoy("mooring buoy 5.0 m"))
    return dataclasses.replace(plain, **changes)


def line(**changes: Any) -> LineChoice:
    return LineChoice(("chain studless R3",), "break/5", **changes)


@pytest.mark.parametrize(
    ("changes", "key", "allowed"),
    [
        ({"hawser": -0.01}, "hawser", "must be 0 m or more"),
        ({"hawser": 1000.1}, "hawser", "must be 1000 m or less"),
        ({"pretension": 0.0}, "pretension", "must be above 0"),
        ({"pretension": 0.91}, "pretension", "must be 0.9 or less"),
        ({"lines": 0}, "lines", "1, or 3 to 24 around the body, are required"),
        ({"lines": 2}, "lines", "1, or 3 to 24 around the body, are required"),
        ({"lines": 25}, "lines", "1, or 3 to 24 around the body, are required"),
        ({"clump_masses": (5e3, 0.0)}, "clump_masses[1]", "must be above 0 kg"),
        ({"clump_density": 1100.0}, "clump_density", "must be above 1100 kg/m3"),
        ({"clump_density": 20001.0}, "clump_density", "must be 20000 kg/m3 or less"),
        (
            {"hawser": 0.05, "buoy": None},
            "hawser",
            "needs a buoy: give one, or leave it out",
        ),
    ],
)
def test_a_ship_s_request_is_refused_beyond_its_bounds(
    changes: dict[str, Any], key: str, allowed: str
) -> None:
    assert told(lambda: ship_s(**changes)) == {key: allowed}


@pytest.mark.parametrize(
    "changes",
    [
        {"hawser": 0.0, "buoy": None},
        {"hawser": 0.05},
        {"hawser": 1000.0},
        {"pretension": 0.01},
        {"pretension": 0.9},
        {"lines": 1},
        {"lines": 3},
        {"lines": 24},
        {"clump_masses": (0.05,)},
        {"clump_density": 1100.5},
        {"clump_density": 20e3},
    ],
)
def test_a_ship_s_request_is_taken_at_its_bounds(changes: dict[str, Any]) -> None:
    request = ship_s(**changes)
    for key, value in changes.items():
        assert getattr(request, key) == value


def test_what_a_ship_s_request_has_when_nothing_is_said() -> None:
    """A clump weight is of concrete, 2400 kg/m3; there is no hawser, and one line."""
    request = TankerRequest((LOADED,), deep())
    assert (request.hawser, request.lines, request.clump_density) == (0.0, 1, 2400.0)
    assert (request.pretension, request.clump_masses) == (0.1, ())
    assert (request.line.diameter_max, request.line.length_step) == (0.12, 13.75)


def test_the_coefficient_of_waves_is_a_part() -> None:
    by_tcn = {"load_methods": (TCN,)}
    for value in (0.0, 1.0):
        assert ship_s(wave_coefficient=value, **by_tcn).wave_coefficient == value
    for value, allowed in ((-0.01, "must be 0 or more"), (1.01, "must be 1 or less")):
        found = told(lambda value=value: ship_s(wave_coefficient=value, **by_tcn))  # type: ignore[misc]
        assert found == {"wave_coefficient": allowed}
    calm = dataclasses.replace(deep(), sea=SeaState(8.0, 0.0))
    assert ship_s(environment=calm, **by_tcn).wave_coefficient is None
    slight = dataclasses.replace(deep(), sea=SeaState(8.0, maximum_height=0.05))
    assert "wave_coefficient" in told(lambda: ship_s(environment=slight, **by_tcn))
    assert "load_methods" in told(lambda: ship_s(load_methods=()))


@pytest.mark.parametrize(
    ("condition", "key"), [("loaded", "draught"), ("ballast", "ballast_draught")]
)
def test_a_ship_that_draws_all_of_the_water_is_aground(condition: str, key: str) -> None:
    """It draws 12.4 m."""
    ship = dataclasses.replace(LOADED, condition=condition)
    for low in (12.4, 12.41):
        place = dataclasses.replace(deep(), levels=WaterLevels(low, 22.0))
        if low == SHIP.draught:
            found = told(lambda place=place: ship_s(ships=(ship,), environment=place))  # type: ignore[misc]
            assert list(found) == [key]
        else:
            assert ship_s(ships=(ship,), environment=place).environment is place


@pytest.mark.parametrize(
    ("deadweight", "allowed"), [(0.0, "must be above 0 kg"), (-1.0, "must be above 0 kg")]
)
def test_a_deadweight_is_above_nothing(deadweight: float, allowed: str) -> None:
    found = told(lambda: dataclasses.replace(LOADED, deadweight=deadweight))
    assert found == {"deadweight": allowed}


def test_a_deadweight_of_a_few_grams_is_held_against_the_displacement() -> None:
    """0.80 x 0.97 x 234 x 31.3 x 12.4 x 1.025 = 72,238.3 t."""
    found = told(lambda: dataclasses.replace(LOADED, deadweight=0.05))
    assert found["deadweight"].endswith("what a ship of these dimensions displaces, 72238.3 t")
    assert found["deadweight"].startswith("below 0.4 of")


@pytest.mark.parametrize("height", [0.0, 0.05, 100.0])
def test_a_fairlead_is_taken_at_its_bounds(height: float) -> None:
    assert dataclasses.replace(LOADED, fairlead=height).fairlead == height


@pytest.mark.parametrize("height", [-0.01, 100.1])
def test_a_fairlead_is_refused_beyond_its_bounds(height: float) -> None:
    assert list(told(lambda: dataclasses.replace(LOADED, fairlead=height))) == ["fairlead"]


@pytest.mark.parametrize(
    ("changes", "key", "allowed"),
    [
        ({"components": ()}, "components", "one family with its grade is required, or several"),
        ({"diameter_min": 0.0}, "diameter_min", "must be above 0 m"),
        ({"diameter_min": 0.05, "diameter_max": 0.04}, "diameter_max", "below diameter_min, 50 mm"),
        ({"length_step": 0.0}, "length_step", "must be above 0 m"),
        ({"max_swing": 0.0}, "max_swing", "must be above 0 m"),
        ({"swing_price": -1.0, "prefer": "cheapest"}, "swing_price", "must be 0 USD/m or more"),
        ({"life": -1.0}, "life", "must be 0 s or more"),
        ({"life": 100.1 * YEAR}, "life", "must be 100 years or less"),
        ({"wear_rate": -1e-12}, "wear_rate", "must be 0 m/s or more"),
        ({"wear_rate": 10.1e-3 / YEAR}, "wear_rate", "must be 10 mm/year or less"),
        ({"dynamic_factor": 0.99}, "dynamic_factor", "must be 1 or more"),
        ({"dynamic_factor": 10.1}, "dynamic_factor", "must be 10 or less"),
        ({"scope": (-0.1, 3.0)}, "scope_min", "must be 0 or more"),
        ({"scope": (20.1, math.inf)}, "scope_min", "must be 20 or less"),
        ({"scope": (0.0, 0.0)}, "scope_max", "must be above 0"),
        ({"scope": (2.0, 20.1)}, "scope_max", "must be 20 or less"),
        ({"scope": (3.0, 2.0)}, "scope_max", "below scope_min, 3"),
        ({"scope": (2.0, math.nan)}, "scope_max", "a number is required"),
        (
            {"prefer": "knee"},
            "prefer",
            "one of practice, shortest, cheapest, lightest, balanced, least-swing",
        ),
    ],
)
def test_a_line_is_refused_beyond_its_bounds(
    changes: dict[str, Any], key: str, allowed: str
) -> None:
    assert told(lambda: dataclasses.replace(line(), **changes)) == {key: allowed}


@pytest.mark.parametrize(
    "changes",
    [
        {"diameter_min": 0.05, "diameter_max": 0.05},
        {"length_step": 0.05},
        {"max_swing": 0.05},
        {"swing_price": 0.05, "prefer": "cheapest"},
        {"life": 0.0, "wear_rate": 0.0},
        {"life": 100.0 * YEAR, "wear_rate": 10e-3 / YEAR},
        {"dynamic_factor": 1.0},
        {"dynamic_factor": 10.0},
        {"scope": (0.0, 0.05)},
        {"scope": (20.0, 20.0)},
    ],
)
def test_a_line_is_taken_at_its_bounds(changes: dict[str, Any]) -> None:
    made = line(**changes)
    for key, value in changes.items():
        assert getattr(made, key) == value


def test_what_is_wrong_with_a_life_is_told_in_years_and_with_a_wear_in_mm() -> None:
    with pytest.raises(InputError) as caught:
        line(life=120.0 * YEAR, wear_rate=12e-3 / YEAR)
    found = {each.key: each.found for each in caught.value.problems}
    assert found == {"life": "120 years", "wear_rate": "12 mm/year"}


def test_a_line_that_no_time_or_no_wear_thins_stays_as_new() -> None:
    """5 years of 0.4 mm are 2 mm."""
    assert line(life=0.0).service is None
    assert line(wear_rate=0.0).service is None
    service = line(life=5.0 * YEAR, wear_rate=0.4e-3 / YEAR).service
    assert service is not None
    assert service.diameter_loss() == pytest.approx(2e-3, rel=1e-12)
    slow = line(life=0.05, wear_rate=1e-12).service
    assert slow is not None


@pytest.mark.parametrize(
    ("height", "step"),
    [
        *((6.25, 0.25), (6.26, 0.5), (12.5, 0.5), (12.6, 1.0), (25.0, 1.0), (25.1, 2.5)),
        *((62.5, 2.5), (62.6, 5.0), (125.0, 5.0), (126.0, 10.0), (250.0, 10.0), (1000.0, 10.0)),
    ],
)
def test_the_step_of_length_is_a_round_one_of_a_25th_of_the_height_or_more(
    height: float, step: float
) -> None:
    """docs/sizing.md, length_step; 10 m are the largest."""
    assert round_step(height) == step
    assert step >= height / 25.0 or step == 10.0


def test_lengths_begin_above_the_height_and_end_at_twelve_of_it() -> None:
    """A line as long as the height hangs straight down: it is never one of them."""
    assert line().segment(12.0).lengths == tuple(12.0 + 0.5 * k for k in range(1, 265))
    assert line().segment(24.2).lengths == tuple(float(k) for k in range(25, 292))  # 290.4 m
    stepped = line(length_step=13.75)
    assert stepped.segment(24.0).lengths == tuple(13.75 * k for k in range(2, 22))  # 288 m
    assert stepped.segment(24.0, longest=400.0).lengths[-1] == 412.5
    assert stepped.segment(24.0, longest=100.0).lengths[-1] == 288.75
    assert line(length_step=500.0).segment(24.0).lengths == (500.0,)


@pytest.mark.parametrize(
    ("scope", "first", "last"),
    [
        ((2.0, 3.0), 24.0, 36.0),
        ((2.02, 2.98), 24.5, 35.5),  # 24.24 and 35.76 m, to steps of 0.5 m within
        ((0.0, 3.0), 12.5, 36.0),  # above the height
        ((0.5, 3.0), 12.5, 36.0),
        ((2.0, math.inf), 24.0, 144.0),
        ((0.0, 0.9), 12.5, 12.5),  # one length is always left, above the height
    ],
)
def test_a_scope_bounds_the_lengths_in_depths(
    scope: tuple[float, float], first: float, last: float
) -> None:
    """Of 12 m of water, and a height of 12 m: the steps are of 0.5 m."""
    lengths = line(scope=scope).segment(12.0, depth=12.0).lengths
    assert (lengths[0], lengths[-1]) == (first, last)
    assert len(lengths) == 1 + round((last - first) / 0.5)


def test_sizes_within_the_bounds_are_taken_with_the_bounds() -> None:
    metres = sold(line(diameter_min=0.06, diameter_max=0.07), 1025.0)
    sizes = [each.nominal_diameter or 0.0 for each in metres]
    assert (min(sizes), max(sizes)) == (0.06, 0.07)
    assert {each.length for each in metres} == {1.0}
    found = told(lambda: sold(line(diameter_min=0.5, diameter_max=0.6), 1025.0))
    assert found == {"components": "no size of it is sold from 500 to 600 mm"}
    assert min(each.nominal_diameter or 0.0 for each in sold(line(), 1025.0)) < 0.05


def test_no_line_hangs_over_a_height_at_which_its_own_weight_breaks_it() -> None:
    """Of h > 2 MBL/w: s^2 = 2 h MBL/w - h^2 is below 0, and only the 30 m on the bed are left."""
    one = line(diameters=(0.06,))
    strongest = max((each.MBL or 0.0) / each.submerged_weight for each in sold(one, 1025.0))
    assert longest_useful(one, 1025.0, 2.01 * strongest) == 30.0
    assert longest_useful(one, 1025.0, 1.99 * strongest) > 130.0


def test_a_buoy_is_sized_in_as_much_water_as_calmar_holds_for() -> None:
    """It states 200 m; of a buoy whose force is given nothing is computed by it."""
    body = buoy("mooring buoy 5.0 m")
    for high, is_deep in ((200.0, False), (200.1, True)):
        place = Environment(WaterLevels.steady(high))
        assert BuoyRequest(GivenBuoy(1e3, 1e4), place).environment is place
        if is_deep:
            found = told(lambda place=place: BuoyRequest(body, place))  # type: ignore[misc]
            assert found == {"levels.high": "CALMAR applies down to 200 m of water"}
        else:
            assert BuoyRequest(body, place).environment is place


@pytest.mark.parametrize(
    ("scope", "allowed"), [(0.0, "must be above 0"), (20.1, "must be 20 or less")]
)
def test_the_length_of_practice_is_of_some_depths(scope: float, allowed: str) -> None:
    request = BuoyRequest(GivenBuoy(1e3, 1e4), Environment(WaterLevels.steady(12.0)))
    assert told(lambda: dataclasses.replace(request, scope=scope)) == {"scope": allowed}


@pytest.mark.parametrize(("body", "key"), [(10.0, "keel_depth"), (12.0, "keel_depth")])
def test_a_buoy_that_draws_all_of_the_water_touches_the_bed(body: float, key: str) -> None:
    place = Environment(WaterLevels(10.0, 12.0))
    assert list(told(lambda: BuoyRequest(GivenBuoy(1e3, 1e4, body), place))) == [key]
    assert BuoyRequest(GivenBuoy(1e3, 1e4, 9.99), place).keel_depth(0.0) == 9.99


def test_the_bounds_of_a_buoy_that_is_given_by_its_force() -> None:
    assert GivenBuoy(0.05, 0.05) == GivenBuoy(0.05, 0.05, 0.0)
    bad = told(lambda: GivenBuoy(0.0, 0.0, -0.01))
    assert bad == {
        "horizontal_force": "must be above 0 N",
        "reserve_buoyancy": "must be above 0 N",
        "keel_depth": "must be 0 m or more",
    }


@pytest.mark.parametrize("what", ["wind", "current", "sea"])
def test_anything_that_pushes_is_enough(what: str) -> None:
    levels = WaterLevels(10.0, 12.0)
    calm = Environment(levels, Wind(0.0), SurfaceCurrent(0.0), SeaState(5.0, 0.0))
    pushes = {"wind": Wind(0.05), "current": SurfaceCurrent(0.05), "sea": SeaState(5.0, 0.05)}
    pushed = dataclasses.replace(calm, **{what: pushes[what]})  # type: ignore[arg-type]
    assert calm.is_calm
    assert not pushed.is_calm
    assert list(told(lambda: BuoyRequest(buoy("pillar 1.8 m"), calm))) == ["wind"]
    assert BuoyRequest(buoy("pillar 1.8 m"), pushed).environment is pushed
    assert BuoyRequest(GivenBuoy(1e3, 1e4), calm).environment is calm  # its force is known


@pytest.mark.parametrize(
    ("height", "period"), [(0.0, 1.0), (0.05, 1.0), (0.25, 1.8), (2.25, 5.4), (2.0, 5.1)]
)
def test_the_period_of_a_growing_sea(height: float, period: float) -> None:
    """3.6 sqrt(Hs) to a tenth, 1 s at least; 3.6 sqrt(2) = 5.09."""
    assert usual_period(height) == pytest.approx(period, rel=1e-12)


def test_the_crest_is_half_of_the_largest_wave() -> None:
    """Hmax = 1.85 Hs. In 2 m of water it breaks at H = 0.78 (2 + H/2), or 1.56/0.61 m."""
    sea = SeaState(8.0, 2.0)
    assert Environment(WaterLevels(10.0, 12.0), sea=sea).crest == pytest.approx(1.85, rel=1e-12)
    assert Environment(WaterLevels(1.0, 2.0), sea=sea).crest == pytest.approx(
        0.5 * 1.56 / 0.61, rel=1e-12
    )


@pytest.mark.parametrize("time", [1.0, 3600.0])
def test_a_wind_is_converted_up_to_the_bounds_of_its_mean(time: float) -> None:
    assert mean_over(20.0, time, time) == 20.0
    for beyond in (0.99, 3601.0):
        assert list(told(lambda beyond=beyond: mean_over(20.0, beyond, 30.0))) == ["given"]  # type: ignore[misc]
        assert list(told(lambda beyond=beyond: mean_over(20.0, 30.0, beyond))) == ["wanted"]  # type: ignore[misc]


@pytest.mark.parametrize(
    ("step", "turns"),
    [
        (180.0, (10.0, -170.0)),
        (90.0, (10.0, 100.0, -170.0, -80.0)),
        (100.0, (10.0, 110.0, -150.0, -50.0)),  # 310 deg; 410 would be 50 again
        (175.0, (10.0, -175.0, 0.0)),
    ],
)
def test_the_current_is_turned_right_round_once(step: float, turns: tuple[float, ...]) -> None:
    start = Headings(wind=0.1, current=math.radians(10.0), waves=0.2)
    found = current_headings(start, math.radians(step))
    assert [math.degrees(each.current) for each in found] == pytest.approx(turns, abs=1e-9)
    assert {(each.wind, each.waves) for each in found} == {(0.1, 0.2)}


def test_the_steps_of_a_turn_are_of_1_to_180_deg() -> None:
    start = Headings()
    assert len(current_headings(start, math.radians(1.0))) == 360
    assert current_headings(start, math.inf) == (start,)
    for degrees in (0.99, 180.1):
        found = told(lambda degrees=degrees: current_headings(start, math.radians(degrees)))  # type: ignore[misc]
        assert found == {"scan": "a step of 1 to 180 deg is required"}


def test_the_lower_figure_of_a_surface_is_taken() -> None:
    """NAVFAC DM 7.02: formed concrete 0.30 to 0.40 on fine to medium sand, steel 0.30."""
    soil = "clean fine to medium sand"
    assert SinkerGround(soil, material="steel").mu == 0.30
    assert SinkerGround(soil).mu == 0.30


def test_an_anchor_whose_figures_are_all_recalled_is_taken_only_where_that_is_allowed() -> None:
    """NAVMOOR's of UFC were read in no document (R)."""
    with pytest.raises(InputError, match="recalled"):
        DragGround("NAVMOOR", "sand")
    assert (
        DragGround("NAVMOOR", "sand", allow_recalled=True).sized(1e5).capacity.curve.source.recalled
    )


def test_a_line_that_is_not_there_has_no_swing_no_mass_and_no_price() -> None:
    none = Alternative("balanced", None, reason="too short")
    assert (none.swing, none.mass, none.cost) == (None, None, None)


def test_the_factor_on_a_drag_anchor_is_1_at_least() -> None:
    assert DragGround(safety_factor=1.0).sized(1e5).safety_factor == 1.0
    assert told(lambda: DragGround(safety_factor=0.99)) == {"safety_factor": "must be 1 or more"}


def test_no_ship_a_condition_that_is_none_and_half_a_line_are_refused() -> None:
    """Each was a fault of Python's own before, not a refusal."""
    assert told(lambda: TankerRequest((), deep())) == {
        "ships": "the ship in one condition at least is required"
    }
    assert told(lambda: dataclasses.replace(LOADED, condition="half")).keys() == {"condition"}
    for lines in (0, 2, 3.0, 3.5, 25):
        asked: Any = lines
        assert told(partial(TankerRequest, (LOADED,), deep(), lines=asked)).keys() == {"lines"}


def test_a_ship_draws_no_more_in_ballast_than_loaded() -> None:
    sizes: dict[str, Any] = {"length": 200.0, "breadth": 32.0, "draught": 12.0, "depth": 20.0}
    found = told(lambda: size_tanker(**sizes, ballast_draught=12.5))
    assert found == {"ballast_draught": "not above the loaded draught, 12 m"}
