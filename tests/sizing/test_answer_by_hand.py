"""Every figure of an answer, from the recommended line solved again in each load case."""

from __future__ import annotations

import dataclasses
import math
from types import SimpleNamespace

import pytest

import catopt
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import NoAnswerError
from catopt.loads import WaterLevels, buoy, buoy_loads, estimated_tanker
from catopt.sizing import (
    BuoyRequest,
    GivenBuoy,
    LineChoice,
    MooredShip,
    SinkerGround,
    Sizing,
    TankerRequest,
    size_buoy,
    size_tanker,
)
from catopt.sizing.converge import Assumed
from catopt.sizing.kinds import usual
from tests.sizing.test_consistency import LOADED, deep, place

SOLVED = 1e-9
STRENGTH, DRAG = 5.0, 2.0
"""On the breaking load by "break/5"; on a drag anchor by UFC's table 3-7."""
MOTION = 1.2
"""An allowance for motion that is given; "break/5" has none of its own."""
LINE = LineChoice(
    usual("chain", "tanker"), "break/5", diameters=(0.06, 0.064), length_step=27.5, life=0.0
)


@pytest.fixture(scope="module")
def ship() -> Sizing:
    return size_tanker(TankerRequest((LOADED,), deep(), line=LINE))


def solved(of: Sizing) -> dict[str, catopt.Solution]:
    """Hang the line at the height and under the force of each load case."""
    return {
        each.name: catopt.solve(
            of.point.line,
            height=of.case.fairlead_height + each.water_level + each.fairlead_rise,
            horizontal_force=each.horizontal_force,
        )
        for each in of.case.load_cases
    }


def test_the_tensions_and_what_is_made_of_them(ship: Sizing) -> None:
    """Nothing wears off: R3 of d mm breaks at 22.3 d^2 (44 - 0.08 d) N, proof 14.8 (IACS)."""
    lines = solved(ship)
    tensions = {name: each.fairlead.tension for name, each in lines.items()}
    tension = max(tensions.values())
    d = 1e3 * (ship.point.line.segments[0].nominal_diameter or 0.0)
    MBL, proof = 22.3 * d * d * (44.0 - 0.08 * d), 14.8 * d * d * (44.0 - 0.08 * d)
    assert ship.largest_tension == pytest.approx(tension, rel=SOLVED)
    assert ship.hardest[0] == "loaded, low water" == max(tensions, key=tensions.__getitem__)
    assert ship.break_factor == pytest.approx(MBL / tension, rel=1e-6)
    assert ship.proof_factor == pytest.approx(proof / tension, rel=1e-6)
    used = {each.utilisation for each in ship.point.checks.results if each.kind == "tension"}
    assert max(each or 0.0 for each in used) == pytest.approx(STRENGTH * tension / MBL, rel=1e-6)
    assert ship.dynamic_factor == 1.0
    assert ship.motion.startswith("break/5: the article sizes by steady forces")
    assert ship.shots == pytest.approx(ship.point.line.length / 27.5, rel=1e-12)


def test_the_ways_of_the_line(ship: Sizing) -> None:
    """She is 234 m long and swings at low water; her excursion is from the everyday place."""
    spans = {name: each.span for name, each in solved(ship).items()}
    assert ship.swing.total == pytest.approx(spans["loaded, low water"] + 234.0, rel=SOLVED)
    farthest = max(spans.values())
    assert ship.excursion == pytest.approx(farthest - spans["everyday"], rel=1e-7)
    assert ship.point.objectives["offset_m"] == pytest.approx(farthest, rel=SOLVED)


def test_the_load_cases(ship: Sizing) -> None:
    """The fairlead is 3.6 m above water of 22 and of 20 m; an everyday force is a tenth."""
    forces = {each.name: each.horizontal_force for each in ship.case.load_cases}
    loads = {each.load_case: each.horizontal_force for each in ship.settled.posed.loads}
    assert forces == {**loads, "everyday": pytest.approx(0.1 * max(loads.values()), rel=1e-12)}
    heights = {name: each.fairlead_height for name, each in ship.point.checks.solutions}
    assert heights == pytest.approx(
        {"loaded, high water": 25.6, "loaded, low water": 23.6, "everyday": 25.6}, rel=1e-12
    )
    # No buoy: no chain is in its water, and nothing is pulled under; the loads are the ship's.
    assert ship.settled.needed == Assumed(0.0, 0.0, ())
    assert "The excursion is measured from 10 % of the largest force" in ship.assumptions[-1]


