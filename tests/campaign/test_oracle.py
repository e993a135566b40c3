"""The oracle: right answers pass, planted errors do not, also where the bed is touched twice."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from catopt import solve
from catopt.catenary.layout import Stretch
from catopt.catenary.solution import EndState, PointLoadState, Residual, Solution
from catopt.model import Line, PointLoad, Segment
from tests.campaign.evaluation import solved
from tests.campaign.lines import draw
from tests.campaign.oracle import check
from tests.campaign.quadrature import hanging, upright

CHAIN = Segment(200.0, 800.0, EA=3e8)
ROPE = Segment(300.0, 60.0, EA=2e7)
CLUMP = PointLoad(150.0, 2e4)


def answered(line: Line, **given: Any) -> tuple[Solution, str, float]:
    known = next(k for k in ("horizontal_force", "span", "fairlead_tension") if k in given)
    return solve(line, **given), known, given[known]


ANSWERS = {
    "suspended": answered(Line([ROPE]), height=100.0, horizontal_force=2e5),
    "below anchor": answered(Line([CHAIN, ROPE]), height=350.0, anchor_height=300.0, span=410.0),
    "grounded": answered(
        Line([CHAIN, ROPE], [CLUMP]), height=100.0, span=480.0, seabed_friction=0.7
    ),
    "friction holds it": answered(
        Line([CHAIN, ROPE]), height=100.0, horizontal_force=5e4, seabed_friction=1.2
    ),
    "between": answered(
        Line([CHAIN, ROPE]),
        height=100.0,
        anchor_height=30.0,
        fairlead_tension=6e4,
        seabed_friction=0.2,
    ),
    "clump weight in part": answered(
        Line([CHAIN, ROPE], [PointLoad(250.0, 5e4)]), height=60.0, horizontal_force=5e4
    ),
    "buoy": answered(Line([CHAIN, ROPE], [PointLoad(350.0, -3e3)]), height=150.0, span=450.0),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_right_answers_pass(name: str) -> None:
    found = check(*ANSWERS[name])
    assert found.ratio < 0.1, found


def test_tension_that_begins_under_a_clump_weight_or_right_at_the_fairlead_passes() -> None:
    """Friction under the weight takes off what is left; or a few ulps of the line's length do."""
    line = Line([CHAIN, ROPE], [PointLoad(150.0, 9e4)])
    held = solve(line, height=100.0, horizontal_force=6e4, seabed_friction=0.7)
    assert held.anchor.tension == 0.0
    assert check(held, "horizontal_force", 6e4).ratio < 0.1
    loose = solve(Line([CHAIN]), height=0.0, horizontal_force=1e-11, seabed_friction=1.0)
    assert check(loose, "horizontal_force", 1e-11).is_right


def with_fairlead(solution: Solution, H: float, V: float) -> Solution:
    end = EndState(math.hypot(H, V), H, V, math.atan2(V, H))
    return replace(solution, fairlead=end)


def with_anchor(solution: Solution, H: float, V: float) -> Solution:
    end = EndState(math.hypot(H, V), H, V, math.atan2(V, H))
    return replace(solution, anchor=end)


def V_off(s: Solution) -> Solution:
    return with_fairlead(s, s.horizontal_force, s.fairlead.vertical_force * (1 + 1e-6))


def H_off(s: Solution) -> Solution:
    return with_fairlead(s, s.horizontal_force * (1 + 1e-6), s.fairlead.vertical_force)


def anchor_pull_off(s: Solution) -> Solution:
    pull = s.anchor.horizontal_force + 1e-6 * s.fairlead.tension
    return with_anchor(s, pull, s.anchor.vertical_force)


def anchor_uplift_off(s: Solution) -> Solution:
    uplift = s.anchor.vertical_force + 1e-6 * s.fairlead.tension
    return with_anchor(s, s.anchor.horizontal_force, uplift)


def span_off(s: Solution) -> Solution:
    return replace(s, span=s.span * (1 + 1e-8))


def height_off(s: Solution) -> Solution:
    return replace(s, fairlead_height=s.fairlead_height + 1e-8 * s.line.length)


def shape_off(s: Solution) -> Solution:
    last = s.stretches[-1]
    return replace(s, stretches=(*s.stretches[:-1], replace(last, x=last.x + 1e-6 * s.line.length)))


