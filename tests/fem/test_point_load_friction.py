"""A point load's own friction where it rests on the bed: tension at the anchor by hand."""

from __future__ import annotations

import math

import pytest

from catopt.fem import Bed, solve_line
from catopt.model import Line, PointLoad, Segment

BED, OWN = 0.3, 0.9
W, PLACE, HEIGHT = 50e3, 50.0, 20.0


def line(friction: float | None = OWN) -> Line:
    return Line([Segment(200.0, 1000.0, EA=1e9)], [PointLoad(PLACE, W, friction=friction)])


def anchor_tension(
    friction: float | None, H: float = 1e5, elements: int = 200, bed: float = BED
) -> float:
    found = solve_line(
        line(friction), height=HEIGHT, horizontal_force=H, seabed_friction=bed, elements=elements
    )
    return found.anchor.tension


def test_a_clump_weight_that_rests_wholly() -> None:
    """H less 0.3 w of what lies and 0.9 W; 66.33 m hang, as sqrt(h (h + 2 H/w)) (S2)."""
    lying = 200.0 - math.sqrt(HEIGHT * (HEIGHT + 2.0 * 100.0))
    by_hand = 1e5 - BED * 1000.0 * lying - OWN * W
    # The stretch of 1e-4 and the bars of 1 m move the touchdown by some centimetres.
    assert anchor_tension(OWN) == pytest.approx(by_hand, abs=20.0)
    assert anchor_tension(None) - anchor_tension(OWN) == pytest.approx((OWN - BED) * W, rel=1e-9)
    assert anchor_tension(BED) == pytest.approx(anchor_tension(None), rel=1e-12)


def test_a_clump_weight_without_friction_on_a_rough_bed_and_the_other_way_round() -> None:
    assert anchor_tension(0.0) - anchor_tension(None) == pytest.approx(BED * W, rel=1e-9)
    for smooth in (0.0, 0):  # a whole number is as good
        tension = anchor_tension(0.5, bed=smooth)
        assert tension == pytest.approx(1e5 - 0.5 * W, rel=1e-9)


def test_a_clump_weight_that_is_lifted_in_part() -> None:
    """Above it 150 m hang: V(0) from the height, and the bed carries W - V(0) and 50 m of line."""
    H, w, length = 6e5, 1000.0, 150.0
    low, high = 0.0, W
    for _ in range(100):
        V = 0.5 * (low + high)
        rise = (math.hypot(H, V + w * length) - math.hypot(H, V)) / w
        low, high = (V, high) if rise < HEIGHT else (low, V)
    by_hand = H - OWN * (W - V) - BED * w * PLACE
    coarse, fine = (anchor_tension(OWN, H, bars) for bars in (200, 400))
    assert 0.0 < V < W
    # Bars of second order: the finer mesh is nearer, and right to the stretch of some 1e-4 of EA.
    stiff = (OWN * H / 1e9) * W + 200.0
    assert fine == pytest.approx(by_hand, abs=stiff)
    assert coarse == pytest.approx(fine, rel=1e-3)


def test_friction_with_a_history_slips_at_the_same_force() -> None:
    """Pulled up from 20 kN at the anchor, beyond all that springs on the way can hold.

    The half bar at the anchor, of 1 m, has no spring (docs/truss.md).
    """
    bed = Bed(friction_law="history", tangential_stiffness=1e9)
    start = solve_line(
        line(), height=HEIGHT, horizontal_force=2e4, seabed_friction=BED, bed=bed, elements=100
    )
    pulled = solve_line(
        line(), height=HEIGHT, horizontal_force=1.4e5, seabed_friction=BED, bed=bed,
        mesh=start.mesh, start=start,
    )  # fmt: skip
    assert pulled.anchor.tension == pytest.approx(
        anchor_tension(OWN, 1.4e5, 100) + BED * 1000.0 * 1.0, rel=1e-6
    )
