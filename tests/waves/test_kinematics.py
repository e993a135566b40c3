"""Airy waves: what the velocity potential demands, and the printed formulas."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import pytest

from catopt.constants import STANDARD_GRAVITY
from catopt.waves import (
    Kinematics,
    PowerLawCurrent,
    Sea,
    TableCurrent,
    Waves,
    fill_elevation,
    fill_kinematics,
    jonswap,
    random_waves,
    regular_wave,
    wave_number,
)
from catopt.waves.kinematics import smooth_ramp

Array = npt.NDArray[np.float64]

g = STANDARD_GRAVITY
DEPTH = 56.0
HEIGHT, PERIOD, DIRECTION, PHASE = 4.0, 10.0, math.radians(35.0), 0.7
OMEGA = 2.0 * math.pi / PERIOD
WAVE = regular_wave(HEIGHT, PERIOD, direction=DIRECTION, phase=PHASE)
POINTS = np.array([[0.0, 0.0, 10.0], [31.0, -18.0, 40.0], [-77.0, 5.0, 55.5], [12.0, 90.0, 0.4]])
TIME = 3.3


def velocity(sea: Sea, t: float, points: Array) -> Array:
    return sea.kinematics(t, points).velocity


def storm(count: int = 60, seed: int = 4) -> Waves:
    """Draw a short-crested sea."""
    generator = np.random.default_rng(seed)
    return random_waves(jonswap(6.0, 9.0), count, generator, direction=2.0, spreading=6.0)


def gradient(f: Callable[[Array], Array], points: Array, step: float) -> Array:
    """Central differences along x, y, z; shape (3, ...)."""
    shifts = step * np.eye(3)
    return np.array([(f(points + s) - f(points - s)) / (2.0 * step) for s in shifts])


def potential(t: float, points: Array) -> Array:
    """Phi = (a g/omega) cosh(k z)/cosh(k d) sin(theta), of any book on waves."""
    k = wave_number(OMEGA, DEPTH)
    along = points[:, 0] * math.cos(DIRECTION) + points[:, 1] * math.sin(DIRECTION)
    theta = k * along - OMEGA * t + PHASE
    rise = np.cosh(k * points[:, 2]) / np.cosh(k * DEPTH)
    result: Array = 0.5 * HEIGHT * g / OMEGA * rise * np.sin(theta)
    return result


def test_velocity_is_the_gradient_of_the_potential() -> None:
    """Central differences: the error falls by 4 as the step is halved, to within 2 %."""
    wanted = velocity(Sea(DEPTH, WAVE), TIME, POINTS).T
    coarse, fine = (
        np.abs(gradient(lambda p: potential(TIME, p), POINTS, step) - wanted).max()
        for step in (1.0, 0.5)
    )
    assert coarse / fine == pytest.approx(4.0, rel=0.02)
    assert fine < 1e-3


@pytest.mark.parametrize("ramp_time", [0.0, 20.0])
def test_acceleration_is_the_time_derivative_of_velocity(ramp_time: float) -> None:
    """Second order: 4 for half the step. While the waves grow, their growth accelerates too."""
    sea = Sea(DEPTH, storm(), ramp_time=ramp_time)
    wanted = sea.kinematics(TIME, POINTS).acceleration
    errors = []
    for step in (0.1, 0.05):
        ahead, back = (velocity(sea, TIME + s, POINTS) for s in (step, -step))
        errors.append(np.abs((ahead - back) / (2.0 * step) - wanted).max())
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.02)


def test_water_neither_appears_nor_vanishes_nor_turns() -> None:
    """Divergence and rotation vanish; differences of second order, so 1/4 for half the step."""
    sea = Sea(DEPTH, storm())
    divergence, rotation = [], []
    for step in (0.4, 0.2):
        slope = gradient(lambda p: velocity(sea, TIME, p), POINTS, step)  # [along, point, part]
        divergence.append(np.abs(slope[0, :, 0] + slope[1, :, 1] + slope[2, :, 2]).max())
        rotation.append(np.abs(slope[2, :, 0] - slope[0, :, 2]).max())
    for error in (divergence, rotation):
        assert error[0] / error[1] == pytest.approx(4.0, rel=0.1)
        assert error[1] < 1e-3


def test_no_flow_through_the_bed() -> None:
    """E and q/E at the bed are both exp(-k d), found in two ways: their difference is rounding."""
    on_bed = POINTS * [1.0, 1.0, 0.0]
    motion = Sea(DEPTH, storm()).kinematics(TIME, on_bed)
    assert np.abs(motion.velocity[:, 2]).max() < 1e-15
    assert np.abs(motion.acceleration[:, 2]).max() < 1e-15
    assert np.abs(motion.velocity[:, 0]).min() > 1e-3


def test_below_the_bed_the_water_moves_as_at_the_bed() -> None:
    """A node sinks a little into a soft bed."""
    sea = Sea(DEPTH, storm(), [PowerLawCurrent(1.0)])
    at, below = (sea.kinematics(TIME, POINTS * [1, 1, 0] - [0, 0, z]) for z in (0.0, 0.3))
    np.testing.assert_array_equal(at.velocity, below.velocity)


def test_the_surface_moves_with_the_water() -> None:
    """Linear kinematic condition d eta/dt = w at still water, and dynamic: eta = -dPhi/dt / g.

    Both for the waves as drawn; central difference in time, of second order.
    """
    sea = Sea(DEPTH, storm())
    at = POINTS * [1.0, 1.0, 0.0] + [0.0, 0.0, DEPTH]
    w = velocity(sea, TIME, at)[:, 2]
    errors = []
    for step in (0.1, 0.05):
        ahead, back = (sea.elevation(TIME + s, at[:, 0], at[:, 1]) for s in (step, -step))
        errors.append(np.abs((ahead - back) / (2.0 * step) - w).max())
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.02)
    one = Sea(DEPTH, WAVE)
    pressure = -(potential(TIME + 1e-4, at) - potential(TIME - 1e-4, at)) / (2e-4 * g)
    # Differences of Phi (about 60 m²/s) leave 1e-16 · 60/2e-4/9.8 = 3e-12 m, and omega² dt²/6.
    np.testing.assert_allclose(one.elevation(TIME, at[:, 0], at[:, 1]), pressure, atol=1e-8)


def printed(t: float, points: Array, waves: Waves, depth: float) -> Kinematics:
    """S4 [2.73]-[2.76] as they stand, wave by wave."""
    u, a = np.zeros_like(points), np.zeros_like(points)
    for amplitude, omega, phase, direction in zip(
        waves.amplitude, waves.omega, waves.phase, waves.direction, strict=True
    ):
        k = wave_number(float(omega), depth)
        c, s = math.cos(direction), math.sin(direction)
        theta = k * (points[:, 0] * c + points[:, 1] * s) - omega * t + phase
        cosh = np.cosh(k * points[:, 2]) / math.sinh(k * depth)
        sinh = np.sinh(k * points[:, 2]) / math.sinh(k * depth)
        for j, part in ((0, c), (1, s)):
            u[:, j] += amplitude * omega * cosh * np.cos(theta) * part
            a[:, j] += amplitude * omega**2 * cosh * np.sin(theta) * part
        u[:, 2] += amplitude * omega * sinh * np.sin(theta)
        a[:, 2] -= amplitude * omega**2 * sinh * np.cos(theta)
    return Kinematics(u, a, np.full(points.shape[0], depth))


@pytest.mark.parametrize("depth", [5.0, 56.0])
def test_equals_the_printed_formulas(depth: float) -> None:
    """Angles of some 100 rad carry 1e-14 each, and 60 waves of up to 1 m/s² add up."""
    points = POINTS * [1.0, 1.0, depth / DEPTH]
    ours = Sea(depth, storm()).kinematics(TIME, points)
    theirs = printed(TIME, points, storm(), depth)
    for mine, wanted in zip(ours, theirs, strict=True):
        np.testing.assert_allclose(mine, wanted, atol=1e-12)


def test_deep_water_does_not_overflow() -> None:
    """Cosh(k d) is beyond double precision; the motion is a omega exp(-k (d - z)), in circles."""
    depth, omega = 5000.0, 3.0
    sea = Sea(depth, regular_wave(1.0, 2.0 * math.pi / omega))
    points = np.array([[0.0, 0.0, depth - 2.0], [0.0, 0.0, 10.0]])
    speed = 0.5 * omega * math.exp(-2.0 * omega**2 / g)
    motion = sea.kinematics(0.0, points)
    # k (d - z) = 4590 - 4588 in the exponent leaves 4588 · 1.1e-16 of it.
    np.testing.assert_allclose(motion.velocity[0], [speed, 0.0, 0.0], rtol=1e-12)
    assert motion.velocity[1].tolist() == [0.0, 0.0, 0.0]
    assert np.isfinite(np.concatenate(motion[:2])).all()


def test_a_negligible_wave_is_left_out_without_a_step() -> None:
    """What is left out is less than the rounding of the motion at the surface."""
    k = wave_number(3.0, 200.0)
    sea = Sea(200.0, regular_wave(2.0, 2.0 * math.pi / 3.0))
    edge = 200.0 - 37.0 / k
    motion = velocity(sea, 0.0, np.array([[0.0, 0.0, edge + 1e-6], [0.0, 0.0, edge - 1e-6]]))
    assert 0.0 < motion[0, 0] < 3.0 * np.finfo(float).eps
    assert motion[1, 0] == 0.0


def test_half_wavelength_reach() -> None:
    """S4's rule: full above, nothing below; 10 s reach the bed at 56 m, 5 s do not."""
    short = regular_wave(2.0, 5.0)
    length = 2.0 * math.pi / wave_number(2.0 * math.pi / 5.0, DEPTH)
    limit = DEPTH - 0.5 * length
    points = np.array([[0.0, 0.0, limit + 0.01], [0.0, 0.0, limit - 0.01]])
    cut = Sea(DEPTH, short, reach="half-wavelength").kinematics(0.4, points)
    whole = Sea(DEPTH, short).kinematics(0.4, points)
    np.testing.assert_array_equal(cut.velocity[0], whole.velocity[0])
    assert not cut.velocity[1].any()
    assert not cut.acceleration[1].any()
    assert whole.velocity[1].any()
    bed = np.zeros((1, 3))
    assert velocity(Sea(DEPTH, WAVE, reach="half-wavelength"), 0.0, bed).any()


