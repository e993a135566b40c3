"""Load curves: points by the scalar solve, marks by formula."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from catopt.catenary.curve import Curve, Mark, load_curve
from catopt.catenary.solve import solve
from catopt.errors import InputError, NoEquilibriumError
from catopt.model import Line, PointLoad, Segment

TANKER = Line([Segment(55.0, 2100.0, MBL=1e6)])
SINKER = Line([Segment(55.0, 2100.0)], [PointLoad(7.0, 200e3, name="sinker")])


def over_force(line: Line, start: float, stop: float, points: int = 20) -> Curve:
    return load_curve(
        line, height=20.0, over="horizontal_force", start=start, stop=stop, points=points
    )


def marks(curve: Curve, word: str) -> list[Mark]:
    return [mark for mark in curve.marks if word in mark.event]


def test_points_are_those_of_the_scalar_solve() -> None:
    curve = over_force(TANKER, 2e4, 4e5)
    for index, force in enumerate(np.linspace(2e4, 4e5, 20)):
        one = solve(TANKER, height=20.0, horizontal_force=float(force))
        assert curve.span[index] == pytest.approx(one.span, rel=1e-13)
        assert curve.regime[index] == one.regime
        assert curve.anchor_tension[index] == pytest.approx(one.anchor.tension, rel=1e-13)
        assert curve.anchor_angle[index] == pytest.approx(one.anchor.angle, rel=1e-13)


def test_the_change_of_regime_is_marked_where_the_formula_has_it() -> None:
    """H_1 = (w/2)(L2/h - h) = 137.8125 kN, found to 1e-9 of itself."""
    curve = load_curve(
        TANKER, height=20.0, over="span", start=40.0, stop=51.0, points=30, safety_factor=5.0
    )
    (change,) = marks(curve, "->")
    assert (change.kind, change.event) == ("regime", "grounded -> suspended")
    assert change.horizontal_force == pytest.approx(137812.5, rel=1e-9)


def test_the_limit_of_every_segment_is_marked() -> None:
    """The line is steepest at the top of each segment, so that its tension there is H / cos."""
    wire = replace(TANKER.segments[0], length=25.0, MBL=1.5e6, name="wire")
    line = Line([wire, replace(wire, length=30.0, MBL=1e6, name="")])
    curve = load_curve(
        line, height=20.0, over="span", start=40.0, stop=51.22, points=40, safety_factor=5.0
    )
    first, second = marks(curve, "MBL")
    assert (first.event, first.kind) == ("segment 2 reaches MBL / 5", "limit")
    assert first.fairlead_tension == pytest.approx(1e6 / 5.0, rel=1e-9)
    assert second.event == "segment 1 reaches MBL / 5 (wire)"
    there = solve(line, height=20.0, horizontal_force=second.horizontal_force)
    assert there.segments[0].max_tension == pytest.approx(1.5e6 / 5.0, rel=1e-9)


def test_the_allowed_inclination_at_the_anchor_is_marked() -> None:
    """At theta0 = 0.1: h = a (sec(theta_L) - sec(0.1)) with tan(theta_L) = tan(0.1) + L/a."""
    curve = load_curve(
        TANKER,
        height=20.0,
        over="horizontal_force",
        start=1e5,
        stop=4e5,
        points=7,
        max_anchor_angle=0.1,
    )
    (limit,) = marks(curve, "inclination")
    assert limit.event == "inclination at the anchor reaches 5.73 deg"
    a = limit.horizontal_force / 2100.0
    t = math.tan(0.1)
    height = a * math.hypot(1.0, t + 55.0 / a) - a / math.cos(0.1)
    assert height == pytest.approx(20.0, rel=1e-9)


def test_a_clump_weight_begins_to_lift_and_is_off_the_bed() -> None:
    """Three of its states: S2's parts of the line, from the bed up to the fairlead.

    While it lies, h (h + 2a) = (L - s)^2; when it is just off the bed, the part above it leaves
    it with V = W, so that h = a (hypot(1, (W + w (L - s)) / H) - hypot(1, W / H)).
    """
    curve = over_force(SINKER, 1e4, 9e5, points=40)
    begins, off = marks(curve, "clump")
    assert begins.event == "clump weight 1 begins to lift (sinker)"
    assert off.event == "clump weight 1 is off the bed (sinker)"
    H = begins.horizontal_force
    assert 20.0 * (20.0 + 2.0 * H / 2100.0) == pytest.approx(48.0**2, rel=1e-9)
    H = off.horizontal_force
    up = math.hypot(1.0, (200e3 + 2100.0 * 48.0) / H) - math.hypot(1.0, 200e3 / H)
    assert H / 2100.0 * up == pytest.approx(20.0, rel=1e-9)


def test_changes_between_two_neighbours_are_all_found() -> None:
    """Two points, and everything happens between them."""
    close = over_force(SINKER, 1e4, 3e6, points=200)
    far = over_force(SINKER, 1e4, 3e6, points=2)
    assert [mark.event for mark in far.marks] == [mark.event for mark in close.marks]
    assert len(far.marks) == 3
    for one, other in zip(far.marks, close.marks, strict=True):
        assert one.horizontal_force == pytest.approx(other.horizontal_force, rel=1e-9)


def test_buoys_and_a_raised_anchor_have_no_mark_of_lifting() -> None:
    buoy = Line(SINKER.segments, [PointLoad(50.0, -1e3)])
    assert marks(over_force(buoy, 1e5, 3e5), "clump") == []
    raised = load_curve(
        SINKER, height=20.0, over="horizontal_force", start=1e5, stop=9e5, anchor_height=2.0
    )
    assert marks(raised, "clump") == []


def test_stiffness_is_the_slope_of_the_curve() -> None:
    """Central differences, order 2: halving the step quarters the error."""
    errors = []
    for points in (41, 81):
        curve = load_curve(TANKER, height=20.0, over="span", start=40.0, stop=49.0, points=points)
        slope = np.gradient(curve.horizontal_force, curve.span)
        middle = points // 2
        errors.append(abs(slope[middle] / curve.stiffness[middle] - 1.0))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.1)


def test_a_slack_line_has_no_force_and_no_stiffness() -> None:
    """Slack up to L - h = 35 m: 20 m hang straight down."""
    curve = load_curve(TANKER, height=20.0, over="span", start=30.0, stop=40.0, points=11)
    slack = curve.span < 35.0
    assert set(curve.regime) == {"slack", "grounded"}
    assert not curve.horizontal_force[slack].any()
    assert not curve.stiffness[slack].any()
    assert curve.fairlead_tension[slack] == pytest.approx(2100.0 * 20.0, rel=1e-12)
    assert (curve.stiffness[~slack] > 0.0).sum() >= 5
    (change,) = marks(curve, "->")
    assert change.event == "slack -> grounded"
    assert change.span == pytest.approx(35.0, rel=1e-9)


def test_a_line_on_the_bed_has_no_slope_unless_it_stretches() -> None:
    stiff = load_curve(TANKER, height=0.0, over="horizontal_force", start=1e4, stop=2e4, points=3)
    assert np.isnan(stiff.stiffness).all()
    assert set(stiff.regime) == {"on-bed"}
    elastic = Line([replace(TANKER.segments[0], EA=1e8)])
    soft = load_curve(elastic, height=0.0, over="horizontal_force", start=1e4, stop=2e4, points=3)
    assert soft.stiffness == pytest.approx(1e8 / 55.0, rel=1e-12)


def test_a_range_beyond_the_line_says_by_how_much() -> None:
    """The line reaches sqrt(L2 - h2) = 51.2348 m; at 60 m it would have to be 63.2456 m long."""
    with pytest.raises(NoEquilibriumError) as caught:
        load_curve(TANKER, height=20.0, over="span", start=40.0, stop=60.0)
    assert caught.value.quantity == "length"
    assert caught.value.missing == pytest.approx(math.hypot(60.0, 20.0) - 55.0, rel=1e-12)
    assert "at a span of 60 m: " in str(caught.value)
    assert "let the range end below a span of 51.2348 m" in str(caught.value)


def test_a_buoy_lifts_the_line_off_the_bed_between_two_stretches() -> None:
    """At 1 kN chain lies on both sides of the buoy; at 100 kN the line only touches at the anchor.

    20 kN of lift hold up 20 m of the chain, 10 m on each side of the buoy at 40 m.
    """
    line = Line([Segment(100.0, 1000.0)], [PointLoad(40.0, -20e3)])
    curve = over_force(line, 1e3, 1e5)
    assert curve.regime[0] == "grounded-in-parts"
    assert curve.regime[-1] != "grounded-in-parts"
    assert [mark.kind for mark in curve.marks].count("regime") >= 1
    first = solve(line, height=20.0, horizontal_force=1e3)
    lying = [(s.start, s.start + s.length) for s in first.stretches if s.on_bed]
    assert lying[0] == pytest.approx((0.0, 30.0), abs=1e-9)
    assert lying[1][0] == pytest.approx(50.0, abs=1e-9)


def test_an_empty_range_is_refused() -> None:
    with pytest.raises(InputError) as caught:
        load_curve(TANKER, height=20.0, over="span", start=50.0, stop=40.0, points=1)
    assert [problem.key for problem in caught.value.problems] == ["stop", "points"]
    with pytest.raises(InputError, match=r"start: found -1 N; must be above 0 N"):
        over_force(TANKER, -1.0, 1e5)
    with pytest.raises(InputError, match=r"stop: found inf N"):
        over_force(TANKER, 1.0, math.inf)


def test_arguments_are_checked_as_by_solve() -> None:
    with pytest.raises(InputError, match=r"height: found -1\.0; must be 0 m or more"):
        load_curve(TANKER, height=-1.0, over="span", start=40.0, stop=50.0)
    weightless = Line([Segment(55.0, 0.0)])
    with pytest.raises(InputError, match=r"needs load\.horizontal_force"):
        load_curve(weightless, height=20.0, over="span", start=40.0, stop=50.0)
    straight = math.sqrt(55.0**2 - 20.0**2)
    assert over_force(weightless, 1e3, 2e3, 3).span == pytest.approx(straight, rel=1e-14)


def test_a_range_that_is_not_given_ends_beyond_the_limit() -> None:
    """200 m of 1500 N/m, 30 m up, hang free at T = 3000 kN: H by the catenary of S2."""
    line = Line([Segment(200.0, 1500.0, MBL=6e6)])
    curve = load_curve(line, height=30.0, safety_factor=2.0)
    # T = H cosh(u2), L = a (sinh(u2) - sinh(u1)), h = a (cosh(u2) - cosh(u1)), a = H / w.
    (limit,) = [mark for mark in curve.marks if mark.kind == "limit"]
    a = limit.horizontal_force / 1500.0
    high = math.acosh(3e6 / limit.horizontal_force)
    low = math.asinh(math.sinh(high) - 200.0 / a)
    assert a * (math.cosh(high) - math.cosh(low)) == pytest.approx(30.0, rel=1e-9)
    assert curve.horizontal_force[0] == pytest.approx(0.01 * limit.horizontal_force, rel=1e-9)
    assert curve.horizontal_force[-1] == pytest.approx(1.05 * limit.horizontal_force, rel=1e-9)


def test_a_range_of_a_line_of_unknown_strength_goes_by_its_weight() -> None:
    line = Line([Segment(200.0, 1500.0)])
    curve = load_curve(line, height=30.0, points=3)
    assert curve.horizontal_force[[0, -1]] == pytest.approx([3e3, 3.15e5], rel=1e-12)
    spans = load_curve(line, height=30.0, over="span", points=3).span
    assert spans[[0, -1]] == pytest.approx(curve.span[[0, -1]], rel=1e-12)
    last = load_curve(line, height=30.0, stop=1e5, points=2)
    assert last.horizontal_force == pytest.approx([3e3, 1e5], rel=1e-12)
