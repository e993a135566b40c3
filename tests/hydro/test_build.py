"""What a hull is laid out from: geometry by hand, waves by the kernels, symmetry all round."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest

from catopt.errors import InputError
from catopt.hydro.build import FloatingHull, HullOfCoefficients, Radiation, room_of, state_of
from catopt.hydro.coefficients import Coefficients, Memory
from catopt.hydro.cylinder import FloatingCylinder
from catopt.hydro.hull import DIFFRACTION, PRESSURE, fill_forces_on_hull, fill_sea
from catopt.waves import Sea, Waves

Array = npt.NDArray[np.float64]
DEPTH, RHO, G = 40.0, 1025.0, 9.80665
FOOT, TOP, RADIUS = np.array([0.0, 4.0, 8.0]), np.array([4.0, 8.0, 10.0]), np.array([2.0, 1.5, 1.0])
CENTRE, DRAUGHT = 3.5, 6.0
VOLUME = math.pi * (4.0 * 4.0 + 2.25 * 2.0)
ALL = (True,) * 6


def spar(**own: object) -> FloatingHull:
    """Three cylinders, one on the other, afloat to the middle of the second."""
    given = {"density": RHO, "gravity": G, **own}
    return FloatingHull(FOOT, TOP, RADIUS, RHO * VOLUME, 9e5, CENTRE, DRAUGHT, **given)  # type: ignore[arg-type]


def waves(*rows: tuple[float, float, float, float]) -> Waves:
    """Of amplitude, frequency, phase and direction each."""
    return Waves(*(np.array(column) for column in zip(*rows, strict=True)))


def test_measures_by_hand() -> None:
    hull = spar()
    assert hull.volume == pytest.approx(VOLUME)
    assert hull.volume_of_all == pytest.approx(math.pi * (4.0 * 4.0 + 2.25 * 4.0 + 2.0))
    assert hull.waterplane == pytest.approx((math.pi * 2.25, 0.25 * math.pi * 1.5**4))
    assert (hull.level, hull.above, hull.size) == (CENTRE - DRAUGHT, 6.5, 6.0)
    assert replace(hull, draught=3.0).size == 4.0
    outline = hull.outline
    assert outline[:2].tolist() == [[2.0, -3.5], [2.0, 0.5]]
    assert outline[-1].tolist() == [-2.0, -3.5]
    assert outline.shape == (12, 2)
    assert outline[:, 1].tolist() == outline[::-1, 1].tolist()


@pytest.mark.parametrize("draught", [4.0, 8.0])
def test_a_waterplane_between_two_slices_is_that_of_the_lower(draught: float) -> None:
    radius = 2.0 if draught == 4.0 else 1.5
    assert replace(spar(), draught=draught).waterplane[0] == pytest.approx(math.pi * radius**2)


def test_stiffness_is_the_waterplane_and_the_lever_of_buoyancy() -> None:
    """Rho g A in heave; rho g (I + V (z_B - z_G)) in pitch, z_B by hand."""
    stiff = spar().stiffness
    moment = math.pi * (16.0 * (2.0 - CENTRE) + 4.5 * (5.0 - CENTRE))
    expected = np.zeros((3, 3))
    expected[1, 1] = RHO * G * math.pi * 2.25
    expected[2, 2] = RHO * G * (0.25 * math.pi * 1.5**4 + moment)
    assert stiff == pytest.approx(expected)


def number(omega: float) -> float:
    k = omega**2 / G
    for _ in range(300):
        k = omega**2 / (G * math.tanh(k * DEPTH))
    return k


def test_water_accelerates_as_airy_has_it() -> None:
    """-i omega times the speeds omega cosh/sinh and -i omega sinh/sinh of a crest of 1 m."""
    omega, z = 0.9, np.array([-1.0, -12.0, -39.0])
    k = number(omega)
    own, below = np.array([omega]), math.sinh(k * DEPTH)
    along = FloatingHull.water_acceleration(own, np.array([k]), DEPTH, z)[0]
    rise = FloatingHull.water_acceleration(own, np.array([k]), DEPTH, z, upwards=True)[0]
    assert along == pytest.approx(-1j * omega**2 * np.cosh(k * (z + DEPTH)) / below)
    assert rise == pytest.approx(-(omega**2) * np.sinh(k * (z + DEPTH)) / below)


def amplitude(hull: FloatingHull, omega: float, direction: float, row: int) -> npt.NDArray:  # type: ignore[type-arg]
    """Force by the kernels on it at rest over the amplitude of a wave of 1 mm, complex (6,)."""
    found = []
    for phase in (0.0, -0.5 * math.pi):  # real and imaginary part at t = 0 over the origin
        flow = Sea(DEPTH, waves((1e-3, omega, phase, direction))).flow
        laid = hull.lay_out(flow)
        place = (0.0, 0.0, DEPTH + hull.level)
        state, room, forces = state_of(laid, place), room_of(laid), []
        for sign in (1.0, 0.0):
            fill_sea(0.0, laid, state, flow, room)
            np.multiply(room.sea, sign, out=room.sea)
            np.multiply(room.acceleration, sign, out=room.acceleration)
            fill_forces_on_hull(laid, state, DEPTH, room)
            forces.append(state.parts[row].copy())
        found.append((forces[0] - forces[1]) / 1e-3)
    return np.asarray(found[0] + 1j * found[1])


def test_a_long_wave_pushes_as_the_kernels_have_it() -> None:
    omega = 0.8
    k = np.array([number(omega)])
    found = spar().long_wave(np.array([omega]), k, DEPTH)[0]
    expected = amplitude(spar(), omega, 0.0, PRESSURE)[[0, 2, 4]]
    assert found == pytest.approx(expected, rel=1e-3)


def test_at_a_frequency_of_its_table_the_whole_force_is_the_tables() -> None:
    """Pressure of the slices and what is added, turned into the wave's direction."""
    omega = np.array([0.6, 0.8, 1.0, 1.3])
    table = np.outer(1.0 + omega, [2e5 - 1e5j, 3e5 + 2e5j, -4e5 + 7e5j])
    zero = np.zeros((4, 3, 3))
    radiation = Radiation(omega, zero, zero, np.zeros((3, 3)), table, 1.0)
    hull, turn = spar(radiation=radiation), 0.7
    whole = amplitude(hull, 0.8, turn, PRESSURE) + amplitude(hull, 0.8, turn, DIFFRACTION)
    push, heave, pitch = table[1]
    c, s = math.cos(turn), math.sin(turn)
    expected = np.array([c * push, s * push, heave, -s * pitch, c * pitch, 0.0])
    assert whole == pytest.approx(expected, rel=1e-3, abs=1e-3 * abs(pitch))
    # Beyond the table: nothing is left of short waves; of long ones a part that falls with w^2.
    short = amplitude(hull, 1.6, 0.0, PRESSURE) + amplitude(hull, 1.6, 0.0, DIFFRACTION)
    assert np.abs(short).max() < 2e-3 * abs(pitch)
    k = np.array([number(0.6)])
    beyond = table[0] - hull.long_wave(np.array([0.6]), k, DEPTH)[0]
    long = amplitude(hull, 0.3, 0.0, DIFFRACTION)[[0, 2, 4]]
    assert long == pytest.approx(0.25 * beyond, rel=1e-6)