def test_the_anchor_holds_the_largest_pull(ship: Sizing) -> None:
    pulls = [each.anchor.horizontal_force for each in solved(ship).values()]
    anchor = ship.drag_anchor
    assert anchor is not None
    assert anchor.horizontal_force == pytest.approx(max(pulls), rel=1e-12)
    assert max(pulls) > 1.001 * sorted(pulls)[-2]
    capacity = anchor.capacity.capacity
    used = [each.utilisation or 0.0 for each in ship.point.checks.results if each.kind == "holding"]
    assert max(used) == pytest.approx(DRAG * max(pulls) / capacity, rel=1e-12)
    assert ship.warnings[-1].startswith("Holding capacity after")


@pytest.fixture(scope="module")
def moving() -> Sizing:
    line = dataclasses.replace(LINE, dynamic_factor=MOTION)
    return size_tanker(TankerRequest((LOADED,), deep(), line=line))


def test_the_allowance_for_motion_is_in_the_force_of_every_load_case(moving: Sizing) -> None:
    """Hung by hand under 1.2 times the loads the line keeps what its code asks for."""
    loads = {each.load_case: each.horizontal_force for each in moving.settled.posed.loads}
    forces = {each.name: each.horizontal_force for each in moving.case.load_cases}
    wanted = {name: MOTION * force for name, force in loads.items()}
    assert forces == pytest.approx(wanted | {"everyday": 0.12 * max(loads.values())}, rel=1e-12)
    lines = solved(moving).values()
    MBL = moving.point.line.segments[0].MBL
    assert MBL is not None
    assert max(each.anchor.angle for each in lines) == 0.0
    assert max(each.fairlead.tension for each in lines) <= MBL / STRENGTH
    assert moving.drag_anchor is not None
    assert DRAG * MOTION * max(loads.values()) <= moving.drag_anchor.capacity.capacity
    assert (moving.dynamic_factor, moving.motion) == (MOTION, "given")


def test_the_line_for_steady_forces_does_not_hold_those_with_an_allowance(
    ship: Sizing, moving: Sizing
) -> None:
    """Under 1.2 times the force it no longer lies on the bed, and its anchor may not hold."""
    states = [
        dataclasses.replace(each, horizontal_force=MOTION * each.horizontal_force)
        for each in ship.case.load_cases
    ]
    failed = catopt.check_case(dataclasses.replace(ship.case, load_cases=tuple(states))).failed
    assert ship.drag_anchor is not None
    pull = max(each.horizontal_force for each in states)
    is_held = DRAG * pull <= ship.drag_anchor.capacity.capacity
    assert {each.kind for each in failed} == {"uplift_angle", *(() if is_held else ("holding",))}
    assert (moving.point.line.mass or 0.0) > (ship.point.line.mass or 0.0)


def test_the_longer_of_two_ships_swings_farther() -> None:
    """One request may have two ships, and the longer of them is in no condition to be left out."""
    short = estimated_tanker("tanker", 150.0, 25.0, 8.0, moulded_depth=12.0)
    both = (LOADED, MooredShip("ballast", short, "tanker ballast", 4.0))
    assert TankerRequest(both, deep()).longest == 234.0
    assert TankerRequest(both[::-1], deep()).longest == 234.0
    body = buoy("mooring buoy 5.0 m")
    assert TankerRequest(both, deep(), buoy=body, hawser=40.0).beyond_the_line == 274.0


def test_a_clump_weight_may_hang_at_round_places_in_heights_of_the_line() -> None:
    """25.6 m x 0.25, 0.5, 1, 1.5, 2 and 3, to the metre; of concrete, from light to heavy."""
    weighted = size_tanker(
        TankerRequest((LOADED,), deep(), line=LINE, clump_masses=(10e3, 5e3), clump_density=2300.0)
    )
    assert weighted.case.design is not None
    (choice,) = weighted.case.design.clump_weights
    assert choice.positions == (6.0, 13.0, 26.0, 38.0, 51.0, 77.0)
    assert (choice.masses, choice.density) == ((5e3, 10e3), 2300.0)
    assert {each.mass for each in weighted.point.line.point_loads} <= {5e3, 10e3}


