"""Lines between points in a current: by hand, by another integration, and where nothing flows."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from catopt import InputError, Line, PointLoad, Segment
from catopt.constants import STANDARD_GRAVITY as G
from catopt.model import Site
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.model.sea import CurrentProfile
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_rest import LinesInCurrent
from catopt.mooring.restoring import unloaded
from tests.campaign.current_check import faults_in_current, judge_in_current

RHO = 1025.0
ROPE = Segment(60.0, 2.0, EA=2e6, drag_diameter=0.02, drag_normal=1.2, drag_axial=0.02)
CHAIN = Segment(30.0, 60.0, EA=2e7, drag_diameter=0.04, drag_normal=2.4, drag_axial=1.1)


def flowing(speed: float, direction: float = 0.0, depth: float = 40.0) -> CurrentProfile:
    return CurrentProfile(
        "table", depths=(0.0, depth), speeds=(speed, 0.5 * speed), direction=direction
    )


def hanging(current: CurrentProfile | None, **own: Any) -> LinesInCurrent:
    """Hang a weight of 30 kgf on a cable of 100 m below the ice, in 200 m."""
    points = (
        Point("ice", "fairlead", 0.0, 0.0, 200.0),
        Point("weight", "joint", submerged_weight=30.0 * G, **own),
    )
    cable = Segment(100.0, 0.05 * G, EA=1e6, drag_diameter=0.006, drag_normal=1.3)
    lines = (LineBetween(Line([cable]), "ice", "weight"),)
    found = at_rest(Network(Site(200.0, 0.0, RHO), points, lines, current=current))
    assert isinstance(found, LinesInCurrent)
    return found


def vee(current: CurrentProfile | None, force: float = 0.0) -> Network:
    """Hold a float under water, with a weight below it, on two legs of chain and rope."""
    points = (
        Point("west", "anchor", -60.0, 0.0),
        Point("east", "anchor", 60.0, 0.0),
        Point("float", "joint", submerged_weight=-3e3, force=(0.0, force, 0.0)),
        Point("meter", "joint", submerged_weight=200.0),
    )
    leg = Line([CHAIN, replace(ROPE, length=40.0)], [PointLoad(45.0, -50.0)])
    lines = (
        LineBetween(leg, "west", "float", "west leg"),
        LineBetween(leg, "east", "float", "east leg"),
        LineBetween(Line([replace(ROPE, length=8.0)]), "float", "meter", "below"),
    )
    return Network(Site(40.0, 0.0, RHO), points, lines, current=current)


def buoy(current: CurrentProfile | None) -> Network:
    """Moor a data buoy by a riser to a ring, on three legs with floats of their own."""
    ends = [(70.0 * math.cos(k * math.tau / 3.0), 70.0 * math.sin(k * math.tau / 3.0))
            for k in range(3)]  # fmt: skip
    points = (
        *(Point(f"A{k}", "anchor", x, y) for k, (x, y) in enumerate(ends)),
        *(Point(f"float {k}", "joint", submerged_weight=-2e3, mass=20.0) for k in range(3)),
        Point("eye", "fairlead", 0.0, 0.0, 29.0, body="buoy"),
    )
    leg = Line([replace(CHAIN, length=40.0), replace(ROPE, length=30.0)])
    across = Line([replace(ROPE, length=28.0)])
    lines = (
        *(LineBetween(leg, f"A{k}", f"float {k}") for k in range(3)),
        *(LineBetween(across, f"float {k}", "eye") for k in range(3)),
    )
    body = MooredBody("buoy", force=(500.0, 200.0))
    return Network(Site(30.0, 0.4, RHO), points, lines, bodies=(body,), current=current)


def test_a_weight_streams_on_its_cable() -> None:
    """By integration and shooting with scipy: 16.898 m downstream, 98.267 m below, 342.437 N."""
    steady = CurrentProfile("table", depths=(0.0, 200.0), speeds=(0.5, 0.5))
    found = hanging(steady, drag_area=0.05, drag_coefficient=1.0)
    x, y, z = found.place_of("weight")
    assert (x, y, 200.0 - z) == pytest.approx((16.898, 0.0, 98.267), abs=5e-4)
    assert found.lines[0].anchor.tension == pytest.approx(342.437, abs=5e-4)
    # At its end the cable carries the weight and the drag of that alone.
    drag = 0.5 * RHO * 0.05 * 0.5**2
    assert found.lines[0].fairlead.tension == pytest.approx(math.hypot(30.0 * G, drag), rel=1e-9)
    assert found.still_places[1][2] == pytest.approx(200.0 - 100.032, abs=5e-4)
    assert [*faults_in_current(found)] == []


@pytest.mark.parametrize("network", [vee, pytest.param(buoy, marks=pytest.mark.slow)])
def test_where_nothing_flows_all_is_as_in_still_water(network: Any) -> None:
    calm, still = at_rest(network(flowing(0.0))), at_rest(network(None))
    for one, other in zip(calm.joints.places, still.joints.places, strict=True):
        assert one == pytest.approx(other, abs=1e-4)
    for line, same in zip(calm.lines, still.lines, strict=True):
        assert line.fairlead.tension == pytest.approx(same.fairlead.tension, rel=1e-5)
        assert line.grounded_length == pytest.approx(same.grounded_length, abs=1e-3)


@pytest.mark.parametrize("direction", [0.7])
def test_a_float_on_two_legs_balances_in_a_current(direction: float) -> None:
    found = at_rest(vee(flowing(0.6, direction)))
    assert isinstance(found, LinesInCurrent)
    assert [*faults_in_current(found)] == []
    x, y, _ = found.place_of("float")
    assert x * math.cos(direction) + y * math.sin(direction) > 0.0


@pytest.mark.slow
def test_a_buoy_with_floats_balances_in_a_current() -> None:
    network = buoy(flowing(0.5, 0.4, 30.0))
    found = at_rest(network)
    assert isinstance(found, LinesInCurrent)
    assert [*faults_in_current(found)] == []
    (moored,) = found.bodies
    # From where it is in still water without its load.
    (still,) = at_rest(buoy(None).unloaded()).bodies
    assert moored.offset == pytest.approx(
        (moored.position.x - still.position.x, moored.position.y - still.position.y), abs=1e-6
    )
    assert math.hypot(*moored.offset) > math.hypot(*at_rest(buoy(None)).bodies[0].offset)


@pytest.mark.slow
def test_stiffness_in_a_current_is_of_differences() -> None:
    network = buoy(flowing(0.5, 0.4, 30.0))
    (body,) = at_rest(network).bodies
    step = 2.0
    moved = []
    for x, y in ((500.0 + step, 200.0), (500.0, 200.0 + step)):
        loaded = (MooredBody("buoy", force=(x, y)),)
        (other,) = at_rest(replace(network, bodies=loaded)).bodies
        ways = (other.position.x - body.position.x, other.position.y - body.position.y)
        moved.append([way / step for way in ways])
    (a, b), (c, d) = (row[:2] for row in body.stiffness[:2])
    size = a * d - b * c
    inverse = ((d / size, -b / size), (-c / size, a / size))
    for i in (0, 1):
        assert moved[i] == pytest.approx([inverse[0][i], inverse[1][i]], rel=2e-2, abs=2e-5)


def test_what_is_not_solved_in_a_current_is_refused() -> None:
    with pytest.raises(InputError, match="solved under its own load alone"):
        unloaded(buoy(flowing(0.5, 0.0, 30.0)), "curve")
    bare = vee(None)
    leg = replace(bare.lines[0], line=Line([replace(CHAIN, drag_normal=None)]))
    with pytest.raises(InputError, match="the drag of a current needs it"):
        replace(bare, lines=(leg, *bare.lines[1:]), current=flowing(0.5))


@pytest.mark.slow
@pytest.mark.parametrize("seed", [8, 13, 18, 28])
def test_random_networks_balance_in_a_current(seed: int) -> None:
    assert judge_in_current(seed) == ("answered", [])
