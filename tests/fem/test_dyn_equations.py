"""The equations of motion: tangents against differences, forces against formulas written anew."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.fem import mesh_line
from catopt.fem.banded import back_substitute_blocks, eliminate_blocks
from catopt.fem.dynamic_model import Fluid, LineProperties, lay_out_moving
from catopt.fem.morison import MorisonSection
from catopt.fem.moving import Blend, Equations, Moving
from catopt.fem.newmark import LineDamping, Scheme, assemble_moving, rayleigh_factors
from catopt.fem.run_settings import StepControls
from catopt.fem.seabed import Seabed
from catopt.fem.simulation import Simulation
from catopt.model import Line, Segment
from tests.fem.strings import plain_simulation, run

BARS = 6
SECTION = MorisonSection(0.3, 1.4, 0.5, 1.1, 0.3, oblique=(0.2, 0.4))
DAMPING = LineDamping(internal=2e4, mass_factor=0.3, stiffness_factor=0.04)


def _shaken(seed: int, friction: float = 0.4, slope: float = 0.0) -> Simulation:
    """Line in disorder: taut and slack bars, nodes in and on the bed, stuck and slipping."""
    rng = np.random.default_rng(seed)
    line = Line([Segment(60.0, 500.0, EA=1e6, mass=120.0)])
    lines = lay_out_moving(
        [mesh_line(line, BARS)],
        LineProperties(
            [SECTION], DAMPING, Fluid(1025.0, 9.81), Seabed(2e4, 3e3, friction, 1e4, slope=slope)
        ),
    )
    x = np.column_stack([np.linspace(0.0, 62.0, BARS + 1), np.zeros(BARS + 1), np.zeros(BARS + 1)])
    x[:, 2] = [0.0, -0.03, -0.05, -0.01, 4.0, 9.0, 14.0]
    x += 0.005 * rng.standard_normal(x.shape)
    along, above = x[:, 0].copy(), x[:, 2].copy()
    cos, sin = math.cos(slope), math.sin(slope)
    x[:, 0], x[:, 2] = cos * along - sin * above, sin * along + cos * above
    simulation = Simulation(lines, x)
    at = simulation.state
    at.v[:] = 0.2 * rng.standard_normal(x.shape)
    at.a[:] = rng.standard_normal(x.shape)
    at.foot[:] = np.column_stack([along, x[:, 1]]) + 0.01 * rng.standard_normal((BARS + 1, 2))
    room = simulation._room
    room.water.velocity[:] = rng.standard_normal(x.shape)
    room.water.acceleration[:] = rng.standard_normal(x.shape)
    return simulation


def _left_over(
    simulation: Simulation, now: Moving, before: Moving, blend: Blend, to: Equations
) -> np.ndarray:
    room = simulation._room
    assemble_moving(simulation.lines, simulation.body, now, before, blend, room)
    return to.rest.copy()


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("scheme", [Scheme(), Scheme.generalised_alpha(0.6)])
@pytest.mark.parametrize("slope", [0.0, 0.3])
def test_tangent_is_the_derivative(seed: int, scheme: Scheme, slope: float) -> None:
    """Each block is the central difference of the balance, velocities and accelerations following.

    With generalised-alpha the direction of the added mass is one within the step; its derivative
    is taken as at the step's end, which leaves out a turn of the bar within the step.
    """
    simulation = _shaken(seed, slope=slope)
    h = 0.05
    by_v, by_a = scheme.gamma / (scheme.beta * h), 1.0 / (scheme.beta * h * h)
    late = 1.0 - scheme.alpha_f
    blend = Blend(scheme.alpha_f, scheme.alpha_m, late, late * by_v, (1 - scheme.alpha_m) * by_a)
    now, to = simulation.state, simulation.equations
    before = Moving(*(array.copy() for array in now))
    _left_over(simulation, before, before, Blend(0, 0, 1, 0, 0), to)
    _left_over(simulation, now, before, blend, to)
    blocks = [each.copy() for each in (to.lower, to.diagonal, to.upper)]
    size = 1e-7
    for n in range(1, BARS):
        for i in range(3):
            sides = []
            for sign in (1.0, -1.0):
                moved = Moving(*(array.copy() for array in now))
                moved.x[n, i] += sign * size
                moved.v[n, i] += sign * size * by_v
                moved.a[n, i] += sign * size * by_a
                sides.append(_left_over(simulation, moved, before, blend, to))
            derivative = -(sides[0] - sides[1]) / (2.0 * size)
            for block, at in zip(blocks, (n + 1, n, n - 1), strict=True):
                if 0 < at < BARS:
                    # Differences: rounding of 1e5 N over 1e-7 m, and curvature of |r| r.
                    scale = np.abs(blocks[1][at]).max()
                    assert derivative[at] == pytest.approx(block[at, :, i], abs=2e-5 * scale)


def test_drag_and_inertia_by_the_formula() -> None:
    """Morison's sum over a bar in uniform flow, against the formula in vectors."""
    rng = np.random.default_rng(5)
    for _ in range(5):
        direction = rng.standard_normal(3)
        direction /= np.linalg.norm(direction)
        line = Line([Segment(10.0, 500.0, EA=1e9, mass=120.0)])
        fluid = Fluid(1000.0, 9.81)
        lines = lay_out_moving(
            [mesh_line(line, 1)], LineProperties([SECTION], fluid=fluid, seabed=None)
        )
        x = np.array([[0.0, 0.0, 50.0], [0.0, 0.0, 50.0] + 10.0 * direction])
        simulation = Simulation(lines, x)
        u, v, du, dv = rng.standard_normal((4, 3))
        at, water = simulation.state, simulation._room.water
        at.v[:], at.a[:], water.velocity[:], water.acceleration[:] = v, dv, u, du
        _left_over(simulation, at, at, Blend(0, 0, 1, 0, 0), simulation.equations)
        t = direction
        r = u - v
        r_t, r_n = (r @ t) * t, r - (r @ t) * t
        displaced = 120.0 - 500.0 / 9.81
        D, rho = SECTION.diameter, fluid.density
        # S4 [2.32], g between the line and the relative velocity.
        cos = float(r @ t) / float(np.linalg.norm(r))
        sin = math.sqrt(1.0 - cos * cos)
        (m, n), C_n = SECTION.oblique, SECTION.drag_normal
        oblique = 0.5 * rho * D * C_n * (m + n * sin) * cos * float(r @ r) * t
        drag = oblique + (
            0.5
            * rho
            * D
            * (
                SECTION.drag_normal * np.linalg.norm(r_n) * r_n
                + SECTION.drag_tangential * np.linalg.norm(r_t) * r_t
            )
        )
        b = du - dv
        b_t, b_n = (b @ t) * t, b - (b @ t) * t
        push = displaced * (
            du + SECTION.added_mass_normal * b_n + SECTION.added_mass_tangential * b_t
        )
        expected = 10.0 * (drag + push - 120.0 * dv - [0.0, 0.0, 500.0])
        total = simulation.equations.rest.sum(axis=0)
        # Double precision of sums of 1e4 N.
        assert total == pytest.approx(expected, abs=1e-8)


