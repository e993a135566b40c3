"""Floats at the surface: partly wet there, or under water with all their buoyancy."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from catopt import InputError, Line, Segment
from catopt.answers.floats import afloat_on_card
from catopt.casefile.reading import parse_network
from catopt.casefile.writing import write_case
from catopt.constants import STANDARD_GRAVITY as G
from catopt.errors import FloatsUpError
from catopt.model import Site
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.mooring.fixed_body import at_rest, hold
from catopt.mooring.many import solve_network_many
from catopt.mooring.network_rest import LinesAtRest
from catopt.verify.case import verify_network

CHAIN = Segment(6.0, 4.0 * G, EA=20e6)
ROPE = 0.02 * G


def lake_buoy(force: float = 300.0, **marker: Any) -> Network:
    """Moor a data buoy between two marker floats, each on its own line to a chain and anchor."""
    leg = Line([CHAIN, Segment(12.0, ROPE, EA=200e3)])
    across = Line([Segment(26.0, ROPE, EA=200e3)])
    points = (
        Point("anchor west", "anchor", -40.0, 0.0),
        Point("anchor east", "anchor", 40.0, 0.0),
        Point("marker west", "joint", submerged_weight=-120.0 * G, **marker),
        Point("marker east", "joint", submerged_weight=-120.0 * G, **marker),
        Point("eye west", "fairlead", -0.5, 0.0, 11.5, body="buoy"),
        Point("eye east", "fairlead", 0.5, 0.0, 11.5, body="buoy"),
    )
    lines = (
        LineBetween(leg, "anchor west", "marker west"),
        LineBetween(leg, "anchor east", "marker east"),
        LineBetween(across, "marker west", "eye west"),
        LineBetween(across, "marker east", "eye east"),
    )
    body = MooredBody("buoy", force=(force, 0.0))
    return Network(Site(12.0), points, lines, bodies=(body,))


def plumb(depth: float, length: float, lift: float, w: float = 1e-3, **own: Any) -> Network:
    """Moor a float straight over its anchor."""
    points = (
        Point("anchor", "anchor", 0.0, 0.0),
        Point("float", "joint", submerged_weight=-lift, **own),
    )
    line = LineBetween(Line([Segment(length, w, EA=1e6)]), "anchor", "float")
    return Network(Site(depth), points, (line,))


def used(found: LinesAtRest) -> list[float]:
    return [each.used for each in found.floats]


def test_a_lake_buoy_between_two_marker_floats() -> None:
    # MoorPy 1.3.0, markers held at the surface and free in x and y, the body's x sought: offset
    # 0.06589 m; 1070.25 and 672.22 N at the markers, which carry 735.95 + 17.44 = 753.39 and
    # 473.61 + 11.70 = 485.31 N.
    found = at_rest(lake_buoy())
    (body,) = found.bodies
    assert body.offset[0] == pytest.approx(0.06589, abs=6e-6)
    west, east, *_ = found.lines
    assert west.fairlead.tension == pytest.approx(1070.25, abs=6e-3)
    assert east.fairlead.tension == pytest.approx(672.22, abs=6e-3)
    assert used(found) == pytest.approx([753.39, 485.31], abs=0.011)
    assert [each.under for each in found.floats] == [0.0, 0.0]
    assert [found.place_of(name)[2] for name in ("marker west", "marker east")] == [12.0, 12.0]


def test_a_float_that_is_pulled_under_has_all_its_buoyancy_in_use() -> None:
    found = at_rest(lake_buoy(3000.0))
    west, east = found.floats
    z = found.place_of("marker west")[2]
    assert west.under == pytest.approx(12.0 - z)
    assert west.under > 3.0
    assert (west.used, west.left) == (120.0 * G, 0.0)
    assert east.under == 0.0
    # What is used is what the lines that end there pull down with.
    down = found.lines[1].fairlead.vertical_force - found.lines[3].anchor.vertical_force
    assert east.used == pytest.approx(down, abs=1e-6)


def test_a_held_body_and_many_loads_have_floats_at_the_surface_too() -> None:
    network = lake_buoy()
    alone = at_rest(network)
    held = hold(network, (alone.bodies[0].position.x, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert used(held) == pytest.approx(used(alone), abs=1e-6)
    assert held.body.load[0] == pytest.approx(-300.0, abs=1e-6)
    forces = np.array([[[300.0, 0.0, 0.0]], [[3000.0, 0.0, 0.0]], [[0.0, 200.0, 0.0]]])
    many = solve_network_many(network, force=forces)
    assert not many.reasons
    for k, (x, y, _) in enumerate(forces[:, 0].tolist()):
        body = MooredBody("buoy", force=(x, y))
        (single,) = at_rest(replace(network, bodies=(body,))).bodies
        assert many.offset[k, 0] == pytest.approx(single.offset, abs=1e-7)


def test_stiffness_has_floats_follow_along_the_surface() -> None:
    network = lake_buoy()
    step = 1e-4
    (body,) = at_rest(network).bodies
    follows = np.linalg.inv(body.stiffness)[:2, :2]
    moved = []
    for x, y in ((300.0 + step, 0.0), (300.0, step)):
        (other,) = at_rest(replace(network, bodies=(MooredBody("buoy", force=(x, y)),))).bodies
        moved.append(np.subtract(other.offset, body.offset) / step)
    assert follows == pytest.approx(np.array(moved).T, rel=1e-4, abs=1e-8)


def test_a_taut_line_uses_what_it_is_stretched_by() -> None:
    # 9.9 m of 1 MN stretched to the surface at 10 m, its own weight of 9.9 mN negligible.
    tension = 1e6 * 0.1 / 9.9
    found = at_rest(plumb(10.0, 9.9, 12e3))
    assert used(found) == pytest.approx([tension], abs=0.011)
    assert found.place_of("float")[2] == 10.0
    # With less buoyancy than that it is under: by what it does not stretch the line.
    (below,) = at_rest(plumb(10.0, 9.9, 8e3)).floats
    assert below.under == pytest.approx(0.1 - 9.9 * 8e3 / 1e6, abs=1e-6)


def test_a_slack_line_uses_what_it_lifts_of_itself() -> None:
    w, depth = 50.0, 10.0
    (afloat,) = at_rest(plumb(depth, 30.0, 2e3, w)).floats
    # w z hangs, stretched by w z^2 / 2 EA, so that less than the depth hangs unstretched.
    assert afloat.used == pytest.approx(w * depth, rel=w * depth / 1e6)


def test_a_float_with_a_height_has_a_draught() -> None:
    """Weight W, lift B and what hangs, w (d - t), balance at a draught t: (B + W) t / h."""
    w, depth, lift, mass, height = 50.0, 10.0, 2e3, 40.0, 0.6
    found = at_rest(plumb(depth, 30.0, lift, w, mass=mass, float_height=height))
    weight = mass * G
    draught = (weight + w * depth) / ((lift + weight) / height + w)
    (afloat,) = found.floats
    assert afloat.draught == pytest.approx(draught, rel=w * depth / 1e6)
    assert afloat.freeboard == pytest.approx(height - draught, rel=1e-3)
    assert found.place_of("float")[2] == pytest.approx(depth - draught, abs=1e-4)
    assert afloat.used == pytest.approx(w * (depth - draught), rel=1e-3)
    # Too heavy a line draws it under, where its draught is its height.
    (sunk,) = at_rest(plumb(depth, 30.0, 200.0, w, mass=mass, float_height=height)).floats
    assert (sunk.draught, sunk.used) == (height, 200.0)
    assert sunk.under == pytest.approx(depth - height - 200.0 / w, rel=1e-3)


def lifted(**own: Any) -> Network:
    """Put a float on the way of a line to a quay above the water."""
    points = (
        Point("anchor", "anchor", 0.0, 0.0),
        Point("float", "joint", submerged_weight=-500.0, **own),
        Point("quay", "fairlead", 30.0, 0.0, 14.0),
    )
    rope = Line([Segment(16.56, 1.0, EA=1e6)])
    lines = (LineBetween(rope, "anchor", "float"), LineBetween(rope, "float", "quay"))
    return Network(Site(6.0), points, lines)


def test_a_float_that_lines_lift_weighs_what_it_does_in_air() -> None:
    with pytest.raises(FloatsUpError, match=r"lift float float out of the water.*its mass"):
        at_rest(lifted())
    found = at_rest(lifted(mass=20.0))
    (up,) = found.floats
    assert found.place_of("float")[2] > 6.0
    assert up.used == pytest.approx(-20.0 * G)
    (said,) = afloat_on_card(found)
    assert "float, none, lifted with 0.196 kN" in f"{said.said}"


def test_the_truss_agrees() -> None:
    compared = verify_network(lake_buoy(), elements=64, tolerance=1e-2)
    assert compared.verdict == "agrees"


def test_a_file_says_the_height_of_a_float() -> None:
    network = lake_buoy(mass=15.0, float_height=0.4)
    assert parse_network(write_case(network)) == network
    text = write_case(network)
    with pytest.raises(InputError, match="needs its mass"):
        parse_network(text.replace('mass = "15.0 kg"\n', ""))
    heavy = text.replace('submerged_weight = "-1176.798 N"', 'submerged_weight = "100 N"')
    with pytest.raises(InputError, match="submerged_weight below 0, a float"):
        parse_network(heavy)


def test_what_floats_pulls_less_as_it_comes_up() -> None:
    """Over ten micrometres of height the answer is that of a flat float, but for that height."""
    flat, high = at_rest(lake_buoy()), at_rest(lake_buoy(mass=1.0, float_height=1e-5))
    assert used(high) == pytest.approx(used(flat), rel=5e-5)
    assert math.isclose(high.bodies[0].offset[0], flat.bodies[0].offset[0], rel_tol=1e-4)
