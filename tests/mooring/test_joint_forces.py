"""Joints that a force pulls, and floats that end one line: by hand and by straight springs."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt import InputError, Line, PointLoad, Segment
from catopt.casefile.reading import parse_network
from catopt.casefile.writing import write_case
from catopt.model import Site
from catopt.model.network import LineBetween, Network, Point
from catopt.mooring.fixed_body import hold

DEPTH = 500.0


def moored_float(
    *, lift: float = 6e3, force: tuple[float, float, float] = (0.0, 0.0, 0.0), weight: float = 2.0
) -> Network:
    """Hold a float by one line of 400 m and 4 MN, anchored in 500 m of water."""
    points = [
        Point("anchor", "anchor", 0.0, 0.0, 0.0),
        Point("float", "joint", submerged_weight=-lift, force=force),
    ]
    line = Line([Segment(400.0, weight, EA=4e6)])
    return Network(Site(DEPTH), tuple(points), (LineBetween(line, "anchor", "float"),))


def test_a_float_stands_over_its_anchor() -> None:
    # 6 kN at the float, 400 m x 2 N/m less at the anchor; stretched by the mean tension, 5.6 kN:
    # 400 m x 5.6 kN / 4 MN = 0.56 m.
    found = hold(moored_float())
    (line,) = found.lines
    assert found.place_of("float") == pytest.approx((0.0, 0.0, 400.56), abs=1e-6)
    assert line.fairlead.tension == pytest.approx(6000.0, rel=1e-12)
    assert line.anchor.tension == pytest.approx(5200.0, rel=1e-12)


def test_a_float_that_is_pulled_aside_hangs_on_a_catenary() -> None:
    # H = 1.5 kN and V = 6 kN at its upper end, V = 5.2 kN at the anchor: the elastic catenary.
    H, high, low, w, EA = 1500.0, 6e3, 5.2e3, 2.0, 4e6
    found = hold(moored_float(force=(900.0, 1200.0, 0.0)))
    x, y, z = found.place_of("float")
    span = H / w * (math.asinh(high / H) - math.asinh(low / H)) + H * 400.0 / EA
    tensions = math.hypot(H, high), math.hypot(H, low)
    height = (tensions[0] - tensions[1]) / w + (high**2 - low**2) / (2.0 * w * EA)
    assert (x, y) == pytest.approx((0.6 * span, 0.8 * span), rel=1e-9)
    assert z == pytest.approx(height, rel=1e-9)


def test_a_force_counts_as_the_buoyancy_that_pulls_as_much() -> None:
    lifted = hold(moored_float(lift=0.0, force=(0.0, 0.0, 6e3)))
    assert lifted.place_of("float") == pytest.approx(hold(moored_float()).place_of("float"))


def test_a_row_of_lines_and_a_buoy_ends_in_a_float() -> None:
    # Two lines and a buoy of 1 kN between: 6, 7 kN less the weight of 200 m each at 2 N/m; the mean
    # tensions are 5.8 and 6.4 kN, so the float stands 400 m + 200 m (5.8 + 6.4) kN / 4 MN high.
    points = [
        Point("anchor", "anchor", 0.0, 0.0, 0.0),
        Point("buoy", "joint", submerged_weight=-1e3),
        Point("float", "joint", submerged_weight=-6e3),
    ]
    line = Line([Segment(200.0, 2.0, EA=4e6)])
    lines = [LineBetween(line, "anchor", "buoy"), LineBetween(line, "buoy", "float")]
    found = hold(Network(Site(DEPTH), tuple(points), tuple(lines)))
    assert found.place_of("float") == pytest.approx((0.0, 0.0, 400.61), abs=1e-6)


@pytest.mark.parametrize("seed", range(10))
def test_springs_balance_the_force_at_a_joint(seed: int) -> None:
    # Ropes of hardly any weight, pulled taut, are straight springs, whose pulls are summed here.
    random = np.random.default_rng(seed)
    anchors = [(100.0 * math.cos(a), 100.0 * math.sin(a), 50.0) for a in (0.3, 2.2, 4.5)]
    lengths = random.uniform(80.0, 99.0, 3)
    force = random.uniform(-3e4, 3e4, 3)
    EA = 3e6

    def left(place: np.ndarray) -> np.ndarray:
        total = np.array(force)
        for anchor, length in zip(anchors, lengths, strict=True):
            way = np.array(anchor) - place
            far = math.hypot(*way)
            total += EA * max(far / length - 1.0, 0.0) * way / far
        return total

    points = [Point(f"{k}", "anchor", *each) for k, each in enumerate(anchors)]
    points.append(Point("joint", "joint", force=tuple(force)))
    lines = [
        LineBetween(Line([Segment(length, 1e-5, EA=EA)]), f"{k}", "joint")
        for k, length in enumerate(lengths)
    ]
    found = hold(Network(Site(200.0), tuple(points), tuple(lines)))
    place = np.array(found.place_of("joint"))
    assert max(abs(left(place))) < 1e-3 * max(abs(force))


def test_two_lines_and_a_force_are_not_one_line() -> None:
    # 3-4-5 on either side: pulled down by 8 kN 3 m below the ends, aside by 3 kN along the chord.
    points = [
        Point("left", "anchor", -4.0, 0.0, 10.0),
        Point("right", "anchor", 4.0, 0.0, 10.0),
        Point("joint", "joint", force=(0.0, 0.0, -6e3)),
    ]
    lines = [
        LineBetween(Line([Segment(5.0, 1e-4, EA=1e9)]), end, "joint") for end in ("left", "right")
    ]
    found = hold(Network(Site(20.0), tuple(points), tuple(lines)))
    assert found.place_of("joint") == pytest.approx((0.0, 0.0, 7.0), abs=1e-4)
    for line in found.lines:
        assert line.fairlead.tension == pytest.approx(5e3, rel=1e-5)


FILE = """
[site]
water_depth = "500 m"
[[points]]
name = "anchor"
kind = "anchor"
x = 0
y = 0
height = 0
[[points]]
name = "float"
kind = "joint"
submerged_weight = "-6 kN"
force = ["1.5 kN", "0 N", "0 N"]
[[lines]]
start = "anchor"
end = "float"
[[lines.segments]]
length = "400 m"
submerged_weight = "2 N/m"
EA = "4 MN"
"""


def test_a_file_says_the_force() -> None:
    read = parse_network(FILE)
    assert read.points[1].hung == (1500.0, 0.0, 6000.0)
    assert parse_network(write_case(read)) == read


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"1.5 kN", "0 N", "0 N"', '"1.5 kN", "0 N"', "force"),
        ("height = 0", 'height = 0\nforce = ["1 kN", "0 N", "0 N"]', "affects only a joint"),
    ],
)
def test_what_cannot_be_is_refused(old: str, new: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        parse_network(FILE.replace(old, new, 1))


def test_a_float_on_a_line_with_a_clump_weight() -> None:
    # 2 kN hang in the middle: 6 kN less 0.4 kN above it, 3.6 and 3.2 kN below.
    network = moored_float()
    line = Line(network.lines[0].line.segments, [PointLoad(200.0, 2e3)])
    found = hold(Network(network.site, network.points, (LineBetween(line, "anchor", "float"),)))
    stretch = 200.0 * (5.8e3 + 3.4e3) / 4e6
    assert found.place_of("float") == pytest.approx((0.0, 0.0, 400.0 + stretch), abs=1e-6)