@pytest.mark.slow
def test_tangential_coefficient_goes_with_the_diameter() -> None:
    """A bar drawn along itself: 0.5 rho D C_t u^2 L, D and not pi D."""
    line = Line([Segment(10.0, 0.0, EA=1e9, mass=1.0)])
    section = MorisonSection(0.2, 1.0, 0.3)
    of = LineProperties([section], LineDamping(), Fluid(1000.0, 9.81), None, "lumped")
    lines = lay_out_moving([mesh_line(line, 2)], of)
    x = np.array([[0.0, 0.0, 9.0], [5.0, 0.0, 9.0], [10.0, 0.0, 9.0]])
    simulation = Simulation(lines, x)
    simulation.state.v[:, 0] = -2.0
    simulation.assemble(Blend(0, 0, 1, 0, 0))
    drag = simulation.state.force[:, 0].sum()
    assert drag == pytest.approx(0.5 * 1000.0 * 0.2 * 0.3 * 4.0 * 10.0, rel=1e-12)


def test_line_carried_by_the_water_feels_no_drag() -> None:
    """What moves as the water does: weight alone is left, and it sums up."""
    simulation = _shaken(0)
    at, water = simulation.state, simulation._room.water
    at.v[:] = water.velocity[:] = [0.7, -0.3, 0.2]
    at.x[:, 2] += 30.0
    at.a[:] = water.acceleration[:] = 0.0
    at.foot[:] = np.nan
    calm = simulation.lines._replace(mass_factor=0.0)
    simulation.lines = calm
    _left_over(simulation, at, at, Blend(0, 0, 1, 0, 0), simulation.equations)
    total = at.force.sum(axis=0)
    assert total == pytest.approx([0.0, 0.0, -60.0 * 500.0], abs=1e-8)


def test_arrow_solver_against_a_full_matrix() -> None:
    """Blocks of a line, eliminated up to its last node, as numpy solves the whole."""
    rng = np.random.default_rng(3)
    n = 7
    blocks = rng.standard_normal((3, n, 3, 3))
    blocks[1] += 8.0 * np.eye(3)
    rest = rng.standard_normal((n, 3))
    full = np.zeros((3 * n, 3 * n))
    for i in range(n):
        for block, j in zip(blocks, (i - 1, i, i + 1), strict=True):
            if 0 <= j < n:
                full[3 * i : 3 * i + 3, 3 * j : 3 * j + 3] = block[i]
    expected = np.linalg.solve(full, rest.ravel()).reshape(n, 3)
    to = Equations(blocks[1].copy(), blocks[0].copy(), blocks[2].copy(), rest.copy(), rest.copy())
    assert eliminate_blocks(to, 0, n - 1)
    to.rest[-1] = np.linalg.solve(to.diagonal[-1], to.rest[-1])
    back_substitute_blocks(to, 0, n - 1)
    # Well-conditioned: double precision.
    assert to.rest == pytest.approx(expected, abs=1e-12)


