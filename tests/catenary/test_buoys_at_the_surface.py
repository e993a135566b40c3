"""A buoy lifts in the water only: a line whose buoy would float above the surface is refused."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import catopt
from catopt.catenary.case_curve import curve_case
from catopt.catenary.solve import solve
from catopt.checks.case import check_case
from catopt.errors import FloatsUpError
from catopt.model import Case, Checks, Leg, Line, Load, LoadCase, PointLoad, Segment, Site, System
from catopt.mooring.case import report_system
from catopt.words import Message

BUOYED = Line([Segment(120.0, 1000.0, EA=5e8, MBL=3e6)], [PointLoad(80.0, -150e3, name="float")])
"""Its buoy is above 50 m under less than 115 kN, and below that under more."""


def case(line: Line = BUOYED, force: float = 5e4, depth: float = 50.0) -> Case:
    return Case(Site(depth), line, Load(horizontal_force=force), 50.0, checks=Checks(1.5))


def test_how_far_above_is_that_of_a_triangle() -> None:
    """A huge buoy draws two light parts, of 100 m and 50 m, straight: its place is where they meet.

    Both ends are 80 m apart and the fairlead is 60 m up, so that they are 100 m from each other:
    from the anchor the buoy stands up at atan(60/80) + acos((100^2 + 100^2 - 50^2)/(2 100 100)).
    """
    angle = math.atan2(60.0, 80.0) + math.acos((2.0 * 100.0**2 - 50.0**2) / (2.0 * 100.0**2))
    above = 100.0 * math.sin(angle) - 60.0
    line = Line([Segment(150.0, 1e-3)], [PointLoad(100.0, -1e6)])
    taut = Case(Site(60.0), line, Load(span=80.0), 60.0)
    with pytest.raises(FloatsUpError, match=rf"would float {above:.4g} m above the water surface"):
        catopt.solve_case(taut)


def test_the_refusal_names_the_buoy_and_the_way_out() -> None:
    z = solve(BUOYED, height=50.0, horizontal_force=5e4).point_loads[0].z
    with pytest.raises(FloatsUpError) as refused:
        catopt.solve_case(case())
    assert str(refused.value) == (
        f"the buoy line.point_loads[0] (float) at 80 m would float {z - 50.0:.4g} m above the "
        "water surface under its full lift of 150000 N, which it has only when submerged. Give it "
        "less lift, move it towards the anchor, or increase the force; the water is 50 m deep."
    )
    assert refused.value.exit_status == 3


@pytest.mark.parametrize("force", [1.5e5, 4e5])
def test_in_the_water_it_is_answered(force: float) -> None:
    solution = catopt.solve_case(case(force=force))
    assert solution.point_loads[0].z < 50.0
    assert solution.warnings == ()


def test_a_load_case_is_named() -> None:
    both = replace(
        case(force=2e5), load=None, load_cases=(LoadCase("storm", 2e5), LoadCase("calm", 5e4))
    )
    with pytest.raises(FloatsUpError, match=r'load case "calm": the buoy line.point_loads\[0\]'):
        check_case(both)
    raised = replace(both, load_cases=(LoadCase("storm", 2e5), LoadCase("flood", 5e4, 60.0)))
    assert check_case(raised).results  # 60 m more water are above it


def test_verify_refuses_it_and_so_where_the_line_touches_twice() -> None:
    with pytest.raises(FloatsUpError):
        catopt.verify_case(case())
    twice = Line([Segment(300.0, 1000.0, EA=5e8)], [PointLoad(100.0, -1.2e5)])
    shallow = Case(Site(20.0), twice, Load(horizontal_force=2e4), 20.0)
    assert solve(twice, height=20.0, horizontal_force=2e4).regime == "grounded-in-parts"
    with pytest.raises(FloatsUpError, match="at 100 m would float"):
        catopt.verify_case(shallow)


def test_a_curve_starts_where_the_buoy_is_in_the_water() -> None:
    found = curve_case(case(force=4e5))
    first = float(found.curve.horizontal_force[0])
    assert solve(BUOYED, height=50.0, horizontal_force=first).point_loads[0].z < 50.0
    below = solve(BUOYED, height=50.0, horizontal_force=0.99 * first).point_loads[0].z
    assert below > 50.0
    assert "below which a buoy floats above the water" in found.range_words
    assert isinstance(found.range_words, Message)
    with pytest.raises(FloatsUpError):
        curve_case(case(force=4e5), start=5e4)


def test_a_line_of_a_system_is_named() -> None:
    legs = [Leg(Line([Segment(120.0, 1000.0)]), 0.0, 90.0, 50.0), Leg(BUOYED, math.pi, 90.0, 50.0)]
    moored = replace(case(), system=System(tuple(legs)), load=None)
    with pytest.raises(FloatsUpError, match=r"^line 2: the buoy line.point_loads\[0\]"):
        report_system(moored)
    with pytest.raises(FloatsUpError, match=r"^line 2: the buoy line.point_loads\[0\]"):
        catopt.verify_case(moored)


def test_what_is_heavy_may_hang_above_the_water() -> None:
    """A fairlead 20 m above the water, with a clump weight 10 m below it."""
    line = Line([Segment(150.0, 1000.0)], [PointLoad(148.0, 1e4)])
    high = Case(Site(50.0), line, Load(horizontal_force=2e5), 70.0)
    solution = catopt.solve_case(high)
    assert solution.point_loads[0].z > 50.0
    assert np.isfinite(solution.span)
