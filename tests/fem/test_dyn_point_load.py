"""Point loads in motion: drag, added mass, and the lift that a buoy loses out of the water.

Against the closed form, and against ordinary differential equations of one body written here.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from catopt.constants import STANDARD_GRAVITY as G
from catopt.errors import InputError
from catopt.fem import (
    Fluid,
    LineProperties,
    Scheme,
    line_frequencies,
    mesh_line,
)
from catopt.fem.dynamic_model import lay_out_moving
from catopt.fem.moving import Blend
from catopt.fem.simulation import Simulation
from catopt.model import Line, PointLoad, Segment
from catopt.waves import Sea, TableCurrent, jonswap, random_waves
from tests.fem.strings import run

RHO = 1025.0
DEPTH = 40.0
BARE = LineProperties(fluid=Fluid(RHO, G), seabed=None, mass_matrix="lumped")
THREAD = Segment(100.0, 1e-3, EA=1e4, mass=2e-3)


def on_thread(load: PointLoad, at: tuple[float, float, float], sea: Sea | None) -> Simulation:
    """Hang a body in the middle of two slack bars that weigh nothing and reach it nowhere."""
    line = Line([THREAD, THREAD], [load])
    lines = lay_out_moving([mesh_line(line, [1, 1])], BARE)
    simulation = Simulation(lines, np.array([[0.0, 0.0, 30.0], at, [2.0, 0.0, 30.0]]), sea=sea)
    simulation.start()
    return simulation


def body(weight: float, mass: float, **water: float) -> PointLoad:
    return PointLoad(100.0, weight, mass, **water)  # type: ignore[arg-type]


def test_a_sinking_body_comes_to_its_terminal_velocity() -> None:
    """W = rho Cd A v^2/2; on the way v tanh(t/tau) with tau = v (m + added)/W."""
    weight, mass, area, cd, ca = 5e3, 1500.0, 2.0, 0.8, 0.6
    load = body(weight, mass, drag_area=area, drag_coefficient=cd, added_mass_coefficient=ca)
    simulation = on_thread(load, (1.0, 0.0, 30.0), None)
    record = run(simulation, 600, 1, 0.02, nodes=[1])
    final = math.sqrt(2.0 * weight / (RHO * cd * area))
    tau = final * (mass + ca * (mass - weight / G)) / weight
    sunk = 30.0 - record.nodes[:, 0, 2]
    expected = final * tau * np.log(np.cosh(record.time / tau))
    # Second order in steps of tau/60.
    assert sunk[1:] == pytest.approx(expected[1:], rel=2e-3, abs=1e-4)
    assert simulation.state.v[1, 2] == pytest.approx(-final, rel=1e-3)


def test_added_mass_lengthens_the_natural_period() -> None:
    """A neutral body amid a taut string: omega^2 = (4 T/L)/(m (1 + Ca)), the string's mass nil."""
    mass, ca, length, tension = 2000.0, 0.7, 60.0, 5e4
    string = Segment(length / 2.0, 1e-4, EA=1e8, mass=1e-3)
    found = []
    for factor in (0.0, ca):
        load = PointLoad(length / 2.0, 0.0, mass, added_mass_coefficient=factor)
        stretched = length * (1.0 + tension / 1e8)
        found.append(
            line_frequencies(
                mesh_line(Line([string, string], [load]), [1, 1]), 2, height=20.0,
                span=stretched, anchor_height=20.0,
                properties=LineProperties(seabed=None, fluid=Fluid(RHO, G)),
            )
        )  # fmt: skip
    for factor, omega in zip((0.0, ca), found, strict=True):
        expected = math.sqrt(4.0 * tension / length / (mass * (1.0 + factor)))
        # Twice, up and across; the length under tension is 5e-4 greater.
        assert omega == pytest.approx(expected, rel=1e-3)


