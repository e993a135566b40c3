"""The campaign over sizings in motion, in small; and that it sees what is planted."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.campaign.in_motion import faults_of, judge
from tests.sizing.alone import alone
from tests.sizing.at_rest import size_tanker


@pytest.mark.slow
@pytest.mark.parametrize("number", [2, 4, 7])
def test_none_recommends_what_its_own_motion_fails(number: int) -> None:
    assert judge(number)[1] == []


@pytest.mark.slow
def test_an_anchor_that_is_too_light_is_seen() -> None:
    with alone():
        found = size_tanker(dwt="50000 t", depth="20 m", in_motion=True, seeds=2)
    assert faults_of(found) == []
    moved = found.in_motion
    assert moved is not None
    assert moved.case.anchor is not None
    half = replace(
        moved.case.anchor, holding_capacity=0.5 * (moved.case.anchor.holding_capacity or 0)
    )
    planted = replace(moved, case=replace(moved.case, anchor=half))
    assert "holding" in " ".join(faults_of(replace(found, in_motion=planted)))
