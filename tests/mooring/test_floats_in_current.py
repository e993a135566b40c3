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
from catopt.casefile.reading import parse_network
from catopt.casefile.writing import write_case
from catopt.checks.system import check_network
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


def test_a_float_above_the_water_is_refused() -> None:
    short = replace(moored(), site=Site(390.0, 0.3, RHO))
    with pytest.raises(FloatsUpError, match=r"float float would be 5\.69\d* m above the water"):
        at_rest(short)


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
