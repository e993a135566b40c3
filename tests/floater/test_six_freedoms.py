"""A hull in all six freedoms: weather from the side is weather from ahead, turned."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from catopt.fem.afloat import Afloat, step_hull
from catopt.fem.mesh import mesh_line
from catopt.fem.morison import MorisonSection
from catopt.fem.moving import BodyNode
from catopt.fem.newmark import LineDamping, Scheme
from catopt.fem.run_settings import TimeStepping
from catopt.fem.sampling import Rules
from catopt.fem.seabed import Seabed
from catopt.fem.solve import Leg
from catopt.floater.alone import freedoms, run_alone
from catopt.floater.moored import moored_at_rest, run_moored
from catopt.hydro.build import FloatingHull, Radiation, record_of, room_of, state_of
from catopt.hydro.cylinder import FloatingCylinder
from catopt.waves import PowerLawCurrent, Sea, Waves
from tests.floater.test_moored import DEPTH, DRY, LEG, LINE, buoy

RADIATION = Radiation.of_cylinder(FloatingCylinder(1.2, 0.6, DEPTH, -0.1, 1025.0, 9.80665))
STEEP = 0.25
"""Amplitude of the wave, m: hull and line are far from linear in it."""


def sea_from(direction: float, *, current: float = 0.8) -> Sea:
    """Two waves and a current in one direction, rad."""
    omega = np.array([1.3, 1.9])
    waves = Waves(np.array([STEEP, 0.1]), omega, np.array([0.4, 2.0]), np.full(2, direction))
    return Sea(DEPTH, waves, (PowerLawCurrent(current, direction, 1e-9),))


def hull_in_wind(direction: float, **of: object) -> FloatingHull:
    """Make the drum of the other tests, that drags along its axis, too."""
    given = {"bottom_drag": 2000.0, "bottom_radius": 1.2, "radiation": RADIATION, **of}
    return buoy(wind=(600.0, 1.0), wind_direction=direction, **given)


def turned(way: np.ndarray, by: float) -> np.ndarray:
    """Components along a direction, across it, and up; of a way (n, 3)."""
    cosine, sine = math.cos(by), math.sin(by)
    out: np.ndarray = way @ np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    return out


SMOOTH = replace(
    DRY,
    sections=[MorisonSection(0.05, drag_normal=1.2, drag_tangential=0.1, added_mass_normal=1.0)],
    damping=LineDamping(stiffness_time=0.02),
    seabed=Seabed(2e4, 2e3, friction=0.0),
)
STEPPING = TimeStepping(10.0, 0.05, ramp_time=4.0)


@pytest.mark.parametrize("direction", [0.5, -2.0])
def test_alone_it_goes_with_the_weather_wherever_that_goes(direction: float) -> None:
    """To what the steps leave over: surge and sway, and how its axis leans."""
    ahead = run_alone(hull_in_wind(0.0), STEPPING, sea=sea_from(0.0))
    aside = run_alone(hull_in_wind(direction), STEPPING, sea=sea_from(direction))
    assert ahead.free.tolist() == [True, False, True, False, True, False]
    assert aside.free.tolist() == [True] * 5 + [False]
    assert np.ptp(ahead.place[:, 4]) > 0.05
    assert turned(aside.place[:, :3], direction) == pytest.approx(ahead.place[:, :3], abs=2e-5)
    roll, pitch = aside.place[:, 3], aside.place[:, 4]
    axis = np.stack([np.cos(roll) * np.sin(pitch), -np.sin(roll), np.cos(roll) * np.cos(pitch)], 1)
    leans = turned(axis, direction)
    assert np.arctan2(leans[:, 0], leans[:, 2]) == pytest.approx(ahead.place[:, 4], abs=2e-5)
    assert leans[:, 1] == pytest.approx(np.zeros(leans.shape[0]), abs=2e-5)
    assert aside.works == pytest.approx(ahead.works, rel=1e-4, abs=1e-2)


def test_a_buoy_on_one_line_swings_to_the_weather() -> None:
    """At rest and in motion all is turned: places, and the tension at both ends."""
    mesh, direction = [mesh_line(LINE, 10)], math.radians(-70.0)
    results = [
        run_moored(hull_in_wind(at), LEG, mesh, STEPPING, sea=sea_from(at), properties=SMOOTH)
        for at in (0.0, direction)
    ]
    (ahead, hull), (aside, other) = results
    assert other.free.tolist() == [True] * 5 + [False]
    assert turned(other.place[:, :3], direction) == pytest.approx(hull.place[:, :3], abs=1e-5)
    largest = ahead.bar_tension.max()
    assert aside.bar_tension == pytest.approx(ahead.bar_tension, abs=1e-3 * largest)
    assert np.ptp(ahead.fairlead_tension) > 0.2 * largest
    assert other.numerical_part == pytest.approx(hull.numerical_part, rel=0.01)


def around(turn: float) -> tuple[tuple[Leg, ...], tuple[tuple[float, float, float], ...]]:
    """Three lines and their eyes, turned about the vertical, rad."""
    at = [turn + each for each in (0.0, 2.0 * math.pi / 3.0, -2.0 * math.pi / 3.0)]
    legs = tuple(Leg(LINE, (30.0 * math.cos(a), 30.0 * math.sin(a), 0.0)) for a in at)
    return legs, tuple((0.8 * math.cos(a), 0.8 * math.sin(a), -0.3) for a in at)


def test_on_three_lines_turned_with_the_weather() -> None:
    """Lines and weather turned alike: every line carries what it carried."""
    direction, results = 0.7, []
    for at in (0.0, direction):
        legs, eyes = around(at)
        hull = hull_in_wind(at, eyes=eyes)
        meshes = [mesh_line(LINE, 6)] * 3
        sea = sea_from(at)
        results.append(run_moored(hull, legs, meshes, STEPPING, sea=sea, properties=SMOOTH))
    (ahead, first), (aside, other) = results
    assert first.free.tolist() == [True, False, True, False, True, False]
    assert other.free.all()
    assert turned(other.place[:, :3], direction) == pytest.approx(first.place[:, :3], abs=1e-4)
    # Nothing damps its yaw: what the steps leave over shows.
    assert other.place[:, 5] == pytest.approx(np.zeros(other.time.size), abs=2e-3)
    largest = ahead.bar_tension.max()
    assert aside.bar_tension == pytest.approx(ahead.bar_tension, abs=1e-3 * largest)


def test_weather_on_one_side_of_three_lines() -> None:
    """Along y the lines are not mirrored by x: at rest all balances, by the truss's own pulls."""
    legs, eyes = around(0.0)
    hull = hull_in_wind(0.5 * math.pi, eyes=eyes)
    sea, meshes = sea_from(0.5 * math.pi), [mesh_line(LINE, 12)] * 3
    assert all(freedoms(hull, legs, sea))
    rest = moored_at_rest(hull, legs, meshes, sea=sea, properties=DRY)
    assert rest.state.q[1] > 0.5
    assert rest.line[1] < -600.0  # wind, and the current's drag
    assert rest.line == pytest.approx(-rest.state.force, abs=1e-6 * 2200.0 * 9.80665)
    _, moved = run_moored(hull, legs, meshes, STEPPING, sea=sea, properties=DRY)
    assert np.ptp(moved.place[:, 3]) > 0.05
    assert moved.numerical_part < 2e-3
    assert np.ptp(moved.place[:, 5]) > 1e-3  # it yaws, since nothing mirrors its lines


