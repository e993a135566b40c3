"""Lines in motion that meet in joints: beside one line, a closed form, and themselves turned."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.dynamics import line_at_rest, run_dynamics, run_network_dynamics
from catopt.fem.history import History
from catopt.fem.mesh import mesh_line
from catopt.fem.morison import MorisonSection
from catopt.fem.network import LineEnd
from catopt.fem.newmark import LineDamping, Scheme
from catopt.fem.run_settings import StepControls, TimeStepping
from catopt.fem.seabed import Seabed
from catopt.fem.series import Harmonic
from catopt.model import Line, PointLoad, Segment
from catopt.model.network import Point
from catopt.mooring.joints import reversed_line
from catopt.waves import Sea, regular_wave

SECTION = MorisonSection(0.05, 1.6, 0.3, 1.0, 0.1)
PROPERTIES = LineProperties(
    sections=[SECTION],
    damping=LineDamping(critical_ratio=0.5),
    seabed=Seabed(2e4, 2e3, friction=0.0),
)
CHAIN = Segment(80.0, 200.0, EA=2e7, mass=23.5)
ROPE = Segment(60.0, 20.0, EA=5e6, mass=4.0)
JOINT = LineEnd((0.0, 0.0, 0.0), 0)
WAVES = Sea(50.0, regular_wave(2.0, 7.0, direction=0.4), ramp_time=5.0)
MOTION = Harmonic(7.0, (0.5, 0.4, 0.5), (0.0, 1.0, 2.0))
STEPPING = TimeStepping(
    14.0, 0.1, ramp_time=7.0, controls=StepControls(tolerance=1e-9, surprise=100.0)
)


@pytest.mark.parametrize("weight", [2e3, -3e3], ids=["clump", "buoy"])
def test_joint_of_two_lines_is_a_point_load(weight: float) -> None:
    """The same nodes, bars and loads in one line, which knows no joints."""
    body: dict[str, Any] = {
        "mass": 450.0,
        "drag_area": 0.5,
        "drag_coefficient": 1.0,
        "added_mass_coefficient": 0.5,
    }
    load = PointLoad(80.0, weight, **body)
    line = Line([CHAIN, ROPE], [load])
    damping = LineDamping(internal=2e4)
    of = replace(PROPERTIES, damping=damping)
    one = run_dynamics(
        line,
        STEPPING,
        height=45.0,
        span=121.0,
        motion=MOTION,
        properties=replace(of, sections=[SECTION] * 2),
        sea=WAVES,
        elements=[16, 12],
    )
    two = run_network_dynamics(
        [mesh_line(Line([CHAIN]), 16), mesh_line(Line([ROPE]), 12)],
        [(LineEnd((0.0, 0.0, 0.0)), JOINT), (JOINT, LineEnd((121.0, 0.0, 45.0)))],
        [Point("joint", "joint", submerged_weight=weight, **body)],
        STEPPING,
        motions=[(None, None), (None, MOTION)],
        properties=of,
        sea=WAVES,
    )
    largest = one.fairlead_tension.max()
    near = 1e-6 * largest  # of steps that leave 1e-9 over
    assert two.fairlead_tension[:, 1] == pytest.approx(one.fairlead_tension[:, 0], abs=near)
    assert two.anchor_tension[:, 0] == pytest.approx(one.anchor_tension[:, 0], abs=near)
    assert two.nodes[0, 0] == pytest.approx(one.at_rest[16], abs=1e-6)
    assert np.ptp(two.nodes[:, 0, 2]) > 0.3
    assert two.line_max_tension(0) == pytest.approx(one.max_tension[:16].max(), rel=1e-6)
    books, alone = two.balance, one.balance
    for each in ("ends", "water", "kinetic", "elastic", "potential", "drag", "bed", "damping"):
        booked = getattr(alone, each)
        assert getattr(books, each) == pytest.approx(booked, abs=1e-6 * alone.put_in)


def crowfoot(turned: tuple[bool, bool, bool], scheme: Scheme | None = None) -> History:
    """Run a chain that splits into two ropes, each given from either end."""
    ends = [
        (LineEnd((0.0, 0.0, 0.0)), JOINT),
        (JOINT, LineEnd((110.0, 15.0, 45.0))),
        (JOINT, LineEnd((110.0, -15.0, 45.0))),
    ]
    lines = [Line([CHAIN]), Line([ROPE]), Line([ROPE])]
    motions = [(None, None), (None, MOTION), (None, MOTION)]
    return run_network_dynamics(
        [mesh_line(reversed_line(x) if t else x, 12) for x, t in zip(lines, turned, strict=True)],
        [pair[::-1] if t else pair for pair, t in zip(ends, turned, strict=True)],
        [Point("joint", "joint", submerged_weight=-900.0, mass=300.0)],
        replace(STEPPING, scheme=scheme or STEPPING.scheme),
        motions=[pair[::-1] if t else pair for pair, t in zip(motions, turned, strict=True)],
        properties=PROPERTIES,
        sea=WAVES,
    )


def test_which_way_a_line_is_given_makes_no_difference() -> None:
    given = crowfoot((False, False, False))
    turned = crowfoot((True, False, True))
    largest = given.fairlead_tension.max()
    near = 1e-6 * largest  # of the steps' own tolerance
    assert turned.anchor_tension[:, 0] == pytest.approx(given.fairlead_tension[:, 0], abs=near)
    assert turned.fairlead_tension[:, 0] == pytest.approx(given.anchor_tension[:, 0], abs=near)
    assert turned.fairlead_tension[:, 1] == pytest.approx(given.fairlead_tension[:, 1], abs=near)
    assert turned.anchor_tension[:, 2] == pytest.approx(given.fairlead_tension[:, 2], abs=near)
    assert turned.nodes == pytest.approx(given.nodes, abs=1e-6)


def test_books_close_where_nothing_is_lost_by_the_scheme() -> None:
    """Newmark's average acceleration: works add up to the energy gained, joints included."""
    books = crowfoot((False, False, False), Scheme.average_acceleration()).balance
    assert books.numerical_part < 2e-3
    assert books.drag > 0.02 * books.put_in


