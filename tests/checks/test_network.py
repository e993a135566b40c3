"""Checks of lines between points: by hand, with all lines there and each out in turn."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from catopt import InputError, Line, Segment
from catopt.casefile.reading import parse_network
from catopt.casefile.writing import write_case
from catopt.checks.result import CheckReport, CheckResult
from catopt.checks.system import check_network
from catopt.errors import NotConvergedError
from catopt.model import Anchor, Checks, Service, Site
from catopt.model.network import LineBetween, Network, Point
from catopt.mooring import network_out
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_out import each_line_out
from catopt.mooring.network_rest import LinesAtRest


def rope(length: float = 5.0, MBL: float | None = 40e3) -> Line:
    """Make a rope of hardly any weight that hardly stretches."""
    return Line([Segment(length, 1e-4, EA=1e9, MBL=MBL)])


def hung(checks: Checks) -> Network:
    """Hang 6 kN by a force between ends 4 m to either side, 3 m higher: 3-4-5, each at 5 kN.

    A force that is not straight down is no weight that may lie on the bed: it holds a joint that
    one line is left of, too.
    """
    points = [
        Point("left", "fairlead", -4.0, 0.0, 10.0),
        Point("right", "fairlead", 4.0, 0.0, 10.0),
        Point("joint", "joint", force=(0.0, 1e-6, -6e3)),
    ]
    between = [
        LineBetween(rope(), "left", "joint"),
        LineBetween(rope(), "right", "joint"),
    ]
    return Network(Site(20.0), points, between, checks=checks)  # type: ignore[arg-type]


def of(
    report: CheckReport, kind: str, *, line: int | None = None, missing: int | None = None
) -> list[CheckResult]:
    return [
        each
        for each in report.results
        if each.kind == kind and each.place.line == line and each.place.missing == missing
    ]


def test_the_tension_of_every_line_is_checked() -> None:
    report = check_network(hung(Checks(safety_factor=2.0)))
    for line in (1, 2):
        (found,) = of(report, "tension", line=line)
        assert (found.demand, found.capacity) == pytest.approx((5e3, 20e3), rel=1e-5)
        assert found.utilisation == pytest.approx(0.25, rel=1e-5)
    assert not check_network(hung(Checks(safety_factor=9.0))).passes
    assert [name for name, _ in report.solutions][:2] == ["line 1, intact", "line 2, intact"]


def test_what_is_left_carries_all_when_a_line_is_lost() -> None:
    # The joint then hangs plumb below the other end: 6 kN of 40 kN by a factor of 1.25.
    checks = Checks(safety_factor=2.0, safety_factor_line_out=1.25)
    report = check_network(hung(checks))
    for line, missing in ((2, 1), (1, 2)):
        (found,) = of(report, "tension", line=line, missing=missing)
        assert (found.demand, found.capacity) == pytest.approx((6e3, 32e3), rel=1e-5)
    assert "the body is held in place" in "\n".join(report.warnings)
    assert not of(report, "equilibrium", missing=1)


def test_a_line_out_that_does_not_converge_fails_and_the_others_are_answered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    checks = Checks(safety_factor=2.0, safety_factor_line_out=1.25)
    converged = at_rest

    def stops_without_the_left_line(network: Network) -> LinesAtRest:
        if [line.start for line in network.lines] == ["right"]:
            raise NotConvergedError("stopped short")
        return converged(network)

    monkeypatch.setattr(network_out, "at_rest", stops_without_the_left_line)
    report = check_network(hung(checks))
    assert not report.passes
    (lost,) = of(report, "equilibrium", missing=1)
    assert lost.note == "stopped short"
    (found,) = of(report, "tension", line=1, missing=2)
    assert found.demand == pytest.approx(6e3, rel=1e-5)
    assert "Without line 1 no equilibrium was found" in "\n".join(report.warnings)


def leg(**own: object) -> Network:
    """Anchor a chain of 220 m that goes on in two ropes from a joint; they hold a body."""
    points = [
        Point("anchor", "anchor", 250.0, 0.0, 0.0),
        Point("joint", "joint", submerged_weight=2e3),
        Point("port", "fairlead", 10.0, 8.0, 45.0),
        Point("starboard", "fairlead", 10.0, -8.0, 45.0),
    ]
    chain = Line(
        [
            Segment(50.0, 600.0, EA=400e6, MBL=3e6, name="upper"),
            Segment(170.0, 1200.0, EA=600e6, MBL=4.5e6, name="lower"),
        ]
    )
    ropes = Line([Segment(40.0, 60.0, EA=40e6, MBL=1.2e6)])
    lines = [
        LineBetween(chain, "joint", "anchor"),  # given from above
        LineBetween(ropes, "joint", "port"),
        LineBetween(ropes, "joint", "starboard"),
    ]
    return Network(Site(50.0), points, lines, **own)  # type: ignore[arg-type]


CHECKS = Checks(
    safety_factor=2.0,
    safety_factor_line_out=1.25,
    max_anchor_uplift_angle=math.radians(1.0),
    min_grounded_length=100.0,
)
ANCHOR = Anchor("drag", holding_capacity=60e3, safety_factor=1.5, safety_factor_line_out=1.0)


def test_an_anchor_is_judged_where_a_line_ends_at_one() -> None:
    report = check_network(leg(checks=CHECKS, anchor=ANCHOR))
    (holding,) = of(report, "holding", line=1)
    (lies,) = of(report, "grounded_length", line=1)
    assert {each.place.line for each in report.results if each.kind != "tension"} == {1}
    # The bed of no friction: the pull on the anchor is the horizontal force of the two ropes.
    ropes = [solution for name, solution in report.solutions[1:3]]
    pulled = sum(each.horizontal_force * math.sqrt(1.0 - (8.0 / each.span) ** 2) for each in ropes)
    assert holding.demand == pytest.approx(pulled, rel=1e-6)
    assert holding.capacity == pytest.approx(40e3)
    # What does not lie hangs from the joint, with the weight of the pull there: V = w L.
    above = report.solutions[0][1].fairlead.vertical_force
    hangs = 50.0 + (above - 50.0 * 600.0) / 1200.0 if above > 30e3 else above / 600.0
    assert lies.capacity == pytest.approx(220.0 - hangs, abs=0.05)
    (upper,) = [each for each in of(report, "tension", line=1) if each.place.segment == 2]
    assert "upper" in str(upper.name)  # segments are counted from the anchor
    assert upper.capacity == pytest.approx(1.5e6)


def test_a_leg_of_two_lines_hangs_loose_when_one_is_lost() -> None:
    points = [
        Point("anchor", "anchor", 100.0, 0.0, 0.0),
        Point("link", "joint"),
        Point("joint", "joint", submerged_weight=-8e3),
        Point("bow", "fairlead", 0.0, 0.0, 10.0),
    ]
    chain, line = Line([Segment(60.0, 200.0, EA=9e7, MBL=1e6)]), rope(42.0, 1e6)
    lines = [
        LineBetween(chain, "anchor", "link"),
        LineBetween(chain, "link", "joint"),
        LineBetween(line, "joint", "bow"),
    ]
    network = Network(
        Site(60.0), tuple(points), tuple(lines), checks=Checks(safety_factor_line_out=1.0)
    )
    first, second, third = each_line_out(network)
    # The 12 kN of the second chain sink the buoy of 8 kN: nothing holds the body.
    assert (first.left, first.loose, first.rest) == ((), (1, 2), None)
    assert first.refusal == "no line is left"
    assert (second.left, second.loose) == ((2,), (0,))
    # 8 kN up, the rope has no weight: it stands plumb on the bow.
    assert second.rest is not None
    assert second.rest.lines[0].fairlead.tension == pytest.approx(8e3, rel=1e-4)
    assert (third.left, third.loose) == ((0, 1), ())
    said = "\n".join(check_network(network).warnings)
    assert "with line 2 out, lines 1 hang loose" in said


def test_a_float_that_no_line_holds_is_adrift() -> None:
    points = [
        Point("anchor", "anchor", 0.0, 0.0, 0.0),
        Point("float", "joint", submerged_weight=-6e3),
        Point("cage", "joint", force=(1e3, 0.0, 500.0)),
    ]
    line = Line([Segment(40.0, 2.0, EA=4e6, MBL=50e3)])
    lines = [LineBetween(line, "anchor", "float"), LineBetween(line, "float", "cage")]
    checks = Checks(safety_factor_line_out=1.0)
    report = check_network(Network(Site(100.0), tuple(points), tuple(lines), checks=checks))
    (lost,) = of(report, "equilibrium", missing=1)
    assert not lost.passes
    assert "no line holds float, cage any more" in str(lost.note)
    (lost,) = of(report, "equilibrium", missing=2)
    assert "no line holds cage any more" in str(lost.note)


@pytest.mark.parametrize(
    ("network", "said"),
    [
        (lambda: leg(checks=Checks(max_span=300.0)), "checks.max_span"),
        (lambda: leg(checks=Checks(motion_code="API-RP-2SK")), "checks.motion_code"),
        (
            lambda: check_network(leg(anchor=Anchor("drag", holding_capacity=1e5))),
            "anchor.safety_factor",
        ),
        (
            lambda: check_network(leg(service=Service(3e8, 1e-11), checks=CHECKS)),
            r"lines\[0\].segments\[1\]",
        ),
        (
            lambda: Network(
                Site(50.0),
                (Point("a", "anchor", 0.0, 0.0, 0.0), Point("b", "anchor", 9.0, 0.0, 0.0)),
                (LineBetween(rope(10.0), "a", "b"), LineBetween(rope(11.0), "a", "b")),
                anchor=ANCHOR,
            ),
            "lines 1, 2 at a",
        ),
    ],
)
def test_what_cannot_be_judged_is_refused(network: Callable[[], object], said: str) -> None:
    with pytest.raises(InputError, match=said):
        network()


FILE = """
[site]
water_depth = "60 m"
[checks]
code = "API-RP-2SK"
max_anchor_uplift_force = "10 kN"
[anchor]
kind = "sinker"
mass = "12 t"
density = "2400 kg/m^3"
friction = 0.5
safety_factor = 1.5
[service]
life = "10 years"
wear_rate = "0.2 mm/year"
[[points]]
name = "a"
kind = "anchor"
x = 0
y = 0
height = 0
[[points]]
name = "f"
kind = "fairlead"
x = 100
y = 0
height = 55
[[lines]]
start = "a"
end = "f"
[[lines.segments]]
length = "130 m"
diameter = "40 mm"
submerged_weight = "300 N/m"
EA = "150 MN"
MBL = "1280 kN"
"""


def test_a_file_says_by_what_lines_are_judged() -> None:
    network = parse_network(FILE)
    assert network.anchor is not None
    assert network.anchor.submerged_weight == pytest.approx(12e3 * 9.80665 * (1 - 1025 / 2400))
    assert parse_network(write_case(network)) == network
    report = check_network(network)
    (tension,) = of(report, "tension", line=1)
    # 10 years of 0.2 mm take 2 mm off the 40: the MBL goes with the square; API's factor is 2.
    assert tension.capacity == pytest.approx(1280e3 * (38.0 / 40.0) ** 2 / 2.0, rel=1e-9)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('code = "API', 'codes = ["IALA-CALMAR"]\ncode = "API', "put all of them into codes"),
        ("friction = 0.5\n", "", "anchor.friction"),
        ("max_anchor_uplift_force", "max_anchor_uplift_farce", "did you mean"),
        ('density = "2400', 'density = "900', "anchor.density"),
    ],
)
def test_what_a_file_has_wrong_is_told(old: str, new: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        parse_network(FILE.replace(old, new, 1))


@pytest.mark.parametrize(("depth", "above"), [(9.0, True), (11.0, False)])
def test_a_joint_that_is_pulled_out_of_the_water_is_said(depth: float, above: bool) -> None:
    points = (
        Point("left", "anchor", -4.0, 0.0, 7.0),
        Point("right", "anchor", 4.0, 0.0, 7.0),
        Point("joint", "joint", force=(0.0, 0.0, 6e3)),  # 3-4-5: at 10 m
    )
    lines = (LineBetween(rope(), "left", "joint"), LineBetween(rope(), "right", "joint"))
    said = "\n".join(check_network(Network(Site(depth), points, lines)).warnings)
    assert ("joint joint is pulled 1 m above the water surface" in said) is above
