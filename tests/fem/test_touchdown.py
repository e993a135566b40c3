"""A touchdown on a node or next to one: lines whose truss is known by hand, bar by bar."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from catopt.fem import TrussSolution, solve_line
from catopt.fem.sloped_rest import shift_slope
from catopt.model import Line, PointLoad, Segment

BARS, LYING = 120, 47
"""Bars of the line, and of these the ones that lie wholly."""

W, L0 = 800.0, 0.5
"""Weight of a bar, N, and its length, m."""

PARTS = [0.0, *(10.0**-n for n in range(13, 0, -1)), *(1.0 - 10.0**-n for n in range(1, 13)), 1.0]
"""How much of a bar hangs: from nothing to all of it, and all but nothing of either."""


def rise(part: float, bars: int, H: float, EA: float) -> float:
    """Height to which a bar that hangs in part and the bars after it climb, m.

    The first pulls with V = W part**2 / 2 at its node that lies; the node after it carries
    W (part - part**2 / 2) of it and half of the next bar, so that the bars then pull with
    W (part + 1/2), W (part + 3/2), ...
    """
    forces = [0.5 * W * part**2, *(W * (part + 0.5 + k) for k in range(bars))]
    height = 0.0
    for V in forces:
        T = math.hypot(H, V)
        height += L0 * (1.0 + T / EA) * V / T
    return height


def chain(bars: int, EA: float) -> Line:
    return Line([Segment(L0 * bars, W / L0, EA=EA)])


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("EA", [math.inf, 4e7])
def test_touchdown_comes_as_near_to_a_node_as_you_like(
    part: float, friction: float, EA: float
) -> None:
    """The part of the bar that hangs is found to 1e-6 of the bar: 1e-10 of the tension, over W."""
    H = 5e4
    hanging = BARS - LYING - 1
    truss = solve_line(
        chain(BARS, EA), height=rise(part, hanging, H, EA), horizontal_force=H,
        seabed_friction=friction, elements=BARS,
    )  # fmt: skip
    assert truss.grounded_length == pytest.approx(L0 * (LYING + 1.0 - part), abs=1e-6 * L0)
    assert truss.fairlead.vertical_force == pytest.approx(W * (part + hanging), rel=1e-6)
    assert truss.residual < 1e-10
    # The path takes some 25 iterations from a straight start wherever the touchdown is.
    assert truss.iterations < 60


@pytest.mark.parametrize("right", [0.0, 1e-9, 1e-5, 1.0])
@pytest.mark.parametrize("left", [0.0, 1e-10, 1e-6, 1e-4, 1.0])
def test_a_raised_anchor_lets_both_touchdowns_be_near_a_node(left: float, right: float) -> None:
    H, EA, beyond, lying, towards = 8e4, 4e7, 40, 21, 30
    truss = solve_line(
        chain(towards + lying + beyond + 2, EA), height=rise(right, beyond, H, EA),
        anchor_height=rise(left, towards, H, EA), horizontal_force=H,
        elements=towards + lying + beyond + 2,
    )  # fmt: skip
    assert truss.grounded_length == pytest.approx(L0 * (lying + 2.0 - left - right), abs=1e-5 * L0)
    assert truss.residual < 1e-10


@pytest.mark.parametrize("elements", [150, 200, 400, 800])
def test_a_clump_weight_near_the_anchor_lifts_the_line_off_at_a_node(elements: int) -> None:
    """A design of the tanker case: 0.24998 m lie, with nodes 0.25 m apart on 150 bars."""
    w = 1705.232770700637
    line = Line([Segment(40.0, w, EA=816814089.9333464)], [PointLoad(3.0, 252827.69531250003)])
    truss = solve_line(line, height=20.0, horizontal_force=450e3, elements=elements)
    assert truss.residual < 1e-10
    hangs = (truss.fairlead.vertical_force - 252827.69531250003) / w
    # What lies carries itself: balance of the whole line, to 1e-10 of the tension.
    assert truss.grounded_length == pytest.approx(40.0 - hangs, abs=1e-6)


def test_going_on_past_node_after_node_ends_where_a_fresh_start_does() -> None:
    """Pulled in small steps from one solution to the next, without friction."""
    line = chain(BARS, 4e7)
    truss: TrussSolution | None = None
    setting: dict[str, Any] = {"height": 12.0, "elements": BARS}
    for H in np.linspace(3e4, 3.4e4, 41).tolist():
        truss = solve_line(line, horizontal_force=H, start=truss, **setting)
        fresh = solve_line(line, horizontal_force=H, **setting)
        assert truss.residual < 1e-10
        assert truss.grounded_length == pytest.approx(fresh.grounded_length, abs=1e-6 * L0)


@pytest.mark.parametrize("wanted", [-0.3, 0.0, 1e-9, 1e-3, 0.4, 1.0, 1.7])
@pytest.mark.parametrize("part", [-0.2, 0.0, 1e-12, 1e-4, 0.5, 0.99])
def test_secant_leads_to_the_lift_of_the_part_that_has_to_hang(part: float, wanted: float) -> None:
    """(1 + slope) times the change of the lift is what is left over, W (wanted - part)."""

    def lift(r: float) -> float:
        return W * (r if r < 0.0 else 0.5 * r * r if r <= 1.0 else r - 0.5)

    left = W * (wanted - part)
    slope = shift_slope(lift(part), W, left)
    assert (1.0 + slope) * (lift(wanted) - lift(part)) == pytest.approx(left, abs=1e-9 * W)


def test_secant_is_the_tangent_where_nothing_is_left_over() -> None:
    """(1 - r)/r; and nothing more is shifted of a bar that hangs wholly or lies wholly."""
    assert shift_slope(0.5 * W * 0.3**2, W, 0.0) == pytest.approx(0.7 / 0.3, rel=1e-12)
    assert shift_slope(0.6 * W, W, 10.0) == 0.0
    assert shift_slope(-0.1 * W, W, -10.0) == 0.0
    assert shift_slope(5.0, 0.0, 1.0) == 0.0
