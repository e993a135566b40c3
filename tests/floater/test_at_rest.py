"""A hull at rest on its lines, its small motion and its picture, by hand; on lines of four bars."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from catopt import solve
from catopt.fem.mesh import mesh_line
from catopt.fem.newmark import Scheme
from catopt.fem.run_settings import TimeStepping
from catopt.fem.solve import Leg
from catopt.floater.alone import freedoms, run_alone, unmirrored, waves_across
from catopt.floater.moored import AtRest, LinearHull, linear_hull, moored_at_rest
from catopt.floater.scene import kept_nodes, scene_of
from catopt.hydro.build import FloatingHull
from catopt.waves import PowerLawCurrent, Sea, Waves, regular_wave
from tests.floater.test_moored import DEPTH, DRY, LEG, LINE, buoy, place_of

RHO, G = 1025.0, 9.80665
AREA = math.pi * 1.2**2


def rest_of(hull: FloatingHull, sea: Sea | None = None) -> AtRest:
    return moored_at_rest(hull, LEG, [mesh_line(LINE, 4)], sea=sea or Sea(DEPTH), properties=DRY)


@pytest.mark.parametrize("direction", [0.0, -2.5])
def test_wind_is_what_the_line_pulls_wherever_it_blows(direction: float) -> None:
    """Forces and moments close; the line's ends are its closed form's to 5 % with four bars."""
    rest = rest_of(buoy(wind=(1000.0, 0.9), wind_direction=direction))
    push = 1000.0 * np.array([math.cos(direction), math.sin(direction)])
    assert rest.line[:2] == pytest.approx(-push, abs=1e-2)
    lift = RHO * G * float(rest.state.wet[0]) - 2200.0 * G
    assert rest.line[2] == pytest.approx(-lift, rel=1e-5)
    axis = rest.state.axes[:, 2]
    eye = rest.state.q - 0.8 * axis
    assert math.atan2(eye[1], eye[0]) == pytest.approx(direction, abs=1e-6)
    span = math.hypot(eye[0], eye[1])
    known = solve(LINE, height=float(eye[2]), horizontal_force=1000.0, seabed_friction=0.3)
    assert span == pytest.approx(known.span, rel=0.02)
    assert known.fairlead.vertical_force == pytest.approx(lift, rel=0.05)
    # About the centre of gravity: line at the eye, wind 0.4 m up, buoyancy that rights it.
    arm = -0.8 * axis
    moment = np.cross(arm, rest.line[:3]) + np.cross(0.4 * axis, [*push, 0.0])
    righting = rest.state.parts[0, 3:]
    assert moment + righting == pytest.approx(np.zeros(3), abs=1e-3)


def test_it_rights_as_weight_buoyancy_and_pull_have_it() -> None:
    """In heave rho g A; in pitch the metacentre's, and the line's downward pull at its eye."""
    rest = rest_of(buoy(wind=(1e-3, 0.5)))
    q, wet = float(rest.state.q[2]), float(rest.state.wet[0])
    draught = wet / AREA
    assert rest.stiffness[2, 2] == pytest.approx(RHO * G * AREA, rel=1e-6)
    middle = 0.5 * draught - 0.5
    second = 0.25 * math.pi * 1.2**4
    pull = -float(rest.line[2])
    righting = RHO * G * (second + wet * middle) + pull * 0.8
    # Over 0.03 rad to either side, to the square of it.
    assert rest.stiffness[4, 4] == pytest.approx(righting, rel=2e-3)
    assert rest.stiffness[3, 3] == pytest.approx(righting, rel=2e-3)
    assert q + middle + 0.5 * draught == pytest.approx(DEPTH, abs=1e-6)
    assert rest.by_surface[2, 0] == pytest.approx(RHO * G * AREA, rel=1e-6)
    # A surface that rises along x turns it back: bow up, against pitch.
    assert rest.by_surface[4, 1] == pytest.approx(-RHO * G * second, rel=1e-6)
    under = np.clip(draught - np.linspace(0.0, 1.35, 10), 0.0, 0.15) * AREA
    for i in range(3):
        assert rest.by_acceleration[i, :, i] == pytest.approx(RHO * under, rel=1e-5, abs=1e-6)


def test_drift_in_a_current_aside_is_along_it() -> None:
    """The line leads where the current goes, and carries its drag across the hull."""
    sea = Sea(DEPTH, None, (PowerLawCurrent(0.8, exponent=1e-9, direction=0.9),))
    rest = rest_of(buoy(), sea)
    assert math.atan2(-rest.line[1], -rest.line[0]) == pytest.approx(0.9, abs=1e-3)
    draught = float(rest.state.wet[0]) / AREA
    drag = 0.5 * RHO * 1.2 * 2.4 * draught * 0.8**2
    # It leans: by the cube of the cosine of a few degrees.
    assert math.hypot(rest.line[0], rest.line[1]) == pytest.approx(drag, rel=0.02)
    assert place_of(rest)[0] > 10.0


def test_small_motion_of_an_upright_hull_by_hand() -> None:
    """Stiffness, mass, damping, and the pressure of the wave at the hull's place and phase."""
    hull = buoy(wind=(1e-3, 0.5), damping=(50.0, 80.0, 900.0), drag=np.full(10, 300.0))
    wave = Waves(np.array([0.2]), np.array([1.1]), np.array([0.4]), np.array([math.pi]))
    sea = Sea(DEPTH, wave)
    rest = rest_of(hull, sea)
    found = linear_hull(hull, rest, sea)
    w, k = 1.1, float(sea.wave_numbers[0])
    own = rest.stiffness[np.ix_([0, 2, 4], [0, 2, 4])]
    inertia = np.diag([2200.0, 2200.0, 2200.0 * 0.49])
    expected = own - w * w * inertia - 1j * w * np.diag([50.0, 80.0, 900.0])
    assert found.matrix[0] == pytest.approx(expected, rel=1e-9, abs=1e-6)
    draught = float(rest.state.wet[0]) / AREA
    there = replace(hull, draught=draught, centre=0.5)
    pressed = there.long_wave(np.array([w]), np.array([k]), DEPTH)[0] * [-1.0, 1.0, -1.0]
    crest = 0.2 * cmath.exp(1j * (-k * float(rest.state.q[0]) + 0.4))
    assert found.push[0] == pytest.approx(pressed * crest, rel=2e-3)
    # Each slice drags with its wet length, at its place below the centre of gravity.
    wet = np.clip(draught - hull.foot, 0.0, 0.15)
    assert found.coefficient == pytest.approx(300.0 * wet, abs=1e-4)
    carries = wet > 1e-3
    middle = hull.foot + 0.5 * wet - 0.5
    assert found.way[carries, 0] == pytest.approx(np.ones(carries.sum()), abs=1e-6)
    assert found.way[carries, 2] == pytest.approx(middle[carries], abs=1e-4)
    assert found.arm[0] == pytest.approx(np.array([[1, 0, -0.8], [0, 0, 0], [0, 1, 0]]), abs=1e-4)
    assert found.stream == pytest.approx(np.zeros(10), abs=1e-12)
    # Airy's speed of a wave against x: -omega cosh k z/sinh k d at the slices' middles.
    z = np.minimum(rest.state.q[2] + 0.5 * (hull.foot + hull.top) - 0.5, DEPTH)
    speed = -w * np.cosh(k * z) / math.sinh(k * DEPTH) * crest
    assert found.flow[0] == pytest.approx(speed, rel=1e-3)


