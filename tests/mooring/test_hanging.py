"""What hangs from one line: a weight, a sinker on a chain of its own, a free end."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt import Line, Segment
from catopt.constants import STANDARD_GRAVITY as G
from catopt.errors import FloatsUpError, NoEquilibriumError
from catopt.model import Site
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_out import each_line_out
from catopt.mooring.network_rest import LinesAtRest
from tests.campaign.network_check import faults_of_answer


def hung(
    top: float,
    length: float,
    w: float,
    weight: float = 0.0,
    force: tuple[float, float, float] = (0.0, 0.0, 0.0),
    EA: float = 1e7,
    friction: float = 0.0,
) -> LinesAtRest:
    """Hang a line with its end, in 20 m of water, from a height above the bed."""
    points = (
        Point("top", "fairlead", 3.0, -2.0, top),
        Point("end", "joint", submerged_weight=weight, force=force),
    )
    lines = (LineBetween(Line([Segment(length, w, EA=EA)]), "top", "end"),)
    return at_rest(Network(Site(20.0, friction), points, lines))


def riser(force: float) -> Network:
    """Moor a buoy by a riser to a ring with a sinker and three ground chains."""
    anchors = ((60.0, 0.0), (-30.0, 51.96), (-30.0, -51.96))
    points = (
        *(Point(f"A{k}", "anchor", x, y) for k, (x, y) in enumerate(anchors, start=1)),
        Point("ring", "joint"),
        Point("sinker", "joint", submerged_weight=60e3),
        Point("eye", "fairlead", 0.0, 0.0, 14.0, body="buoy"),
    )
    main = Line([Segment(12.0, 1000.0, EA=500e6)])
    own = Line([Segment(3.0, 1000.0, EA=500e6)])
    ground = Line([Segment(62.0, 800.0, EA=400e6)])
    lines = (
        LineBetween(main, "ring", "eye", "main"),
        LineBetween(own, "sinker", "ring", "sinker chain"),
        *(LineBetween(ground, f"A{k}", "ring", f"ground {k}") for k in (1, 2, 3)),
    )
    return Network(Site(15.0), points, lines, bodies=(MooredBody("buoy", force=(force, 0.0)),))


def test_a_weight_hangs_on_a_cable() -> None:
    """30 kgf on 100 m of 0.05 kgf/m: 35 kgf above; stretched by (30 x 100 + 0.05 x 100^2/2)/EA."""
    points = (
        Point("ice", "fairlead", 0.0, 0.0, 200.0),
        Point("weight", "joint", submerged_weight=30.0 * G),
    )
    line = Line([Segment(100.0, 0.05 * G, EA=1e6)])
    found = at_rest(Network(Site(200.0), points, (LineBetween(line, "ice", "weight"),)))
    (cable,) = found.lines
    assert cable.anchor.tension == pytest.approx(343.233, abs=5e-4)
    assert found.place_of("weight")[2] == pytest.approx(200.0 - 100.032, abs=5e-4)
    assert found.place_of("weight")[2] == pytest.approx(100.0 - 3250.0 * G / 1e6, abs=1e-9)


@pytest.mark.parametrize(
    ("force", "ring", "buoy", "tension"),
    [(100e3, 4.611, 10.535, 165.305e3), (400e3, 8.090, 13.329, 462.452e3)],
)
def test_a_sinker_hangs_on_a_chain_of_its_own(
    force: float, ring: float, buoy: float, tension: float
) -> None:
    """By MoorPy 1.3: height of the ring, x of the buoy, tension of the main chain at its eye."""
    found = at_rest(riser(force))
    assert found.place_of("ring")[2] == pytest.approx(ring, abs=5e-4)
    assert found.place_of("eye")[0] == pytest.approx(buoy, abs=5e-4)
    assert found.lines[0].fairlead.tension == pytest.approx(tension, abs=0.5)
    x, y, z = found.place_of("ring")
    # 60 kN on 3 m: stretched by 3 x (60 + 1.5) kN / 500 MN.
    below = 3.0 * (1.0 + 61.5e3 / 500e6)
    assert found.place_of("sinker") == pytest.approx((x, y, z - below), abs=1e-9)
    assert faults_of_answer(found) == []


def test_what_hangs_is_not_loose_when_another_line_is_gone() -> None:
    main, own, *ground = each_line_out(riser(100e3))
    assert "buoy" in main.refusal
    assert own.loose_lines == ()
    assert own.rest is not None
    assert own.rest.place_of("ring")[2] > 4.611
    for each in ground:
        assert each.loose_lines == ()
        assert each.rest is not None
        assert "sinker" in {point.of.name for point in each.rest.points}


def test_a_weight_that_comes_to_the_bed_lies_there() -> None:
    found = hung(15.0, 30.0, 50.0, 2e3)
    _, end = found.points
    assert end.place == (3.0, -2.0, 0.0)
    assert end.bed_reaction == 2e3
    (chain,) = found.lines
    # 15 m hang, less what 50 N/m x 15 m stretches them by on the average.
    assert chain.anchor.tension == pytest.approx(750.0, rel=50.0 * 15.0 / 1e7)
    assert chain.grounded_length == pytest.approx(15.0, abs=1e-3)
    with pytest.raises(NoEquilibriumError, match="joint end comes to rest on the bed"):
        hung(15.0, 30.0, 50.0, 2e3, friction=0.5)


def test_a_weight_pulled_aside_hangs_on_a_catenary() -> None:
    """H = 500 N; V is 2000 N below and 2500 N above; the curve is that of a catenary, stiff."""
    found = hung(15.0, 10.0, 50.0, 2e3, (500.0, 0.0, 0.0), EA=1e12)
    x, y, z = found.place_of("end")
    a = 500.0 / 50.0
    aside = a * (math.asinh(5.0) - math.asinh(4.0))
    below = (math.hypot(500.0, 2500.0) - math.hypot(500.0, 2000.0)) / 50.0
    assert (x, y, z) == pytest.approx((3.0 + aside, -2.0, 15.0 - below), abs=1e-6)


def test_a_chain_hangs_over_the_side() -> None:
    found = hung(20.0, 12.0, 100.0, EA=1e6)
    (chain,) = found.lines
    assert chain.anchor.tension == pytest.approx(1200.0, abs=1e-6)
    assert chain.fairlead.tension == pytest.approx(0.0, abs=1e-6)
    stretch = 100.0 * 12.0**2 / 2.0 / 1e6
    assert found.place_of("end") == pytest.approx((3.0, -2.0, 8.0 - stretch), abs=1e-8)


@pytest.mark.parametrize("friction", [0.0, 0.6])
def test_what_is_longer_than_the_water_is_deep_lies_on_the_bed(friction: float) -> None:
    """Slack, it rubs on nothing."""
    found = hung(20.0, 50.0, 100.0, friction=friction)
    (chain,) = found.lines
    assert chain.anchor.tension == pytest.approx(2000.0, rel=2000.0 / 1e7)
    assert chain.grounded_length == pytest.approx(30.0, abs=20.0 * 2000.0 / 1e7)
    assert found.place_of("end")[2] == 0.0


def test_a_buoyant_line_stands_on_its_anchor() -> None:
    points = (Point("anchor", "anchor", 0.0, 0.0), Point("end", "joint"))
    lines = (LineBetween(Line([Segment(10.0, -100.0, EA=1e6)]), "anchor", "end"),)
    network = Network(Site(30.0), points, lines)
    found = at_rest(network)
    assert found.lines[0].anchor.tension == pytest.approx(1000.0, abs=1e-6)
    assert found.place_of("end")[2] == pytest.approx(10.0 + 100.0 * 10.0**2 / 2e6, abs=1e-8)
    with pytest.raises(FloatsUpError, match=r"line 1, .* 2\.005 m above the water surface"):
        at_rest(replace(network, site=Site(8.0)))