def test_several_waves_are_excited_each_by_its_own() -> None:
    omega = np.array([0.6, 0.8, 1.0, 1.3])
    zero = np.zeros((4, 3, 3))
    table = np.outer(omega, [2e5 - 1e5j, 3e5 + 2e5j, -4e5 + 7e5j])
    hull = spar(radiation=Radiation(omega, zero, zero, np.zeros((3, 3)), table, 1.0))
    both = waves((0.5, 0.6, 0.2, 0.0), (2.0, 1.3, 0.1, 0.0))
    excited = hull.lay_out(Sea(DEPTH, both).flow).excited
    for row, a, w, n in zip(excited, (0.5, 2.0), (0.6, 1.3), (0, 3), strict=True):
        k = np.array([number(w)])
        beyond = a * (table[n] - hull.long_wave(np.array([w]), k, DEPTH)[0])
        assert row[[0, 4, 8]] + 1j * row[[1, 5, 9]] == pytest.approx(beyond, rel=1e-6)
    assert spar().lay_out(Sea(DEPTH, both).flow).excited.any() == False  # noqa: E712 - an array's


def test_arrays_for_the_kernels_by_hand() -> None:
    hull = spar(
        drag=np.array([1.0, 2.0, 3.0]),
        bottom_drag=7.0,
        bottom_radius=1.9,
        wind=(2e3, 9.0),
        wind_direction=0.7,
        damping=(50.0, 80.0, 900.0),
        constant=(1.0, 2.0, 3.0),
        eyes=((0.5, -0.2, 1.0), (0.0, 0.0, 0.0)),
    )
    laid = hull.lay_out(Sea(DEPTH).flow, (True, True, True, False, True, True))
    assert laid.foot.tolist() == [-3.5, 0.5, 4.5]
    assert laid.top.tolist() == [0.5, 4.5, 6.5]
    assert (laid.mass, laid.inertia) == pytest.approx((RHO * VOLUME, 9e5))
    assert (laid.bottom, laid.bottom_drag, laid.bottom_radius) == (-3.5, 7.0, 1.9)
    assert laid.wind == pytest.approx([2e3 * math.cos(0.7), 2e3 * math.sin(0.7), 5.5])
    assert laid.damping.tolist() == [50.0, 50.0, 80.0, 900.0, 900.0, 0.0]
    assert laid.constant.tolist() == [1.0, 0.0, 2.0, 0.0, 3.0, 0.0]
    assert laid.eye.tolist() == [[0.5, -0.2, -2.5], [0.0, 0.0, -3.5]]
    assert laid.free.tolist() == [1.0, 1.0, 1.0, 0.0, 1.0, 1.0]
    # A cylinder of even mass: m R^2/2 of each, by its volume.
    squares, volumes = np.array([4.0, 2.25, 1.0]), np.array([16.0, 9.0, 2.0])
    spin = 0.5 * RHO * VOLUME * float(squares @ volumes) / 27.0
    assert laid.spin_inertia == pytest.approx(spin)
    assert spar(spin_inertia=5.0).lay_out(Sea(DEPTH).flow).spin_inertia == 5.0
    assert not laid.restoring.any()
    assert not laid.level.any()
    assert spar().lay_out(Sea(DEPTH).flow).drag.tolist() == [0.0, 0.0, 0.0]
    # Columns of a disc: shares of one, its second moment R^2/4 and sixth 5 R^6/64, symmetric.
    place, share = laid.column.T
    assert share.sum() == pytest.approx(1.0)
    assert share @ place**2 == pytest.approx(0.25)
    assert share @ place**6 == pytest.approx(5.0 / 64.0)
    assert place == pytest.approx(-place[::-1])