def test_a_shallow_place_has_a_clump_weight_a_metre_from_the_anchor_at_least() -> None:
    """0.25 x 1.9 m would be none."""
    barge = estimated_tanker("barge", 30.0, 6.0, 1.0, moulded_depth=1.2)
    shallow = dataclasses.replace(deep(), levels=WaterLevels(1.7, 1.7))
    line = dataclasses.replace(LINE, length_step=5.0)
    light = TankerRequest(
        (MooredShip("loaded", barge, "tanker loaded", 0.2),), shallow, line=line,
        clump_masses=(500.0,),
    )  # fmt: skip
    design = size_tanker(light).case.design
    assert design is not None
    assert design.clump_weights[0].positions == (
        1.0,
        2.0,
        3.0,
        4.0,
        6.0,
    )  # of 0.475, 0.95, 1.9, 2.85, 3.8, 5.7


@pytest.fixture(scope="module")
def on_a_sinker() -> Sizing:
    return size_tanker(
        TankerRequest((LOADED,), deep(), line=LINE, ground=SinkerGround("clean sound rock"))
    )


def test_a_ship_s_sinker_holds_the_largest_pull_of_all_load_cases(on_a_sinker: Sizing) -> None:
    """Mu = 0.55: (1.5 H/0.55 + V)/(g (1 - 1025/2400)) is needed, of the largest H and V upwards."""
    ends = [each.anchor for each in solved(on_a_sinker).values()]
    H = max(each.horizontal_force for each in ends)
    V = max(0.0, *(each.vertical_force for each in ends))
    sinker = on_a_sinker.sinker
    assert sinker is not None
    assert sinker.horizontal_force == pytest.approx(H, rel=SOLVED)
    assert sinker.vertical_force == pytest.approx(V, rel=1e-6, abs=1e-6)
    needed = (1.5 * H / 0.55 + V) / (STANDARD_GRAVITY * (1.0 - 1025.0 / 2400.0))
    assert sinker.needed_mass == pytest.approx(needed, rel=1e-6)
    assert on_a_sinker.drag_anchor is None
    assert not any("Holding capacity" in each for each in on_a_sinker.warnings)


@pytest.fixture(scope="module")
def on_a_buoy() -> Sizing:
    """By "break/5" the sinker may be lifted: the lightest line is a short one."""
    line = LineChoice(usual("chain"), "break/5", diameters=(0.035,), life=0.0)
    return size_buoy(BuoyRequest(GivenBuoy(10e3, 60e3, 1.2), place(), line))


def test_a_buoy_s_load_cases(on_a_buoy: Sizing) -> None:
    """12 m and half of 1.85 x 1.2 m; 10 m; the chain is made fast 1.2 m below the water."""
    heights = {name: each.fairlead_height for name, each in on_a_buoy.point.checks.solutions}
    assert heights == pytest.approx(
        {"storm, high water": 12.0 + 1.11 - 1.2, "storm, low water": 10.0 - 1.2}, rel=1e-12
    )
    assert {each.horizontal_force for each in on_a_buoy.case.load_cases} == {10e3}
    assert {each.kind for each in on_a_buoy.case.load_cases} == {"extreme"}
    assert on_a_buoy.case.design is not None
    lengths = on_a_buoy.case.design.segments[0].lengths
    assert lengths[:2] == (12.0, 12.5)  # above 11.91 m, in steps of a 25th of it or more
    assert lengths[-1] == 143.0  # 12 x 11.91 m = 142.92 m


def test_a_buoy_s_line_and_sinker_by_hand(on_a_buoy: Sizing) -> None:
    lines = solved(on_a_buoy)
    ends = [each.anchor for each in lines.values()]
    H = max(each.horizontal_force for each in ends)
    V = max(0.0, *(each.vertical_force for each in ends))
    assert V > 1.1 * min(each.vertical_force for each in ends) > 0.0
    sinker = on_a_buoy.sinker
    assert sinker is not None
    assert (sinker.horizontal_force, sinker.vertical_force) == pytest.approx((H, V), rel=1e-7)
    # IALA's friction, 1.0; the next size is cast.
    needed = (1.5 * H / 1.0 + V) / (STANDARD_GRAVITY * (1.0 - 1025.0 / 2400.0))
    assert sinker.needed_mass == pytest.approx(needed, rel=1e-7)
    assert on_a_buoy.swing.total == pytest.approx(lines["storm, low water"].span, rel=SOLVED)
    assert on_a_buoy.largest_tension == pytest.approx(
        max(each.fairlead.tension for each in lines.values()), rel=SOLVED
    )
    assert on_a_buoy.excursion is None
    assert on_a_buoy.reserve_buoyancy == 60e3


