"""Forces on a hull that is stepped in time, one by one: vectors, integrals, and by hand."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.spatial.transform import Rotation

from catopt.arrays import Array
from catopt.hydro.build import FloatingHull, room_of, state_of
from catopt.hydro.hull import (
    DAMPING,
    DIFFRACTION,
    DRAG,
    MEMORY,
    PRESSURE,
    WIND,
    Hull,
    HullRoom,
    HullState,
    attitude,
    carry_memory,
    cross,
    fill_forces_on_hull,
    fill_sea,
    fill_sea_between,
    hull_inertia,
    keep_sea,
    rotated,
)
from catopt.waves import Sea, regular_wave

DEPTH, RHO, G = 40.0, 1025.0, 9.80665
FOOT, TOP, RADIUS = np.array([0.0, 4.0]), np.array([4.0, 10.0]), np.array([2.0, 1.5])
CENTRE = 3.5
TILTED = Rotation.from_euler("zyx", [0.4, 0.25, -0.3]).as_matrix()
MOVES = np.array([0.7, -0.4, 0.3, 0.06, -0.09, 0.04])


def spar(**own: object) -> Hull:
    """Two cylinders, one on the other, of 60 t, upright in 40 m of water."""
    hull = FloatingHull(
        FOOT,
        TOP,
        RADIUS,
        60e3,
        9e5,
        CENTRE,
        6.0,
        density=RHO,
        gravity=G,
        **own,  # type: ignore[arg-type]
    )
    return hull.lay_out(Sea(DEPTH).flow)


def at(hull: Hull, z: float, axes: Array, moves: Array | None = None) -> tuple[HullState, HullRoom]:
    """Put a hull with its centre of gravity at a height above the bed, m, into still water."""
    state, room = state_of(hull, (3.0, -2.0, z)), room_of(hull)
    state.axes[:] = axes
    if moves is not None:
        state.v[:] = moves
    return state, room


def pushed(hull: Hull, state: HullState, room: HullRoom) -> Array:
    fill_forces_on_hull(hull, state, DEPTH, room)
    return state.parts


def test_vectors_are_turned_as_by_another_library() -> None:
    vector, by = np.array([1.0, -2.0, 0.5]), np.array([0.3, -1.1, 0.7])
    assert cross(vector, by) == pytest.approx(np.cross(vector, by))
    assert rotated(by, *vector) == pytest.approx(Rotation.from_rotvec(by).apply(vector))
    small = 1e-10 * by
    assert np.array(rotated(small, *vector)) - vector == pytest.approx(
        np.cross(small, vector), rel=1e-5, abs=1e-16
    )
    assert state_of(spar(), (0.0, 0.0, 30.0), 0.2).axes == pytest.approx(
        Rotation.from_euler("y", 0.2).as_matrix()
    )


def test_roll_pitch_and_yaw_are_those_that_turned_it() -> None:
    """About its axis first, then about x, then about y: angles of the three in one."""
    roll, pitch, yaw = 0.3, -0.5, 1.1
    axes = Rotation.from_euler("zxy", [yaw, roll, pitch]).as_matrix()
    assert attitude(axes) == pytest.approx((roll, pitch, yaw))
    # What rounding makes of an axis that lies along y.
    lying = Rotation.from_euler("x", 0.5 * math.pi).as_matrix()
    lying[1, 2] = -1.0 - 1e-15
    assert attitude(lying)[0] == pytest.approx(0.5 * math.pi)


def test_under_water_each_slice_is_pushed_by_what_it_displaces() -> None:
    """Rho V (a + g) at its middle, in water that accelerates otherwise at each slice."""
    hull = spar()
    state, room = at(hull, 20.0, TILTED)
    room.acceleration[:] = [[0.3, -0.2, 0.1], [-0.5, 0.4, 0.6]]
    parts = pushed(hull, state, room)
    volumes = math.pi * RADIUS**2 * (TOP - FOOT)
    force = RHO * volumes[:, np.newaxis] * (room.acceleration + np.array([0.0, 0.0, G]))
    arms = np.outer(0.5 * (FOOT + TOP) - CENTRE, TILTED[:, 2])
    assert state.wet[0] == pytest.approx(volumes.sum())
    assert parts[PRESSURE, :3] == pytest.approx(force.sum(axis=0) - [0.0, 0.0, 60e3 * G])
    assert parts[PRESSURE, 3:] == pytest.approx(np.cross(arms, force).sum(axis=0))


def under_surface(z: float, axes: Array, sea: tuple[float, float, float]) -> tuple[float, Array]:
    """Volume under a sloping plane and its first moment about the centre of gravity, by quadrature.

    Over each disc by Gauss in the square of the radius and evenly around; along the axis exactly.
    """
    points, weights = np.polynomial.legendre.leggauss(200)
    angles = 2.0 * math.pi * (np.arange(240) + 0.5) / 240
    volume, moment = 0.0, np.zeros(3)
    slope = np.array([sea[1], sea[2], -1.0])
    for low, high, R in zip(FOOT - CENTRE, TOP - CENTRE, RADIUS, strict=True):
        r = R * np.sqrt(0.5 * (points + 1.0))
        share = np.repeat(0.5 * math.pi * R * R * weights / angles.size, angles.size)
        x, y = (np.outer(r, part).ravel() for part in (np.cos(angles), np.sin(angles)))
        across = np.outer(x, axes[:, 0]) + np.outer(y, axes[:, 1])
        # Under the plane where s n.slope + across.slope + (depth + surface - z) is above 0.
        top = (DEPTH + sea[0] - z + across @ slope) / -(axes[:, 2] @ slope)
        top = np.clip(top, low, high)
        volume += float(share @ (top - low))
        moment += (share * (top - low)) @ across
        moment += 0.5 * float(share @ (top**2 - low**2)) * axes[:, 2]
    return volume, moment


@pytest.mark.parametrize("sea", [(0.0, 0.0, 0.0), (0.4, 0.05, -0.08)])
def test_cut_by_the_surface_it_floats_by_what_is_under(sea: tuple[float, float, float]) -> None:
    """Columns are exact where the surface leaves through the side: volume, force and moment."""
    hull = spar()
    state, room = at(hull, DEPTH - 3.0, TILTED)
    room.sea[:3] = sea
    parts = pushed(hull, state, room)
    volume, moment = under_surface(DEPTH - 3.0, TILTED, sea)
    assert state.wet[0] == pytest.approx(volume, rel=1e-6)
    assert parts[PRESSURE, 2] == pytest.approx(RHO * G * volume - 60e3 * G, rel=1e-6)
    expected = RHO * np.cross(moment, [0.0, 0.0, G])
    assert parts[PRESSURE, 3:] == pytest.approx(expected, abs=1e-6 * np.abs(expected).max())


def test_where_the_surface_leaves_through_its_end_nine_columns_are_near() -> None:
    """The lower edge alone in the water: a kink between nine columns costs some 3 %."""
    hull, axes = spar(), Rotation.from_euler("y", 0.6).as_matrix()
    z = DEPTH + 3.3
    state, room = at(hull, z, axes)
    parts = pushed(hull, state, room)
    volume, moment = under_surface(z, axes, (0.0, 0.0, 0.0))
    assert 0.0 < volume < 0.1 * math.pi * RADIUS[0] ** 2 * 4.0
    assert state.wet[0] == pytest.approx(volume, rel=0.04)
    expected = RHO * np.cross(moment, [0.0, 0.0, G])
    assert parts[PRESSURE, 4] == pytest.approx(expected[1], rel=0.04)


def test_above_the_water_there_is_its_weight_alone() -> None:
    hull = spar(constant=(1.0, 2.0, 3.0))
    state, room = at(hull, DEPTH + 12.0, np.eye(3))
    parts = pushed(hull, state, room)
    assert state.wet[0] == 0.0
    assert parts[PRESSURE].tolist() == [1.0, 0.0, 2.0 - 60e3 * G, 0.0, 3.0, 0.0]


def across(axes: Array, water: Array, moves: Array, s: float) -> Array:
    """Speed of the water past a place on the axis, across it, as a vector."""
    n = axes[:, 2]
    past = water - moves[:3] - np.cross(moves[3:], s * n)
    return np.asarray(past - (past @ n) * n)


def test_drag_across_each_slice_is_along_the_water_that_passes_it() -> None:
    """0.5 rho C D L |w| w at its middle; of a slice that is partly wet over that part."""
    drag = np.array([700.0, 300.0])
    hull = spar(drag=drag)
    water = np.array([[1.1, 0.4, -0.2], [0.6, -0.7, 0.3]])
    for z, wet in ((20.0, (4.0, 6.0)), (DEPTH - 2.5, (4.0, 2.0))):
        axes = TILTED if wet[1] == 6.0 else np.eye(3)
        state, room = at(hull, z, axes, MOVES)
        room.velocity[:] = water
        parts = pushed(hull, state, room)
        force, moment = np.zeros(3), np.zeros(3)
        for j, foot in enumerate(FOOT - CENTRE):
            s = foot + 0.5 * wet[j]
            w = across(axes, water[j], MOVES, s)
            push = drag[j] * wet[j] * np.linalg.norm(w) * w
            force, moment = force + push, moment + np.cross(s * axes[:, 2], push)
        assert parts[DRAG, :3] == pytest.approx(force, rel=1e-9)
        assert parts[DRAG, 3:] == pytest.approx(moment, rel=1e-9)


def test_newton_has_the_derivative_of_drag_and_damping() -> None:
    """Central differences of the forces over each velocity."""
    hull = spar(drag=np.array([700.0, 300.0]), damping=(50.0, 80.0, 900.0))
    water = np.array([[1.1, 0.4, -0.2], [0.6, -0.7, 0.3]])
    change = np.zeros((6, 6))
    for j in range(6):
        ends = []
        for sign in (1.0, -1.0):
            state, room = at(hull, 20.0, TILTED, MOVES + sign * 1e-4 * np.eye(6)[j])
            room.velocity[:] = water
            parts = pushed(hull, state, room)
            ends.append(parts[DRAG] + parts[DAMPING])
        change[:, j] = (ends[0] - ends[1]) / 2e-4
    state, room = at(hull, 20.0, TILTED, MOVES)
    room.velocity[:] = water
    pushed(hull, state, room)
    assert room.by_v == pytest.approx(-change, rel=1e-5, abs=1e-3)


def test_in_its_plane_newton_takes_what_the_plane_has() -> None:
    """A hull that keeps to surge, heave and pitch has no derivative across; the others stay."""
    drag = np.array([700.0, 300.0])
    both = []
    for free in ((True,) * 6, (True, False, True, False, True, False)):
        hull = spar(drag=drag, free=free)
        state, room = at(hull, 20.0, np.eye(3))
        room.velocity[:] = [1.0, 0.0, 0.0]
        pushed(hull, state, room)
        both.append(room.by_v.copy())
    assert both[1][1] == pytest.approx(np.zeros(6), abs=1e-9)
    assert both[0][1, 1] == pytest.approx(700.0 * 4.0 + 300.0 * 6.0)
    assert both[1][[0, 2, 4]] == pytest.approx(both[0][[0, 2, 4]])


def test_drag_on_the_bottom_of_what_heaves() -> None:
    """0.5 rho C A (w - v) |w - v|, whatever the columns: their shares make one."""
    hull = spar(bottom_drag=5e3, bottom_radius=2.0)
    state, room = at(hull, 20.0, TILTED, np.array([0.3, 0.2, -0.8, 0.0, 0.0, 0.0]))
    room.velocity[0] = [0.1, -0.3, 0.25]
    parts = pushed(hull, state, room)
    n = TILTED[:, 2]
    w = float((room.velocity[0] - state.v[:3]) @ n)
    assert parts[DRAG, :3] == pytest.approx(5e3 * abs(w) * w * n)
    assert parts[DRAG, 3:] == pytest.approx(np.zeros(3), abs=1e-6)
    assert room.by_v[:3, :3] == pytest.approx(2.0 * 5e3 * abs(w) * np.outer(n, n))


def test_drag_on_the_bottom_of_what_pitches() -> None:
    """Over a disc the mean of |x|^3 is 8 R^3/(15 pi); nine columns are within 1 %."""
    hull = spar(bottom_drag=5e3, bottom_radius=2.0)
    rate = np.array([0.06, -0.09, 0.0])
    state, room = at(hull, 20.0, np.eye(3), np.array([0.0, 0.0, 0.0, *rate]))
    parts = pushed(hull, state, room)
    size = float(np.linalg.norm(rate))
    expected = -5e3 * 8.0 * 2.0**3 / (15.0 * math.pi) * size * rate
    assert parts[DRAG, 3:5] == pytest.approx(expected[:2], rel=0.01)
    assert parts[DRAG, [0, 1, 2, 5]] == pytest.approx(np.zeros(4), abs=1e-9)
    # Energy leaves with the turn, in the derivative too: twice the force over the rate.
    turn = room.by_v[3:, 3:] @ rate
    assert turn == pytest.approx(-2.0 * parts[DRAG, 3:])


def test_a_bottom_near_the_surface_has_part_of_its_drag() -> None:
    """Half a radius under still water: half of it; in a wave of 0.4 m 0.2 more; out of it none."""
    hull = spar(bottom_drag=5e3, bottom_radius=2.0)
    for under, wave, part in ((1.0, 0.0, 0.5), (1.0, 0.4, 0.7), (-0.1, 0.0, 0.0), (9.0, 0.0, 1.0)):
        state, room = at(hull, DEPTH + CENTRE - under, np.eye(3), np.eye(6)[2])
        room.sea[0] = wave
        parts = pushed(hull, state, room)
        assert parts[DRAG, 2] == pytest.approx(-5e3 * part)


def test_a_bottom_that_leans_is_under_a_sloping_surface_by_its_place() -> None:
    """The middle of its face lies s n off the centre of gravity: by hand for a surface of 0.1."""
    hull = spar(bottom_drag=5e3, bottom_radius=2.0)
    axes = Rotation.from_euler("xy", [0.2, 0.3]).as_matrix()
    place = -CENTRE * axes[:, 2]
    z = DEPTH - 1.0 - place[2]
    state, room = at(hull, z, axes, np.array([*axes[:, 2], 0.0, 0.0, 0.0]))
    room.sea[1:3] = [0.1, -0.05]
    parts = pushed(hull, state, room)
    # Columns stand along its own x axis, whose height evens out over the face.
    under = 1.0 + 0.1 * place[0] - 0.05 * place[1]
    assert parts[DRAG, :3] == pytest.approx(-5e3 * 0.5 * under * axes[:, 2], rel=1e-9)


def test_wind_pushes_at_its_height_on_the_axis() -> None:
    hull = spar(wind=(2e3, 9.0), wind_direction=0.7)
    state, room = at(hull, 20.0, TILTED)
    parts = pushed(hull, state, room)
    push = 2e3 * np.array([math.cos(0.7), math.sin(0.7), 0.0])
    assert parts[WIND, :3] == pytest.approx(push)
    assert parts[WIND, 3:] == pytest.approx(np.cross((9.0 - CENTRE) * TILTED[:, 2], push))


def test_damping_and_diffraction_are_put_in_as_they_are() -> None:
    hull = spar(damping=(50.0, 80.0, 900.0))
    state, room = at(hull, 20.0, np.eye(3), MOVES)
    room.sea[3:] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    parts = pushed(hull, state, room)
    factors = np.array([50.0, 50.0, 80.0, 900.0, 900.0, 0.0])
    assert parts[DAMPING] == pytest.approx(-factors * MOVES)
    assert parts[DIFFRACTION].tolist() == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    spin = state.force - parts.sum(axis=0)
    assert np.linalg.norm(spin[:3]) == 0.0


def test_a_spinning_hull_keeps_its_angular_momentum() -> None:
    """d/dt (I w) with I = A 1 + (C - A) n n' and n' = w x n leaves (C - A) (w.n) (w x n)."""
    hull = spar(spin_inertia=2e5)
    state, room = at(hull, 20.0, TILTED, MOVES)
    parts = pushed(hull, state, room)
    n, turn = TILTED[:, 2], MOVES[3:]
    expected = -(2e5 - 9e5) * (turn @ n) * np.cross(turn, n)
    assert (state.force - parts.sum(axis=0))[3:] == pytest.approx(expected, rel=1e-6)


def test_inertia_is_that_of_a_body_of_revolution_turned() -> None:
    hull = spar(spin_inertia=2e5)
    added = np.arange(36.0).reshape(6, 6)
    hull = hull._replace(added=added)
    expected = np.zeros((6, 6))
    expected[:3, :3] = 60e3 * np.eye(3)
    expected[3:, 3:] = TILTED @ np.diag([9e5, 9e5, 2e5]) @ TILTED.T
    found = [[hull_inertia(hull, TILTED, i, j) for j in range(6)] for i in range(6)]
    assert np.array(found) == pytest.approx(expected + added)


def test_without_slices_it_is_restored_from_where_it_floats() -> None:
    stiff = np.diag([1e4, 2e4, 3e5, 4e6, 5e6, 6e6])
    stiff[2, 4] = stiff[4, 2] = -2e4
    none = np.zeros(0)
    hull = spar()._replace(
        foot=none,
        top=none,
        radius=none,
        drag=none,
        restoring=stiff,
        level=np.array([1.0, 0.5, 38.0]),
    )
    axes = Rotation.from_euler("zxy", [0.1, 0.05, -0.08]).as_matrix()
    state, room = at(hull, 37.2, axes)
    parts = pushed(hull, state, room)
    way = np.array([2.0, -2.5, -0.8, 0.05, -0.08, 0.1])
    assert parts[PRESSURE] == pytest.approx(-stiff @ way - 60e3 * G * np.eye(6)[2])


@pytest.mark.parametrize("rate", [complex(-0.7, 1.9), complex(-0.02, 0.05), complex(-0.3, -1e-9)])
def test_memory_over_a_step_is_its_integral(rate: complex) -> None:
    """Of exp(rate (h - s)) v(s) with v from 0.4 to 1.3 m/s, and what there was, decayed."""
    h, before = 0.15, complex(2.0, -3.0)
    hull = spar()._replace(
        mode=np.array([[4, 0]]), rate=np.array([[rate.real, rate.imag]]), strength=np.ones((1, 2))
    )
    state, room = at(hull, 20.0, np.eye(3), 0.4 * np.eye(6)[0])
    state.memory[0] = before.real, before.imag
    carry_memory(h, hull, state, room)

    def integral(speed: Callable[[float], float]) -> complex:
        def part(of: str) -> float:
            curve = quad(lambda s: getattr(cmath.exp(rate * (h - s)) * speed(s), of), 0.0, h)
            return float(curve[0])

        return complex(part("real"), part("imag"))

    # The error of the series is of z^3 beside 1: 1e-6 below |z| = 0.01.
    carried = before * cmath.exp(rate * h) + integral(lambda s: 0.4 * (1.0 - s / h))
    assert complex(*room.carried[0]) == pytest.approx(carried, rel=1e-7)
    assert complex(*room.by_speed[0]) == pytest.approx(integral(lambda s: s / h), rel=1e-6)


def test_memory_pushes_by_the_real_part_of_its_strength() -> None:
    strengths = np.array([complex(3e3, -5e3), complex(-2e3, 1e3)])
    hull = spar()._replace(
        mode=np.array([[4, 0], [2, 2]]),
        rate=np.full((2, 2), -1.0),
        strength=np.stack([strengths.real, strengths.imag], axis=1),
    )
    state, room = at(hull, 20.0, np.eye(3), MOVES)
    room.carried[:] = [[0.2, 0.5], [-0.4, 0.1]]
    room.by_speed[:] = [[0.03, -0.01], [0.02, 0.04]]
    parts = pushed(hull, state, room)
    carried, by_speed = ([complex(*row) for row in rows] for rows in (room.carried, room.by_speed))
    memory = [c + b * v for c, b, v in zip(carried, by_speed, MOVES[[0, 2]], strict=True)]
    assert [complex(*row) for row in state.memory] == pytest.approx(memory)
    assert parts[MEMORY, 4] == pytest.approx(-(strengths[0] * memory[0]).real)
    assert parts[MEMORY, 2] == pytest.approx(-(strengths[1] * memory[1]).real)
    assert room.by_v[4, 0] == pytest.approx((strengths[0] * by_speed[0]).real)
    assert room.by_v[2, 2] == pytest.approx((strengths[1] * by_speed[1]).real)


def test_the_sea_about_it_is_the_wave_where_it_is() -> None:
    """Crest, slopes, and the wave's own force, growing over a ramp of which half is over."""
    a, period, direction, t = 1.3, 7.0, 0.6, 5.0
    wave = regular_wave(2.0 * a, period, direction=direction)
    flow = Sea(DEPTH, wave, ramp_time=10.0).flow
    hull = spar()._replace(excited=np.arange(1.0, 13.0).reshape(1, 12))
    state, room = at(hull, DEPTH - 2.5, TILTED)
    fill_sea(t, hull, state, flow, room)
    omega = 2.0 * math.pi / period
    k = omega**2 / G
    for _ in range(200):
        k = omega**2 / (G * math.tanh(k * DEPTH))
    along = np.array([math.cos(direction), math.sin(direction)])
    phase = k * float(along @ [3.0, -2.0]) - omega * t + float(wave.phase[0])
    # Half way through the ramp waves have half their size.
    assert room.sea[0] == pytest.approx(0.5 * a * math.cos(phase), rel=1e-9)
    assert room.sea[1:3] == pytest.approx(-0.5 * a * k * along * math.sin(phase), rel=1e-9)
    force = 0.5 * (np.arange(1.0, 13.0, 2.0) + 1j * np.arange(2.0, 13.0, 2.0))
    assert room.sea[3:] == pytest.approx((force * cmath.exp(1j * phase)).real, rel=1e-9)
    # Slices are met at their middles, none of them under the surface's own height.
    middles = np.array([3.0, -2.0, DEPTH - 2.5]) + np.outer([-1.5, 3.5], TILTED[:, 2])
    assert middles[1, 2] > DEPTH
    middles[:, 2] = np.minimum(middles[:, 2], DEPTH)
    assert room.points == pytest.approx(middles)


def test_between_two_steps_the_sea_is_even_between_its_ends() -> None:
    """The end is where the hull gets to at its present speed, turned by its present turn."""
    wave = regular_wave(2.0, 7.0, direction=0.6)
    flow = Sea(DEPTH, wave).flow
    hull = spar()._replace(excited=np.arange(1.0, 13.0).reshape(1, 12))
    state, room = at(hull, 20.0, TILTED, MOVES)
    fill_sea(4.0, hull, state, flow, room)
    first, slow = room.sea.copy(), room.velocity.copy()
    keep_sea(room)
    fill_sea_between(4.5, 0.3, 0.5, state, hull, flow, room)
    there, other = at(hull, 20.0, TILTED)
    there.q[:] = state.q + 0.5 * MOVES[:3]
    there.axes[:] = Rotation.from_rotvec(0.5 * MOVES[3:]).as_matrix() @ TILTED
    fill_sea(4.5, hull, there, flow, other)
    assert room.sea == pytest.approx(0.7 * first + 0.3 * other.sea)
    assert room.velocity == pytest.approx(0.7 * slow + 0.3 * other.velocity)