def test_a_swaying_buoy_on_a_taut_line_is_the_equation_of_one_body() -> None:
    """(m + Ca rho V) x'' = -T x/l - T x/r - rho Cd A |x'| x'/2, let go 1 m aside."""
    mass, volume, area, cd, ca, half, EA = 800.0, 2.0, 1.5, 1.1, 0.5, 20.0, 1e6
    lift = (RHO * volume - mass) * G
    string = Segment(half, 1e-4, EA=EA, mass=1e-3)
    load = PointLoad(half, -lift, mass, drag_area=area, drag_coefficient=cd,
                     added_mass_coefficient=ca)  # fmt: skip
    line = Line([string, string], [load])
    lines = lay_out_moving([mesh_line(line, [1, 1])], BARE)
    top = 2.0 * half * 1.05
    start = np.array([1.0, half * 1.05])
    x = np.array([[0.0, 0.0, 0.0], [start[0], 0.0, start[1]], [0.0, 0.0, top]])
    simulation = Simulation(lines, x)
    simulation.start()
    record = run(simulation, 400, 1, 0.01, nodes=[1], scheme=Scheme.average_acceleration())

    def rate(_: float, y: np.ndarray) -> list[float]:
        force = np.array([0.0, lift])
        for end in (0.0, top):
            d = np.array([-y[0], end - y[1]])
            size = float(np.hypot(*d))
            force += max(EA * (size - half) / half, 0.0) * d / size
        force -= 0.5 * RHO * cd * area * math.hypot(y[2], y[3]) * y[2:]
        return [y[2], y[3], *(force / (mass + ca * RHO * volume))]

    exact = solve_ivp(
        rate, (0.0, 4.0), [*start, 0.0, 0.0], t_eval=record.time, rtol=1e-9, atol=1e-9
    ).y
    # Steps of a fortieth of the faster period along the line: (omega h)^2/12 of phase.
    assert record.nodes[:, 0, 0] == pytest.approx(exact[0], abs=2e-3)
    assert record.nodes[:, 0, 2] == pytest.approx(exact[1], abs=2e-3)


@pytest.mark.parametrize("scheme", [Scheme.average_acceleration(), Scheme()])
def test_a_buoy_that_falls_into_the_water_is_a_sphere(scheme: Scheme) -> None:
    """Lift, drag and added mass by the part of a sphere that is under water: s^2 (3 - 2 s)."""
    mass, volume, area, cd, ca = 600.0, 1.5, 1.6, 0.9, 0.5
    radius = (3.0 * volume / (4.0 * math.pi)) ** (1.0 / 3.0)
    load = body((mass - RHO * volume) * G, mass, drag_area=area, drag_coefficient=cd,
                added_mass_coefficient=ca)  # fmt: skip
    simulation = on_thread(load, (1.0, 0.0, DEPTH + 1.5), Sea(DEPTH))
    record = run(simulation, 800, 1, 0.01, nodes=[1], scheme=scheme)

    def rate(_: float, y: np.ndarray) -> list[float]:
        s = min(max((DEPTH - y[0]) / (2.0 * radius) + 0.5, 0.0), 1.0)
        wet = s * s * (3.0 - 2.0 * s)
        force = -mass * G + RHO * G * volume * wet - 0.5 * RHO * cd * area * wet * abs(y[1]) * y[1]
        return [y[1], force / (mass + ca * RHO * volume * wet)]

    exact = solve_ivp(
        rate, (0.0, 8.0), [DEPTH + 1.5, 0.0], t_eval=record.time, rtol=1e-9, atol=1e-9,
        max_step=0.01,
    ).y  # fmt: skip
    assert np.ptp(exact[0]) > 1.5
    # Second order in steps of a 250th of the period; added mass that changes is frozen in a step.
    assert record.nodes[:, 0, 2] == pytest.approx(exact[0], abs=0.02)
    # It comes to float where the water carries it: a sphere under water by m/(rho V).
    s = np.roots([-2.0, 3.0, 0.0, -mass / (RHO * volume)])
    part = float(s[(s > 0.0) & (s < 1.0)][0])
    late = record.nodes[-160:, 0, 2].mean()
    assert late == pytest.approx(DEPTH - (part - 0.5) * 2.0 * radius, abs=0.05)


