"""Loads and line agree, what is saved says the same, and more weather is never less chain."""

from __future__ import annotations

import dataclasses

import pytest

from catopt.casefile import parse_case, write_case
from catopt.checks.case import check_case
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.design.search import design_case
from catopt.errors import InputError, NoAnswerError
from catopt.loads import (
    SeaState,
    SurfaceCurrent,
    WaterLevels,
    Wind,
    buoy,
    buoy_loads,
    estimated_tanker,
)
from catopt.sizing import (
    BuoyRequest,
    DragGround,
    Environment,
    GivenBuoy,
    LineChoice,
    MooredShip,
    SinkerGround,
    Sizing,
    TankerRequest,
)
from catopt.sizing.converge import Assumed, rounded_up
from catopt.sizing.kinds import usual
from catopt.sizing.line_choice import PREFERENCES
from tests.sizing.alone import alone
from tests.sizing.at_rest import size_buoy, size_tanker

ROUNDING = 1e-9
SHIP = estimated_tanker("tanker", 234.0, 31.3, 12.4, moulded_depth=16.0)
UNPRICED = tuple(each for each in PREFERENCES if each != "cheapest")
"""No buoy chain has a price."""
LOADED = MooredShip("loaded", SHIP, "tanker loaded", 3.6)


def place(
    wind: float = 25.0,
    *,
    current: float = 1.0,
    hs: float = 1.2,
    low: float = 10.0,
    high: float = 12.0,
) -> Environment:
    return Environment(
        WaterLevels(low, high), Wind(wind), SurfaceCurrent(current), SeaState(6.0, hs)
    )


def chain(prefer: str = "balanced", **more: object) -> LineChoice:
    return LineChoice(usual("chain"), usual("code"), prefer=prefer, **more)  # type: ignore[arg-type]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["pillar 1.8 m", "pillar 2.4 m", "pillar 3.0 m"])
@pytest.mark.parametrize("prefer", UNPRICED)
def test_the_loads_are_those_of_a_line_no_lighter_than_the_recommended(
    name: str, prefer: str
) -> None:
    """Computed again by `buoy_loads` for what came out, they are no more than what was taken."""
    env = place()
    with alone():
        sized = size_buoy(BuoyRequest(buoy(name), env, chain(prefer)))
    diameter = sized.point.line.segments[0].nominal_diameter or 0.0
    solutions = dict(sized.point.checks.solutions)
    pull = max(each.fairlead.vertical_force for each in solutions.values())
    assumed = sized.settled.assumed
    assert diameter <= assumed.diameter * (1.0 + ROUNDING)
    assert pull <= assumed.pull * (1.0 + ROUNDING)
    low = WaterLevels.steady(env.levels.low)
    levels = {"storm, high water": env.levels, "storm, low water": low}
    for state, water in levels.items():
        anew = buoy_loads(
            buoy(name), env.wind, env.current, env.sea, water, chain_diameter=diameter, pull=pull
        )
        assert anew.horizontal_force <= solutions[state].horizontal_force * (1.0 + ROUNDING)


@pytest.mark.slow
@pytest.mark.parametrize("prefer", UNPRICED)
def test_what_is_recommended_is_where_it_is_said_to_be_on_the_front(prefer: str) -> None:
    with alone():
        sized = size_buoy(BuoyRequest(buoy("pillar 3.0 m"), place(), chain(prefer)))
    front = sized.settled.result.front
    index = sized.settled.index
    # The front rises in mass and falls in length, or in span: 2.5 depths of 13.11 m are laid.
    key = "length_m" if prefer in ("practice", "shortest") else "offset_m"
    near = [k for k, each in enumerate(front) if each.objectives[key] <= 2.5 * 13.11]
    assert 0 < len(near)
    wanted = {"balanced": near[0], "practice": near[0], "lightest": 0}
    assert index == wanted.get(prefer, len(front) - 1)
    assert sized.point.genes == front[index].genes
    assert sized.point.checks.results == front[index].checks.results