def friction_off(s: Solution) -> Solution:
    return replace(s, seabed_friction=s.seabed_friction + 1e-5)


def grounded_off(s: Solution) -> Solution:
    return replace(s, grounded_length=s.grounded_length + 1e-6 * s.line.length)


def weight_off(s: Solution) -> Solution:
    *rest, last = s.line.segments
    heavier = replace(last, submerged_weight=last.submerged_weight * (1 + 1e-6))
    return replace(s, line=Line([*rest, heavier], s.line.point_loads))


def stiffness_off(s: Solution) -> Solution:
    *rest, last = s.line.segments
    return replace(s, line=Line([*rest, replace(last, EA=last.EA * 1.001)], s.line.point_loads))


def reaction_off(s: Solution) -> Solution:
    load = s.point_loads[0]
    changed = replace(load, seabed_reaction=load.seabed_reaction + 1e-6 * s.fairlead.tension)
    return replace(s, point_loads=(changed, *s.point_loads[1:]))


def load_elsewhere(s: Solution) -> Solution:
    load = s.point_loads[0]
    return replace(s, point_loads=(replace(load, x=load.x + 1e-3), *s.point_loads[1:]))


def touchdown_elsewhere(s: Solution) -> Solution:
    """Move the touchdown by a millimetre along the line."""
    stretches = list(s.stretches)
    k = next(k for k, each in enumerate(stretches) if not each.on_bed and each.start > 0.0)
    stretches[k - 1] = replace(stretches[k - 1], length=stretches[k - 1].length - 1e-3)
    stretches[k] = replace(
        stretches[k], start=stretches[k].start - 1e-3, length=stretches[k].length + 1e-3
    )
    return replace(s, stretches=tuple(stretches), grounded_length=s.grounded_length - 1e-3)


EVERYWHERE = (
    *(V_off, H_off, anchor_pull_off, anchor_uplift_off, span_off, height_off, shape_off),
    *(weight_off, stiffness_off, grounded_off),
)
ON_THE_BED = ("grounded", "friction holds it", "between")


@pytest.mark.parametrize("name", ANSWERS)
@pytest.mark.parametrize("plant", EVERYWHERE)
def test_planted_errors_are_caught(name: str, plant: Callable[[Solution], Solution]) -> None:
    solution, known, value = ANSWERS[name]
    assert not check(plant(solution), known, value).is_right


@pytest.mark.parametrize("name", ["grounded", "between"])
def test_wrong_friction_is_caught(name: str) -> None:
    solution, known, value = ANSWERS[name]
    assert not check(friction_off(solution), known, value).is_right


@pytest.mark.parametrize("name", ON_THE_BED)
def test_a_touchdown_elsewhere_is_caught(name: str) -> None:
    solution, known, value = ANSWERS[name]
    assert not check(touchdown_elsewhere(solution), known, value).is_right


@pytest.mark.parametrize("name", ["grounded", "clump weight in part", "buoy"])
@pytest.mark.parametrize("plant", [reaction_off, load_elsewhere])
def test_wrong_point_loads_are_caught(name: str, plant: Callable[[Solution], Solution]) -> None:
    solution, known, value = ANSWERS[name]
    assert not check(plant(solution), known, value).is_right


def test_an_answer_to_another_question_is_caught() -> None:
    solution, _, value = ANSWERS["suspended"]
    assert check(solution, "horizontal_force", value * (1 + 1e-9)).condition == "asked"


def test_a_line_through_the_bed_is_caught() -> None:
    """A line that hangs clear of the bed, its anchor and all, let down until it passes through."""
    solution, known, value = ANSWERS["below anchor"]
    low = min(solution.profile(1001).z)
    assert low > 100.0
    down = low + 0.01
    stretches = tuple(replace(each, z=each.z - down) for each in solution.stretches)
    sunk = replace(
        solution,
        fairlead_height=solution.fairlead_height - down,
        anchor_height=solution.anchor_height - down,
        stretches=stretches,
    )
    found = check(sunk, known, value)
    assert found.condition == "below the bed"
    assert not found.is_right


