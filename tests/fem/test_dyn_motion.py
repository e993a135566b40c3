"""Motion against solutions known otherwise: order in the step and in the mesh, energy, slack."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from catopt.fem import mesh_line
from catopt.fem.dynamic_model import Fluid, LineProperties, lay_out_moving
from catopt.fem.linear_model import natural_frequencies
from catopt.fem.morison import MorisonSection
from catopt.fem.moving import Blend
from catopt.fem.newmark import LineDamping, Scheme
from catopt.fem.run_settings import StepControls
from catopt.fem.seabed import Seabed
from catopt.fem.series import Harmonic, series_rows
from catopt.fem.simulation import Simulation
from catopt.model import Line, Segment
from tests.fem.strings import G, free_body, orders, plain_simulation, run

TIGHT = StepControls(tolerance=1e-12)
SCHEMES = [Scheme.average_acceleration(), Scheme.generalised_alpha(0.5)]


@pytest.mark.parametrize("scheme", SCHEMES)
def test_elastic_pendulum(scheme: Scheme) -> None:
    """A body on a springy string, released at 60 degrees: second order in the step.

    Reference: the two equations of the body integrated to 1e-12 by DOP853.
    """
    L, EA, M = 2.0, 4e3, 10.0

    def fall(_: float, y: np.ndarray) -> list[float]:
        size = math.hypot(y[0], y[1])
        pull = -EA * (size - L) / L / size / M
        return [y[2], y[3], pull * y[0], pull * y[1] - G]

    start = L * 1.01 * np.array([math.sin(math.pi / 3), -math.cos(math.pi / 3)])
    end = 3.0
    exact = solve_ivp(fall, (0.0, end), [*start, 0.0, 0.0], "DOP853", rtol=1e-12, atol=1e-12)
    errors = []
    for steps in (300, 600, 1200):
        simulation = plain_simulation(
            ((0.0, 0.0, 0.0), (start[0], 0.0, start[1])), L, 1, EA=EA, mass=1e-9,
            body=free_body(M),
        )  # fmt: skip
        simulation.load.base[0, 2] = -M * G
        simulation.start()
        run(simulation, 1, steps, end / steps, scheme=scheme, controls=TIGHT)
        at = simulation.state.x[1, [0, 2]]
        errors.append(float(np.linalg.norm(at - exact.y[:2, -1])))
    # Spring and swing are resolved with 9 steps in the spring's period at the coarsest.
    assert orders(errors) == pytest.approx(2.0, abs=0.1)
    assert errors[-1] < 2e-3 * L


def test_pendulum_period() -> None:
    """Large swing on a stiff string: 4 sqrt(L/g) K(sin(a/2)), by the arithmetic-geometric mean."""
    L, angle = 2.0, math.pi / 3
    a, b = 1.0, math.cos(0.5 * angle)
    for _ in range(8):
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    period = 2.0 * math.pi * math.sqrt(L / G) / a
    start = (L * math.sin(angle), 0.0, -L * math.cos(angle))
    simulation = plain_simulation(
        ((0.0, 0.0, 0.0), start), L, 1, EA=1e7, mass=1e-9, body=free_body(10.0)
    )
    simulation.load.base[0, 2] = -10.0 * G
    simulation.start()
    record = run(simulation, 2000, 1, 3.0 * period / 2000)
    x = record.fairlead[:, 0, 0]
    down = np.flatnonzero((x[:-1] > 0.0) & (x[1:] <= 0.0))
    crossing = record.time[down] + x[down] / (x[down] - x[down + 1]) * record.time[1]
    # 667 steps a period: (omega h)^2/12 = 7e-6, more where the swing is fastest.
    assert np.diff(crossing) == pytest.approx(period, rel=5e-5)


def _smooth_line(elements: int, motion: Harmonic) -> Simulation:
    """Line in water, hanging free of any bed, whose end is led, its axial waves damped."""
    line = Line([Segment(100.0, 100.0, EA=1e6, mass=20.0)])
    section, damping = MorisonSection(0.1, 1.2, 0.3), LineDamping(stiffness_time=0.1)
    of = LineProperties([section], damping, Fluid(1025.0, G), None)
    lines = lay_out_moving([mesh_line(line, elements)], of)
    x = np.linspace([0.0, 0.0, 80.0], [80.0, 0.0, 100.0], elements + 1)
    x[:, 2] -= 25.0 * np.sin(np.linspace(0.0, math.pi, elements + 1))
    simulation = Simulation(lines, x, prescribed_motion=series_rows(x[-1:], [motion], 4.0))
    simulation.settle()
    simulation.start()
    return simulation


MOTION = Harmonic(4.0, (1.0, 0.5, 0.5), (-math.pi / 2, 0.3, 0.0))


@pytest.mark.parametrize("scheme", SCHEMES)
def test_second_order_in_the_step(scheme: Scheme) -> None:
    """End force and shape of a line with drag, added mass and damping: a quarter by half a step."""
    forces, shapes = [], []
    for steps in (256, 512, 1024, 2048):
        simulation = _smooth_line(10, MOTION)
        record = run(simulation, 1, steps, 10.0 / steps, scheme=scheme, controls=TIGHT)
        forces.append(record.end_force[-1, 0, 1])
        shapes.append(simulation.state.x.copy())
    for series in (forces, shapes):
        steps_apart = [np.linalg.norm(b - a) for a, b in pairwise(series)]
        # |r| r of the drag is not smooth where the flow turns: the order wanders by a tenth.
        assert orders(steps_apart) == pytest.approx(2.0, abs=0.15)


def test_second_order_in_the_mesh() -> None:
    """End force and middle of the same line over the whole run, bars halved."""
    forces, middles = [], []
    for elements in (20, 40, 80, 160):
        simulation = _smooth_line(elements, MOTION)
        record = run(simulation, 500, 1, 0.02, controls=TIGHT, nodes=[elements // 2])
        forces.append(record.end_force[:, 0, 1])
        middles.append(record.nodes[:, 0])
    for series in (forces, middles):
        apart = [np.linalg.norm(b - a) for a, b in pairwise(series)]
        # |r| r of the drag is not smooth where the flow turns: the order wanders by a tenth.
        assert orders(apart) == pytest.approx(2.0, abs=0.15)


def test_axial_wave_in_a_bar() -> None:
    """One end led along a bar: force at the other, EA A w/c / sin(w L/c) in the steady state."""
    L, EA, mass, A = 100.0, 1e6, 1.0, 0.01
    omega = 0.4 * math.pi * math.sqrt(EA / mass) / L
    exact = EA * A * omega / math.sqrt(EA / mass) / math.sin(0.4 * math.pi)
    period = 2.0 * math.pi / omega
    errors = []
    for elements in (10, 20, 40):
        simulation = plain_simulation(
            ((0.0, 0.0, 0.0), (1.001 * L, 0.0, 0.0)), L, elements, EA=EA, mass=mass
        )
        # Grown so slowly that it brings no vibration of its own with it.
        prescribed_motion = series_rows(
            simulation.state.x[-1:], [Harmonic(period, (A, 0.0, 0.0))], 60 * period
        )
        simulation.prescribed_motion = prescribed_motion
        simulation.start()
        record = run(simulation, 7000, 1, period / 100, since=60 * period)
        late = record.time > 60 * period
        angle = omega * record.time[late]
        wave = np.column_stack([np.cos(angle), np.sin(angle)])
        parts = np.linalg.lstsq(wave, record.end_force[late, 0, 0, 0], rcond=None)[0]
        errors.append(float(np.hypot(*parts)) / exact - 1.0)
    # Bars and steps are refined together only in the bars: the step's part, (w h)^2/12 = 3e-4.
    assert orders(np.diff(errors))[0] == pytest.approx(2.0, abs=0.15)
    assert abs(errors[-1]) < 2e-3


def _plucked(amplitude: float, periods: float, steps: int) -> np.ndarray:
    """Energies of a taut string let go in its first mode."""
    EA, strain = 1e6, 1e-3
    simulation = plain_simulation(
        ((0.0, 0.0, 50.0), (100.0 * (1 + strain), 0.0, 50.0)), 100.0, 10, EA=EA,
    )  # fmt: skip
    simulation.assemble(Blend(0.0, 0.0, 1.0, 0.0, 0.0))
    period = 2.0 * math.pi / float(natural_frequencies(simulation, 1)[0])
    simulation.state.v[:, 1] = amplitude * np.sin(np.linspace(0.0, math.pi, 11))
    simulation.start()
    record = run(
        simulation,
        round(periods * steps / 10), 10, period / steps, scheme=Scheme.average_acceleration(),
        controls=TIGHT, energy=True,
    )  # fmt: skip
    energy: np.ndarray = record.energy.sum(axis=1)
    return energy


def test_small_vibration_keeps_its_energy() -> None:
    """Average acceleration, 1,000 periods of 30 steps: energy constant to 1e-6 of itself."""
    energy = _plucked(1e-3, 1000, 30)
    assert np.ptp(energy) / energy[0] < 1e-6


def test_large_vibration_drifts_little() -> None:
    """Where motion adds half to the string's tension energy is no longer kept exactly.

    Of second order in the step: 1.4e-3 at 60 steps a period, a quarter of it at 120.
    """
    drift = [np.ptp(energy) / energy[0] for energy in (_plucked(1.5, 100, n) for n in (60, 120))]
    assert drift[0] < 2e-3
    assert orders(drift)[0] == pytest.approx(2.0, abs=0.3)


def test_slack_flight_and_snap() -> None:
    """A body thrown up flies freely for 2 v/g, falls back into the string and snaps it taut.

    Largest tension M g + sqrt((M g)^2 + k M v^2), from the energy of body and spring.
    """
    M, L, EA, v = 100.0, 10.0, 1e6, 2.0
    stretch = M * G * L / EA
    simulation = plain_simulation(
        ((0.0, 0.0, 20.0), (0.0, 0.0, 20.0 - L - stretch)), L, 1, EA=EA, mass=1e-6,
        body=free_body(M),
    )  # fmt: skip
    simulation.load.base[0, 2] = -M * G
    simulation.state.v[1, 2] = v
    simulation.start()
    h = 0.0005
    record = run(simulation, 1000, 1, h, controls=TIGHT)
    tension = record.bar_tension[:, 0, 1]
    assert tension.min() == 0.0
    # On the way up the spring gives back (M g)^2/(2 k) and gravity takes M g stretch: v changes.
    left = math.sqrt(v**2 + M * G**2 * L / EA - 2.0 * G * stretch)
    assert float(record.slack_time[0]) == pytest.approx(2.0 * left / G, abs=3 * h)
    snap = M * G + math.sqrt((M * G) ** 2 + EA / L * M * left**2)
    # Steps of h: (omega h)^2/8 at the crest.
    assert tension.max() == pytest.approx(snap, rel=5e-3)


def test_line_dragged_along_a_rough_bed() -> None:
    """A line that lies and is drawn along at 1 cm/s pulls with mu w L at its end; with 0 let go."""
    w, L, mu = 500.0, 50.0, 0.6
    line = Line([Segment(L, w, EA=1e7, mass=80.0)])
    bed, damping = Seabed(5e4, None, mu), LineDamping(0.0, 0.5)
    of = LineProperties(None, damping, Fluid(1025.0, G), bed)
    lines = lay_out_moving([mesh_line(line, 20)], of)
    x = np.linspace([0.0, 0.0, -0.01], [L, 0.0, -0.01], 21)
    slow = Harmonic(1e3, (-2.0, 0.0, 0.0), (math.pi / 2, 0.0, 0.0))
    simulation = Simulation(lines, x, prescribed_motion=series_rows(x[-1:], [slow], 0.0))
    simulation.settle(rubbed=True)
    simulation.start()
    record = run(simulation, 200, 5, 0.01)
    stretch = mu * w * L**2 / 2.0 / 1e7
    pulled = record.fairlead[:, 0, 0] - L
    # Before the whole line slips, friction is mobilised from the end: T = sqrt(2 mu w EA u).
    part = (pulled > 0.2 * stretch) & (pulled < 0.8 * stretch)
    expected = np.sqrt(2.0 * mu * w * 1e7 * pulled[part])
    assert part.sum() > 3
    # The spring of friction gives 1 mm before it slips; bars of 2.5 m.
    assert record.bar_tension[part, 0, 1] == pytest.approx(expected, rel=0.1)
