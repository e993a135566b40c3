"""A sizing is judged in motion unless it is told otherwise."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

import catopt
from catopt.answers.blocks import Table
from catopt.answers.size import tried_blocks
from catopt.answers.size_card import counted_words
from catopt.checks.kinds import CheckSource
from catopt.checks.result import CheckResult
from catopt.errors import InputError
from catopt.sizing.in_motion import LineTried, with_margin
from catopt.sizing.input_values import input_values
from catopt.sizing.quick import quick_runs, shared_out
from catopt.sizing.requests import request_of

BUOY: dict[str, Any] = {"buoy": "pillar 1.8 m", "depth": "12 m"}
SHIP: dict[str, Any] = {"dwt": "50000 t", "depth": "20 m"}


@pytest.mark.parametrize(("moored", "given"), [("buoy", BUOY), ("tanker", SHIP)])
def test_motion_is_judged_fast_in_full_or_not_at_all(moored: Any, given: dict[str, Any]) -> None:
    usual = request_of(input_values(moored, given, source="")).in_motion
    full = request_of(input_values(moored, given | {"in_motion": True}, source="")).in_motion
    still = request_of(input_values(moored, given | {"at_rest": True}, source="")).in_motion
    assert usual is not None
    assert full is not None
    assert (usual.quick, full.quick, still) == (True, False, None)


def test_at_rest_and_in_motion_are_not_both() -> None:
    with pytest.raises(InputError, match="in_motion"):
        request_of(input_values("buoy", BUOY | {"at_rest": True, "in_motion": True}, source=""))


def test_a_buoy_of_which_the_force_alone_is_known_is_not_judged_in_motion() -> None:
    found = catopt.size_buoy(force="5 kN", reserve_buoyancy="12 kN", depth="12 m")
    assert found.in_motion is None
    assert found.judgement.colour == "amber"
    assert "motion" in {each.subject for each in found.judgement.not_judged}


def test_the_time_of_a_buoy_s_line_is_shared_out() -> None:
    """1600 s in all; a run is no shorter than a minute."""
    how = quick_runs("buoy")
    assert [shared_out(how, count).duration for count in (1, 4, 100)] == [1600.0, 400.0, 60.0]


def test_a_margin_is_on_what_hangs_on_few_peaks() -> None:
    """100 kN of 110 are 125 of 110: beyond by 15/110. The pull down is a mean: it stays."""
    of = CheckResult("", "tension", "", 100e3, 110e3, "N", -10 / 110, CheckSource("", "", "A"))
    taken = with_margin(of, quick_runs("buoy"))
    assert taken.demand == 125e3
    assert taken.exceedance == pytest.approx(15 / 110, rel=1e-12)
    assert not taken.passes
    assert with_margin(of, quick_runs("tanker")) is of


@pytest.mark.parametrize(("demand", "by_margin"), [(124e3, True), (126e3, False)])
def test_a_line_that_fails_by_the_margin_alone_is_run_in_full(
    demand: float, *, by_margin: bool
) -> None:
    of = CheckResult("", "tension", "", demand, 100e3, "N", 0.24, CheckSource("", "", "A"))
    tried = LineTried("chain", 0.03, 38.0, 600.0, 2, (of,))
    assert tried.fails_by_margin(quick_runs("buoy").margin) is by_margin
    assert not replace(tried, failing=()).fails_by_margin(1.25)
    assert not replace(tried, failing=(), reason="capsizes").fails_by_margin(1.25)


@pytest.mark.slow
def test_the_buoy_of_readme_passes_in_full_where_the_margin_leaves_none() -> None:
    """Its thickest chain comes to 0.81 of the allowable tension, and 1.02 with the margin."""
    found = catopt.size_buoy(**BUOY)
    assert found.passes
    assert found.in_motion is not None
    assert not found.in_motion.how.quick
    assert found.in_motion.checks.is_proven
    # What the fast judgement ran before is told, with its margin, and stands in the table.
    fast = found.in_motion.fast
    assert fast
    assert any(each.fails_by_margin(1.25) for each in fast)
    assert not any(each.passes for each in fast)
    (table,) = (one for one in tried_blocks(found.in_motion) if isinstance(one, Table))
    assert len(table.columns[0].values) == len(fast) + len(found.in_motion.tried)
    said = str(counted_words(found.in_motion))
    assert f"before, {len(fast)} by the fast judgement" in said
    assert "margin of 1.25" in said
