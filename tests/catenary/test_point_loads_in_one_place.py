"""Point loads in one place are one load on the bed and in the water."""

from __future__ import annotations

import pytest

from catopt import InputError, solve, solve_many
from catopt.model import Line, PointLoad, Segment
from tests.campaign.oracle import check

CHAIN = [Segment(50.0, 20.0)]


def line(*weights: float) -> Line:
    return Line(CHAIN, [PointLoad(30.0, weight) for weight in weights])


TOGETHER = [(400.0, 300.0), (300.0, 400.0), (1000.0, -300.0), (-100.0, -200.0, 1000.0)]


@pytest.mark.parametrize("weights", TOGETHER)
def test_they_hang_as_their_sum_hangs(weights: tuple[float, ...]) -> None:
    at = {"height": 15.0, "horizontal_force": 400.0, "seabed_friction": 0.6}
    both, one = solve(line(*weights), **at), solve(line(sum(weights)), **at)
    assert check(both, "horizontal_force", 400.0).is_right
    assert both.span == pytest.approx(one.span, rel=1e-14)
    assert both.anchor == one.anchor
    carried = [load.seabed_reaction for load in both.point_loads]
    assert sum(carried) == pytest.approx(one.point_loads[0].seabed_reaction, rel=1e-14)
    assert all(0.0 <= share <= max(w, 0.0) for share, w in zip(carried, weights, strict=True))
    many = solve_many(line(*weights), height=15.0, horizontal_force=400.0, seabed_friction=0.6)
    assert many.span[0] == pytest.approx(one.span, rel=1e-14)


def test_they_have_one_friction() -> None:
    with pytest.raises(InputError, match="give both the same"):
        Line(CHAIN, [PointLoad(30.0, 400.0), PointLoad(30.0, 300.0, friction=0.3)])
