"""The mean heel of a buoy: that of its mean place, whatever it rolls by."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from catopt.checks.case import Carried, LineInMotion, Pull, check_motion
from catopt.checks.verdict import Matter, not_judged
from catopt.errors import InputError
from catopt.floater.alone import HullHistory
from catopt.model import Buoy, Case, Checks, Floater, Line, LoadCase, Segment, Site
from catopt.model.dynamics import Dynamics
from catopt.model.sea import WaveState

NONE = np.zeros(0)


def hull(pitch: list[float], **kept: Any) -> HullHistory:
    place = np.zeros((len(pitch), 6))
    place[:, 4] = np.radians(pitch)
    free = np.ones(6, dtype=bool)
    return HullHistory(NONE, place, NONE, free, NONE, NONE, NONE, NONE, NONE, 0.0, 1.0, **kept)


def test_it_is_that_of_the_samples_that_count() -> None:
    """Of 80 (in the ramp), -10, 30 and 40 deg the last three have 20 deg on average."""
    counted = np.array([False, True, True, True])
    assert math.degrees(hull([80, -10, 30, 40]).mean_heel(counted)) == pytest.approx(20.0)
    kept = np.array([0.0, 0.0, 0.0, math.radians(3.0), math.radians(4.0), 0.0, 0.0])
    without = hull([], mean=kept).mean_heel(np.zeros(0, dtype=bool))
    # cos a = cos 3 cos 4: 4.999 deg, as two small turns add up by Pythagoras
    assert math.degrees(without) == pytest.approx(4.999, abs=1e-3)


def case(max_heel: float | None) -> Case:
    line = Line([Segment(30.0, submerged_weight=200.0, MBL=400e3)])
    return Case(
        Site(12.0),
        line,
        None,
        fairlead_height=12.0,
        load_cases=(LoadCase("storm", 6e3),),
        checks=Checks(safety_factor=3.0),
        buoy=Buoy(40e3),
        floater=Floater("pillar 1.8 m", max_heel=max_heel),
        waves=WaveState("jonswap", 2.0, 6.0),
        dynamics=Dynamics(600.0),
    )


def judged(max_heel: float | None, heel: float) -> Any:
    of, pull = case(max_heel), Pull(9e3, 0.0, 0.0)
    carried = Carried(pull, pull, 10.0, 25.0, 1e3, None, math.radians(heel))
    return check_motion(of, [LineInMotion(of.line, (20e3,), (6e3,), "storm", None, carried)])


def test_a_limit_judges_it_and_none_is_said() -> None:
    for heel, passes in ((4.9, True), (5.1, False)):
        (found,) = (e for e in judged(math.radians(5.0), heel).results if e.kind == "heel")
        assert found.passes is passes
        assert found.utilisation == pytest.approx(heel / 5.0)
    report = judged(None, 27.0)
    assert not any(each.kind == "heel" for each in report.results)
    left = not_judged(Matter(case(None), in_motion=replace(report, is_proven=True)))
    assert "heel" in [each.subject for each in left]
    judged_one = judged(math.radians(40.0), 27.0)
    left = not_judged(Matter(case(math.radians(40.0)), in_motion=judged_one))
    assert "heel" not in [each.subject for each in left]


@pytest.mark.parametrize("wrong", [0.0, math.radians(90.0), -0.1])
def test_a_limit_is_between_upright_and_lying(wrong: float) -> None:
    with pytest.raises(InputError, match="max_heel"):
        Floater("pillar 1.8 m", max_heel=wrong)
