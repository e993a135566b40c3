"""The questions turned round, against formulas and by putting each answer back in."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

from catopt import read_case
from catopt.catenary.case import solve_case
from catopt.catenary.find import (
    find_case,
    find_clump_weight,
    find_length,
    find_limit_force,
    find_touchdown_force,
    with_segment_length,
)
from catopt.catenary.solve import solve
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError, NoAnswerError, NoEquilibriumError
from catopt.model import Case, Checks, Find, Line, Load, PointLoad, Segment, Site
from tests.campaign.questions import question, run
from tests.catenary.random_lines import random_setting

TANKER = Line([Segment(55.0, 2100.0, MBL=770e3 * STANDARD_GRAVITY)])


def test_touchdown_force_of_s3() -> None:
    """S3 Table 1 prints 137.81 kN for (w/2)(L2/h - h) = 137.8125 kN."""
    found = find_touchdown_force(TANKER, height=20.0)
    assert found.value == pytest.approx(2100.0 / 2 * (55.0**2 / 20.0 - 20.0), rel=1e-12)
    assert found.solution.anchor.angle == pytest.approx(0.0, abs=1e-12)


def test_length_that_lays_the_anchor_flat_is_the_shortest_suspended_one() -> None:
    """L_min = sqrt(h (h + 2 a)), S2 (1)."""
    found = find_length(TANKER, height=20.0, horizontal_force=450e3, anchor_angle=0.0)
    expected = math.sqrt(20.0 * (20.0 + 2 * 450e3 / 2100.0))
    assert found.value == pytest.approx(expected, rel=1e-12)


def test_length_of_s2_with_the_sinker() -> None:
    """S2: 50 kN at 200 m lets 27.7 m be saved of 600 m under 800 kN (printed digits)."""
    line = Line([Segment(600.0, 1000.0)], [PointLoad(200.0, 50e3)])
    found = find_length(line, height=200.0, horizontal_force=800e3, anchor_angle=0.0)
    assert 600.0 - found.value == pytest.approx(27.7, abs=0.05)
    assert found.solution.fairlead.tension == pytest.approx(1013.5e3, abs=50.0)


def test_length_for_an_angle_and_back() -> None:
    there = find_length(TANKER, height=20.0, horizontal_force=450e3, anchor_angle=0.1)
    back = solve(Line([Segment(there.value, 2100.0)]), height=20.0, horizontal_force=450e3)
    assert back.anchor.angle == pytest.approx(0.1, rel=1e-10)


def test_length_for_a_grounded_length() -> None:
    """Under 100 kN 48.01 m hang (S3 Table 1), so 10 m on the bed take 58.01 m."""
    found = find_length(TANKER, height=20.0, horizontal_force=100e3, grounded_length=10.0)
    hanging = math.sqrt(20.0 * (20.0 + 2 * 100e3 / 2100.0))
    assert found.value == pytest.approx(10.0 + hanging, rel=1e-10)


def test_length_under_a_known_tension() -> None:
    """T = H + w h from the bed up, so T = 492 kN is H = 450 kN at the same length."""
    by_force = find_length(TANKER, height=20.0, horizontal_force=450e3, anchor_angle=0.0)
    by_tension = find_length(TANKER, height=20.0, fairlead_tension=492e3, anchor_angle=0.0)
    assert by_tension.value == pytest.approx(by_force.value, rel=1e-10)


def test_length_of_one_segment_moves_what_hangs_above_it() -> None:
    line = Line([Segment(30.0, 300.0), Segment(40.0, 2100.0)], [PointLoad(50.0, 1e4)])
    longer = with_segment_length(line, 0, 36.0)
    assert longer.point_loads[0].position == 56.0
    found = find_length(line, height=20.0, horizontal_force=300e3, segment=0, anchor_angle=0.0)
    assert found.solution.line.segments[1].length == 40.0
    assert found.solution.anchor.vertical_force == pytest.approx(0.0, abs=1e-6)


def test_clump_weight_and_length_answer_each_other() -> None:
    line = Line([Segment(55.0, 2100.0)], [PointLoad(7.0, 200e3)])
    length = find_length(line, height=20.0, horizontal_force=450e3, anchor_angle=0.0)
    clump = find_clump_weight(length.solution.line, height=20.0, horizontal_force=450e3)
    assert clump.value == pytest.approx(200e3, rel=1e-10)


def test_limit_force_at_a_fifth_of_the_breaking_load() -> None:
    """S3: [T] = 770/5 = 154 tf at the fairlead."""
    found = find_limit_force(TANKER, height=20.0, safety_factor=5.0)
    tf = found.solution.fairlead.tension / (1e3 * STANDARD_GRAVITY)
    assert tf == pytest.approx(154.0, rel=1e-12)


def test_limit_force_of_one_segment() -> None:
    """A weaker segment below, and the one above that is asked for."""
    line = Line([Segment(25.0, 2100.0, MBL=1e6), Segment(30.0, 2100.0, MBL=2e6)])
    first = find_limit_force(line, height=20.0, safety_factor=2.0)
    assert first.solution.segments[0].max_tension == pytest.approx(5e5, rel=1e-12)
    assert first.condition == "a segment at MBL / 2"
    upper = find_limit_force(line, height=20.0, safety_factor=2.0, segment=1)
    assert upper.solution.fairlead.tension == pytest.approx(1e6, rel=1e-12)
    assert upper.condition == "segment 2 at MBL / 2"
    assert find_limit_force(line, height=20.0, safety_factor=2.0, segment=-2).value == first.value


def test_limit_force_below_what_hangs() -> None:
    """20 m hang straight down at no force at all: 42 kN, more than the MBL."""
    with pytest.raises(NoAnswerError, match="no horizontal force gives a segment at MBL / 1"):
        find_limit_force(Line([Segment(55.0, 2100.0, MBL=4e4)]), height=20.0)


def test_touchdown_force_beyond_forces_under_which_the_line_touches_twice() -> None:
    """At the anchor V = W - B - w L = 0 in the end, and from there up it is a hung line.

    Height by pieces: h = (T1 - H) / w + (T2 - T3) / w with V1 = w s, V2 = wL - B and the buoy's
    jump down to V3 = w s + B; V = 0 at the anchor.
    """
    line = Line([Segment(100.0, 1000.0)], [PointLoad(40.0, -20e3)])
    found = find_touchdown_force(line, height=20.0)
    H = found.value
    below = math.hypot(H, 40e3) - H
    above = math.hypot(H, 80e3) - math.hypot(H, 20e3)
    assert (below + above) / 1000.0 == pytest.approx(20.0, rel=1e-9)


def test_a_line_too_short_for_its_height_says_so() -> None:
    with pytest.raises(NoEquilibriumError, match="too short"):
        find_touchdown_force(Line([Segment(15.0, 2100.0)]), height=20.0)


# What a case seeks. S3, Table 2, recomputed for H = 450 kN: the sinker 7 m from the anchor, its
# weight as submerged weight, theta0 = 0; lengths in m and tensions in kN to printed digits.
S3_SINKERS = {
    100e3: (62.72, 506.15),
    150e3: (53.56, 520.95),
    200e3: (47.21, 540.35),
    250e3: (42.73, 563.84),
    300e3: (39.50, 590.88),
}


def case(find: Find, load: Load | None, line: Line = TANKER) -> Case:
    return Case(Site(20.0), line, load, 20.0, checks=Checks(5.0), title="Tanker", find=find)


@pytest.mark.parametrize("weight", S3_SINKERS)
def test_the_lengths_of_s3_with_a_sinker(weight: float) -> None:
    line = Line(TANKER.segments, [PointLoad(7.0, weight)])
    flat = Find("length", anchor_angle=0.0)
    solution = solve_case(case(flat, Load(horizontal_force=450e3), line))
    length, tension = S3_SINKERS[weight]
    assert solution.found is not None
    assert round(solution.found.value, 2) == length
    assert round(solution.fairlead.tension / 1e3, 2) == tension
    assert (solution.found.number, solution.found.unit) == (1, "m")
    assert abs(solution.found.residual) <= 1e-12
    assert solution.title == "Tanker"


def test_every_quantity_that_a_case_may_seek_is_that_of_its_function() -> None:
    H, T = Load(horizontal_force=450e3), Load(fairlead_tension=500e3)
    two = Line([Segment(30.0, 300.0), Segment(40.0, 2100.0, MBL=7e6)])
    loaded = Line(TANKER.segments, [PointLoad(3.0, 1e3), PointLoad(7.0, 1e3)])
    asked = [
        (
            case(Find("length", segment=1, anchor_angle=0.1), H, two),
            find_length(two, height=20.0, horizontal_force=450e3, segment=0, anchor_angle=0.1),
        ),
        (
            case(Find("length", grounded_length=5.0), T, two),
            find_length(two, height=20.0, fairlead_tension=500e3, grounded_length=5.0),
        ),
        (
            case(Find("clump_weight", anchor_angle=0.0), H, loaded),
            find_clump_weight(loaded, height=20.0, horizontal_force=450e3),
        ),
        (
            case(Find("clump_weight", point_load=2, anchor_angle=0.0), Load(span=50.3), loaded),
            find_clump_weight(loaded, height=20.0, span=50.3, point_load=1),
        ),
        (case(Find("touchdown_force"), None), find_touchdown_force(TANKER, height=20.0)),
        (
            case(Find("limit_force"), None),
            find_limit_force(TANKER, height=20.0, safety_factor=5.0),
        ),
        (
            case(Find("limit_force", segment=2), None, two),
            find_limit_force(two, height=20.0, safety_factor=5.0, segment=1),
        ),
    ]
    for each, direct in asked:
        assert find_case(each).alone() == direct.alone()
        solved = solve_case(each)
        assert solved.found == direct.alone()
        assert solved.line == direct.solution.line


def test_a_case_whose_question_does_not_fit_is_refused_with_all_that_is_wrong() -> None:
    with pytest.raises(InputError) as caught:
        case(Find("length", segment=2, anchor_angle=0.0), Load(span=50.0))
    assert [problem.key for problem in caught.value.problems] == ["find.segment"]
    with pytest.raises(InputError, match="load: missing"):
        case(Find("clump_weight", anchor_angle=0.0), None)
    with pytest.raises(InputError, match="load: found span; leave it out"):
        case(Find("touchdown_force"), Load(span=50.0))
    with pytest.raises(InputError, match=r"line\.segments\[0\]\.MBL: missing"):
        case(Find("limit_force", segment=1), None, Line([Segment(55.0, 2100.0)]))


def test_length_to_angle_to_length() -> None:
    """The angle of any line that lifts its anchor leads back to its length, to 1e-10."""
    tried = 0
    for seed in range(60):
        s = random_setting(seed, raised=False)
        there = solve(s.line, height=s.height, horizontal_force=s.horizontal_force)
        angle = there.anchor.angle
        if angle < 1e-3:
            continue
        tried += 1
        back = find_length(
            s.line, height=s.height, horizontal_force=s.horizontal_force, anchor_angle=angle
        )
        # Of a flat straight line the angle hardly tells the length, hence L / h.
        allowed = 1e-10 * s.line.length * s.line.length / s.height
        assert back.value == pytest.approx(s.line.segments[-1].length, abs=allowed), seed
    assert tried >= 25


def test_no_clump_weight_needed() -> None:
    line = Line([Segment(100.0, 2100.0)], [PointLoad(7.0, 1.0)])
    with pytest.raises(NoAnswerError, match="no clump weight is needed"):
        find_clump_weight(line, height=20.0, horizontal_force=100e3)


def test_a_weightless_line_never_lies_flat() -> None:
    with pytest.raises(NoAnswerError, match="no length gives"):
        find_length(Line([Segment(30.0, 0.0)]), height=20.0, horizontal_force=1e3, anchor_angle=0.0)


def test_wrong_questions() -> None:
    with pytest.raises(InputError, match="exactly one is required"):
        find_length(TANKER, height=20.0, horizontal_force=1e5)
    with pytest.raises(InputError, match="from 0 to 0"):
        find_length(TANKER, height=20.0, horizontal_force=1e5, anchor_angle=0.0, segment=3)
    with pytest.raises(InputError, match="the line has none"):
        find_clump_weight(TANKER, height=20.0, horizontal_force=1e5)
    with pytest.raises(InputError, match="needs its MBL"):
        find_limit_force(Line([Segment(55.0, 2100.0)]), height=20.0)


def test_what_is_wrong_at_every_value_is_told() -> None:
    asked = {"height": 20.0, "horizontal_force": 1e5, "anchor_angle": 0.0}
    for key, value in (
        ("seabed_friction", -1.0),
        ("height", math.nan),
        ("height", -1.0),
        ("horizontal_force", -1.0),
        ("horizontal_force", "x"),
    ):
        with pytest.raises(InputError, match=key):
            find_length(TANKER, **{**asked, key: value})  # type: ignore[arg-type]
    with pytest.raises(InputError, match="seabed_friction"):
        find_touchdown_force(TANKER, height=20.0, seabed_friction=-1.0)


# --- hard cases: lines that float, contact states, and what bounds a length ----------------------

HARD = Path(__file__).parents[1] / "hard_cases"


def test_a_length_of_what_floats() -> None:
    """A rope of -5 N/m from the anchor under 180 m of chain of 50 N/m that touches the bed.

    With hypot(H, V0) = H / cos(2 deg) at the anchor and V1 at the end of the rope, which is as high
    as the chain hangs from there down to the bed: (hypot(H, V0) - hypot(H, V1)) / 5 =
    (hypot(H, V1) - H) / 50. The rope's length is (V0 + V1) / 5: 27.2864 m.
    """
    H = 2000.0
    at_anchor = H / math.cos(math.radians(2.0))
    at_joint = (at_anchor + 0.1 * H) / 1.1
    V0, V1 = H * math.tan(math.radians(2.0)), math.sqrt(at_joint**2 - H**2)
    assert (V0 + V1) / 5.0 == pytest.approx(27.2864, abs=5e-5)
    found = find_case(read_case(HARD / "find_length_floating.toml"))
    assert found.value == pytest.approx((V0 + V1) / 5.0, rel=1e-9)


def _rise_from_a_flat_anchor(H: float) -> float:
    """24 m of chain of 400 N/m, a buoy of 2400 N, 36 m more: how high that rises, m."""
    below, above, top = 24.0 * 400.0, 24.0 * 400.0 - 2400.0, 60.0 * 400.0 - 2400.0
    lower = math.hypot(H, below) - H
    return (lower + math.hypot(H, top) - math.hypot(H, above)) / 400.0


def test_a_line_with_a_buoy_just_touches_the_bed() -> None:
    found = find_case(read_case(HARD / "find_touchdown_buoy.toml"))
    assert _rise_from_a_flat_anchor(found.value) == pytest.approx(12.0, rel=1e-12)


def test_a_contact_state_is_solved_at_every_float() -> None:
    """Where the touchdown comes to the anchor neither regime holds to the last digit."""
    line = Line([Segment(60.0, 400.0)], [PointLoad(24.0, -2400.0)])
    force = find_touchdown_force(line, height=12.0).value
    for way in (0.0, math.inf):
        beside = force
        for _ in range(20):
            assert solve(line, height=12.0, horizontal_force=beside).span == pytest.approx(
                solve(line, height=12.0, horizontal_force=force * (1.0 + 1e-12)).span, rel=1e-9
            )
            beside = math.nextafter(beside, way)


def test_a_length_bounded_by_its_point_load() -> None:
    """10 m of height under 1 kN take 12.25 m of 400 N/m: at the 60 m up to the load it lies."""
    line = Line([Segment(100.0, 400.0)], [PointLoad(60.0, 1000.0)])
    found = find_length(line, height=10.0, horizontal_force=1000.0, anchor_angle=0.0)
    assert found.value == pytest.approx(60.0, rel=1e-11)
    assert found.solution.anchor.angle == 0.0


def test_every_length_lies_at_the_anchor() -> None:
    """The other segment alone lies at the anchor: there is no shortest length to be named."""
    line = Line([Segment(10.0, 400.0), Segment(90.0, 400.0)])
    with pytest.raises(NoAnswerError, match="every length gives"):
        find_length(line, height=10.0, horizontal_force=1e3, segment=0, anchor_angle=0.0)


def test_every_length_that_gives_it_is_named() -> None:
    """Chain above a rope that floats, under one tension: both lengths named give what is asked."""
    asked = question(150)
    assert asked is not None
    found = asked.ask()
    (said,) = (str(each) for each in found.solution.warnings if "another length" in str(each))
    others = [float(each) for each in re.findall(r"length: ([\d.]+) m", said)]
    assert others
    for value in (found.value, *others):
        assert asked.reading(asked.at(value)) == pytest.approx(asked.wanted, rel=1e-4)


@pytest.mark.slow
def test_no_question_is_refused_or_answered_wrongly() -> None:
    """Against a scan of its own; 1,000 questions went through it when it was written."""
    asked, faults = run(5000, 20)
    assert asked == 20
    assert faults == {}


def test_numbers_of_numpy_are_numbers() -> None:
    assert Segment(np.int64(5), 1.0).length == 5  # type: ignore[arg-type]
    with pytest.raises(InputError, match="found -1; must be above 0 m"):
        Segment(np.int64(-1), 1.0)  # type: ignore[arg-type]


def test_all_that_is_wrong_is_said_at_once() -> None:
    with pytest.raises(InputError) as caught:
        find_length(TANKER, height="20 kN", horizontal_force=450e3, anchor_angle="5 m")  # type: ignore[arg-type]
    assert [each.key for each in caught.value.problems] == ["height", "anchor_angle"]