def test_a_deep_body_in_a_current_is_driven_at_its_speed() -> None:
    """Let go in a current it ends up going with it, and is not driven further."""
    load = body(0.0, 1000.0, drag_area=2.0, drag_coefficient=1.0)
    sea = Sea(DEPTH, None, [TableCurrent((0.0,), (1.2,), 0.0)])
    simulation = on_thread(load, (1.0, 0.0, 20.0), sea)
    run(simulation, 600, 1, 0.05)
    assert simulation.state.v[1, 0] == pytest.approx(1.2, rel=0.1)
    assert simulation.state.v[1, 0] < 1.2


@pytest.mark.parametrize("scheme", [Scheme.average_acceleration(), Scheme()])
def test_tangent_is_the_derivative(scheme: Scheme) -> None:
    """Of a body half out of the water, in waves: blocks against differences."""
    load = body(-3e3, 400.0, drag_area=1.2, drag_coefficient=1.0, added_mass_coefficient=0.5)
    waves = random_waves(jonswap(2.0, 6.0), 5, np.random.default_rng(2))
    sea = Sea(DEPTH, waves, [TableCurrent((0.0,), (0.8,), 0.0)])
    simulation = on_thread(load, (1.0, 0.0, DEPTH + 0.1), sea)
    lines, room, state = simulation.lines, simulation._room, simulation.state
    rng = np.random.default_rng(4)
    before = state._replace(**{name: getattr(state, name).copy() for name in state._fields})
    room.water.velocity[:] = rng.standard_normal((3, 3))
    room.water.acceleration[:] = rng.standard_normal((3, 3))
    room.water.surface[:] = DEPTH
    h, a_m, a_f = 0.1, float(scheme.alpha_m), float(scheme.alpha_f)
    by_v, by_a = float(scheme.gamma) / (float(scheme.beta) * h), 1.0 / (float(scheme.beta) * h**2)
    blend = Blend(a_f, a_m, 1.0 - a_f, (1.0 - a_f) * by_v, (1.0 - a_m) * by_a, h)
    state.v[1], state.a[1] = rng.standard_normal(3), rng.standard_normal(3)
    x, v, a = state.x[1].copy(), state.v[1].copy(), state.a[1].copy()

    def left(by: np.ndarray) -> np.ndarray:
        from catopt.fem.newmark import assemble_moving

        state.x[1], state.v[1], state.a[1] = x + by, v + by_v * by, a + by_a * by
        assemble_moving(lines, simulation.body, state, before, blend, room)
        return np.array(room.equations.rest[1])

    left(np.zeros(3))
    block = room.equations.diagonal[1].copy()
    d = 1e-6
    for j in range(3):
        by = np.zeros(3)
        by[j] = d
        slope = (left(-by) - left(by)) / (2.0 * d)
        assert slope == pytest.approx(block[:, j], rel=1e-5, abs=1e-5 * float(np.abs(block).max()))


def test_energy_of_a_floating_buoy_is_accounted_for() -> None:
    """What falls into the water and comes to rest gives its energy to drag."""
    mass, volume = 600.0, 1.5
    load = body((mass - RHO * volume) * G, mass, drag_area=1.6, drag_coefficient=0.9,
                added_mass_coefficient=0.5)  # fmt: skip
    simulation = on_thread(load, (1.0, 0.0, DEPTH + 1.5), Sea(DEPTH))
    record = run(simulation, 1000, 1, 0.01, scheme=Scheme.average_acceleration())
    balance = simulation.balance(record)
    assert balance.drag > 0.5 * mass * G  # of about 1.5 m of fall
    assert abs(balance.numerical) < 0.01 * balance.drag


def test_what_does_not_go_together_is_refused() -> None:
    with pytest.raises(InputError, match="drag_coefficient: missing; needed with drag_area"):
        PointLoad(10.0, 100.0, 50.0, drag_area=1.0)
    with pytest.raises(InputError, match="drag_area: missing; needed with drag_coefficient"):
        PointLoad(10.0, 100.0, 50.0, drag_coefficient=1.0)
    heavy = Line([THREAD, THREAD], [PointLoad(100.0, 1e4, 500.0, accept=["weight_in_water"])])
    with pytest.raises(InputError, match="must weigh more in air than in water"):
        lay_out_moving([mesh_line(heavy, [1, 1])], BARE)
