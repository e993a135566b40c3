"""The load curve of a case: what is stepped, where its range comes from, what its document says."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from catopt.catenary.case_curve import curve_case
from catopt.catenary.find import find_limit_force
from catopt.catenary.solve import solve
from catopt.errors import InputError, NoEquilibriumError
from catopt.model import Case, Checks, Find, Line, Load, PointLoad, Segment, Site

CHAIN = Segment(55.0, 2100.0)
STRONG = replace(CHAIN, MBL=7.5e6)


def tanker(segment: Segment = CHAIN, **changes: object) -> Case:
    """Build S3's tanker: 20 m of water, 55 m of 105 mm chain, 100 kN."""
    case = Case(Site(20.0), Line([segment]), Load(horizontal_force=1e5), 20.0, title="Tanker")
    return replace(case, **changes)  # type: ignore[arg-type]


def test_the_range_follows_the_case_s_force() -> None:
    result = curve_case(tanker())
    force = result.curve.horizontal_force
    assert (force[0], force[-1], len(force)) == (1e3, 1.05e5, 50)
    assert result.range_words == "from 1 % to 105 % of 100.000 kN, the horizontal force of the case"
    assert np.diff(force) == pytest.approx(np.diff(force)[0], rel=1e-9)


def test_the_range_reaches_beyond_the_limit_where_the_strength_is_known() -> None:
    result = curve_case(tanker(STRONG, checks=Checks(safety_factor=5.0)))
    limit = find_limit_force(Line([STRONG]), height=20.0, safety_factor=5.0).value
    assert result.curve.horizontal_force[-1] == pytest.approx(1.05 * limit, rel=1e-12)
    assert "the horizontal force with a segment at MBL / 5" in result.range_words
    assert any("reaches MBL / 5" in mark.event for mark in result.curve.marks)


def test_a_limit_below_the_case_or_out_of_reach_does_not_set_the_range() -> None:
    """40 kN hang from the fairlead, more than an MBL of 30 kN at any force."""
    for MBL in (50e3, 30e3):
        result = curve_case(tanker(replace(CHAIN, MBL=MBL)))
        assert result.curve.horizontal_force[-1] == 1.05e5


def test_over_the_span_the_same_forces_bound_the_range() -> None:
    result = curve_case(tanker(), over="span", points=9)
    for index, force in ((0, 1e3), (-1, 1.05e5)):
        one = solve(Line([CHAIN]), height=20.0, horizontal_force=force)
        assert result.curve.span[index] == pytest.approx(one.span, rel=1e-12)
    assert np.diff(result.curve.span) == pytest.approx(np.diff(result.curve.span)[0], rel=1e-9)


def test_the_offset_counts_from_the_case() -> None:
    result = curve_case(tanker(), over="offset", start=-2.0, stop=0.5, points=6)
    assert result.offset == pytest.approx([-2.0, -1.5, -1.0, -0.5, 0.0, 0.5], abs=1e-12)
    assert result.curve.horizontal_force[4] == pytest.approx(1e5, rel=1e-9)
    assert result.range_words == "as given"


def test_one_end_may_be_given() -> None:
    low = curve_case(tanker(), start=2e4)
    assert low.curve.horizontal_force[[0, -1]] == pytest.approx([2e4, 1.05e5])
    assert low.range_words == "up to 105 % of 100.000 kN, the horizontal force of the case"
    high = curve_case(tanker(), over="span", stop=50.0)
    assert high.curve.span[-1] == pytest.approx(50.0)
    assert high.curve.horizontal_force[0] == pytest.approx(1e3, rel=1e-9)
    assert high.range_words == "from 1 % of 100.000 kN, the horizontal force of the case"


def test_the_curve_is_that_of_the_line_with_what_was_found() -> None:
    find = Find("length", anchor_angle=0.0)
    result = curve_case(tanker(find=find))
    length = math.sqrt(20.0 * (20.0 + 2.0 * 1e5 / 2100.0))
    assert result.reference.line.length == pytest.approx(length, rel=1e-9)
    (change,) = result.curve.marks
    assert change.horizontal_force == pytest.approx(1e5, rel=1e-9)
    assert result.to_dict()["found"]["value"] == result.reference.line.length


