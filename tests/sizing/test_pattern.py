"""Several lines around a body: the rule it begins with, and every state solved by itself."""

from __future__ import annotations

import dataclasses
import functools
import itertools
import math

import pytest

import catopt
from catopt.errors import NoAnswerError
from catopt.loads import WaterLevels
from catopt.model import LoadCase
from catopt.mooring.solution import SystemSolution
from catopt.mooring.zero_load import ZeroLoadPosition, zero_load_position
from catopt.sizing import LineChoice, Sizing, TankerRequest
from catopt.sizing.kinds import usual
from catopt.sizing.pattern import AtRest, BodyState, Pattern, pattern, shared_force, system_case
from tests.sizing.alone import alone
from tests.sizing.at_rest import size_tanker
from tests.sizing.test_consistency import LOADED, deep
from tests.sizing.test_line_out import around

LINE = catopt.Line([catopt.Segment(length=300.0, submerged_weight=1000.0)])
PRETENSION, STILL = 40e3, 24.0
STATES = (BodyState("storm, high water", 450e3, 25.5), BodyState("swell, low water", 250e3, 22.0))
SOLVED = 1e-7
"""Of a force or a length: two ways to the same equilibrium end at residuals far below it."""
COUNTS = (3, 4, 5)


@pytest.mark.parametrize(
    ("lines", "share"),
    [
        (3, 1.0),  # 4/3 would be more than all of it
        (4, 1.0),
        (5, 4.0 / 5.0),
        (6, 1.0 / 1.5),
        (7, 4.0 / 7.0),
        (8, 1.0 / 2.0),
        (12, 1.0 / 3.0),
    ],
)
def test_the_sizing_begins_with_four_nths_of_the_force_and_never_with_more_than_all(
    lines: int, share: float
) -> None:
    """S4: F = FT/(N/4)."""
    assert shared_force(300e3, lines) == pytest.approx(share * 300e3, rel=1e-12)


@functools.cache
def found(lines: int) -> Pattern:
    return pattern(LINE, lines, STATES, pretension=PRETENSION, still_height=STILL)


@functools.cache
def reach() -> float:
    return catopt.solve(LINE, height=STILL, horizontal_force=PRETENSION).span


def body(lines: int, state: BodyState) -> catopt.System:
    azimuths = [2.0 * math.pi * k / lines for k in range(lines)]
    return catopt.System.around(
        LINE, azimuths=azimuths, anchor_radius=reach(), fairlead_height=state.fairlead_height
    )


def under(system: catopt.System, force: float, towards: float) -> SystemSolution:
    """Solve it under a force towards an angle from line 1, rad."""
    return catopt.solve_system(system.under((force * math.cos(towards), force * math.sin(towards))))


Solved = list[tuple[float, SystemSolution]]
"""From how far off line 1 the force comes, rad, and the equilibrium."""


@functools.cache
def by_hand(lines: int, state: BodyState, steps: int = 24) -> tuple[Solved, Solved]:
    """Solve it with all lines, and without line 1.

    Equal lines evenly spaced: with all there a force from between against a line and half way to
    the next says all, and with line 1 gone one from between against it and right behind it.
    """
    system = body(lines, state)
    sides = [math.pi / lines * k / steps for k in range(steps + 1)]
    around_ = [math.pi * k / (2 * steps) for k in range(2 * steps + 1)]
    left = system.without([0])
    return (
        [(off, under(system, state.force, math.pi + off)) for off in sides],
        [(off, under(left, state.force, math.pi + off)) for off in around_],
    )


def force_of(solution: SystemSolution) -> float:
    return max(line.horizontal_force for line in solution.lines)


def pull_of(solution: SystemSolution) -> float:
    """All lines together pull down with this."""
    return sum(line.solution.fairlead.vertical_force for line in solution.lines)


def away(solution: SystemSolution) -> float:
    """Way from the middle, where equal lines all around leave the body under no load."""
    return math.hypot(solution.position.x, solution.position.y)


def is_just_over(told: float, scanned: float) -> bool:
    """Whether a largest value is that of a scan, or what lies between two of its steps.

    By a step d the scan is short of a flat top by d^2/2 of its curvature at most: a thousandth.
    """
    return scanned * (1.0 - SOLVED) <= told <= scanned * (1.0 + 1e-3)


def is_of(told: AtRest, scan: Solved) -> bool:
    """Whether what is told of the worst directions is what a scan comes to."""
    every = [each for _, each in scan]
    return (
        is_just_over(told.line_force, max(map(force_of, every)))
        and is_just_over(told.tension, max(line.tension for each in every for line in each.lines))
        and is_just_over(told.offset, max(map(away, every)))
        and is_just_over(told.pull, max(map(pull_of, every)))
    )


