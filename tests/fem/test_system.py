"""Several lines that meet in a body: balance, symmetry, and one line as a system of one."""

from __future__ import annotations

import math

import numpy as np
import pytest

import catopt
from catopt.fem import Current, DragSection, Leg, SystemSolution, Water, solve_line, solve_system
from catopt.model import Line, PointLoad, Segment

LINE = Line([Segment(300.0, 300.0, EA=4e8), Segment(200.0, 1200.0, EA=8e8)],
            [PointLoad(320.0, 3e4)])  # fmt: skip
RADIUS, HEIGHT = 455.0, 80.0


def ring(turn: float, count: int = 3, fairlead: float = 0.0) -> list[Leg]:
    angles = [turn + 2 * math.pi * k / count for k in range(count)]
    return [
        Leg(
            LINE,
            (RADIUS * math.cos(a), RADIUS * math.sin(a), 0.0),
            (fairlead * math.cos(a), fairlead * math.sin(a), 0.0),
        )
        for a in angles
    ]


def at_rest(turn: float, force: tuple[float, float]) -> SystemSolution:
    return solve_system(ring(turn), height=HEIGHT, force=force, elements=60)


def test_lines_balance_the_force_on_the_body() -> None:
    solution = at_rest(0.3, (4e5, -1.5e5))
    # The solver's 1e-10 of the largest tension.
    assert solution.force[:2] == pytest.approx((-4e5, 1.5e5), abs=1e-3)
    assert solution.residual < 1e-10


def test_turning_the_layout_turns_the_answer() -> None:
    """Rounding, over the stiffness of the mooring."""
    turn = 0.8
    c, s = math.cos(turn), math.sin(turn)
    first, second = at_rest(0.1, (5e5, 0.0)), at_rest(0.1 + turn, (5e5 * c, 5e5 * s))
    x, y, _ = first.position
    assert second.position[:2] == pytest.approx((c * x - s * y, s * x + c * y), abs=1e-6)
    for a, b in zip(first.lines, second.lines, strict=True):
        assert a.tension == pytest.approx(b.tension, rel=1e-6)


def test_without_a_force_equal_lines_share_by_symmetry() -> None:
    solution = at_rest(0.3, (0.0, 0.0))
    assert solution.position[:2] == pytest.approx((0.0, 0.0), abs=1e-6)
    for line in solution.lines[1:]:
        assert line.tension == pytest.approx(solution.lines[0].tension, rel=1e-7)


def test_a_held_body_gives_each_line_its_own_answer() -> None:
    """No coupling: each line as solved alone at its span."""
    legs = ring(0.0, fairlead=5.0)
    solution = solve_system(legs, height=HEIGHT, position=(6.0, 2.0), elements=60)
    for leg, line in zip(legs, solution.lines, strict=True):
        way = np.array([6.0, 2.0, HEIGHT]) + leg.fairlead - np.array(leg.anchor)
        alone = solve_line(LINE, height=HEIGHT, span=float(np.hypot(*way[:2])), elements=60)
        assert line.span == pytest.approx(alone.span, rel=1e-13)
        assert line.tension == pytest.approx(alone.tension, rel=1e-8)


def test_one_line_under_a_force_is_a_system_of_one() -> None:
    leg = Leg(LINE, (-RADIUS, 0.0, 0.0))
    system = solve_system([leg], height=HEIGHT, force=(3e5, 0.0), elements=60)
    alone = solve_line(LINE, height=HEIGHT, horizontal_force=3e5, elements=60)
    assert system.position[0] + RADIUS == pytest.approx(alone.span, rel=1e-10)
    assert system.lines[0].fairlead.tension == pytest.approx(alone.fairlead.tension, rel=1e-10)


def test_system_agrees_with_the_closed_form_of_its_lines() -> None:
    """The horizontal forces of the closed form, at the truss's offset, balance to 0.01 %."""
    solution = solve_system(ring(0.2), height=HEIGHT, force=(6e5, 1e5), elements=[100, 400])
    total = np.zeros(2)
    for leg in ring(0.2):
        way = np.array(leg.anchor[:2]) - solution.position[:2]
        span = float(np.hypot(*way))
        total += catopt.solve(LINE, height=HEIGHT, span=span).horizontal_force * way / span
    assert total == pytest.approx([-6e5, -1e5], abs=1e-4 * 6e5)


def test_going_on_from_a_neighbour_gives_the_same_answer() -> None:
    """From a start the way is shorter, the equilibrium the same: to the solver's tolerance."""
    first = at_rest(0.0, (2e5, 0.0))
    direct = at_rest(0.0, (6e5, 1e5))
    onwards = solve_system(ring(0.0), height=HEIGHT, force=(6e5, 1e5), elements=60, start=first)
    assert onwards.position == pytest.approx(direct.position, abs=1e-6)
    back = solve_system(ring(0.0), height=HEIGHT, force=(2e5, 0.0), elements=60, start=onwards)
    assert back.position == pytest.approx(first.position, abs=1e-6)
    held = solve_system(ring(0.0), height=HEIGHT, position=(0.0, 0.0), elements=60)
    moved = solve_system(
        ring(0.0), height=HEIGHT, position=onwards.position[:2], elements=60, start=held
    )
    assert moved.force[:2] == pytest.approx((-6e5, -1e5), abs=1.0)


def test_a_current_pushes_the_body_of_a_mooring() -> None:
    """With drag on every line the body goes with the flow."""
    current = Current(lambda x: np.tile([1.0, 0.0, 0.0], (len(x), 1)), [DragSection(0.1, 1.2)] * 2)
    solution = solve_system(
        ring(0.0), height=HEIGHT, force=(0.0, 0.0), elements=60, water=Water(current=current)
    )
    assert solution.position[0] > 0.01
    assert solution.position[1] == pytest.approx(0.0, abs=1e-4)
