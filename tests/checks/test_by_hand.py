"""Each check beside a calculation by hand; the lines are those of tests/checks/lines.py."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt.checks.case import check_case
from catopt.checks.result import CheckResult
from catopt.model import Anchor, Buoy, Checks, Line, LoadCase, Segment, Site

from .lines import CLOSE, GROUNDED, LIFTED, PLAIN, SPAN, asking, only


def agrees(
    result: CheckResult, *, demand: float, capacity: float, utilisation: float, exceedance: float
) -> None:
    assert result.demand == pytest.approx(demand, rel=CLOSE)
    assert result.capacity == pytest.approx(capacity, rel=CLOSE)
    assert result.utilisation == pytest.approx(utilisation, rel=CLOSE)
    assert result.exceedance == pytest.approx(exceedance, rel=CLOSE, abs=CLOSE)
    assert result.passes == (exceedance <= 0.0)


def test_tension_against_the_breaking_load() -> None:
    """T = 50 kN; MBL 200 kN / 5 = 40 kN; 50 / 40 = 1.25, 0.25 too much."""
    result = only(asking(checks=Checks(safety_factor=5.0)))
    agrees(result, demand=50e3, capacity=40e3, utilisation=1.25, exceedance=0.25)
    assert (result.kind, result.name, result.unit) == (
        "tension",
        "tension, segment 1 (100 mm)",
        "N",
    )
    assert result.note == "MBL 200 kN / 5"


def test_tension_just_at_its_limit_passes() -> None:
    """T = 50 kN; MBL 200 kN / 4 = 50 kN: utilisation 1, and rounding does not fail it."""
    result = only(asking(checks=Checks(safety_factor=4.0)))
    agrees(result, demand=50e3, capacity=50e3, utilisation=1.0, exceedance=0.0)


def test_tension_against_the_proof_load() -> None:
    """T = 50 kN; proof load 100 kN / 1.6 = 62.5 kN; 50 / 62.5 = 0.8."""
    result = only(asking(checks=Checks(proof_load_factor=1.6)))
    agrees(result, demand=50e3, capacity=62.5e3, utilisation=0.8, exceedance=-0.2)
    assert result.note == "proof load 100 kN / 1.6"


def test_tension_by_segment() -> None:
    """The lower 50 m end 30 m up the suspended part, where T = sqrt(30^2 + 30^2) = 42.426 kN.

    With MBL 120 kN / 2 = 60 kN below that is 0.70711; above, 50 kN beside 200 / 2 = 100 kN is 0.5.
    """
    line = Line([Segment(50.0, 1000.0, MBL=120e3, name="old"), replace(PLAIN, length=10.0)])
    below, above = check_case(asking(line=line, checks=Checks(safety_factor=2.0))).results
    root = math.sqrt(0.5)
    agrees(below, demand=60e3 * root, capacity=60e3, utilisation=root, exceedance=root - 1.0)
    agrees(above, demand=50e3, capacity=100e3, utilisation=0.5, exceedance=-0.5)
    assert (below.name, above.name) == (
        "tension, segment 1 (old)",
        "tension, segment 2 (100 mm)",
    )


def test_uplift_angle() -> None:
    """Arctan 0.75 = 0.643501 rad (36.87 deg); allowed 0.5 rad: 1.287002, 0.143501 rad too much."""
    result = only(asking(LIFTED, Checks(max_anchor_uplift_angle=0.5)))
    angle = math.atan(0.75)
    assert round(angle, 6) == 0.643501
    agrees(result, demand=angle, capacity=0.5, utilisation=angle / 0.5, exceedance=angle - 0.5)
    assert result.unit == "rad"


def test_no_uplift_has_no_utilisation() -> None:
    """A limit of 0: what lies on the bed keeps it, what is lifted does not."""
    checks = Checks(max_anchor_uplift_angle=0.0)
    lies, lifted = only(asking(GROUNDED, checks)), only(asking(LIFTED, checks))
    assert (lies.demand, lies.utilisation, lies.exceedance, lies.passes) == (0.0, None, 0.0, True)
    assert (lifted.utilisation, lifted.passes) == (None, False)
    assert lifted.exceedance == pytest.approx(math.atan(0.75), rel=CLOSE)


def test_uplift_force() -> None:
    """V = 22.5 kN of 25 kN allowed: 0.9. The excess is measured by H: (22.5 - 25) / 30."""
    result = only(asking(LIFTED, Checks(max_anchor_uplift_force=25e3)))
    agrees(result, demand=22.5e3, capacity=25e3, utilisation=0.9, exceedance=-2.5 / 30.0)


def test_least_tension() -> None:
    """H = 30 kN and V = 40 kN: 50 kN at the fairlead; of 60 kN wanted a sixth is missing."""
    result = only(asking(checks=Checks(min_tension=60e3)))
    agrees(result, demand=60e3, capacity=50e3, utilisation=1.2, exceedance=1.0 / 6.0)


def test_grounded_length() -> None:
    """20 m lie on the bed; of 25 m wanted a fifth is missing, and 25 / 20 = 1.25."""
    result = only(asking(checks=Checks(min_grounded_length=25.0)))
    agrees(result, demand=25.0, capacity=20.0, utilisation=1.25, exceedance=0.2)


def test_span() -> None:
    """Span 52.9584 m of 60 m allowed: 0.88264."""
    result = only(asking(checks=Checks(max_span=60.0)))
    assert round(SPAN, 4) == 52.9584
    agrees(
        result, demand=SPAN, capacity=60.0, utilisation=SPAN / 60.0, exceedance=SPAN / 60.0 - 1.0
    )


def test_buoyancy() -> None:
    """The line pulls down with V = 40 kN; reserve 50 kN: 0.8."""
    result = only(asking(buoy=Buoy(50e3)))
    agrees(result, demand=40e3, capacity=50e3, utilisation=0.8, exceedance=-0.2)


def test_sliding_of_a_sinker() -> None:
    """No uplift, mu 0.5, SF 1.5: W >= 1.5 * 30 / 0.5 = 90 kN; it weighs 100 kN: 0.9."""
    anchor = Anchor("sinker", submerged_weight=100e3, friction=0.5, safety_factor=1.5)
    agrees(
        only(asking(anchor=anchor)), demand=90e3, capacity=100e3, utilisation=0.9, exceedance=-0.1
    )


def test_uplift_takes_weight_off_a_sinker() -> None:
    """V = 22.5 kN: W >= 22.5 + 1.5 * 30 / 0.5 = 112.5 kN; it weighs 100 kN: 1.125.

    The same as mu (W - V) = 0.5 * (100 - 22.5) = 38.75 kN, which is less than SF H = 45 kN.
    """
    anchor = Anchor("sinker", submerged_weight=100e3, friction=0.5, safety_factor=1.5)
    result = only(asking(LIFTED, anchor=anchor))
    agrees(result, demand=112.5e3, capacity=100e3, utilisation=1.125, exceedance=0.125)


def test_holding_of_a_drag_anchor() -> None:
    """H = 30 kN; 75 kN / 2 = 37.5 kN: 0.8. Its uplift is kept at 0 though nobody asked."""
    anchor = Anchor("drag", holding_capacity=75e3, safety_factor=2.0)
    uplift, holding = check_case(asking(anchor=anchor)).results
    agrees(holding, demand=30e3, capacity=37.5e3, utilisation=0.8, exceedance=-0.2)
    assert (uplift.kind, uplift.capacity, uplift.passes) == ("uplift_angle", 0.0, True)
    assert uplift.source.clause == "Table 3-18"


def test_a_drag_anchor_takes_the_uplift_that_the_case_allows() -> None:
    """Arctan 0.75 = 0.6435 rad beside 0.7 rad, and no check against 0."""
    anchor = Anchor("drag", holding_capacity=75e3, safety_factor=2.0)
    case = asking(LIFTED, Checks(max_anchor_uplift_angle=0.7), anchor=anchor)
    uplift, _ = check_case(case).results
    assert (uplift.capacity, uplift.passes, uplift.source.code) == (0.7, True, "user")
    assert not check_case(asking(LIFTED, anchor=anchor)).passes


def test_friction_of_the_line_helps_the_anchor() -> None:
    """20 m of 1000 N/m on the bed with mu 0.3 hold 6 kN: 24 kN reach the anchor; 24 / 37.5."""
    anchor = Anchor("drag", holding_capacity=75e3, safety_factor=2.0)
    case = asking(anchor=anchor, site=Site(20.0, seabed_friction=0.3))
    _, holding = check_case(case).results
    agrees(holding, demand=24e3, capacity=37.5e3, utilisation=0.64, exceedance=-0.36)


def test_load_cases_move_the_fairlead() -> None:
    """T = H + w h: 30 + 20 = 50 kN, at high water under 10 kN 10 + 25 = 35 kN; MBL / 2 = 100 kN."""
    states = (LoadCase("storm", 30e3), LoadCase("tide", 10e3, 5.0, "reference"))
    report = check_case(asking(checks=Checks(safety_factor=2.0), load_cases=states, load=None))
    storm, tide = report.results
    agrees(storm, demand=50e3, capacity=100e3, utilisation=0.5, exceedance=-0.5)
    agrees(tide, demand=35e3, capacity=100e3, utilisation=0.35, exceedance=-0.65)
    assert (storm.load_case, tide.load_case) == ("storm", "tide")
    assert report.governing == storm
    assert report.passes
