"""A buoy on its line, as one system: at rest by hand, in motion as the parts say."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from catopt.catenary.solve import solve
from catopt.fem.dynamic_model import Fluid, LineProperties
from catopt.fem.mesh import mesh_line
from catopt.fem.morison import MorisonSection
from catopt.fem.run_settings import TimeStepping
from catopt.fem.seabed import Seabed
from catopt.fem.solve import Leg
from catopt.floater.moored import AtRest, moored_at_rest, run_moored
from catopt.hydro.build import FloatingHull, Radiation
from catopt.hydro.cylinder import FloatingCylinder
from catopt.model import Line, Segment
from catopt.waves import PowerLawCurrent, Sea, regular_wave

DEPTH = 12.0
LINE = Line((Segment(length=40.0, submerged_weight=170.0, EA=5e7, mass=18.0, MBL=5e5),))
LEG = (Leg(LINE, (0.0, 0.0, 0.0)),)
DRY = LineProperties(
    sections=[MorisonSection(diameter=0.05, drag_normal=0.0, drag_tangential=0.0)],
    fluid=Fluid(),
    seabed=Seabed(friction=0.3),
)


def buoy(**of: object) -> FloatingHull:
    """Make a drum of 2.4 m, its eye below its bottom."""
    mass, draught, centre = 2200.0, 0.6, 0.5
    ends = np.linspace(0.0, 1.5, 11)
    given = {"drag": np.full(10, 0.5 * 1025.0 * 1.2 * 2.4), "eyes": ((0.0, 0.0, -0.3),), **of}
    return FloatingHull(
        ends[:-1],
        ends[1:],
        np.full(10, 1.2),
        mass,
        mass * 0.7**2,
        centre,
        draught,
        **given,  # type: ignore[arg-type]
    )


def place_of(rest: AtRest) -> tuple[float, float, float]:
    """Where it is along x and above the bed, m, and its pitch, rad."""
    x, _, z = rest.state.q.tolist()
    return x, z, math.atan2(rest.state.axes[0, 2], rest.state.axes[2, 2])


def test_rest_in_the_current_balances_by_the_closed_form() -> None:
    """Drag on the hull is what the line pulls, and the line's weight is what it displaces more.

    The drag across a hull that leans pushes it down, too. The truss model's line is the closed
    form's to the square of its bars: some 1e-3 with 24.
    """
    sea = Sea(DEPTH, None, (PowerLawCurrent(1.2, exponent=1e-9),))
    hull = buoy()
    rest = moored_at_rest(hull, LEG, [mesh_line(LINE, 24)], sea=sea, properties=DRY)
    x, z, turn = place_of(rest)
    wet = float(rest.state.wet[0])
    pull, lift, moment = rest.line[[0, 2, 4]]
    assert 1025.0 * 9.80665 * wet - 2200.0 * 9.80665 == pytest.approx(
        -lift - pull * math.tan(turn), rel=1e-6
    )
    # Across the hull by its wet length, along the axis nothing: bottom drag is 0 here.
    across = wet / (math.pi * 1.2**2)
    drag = 0.5 * 1025.0 * 1.2 * 2.4 * across * (1.2 * math.cos(turn)) ** 2 * math.cos(turn)
    assert -pull == pytest.approx(drag, rel=2e-3)
    eye = np.array([x - 0.8 * math.sin(turn), z - 0.8 * math.cos(turn)])
    closed = solve(LINE, height=float(eye[1]), span=float(eye[0]), seabed_friction=0.3)
    assert closed.horizontal_force == pytest.approx(-pull, rel=1e-2)
    assert closed.fairlead.vertical_force == pytest.approx(-lift, rel=5e-3)
    arm = eye - [x, z]
    assert moment == pytest.approx(arm[1] * pull - arm[0] * lift, rel=1e-9)


def test_a_constant_force_moves_it_as_the_statics_say() -> None:
    """1 kN more on the hull: the horizontal force of the line at its new place is 1 kN more."""
    sea = Sea(DEPTH, None)
    mesh = mesh_line(LINE, 20)
    spans = []
    for force in (1000.0, 2000.0):
        hull = buoy(wind=(force, 0.5))
        rest = moored_at_rest(hull, LEG, [mesh], sea=sea, properties=DRY)
        assert rest.line[0] == pytest.approx(-force, rel=1e-6)
        x, z, turn = place_of(rest)
        span, height = x - 0.8 * math.sin(turn), z - 0.8 * math.cos(turn)
        closed = solve(LINE, height=height, horizontal_force=force, seabed_friction=0.3)
        assert span == pytest.approx(closed.span, abs=0.03)
        spans.append(span)
    assert spans[1] > spans[0] + 0.1


def test_in_still_water_it_stays_where_it_is() -> None:
    hull = buoy(wind=(1500.0, 1.0))
    stepping = TimeStepping(1.0, 0.05)
    history, moved = run_moored(
        hull, LEG, [mesh_line(LINE, 12)], stepping, sea=Sea(DEPTH, None), properties=DRY
    )
    tension = history.fairlead_tension[:, 0]
    assert tension == pytest.approx(tension[0], rel=1e-4)
    assert np.abs(moved.place - moved.place[0]).max() < 1e-5


def test_it_rides_long_waves_and_books_their_energy() -> None:
    """A wave of 12 s and 0.2 m lifts the buoy with the surface; the steps lose less than 1e-3.

    The line's own stiffness in heave is a per cent of the waterplane's. Its eye goes as the rigid
    arm says, and the force on it is what the hull felt.
    """
    cylinder = FloatingCylinder(1.2, 0.6, DEPTH, 0.5 - 0.6)
    hull = buoy(wind=(1500.0, 1.0), radiation=Radiation.of_cylinder(cylinder))
    sea = Sea(DEPTH, regular_wave(0.2, 12.0))
    stepping = TimeStepping(18.0, 0.1, ramp_time=6.0)
    history, moved = run_moored(hull, LEG, [mesh_line(LINE, 8)], stepping, sea=sea, properties=DRY)
    late = history.time > 6.0
    rise = moved.place[late, 2] - moved.place[0, 2]
    assert rise == pytest.approx(moved.surface[late], abs=0.01)
    arm = np.stack([-0.8 * np.sin(moved.place[:, 4]), -0.8 * np.cos(moved.place[:, 4])], axis=1)
    eye = moved.place[:, [0, 2]] + [0.0, DEPTH] + arm
    assert history.fairlead[:, 0, [0, 2]] == pytest.approx(eye, abs=1e-9)
    # The hull's is balanced within the step, the line's taken at its end.
    pull = history.fairlead_force[late, 0, 0]
    assert moved.lines[late, 0] == pytest.approx(pull, abs=0.02 * np.abs(pull).max())
    assert moved.numerical_part < 1e-3
    assert history.balance.numerical_part < 1e-3


def test_two_lines_in_one_place_are_one_of_twice_the_weight() -> None:
    """Each of half of everything: at rest and in motion the same, to what a step leaves over."""
    half = Line((Segment(length=40.0, submerged_weight=85.0, EA=2.5e7, mass=9.0),))
    own, sea = Leg(half, (-34.0, 0.0, 0.0)), Sea(DEPTH, regular_wave(0.5, 4.0))
    here = Sea(DEPTH, regular_wave(0.5, 4.0, phase=-34.0 * float(sea.wave_numbers[0])))
    stepping = TimeStepping(8.0, 0.04, ramp_time=4.0)
    smooth = replace(DRY, seabed=Seabed(2e4, 2e3, friction=0.0))
    section = MorisonSection(0.05 / math.sqrt(2.0), drag_normal=0.0, drag_tangential=0.0)
    thin = replace(smooth, sections=[section])
    soft = replace(thin, seabed=Seabed(1e4, 1e3, friction=0.0))
    wind, mesh = {"wind": (1500.0, 1.0)}, mesh_line(LINE, 8)
    _, one = run_moored(buoy(**wind), LEG, [mesh], stepping, sea=here, properties=smooth)
    hull = buoy(**wind, eyes=((0.0, 0.0, -0.3), (0.0, 0.0, -0.3)))
    (_, two) = run_moored(
        hull, [own, own], [mesh_line(half, 8)] * 2, stepping, sea=sea, properties=soft
    )
    assert np.ptp(two.place[:, 2]) > 0.3
    way = two.place - two.place[0]
    assert way == pytest.approx(one.place - one.place[0], abs=1e-4)


def test_lines_around_it_hold_it_where_it_is() -> None:
    """Without weather in the middle of three; what they push across cancels, and all pull down."""
    at = (0.0, 2.0 * math.pi / 3.0, -2.0 * math.pi / 3.0)
    legs = [Leg(LINE, (30.0 * math.cos(a), 30.0 * math.sin(a), 0.0)) for a in at]
    hull = buoy(eyes=tuple((0.8 * math.cos(a), 0.8 * math.sin(a), -0.3) for a in at))
    meshes = [mesh_line(LINE, 96)] * 3
    rest = moored_at_rest(hull, legs, meshes, sea=Sea(DEPTH, None), properties=DRY)
    x, z, turn = place_of(rest)
    assert (x, turn) == pytest.approx((0.0, 0.0), abs=5e-3)  # as little as holds it there
    closed = solve(LINE, height=z - 0.5 - 0.3, span=30.0 - 0.8)
    assert rest.line[2] == pytest.approx(-3.0 * closed.fairlead.vertical_force, rel=1e-2)
    lift = 1025.0 * 9.80665 * float(rest.state.wet[0]) - 2200.0 * 9.80665
    assert lift == pytest.approx(-rest.line[2], rel=1e-6)
