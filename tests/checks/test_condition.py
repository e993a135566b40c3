"""New and worn, each a state of its own: weight and strength, by hand and through a search."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from catopt import check_case, solve_case
from catopt.casefile import parse_case
from catopt.casefile.writing import write_case
from catopt.checks.case import LineInMotion, check_motion
from catopt.checks.result import CheckReport
from catopt.design.evaluation import DesignProblem
from catopt.errors import InputError
from catopt.model import Design, LoadCase, Segment, SegmentChoice
from catopt.model.wear import worn_line

H, HEIGHT, W, LENGTH = 5000.0, 10.0, 200.0, 40.0
LEFT = (18.0 / 20.0) ** 2
"""Of the cross-section: 20 mm less 5 years of 0.4 mm."""

CASE = f"""
[site]
water_depth = {HEIGHT}
[line]
[[line.segments]]
length = {LENGTH}
submerged_weight = {W}
mass = 25.0
MBL = "200 kN"
diameter = "20 mm"
[checks]
safety_factor = 5.0
max_anchor_uplift_angle = "0 deg"
min_grounded_length = "1 m"
[buoy]
reserve_buoyancy = "20 kN"
[service]
life = "5 years"
wear_rate = "0.4 mm/year"
[[load_cases]]
name = "plain"
horizontal_force = {H}
[[load_cases]]
name = "new"
horizontal_force = {H}
condition = "new"
[[load_cases]]
name = "worn"
horizontal_force = {H}
condition = "worn"
"""


def hangs(weight: float) -> float:
    """Length of a catenary that leaves the bed horizontally, s = sqrt(h (h + 2 H/w))."""
    return math.sqrt(HEIGHT * (HEIGHT + 2.0 * H / weight))


def found(report: CheckReport, kind: str, load_case: str) -> tuple[float, float]:
    one = next(r for r in report.results if (r.kind, r.load_case) == (kind, load_case))
    return one.demand, one.capacity


def test_each_state_has_its_own_weight_and_strength() -> None:
    """T = H + w h at the fairlead of a line that lies on the bed; MBL goes with the section."""
    report = check_case(parse_case(CASE))
    new, worn = H + W * HEIGHT, H + LEFT * W * HEIGHT
    full, left = 200e3 / 5.0, LEFT * 200e3 / 5.0
    assert found(report, "tension", "plain") == pytest.approx((new, left), rel=1e-12)
    assert found(report, "tension", "new") == pytest.approx((new, full), rel=1e-12)
    assert found(report, "tension", "worn") == pytest.approx((worn, left), rel=1e-12)
    for name, weight in (("plain", W), ("new", W), ("worn", LEFT * W)):
        lies = LENGTH - hangs(weight)
        assert found(report, "grounded_length", name)[1] == pytest.approx(lies, rel=1e-12)
        pull = weight * hangs(weight)
        assert found(report, "buoyancy", name)[0] == pytest.approx(pull, rel=1e-12)


def test_in_motion_each_state_has_its_own_strength() -> None:
    case = parse_case(CASE)
    line = worn_line(case.line, case.service)
    report = check_motion(
        case, [LineInMotion(line, (9e3,), (5e3,), each.name) for each in case.load_cases]
    )
    capacities = [found(report, "tension", each.name)[1] for each in case.load_cases]
    left = LEFT * 200e3 / 5.0
    assert capacities == pytest.approx([left, 200e3 / 5.0, left], rel=1e-12)


def test_a_worn_line_weighs_what_is_left_and_keeps_its_name() -> None:
    case = parse_case(CASE)
    worn = worn_line(case.line, case.service).segments[0]
    assert worn.submerged_weight == pytest.approx(LEFT * W, rel=1e-15)
    assert worn.mass == pytest.approx(LEFT * 25.0, rel=1e-15)
    assert (worn.nominal_diameter, worn.MBL) == (0.020, 200e3)
    rope = Segment(10.0, 5.0, component="polyester", nominal_diameter=0.1, mass=6.0)
    line = replace(case, line=type(case.line)([rope])).line
    assert worn_line(line, case.service) == line  # a rope does not corrode


def test_the_search_sees_what_the_report_prints() -> None:
    """One design in each condition: the excess of the compiled loop is that of the plain report."""
    case = parse_case(CASE)
    choice = SegmentChoice(
        name="chain", lengths=(40.0, 46.0), components=("chain studless R3",), diameters=(0.02,)
    )
    case = replace(case, design=Design((choice,), objectives=("mass", "length")))
    problem = DesignProblem.of(case)
    genes = np.array([[0, 0], [0, 1]])
    both = problem.assess(genes)
    for row in range(2):
        point = problem.point((0, row))
        assert both.exceedance[row] == pytest.approx(
            max(each.exceedance for each in point.checks.results), abs=1e-9
        )
        assert point.objectives["length_m"] == pytest.approx((40.0, 46.0)[row], rel=1e-12)
        assert both.objectives[row, 4] == pytest.approx((40.0, 46.0)[row], rel=1e-9)
    new = replace(case, load_cases=tuple(e for e in case.load_cases if e.name == "new"))
    alone = DesignProblem.of(new).assess(genes)
    assert (both.exceedance >= alone.exceedance).all()
    assert both.exceedance[0] > alone.exceedance[0]  # worn is harder


def test_the_condition_is_written_and_read_again() -> None:
    case = parse_case(CASE)
    assert parse_case(write_case(case)).load_cases == case.load_cases


def test_a_condition_without_a_service_is_refused() -> None:
    text = CASE.replace('[service]\nlife = "5 years"\nwear_rate = "0.4 mm/year"\n', "")
    with pytest.raises(InputError, match="there is no wear without it") as told:
        parse_case(text)
    assert {each.key for each in told.value.problems} >= {"load_cases[1].condition"}
    with pytest.raises(InputError, match="condition"):
        LoadCase("storm", 1.0, condition="old")  # type: ignore[arg-type]


def test_what_is_known_of_several_load_cases_is_said_once_and_nothing_of_the_new_line() -> None:
    """A fairlead 2 m above the water of every case; `solve` alone says whose its strengths are."""
    text = CASE.replace("[line]\n", "[line]\nfairlead_height = 12.0\n")
    warnings = check_case(parse_case(text)).warnings
    (above,) = (each for each in warnings if "above the water" in each)
    assert above.startswith('load cases "plain", "new", "worn": the fairlead is 2 m above')
    assert not any("those of the new line" in each for each in warnings)
    alone = text[: text.index("[[load_cases]]")].replace(
        "[line]\n", f"[load]\nhorizontal_force = {H}\n[line]\n"
    )
    assert any("those of the new line" in each for each in solve_case(parse_case(alone)).warnings)
    assert not any("those of the new" in each for each in check_case(parse_case(alone)).warnings)