@pytest.mark.slow
def test_a_written_case_gives_the_same_front_and_the_same_checks() -> None:
    sized = size_buoy(BuoyRequest(buoy("pillar 2.4 m"), place(), title="a buoy"))
    case = parse_case(write_case(sized.case))
    result = design_case(case)
    assert [p.genes for p in result.front] == [p.genes for p in sized.settled.result.front]
    report = check_case(case)
    assert report.passes
    assert [r.demand for r in report.results] == [r.demand for r in sized.point.checks.results]
    assert case.title == "a buoy"
    kinds = {result.kind for result in report.results}
    assert kinds == {"tension", "uplift_angle", "buoyancy", "sliding"}


def test_the_sinker_is_the_one_that_sizing_it_alone_gives() -> None:
    sized = size_buoy(BuoyRequest(buoy("pillar 2.4 m"), place()))
    assert sized.sinker is not None
    assert sized.point.anchor is not None
    assert sized.point.anchor.mass == sized.sinker.mass


def lightest(request: BuoyRequest) -> Sizing:
    with alone():
        return size_buoy(dataclasses.replace(request, line=chain("lightest")))


@pytest.mark.slow
def test_more_weather_never_gives_a_lighter_chain() -> None:
    """At the light end of the front, from a breeze to a storm."""
    for change in ("wind", "current", "hs"):
        values = {"wind": (10.0, 20.0, 30.0), "current": (0.5, 1.0, 1.5), "hs": (0.4, 0.8, 1.2)}
        masses = [
            lightest(BuoyRequest(buoy("pillar 3.0 m"), place(**{change: value}))).point.objectives[
                "mass_kg"
            ]
            for value in values[change]
        ]
        assert masses == sorted(masses), (change, masses)
        assert masses[0] < masses[-1], (change, masses)


def test_deeper_water_never_gives_a_shorter_line() -> None:
    """Of one size of chain and one force, so that nothing but the depth differs."""
    one = chain(diameters=(0.035,))
    lengths = []
    for depth in (8.0, 11.0, 15.0, 20.0, 28.0, 40.0):
        env = Environment(WaterLevels.steady(depth), sea=SeaState(6.0, 1.0))
        body = GivenBuoy(10e3, 60e3)
        lengths.append(size_buoy(BuoyRequest(body, env, one)).point.line.length)
    assert lengths == sorted(lengths)
    assert lengths[0] < lengths[-1]


def test_a_larger_force_never_gives_a_lighter_sinker() -> None:
    env = place()
    masses = [
        size_buoy(BuoyRequest(GivenBuoy(force, 60e3), env, chain("lightest"))).point.anchor.mass  # type: ignore[union-attr]
        for force in (2e3, 5e3, 10e3, 20e3)
    ]
    assert masses == sorted(masses)  # type: ignore[type-var]


def test_neighbours_are_one_size_apart_and_pass_under_their_own_loads() -> None:
    sized = size_buoy(BuoyRequest(buoy("pillar 2.4 m"), place(), chain()))
    sizes = [each.diameter for each in sized.candidates]
    assert [each.role for each in sized.candidates] == ["smaller", "recommended", "larger"]
    assert sizes == sorted(set(sizes))
    for each in sized.candidates:
        assert each.settled is not None
        assert each.settled.point.checks.passes
        assert each.settled.assumed.covers(each.settled.needed)


def test_what_governs_fails_when_it_is_checked_alone() -> None:
    sized = size_buoy(BuoyRequest(buoy("pillar 2.4 m"), place()))
    assert sized.limits
    line = sized.point.line
    step = sized.case.design.segments[0].lengths  # type: ignore[union-attr]
    shorter = dataclasses.replace(line.segments[0], length=line.length - (step[1] - step[0]))
    report = check_case(dataclasses.replace(sized.case, line=type(line)([shorter])))
    assert not report.passes