def turned_about_z(angle: float) -> Array:
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return np.kron(np.eye(2), turn)


def test_what_a_body_of_revolution_has_is_the_same_all_round() -> None:
    """Matrices in surge, heave and pitch over all freedoms: a turn about z changes nothing."""
    given = np.array([[3.0, 0.0, -1.5], [0.0, 4.0, 0.0], [-1.5, 0.0, 9.0]])
    zero, omega = np.zeros((4, 3, 3)), np.linspace(1.0, 4.0, 4)
    hull = spar(radiation=Radiation(omega, zero, zero, given, None, 1.0))
    laid = hull.lay_out(Sea(DEPTH).flow)
    plane, turn = np.ix_([0, 2, 4], [0, 2, 4]), turned_about_z(0.8)
    for found, expected in ((laid.added, given), (laid.stiffness, hull.stiffness)):
        assert found[plane] == pytest.approx(expected)
        assert turn @ found @ turn.T == pytest.approx(found, rel=1e-12, abs=1e-9)
        assert found[5].tolist() == [0.0] * 6


def test_its_memory_is_the_same_all_round() -> None:
    """K(t) out of the modes for all freedoms, and without those that are not free."""
    cylinder = FloatingCylinder(1.5, 6.0, DEPTH, CENTRE - DRAUGHT)
    hull = spar(radiation=Radiation.of_cylinder(cylinder))
    memory, t = hull.radiation.memory, np.array([0.7])

    def kernel(free: tuple[bool, ...]) -> Array:
        laid, out = hull.lay_out(Sea(DEPTH).flow, free), np.zeros((6, 6))
        for (row, column), rate, strength in zip(laid.mode, laid.rate, laid.strength, strict=True):
            out[row, column] += (complex(*strength) * cmath.exp(complex(*rate) * 0.7)).real
        return out

    found, turn = kernel(ALL), turned_about_z(0.8)
    for i in range(3):
        for j in range(3):
            assert found[2 * i, 2 * j] == pytest.approx(memory.kernel(t, i, j)[0])
    assert found[0, 4] != 0.0
    assert turn @ found @ turn.T == pytest.approx(found, abs=1e-9)
    held = kernel((True, False, True, True, True, False))
    assert not held[1].any()
    assert not held[:, 1].any()
    assert held[[0, 2, 3, 4], :][:, [0, 2, 3, 4]] == pytest.approx(
        found[[0, 2, 3, 4], :][:, [0, 2, 3, 4]]
    )