def test_a_hull_that_leans_meets_the_wave_where_its_slices_are() -> None:
    """Across its axis: u cos - w sin of Airy's water at the middle of each slice."""
    hull = buoy(wind=(2500.0, 1.2), drag=np.full(10, 300.0))
    wave = Waves(np.array([0.2]), np.array([1.9]), np.array([0.4]), np.array([0.0]))
    sea = Sea(DEPTH, wave)
    rest = rest_of(hull, sea)
    found = linear_hull(hull, rest, sea)
    (x, _, z), axis = rest.state.q, rest.state.axes[:, 2]
    assert axis[0] > 0.1
    middle = 0.5 * (hull.foot + hull.top) - 0.5
    at_x, at_z = x + middle * axis[0], np.minimum(z + middle * axis[2], DEPTH)
    w, k = 1.9, float(sea.wave_numbers[0])
    crest = 0.2 * np.exp(1j * (k * at_x + 0.4))
    u = w * np.cosh(k * at_z) / math.sinh(k * DEPTH) * crest
    up = -1j * w * np.sinh(k * at_z) / math.sinh(k * DEPTH) * crest
    assert found.flow[0] == pytest.approx(u * axis[2] - up * axis[0], rel=1e-9)


def test_the_bottom_of_a_linear_hull_drags_along_its_axis() -> None:
    hull = buoy(wind=(1e-3, 0.5), bottom_drag=700.0, bottom_radius=1.2)
    wave = Waves(np.array([0.2]), np.array([1.1]), np.array([0.4]), np.array([0.0]))
    found = linear_hull(hull, rest_of(hull, Sea(DEPTH, wave)), Sea(DEPTH, wave))
    face = slice(10, None)
    assert found.coefficient[face].sum() == pytest.approx(700.0)
    assert found.way[face, 1] == pytest.approx(np.ones(9), abs=1e-6)
    # Bow down is positive: what is ahead goes down as it pitches; R^2/4 is the mean of x^2.
    share = found.coefficient[face] / 700.0
    assert share @ found.way[face, 2] ** 2 == pytest.approx(0.36)
    assert found.way[face, 2] == pytest.approx(-found.way[face, 2][::-1])


