"""Truss and closed form over many lines: they share no code but the line they are given."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import catopt
from catopt.catenary.solution import Solution
from catopt.fem import LineMesh, TrussSolution, mesh_line, solve_line
from tests.fem.lines import Moored, moored_line

AGREEMENT = 1e-6
"""Of the tension: what is asked of the truss after refinement or Richardson's extrapolation."""

SEEDS = range(120)


def both(seed: int) -> tuple[Moored, Solution, dict[str, Any]]:
    """Draw a line; its closed form under a force; that force or (even seeds) the span it gives."""
    moored = moored_line(seed)
    closed = catopt.solve(moored.line, horizontal_force=moored.horizontal_force, **moored.setting)
    load = {"horizontal_force": moored.horizontal_force} if seed % 2 else {"span": closed.span}
    return moored, closed, load


def difference(truss: TrussSolution, closed: Solution) -> np.ndarray:
    """Fairlead tension, its angle, anchor tension and span or force, over tension and length."""
    tension = closed.fairlead.tension
    return np.array(
        [
            truss.fairlead.tension / tension - 1.0,
            truss.fairlead.angle - closed.fairlead.angle,
            (truss.anchor.tension - closed.anchor.tension) / tension,
            (truss.span - closed.span) / closed.line.length,
            (truss.horizontal_force - closed.horizontal_force) / tension,
        ]
    )


def solved(moored: Moored, mesh: LineMesh, load: dict[str, Any]) -> TrussSolution:
    return solve_line(moored.line, mesh=mesh, **load, **moored.setting)


@pytest.mark.parametrize(
    "seed", [*SEEDS[:40], *(pytest.param(seed, marks=pytest.mark.slow) for seed in SEEDS[40:])]
)
def test_error_falls_with_the_square_of_the_bar_length(seed: int) -> None:
    """Every line: hanging, on the bed, rough, with clump weights, slack and taut.

    Order 2 of the fairlead's tension from the two finer of three meshes, and these two put
    together (Richardson) to 1e-6 of the tension, or of the length for the span.
    """
    moored, closed, load = both(seed)
    mesh = mesh_line(moored.line, 250)
    found = []
    for _ in range(3):
        truss = solved(moored, mesh, load)
        found.append(difference(truss, closed))
        mesh = mesh.refined()
    errors = np.array(found)
    order = np.log2(abs(errors[1, 0] / errors[2, 0]))
    assert order == pytest.approx(2.0, abs=0.1)
    assert np.abs((4.0 * errors[2] - errors[1]) / 3.0).max() < AGREEMENT
    assert abs(truss.grounded_length - closed.grounded_length) < 1e-4 * moored.line.length
    assert truss.penetration < 1e-9 * moored.line.length
    assert truss.residual < 1e-10


def test_the_lines_are_of_every_kind() -> None:
    regimes = [both(seed)[1].regime for seed in SEEDS]
    lines = [moored_line(seed) for seed in SEEDS]
    assert regimes.count("grounded") >= 40
    assert regimes.count("suspended") >= 40
    assert {"grounded-between", "below-anchor"} <= set(regimes)
    assert sum(len(each.line.point_loads) > 0 for each in lines) >= 60
    assert sum(each.setting["seabed_friction"] > 0.0 for each in lines) >= 40
    assert sum(math.isinf(each.line.segments[0].EA) for each in lines) >= 30
    assert {len(each.line.segments) for each in lines} == {1, 2, 3}


@pytest.mark.parametrize("seed", SEEDS[:40])
def test_segments_and_clump_weights_agree(seed: int) -> None:
    """Largest tension of each segment, and where each clump weight is; one mesh of 500 bars.

    Second order: 500**-2 is 4e-6, and a factor of ten for what lies on the bed.
    """
    moored, closed, load = both(seed)
    truss = solved(moored, mesh_line(moored.line, 500), load)
    tension = closed.fairlead.tension
    for found, wanted in zip(truss.segment_max_tension(), closed.segments, strict=True):
        assert found == pytest.approx(wanted.max_tension, abs=4e-5 * tension)
    reactions = truss.point_load_reaction()
    for number, wanted_load in enumerate(closed.point_loads):
        x, _, z = truss.nodes[truss.mesh.load_node[number]]
        assert [x, z] == pytest.approx(
            [wanted_load.x, wanted_load.z], abs=4e-5 * closed.line.length
        )
        most = 4e-5 * tension + truss.mesh.length.max() * 3000.0
        assert reactions[number] == pytest.approx(wanted_load.seabed_reaction, abs=most)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(120, 600))
def test_error_falls_so_over_many_more_lines(seed: int) -> None:
    test_error_falls_with_the_square_of_the_bar_length(seed)