def test_radiation_of_a_cylinder_is_taken_where_it_makes_waves() -> None:
    """From 0.05 to 3.6 sqrt(g/a): no short waves are made; long ones by what they lift.

    Energy: B = k X^2/(4 rho g c_g) with X = rho g A as k goes to 0, and c_g = sqrt(g d).
    """
    cylinder = FloatingCylinder(2.0, 3.0, DEPTH, -1.0, RHO, G)
    found = Radiation.of_cylinder(cylinder)
    scale = math.sqrt(G / 2.0)
    assert found.omega[[0, -1]] == pytest.approx([0.05 * scale, 3.6 * scale])
    assert found.omega.size == 60
    assert (np.diff(found.omega, 2) > 0.0).all()  # closest where the waves are long
    heave = found.damping[:, 1, 1]
    assert heave[-1] < 1e-12 * heave.max()
    celerity = math.sqrt(G * DEPTH)
    long = 0.05 * scale / celerity * (RHO * G * math.pi * 4.0) ** 2 / (4.0 * RHO * G * celerity)
    assert heave[0] == pytest.approx(long, rel=0.1)
    assert found.longest == pytest.approx(40.0 / scale)
    none = Radiation.none()
    assert none.memory.rate.size == 0
    assert none.infinite.shape == (3, 3)


def test_it_keeps_to_its_plane_unless_something_pushes_across() -> None:
    """Only a line off its axis turns it about that."""
    in_plane = (True, False, True, False, True, False)
    five = (True, True, True, True, True, False)
    assert spar().freedoms(in_plane=True) == in_plane
    assert spar().freedoms(in_plane=False) == five
    along, across = spar(wind=(1e3, 9.0)), spar(wind=(1e3, 9.0), wind_direction=0.1)
    assert along.freedoms(in_plane=True) == in_plane
    assert across.freedoms(in_plane=True) == five
    assert spar(wind_direction=0.1).freedoms(in_plane=True) == in_plane  # no wind at all
    assert spar(eyes=((0.3, 0.0, 1.0),)).freedoms(in_plane=False) == ALL


