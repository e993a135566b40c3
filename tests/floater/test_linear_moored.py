"""A buoy on its line by linear motion, beside the run in time of the same system."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from catopt.casefile import parse_case
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.linear_model import linear_model
from catopt.fem.linear_motion import LinearMotion, linear_motion
from catopt.fem.mesh import mesh_line
from catopt.fem.morison import MorisonSection
from catopt.fem.run_settings import TimeStepping
from catopt.fem.solve import Leg
from catopt.floater.moored import linear_hull, moored_at_rest, run_moored
from catopt.hydro.build import FloatingHull, Radiation
from catopt.hydro.cylinder import FloatingCylinder
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.linear import linear_lines
from catopt.waves import PowerLawCurrent, Sea, Waves
from tests.floater.test_moored import DEPTH, DRY, LEG, LINE, buoy

RADIATION = Radiation.of_cylinder(FloatingCylinder(1.2, 0.6, DEPTH, -0.1, 1025.0, 9.80665))
NO_DRAG = np.zeros(10)
WET = replace(
    DRY,
    sections=[MorisonSection(0.05, drag_normal=1.2, drag_tangential=0.1, added_mass_normal=1.0)],
    seabed=replace(DRY.seabed, friction=0.0),  # type: ignore[type-var]
)
BARE = replace(WET, sections=[MorisonSection(0.05, 0.0, 0.0, added_mass_normal=1.0)])


def in_wave(amplitude: float, omega: float, *, current: float = 0.0) -> Sea:
    """One wave against x, which the line pulls the buoy along."""
    wave = (np.array([each]) for each in (amplitude, omega, 0.4, math.pi))
    flows = (PowerLawCurrent(current, exponent=1e-9),) if current else ()
    return Sea(DEPTH, Waves(*wave), flows)


def linear(
    hull: FloatingHull, properties: LineProperties, sea: Sea, legs: Sequence[Leg] = LEG
) -> LinearMotion:
    meshes = [mesh_line(leg.line, 20) for leg in legs]
    rest = moored_at_rest(hull, legs, meshes, sea=sea, properties=properties)
    prescribed_motion, body = np.zeros((len(legs), 1, 3), complex), linear_hull(hull, rest, sea)
    return linear_motion(linear_model(rest.simulation), sea, prescribed_motion, body)


def in_time(
    hull: FloatingHull,
    properties: LineProperties,
    sea: Sea,
    omega: float,
    legs: Sequence[Leg] = LEG,
) -> list[complex]:
    """Surge, heave, pitch, tension at anchor and eye of each line in the last 10 of 40 periods."""
    period = 2.0 * math.pi / omega
    stepping = TimeStepping(40.0 * period, period / 100.0, ramp_time=10.0 * period)
    meshes = [mesh_line(leg.line, 20) for leg in legs]
    history, way = run_moored(hull, legs, meshes, stepping, sea=sea, properties=properties)

    def amplitude(series: np.ndarray) -> complex:
        late = history.time >= 30.0 * period
        time = history.time[late]
        parts = np.stack([np.cos(omega * time), np.sin(omega * time), np.ones_like(time)], axis=1)
        cosine, sine, _ = np.linalg.lstsq(parts, series[late], rcond=None)[0]
        return complex(cosine, sine)

    places = [amplitude(way.place[:, k]) for k in (0, 2, 4)]
    tensions = history.bar_tension
    return places + [amplitude(tensions[:, k, end]) for k in range(len(legs)) for end in range(2)]


def test_without_drag_it_goes_with_the_wave() -> None:
    hull = buoy(drag=NO_DRAG, wind=(400.0, 0.5), radiation=RADIATION)
    small, large = (linear(hull, BARE, in_wave(each, 1.0)) for each in (0.01, 0.5))
    assert np.allclose(large.motion, 50.0 * small.motion, rtol=1e-6)
    assert np.allclose(large.tension, 50.0 * small.tension, rtol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("omega", "current", "radiates"),
    [(0.6, 0.0, True), (1.6, 0.0, True), (1.0, 0.0, False), (0.6, 1.0, True), (1.6, 1.0, True)],
)
def test_small_waves_move_it_as_in_time(omega: float, current: float, radiates: bool) -> None:
    """Amplitude and phase of its motion and of the tension at both ends to 0.5 %.

    The step is a hundredth of the period. Steady drag goes with what the wave wets, with the bars'
    directions, and acts where each slice is wet: without the three surge was off by a third, pitch
    by a quarter and the anchor's tension by 3.5 % in a current of 1 m/s.
    """
    of: dict[str, object] = {"radiation": RADIATION} if radiates else {}
    if not current:
        of |= {"drag": NO_DRAG, "wind": (400.0, 0.5)}
    hull, sea = buoy(**of), in_wave(0.01, omega, current=current)
    properties = WET if current else BARE
    found = linear(hull, properties, sea)
    ours = [*found.motion[0], *found.tension[0, [0, -1]]]
    for own, theirs in zip(ours, in_time(hull, properties, sea, omega), strict=True):
        assert abs(own - theirs) < 0.005 * abs(theirs)


AROUND = tuple(
    Leg(LINE, (30.0 * math.cos(at), 30.0 * math.sin(at), 0.0)) for at in (0.0, 2.0, -2.0)
)


@pytest.mark.slow
@pytest.mark.parametrize(("omega", "current"), [(0.8, 0.7), (1.3, 0.3)])
def test_on_three_lines_as_in_time(omega: float, current: float) -> None:
    """As on one, to 1.5 %; the line to leeward lies slack at its anchor, which adds nothing."""
    arms = tuple((0.8 * math.cos(at), 0.8 * math.sin(at), -0.3) for at in (0.0, 2.0, -2.0))
    hull, sea = buoy(radiation=RADIATION, eyes=arms), in_wave(0.01, omega, current=current)
    found = linear(hull, WET, sea, AROUND)
    ends = np.stack([found.start[:-1], found.start[1:] - 1], axis=1).ravel()
    ours = [*found.motion[0], *found.tension[0, ends]]
    theirs = in_time(hull, WET, sea, omega, AROUND)
    assert theirs[3] == 0.0
    assert abs(theirs[7]) > 1.0
    for own, other in zip(ours, theirs, strict=True):
        assert abs(own - other) <= 0.015 * abs(other)
    assert found.tension[0, 20:40] == pytest.approx(found.tension[0, 40:], rel=1e-4)


CASE = """
[site]
water_depth = "12 m"
[line]
fairlead_height = "9.4 m"
[[line.segments]]
component = "chain open-link 4D Q2"
diameter = "38 mm"
length = "30 m"
EA = "119 MN"
[load]
horizontal_force = "8.6 kN"
[floater]
buoy = "T-5000l-2.4m"
wind_speed = "25 m/s"
[waves]
spectrum = "jonswap"
height = "{height} m"
period = "4 s"
components = 100
[current]
profile = "power"
speed = "1 m/s"
[dynamics]
duration = "600 s"
elements = 20
"""


@pytest.mark.slow
@pytest.mark.parametrize(("height", "holds"), [(0.3, True), (2.0, False)])
def test_a_buoy_in_a_sea(height: float, holds: bool) -> None:
    """The deviation of the tension to 7 % where the line stays taut, else it is told."""
    case = parse_case(CASE.format(height=height))
    (line,) = linear_lines(case)
    assert line.holds is holds
    assert line.buoy is not None
    found = verify_dynamic(case, convergence_check="none", workers=1, compares_at_rest=False)
    (part,) = found.parts
    assert (part.slack_time == 0.0) is holds
    if holds:
        assert line.deviation == pytest.approx(part.of("fairlead_tension").std, rel=0.07)
        assert line.anchor_deviation == pytest.approx(part.of("anchor_tension").std, rel=0.1)
        (run,) = part.runs
        assert run.hull is not None
        heave = run.hull.place[run.history.counted, 2]
        assert line.buoy[1] == pytest.approx(float(heave.std()), rel=0.05)
