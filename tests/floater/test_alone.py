"""A hull by itself: decays, waves and forces against experiments, closed forms and frequency."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pandas as pd
import pytest

from catopt.fem.newmark import Scheme
from catopt.fem.run_settings import TimeStepping
from catopt.floater.alone import HullHistory, run_alone
from catopt.hydro.build import FloatingHull, Radiation
from catopt.hydro.coefficients import Memory
from catopt.hydro.cylinder import FloatingCylinder
from catopt.waves import Sea, regular_wave

DATA = Path(__file__).parents[1] / "hydro"
SMALL = 1e-3
"""Largest part of the energy put in that steps may lose."""
HEAVES = (False, False, True, False, False, False)
STEADY = Scheme.average_acceleration()


def sphere_radiation() -> Radiation:
    """Coefficients of capytaine 3.0, density 1000 kg/m3, deep; the last row is the fast limit."""
    table = pd.read_csv(DATA / "sphere_heave_coefficients.csv")
    omega, A, B = table.to_numpy().T
    mass, damping = np.zeros((2, omega.size - 1, 3, 3))
    mass[:, 1, 1], damping[:, 1, 1] = A[:-1], B[:-1]
    limit = np.zeros((3, 3))
    limit[1, 1] = A[-1]
    return Radiation(omega[:-1], mass, damping, limit, None, 30.0)


def heave_alone(**of: object) -> FloatingHull:
    """Make the sphere of IEA OES Task 10: radius 5 m, 261.8 t, afloat to its middle."""
    given = {"free": HEAVES, "density": 1000.0, "gravity": 9.81, **of}
    return FloatingHull(mass=261.8e3, inertia=1.0, centre=3.0, draught=5.0, **given)  # type: ignore[arg-type]


def turning_points(history: HullHistory) -> npt.NDArray[np.float64]:
    """Find times and heights over rest of the extremes after the start."""
    z = history.place[:, 2] - (3.0 - 5.0)
    at = 1 + np.flatnonzero((z[1:-1] - z[:-2]) * (z[2:] - z[1:-1]) < 0.0)
    found = []
    for i in at:  # through three samples a parabola
        a, b, c = z[i - 1 : i + 2]
        off = 0.5 * (a - c) / (a - 2.0 * b + c)
        found.append((history.time[i] + off * history.time[1], b - 0.25 * (a - c) * off))
    return np.array(found)


def rms_to_cfd(history: HullHistory) -> float:
    table = pd.read_csv(DATA / "sphere_decay_1m.csv")
    table = table[table.time_s <= 13.0]
    z = np.interp(table.time_s, history.time, history.place[:, 2] + 2.0)
    return float(np.sqrt(np.mean((z - table.nrel_cfd_m) ** 2)))


def test_sphere_falls_as_in_the_viscous_computation() -> None:
    """Linear hydrostatics, as its coefficients are: a wall-sided body of the same waterplane."""
    too_much = (math.pi * 125.0 - 261.8) * 1000.0 * 9.81
    wall = heave_alone(
        foot=np.array([0.0]),
        top=np.array([10.0]),
        radius=np.array([5.0]),
        radiation=sphere_radiation(),
        constant=(0.0, -too_much, 0.0),
    )
    history = run_alone(
        wall, TimeStepping(16.0, 0.02, scheme=STEADY), sea=Sea(300.0), offset=(0.0, 1.0, 0.0)
    )
    assert rms_to_cfd(history) < 0.01
    printed = [(2.23, -0.869), (4.45, 0.637), (6.63, -0.469), (8.81, 0.349)]
    for (t, z), (t_cfd, z_cfd) in zip(turning_points(history), printed, strict=False):
        assert t == pytest.approx(t_cfd, abs=0.03)
        assert z == pytest.approx(z_cfd, abs=0.02)
    assert history.numerical_part < SMALL


def test_sphere_of_slices_falls_so_too() -> None:
    """Buoyancy over what is under water at each time, 40 slices: 0.013 m, with the same table.

    Its fast limit, 135.5 t, is 3.5 % above the closed form of a hemisphere, rho V/2 = 130.9 t; with
    that the misfit falls below 0.01 m.
    """
    ends = np.linspace(-5.0, 5.0, 41)
    low, high = ends[:-1], ends[1:]
    radius = np.sqrt(25.0 - (low * low + low * high + high * high) / 3.0)
    given, misfits = sphere_radiation(), []
    limit = np.zeros((3, 3))
    limit[1, 1] = 1000.0 * math.pi * 125.0 / 3.0
    exact = Radiation(given.omega, given.added_mass, given.damping, limit, None, 30.0)
    for radiation in (given, exact):
        hull = heave_alone(foot=low + 5.0, top=high + 5.0, radius=radius, radiation=radiation)
        stepping = TimeStepping(13.0, 0.05, scheme=STEADY)
        history = run_alone(hull, stepping, sea=Sea(300.0), offset=(0.0, 1.0, 0.0))
        assert history.numerical_part < SMALL
        misfits.append(rms_to_cfd(history))
    assert misfits[0] < 0.013
    assert misfits[1] < 0.01


def test_sphere_rides_waves_as_five_codes_have_it() -> None:
    """Response by its coefficients and Haskind's force, at ten periods.

    In deep water |X|^2 = 2 rho g^3 B/w^3. Steepness 0.01: nothing is steep. Where the codes agree
    better than 3 %, within that of their mean; at 3 s, beside the irregular frequency of 2.2 rad/s
    that spoils the table's damping (40, 23, 55 t/s in steps of 0.1 rad/s), within 8 %.
    """
    given, rho, g = sphere_radiation(), 1000.0, 9.81
    for _, row in pd.read_csv(DATA / "sphere_heave_rao.csv").iterrows():
        w = 2.0 * math.pi / row.period_s
        B = float(np.interp(w, given.omega, given.damping[:, 1, 1]))
        A = float(np.interp(w, given.omega, given.added_mass[:, 1, 1]))
        X = math.sqrt(2.0 * rho * g**3 * B / w**3)
        stiffness = rho * g * math.pi * 25.0 - w * w * (261.8e3 + A)
        response = X / abs(complex(stiffness, -w * B))
        codes = row.to_numpy()[1:]
        near = 0.08 if row.period_s == 3.0 else 0.03
        low = min(codes.min(), (1.0 - near) * codes.mean())
        high = max(codes.max(), (1.0 + near) * codes.mean())
        assert low <= response <= high, row.period_s


def buoy(**of: object) -> FloatingHull:
    a, draught, centre, depth = 1.2, 0.7, 0.3, 12.0
    mass = 1025.0 * math.pi * a * a * draught
    ends = np.linspace(0.0, 1.4, 8)
    given = {
        "radiation": Radiation.of_cylinder(FloatingCylinder(a, draught, depth, centre - draught)),
        "density": 1025.0,
        **of,
    }
    return FloatingHull(
        ends[:-1],
        ends[1:],
        np.full(7, a),
        mass,
        mass * 0.55**2,
        centre,
        draught,
        **given,  # type: ignore[arg-type]
    )


@pytest.mark.parametrize("direction", [0.0, math.pi])
@pytest.mark.parametrize("period", [2.5, 4.0])
def test_regular_waves_against_the_frequency_domain(period: float, direction: float) -> None:
    """Surge, heave and pitch in waves of 1 cm; heave and pitch resonate near 2.5 s.

    Three exponentials' misfit of the damping, and sixty steps in a period: within 2 %.
    """
    damping = (2000.0, 0.0, 50.0)
    hull, w = buoy(damping=damping), 2.0 * math.pi / period
    cylinder = FloatingCylinder(1.2, 0.7, 12.0, 0.3 - 0.7)
    answer = cylinder.at([w])
    mass = np.diag([hull.mass, hull.mass, hull.inertia]) + answer.added_mass[0]
    through = -w * w * mass - 1j * w * (answer.damping[0] + np.diag(damping)) + hull.stiffness
    expected = np.linalg.solve(through, answer.excitation[0])
    expected[[0, 2]] *= math.cos(direction)
    sea = Sea(12.0, regular_wave(0.01, period, direction=direction))
    stepping = TimeStepping(22.0 * period, period / 60.0, ramp_time=4.0 * period, scheme=STEADY)
    history = run_alone(hull, stepping, sea=sea)
    late = history.time > 18.0 * period - 1e-9
    t = history.time[late]
    basis = np.stack([np.cos(w * t), np.sin(w * t), np.ones_like(t), t], axis=1)
    found = np.linalg.lstsq(basis, history.place[late][:, [0, 2, 4]], rcond=None)[0]
    k = sea.wave_numbers[0] * math.cos(direction)
    for i in range(3):
        answered = complex(found[0, i], found[1, i]) / 0.005
        assert answered == pytest.approx(expected[i] * np.exp(1j * k * found[2, 0]), rel=0.02)
    assert history.numerical_part < SMALL


def test_spar_bobs_with_its_closed_period() -> None:
    """T = 2 pi sqrt((m + A)/(rho g A_w)); average acceleration lengthens it by (w h)^2/24."""
    a, draught = 3.0, 60.0
    mass = 1025.0 * math.pi * a * a * draught
    added = np.zeros((3, 3))
    added[1, 1] = 1025.0 * 2.0 / 3.0 * math.pi * a**3
    none = Radiation.none()
    spar = FloatingHull(
        np.array([0.0]), np.array([80.0]), np.array([a]), mass, mass * 400.0, 20.0, draught,
        radiation=Radiation(none.omega, none.added_mass, none.damping, added, None, 1.0),
        free=HEAVES, density=1025.0, gravity=9.81,
    )  # fmt: skip
    w = math.sqrt(1025.0 * 9.81 * math.pi * a * a / (mass + added[1, 1]))
    h = 0.1
    stepping = TimeStepping(100.0, h, scheme=STEADY)
    history = run_alone(spar, stepping, sea=Sea(200.0), offset=(0.0, 0.5, 0.0))
    slower = w * (1.0 - (w * h) ** 2 / 12.0)
    z = history.place[:, 2] - (20.0 - 60.0)
    assert z == pytest.approx(0.5 * np.cos(slower * history.time), abs=1e-4)
    assert history.numerical_part < 1e-9


def test_memory_with_one_exponential_has_the_decay_of_a_cubic() -> None:
    """With K = a exp(-b t), m x'' + int K x' + c x = 0 has (m s^2 + c)(s + b) + a s = 0."""
    a, b = 4.0e4, 0.9
    m = 1025.0 * math.pi * 1.2**2 * 0.7
    c = 1025.0 * 9.80665 * math.pi * 1.2**2
    roots = np.roots([m, m * b, c + a, b * c])
    # x(0) = 1, x'(0) = 0, and no memory at first: m x''(0) = -c.
    of = np.linalg.solve(np.vander(roots, 3, increasing=True).T, [1.0, 0.0, -c / m])

    class Given(Radiation):
        @property
        def memory(self) -> Memory:
            one = np.array([1])
            return Memory(one, one, np.array([-b + 0j]), np.array([a + 0j]))

    none = Radiation.none()
    made = Given(none.omega, none.added_mass, none.damping, np.zeros((3, 3)), None, 1.0)
    hull = buoy(radiation=made, free=HEAVES)
    misfits = []
    for step in (0.02, 0.01):
        stepping = TimeStepping(8.0, step, scheme=STEADY)
        history = run_alone(hull, stepping, sea=Sea(12.0), offset=(0.0, 0.1, 0.0))
        exact = 0.1 * (np.exp(np.outer(history.time, roots)) @ of).real
        misfits.append(float(np.abs(history.place[:, 2] - (0.3 - 0.7) - exact).max()))
        assert history.numerical_part < SMALL
    # The scheme slows by (w h)^2/12 = 1.1e-4, over 30 rad of 0.1 m that decay.
    assert misfits[1] < 2e-4
    assert misfits[0] / misfits[1] == pytest.approx(4.0, rel=0.1)  # second order


def test_held_under_it_comes_up_by_all_of_its_buoyancy() -> None:
    """Fully under water the lift is rho g V, and half out of its depth nothing is."""
    hull = buoy(radiation=Radiation.none(), free=HEAVES)
    volume = math.pi * 1.2**2 * 1.4
    stepping = TimeStepping(0.002, 0.001, scheme=STEADY)
    under = run_alone(hull, stepping, sea=Sea(12.0), offset=(0.0, -3.0, 0.0))
    lift = 1025.0 * 9.80665 * (volume - math.pi * 1.2**2 * 0.7)
    risen = under.place[-1, 2] - under.place[0, 2]
    assert risen == pytest.approx(0.5 * lift / hull.mass * 0.002**2, rel=1e-6)
    out = run_alone(hull, stepping, sea=Sea(12.0), offset=(0.0, 3.0, 0.0))
    fallen = out.place[-1, 2] - out.place[0, 2]
    assert fallen == pytest.approx(-0.5 * 9.80665 * 0.002**2, rel=1e-6)
    assert under.wet[-1] == pytest.approx(volume)
    assert out.wet[-1] == 0.0