def test_a_free_top_nutates_as_in_closed_form() -> None:
    """Its axis goes round the angular momentum L at |L| over the inertia across, unforced.

    The scheme is of second order in the step.
    """
    hull = FloatingHull(
        np.array([0.0]), np.array([1.0]), np.array([0.5]), 1.0, 2.0, 0.5, 0.5,
        spin_inertia=3.0, density=1e-12, gravity=1e-12,
    )  # fmt: skip
    sea, omega = Sea(100.0), np.array([0.3, 0.1, 1.5])
    momentum = np.diag([2.0, 2.0, 3.0]) @ omega
    size, duration = float(np.linalg.norm(momentum)), 4.0
    k, angle = momentum / size, size / 2.0 * duration
    up = np.array([0.0, 0.0, 1.0])
    exact = up * math.cos(angle) + np.cross(k, up) * math.sin(angle)
    exact += k * (k @ up) * (1.0 - math.cos(angle))
    laid, none, how = hull.lay_out(sea.flow), np.zeros(3), Scheme.average_acceleration()
    misfits = []
    for step in (0.02, 0.01):
        now, before = (state_of(laid, (0.0, 0.0, 100.0)) for _ in range(2))
        body = Afloat(laid, now, before, room_of(laid), record_of(1), BodyNode(none, none, none))
        before.v[3:] = omega
        aside = np.cross(omega, up)
        before.force[3:] = -(3.0 - 2.0) * omega[2] * aside
        before.a[3:] = before.force[3:] / [2.0, 2.0, 3.0]
        rules = Rules(
            alpha_m=how.alpha_m, alpha_f=how.alpha_f, beta=how.beta, gamma=how.gamma, step=step,
            every=1, limit=30, halvings=0, refinements=0, surprise=1.0, transits=1.0,
            tolerance=1e-3, since=0.0, until=duration,
        )  # fmt: skip
        for i in range(round(duration / step)):
            closed, _ = step_hull(i * step, step, rules, sea.flow, body)
            assert closed
            before.q[:], before.axes[:], before.v[:], before.a[:] = now.q, now.axes, now.v, now.a
            before.force[:] = now.force
        misfits.append(float(np.linalg.norm(now.axes[:, 2] - exact)))
        assert now.axes.T @ now.axes == pytest.approx(np.eye(3), abs=1e-12)
    assert misfits[1] < 1e-3
    assert misfits[0] / misfits[1] == pytest.approx(4.0, rel=0.1)