@pytest.mark.parametrize("of_own", [0.5, 2.0])
def test_buoy_on_a_tether_that_is_led_below(of_own: float) -> None:
    """A pendulum upside down: led by a cos(w t), the buoy goes a/(1 - (w/w0)^2) far.

    w0^2 = B/((m + ma) L), of a tether that has next to no mass.
    """
    lift, mass, length, far = 5e3, 400.0, 20.0, 0.05
    displaced = mass + lift / 9.80665
    own = math.sqrt(lift / ((mass + 0.5 * displaced) * length))
    period = 2.0 * math.pi / (of_own * own)
    tether = Line([Segment(length, 1e-3, EA=1e8, mass=1e-3)])
    found = run_network_dynamics(
        [mesh_line(tether, 4)],
        [(LineEnd((0.0, 0.0, 5.0)), JOINT)],
        [
            Point(
                "buoy",
                "joint",
                submerged_weight=-lift,
                mass=mass,
                added_mass_coefficient=0.5,
            )
        ],
        TimeStepping(14.0 * period, period / 120.0, ramp_time=10.0 * period),
        motions=[(Harmonic(period, (far, 0.0, 0.0)), None)],
        properties=LineProperties(seabed=None),
    )
    late = found.time >= 11.0 * period
    swing = 0.5 * np.ptp(found.nodes[late, 0, 0])
    # What a ramp of ten periods leaves of the pendulum's own swing, and the turn's square.
    assert swing == pytest.approx(far / abs(1.0 - of_own**2), rel=0.01)


def test_a_joint_of_unknown_mass_is_refused() -> None:
    with pytest.raises(InputError, match="mass"):
        run_network_dynamics(
            [mesh_line(Line([Segment(20.0, 10.0, EA=1e6, mass=2.0)]), 4)],
            [(LineEnd((0.0, 0.0, 5.0)), JOINT)],
            [Point("buoy", "joint", submerged_weight=-5e3)],
            TimeStepping(1.0, 0.1),
        )


@pytest.mark.parametrize("span", [110.0, 115.0, 118.0])
@pytest.mark.parametrize("friction", [0.0, 0.5])
@pytest.mark.parametrize("elements", [[16, 12], [8, 6]])
def test_a_clump_weight_on_the_bed_comes_to_rest(
    span: float, friction: float, elements: list[int]
) -> None:
    """Friction under it may hold the line, whose chain behind it is slack.

    What it presses into the bed is its own weight and the line's over the bed's stiffness.
    """
    line = Line([CHAIN, ROPE], [PointLoad(80.0, 2e3, mass=450.0)])
    bed = Seabed(2e4, 2e3, friction=friction)
    of = replace(PROPERTIES, sections=[SECTION] * 2, seabed=bed)
    rest = line_at_rest(mesh_line(line, elements), height=45.0, span=span, properties=of)
    at = rest.state
    assert at.reaction[elements[0]] > 0.0
    bar = at.x[-1] - at.x[-2]
    lift = at.tension[-1] * bar[2] / float(np.linalg.norm(bar)) + 10.0 * 60.0 / elements[1]
    weight = 200.0 * 80.0 + 20.0 * 60.0 + 2e3
    assert at.reaction.sum() - at.force[0, 2] + lift == pytest.approx(weight, rel=1e-6)