def test_without_stretching_there_is_no_water_above_still_water() -> None:
    """Under a crest too; up to still water the formulas hold under a trough too."""
    sea = Sea(DEPTH, regular_wave(4.0, 10.0), [TableCurrent([0.0], [1.0])])
    points = np.array([[0.0, 0.0, DEPTH + 0.5], [0.0, 0.0, DEPTH]])
    crest, trough = sea.kinematics(0.0, points), sea.kinematics(5.0, points)
    assert not crest.velocity[0].any()
    assert not crest.acceleration[0].any()
    assert crest.surface.tolist() == trough.surface.tolist() == [DEPTH, DEPTH]
    assert trough.velocity[1, 0] < 0.0 < crest.velocity[1, 0]


def test_wheeler_brings_the_profile_to_the_moving_surface() -> None:
    """At the surface the motion is what the formulas give at still water, and 0 above it."""
    waves = storm()
    sea, plain = Sea(DEPTH, waves, stretching="wheeler"), Sea(DEPTH, waves)
    eta = sea.elevation(TIME, POINTS[:, 0], POINTS[:, 1])
    assert (eta > 0.2).any()
    assert (eta < -0.2).any()
    share = np.array([0.1, 0.7, 0.999999, 0.5])
    at = np.column_stack([POINTS[:, :2], share * (DEPTH + eta)])
    still = np.column_stack([POINTS[:, :2], share * DEPTH])
    motion, wanted = sea.kinematics(TIME, at), plain.kinematics(TIME, still)
    # The same places but for the rounding of z, a slope of order 1/s times 1e-14 m.
    np.testing.assert_allclose(motion.velocity, wanted.velocity, atol=1e-13)
    np.testing.assert_allclose(motion.acceleration, wanted.acceleration, atol=1e-13)
    np.testing.assert_allclose(motion.surface, DEPTH + eta, rtol=1e-15)
    above = np.column_stack([POINTS[:, :2], DEPTH + eta + 1e-6])
    assert not sea.kinematics(TIME, above).velocity.any()