def test_what_a_line_was_sized_for_is_its_own_pull_rounded_up(on_a_buoy: Sizing) -> None:
    """To two digits; never more than the buoy has."""
    pull = max(each.fairlead.vertical_force for each in solved(on_a_buoy).values())
    unit = 10.0 ** (math.floor(math.log10(pull)) - 1)
    assert on_a_buoy.settled.needed.pull == pytest.approx(unit * math.ceil(pull / unit), rel=1e-12)
    assert on_a_buoy.settled.needed.diameter == 0.035
    assert on_a_buoy.settled.assumed.covers(on_a_buoy.settled.needed)


def test_a_buoy_that_is_pulled_to_its_mark_is_sized_for_no_more_than_it_has() -> None:
    """28.1 kN would be 29 kN in two digits: the reserve is 28.2 kN."""
    line = LineChoice(usual("chain"), "break/5", diameters=(0.035,), life=0.0)
    free = size_buoy(BuoyRequest(GivenBuoy(10e3, 60e3), place(), line))
    pull = max(each.fairlead.vertical_force for each in solved(free).values())
    reserve = 1.002 * pull
    bound = size_buoy(BuoyRequest(GivenBuoy(10e3, reserve), place(), line))
    assert bound.point.line == free.point.line
    assert free.settled.needed.pull > reserve
    assert bound.settled.needed.pull == reserve


@pytest.fixture(scope="module")
def pillar() -> Sizing:
    """By IALA the line is tangent at the sinker: nothing lifts it."""
    line = LineChoice(usual("chain"), "IALA-CALMAR", diameters=(0.038,), length_step=2.5, life=0.0)
    return size_buoy(BuoyRequest(buoy("pillar 2.4 m"), place(), line))


def test_the_sinker_of_a_buoy_holds_the_harder_of_its_two_storms(pillar: Sizing) -> None:
    forces = [each.horizontal_force for each in pillar.settled.posed.loads]
    assert max(forces) > 1.001 * min(forces)
    assert pillar.sinker is not None
    assert pillar.sinker.horizontal_force == pytest.approx(max(forces), rel=1e-12)
    assert pillar.sinker.vertical_force == pytest.approx(0.0, abs=1e-6)
    needed = 1.5 * max(forces) / 1.0 / (STANDARD_GRAVITY * (1.0 - 1025.0 / 2400.0))
    assert pillar.sinker.needed_mass == pytest.approx(needed, rel=1e-6)


def test_a_buoy_s_chain_is_made_fast_where_its_pull_takes_it(pillar: Sizing) -> None:
    """2000 kg on 2.4 m with a tail tube of 0.4 x 1.5 m, as on docs/sizing.md."""
    assumed = pillar.settled.assumed
    tube = math.pi * 0.4**2 / 4.0 * 1.5
    volume = (2000.0 + assumed.pull / STANDARD_GRAVITY) / 1025.0
    keel = (volume - tube) / (math.pi * 2.4**2 / 4.0) + 1.5
    heights = {name: each.fairlead_height for name, each in pillar.point.checks.solutions}
    assert heights == pytest.approx(
        {"storm, high water": 12.0 + 1.11 - keel, "storm, low water": 10.0 - keel}, rel=1e-12
    )
    assert f"The chain is attached {keel:.3g} m below the water." in pillar.assumptions[0]
    loads = "The loads are those on a chain of 38 mm under a pull of "
    assert pillar.assumptions[1].startswith(f"{loads}{assumed.pull / 1e3:.3g} kN")