@pytest.mark.parametrize("lines", COUNTS)
def test_every_state_is_the_hardest_of_all_directions(lines: int) -> None:
    for state, told in zip(STATES, found(lines).states, strict=True):
        assert (told.load_case, told.force) == (state.load_case, state.force)
        assert is_of(told, by_hand(lines, state)[0])
        again = under(body(lines, state), state.force, math.pi + told.direction)
        assert force_of(again) == pytest.approx(told.line_force, rel=SOLVED)


@pytest.mark.parametrize("lines", COUNTS)
def test_every_state_without_a_line_is_the_hardest_of_all_directions(lines: int) -> None:
    """Solved again without the line that is told, from the direction that is told."""
    for state, told in zip(STATES, found(lines).states, strict=True):
        out = told.line_out
        assert is_of(out, by_hand(lines, state)[1])
        assert 0.0 <= out.direction <= math.pi / lines
        left = body(lines, state).without([out.missing - 1])
        again = under(left, state.force, math.pi + out.direction)
        assert force_of(again) == pytest.approx(out.line_force, rel=SOLVED)
        assert max(line.tension for line in again.lines) == pytest.approx(out.tension, rel=SOLVED)


@pytest.mark.parametrize(
    ("lines", "directions"),
    [
        (3, 72),
        (6, 36),
        pytest.param(3, 720, marks=pytest.mark.slow),
        pytest.param(6, 720, marks=pytest.mark.slow),
    ],
)
def test_no_direction_with_any_line_gone_has_more_than_is_told(lines: int, directions: int) -> None:
    """Nothing of the symmetry is used: every line goes in turn, under a force from all around."""
    (state, _), (told, _) = STATES, found(lines).states
    system = body(lines, state)
    for gone in ((), *((k,) for k in range(lines))):
        of: AtRest = told.line_out if gone else told
        left = system.without(gone) if gone else system
        for k in range(directions):
            at = under(left, state.force, 2.0 * math.pi * (k + 0.25) / directions)
            assert force_of(at) <= of.line_force * (1.0 + 1e-6)
            assert away(at) <= of.offset * (1.0 + 1e-6)
            assert pull_of(at) <= of.pull * (1.0 + 1e-6)


@pytest.mark.parametrize("lines", COUNTS)
def test_the_largest_pull_is_of_any_state_with_each_line_there_or_one_gone(lines: int) -> None:
    """The buoy has to carry it."""
    pulls = {
        state.load_case: [
            max(pull_of(each) for _, each in solved) for solved in by_hand(lines, state)
        ]
        for state in STATES
    }
    assert is_just_over(found(lines).largest_pull, max(itertools.chain(*pulls.values())))
    # The two states differ, and so do all lines and one gone: no other choice is as large.
    every = sorted(itertools.chain(*pulls.values()))
    assert every[-1] > 1.01 * every[-2]


def test_the_hardest_state_has_the_largest_force_in_a_line_wherever_it_stands() -> None:
    turned = pattern(LINE, 4, STATES[::-1], pretension=PRETENSION, still_height=STILL)
    assert found(4).hardest.load_case == turned.hardest.load_case == "storm, high water"
    assert math.hypot(*turned.system.force) == pytest.approx(450e3, rel=1e-12)
    assert {leg.fairlead_height for leg in turned.system.legs} == {25.5}


def test_the_anchors_are_where_the_pretension_has_them() -> None:
    assert found(4).pretension == PRETENSION
    assert found(4).anchor_radius == pytest.approx(reach(), rel=1e-12)
    assert [leg.azimuth for leg in found(4).system.legs] == pytest.approx(
        [0.0, math.pi / 2.0, math.pi, 1.5 * math.pi], abs=1e-12
    )


def test_the_rule_is_told_where_it_is_one() -> None:
    """It wants 4 lines or more, and an even number: of 4 the most loaded has all of the force."""
    assert [each.rule_force for each in found(4).states] == pytest.approx([450e3, 250e3], rel=1e-12)
    assert {each.rule_force for lines in (3, 5) for each in found(lines).states} == {None}


def test_friction_on_the_bed_is_that_of_the_pattern() -> None:
    rough = pattern(
        LINE, 4, STATES[:1], pretension=PRETENSION, still_height=STILL, seabed_friction=1.0
    )
    assert rough.system.seabed_friction == 1.0
    assert found(4).system.seabed_friction == 0.0


def test_a_body_that_cannot_do_without_a_line_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    solved = iter((zero_load_position,))

    def once(system: catopt.System) -> ZeroLoadPosition:
        """Find the place with all lines, and none with one gone."""
        for solver in solved:
            return solver(system)
        raise NoAnswerError("the rest does not hold it")

    monkeypatch.setattr("catopt.sizing.pattern.zero_load_position", once)
    said = r"^swell: without line 1 of the pattern the body has no equilibrium: the rest does"
    with pytest.raises(NoAnswerError, match=said):
        pattern(
            LINE, 3, [BodyState("swell", 50e3, STILL)], pretension=PRETENSION, still_height=STILL
        )