def test_waves_grow_smoothly_and_the_current_is_there_at_once() -> None:
    waves, current = storm(), [TableCurrent([0.0], [0.8])]
    grown = Sea(DEPTH, waves, current)
    sea = Sea(DEPTH, waves, current, ramp_time=30.0)
    still = Sea(DEPTH, None, current)
    np.testing.assert_array_equal(velocity(sea, 0.0, POINTS), velocity(still, 0.0, POINTS))
    np.testing.assert_array_equal(velocity(sea, 30.0, POINTS), velocity(grown, 30.0, POINTS))
    assert sea.elevation(15.0) == pytest.approx(0.5 * float(grown.elevation(15.0)), rel=1e-12)
    rates = [smooth_ramp(t, 30.0)[1] for t in (0.0, 1e-9, 30.0 - 1e-9, 30.0)]
    assert max(map(abs, rates)) < 1e-10  # no jolt at either end


def test_directions() -> None:
    """A wave towards 180 deg moves the water under its crest towards -x."""
    sea = Sea(DEPTH, regular_wave(2.0, 8.0, direction=math.pi))
    u = velocity(sea, 0.0, np.array([[0.0, 0.0, 50.0]]))[0]
    assert u[0] < -0.1
    assert abs(u[1]) < 1e-15
    omega = 2.0 * math.pi / 8.0
    forth = 0.1 * omega / wave_number(omega, DEPTH)
    # A crest's height at the crest: rounding of the angle, squared, is nothing.
    assert float(sea.elevation(0.1, -forth)) == pytest.approx(1.0, rel=1e-14)
    assert float(sea.elevation(0.1, forth)) < 0.999