def test_a_buoy_s_loads_are_those_on_the_assumed_chain_and_nothing_else(pillar: Sizing) -> None:
    env, assumed = place(), pillar.settled.assumed
    levels = (env.levels, WaterLevels.steady(env.levels.low))
    for at, water in zip(pillar.settled.posed.loads, levels, strict=True):
        anew = buoy_loads(
            buoy("pillar 2.4 m"), env.wind, env.current, env.sea, water,
            chain_diameter=assumed.diameter, pull=assumed.pull,
        )  # fmt: skip
        assert at.horizontal_force == pytest.approx(anew.horizontal_force, rel=1e-12)
        assert at.given == 0.0
    given = size_buoy(
        BuoyRequest(
            GivenBuoy(4e3, 60e3), env, LineChoice(usual("chain"), "break/5", diameters=(0.035,))
        )
    )
    assert {each.horizontal_force for each in given.settled.posed.loads} == {4e3}


def test_a_ship_s_buoy_is_computed_for_the_line_s_own_pull_rounded_up() -> None:
    """To two digits; the buoy could carry more."""
    body = buoy("mooring buoy 5.0 m")
    of = size_tanker(TankerRequest((LOADED,), deep(), line=LINE, buoy=body, hawser=0.05))
    assert [length for _, length in of.swing.parts][1:] == [0.05, 234.0]
    pull = max(each.fairlead.vertical_force for each in solved(of).values())
    unit = 10.0 ** (math.floor(math.log10(pull)) - 1)
    assert of.settled.needed.pull == pytest.approx(unit * math.ceil(pull / unit), rel=1e-12)
    assert of.settled.needed.pull < body.reserve_buoyancy()
    assert of.settled.needed.diameter == of.point.line.segments[0].nominal_diameter
    assert of.settled.needed.forces == ()


def test_a_smaller_size_that_was_looked_at_is_not_told_to_be_left_out() -> None:
    """The next smaller size is the bound: it was looked at, and does not pass."""
    free = dataclasses.replace(
        LINE, diameters=(), diameter_min=0.04, diameter_max=0.08, prefer="lightest"
    )
    best = size_tanker(TankerRequest((LOADED,), deep(), line=free))
    smaller = best.candidates[0]
    assert smaller.role == "smaller"
    bound = dataclasses.replace(free, diameter_min=smaller.diameter)
    again = size_tanker(TankerRequest((LOADED,), deep(), line=bound))
    assert again.point.line == best.point.line
    assert again.why == best.why == "It is the lightest line that passes."


def test_a_buoy_with_lines_that_pull_too_much_is_tried_with_less_for_each(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """All pull 400 kN, of which one has 100: within R kN one may have 0.98 x 100 R/400.

    R = g (1025 pi 5^2/4 (2.8 - 0.5) - 16000) = 297.04 kN. After 8 tries it is refused, and told
    that 400 - 297.04 = 103 kN are too many.
    """
    tried: list[float | None] = []

    def within(_request: object, allowed: float | None, _start: object) -> SimpleNamespace:
        tried.append(allowed)
        return SimpleNamespace(point="a line", posed="its loads")

    home = "catopt.sizing.tanker."
    monkeypatch.setattr(home + "_settled_within", within)
    monkeypatch.setattr(home + "_pattern", lambda *_: SimpleNamespace(largest_pull=400e3))
    monkeypatch.setattr(home + "point_pull", lambda _: 100e3)
    request = TankerRequest((LOADED,), deep(), buoy=buoy("mooring buoy 5.0 m"), lines=4)
    with pytest.raises(NoAnswerError, match="the 4 lines pull the buoy down by 400 kN") as caught:
        size_tanker(request)
    reserve = STANDARD_GRAVITY * (1025.0 * math.pi * 25.0 / 4.0 * 2.3 - 16e3)
    assert "103 kN more than its reserve buoyancy" in str(caught.value)
    less = 0.98 * 100e3 * reserve / 400e3
    assert tried == pytest.approx([reserve] + 7 * [less], rel=1e-12)


def test_a_line_of_which_no_proof_load_is_known_has_no_factor_on_it() -> None:
    """A rope has none; it breaks at its MBL, of which the factor is told."""
    line = LineChoice(("polyester",), "break/5", diameters=(0.138,), length_step=2.5, life=0.0)
    of = size_buoy(BuoyRequest(GivenBuoy(10e3, 60e3), place(), line))
    tension = max(each.fairlead.tension for each in solved(of).values())
    MBL = of.point.line.segments[0].MBL
    assert MBL is not None
    assert of.proof_factor is None
    assert of.break_factor == pytest.approx(MBL / tension, rel=1e-7)