def test_internal_damping_and_rayleigh_of_a_bar() -> None:
    """Force c times the rate of strain, plus beta of both parts of the bar's stiffness."""
    EA, beta, c = 1e6, 0.05, 300.0
    simulation = plain_simulation(
        ((0.0, 0.0, 50.0), (10.1, 0.0, 50.0)), 10.0, 1, EA=EA,
        damping=LineDamping(internal=c, stiffness_factor=beta),
    )  # fmt: skip
    simulation.state.v[1] = [0.2, 0.3, 0.0]
    simulation.assemble(Blend(0, 0, 1, 0, 0))
    T = EA * 0.1 / 10.0
    expected = [T + (c + beta * EA) * 0.2 / 10.0, beta * T / 10.1 * 0.3, 0.0]
    assert simulation.state.force[0] == pytest.approx(expected, rel=1e-12)


def test_slack_bar_pushes_nothing() -> None:
    """Shorter than its length, or closing faster than it is stretched: no force."""
    damping = LineDamping(internal=1e5)
    for end, speed in ((9.9, 0.0), (10.0001, -1.0)):
        simulation = plain_simulation(
            ((0.0, 0.0, 50.0), (end, 0.0, 50.0)), 10.0, 1, EA=1e6, damping=damping
        )
        simulation.state.v[1, 0] = speed
        simulation.assemble(Blend(0, 0, 1, 0, 0))
        assert np.abs(simulation.state.force).max() == 0.0


def test_rayleigh_factors_give_their_ratios() -> None:
    """alpha/(2 w) + beta w/2 is the ratio asked for at both frequencies, S4 [3.17]."""
    alpha, beta = rayleigh_factors(0.7, 1.9, 0.05)
    assert alpha == pytest.approx(2 * 0.05 * 0.7 * 1.9 / 2.6)
    assert beta == pytest.approx(2 * 0.05 / 2.6)
    alpha, beta = rayleigh_factors(0.7, 1.9, 0.05, 0.08)
    ratios = [alpha / (2 * w) + beta * w / 2 for w in (0.7, 1.9)]
    assert ratios == pytest.approx([0.05, 0.08])


@pytest.mark.parametrize("radius", [0.0, 0.3, 0.5, 0.8, 1.0])
def test_spectral_radius_at_infinity(radius: float) -> None:
    """A step of h on a vibration of omega h = 1e4 leaves what was asked for (Chung, Hulbert)."""
    largest = _spectral_radius(Scheme.generalised_alpha(radius), 1e4)
    # A double (for 0: triple) eigenvalue: its error is the root of what 1/(omega h)^2 leaves.
    assert largest == pytest.approx(radius, abs=4e-3)


@pytest.mark.parametrize("omega_h", [0.1, 1.0, 10.0, 1e3])
def test_average_acceleration_neither_damps_nor_grows(omega_h: float) -> None:
    """Spectral radius 1 at every step; less with a larger delta of S4's, here 0.7."""
    assert _spectral_radius(Scheme.average_acceleration(), omega_h) == pytest.approx(1.0, abs=1e-6)
    assert _spectral_radius(Scheme(beta=0.36, gamma=0.7), omega_h) < 1.0


def _spectral_radius(scheme: Scheme, omega_h: float) -> float:
    """Of one step from each of x, h v and h^2 a of a body on a spring that pushes and pulls."""
    length, EA = 1.0, 1.0
    h = omega_h * math.sqrt(0.5 / EA)
    columns = []
    for i in range(3):
        simulation = plain_simulation(
            ((0.0, 0.0, 5.0), (length, 0.0, 5.0)), length, 1, EA=EA, pushes=True,
            mass_matrix="lumped",
        )  # fmt: skip
        free = np.array([1.0, 0.0, 0.0])
        simulation.body = simulation.body._replace(free=free)
        simulation.lines = simulation.lines._replace(force_scale=1.0)
        size, at = 1e-3, simulation.state
        at.x[1, 0] += size * (i == 0)
        at.v[1, 0] = size / h * (i == 1)
        simulation.assemble(Blend(0, 0, 1, 0, 0))
        at.a[1, 0] = size / h**2 * (i == 2)
        run(simulation, 1, 1, h, scheme=scheme, controls=StepControls(tolerance=1e-13))
        columns.append([at.x[1, 0] - length, h * at.v[1, 0], h * h * at.a[1, 0]])
    amplification = np.array(columns).T / 1e-3
    return float(np.abs(np.linalg.eigvals(amplification)).max())