def test_drag_is_made_linear_by_what_passes_in_the_wave() -> None:
    """Sqrt(3) s of a speed of deviation s keeps the variance of |r| r: E r^4 = 3 s^4."""
    flow, motion = np.array([[0.9 + 0.2j]]), np.array([[0.1 - 0.3j, 0.0, 0.0]])
    hull = LinearHull(
        np.array([0.8]), np.zeros((1, 3, 3), complex), np.zeros((1, 3), complex),
        np.zeros((1, 3, 3)), np.array([[1.0, 0.0, -2.0]]), np.array([70.0]), np.zeros(1), flow,
    )  # fmt: skip
    matrix, push = hull.equations(motion)
    past = flow[0, 0] + 0.8j * motion[0, 0]  # exp(-i omega t): speed is -i omega times the way
    drag = 70.0 * math.sqrt(3.0) * abs(past) / math.sqrt(2.0)
    way = np.array([1.0, 0.0, -2.0])
    assert push[0] == pytest.approx(drag * flow[0, 0] * way, rel=1e-5)
    assert matrix[0] == pytest.approx(-0.8j * drag * np.outer(way, way), rel=1e-5)


# ------------------------------------------------------------------ alone, in a few steps


def test_a_push_accelerates_it_evenly_and_is_booked() -> None:
    """X = F t^2/2 m, exactly by the mean acceleration; energy put in is F x."""
    hull = buoy(
        eyes=(), drag=None, wind=(500.0, 0.5), free=(True, False, False, False, False, False)
    )
    steps = TimeStepping(0.5, 0.05, scheme=Scheme.average_acceleration())
    history = run_alone(hull, steps, sea=Sea(DEPTH))
    assert history.time == pytest.approx(0.05 * np.arange(11))
    assert history.place[:, 0] == pytest.approx(500.0 / 4400.0 * history.time**2, rel=1e-6)
    assert history.velocity[:, 0] == pytest.approx(500.0 / 2200.0 * history.time, rel=1e-6)
    assert history.place[:, 2] == pytest.approx(np.full(11, 0.5 - 0.6))
    assert history.works.sum() == pytest.approx(0.5 * 2200.0 * history.velocity[-1, 0] ** 2)
    assert history.numerical_part < 1e-6
    assert history.extreme[0] == pytest.approx(history.place[[1, -1], 0])  # of its steps
    assert history.volume == pytest.approx(1.5 * AREA)