def test_the_case_of_the_whole_pattern_has_the_water_of_its_hardest_state() -> None:
    """The fairlead is 24 m up in 20 m of water; the hardest state has it at 25.5 m."""
    case = catopt.Case(
        title="Berth 3",
        site=catopt.Site(20.0),
        line=LINE,
        load=None,
        load_cases=(LoadCase("storm", 1e3),),
        fairlead_height=STILL,
    )
    made = system_case(case, found(4))
    assert made.title == "Berth 3: 4 lines, storm, high water"
    assert (made.fairlead_height, made.site.water_depth) == (25.5, 21.5)
    assert made.system == found(4).system
    assert made.design is None


def three_lines(levels: WaterLevels) -> Sizing:
    """Size them of one size of chain."""
    line = LineChoice(
        usual("chain", "tanker"), "break/5", diameters=(0.07,), length_step=82.5, life=0.0
    )
    place = dataclasses.replace(deep(), levels=levels)
    with alone():
        return size_tanker(TankerRequest((LOADED,), place, line=line, lines=3))


@pytest.fixture(scope="module")
def of() -> Sizing:
    """Three lines where low water has the larger force by far."""
    return three_lines(WaterLevels(14.0, 22.0))


def test_without_a_tide_the_swing_is_that_of_the_one_water_there_is() -> None:
    steady = three_lines(WaterLevels.steady(22.0))
    (state,) = around(steady).states
    assert state.load_case == steady.swing.load_case == "loaded, high water"
    assert steady.swing.total == pytest.approx(state.line_out.offset + 234.0, rel=1e-12)


def test_the_pretension_is_a_part_of_the_largest_force_of_a_line(of: Sizing) -> None:
    """A tenth when nothing is said; the anchors lie where it has them at still high water."""
    forces = [each.horizontal_force for each in of.case.load_cases if each.state == "intact"]
    assert max(forces) > 1.01 * min(forces)
    assert around(of).pretension == pytest.approx(0.1 * max(forces), rel=1e-12)
    alone = catopt.solve(
        of.point.line, height=22.0 + 3.6, horizontal_force=0.1 * max(forces)
    )  # her fairlead is 3.6 m up
    assert around(of).anchor_radius == pytest.approx(alone.span, rel=1e-9)


def test_several_lines_let_the_body_go_by_its_largest_offset(of: Sizing) -> None:
    """The swing is told with a line lost, and the ship behind the body: she is 234 m long."""
    offsets = {each.load_case: each.offset for each in around(of).states}
    assert of.excursion == max(offsets.values()) > min(offsets.values())
    lost = {each.load_case: each.line_out.offset for each in around(of).states}
    assert of.swing.load_case == "loaded, low water"
    assert max(lost.values()) == lost["loaded, low water"] > max(offsets.values())
    assert [length for _, length in of.swing.parts] == [lost["loaded, low water"], 234.0]


def test_each_state_of_several_lines_stands_in_its_own_water(of: Sizing) -> None:
    """Low water is 8 m lower; the ship has no crest under it. The loads are those of the ship."""
    heights = {each.load_case: each.fairlead_height for each in around(of).states}
    assert heights == pytest.approx({"loaded, high water": 25.6, "loaded, low water": 17.6})
    loads = {each.load_case: each.horizontal_force for each in of.settled.posed.loads}
    assert {each.load_case: each.force for each in around(of).states} == loads


def test_the_line_is_sized_for_each_state_s_own_force_to_three_digits(of: Sizing) -> None:
    """With all lines there, and with one gone; rounded up."""
    wanted = {each.load_case: each.line_force for each in around(of).states}
    wanted |= {
        f"{each.load_case}, one line damaged": each.line_out.line_force
        for each in around(of).states
    }
    carried = {each.name: each.horizontal_force for each in of.case.load_cases}
    assert carried.keys() == wanted.keys()
    for name, force in carried.items():
        assert wanted[name] <= force * (1.0 + 1e-9)
        # Not more than by the rule of practice, where that is more: all of the force for 3 lines.
        whole = next(
            each.force for each in around(of).states if each.load_case == name.split(", one")[0]
        )
        assert force <= max(1.01 * wanted[name], whole)
    for force in of.settled.assumed.forces:
        unit = 10.0 ** (math.floor(math.log10(force)) - 2)
        assert force == pytest.approx(unit * round(force / unit), rel=1e-12)
    assert len(of.settled.assumed.forces) == 4
