"""Weight above the water, and a current's drag."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.fem import Current, DragSection, Water, mesh_line, solve_line
from catopt.model import Line, Segment

G = 9.80665
CHAIN = Line([Segment(100.0, 1000.0, EA=1e8, mass=120.0)])


def test_a_line_above_the_water_weighs_what_it_weighs_in_air() -> None:
    """With the surface at the bed, the whole line has its mass times g: as if it were given so."""
    dry = solve_line(CHAIN, height=60.0, span=70.0, elements=40, water=Water(surface=0.0))
    heavy = Line([Segment(100.0, 120.0 * G, EA=1e8)])
    assert dry.tension == pytest.approx(
        solve_line(heavy, height=60.0, span=70.0, elements=40).tension, rel=1e-9
    )
    high = solve_line(CHAIN, height=60.0, span=70.0, elements=40, water=Water(surface=60.0))
    wet = solve_line(CHAIN, height=60.0, span=70.0, elements=40)
    assert high.tension == pytest.approx(wet.tension, rel=1e-9)


def test_a_line_through_the_surface_weighs_between() -> None:
    """Sum of vertical forces: the part above in air, below in water, cut at the surface."""
    surface = 45.0
    mesh = mesh_line(CHAIN, 50)
    part = solve_line(CHAIN, height=60.0, span=70.0, mesh=mesh, water=Water(surface=surface))
    low, high = part.nodes[:-1, 2], part.nodes[1:, 2]
    dry = np.clip((high - surface) / np.maximum(high - low, 1e-9), 0.0, 1.0)
    weight = float((mesh.length * (1000.0 + (120.0 * G - 1000.0) * dry)).sum())
    assert np.count_nonzero((dry > 0.0) & (dry < 1.0)) == 1
    carried = part.fairlead.vertical_force - part.anchor.vertical_force + part.bed_reaction.sum()
    assert carried == pytest.approx(weight, rel=1e-9)


def test_drag_across_a_level_string_in_a_uniform_current() -> None:
    """Weightless taut string across the flow: a parabola of q = 0.5 rho D C u^2 per length.

    Sag f = q L S/(8 T), drag being per unstretched length; the direction
    changes by 4 f/S, whose square is what the parabola neglects.
    """
    line = Line([Segment(100.0, 0.0, EA=1e7)])
    section = DragSection(diameter=0.1, normal=1.2)
    current = Current(lambda x: np.tile([0.0, 1.5, 0.0], (len(x), 1)), [section])
    solution = solve_line(line, height=30.0, anchor_height=30.0, span=100.5, elements=64,
                          water=Water(current=current))  # fmt: skip
    q = 0.5 * 1025.0 * 0.1 * 1.2 * 1.5**2
    sag = q * 100.0 * 100.5 / (8.0 * solution.horizontal_force)
    slope = 4.0 * sag / 100.5
    assert solution.nodes[32, 1] == pytest.approx(sag, rel=slope**2 + 1e-3)
    assert slope < 0.11
    assert np.abs(solution.nodes[:, 2] - 30.0).max() < 1e-9


def test_drag_along_a_string() -> None:
    """Flow along a weightless string: tension grows by 0.5 rho D C u^2 per length."""
    line = Line([Segment(100.0, 0.0, EA=1e7)])
    current = Current(
        lambda x: np.tile([2.0, 0.0, 0.0], (len(x), 1)), [DragSection(0.1, 1.2, tangential=0.05)]
    )
    solution = solve_line(line, height=30.0, anchor_height=30.0, span=101.0, elements=20,
                          water=Water(current=current))  # fmt: skip
    q = 0.5 * 1025.0 * 0.1 * 0.05 * 2.0**2
    # Load per unstretched length.
    assert -np.diff(solution.tension) == pytest.approx(np.full(19, 5.0 * q), rel=1e-6)


def test_a_current_profile_is_asked_where_the_bars_are() -> None:
    """Only the upper half of the water flows: all drag acts on bars above mid-depth."""
    seen = []

    def velocity(x: np.ndarray) -> np.ndarray:
        seen.append(x.copy())
        return np.where(x[:, 2:] > 30.0, [[0.0, 1.0, 0.0]], 0.0)

    water = Water(current=Current(velocity, [DragSection(0.2, 1.4)]))
    solution = solve_line(CHAIN, height=60.0, span=70.0, elements=40, water=water)
    middles = 0.5 * (solution.nodes[1:] + solution.nodes[:-1])
    assert seen[-1] == pytest.approx(middles, abs=1e-6)
    assert solution.nodes[20, 1] > 0.1
    assert solution.residual < 1e-10


def test_what_is_missing_is_named() -> None:
    line = Line([Segment(100.0, 1000.0)])
    with pytest.raises(InputError, match=r"segments\[0\]\.mass"):
        solve_line(line, height=60.0, span=70.0, water=Water(surface=30.0))
    current = Current(lambda x: np.zeros_like(x), [])
    with pytest.raises(InputError, match=r"current\.sections"):
        solve_line(line, height=60.0, span=70.0, water=Water(current=current))
    with pytest.raises(InputError, match="diameter"):
        DragSection(diameter=math.nan, normal=1.0)