def test_left_alone_at_its_draught_it_stays() -> None:
    ends = np.linspace(0.0, 1.5, 11)
    draught = 2200.0 / (RHO * AREA)
    hull = FloatingHull(
        ends[:-1], ends[1:], np.full(10, 1.2), 2200.0, 1078.0, 0.5, draught, density=RHO, gravity=G
    )
    history = run_alone(hull, TimeStepping(0.2, 0.05), sea=Sea(DEPTH))
    assert history.place == pytest.approx(np.tile(history.place[0], (5, 1)), abs=1e-9)
    assert history.wet == pytest.approx(np.full(5, draught * AREA))


def test_pushed_under_it_bobs_by_its_waterplane() -> None:
    """Z = z_0 cos(omega t), omega^2 = rho g A/m, to second order: 1e-3 of z_0 in 20 steps."""
    draught = 2200.0 / (RHO * AREA)
    hull = replace(
        buoy(eyes=(), drag=None, free=(False, False, True, False, False, False)), draught=draught
    )
    history = run_alone(
        hull,
        TimeStepping(1.0, 0.05, scheme=Scheme.average_acceleration()),
        sea=Sea(DEPTH),
        offset=(0.2, -0.1, 0.0),
    )
    omega = math.sqrt(RHO * G * AREA / 2200.0)
    z = history.place[:, 2] - (0.5 - draught)
    assert z == pytest.approx(-0.1 * np.cos(omega * history.time), abs=0.02 * 0.1)
    assert history.place[:, 0] == pytest.approx(np.full(21, 0.2))
    assert history.numerical_part < 1e-3


def test_it_has_the_freedoms_that_weather_and_lines_ask_for() -> None:
    """In its plane in weather along x and on lines that x mirrors; else all but yaw, or all."""
    plane = (True, False, True, False, True, False)
    hull = buoy()
    assert freedoms(hull, (), Sea(DEPTH)) == plane
    assert freedoms(hull, (), Sea(DEPTH, regular_wave(1.0, 5.0, direction=math.pi))) == plane
    aside = Sea(DEPTH, regular_wave(1.0, 5.0, direction=0.2))
    assert waves_across(aside)
    assert freedoms(hull, (), aside) == (True, True, True, True, True, False)
    stream = PowerLawCurrent(0.5, direction=0.3)
    assert freedoms(hull, (), Sea(DEPTH, None, (stream,)))[1]
    along = PowerLawCurrent(0.5, direction=math.pi)
    assert freedoms(hull, (), Sea(DEPTH, None, (along,))) == plane
    places = [(30.0, 0.0), (-15.0, 26.0), (-15.0, -26.0)]
    legs = [Leg(LINE, (x, y, 0.0)) for x, y in places]
    hull = buoy(eyes=((0.0, 0.0, -0.3),) * 3)
    assert unmirrored(hull, legs) == ()
    assert unmirrored(hull, [*legs[:2], Leg(LINE, (-15.0, -27.0, 0.0))]) == (1, 2)
    other = replace(LINE, segments=(replace(LINE.segments[0], length=41.0),))
    assert unmirrored(hull, [*legs[:2], Leg(other, (-15.0, -26.0, 0.0))]) == (1, 2)
    # Two lines in one place are mirrored by two.
    assert unmirrored(buoy(eyes=((0.0, 0.0, -0.3),) * 2), [legs[0]] * 2) == ()


# ------------------------------------------------------------------ pictures


def test_nodes_of_a_picture_are_even_along_each_line() -> None:
    """33 of one line, 16 of each of several, counted over all; all nodes of a coarse one."""
    fine, coarse = mesh_line(LINE, 64), mesh_line(LINE, 8)
    assert kept_nodes([fine]) == (tuple(range(0, 65, 2)),)
    assert kept_nodes([coarse]) == (tuple(range(9)),)
    first, second = kept_nodes([coarse, mesh_line(LINE, 15)])
    assert first == tuple(range(9))
    assert second == tuple(range(9, 25))
    assert len(kept_nodes([fine, fine])[0]) == 16
    assert kept_nodes([fine, fine])[1][0] == 65