def test_every_error_of_a_hull_at_once() -> None:
    with pytest.raises(InputError) as found:
        FloatingHull(FOOT, FOOT, RADIUS, 0.0, -1.0, 0.0, 0.0, free=(True,) * 5)
    assert [each.key for each in found.value.problems] == [
        "mass", "inertia", "draught", "free", "slices",
    ]  # fmt: skip
    with pytest.raises(InputError, match="slices"):
        FloatingHull(FOOT, TOP, RADIUS[:2], 1.0, 0.0, 0.0, 1.0)
    assert FloatingHull(FOOT, TOP, RADIUS, 1.0, 0.0, 0.0, 1.0).mass == 1.0


def test_a_body_of_files_is_laid_out_from_its_matrices() -> None:
    """Weight is balanced by its displacement; the kernels add what a body of revolution has."""
    omega, heading = np.array([0.5, 1.0]), np.array([0.0, 1.0])
    excitation = (np.arange(24.0) * (1.0 + 2.0j)).astype(np.complex128).reshape(2, 2, 6)
    mass = np.diag([8e4, 8e4, 8e4, 2e6, 3e6, 4e6])
    mass[0, 4] = mass[4, 0] = -5e4
    infinite = 0.5 * mass
    memory = Memory(
        np.array([2, 4]), np.array([2, 0]), np.array([-1 + 2j, -3 + 4j]), np.array([5 + 6j, 7 - 8j])
    )
    hull = HullOfCoefficients(
        Coefficients(omega, heading, excitation=excitation),
        mass,
        np.diag([0.0, 0.0, 3.0, 4.0, 5.0, 0.0]),
        memory,
        infinite,
        9e4,
        force=(11.0, 12.0),
        damping=(1.0, 2.0, 3.0, 4.0, 5.0, 6.0),
        eyes=((1.0, 2.0, 3.0),),
        density=RHO,
        gravity=G,
    )
    laid = hull.lay_out(Sea(DEPTH, waves((2.0, 1.0, 0.3, 1.0))).flow, (True, False) * 3)
    assert (laid.mass, laid.inertia, laid.spin_inertia) == (8e4, 3e6, 3e6)
    own = np.zeros((6, 6))
    own[3, 3], own[5, 5], own[0, 4], own[4, 0] = -1e6, 1e6, -5e4, -5e4
    assert laid.added == pytest.approx(infinite + own)
    assert laid.constant == pytest.approx([11.0, 12.0, 9e4 * G, 0.0, 0.0, 0.0])
    assert laid.level.tolist() == [0.0, 0.0, DEPTH]
    assert laid.mode.tolist() == [[2, 2], [4, 0]]
    assert laid.rate.tolist() == [[-1.0, 2.0], [-3.0, 4.0]]
    assert laid.strength.tolist() == [[5.0, 6.0], [7.0, -8.0]]
    assert laid.free.tolist() == [1.0, 0.0] * 3
    assert laid.eye.tolist() == [[1.0, 2.0, 3.0]]
    # Of a wave of 2 m towards 1 rad: twice the table's last row.
    assert laid.excited[0, ::2] == pytest.approx(2.0 * np.arange(18.0, 24.0))
    assert laid.excited[0, 1::2] == pytest.approx(4.0 * np.arange(18.0, 24.0))
    assert hull.lay_out(Sea(DEPTH).flow).excited.shape == (0, 12)
    assert hull.size == pytest.approx((9e4 / RHO) ** (1.0 / 3.0))
    assert (hull.above, hull.level, hull.volume_of_all) == (hull.size, 0.0, 0.0)
    assert hull.freedoms(in_plane=True) == ALL
    for array in (laid.foot, laid.top, laid.radius, laid.drag, laid.column):
        assert array.size == 0
    assert (laid.bottom, laid.bottom_drag, laid.bottom_radius) == (0.0, 0.0, 0.0)
    assert not laid.wind.any()