@pytest.mark.parametrize("stretching", ["none", "wheeler"])
def test_compiled_equals_plain(stretching: str) -> None:
    """The same operations in the same order, but for what the compiler may contract."""
    sea = Sea(
        DEPTH,
        storm(20),
        [PowerLawCurrent(1.0, 0.3), TableCurrent([0.0, 30.0, 56.0], [1.47, 1.43, 1.0])],
        stretching=stretching,  # type: ignore[arg-type]
        ramp_time=10.0,
    )
    plain = Kinematics(np.empty((4, 3)), np.empty((4, 3)), np.empty(4))
    fill_kinematics(TIME, POINTS, sea.flow, *plain)
    for fast, slow in zip(sea.kinematics(TIME, POINTS), plain, strict=True):
        np.testing.assert_allclose(fast, slow, atol=1e-13)
    t, eta = np.array([0.0, 1.0, 55.0]), np.empty(3)
    fill_elevation(t, np.full(3, 5.0), np.full(3, 6.0), sea.flow, eta)
    np.testing.assert_allclose(sea.elevation(t, 5.0, 6.0), eta, atol=1e-13)


def test_still_water_and_no_points() -> None:
    sea = Sea(DEPTH)
    assert not sea.kinematics(1.0, POINTS).velocity.any()
    assert sea.elevation([0.0, 1.0]).tolist() == [0.0, 0.0]
    assert sea.kinematics(1.0, np.empty((0, 3))).velocity.shape == (0, 3)
