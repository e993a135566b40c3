"""A line at rest in a current: other integrations, the truss model, the sea, still water."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from catopt import InputError, Line, NoEquilibriumError, PointLoad, Segment, fem, solve_case
from catopt import solve as solve_still
from catopt.casefile import parse_case, write_case
from catopt.catenary.in_current import SolutionInCurrent
from catopt.fem.mesh import Water
from catopt.model import Case, Load, Site
from catopt.model.sea import CurrentProfile
from catopt.waves import PowerLawCurrent, Sea, TableCurrent, WindCurrent

DEPTH, DENSITY = 100.0, 1025.0
TIDE = CurrentProfile("power", speed=1.5)
ACROSS = CurrentProfile("power", speed=1.2, direction=math.radians(50.0))
TURNING = CurrentProfile(
    "table", depths=(0.0, 40.0, 90.0), speeds=(1.4, 0.9, 0.2), directions=(0.5, 0.9, 1.2)
)
WIND = CurrentProfile("wind", speed=1.0, depth=60.0, direction=math.pi)


def chain(length: float) -> Segment:
    return Segment(
        length, 600.0, EA=4e8, mass=70.0, drag_diameter=0.1, drag_normal=2.4, drag_axial=0.5
    )


def rope(length: float, weight: float = 200.0) -> Segment:
    return Segment(
        length, weight, EA=6e7, mass=30.0, drag_diameter=0.12, drag_normal=1.2, drag_axial=0.05
    )


def case(current: CurrentProfile | None, load: Load, *parts: Any, **own: Any) -> Case:
    segments = [each for each in parts if isinstance(each, Segment)]
    loads = [each for each in parts if isinstance(each, PointLoad)]
    site = Site(DEPTH, own.pop("friction", 0.3), DENSITY)
    line = Line(segments, loads)
    return Case(site, line, load, **{"fairlead_height": DEPTH, **own}, current=current)


def solved(of: Case) -> SolutionInCurrent:
    found = solve_case(of)
    assert isinstance(found, SolutionInCurrent)
    return found


# ------------------------------------------------------------------ another integration


def water(current: CurrentProfile) -> Callable[[float], Any]:
    """Flow by height, written out anew."""

    def at(z: float) -> Any:
        way = np.array([math.cos(current.direction), math.sin(current.direction), 0.0])
        if current.profile == "power":
            return (current.speed or 0.0) * (max(z, 0.0) / DEPTH) ** (1.0 / 7.0) * way
        if current.profile == "wind":
            assert current.depth is not None
            assert current.speed is not None
            return max(current.depth - DEPTH + z, 0.0) / current.depth * current.speed * way
        columns = [
            [v * f(b) for v, b in zip(current.speeds, current.directions, strict=True)]
            for f in (math.cos, math.sin)
        ]
        return np.array([*(np.interp(DEPTH - z, current.depths, c) for c in columns), 0.0])

    return at


def up(line: Line, current: CurrentProfile, start: Any, skip: float = 0.0) -> Any:
    """Integrate place and force up the line, from so much of it that lies; DOP853."""
    flow = water(current)
    state = start
    for segment in line.segments:
        length = segment.length - min(skip, segment.length)
        skip -= segment.length - length
        half = 0.5 * DENSITY * (segment.drag_diameter or 0.0)
        normal, axial = half * (segment.drag_normal or 0.0), half * (segment.drag_axial or 0.0)

        def slope(
            _: float, y: Any, normal: float = normal, axial: float = axial, part: Segment = segment
        ) -> Any:
            T = np.linalg.norm(y[3:])
            e = y[3:] / T
            u = flow(y[2])
            along = (u @ e) * e
            across = u - along
            drag = normal * np.linalg.norm(across) * across + axial * np.linalg.norm(along) * along
            weight = np.array([0.0, 0.0, part.submerged_weight])
            return np.concatenate([(1.0 + T / part.EA) * e, weight - drag])

        if length > 0.0:
            found = solve_ivp(slope, (0.0, length), state, "DOP853", rtol=1e-12, atol=1e-9)
            state = found.y[:, -1]
    return state


@pytest.mark.parametrize("current", [TIDE, ACROSS, TURNING, WIND])
def test_a_taut_line_as_by_integration_from_its_anchor(current: CurrentProfile) -> None:
    own = case(current, Load(span=330.0), chain(40.0), rope(305.0))
    found = solved(own)
    assert found.regime == "suspended"
    wanted = np.array([330.0, 0.0, DEPTH])

    def missed(force: Any) -> Any:
        return up(own.line, current, np.array([0.0, 0.0, 0.0, *force]))[:3] - wanted

    still = solve_still(own.line, height=DEPTH, span=330.0).anchor
    force = fsolve(missed, [still.horizontal_force, 0.0, still.vertical_force], xtol=1e-12)
    assert found.anchor.tension == pytest.approx(np.linalg.norm(force), rel=1e-6)
    top = up(own.line, current, np.array([0.0, 0.0, 0.0, *force]))[3:]
    assert found.fairlead.tension == pytest.approx(np.linalg.norm(top), rel=1e-6)
    least = 1e-6 * float(np.linalg.norm(top))
    assert found.fairlead_force == pytest.approx(tuple(top), abs=least)
    assert found.anchor_force == pytest.approx(tuple(force), abs=least)
    # What the water does is what the two ends hold beside the weight.
    weight = np.array([0.0, 0.0, 40.0 * 600.0 + 305.0 * 200.0])
    assert found.drag == pytest.approx(tuple(force - top + weight), abs=least)


def test_a_line_on_the_bed_as_by_integration_from_its_touchdown() -> None:
    own = case(TIDE, Load(horizontal_force=60e3), chain(300.0), rope(150.0))
    found = solved(own)

    def top(unknown: Any) -> Any:
        H, lies = unknown
        return up(own.line, TIDE, np.array([0.0, 0.0, 0.0, H, 0.0, 0.0]), lies)

    def missed(unknown: Any) -> list[float]:
        at = top(unknown)
        return [at[2] - DEPTH, (at[3] - 60e3) / 600.0]

    still = solve_still(own.line, height=DEPTH, horizontal_force=60e3)
    H, lies = fsolve(missed, [60e3, still.grounded_length], xtol=1e-13)
    end = top(np.array([H, lies]))
    assert found.grounded_length == pytest.approx(lies, rel=1e-6)
    assert found.fairlead.tension == pytest.approx(np.linalg.norm(end[3:]), rel=1e-6)
    # On the bed the tension falls by mu w a metre, and stretches what lies there.
    assert found.anchor.tension == pytest.approx(H - 0.3 * 600.0 * lies, rel=1e-6)
    stretch = lies * (H - 0.5 * 0.3 * 600.0 * lies) / 4e8
    assert found.span == pytest.approx(lies + stretch + end[0], rel=1e-8)
    assert found.stretched_length == pytest.approx(450.24, abs=0.1)
    assert "no current drag" in "\n".join(found.warnings)


# ------------------------------------------------------------------ the truss model


def truss(own: Case, elements: int) -> fem.TrussSolution:
    assert own.current is not None
    flow = water(own.current)
    sections = [
        fem.DragSection(s.drag_diameter or 1.0, s.drag_normal or 0.0, s.drag_axial or 0.0)
        for s in own.line.segments
    ]
    current = fem.Current(lambda at: np.array([flow(z) for z in at[:, 2]]), sections, DENSITY)
    load = own.load
    assert load is not None
    return fem.solve_line(
        own.line,
        height=DEPTH,
        horizontal_force=load.horizontal_force,
        span=load.span,
        seabed_friction=own.site.seabed_friction,
        elements=elements,
        water=Water(current=current),
    )


@pytest.mark.parametrize(
    ("current", "load", "parts"),
    [
        (TIDE, Load(span=330.0), (chain(40.0), rope(305.0))),
        (ACROSS, Load(span=330.0), (chain(40.0), rope(305.0))),
        (TIDE, Load(horizontal_force=6e4), (chain(300.0), rope(150.0))),
        (WIND, Load(horizontal_force=6e4), (chain(300.0), rope(150.0), PointLoad(320.0, 2e4))),
    ],
)
def test_the_truss_model_comes_to_it(current: CurrentProfile, load: Load, parts: Any) -> None:
    own = case(current, load, *parts)
    found = solved(own)
    off = []
    for elements in (60, 120):
        other = truss(own, elements)
        off.append(other.fairlead.tension / found.fairlead.tension - 1.0)
    assert abs(off[1]) < 2e-4
    # Bars have errors of the second order, so that what is left of two meshes is a third of the
    # change between them; touchdowns between nodes spoil the digits of it.
    left = off[1] + (off[1] - off[0]) / 3.0
    assert abs(left) < 1e-4


# ------------------------------------------------------------------ the water, and none


@pytest.mark.parametrize("current", [TIDE, TURNING, WIND])
def test_the_water_flows_as_in_a_sea(current: CurrentProfile) -> None:
    if current.profile == "table":
        flow: Any = TableCurrent(current.depths, current.speeds, directions=current.directions)
    elif current.profile == "wind":
        flow = WindCurrent(current.speed or 0.0, current.depth or 1.0, current.direction)
    else:
        flow = PowerLawCurrent(current.speed or 0.0, current.direction)
    heights = np.array([0.0, 5.0, 10.0, 33.0, 60.0, 77.0, DEPTH])
    at = np.column_stack([np.zeros((heights.size, 2)), heights])
    sea = Sea(DEPTH, None, (flow,))
    known = sea.kinematics(0.0, at).velocity
    own = [current.flow(DEPTH)(float(z)) for z in heights]
    assert np.array(own) == pytest.approx(np.asarray(known)[:, :2], abs=1e-12)
    assert current.flow(DEPTH)(DEPTH + 1.0) == (0.0, 0.0)


@pytest.mark.parametrize(
    "load", [Load(horizontal_force=4e4), Load(span=430.0), Load(fairlead_tension=9e4)]
)
@pytest.mark.parametrize("parts", [(), (PointLoad(250.0, 9e3),), (PointLoad(310.0, 2e4),)])
def test_water_that_stands_is_still_water(load: Load, parts: tuple[PointLoad, ...]) -> None:
    own = case(CurrentProfile("power", speed=0.0), load, chain(300.0), rope(150.0), *parts)
    found = solved(own)
    still = solve_case(replace(own, current=None))
    for key in ("span", "grounded_length", "suspended_length", "stretched_length"):
        assert getattr(found, key) == pytest.approx(getattr(still, key), rel=1e-8), key
    for end in ("fairlead", "anchor"):
        own_end, other = getattr(found, end), getattr(still, end)
        assert own_end.tension == pytest.approx(other.tension, rel=1e-8)
        assert own_end.angle == pytest.approx(other.angle, abs=1e-8)
    tensions = [each.max_tension for each in found.segments]
    assert tensions == pytest.approx([each.max_tension for each in still.segments], rel=1e-8)
    for state, known in zip(found.point_loads, still.point_loads, strict=True):
        assert (state.x, state.z) == pytest.approx((known.x, known.z), abs=1e-5)
        assert state.seabed_reaction == pytest.approx(known.seabed_reaction, abs=1e-3)
    shape, other_shape = found.profile(), still.profile(1001)
    assert np.interp(shape.s, other_shape.s, other_shape.z) == pytest.approx(shape.z, abs=2e-2)


def test_a_point_load_feels_the_current() -> None:
    # A float of hardly any weight on a taut upright rope of hardly any drag: the rope deflects by
    # the drag 0.5 rho Cd A u^2 = 0.5 x 1025 x 2 x 1 = 1025 N in its middle, so F (L/2)/(2 T)
    # = 1025 x 25/(2 x 100 kN) = 0.128 m, the span being held at nearly none.
    thin = Segment(50.0, 1e-3, EA=1e9, drag_normal=0.0)
    load = PointLoad(25.0, 1e-3, drag_area=2.0, drag_coefficient=1.0)
    steady = CurrentProfile("table", depths=(0.0, DEPTH), speeds=(1.0, 1.0))
    own = case(steady, Load(span=1e-6), thin, load, fairlead_height=50.0 * (1.0 + 1e-4))
    found = solved(own)
    T = found.fairlead.tension
    (state,) = found.point_loads
    assert found.drag[0] == pytest.approx(1025.0, rel=1e-9)
    assert state.x == pytest.approx(1025.0 * 25.0 / (2.0 * T), rel=1e-3)


# ------------------------------------------------------------------ what is refused


def test_what_is_missing_is_told_at_once() -> None:
    own = case(TIDE, Load(span=330.0), Segment(40.0, 600.0), Segment(305.0, 200.0, drag_normal=1.0))
    with pytest.raises(InputError) as caught:
        solve_case(own)
    assert [each.key for each in caught.value.problems] == [
        "line.segments[0].drag_normal",
        "line.segments[1].drag_diameter",
    ]
    rough = replace(rope(305.0), drag_normal=None, drag_axial=None)
    rough = replace(rough, drag_method="roughness", roughness=1e-3, keulegan_carpenter=8.0)
    with pytest.raises(InputError, match="give drag_normal and drag_axial"):
        solve_case(case(TIDE, Load(span=330.0), chain(40.0), rough))


def test_what_is_not_solved_in_a_current_is_refused() -> None:
    with pytest.raises(InputError, match=r"be combined with site\.seabed_slope"):
        replace(case(TIDE, Load(span=330.0), chain(340.0)), site=Site(DEPTH, seabed_slope=0.02))
    with pytest.raises(InputError, match="slack in still water already"):
        solve_case(
            case(
                CurrentProfile("power", speed=3.0, direction=3.0),
                Load(span=380.0),
                chain(300.0),
                rope(150.0),
            )
        )
    with pytest.raises(InputError, match="below the bed"):
        solve_case(case(TIDE, Load(span=440.0), chain(500.0), anchor_height=20.0))
    with pytest.raises(InputError, match="solve and check"):
        solve_case(case(TIDE, Load(span=330.0), chain(340.0)), "pso")
    series = replace(TIDE, speed=None, series_file="current.csv")
    with pytest.raises(InputError, match="a current series needs"):
        case(series, Load(span=330.0), chain(340.0))


def test_a_file_of_a_current_at_rest_is_written_and_read() -> None:
    own = case(TURNING, Load(span=330.0), chain(40.0), rope(305.0))
    again = parse_case(write_case(own))
    assert again.current == own.current
    assert solved(again).fairlead.tension == solved(own).fairlead.tension


AT_THE_SURFACE = """
[site]
water_depth = 34.8071
seabed_friction = 0.1612
[line]
{height}
[[line.segments]]
length = 59.184
submerged_weight = 4.1773
EA = 98379
drag_diameter = 0.010934
drag_normal = 1.6316
drag_axial = 0.51626
[[line.segments]]
length = 15.018
submerged_weight = 9.7301
EA = 93879
drag_diameter = 0.10444
drag_normal = 1.463
drag_axial = 1.0389
[[line.segments]]
length = 31.144
submerged_weight = 3.3288
EA = 940610
drag_diameter = 0.019475
drag_normal = 2.1144
drag_axial = 0.83057
[load]
fairlead_tension = 1874.99
[current]
profile = "wind"
speed = 2.5834
depth = 15.698
direction = -1.7298
"""


def test_a_fairlead_in_the_surface_is_solved_as_one_just_below() -> None:
    """The current stopped above the surface, where the trials of the search come by."""
    below = solve_case(parse_case(AT_THE_SURFACE.format(height="fairlead_height = 34.7971")))
    assert below.span == pytest.approx(98.104, abs=5e-4)  # of the truss and of a finer march
    lower = solve_case(parse_case(AT_THE_SURFACE.format(height="fairlead_height = 34.7871")))
    at = solve_case(parse_case(AT_THE_SURFACE.format(height="")))
    # Continuous in the height: as far from the one 10 mm below as that from the next.
    assert at.span - below.span == pytest.approx(below.span - lower.span, abs=2e-3)


ONE_LINE = """
[site]
water_depth = {depth}
seabed_friction = 0.2
[line]
[[line.segments]]
length = {length}
submerged_weight = {weight}
EA = 1e7
drag_diameter = {diameter}
drag_normal = 1.6
drag_axial = 0.5
[load]
{load}
[current]
profile = "wind"
speed = {speed}
depth = {reach}
"""


def test_every_span_with_the_tension_is_told_and_is_one() -> None:
    given = {"depth": 31.811, "length": 64.361, "weight": 14.975, "diameter": 0.1442}
    given |= {"speed": 1.277, "reach": 21.665}
    solution = solve_case(parse_case(ONE_LINE.format(load="fairlead_tension = 994.33", **given)))
    (told,) = [w for w in solution.warnings if "several spans" in w]
    assert solution.span == pytest.approx(43.65, abs=0.01)
    other = float(re.findall(r"and ([\d.]+) m;", told)[0])
    assert other < 30.0
    # Another question leads to it: at that span the tension is the given one.
    again = solve_case(parse_case(ONE_LINE.format(load=f"span = {other}", **given)))
    assert again.fairlead.tension == pytest.approx(994.33, rel=2e-3)  # the span has four digits


def test_a_line_slack_in_still_water_is_not_said_to_be_slackened() -> None:
    given = {"depth": 20.0, "length": 60.0, "weight": 50.0, "diameter": 0.05}
    given |= {"speed": 1.0, "reach": 20.0}
    against = ONE_LINE.format(load="span = 40.5", **given) + "direction = 3.14\n"
    with pytest.raises(InputError, match="slack in still water already"):
        solve_case(parse_case(against))


def against_a_strong_current(load: Load, direction: float = 0.0) -> Case:
    """Draw a line whose drag is some 80 times its weight, the current against its span."""
    ends = ((152.54, 1.07, 451267.0, 0.0748, 1.7, 0.84), (78.41, 1.94, 309294.0, 0.0834, 1.9, 0.5))
    parts = [
        Segment(length, w, EA=EA, drag_diameter=d, drag_normal=normal, drag_axial=axial)
        for length, w, EA, d, normal, axial in ends
    ]
    current = CurrentProfile(
        "table",
        depths=(0.0, 44.450, 100.01),
        speeds=(1.2591, 0.88134, 0.25181),
        directions=tuple(each + direction for each in (-2.9236, -2.5695, -2.5642)),
    )
    site = Site(111.13, 0.436, DENSITY)
    return Case(site, Line(parts), load, fairlead_height=102.04, current=current)


def test_a_tension_below_all_that_the_current_leaves_is_said_to_be() -> None:
    """It ended as not converged: its way from still water ends in a fold."""
    with pytest.raises(NoEquilibriumError, match=r"at least 2\.223 kN") as caught:
        solved(against_a_strong_current(Load(fairlead_tension=2217.0)))
    assert caught.value.missing == pytest.approx(6.0, abs=0.6)
    # Spans given, from the other side, go another way: no tension about the least is below it.
    at = [
        solved(against_a_strong_current(Load(span=span), math.pi)).fairlead.tension
        for span in (135.0, 139.6, 144.0)
    ]
    assert at[1] < min(at[0], at[2])
    assert at[1] == pytest.approx(2217.0 + caught.value.missing, abs=0.05)


def test_both_spans_with_a_tension_above_the_least_are_told() -> None:
    solution = solved(against_a_strong_current(Load(fairlead_tension=2300.0)))
    (told,) = [w for w in solution.warnings if "several spans" in w]
    spans = {
        round(-solution.span),
        *(round(-float(each)) for each in re.findall(r"and (.+) m;", told)),
    }
    for span in spans:
        again = solved(against_a_strong_current(Load(span=float(span)), math.pi))
        assert again.fairlead.tension == pytest.approx(2300.0, abs=5.0)
    assert len(spans) == 2