def test_all_that_is_wrong_with_a_request() -> None:
    # 1300 kg on a spar of 0.8 m: it draws 1300/1025/(pi 0.8^2/4) = 2.52 m.
    with pytest.raises(InputError, match="touch the bed"):
        BuoyRequest(buoy("spar 0.8 m"), place(low=2.5))
    assert BuoyRequest(buoy("spar 0.8 m"), place(low=2.55)).environment.levels.low == 2.55
    with pytest.raises(InputError, match="a load on the buoy is required"):
        BuoyRequest(buoy("pillar 1.8 m"), place(0.0, current=0.0, hs=0.0))
    with pytest.raises(InputError) as caught:
        TankerRequest((LOADED,), place(), hawser=40.0, lines=2, pretension=2.0)
    keys = [problem.key for problem in caught.value.problems]
    assert keys == ["pretension", "lines", "hawser", "draught"]
    with pytest.raises(InputError, match="not below what a ship of these dimensions"):
        dataclasses.replace(LOADED, deadweight=90e6)


def test_a_buoy_too_small_for_any_chain() -> None:
    with pytest.raises(InputError, match="hanging straight down"):
        size_buoy(BuoyRequest(GivenBuoy(1e3, 200.0), place()))
    with pytest.raises(NoFeasibleDesignError, match="What may help: a larger buoy"):
        size_buoy(BuoyRequest(GivenBuoy(5e3, 600.0), place()))


def deep() -> Environment:
    sea = SeaState(8.0, maximum_height=3.5)
    return Environment(WaterLevels(20.0, 22.0), Wind(20.0), SurfaceCurrent(1.2), sea)


@pytest.mark.slow
@pytest.mark.parametrize("lines", [3, 4, 6, 8])
def test_a_line_of_several_is_sized_for_no_less_than_its_equilibrium(lines: int) -> None:
    with alone():
        sized = size_tanker(TankerRequest((LOADED,), deep(), lines=lines))
    assert sized.pattern is not None
    intact = [
        each
        for each in sized.case.load_cases
        if each.state == "intact" and each.condition != "worn"
    ]
    for state, case in zip(sized.pattern.states, intact, strict=True):
        assert case.name == state.load_case
        assert state.line_force <= case.horizontal_force * (1.0 + ROUNDING)
    checks = {state.load_case: state.tension for state in sized.pattern.states}
    solutions = dict(sized.point.checks.solutions)
    for name, tension in checks.items():
        assert tension <= solutions[name].fairlead.tension * (1.0 + ROUNDING)
    assert (sized.pattern.hardest.rule_force is None) == (lines == 3)


def test_the_drag_anchor_holds_the_largest_force_by_its_factor() -> None:
    sized = size_tanker(TankerRequest((LOADED,), deep()))
    forces = [state.horizontal_force for state in sized.case.load_cases]
    assert sized.drag_anchor is not None
    assert sized.drag_anchor.horizontal_force == max(forces)
    capacity = sized.drag_anchor.capacity.capacity
    assert capacity >= 2.0 * max(forces)  # UFC table 3-7
    assert sized.case.anchor is not None
    assert sized.case.anchor.holding_capacity == capacity
    assert sized.sinker is None


def test_a_sinker_holds_a_ship_by_its_weight() -> None:
    sized = size_tanker(TankerRequest((LOADED,), deep(), ground=SinkerGround()))
    assert sized.sinker is not None
    assert sized.sinker.factor is not None
    assert sized.sinker.factor >= 1.5
    assert sized.point.anchor is not None
    assert sized.point.anchor.mass == sized.sinker.mass > 60e3