def test_a_force_that_is_found_is_the_reference() -> None:
    """H_1 = (w/2)(L2/h - h)."""
    case = tanker(load=None, find=Find("touchdown_force"))
    result = curve_case(case, over="offset", stop=0.1)
    H = 2100.0 / 2.0 * (55.0**2 / 20.0 - 20.0)
    assert result.reference.horizontal_force == pytest.approx(H, rel=1e-9)
    (change,) = result.curve.marks
    assert change.span - result.reference.span == pytest.approx(0.0, abs=1e-9)


def test_a_slack_case_takes_the_line_s_weight_for_its_range() -> None:
    result = curve_case(tanker(load=Load(span=30.0)))
    assert result.curve.horizontal_force[-1] == pytest.approx(1.05 * 55.0 * 2100.0)
    assert "the case has no horizontal force" in result.range_words


def test_the_range_covers_forces_under_which_the_line_touches_twice() -> None:
    """Under a small force the buoy lifts the line off the bed between two stretches on it."""
    line = Line([Segment(100.0, 1000.0)], [PointLoad(40.0, -20e3)])
    case = Case(Site(20.0), line, Load(horizontal_force=1.2e5), 20.0)
    result = curve_case(case)
    assert result.curve.horizontal_force[0] == pytest.approx(0.01 * 1.2e5)
    assert result.curve.regime[0] == "grounded-in-parts"
    assert result.curve.regime[-1] == "grounded"


def test_the_outline_fills_the_steep_part() -> None:
    """Over the span the last step may be many times the force; for drawing it is filled."""
    result = curve_case(tanker(), over="span", start=30.0, stop=51.2, points=10)
    span, force, tension = (np.array(values) for values in result.outline(100))
    assert len(span) == len(force) == len(tension) == 110
    assert (np.diff(span) >= 0.0).all()
    assert (np.diff(force) >= 0.0).all()
    assert np.diff(force).max() <= force[-1] / 99.0
    assert np.diff(result.curve.horizontal_force).max() > 0.5 * force[-1]
    assert tension == pytest.approx(tension.clip(force), rel=0.0)


def test_the_limits_of_the_case_are_marked() -> None:
    case = tanker(STRONG, checks=Checks(5.0, max_anchor_uplift_angle=math.radians(3.0)))
    events = [mark.event for mark in curve_case(case).curve.marks]
    assert events == [
        "grounded -> suspended",
        "inclination at the anchor reaches 3 deg",
        "segment 1 reaches MBL / 5",
    ]


def test_friction_and_a_raised_anchor_come_from_the_case() -> None:
    case = tanker(site=Site(20.0, seabed_friction=0.5), anchor_height=1.0)
    result = curve_case(case, points=5)
    for index in range(5):
        one = solve(
            case.line,
            height=20.0,
            horizontal_force=float(result.curve.horizontal_force[index]),
            seabed_friction=0.5,
            anchor_height=1.0,
        )
        assert result.curve.span[index] == pytest.approx(one.span, rel=1e-12)
        assert result.curve.anchor_tension[index] == pytest.approx(one.anchor.tension, rel=1e-12)


def test_wrong_ranges() -> None:
    with pytest.raises(InputError, match=r"start: found -60 m; must be above -\d+\.\d+ m, where"):
        curve_case(tanker(), over="offset", start=-60.0)
    with pytest.raises(InputError, match=r"stop: found 10000 N; must be above the start"):
        curve_case(tanker(), start=2e4, stop=1e4)
    with pytest.raises(InputError, match=r"points: found 10001; must be from 2 to 10000"):
        curve_case(tanker(), points=10_001)
    with pytest.raises(InputError, match=r"over: found 'time'; one of force, span, offset"):
        curve_case(tanker(), over="time")  # type: ignore[arg-type]
    with pytest.raises(NoEquilibriumError, match="at a span of 60 m"):
        curve_case(tanker(), over="span", stop=60.0)


def test_a_line_on_the_bed_has_no_range_of_span() -> None:
    """Its span is its length, whatever the force."""
    case = tanker(fairlead_height=0.0)
    with pytest.raises(InputError, match="over: found span"):
        curve_case(case, over="span")
    assert set(curve_case(case).to_dict()["stiffness_N_per_m"]) == {None}
