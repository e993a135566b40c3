"""The line's equations and their elimination: derivative by differences, solution by numpy."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from catopt.fem import Bed, Current, DragSection, Water, mesh_line
from catopt.fem.banded import DIAGONAL, REACH, WIDTH, back_substitute, eliminate
from catopt.fem.loads import bar_loads
from catopt.fem.mesh import Problem, build, one_point, straight
from catopt.fem.static_model import BarLoads, Law, Net, State
from catopt.fem.step import assemble
from catopt.model import Line, PointLoad, Segment

Array = npt.NDArray[np.float64]

LINE = Line([Segment(6.0, 900.0, EA=3e5, mass=110.0), Segment(6.0, 400.0, mass=60.0)],
            [PointLoad(4.0, 2e3)])  # fmt: skip
CURRENT = Current(
    lambda x: np.tile([1.2, 0.7, 0.1], (len(x), 1)),
    [DragSection(0.2, 1.4, 0.3), DragSection(0.1, 1.0, 0.5)],
)


NO_SIDE = np.zeros((0, 3))


def dense(band: Array) -> Array:
    """Whole matrix of a band."""
    rows = band.shape[0]
    matrix = np.zeros((rows, rows))
    for r in range(rows):
        for c in range(max(0, r - DIAGONAL), min(rows, r - DIAGONAL + WIDTH)):
            matrix[r, c] = band[r, c - r + DIAGONAL]
    return matrix


def equations(problem: Problem, state: State, ground: Any, law: Law) -> tuple[Array, Array]:
    """Matrix and right hand side at a state, which is left as it was."""
    count = problem.bars.length.size
    varies = problem.current is not None or math.isfinite(problem.surface)
    blocks = (count if varies else 0, 3, 3)
    loads = BarLoads(np.zeros((count, 3)), np.zeros(blocks), np.zeros(blocks))
    velocity = np.zeros((0, 3))
    if problem.current is not None:
        velocity = problem.current.velocity(np.zeros((count, 3)))
    bar_loads(state.x, problem.first_node, problem.bars, problem.surface, velocity, loads)
    band, rhs = np.zeros((4 * count + 3, WIDTH)), np.zeros(4 * count + 3)
    copy = State(*(a.copy() for a in state))  # type: ignore[arg-type]
    assemble(0, Net(problem.bars, copy, loads, problem.nodal, ground, law, band, rhs, NO_SIDE))
    return dense(band), rhs


def bent_state(problem: Problem, rng: np.random.Generator, on_bed: int) -> State:
    """Draw a line out of balance, its first nodes pressed on the bed."""
    nodes = problem.nodal.shape[0]
    state = straight(problem, np.zeros((1, 3)), np.array([[9.0, 1.0, 5.0]]))
    state.x[1:] += rng.normal(scale=0.1, size=(nodes - 1, 3))
    state.x[1 : on_bed + 1, 2] = 0.0
    state.contact[1 : on_bed + 1] = 1
    problem.nodal[1 : on_bed + 1, 2] -= 2e4
    state.tension[:] = rng.uniform(3e3, 6e3, nodes - 1)
    return state


CASES = [
    ("hanging", Bed(), 0.0, Water(), 0),
    ("rigid bed", Bed(), 0.0, Water(), 4),
    ("rubbing", Bed(), 0.3, Water(), 4),
    ("touching down", Bed(), 0.3, Water(), 4),
    ("held by friction", Bed(), 50.0, Water(), 4),
    ("history", Bed(friction_law="history", tangential_stiffness=1e3), 0.3, Water(), 4),
    ("current", Bed(), 0.0, Water(current=CURRENT), 0),
    ("surface", Bed(), 0.0, Water(surface=3.2), 0),
    ("soft bed", Bed(normal_stiffness=1e4), 0.4, Water(), 4),
]


@pytest.mark.parametrize(("name", "bed", "friction", "water", "on_bed"), CASES)
def test_matrix_is_the_derivative_of_the_residual(
    name: str, bed: Bed, friction: float, water: Water, on_bed: int
) -> None:
    """Central differences: 1e-6 of the largest coefficient is their error in h**2 and rounding.

    Friction's dependence on the reaction, drag's on direction and weight's on the water line are
    all in it; only the water's velocity is taken to stay the same.
    """
    rng = np.random.default_rng(7)
    body = one_point(np.array([1.0, 1.0, 0.0]), np.array([1e4, 0.0, 0.0]), np.zeros(3), 1)
    problem = build([mesh_line(LINE, 12)], body, bed, friction, water, False)
    state = bent_state(problem, rng, on_bed)
    ground = problem.ground
    if math.isfinite(bed.normal_stiffness):
        state.x[1 : on_bed + 1, 2] = -rng.uniform(0.05, 0.1, on_bed)
    if name == "history":
        feet = state.x[:, :2] - rng.choice([0.05, 3.0], (state.x.shape[0], 1))
        ground = ground._replace(spring_foot=feet)
    if name == "touching down":
        state.x[5:, 2] *= 0.02 / state.x[5, 2]  # so that the bar before it hangs in part
    law = Law(0.0, problem.soft, 0.0, False, 0.0)
    if name == "touching down":
        # Where the hanging node is in balance, the bar's secant (`shift_slope`) is the derivative.
        left = -law.soft * equations(problem, state, ground, law)[1][4 * 4 + 6]
        problem.nodal[5, 2] -= left
    matrix, _ = equations(problem, state, ground, law)
    count = problem.bars.length.size
    slopes = np.zeros_like(matrix)
    for column in range(4 * count + 3):
        sides = []
        for sign in (1.0, -1.0):
            moved = State(*(a.copy() for a in state))  # type: ignore[arg-type]
            node, part = divmod(column, 4)
            h = 1e-6
            if part == 3:
                moved.tension[node] += sign * h * law.soft
            else:
                moved.x[node, part] += sign * h
            sides.append(equations(problem, moved, ground, law)[1])
        slopes[:, column] = -(sides[0] - sides[1]) / (2 * h)
    assert np.abs(slopes - matrix).max() < 1e-6 * np.abs(matrix).max()


@pytest.mark.parametrize("seed", range(5))
def test_elimination_agrees_with_numpy(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rows = 40
    band = np.zeros((rows, WIDTH))
    for r in range(rows):
        for c in range(max(0, r - REACH), min(rows, r + REACH + 1)):
            band[r, c - r + DIAGONAL] = rng.normal()
    band[5, DIAGONAL] = 0.0  # a pivot that has to be sought
    rhs = rng.normal(size=rows)
    matrix, right = dense(band), rhs.copy()
    assert eliminate(band, rhs, NO_SIDE, 0, rows) == -1
    last = np.array([[band[rows - 3 + i, DIAGONAL + j - i] for j in range(3)] for i in range(3)])
    rhs[-3:] = np.linalg.solve(last, rhs[-3:])
    back_substitute(band, rhs, 0, rows)
    condition = np.linalg.cond(matrix)
    assert (
        np.abs(rhs - np.linalg.solve(matrix, right)).max() < 1e-14 * condition * np.abs(rhs).max()
    )


def test_a_row_of_zeros_is_found() -> None:
    band = np.zeros((12, WIDTH))
    band[:, DIAGONAL] = 1.0
    band[4, DIAGONAL] = 0.0
    assert eliminate(band, np.ones(12), NO_SIDE, 0, 12) == 4