def test_both_conditions_of_a_ship_count() -> None:
    light = estimated_tanker("tanker", 234.0, 31.3, 6.2, moulded_depth=16.0, condition="ballast")
    both = (LOADED, MooredShip("ballast", light, "tanker ballast", 9.8))
    sized = size_tanker(TankerRequest(both, deep()))
    heights = {n: s.fairlead_height for n, s in sized.point.checks.solutions}
    # The deck is 16 m over the keel, whatever the draught.
    assert heights["loaded, high water"] == pytest.approx(22.0 + 3.6, rel=1e-12)
    assert heights["ballast, high water"] == pytest.approx(22.0 + 9.8, rel=1e-12)
    assert heights["ballast, low water"] == pytest.approx(20.0 + 9.8, rel=1e-12)


def test_the_parts_of_a_swing_radius() -> None:
    body = buoy("mooring buoy 5.0 m")
    sized = size_tanker(TankerRequest((LOADED,), deep(), buoy=body, hawser=60.0))
    solutions = dict(sized.point.checks.solutions)
    # Worn the line is lighter, and hangs less: it spans more.
    span = solutions["loaded, low water, worn chain"].span
    assert span > solutions["loaded, low water"].span
    assert sized.swing.parts == (("line at low water", span), ("hawser", 60.0), ("ship", 234.0))
    assert sized.swing.total == pytest.approx(span + 294.0, rel=1e-12)
    assert len(sized.settled.posed.loads[0].parts) == 2  # the ship's and the buoy's


@pytest.mark.slow
def test_lines_that_pull_the_buoy_under_are_made_lighter_or_refused() -> None:
    """Six of 120 mm weigh 2.455 kN/m x 23 m x 6 = 339 kN and more; the buoy carries 297 kN."""
    body = buoy("mooring buoy 5.0 m")
    request = TankerRequest((LOADED,), deep(), buoy=body, hawser=50.0, lines=6)
    line = dataclasses.replace(request.line, prefer="shortest")
    with alone():
        sized = size_tanker(dataclasses.replace(request, line=line))
    assert sized.pattern is not None
    assert sized.pattern.largest_pull <= body.reserve_buoyancy()
    assert any("One line may use" in each for each in sized.assumptions)
    with pytest.raises(NoAnswerError):
        size_tanker(
            TankerRequest((LOADED,), deep(), buoy=buoy("mooring buoy 2.5 m"), hawser=50.0, lines=8)
        )


def test_a_clump_weight_shortens_the_line() -> None:
    plain = size_tanker(TankerRequest((LOADED,), deep()))
    weighted = size_tanker(TankerRequest((LOADED,), deep(), clump_masses=(20e3,)))
    assert weighted.point.line.point_loads[0].mass == 20e3
    assert weighted.swing.total < plain.swing.total


@pytest.mark.parametrize(
    ("value", "rounded"), [(0.0, 0.0), (4231.0, 4300.0), (4300.0, 4300.0), (99.1, 100.0)]
)
def test_rounded_up(value: float, rounded: float) -> None:
    assert rounded_up(value) == pytest.approx(rounded, rel=1e-12)


def test_what_is_assumed_is_compared_part_by_part() -> None:
    one, other = Assumed(0.02, 1e3, (5.0, 6.0)), Assumed(0.025, 900.0)
    assert not one.covers(other)
    assert not other.covers(one)
    both = one.raised_to(other)
    assert both == Assumed(0.025, 1e3, (5.0, 6.0))
    assert both.covers(one)
    assert both.covers(other)


def test_a_drag_anchor_of_an_unknown_kind() -> None:
    with pytest.raises(InputError, match="hook"):
        DragGround("hook")


def test_the_title_of_a_tanker_is_its_own_or_says_what_it_is() -> None:
    given = size_tanker(dwt="50000 t", depth="20 m", title="Berth 3")
    assert given.case.title == "Berth 3"
    assert "20 m" in size_tanker(dwt="50000 t", depth="20 m").case.title


def test_a_ship_that_just_touches_the_bed_is_aground() -> None:
    with pytest.raises(InputError, match="would be aground"):
        size_tanker(length=200.0, breadth=32.0, draught=12.0, depth=12.0)
