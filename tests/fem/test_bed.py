"""The bed: what lies on it, what it carries, how it rubs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import catopt
from catopt.fem import Bed, RestrainedBed, TrussSolution, mesh_line, solve_line
from catopt.model import Line, PointLoad, Segment

W, EA = 1000.0, 5e8
CHAIN = Line([Segment(600.0, W, EA=EA)])


def test_a_rigid_bed_is_not_passed_and_only_pushes() -> None:
    solution = solve_line(CHAIN, height=100.0, horizontal_force=2e5, elements=300)
    assert solution.nodes[:, 2].min() > -1e-9
    assert solution.penetration < 1e-9
    assert solution.bed_reaction.min() == 0.0
    assert solution.touchdowns == 1


def test_bed_and_ends_carry_the_weight() -> None:
    """Sum of vertical forces; rounding and the solver's 1e-10 of the tension at each node."""
    line = Line([Segment(600.0, W, EA=EA)], [PointLoad(300.0, 4e4)])
    solution = solve_line(line, height=100.0, horizontal_force=2e5, elements=300)
    carried = solution.bed_reaction.sum() + solution.fairlead.vertical_force
    assert carried + solution.anchor.vertical_force * -1.0 == pytest.approx(
        line.submerged_weight, rel=1e-9
    )


def test_touchdown_is_found_within_a_bar() -> None:
    """As the line is pulled, touchdown runs through three bars of 10 m: by hand, to 2 cm.

    s = sqrt(h (h + 2 a)) hangs, whatever the nodes; second order, 60**-2 of the 250 m that hang.
    """
    line = Line([Segment(600.0, W)])
    for force in np.linspace(2.6e5, 3.2e5, 13).tolist():
        hangs = math.sqrt(100.0 * (100.0 + 2 * force / W))
        solution = solve_line(line, height=100.0, horizontal_force=force, elements=60)
        assert solution.grounded_length == pytest.approx(600.0 - hangs, abs=250.0 / 60**2)


def test_soft_bed_is_pressed_in_by_weight_over_stiffness_and_hardens_to_the_rigid_one() -> None:
    """Far from touchdown the line lies w/k deep; the answer nears the rigid bed's with k."""
    rigid = solve_line(CHAIN, height=100.0, span=570.0, elements=200)
    off = []
    for stiffness in (1e4, 1e5, 1e6):
        soft = solve_line(
            CHAIN, height=100.0, span=570.0, elements=200, bed=Bed(normal_stiffness=stiffness)
        )
        # Node 1 is next to the anchor, which is not pressed in; node 30 is far from both ends.
        assert soft.nodes[30, 2] == pytest.approx(-W / stiffness, rel=1e-3)
        assert soft.penetration < 1.1 * W / stiffness
        off.append(abs(soft.fairlead.tension / rigid.fairlead.tension - 1.0))
    assert off[0] > off[1] > off[2]
    assert off[2] < 1e-4


def test_clump_weight_on_partly_off_and_off_the_bed() -> None:
    """Its reaction falls from its weight to nothing as the line is pulled; hand formula between.

    While it is partly lifted the line leaves the bed at it: with a = H/w the hanging length is
    s = sqrt(h (h + 2 a))-like with V0 at its foot: V0 = w-free root of h(V0, H), and the bed
    carries W - V0. The closed form has just that.
    """
    line = Line([Segment(300.0, W)], [PointLoad(150.0, 5e4)])
    states = []
    for force in (2e4, 1.2e5, 1.6e5, 6e5):
        truss = solve_line(line, height=80.0, horizontal_force=force, elements=600)
        closed = catopt.solve(line, height=80.0, horizontal_force=force)
        reaction = closed.point_loads[0].seabed_reaction
        # The truss cannot tell the line's own weight at the node (500 N on each side) from it.
        assert truss.point_load_reaction()[0] == pytest.approx(reaction, abs=510.0)
        states.append(reaction)
    assert states[0] == 5e4
    assert 0.0 < min(states[1:3]) < 5e4
    assert states[3] == 0.0


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_a_buoy_that_makes_the_line_touch_the_bed_twice(friction: float) -> None:
    """The truss balances every node to 1e-8 of the tension, and agrees with the closed form.

    The arch is that of a line with a point load, level on both sides: each side hangs P/(2 w).
    """
    buoyancy, H = 6e4, 1.5e5
    line = Line([Segment(450.0, W, EA=EA)], [PointLoad(120.0, -buoyancy)])
    setting: dict[str, Any] = {"height": 80.0, "seabed_friction": friction}
    closed = catopt.solve(line, horizontal_force=H, **setting)
    found = []
    mesh = mesh_line(line, 450)
    for _ in range(2):
        truss = solve_line(line, horizontal_force=H, mesh=mesh, **setting)
        assert truss.residual < 1e-8
        assert truss.touchdowns == 2
        found.append(truss)
        mesh = mesh.refined()
    truss = found[-1]
    node = truss.mesh.load_node[0]
    side = buoyancy / (2 * W)
    pull = H - friction * W * _lying_beyond(truss, node)
    # Second order: bars of 0.5 m on an arch of 60 m leave 1e-4; stretch is 3e-4.
    arch = pull / W * (math.hypot(1.0, W * side / pull) - 1.0)
    assert truss.nodes[node, 2] == pytest.approx(arch, rel=2e-3)
    hanging = math.sqrt(80.0**2 + 2 * 80.0 * H / W)
    assert truss.grounded_length == pytest.approx(450.0 - 2 * side - hanging, abs=0.1)
    # What the error of second order still is on the finer mesh: a third of the last change.
    left = abs(found[0].span - found[1].span) / 3.0
    assert left < 1e-6 * closed.span
    assert truss.span == pytest.approx(closed.span, abs=1.5 * left)
    assert truss.nodes[node, 2] == pytest.approx(closed.point_loads[0].z, rel=1e-4)
    assert truss.anchor.tension == pytest.approx(closed.anchor.tension, abs=1e-4 * H)


