"""Floats at the ends of lines in a current: another integration, still water, what is refused."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from catopt import InputError, Line, PointLoad, Segment
from catopt.answers.blocks import Text
from catopt.answers.floats import afloat_on_card, floats_on_card
from catopt.casefile.reading import parse_network
from catopt.casefile.writing import write_case
from catopt.checks.system import check_network
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import FloatsUpError
from catopt.model import Checks, Site
from catopt.model.network import LineBetween, Network, Point
from catopt.model.sea import CurrentProfile
from catopt.mooring.fixed_body import at_rest, hold
from catopt.mooring.network_out import each_line_out
from catopt.mooring.network_rest import FloatsInCurrent

DEPTH, LIFT, CdA, RHO = 500.0, 6e3, 0.4, 1025.0
SHEAR = CurrentProfile(
    "table",
    depths=(0.0, 100.0, 300.0, 500.0),
    speeds=(0.9, 0.7, 0.3, 0.1),
    direction=math.radians(30.0),
)
LOWER = Segment(250.0, 4.0, EA=8e6, MBL=60e3, drag_diameter=0.016, drag_normal=1.3, drag_axial=0.02)
UPPER = Segment(150.0, 2.0, EA=4e6, MBL=40e3, drag_diameter=0.012, drag_normal=1.3, drag_axial=0.02)


def moored(current: CurrentProfile | None = SHEAR, lift: float = LIFT, **own: Any) -> Network:
    """Moor an instrument float by two ropes in one line, given from the float down."""
    drag = {} if current is None else {"drag_area": 0.8, "drag_coefficient": CdA / 0.8}
    points = (
        Point("anchor", "anchor", 40.0, -10.0, 0.0),
        Point("float", "joint", submerged_weight=-lift, **drag),  # type: ignore[arg-type]
    )
    line = LineBetween(Line([UPPER, LOWER]), "float", "anchor")
    return Network(Site(DEPTH, 0.3, RHO), points, (line,), current=current, **own)


def down(height: float) -> np.ndarray:
    """Integrate place and force down the line from a float at a height; DOP853."""
    way = np.array([math.cos(SHEAR.direction), math.sin(SHEAR.direction), 0.0])

    def flow(z: float) -> Any:
        return np.interp(DEPTH - z, SHEAR.depths, SHEAR.speeds) * way

    u = flow(height)
    pull = np.array([0.0, 0.0, LIFT]) + 0.5 * RHO * CdA * np.linalg.norm(u) * u
    state = np.array([0.0, 0.0, height, *pull])
    for segment in (UPPER, LOWER):
        half = 0.5 * RHO * (segment.drag_diameter or 0.0)

        def slope(_: float, y: Any, half: float = half, part: Segment = segment) -> Any:
            T = np.linalg.norm(y[3:])
            e = y[3:] / T
            u = flow(y[2])
            along = (u @ e) * e
            across = u - along
            drag = half * 1.3 * np.linalg.norm(across) * across
            drag += half * 0.02 * np.linalg.norm(along) * along
            return np.concatenate(
                [-(1.0 + T / part.EA) * e, drag - np.array([0.0, 0.0, part.submerged_weight])]
            )

        found = solve_ivp(slope, (0.0, segment.length), state, "DOP853", rtol=1e-12, atol=1e-9)
        state = found.y[:, -1]
    return np.asarray(state)


def test_a_float_is_knocked_down_as_by_integration_from_it() -> None:
    found = at_rest(moored())
    assert isinstance(found, FloatsInCurrent)
    height = brentq(lambda z: down(z)[2], 350.0, 401.0, xtol=1e-10)
    end = down(height)
    x, y, z = found.place_of("float")
    assert z == pytest.approx(height, rel=1e-8)
    assert (x - 40.0, y + 10.0) == pytest.approx((-end[0], -end[1]), rel=1e-6)
    (line,) = found.lines
    assert line.anchor.tension == pytest.approx(np.linalg.norm(end[3:]), rel=1e-6)
    assert line.fairlead.vertical_force == pytest.approx(LIFT, rel=1e-6)
    # In still water it stands upright: 6 kN at the float, 5.7 kN where the ropes meet, 4.7 kN at
    # the anchor, stretched by 150 m x 5.85 kN/4 MN + 250 m x 5.2 kN/8 MN.
    (still,) = found.heights
    assert still == pytest.approx(400.0 + 150.0 * 5.85e3 / 4e6 + 250.0 * 5.2e3 / 8e6, abs=1e-6)
    assert still - z > 1.5


def test_a_current_that_stands_leaves_the_float_where_it_is() -> None:
    calm = at_rest(moored(replace(SHEAR, speeds=(0.0,) * 4)))
    still = at_rest(moored(None))
    assert calm.place_of("float") == pytest.approx(still.place_of("float"), abs=1e-5)
    assert calm.lines[0].anchor.tension == pytest.approx(still.lines[0].anchor.tension, rel=1e-8)


def test_a_stronger_current_takes_the_float_farther() -> None:
    heights = []
    for factor in (0.5, 1.0, 1.5):
        speeds = tuple(factor * each for each in SHEAR.speeds)
        found = at_rest(moored(replace(SHEAR, speeds=speeds)))
        heights.append(found.place_of("float")[2])
    assert heights[0] > heights[1] > heights[2]
    # A moored line in the plane of the current bends in it alone.
    x, y, _ = found.place_of("float")
    assert math.atan2(y + 10.0, x - 40.0) == pytest.approx(SHEAR.direction, abs=1e-6)


def test_checks_and_lost_lines_are_of_the_current() -> None:
    report = check_network(moored(checks=Checks(safety_factor=3.0)))
    tensions = [each for each in report.results if each.kind == "tension"]
    assert max(each.demand for each in tensions) == pytest.approx(
        at_rest(moored()).lines[0].fairlead.tension, rel=1e-9
    )
    network = moored()
    other = (replace(network.points[0], name="b", x=900.0), replace(network.points[1], name="f2"))
    line = replace(network.lines[0], start="f2", end="b")
    both = replace(network, points=(*network.points, *other), lines=(*network.lines, line))
    first, second = each_line_out(both)
    assert "float" in first.refusal
    assert "f2" in second.refusal


def test_a_buoy_below_a_float_is_a_point_load() -> None:
    network = moored()
    line = Line([UPPER, LOWER], [PointLoad(200.0, -500.0, drag_area=0.2, drag_coefficient=0.6)])
    found = at_rest(replace(network, lines=(replace(network.lines[0], line=line),)))
    (load,) = found.lines[0].point_loads
    # 200 m from the float is 200 m from the anchor, below the float.
    assert 190.0 < load.z < 200.5
    assert found.lines[0].anchor.vertical_force > at_rest(network).lines[0].anchor.vertical_force


# ------------------------------------------------------------------ at the surface

RIVER, RISER_LIFT, RISER_CdA = 40.0, 4e3, 1.0
CHAIN = Segment(
    30.0, 150.0, EA=5e7, MBL=300e3, drag_diameter=0.02, drag_normal=2.4, drag_axial=1.15
)
RISER = Segment(45.0, 0.5, EA=3e5, MBL=60e3, drag_diameter=0.016, drag_normal=1.2, drag_axial=0.02)


def marker(speed: float, **own: Any) -> Network:
    """Moor a marker buoy in 40 m by 75 m of chain and rope."""
    current = CurrentProfile("power", speed=speed, direction=math.radians(30.0))
    drag: dict[str, Any] = {"drag_area": RISER_CdA, "drag_coefficient": 1.0}
    points = (
        Point("A", "anchor", 0.0, 0.0),
        Point("F", "joint", submerged_weight=-RISER_LIFT, **drag, **own),
    )
    line = LineBetween(Line([CHAIN, RISER]), "A", "F")
    return Network(Site(RIVER, 0.5, RHO), points, (line,), current=current)


def come_down(speed: float, z: float, up: float) -> tuple[float, float, float, float]:
    """Follow the line by DOP853 from a float at z that pulls `up`, in the plane of the current.

    Height and way from the float where it comes to lie level, the pull there, and what is left
    of its length.
    """

    def flow(height: float) -> float:
        part: float = min(max(height / RIVER, 0.0), 1.0)
        return speed * math.pow(part, 1.0 / 7.0)

    u = flow(z)
    state, left = np.array([0.0, z, 0.5 * RHO * RISER_CdA * u * u, up]), 75.0
    for part in (RISER, CHAIN):
        half = 0.5 * RHO * (part.drag_diameter or 0.0)

        def slope(_: float, y: Any, half: float = half, part: Segment = part) -> Any:
            T, water = math.hypot(y[2], y[3]), flow(y[1])
            e = np.array([y[2], y[3]]) / T
            along = water * e[0] * e
            across = np.array([water, 0.0]) - along
            drag = half * (part.drag_normal or 0.0) * np.linalg.norm(across) * across
            drag += half * (part.drag_axial or 0.0) * np.linalg.norm(along) * along
            way = -(1.0 + T / part.EA) * e
            return np.concatenate([way, drag - np.array([0.0, part.submerged_weight])])

        def is_level(_: float, y: Any) -> float:
            return float(y[3])

        is_level.terminal = True  # type: ignore[attr-defined]
        found = solve_ivp(
            slope, (0.0, part.length), state, "DOP853", rtol=1e-12, atol=1e-10, events=is_level
        )
        state, left = found.y[:, -1], left - float(found.t[-1])
        if found.status == 1:
            break
    return float(state[1]), float(-state[0]), float(state[2]), left


@pytest.mark.parametrize("speed", [0.02, 0.3, 1.5])
@pytest.mark.parametrize("height", [None, 1.5])
def test_a_float_on_one_line_streams_at_the_surface(speed: float, height: float | None) -> None:
    own = {} if height is None else {"float_height": height, "mass": 100.0}
    found = at_rest(marker(speed, **own))
    assert isinstance(found, FloatsInCurrent)
    most = RISER_LIFT + 100.0 * STANDARD_GRAVITY

    def place(up: float) -> float:
        return RIVER if height is None else RIVER - height * (1.0 - (RISER_LIFT - up) / most)

    up = brentq(lambda each: come_down(speed, place(each), each)[0], 19.0, 3.9e3, xtol=1e-9)
    _, way, tension, lies = come_down(speed, place(up), up)
    (afloat,) = found.floats
    assert afloat.used == pytest.approx(up, rel=1e-6)
    assert afloat.under == 0.0
    x, y, z = found.place_of("F")
    assert z == pytest.approx(place(up), abs=1e-7)
    assert y / x == pytest.approx(math.tan(math.radians(30.0)), rel=1e-6)
    (line,) = found.lines
    assert line.grounded_length == pytest.approx(lies, abs=1e-4)
    # On the bed it lies straight, stretched by no more than the pull that comes down to it.
    assert math.hypot(x, y) == pytest.approx(way + lies, abs=lies * tension / CHAIN.EA + 1e-4)
    if height is not None:
        assert afloat.draught == pytest.approx(RIVER - place(up), abs=1e-6)


def test_a_strong_current_takes_a_surface_float_under() -> None:
    afloat, under = (at_rest(marker(speed)).floats[0] for speed in (2.0, 3.0))
    assert afloat.under == 0.0
    assert (under.used, under.left) == (RISER_LIFT, 0.0)
    assert under.under > 0.0


def test_a_surface_float_that_nothing_pushes_stays_where_it_is() -> None:
    network = marker(0.0)
    calm = at_rest(network)
    points = tuple(replace(p, drag_area=None, drag_coefficient=None) for p in network.points)
    still = at_rest(replace(network, points=points, current=None))
    assert calm.place_of("F") == pytest.approx(still.place_of("F"), abs=1e-6)
    assert calm.floats[0].used == pytest.approx(still.floats[0].used, rel=1e-6)


def test_a_taut_line_holds_a_float_at_the_surface() -> None:
    """The instrument mooring in 390 m: it floats, with what its line takes of its lift."""
    found = at_rest(replace(moored(), site=Site(390.0, 0.3, RHO)))
    (afloat,) = found.floats
    assert found.place_of("float")[2] == pytest.approx(390.0, abs=1e-6)
    assert 0.0 < afloat.used < LIFT
    assert found.lines[0].fairlead.vertical_force == pytest.approx(afloat.used, rel=1e-9)


def test_a_buoyant_line_that_lifts_its_float_out_is_refused() -> None:
    """2 N/m over 45 m take a float of 1 kg with them, up from 40 m of water."""
    network = marker(0.2)
    line = Line([replace(RISER, submerged_weight=-2.0)])
    small = replace(network.points[1], submerged_weight=-10.0, mass=1.0)
    own = (replace(network.lines[0], line=line),)
    with pytest.raises(FloatsUpError, match="line 1, or a buoy on it, would float"):
        at_rest(replace(network, points=(network.points[0], small), lines=own))


def test_the_card_says_that_a_float_is_at_the_surface() -> None:
    found = at_rest(marker(1.5, float_height=1.5, mass=100.0))
    said = [str(each.said) for each in (*afloat_on_card(found), *floats_on_card(found))
            if isinstance(each, Text)]  # fmt: skip
    assert any("Afloat, with so much of their buoyancy in use: F, 1.860 kN" in e for e in said)
    assert any("F is 39.145 m above the bed, 39.699 m in still water" in each for each in said)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("drag_normal = 1.3\n", "", "the drag of a current needs it"),
        ("[current]", "[checks]\n[no]", "drag_area"),
        ("drag_coefficient = 0.5\n", "", "drag_coefficient"),
    ],
)
def test_what_cannot_be_is_refused(old: str, new: str, said: str) -> None:
    text = write_case(moored())
    assert old in text
    if new.endswith("[no]"):
        text = text[: text.index("[current]")]
        said = "goes with .current., which is missing"
    else:
        text = text.replace(old, new)
    with pytest.raises(InputError, match=said):
        parse_network(text)


def test_a_file_says_the_current() -> None:
    network = moored()
    assert parse_network(write_case(network)) == network
    with pytest.raises(InputError, match="no body to hold"):
        hold(network)