def pictured(free_aside: bool) -> Any:
    """Two lines of two nodes; the second has the largest tension, at 40 s of 100."""
    time = np.arange(101.0)
    tension = np.tile([5.0, 6.0], (101, 1))
    tension[40, 1], tension[2, 0] = 9.0, 20.0  # the one at 2 s is in the ramp
    nodes = np.tile(
        [[0.0, 0.0, 0.0], [3.0, 0.0, 9.0], [0.0, 0.0, 0.0], [3.0, 4.0, 9.0]], (101, 1, 1)
    )
    history = SimpleNamespace(
        time=time,
        counts=True,
        counted=time >= 10.0,
        fairlead_tension=tension,
        nodes=nodes.astype(float),
    )
    place = np.tile([3.0, 4.0, -0.2, 0.1, 0.2, 0.0], (101, 1))
    free = np.array([True, free_aside, True, free_aside, True, free_aside])
    body = SimpleNamespace(place=place, free=free)
    outline = np.array([[1.0, -0.5], [1.0, 0.7], [-1.0, 0.7], [-1.0, -0.5]])
    sea = Sea(10.0, regular_wave(0.5, 6.0))
    return scene_of(cast("Any", history), [[0, 1], [2, 3]], cast("Any", body), outline, sea)


def test_a_picture_is_of_the_half_minute_on_both_sides_of_the_largest_tension() -> None:
    scene = pictured(free_aside=False)
    assert scene.time.tolist() == [float(t) for t in range(10, 71)]
    assert (scene.loaded, scene.time[scene.worst], scene.tension[scene.worst]) == (1, 40.0, 9.0)
    assert scene.towards == 0.0
    assert scene.lines[1][0].tolist() == [[0.0, 0.0], [3.0, 9.0]]
    # Pitch alone, and what roll takes from it, is seen along x.
    lean = math.atan2(math.cos(0.1) * math.sin(0.2), math.cos(0.1) * math.cos(0.2))
    assert scene.place[0] == pytest.approx([3.0, 9.8, lean])
    # The water goes a tenth of what is drawn, 0 to 4 m, beyond it on both sides.
    assert scene.x[[0, -1]] == pytest.approx([-0.4, 4.4])
    assert scene.surface.shape == (61, scene.x.size)
    k = float(Sea(10.0, regular_wave(0.5, 6.0)).wave_numbers[0])
    height = 10.0 + 0.25 * np.cos(k * scene.x - 2.0 * math.pi / 6.0 * 40.0)
    assert scene.surface[scene.worst] == pytest.approx(height)


def test_a_picture_aside_is_on_the_plane_of_the_loaded_line() -> None:
    """Through an anchor at the origin and an end at 3, 4: 5 m out, leaning by both angles."""
    scene = pictured(free_aside=True)
    assert scene.towards == pytest.approx(math.atan2(4.0, 3.0))
    assert scene.lines[1][0] == pytest.approx(np.array([[0.0, 0.0], [5.0, 9.0]]))
    assert scene.lines[0][0] == pytest.approx(np.array([[0.0, 0.0], [1.8, 9.0]]))
    assert scene.place[0, :2] == pytest.approx([5.0, 9.8])
    axis = np.array([math.cos(0.1) * math.sin(0.2), -math.sin(0.1), math.cos(0.1) * math.cos(0.2)])
    assert math.tan(scene.place[0, 2]) == pytest.approx((0.6 * axis[0] + 0.8 * axis[1]) / axis[2])


def test_the_outline_of_a_hull_that_leans() -> None:
    """Its corner at 1, -0.5 about its centre: turned by the pitch, towards x where it is above."""
    scene = pictured(free_aside=False)
    x, z, pitch = scene.place[5]
    corner = (complex(1.0, -0.5) * cmath.exp(-1j * pitch)) + complex(x, z)
    assert scene.hull(5)[0] == pytest.approx([corner.real, corner.imag])