def _lying_beyond(truss: TrussSolution, node: int) -> float:
    """Length on the bed between a node and the fairlead, m."""
    return float(truss.bed_reaction[node:].sum()) / W


def test_friction_of_a_pulled_line_runs_out() -> None:
    """Tension falls by mu w l from the touchdown; beyond where it is used up, nothing is left."""
    solution = solve_line(
        CHAIN, height=100.0, horizontal_force=2e5, seabed_friction=0.9, elements=1200
    )
    fall = np.diff(solution.tension[200:600]) / solution.mesh.length[0]
    sliding = solution.tension[200:599] > 2 * 0.9 * W * solution.mesh.length[0]
    assert fall[sliding] == pytest.approx(np.full(sliding.sum(), 0.9 * W), rel=1e-6)
    assert np.count_nonzero(sliding) > 150
    assert solution.anchor.tension == 0.0
    assert solution.tension.min() > -1e-8 * solution.fairlead.tension


def test_history_pull_and_let_go_leaves_tension_locked_in() -> None:
    """Laid, pulled, let go: friction that resisted the pull then resists the return.

    While pulled, history and the "pulled" law agree but for the half bar at the anchor, which has
    no spring, and the last millimetres of slip (500 N of friction a metre over 1e6 N/m2).
    Let go, the anchor keeps more than the touchdown has, by mu w l at most.
    """
    mu = 0.5
    bed = Bed(friction_law="history")
    mesh = mesh_line(CHAIN, 200)
    setting: dict[str, Any] = {"height": 100.0, "seabed_friction": mu, "mesh": mesh}
    laid = solve_line(CHAIN, horizontal_force=5e4, bed=bed, **setting)
    assert laid.tension[0] == pytest.approx(5e4, rel=1e-6)
    pulled = solve_line(CHAIN, horizontal_force=4e5, bed=bed, start=laid, **setting)
    law = solve_line(CHAIN, horizontal_force=4e5, **setting)
    half_bar = mu * W * 0.5 * mesh.length[0]
    assert pulled.anchor.tension == pytest.approx(law.anchor.tension + half_bar, rel=5e-3)
    let_go = solve_line(CHAIN, horizontal_force=5e4, bed=bed, start=pulled, **setting)
    locked = let_go.anchor.tension - 5e4
    assert 1e5 < locked <= mu * W * let_go.grounded_length
    assert let_go.tension[:-80].max() <= 5e4 + mu * W * let_go.grounded_length
    again = solve_line(CHAIN, horizontal_force=4e5, bed=bed, start=let_go, **setting)
    assert again.anchor.tension == pytest.approx(pulled.anchor.tension, rel=5e-3)


def test_held_bed_holds_both_ways() -> None:
    """By hand: held nodes keep z = 0 and the hanging part is that of a line anchored there."""
    held = solve_line(
        CHAIN, height=100.0, horizontal_force=6e5, elements=60, bed=RestrainedBed(400.0, 10.0)
    )
    assert np.abs(held.nodes[:41, 2]).max() == 0.0
    assert held.bed_reaction[40] < 0.0
    assert held.tension[:40] == pytest.approx(np.full(40, 6e5), rel=1e-9)
    short = Line([Segment(200.0, W, EA=10 * EA)])
    alone = solve_line(short, height=100.0, horizontal_force=6e5, elements=20)
    assert held.fairlead.tension == pytest.approx(alone.fairlead.tension, rel=1e-9)


def test_a_line_too_long_for_its_span_hangs_straight_down() -> None:
    """Slack: no horizontal force. The tension is the hanging weight, to the length of one bar."""
    solution = solve_line(CHAIN, height=100.0, span=300.0, elements=300)
    bar = solution.mesh.length[0]
    assert solution.fairlead.tension == pytest.approx(100.0 * W, abs=bar * W)
    assert abs(solution.horizontal_force) < 1e-6 * solution.fairlead.tension
    assert solution.tension.min() > -1e-9 * solution.fairlead.tension