def test_a_buoyant_part_that_lies_is_caught() -> None:
    """Everything else is in order: without friction and stretch, weight on the bed does nothing."""
    line = Line([Segment(50.0, 20.0), Segment(200.0, 800.0)])
    solution = solve(line, height=60.0, horizontal_force=4e4)
    assert check(solution, "horizontal_force", 4e4).is_right
    buoyant = Line([Segment(50.0, -20.0), Segment(200.0, 800.0)])
    found = check(replace(solution, line=buoyant), "horizontal_force", 4e4)
    assert found.condition == "floats on the bed"


def test_a_slack_line_further_than_it_reaches_is_caught() -> None:
    """100 m of chain, 40 m up: without any force it lies on at most 60 m of bed."""
    line = Line([Segment(100.0, 500.0)])
    solution = solve(line, height=40.0, span=30.0)
    exact = replace(
        solution,
        fairlead=EndState(20e3, 0.0, 20e3, math.pi / 2),
        stretches=(
            Stretch(0.0, 60.0, 500.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, True, 0, 0.5),
            Stretch(60.0, 40.0, 500.0, 0.0, 30.0, 0.0, 0.0, 0.0, 0.0, False),
        ),
    )
    assert check(exact, "span", 30.0).is_right
    lying, hanging_part = exact.stretches
    far = replace(exact, span=60.001, stretches=(lying, replace(hanging_part, x=60.001)))
    assert check(far, "span", 60.001).condition == "slack"
    heavier = replace(exact, fairlead=EndState(20.1e3, 0.0, 20.1e3, math.pi / 2))
    assert not check(heavier, "span", 30.0).is_right


# --- touching the bed twice: answers made by hand, of uniform catenaries between touchdowns ------


def touches_twice(friction: float, pull: float) -> Solution:
    """100 N/m, EA 1 MN: bed, an arc over a buoy of 4 kN in its middle, bed again, up to 30 m.

    From a touchdown on, z = (T - H)/w + V^2/(2 EA w) and x = (H/w) asinh(V/H) + H s/EA.
    """
    w, c, lift, side = 100.0, 1e-6, 4e3, 20.0
    first, second, up = 50.0, 40.0, 45.0
    H_arc = max(pull - friction * w * second, 0.0)
    held = second if friction * w * second <= pull else pull / (friction * w)
    H_low = max(H_arc - friction * w * first, 0.0)
    low_held = first if friction * w * first <= H_arc else H_arc / (friction * w)

    def reach(H: float, s: float) -> tuple[float, float]:
        V = w * s
        across = H / w * math.asinh(V / H) if H > 0.0 else 0.0
        return across + c * H * s, (math.hypot(H, V) - H) / w + 0.5 * c * w * s * s

    def lying(T: float, length: float) -> float:
        return length + c * length * (T - 0.5 * friction * w * length)

    stretches: list[Stretch] = []
    s = x = 0.0

    def add(
        length: float, z: float, H: float, V: float, gain: float, lies: bool, dx: float
    ) -> None:
        nonlocal s, x
        if length > 0.0:
            stretches.append(Stretch(s, length, w, c, x, z, H, V, gain, lies))
            s, x = s + length, x + dx

    add(first - low_held, 0.0, 0.0, 0.0, 0.0, True, first - low_held)
    add(low_held, 0.0, H_low, 0.0, friction * w, True, lying(H_arc, low_held))
    across, top = reach(H_arc, side)
    add(side, 0.0, H_arc, 0.0, 0.0, False, across)
    buoy = PointLoadState("", first + side, x, top, 0.0)
    add(side, top, H_arc, -w * side, 0.0, False, across)
    add(second - held, 0.0, 0.0, 0.0, 0.0, True, second - held)
    add(held, 0.0, H_arc, 0.0, friction * w, True, lying(pull, held))
    across, height = reach(pull, up)
    add(up, 0.0, pull, 0.0, 0.0, False, across)
    length = first + 2 * side + second + up
    base = solve(Line([Segment(length, w, EA=1 / c)]), height=height, horizontal_force=pull)
    V = w * up
    return replace(
        base,
        line=Line([Segment(length, w, EA=1 / c)], [PointLoad(first + side, -lift)]),
        seabed_friction=friction,
        span=x,
        fairlead=EndState(math.hypot(pull, V), pull, V, math.atan2(V, pull)),
        anchor=EndState(H_low, H_low, 0.0, 0.0),
        grounded_length=first + second,
        suspended_length=2 * side + up,
        point_loads=(buoy,),
        stretches=tuple(stretches),
        residual=Residual(0.0, 0.0),
    )


@pytest.mark.parametrize(
    ("friction", "pull"), [(0.0, 5e3), (0.3, 9e3), (0.3, 2e3), (0.3, 1e3), (1.5, 9e3)]
)
def test_a_line_that_touches_twice_is_followed(friction: float, pull: float) -> None:
    """Friction takes nothing, some of it, all on the lower bed, all on the upper bed."""
    solution = touches_twice(friction, pull)
    assert check(solution, "horizontal_force", pull).ratio < 0.1
    assert check(solution, "span", solution.span).ratio < 0.1
    for plant in (V_off, H_off, span_off, height_off, shape_off, anchor_pull_off, weight_off):
        assert not check(plant(solution), "horizontal_force", pull).is_right


def test_a_bed_that_would_have_to_pull_is_caught() -> None:
    """A smaller buoy than the arc hangs from: its ends could not come down without force."""
    solution = touches_twice(0.0, 5e3)
    smaller = Line(solution.line.segments, [PointLoad(70.0, -3990.0)])
    assert not check(replace(solution, line=smaller), "horizontal_force", 5e3).is_right


# --- quadrature ----------------------------------------------------------------------------------


@pytest.mark.parametrize("H", [1e-12, 1e-3, 1.0, 1e3, 1e9])
@pytest.mark.parametrize("V", [-5e3, -1.0, 0.0, 2.0, 7e4])
@pytest.mark.parametrize("w", [-300.0, 1e-6, 40.0])
def test_quadrature_against_the_primitive(H: float, V: float, w: float) -> None:
    """Rise (T2 - T1)/w and run (H/w)(asinh(V2/H) - asinh(V1/H)), each with its rounding."""
    length, c = 70.0, 1e-7
    found = hanging(H, V, w, c, length, 0.0)
    T1, T2 = math.hypot(H, V), math.hypot(H, V + w * length)
    rounding = 4e-16 * max(T1, T2) / abs(w)
    rise = (T2 - T1) / w + c * (V + 0.5 * w * length) * length
    assert found.z == pytest.approx(rise, rel=1e-13, abs=rounding + 1e-13 * length)
    run = H / w * (math.asinh((V + w * length) / H) - math.asinh(V / H)) + c * H * length
    noise = 4e-16 * H / abs(w) * max(abs(math.asinh(V / H)), abs(math.asinh((V + w * length) / H)))
    # V + w length is rounded before it is divided by H.
    noise += 2.3e-16 * max(abs(V), abs(V + w * length)) / abs(w)
    assert found.x == pytest.approx(run, rel=1e-12, abs=noise + 1e-13 * length)


def test_without_force_a_piece_stands_upright() -> None:
    """20 m down and 50 m up, with the stretch of each; the lowest point is where V is 0."""
    w, c = 10.0, 1e-4
    found = upright(-200.0, w, c, 70.0, 0.0)
    down = 20.0 + 0.5 * c * w * 20.0**2
    assert found.low == pytest.approx(-down, rel=1e-14)
    assert found.z == pytest.approx(50.0 + 0.5 * c * w * 50.0**2 - down, rel=1e-14)
    assert found.x == 0.0


@pytest.mark.parametrize(
    ("V", "w"), [(-200.0, 10.0), (40.0, 10.0), (0.0, 10.0), (300.0, -10.0), (9.0, 0.0)]
)
def test_what_is_open_without_force_is_what_a_little_force_turns(V: float, w: float) -> None:
    """Each element moves by min(2, error/|V|) of itself: summed up over thin slices."""
    error, slices = 1.0, 100_000
    ds = 70.0 / slices
    forces = (abs(V + w * (k + 0.5) * ds) for k in range(slices))
    turned = ds * math.fsum(min(2.0, error / force) for force in forces)
    assert upright(V, w, 0.0, 70.0, error).doubt == pytest.approx(turned, rel=1e-5)


@pytest.mark.parametrize("index", [987981, 98085, 598677, 671733])
def test_tension_that_begins_within_rounding_of_a_touchdown_leaves_the_place_open(
    index: int,
) -> None:
    """Nearly all friction is beside them: the force left over reaches sideways up to a buoy."""
    trial = draw(2, index)
    assert check(solved(trial), trial.known, trial.value).is_right
