"""Lines that go slack and snap: steps that follow the snap, and what is refused."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from catopt.errors import NotConvergedError
from catopt.fem import (
    Fluid,
    Harmonic,
    History,
    LineDamping,
    LineProperties,
    MorisonSection,
    Scheme,
    Seabed,
    StepControls,
    TimeStepping,
    run_dynamics,
)
from catopt.fem.march import compare_tensions
from catopt.model import Line, Segment
from catopt.waves import Sea
from tests.fem.strings import plain_simulation

# 38 mm studless chain, its figures from the catalogue to three digits.
CHAIN = Line([Segment(60.0, 245.0, EA=1.23e8, mass=28.8)])


@cache
def snapping(step: float, controls: StepControls, ratio: float) -> History:
    """60 m of chain in 20 m of water, its fairlead heaving by 3 m in 6 s: it snaps each time."""
    return run_dynamics(
        CHAIN,
        TimeStepping(30.0, step, ramp_time=12.0, controls=controls),
        height=20.0,
        horizontal_force=20e3,
        motion=Harmonic(6.0, (0.0, 0.0, 3.0)),
        properties=LineProperties(
            [MorisonSection(0.038, 2.4, 0.4, 1.0, 0.5)],
            LineDamping(critical_ratio=ratio),
            seabed=Seabed(friction=0.5),
        ),
        elements=50,
    )


def test_the_step_follows_a_snap() -> None:
    """At a sixtieth of the period, and at a tenth of that: the same maxima within 2 %."""
    coarse, fine = (snapping(step, StepControls(), 1.0) for step in (0.1, 0.01))
    assert coarse.line_slack_time() > 3.0
    assert coarse.refinements > 100
    assert coarse.shortest_step < 1e-3
    # A twentieth of the largest tension may surprise in a step; twice interpolated.
    assert coarse.max_end_force == pytest.approx(fine.max_end_force, rel=0.02)
    assert coarse.line_max_tension() == pytest.approx(fine.line_max_tension(), rel=0.02)


@pytest.mark.slow
def test_a_fixed_step_misses_the_snap() -> None:
    """Without damping a step by the period alone is off by tens of per cent, or a factor."""
    fixed = snapping(0.1, StepControls(max_refinements=0, max_ringing=math.inf), 0.0)
    true = snapping(0.01, StepControls(), 0.0).max_end_force[0, 1]
    assert abs(fixed.tension_statistics().maximum / true - 1.0) > 0.2


def test_a_smooth_motion_keeps_its_step() -> None:
    """Nothing surprises where the line stays taut."""
    history = run_dynamics(
        CHAIN, TimeStepping(30.0, 0.1, ramp_time=12.0), height=20.0, horizontal_force=40e3,
        motion=Harmonic(6.0, (0.2, 0.0, 0.1)), elements=50,
        properties=LineProperties([MorisonSection(0.038, 2.4, 0.4)], LineDamping(critical_ratio=1)),
    )  # fmt: skip
    assert (history.refinements, history.unresolved) == (0, 0)
    assert history.steps == 300


def test_extremes_at_the_ends_see_every_step() -> None:
    """The largest force between two samples is kept, with its time."""
    history = snapping(0.1, StepControls(), 1.0)
    sampled = history.tension_statistics()
    largest = float(history.max_end_force[0, 1])
    # At a sample the led end's acceleration is known, between them it is carried on.
    assert largest >= sampled.maximum * (1.0 - 1e-5)
    assert history.time_of_max_end_force[0, 1] >= history.since
    # A nodal force and the tension of the bar beside it: half a bar's weight and inertia apart.
    assert largest == pytest.approx(float(history.max_tension[-1]), rel=0.02)


def _model_test(scheme: Scheme, controls: StepControls) -> History:
    line = Line([Segment(33.0, 0.7, EA=1e4, mass=0.0818)])
    properties = LineProperties(
        [MorisonSection(0.0022, 2.5, 0.5, 2.8)], LineDamping(internal=2.0), Fluid(1000.0, 9.81),
        Seabed(700.0, friction=0.3),
    )  # fmt: skip
    stepping = TimeStepping(14.0, 0.01, ramp_time=7.0, scheme=scheme, controls=controls)
    return run_dynamics(
        line, stepping, height=3.3, span=32.554, properties=properties, elements=66,
        motion=Harmonic(3.5, (0.2, 0.0, 0.2), (0.0, 0.0, math.pi / 2)), sea=Sea(3.0),
    )  # fmt: skip


def test_ringing_is_no_result() -> None:
    """A light stiff line that snaps, at a step far too long for a scheme that does not damp."""
    fixed = StepControls(max_refinements=0)
    with pytest.raises(NotConvergedError, match=r"of the energy of its tensions changes from step"):
        _model_test(Scheme.average_acceleration(), fixed)


def test_schemes_agree_where_the_step_follows() -> None:
    """The same line with the step that follows: with and without the scheme's damping, to 0.5 %."""
    one, other = (
        _model_test(scheme, StepControls())
        for scheme in (Scheme.average_acceleration(), Scheme.generalised_alpha(0.5))
    )
    assert one.max_end_force == pytest.approx(other.max_end_force, rel=0.005)


@pytest.mark.slow
def test_the_ringing_test_does_not_judge_the_step() -> None:
    """Ever shorter steps are not refused, with damping or without."""
    for ratio in (0.0, 1.0):
        assert snapping(0.002, StepControls(), ratio).is_complete


def test_slack_in_all_and_at_a_stretch() -> None:
    """Slack once a period: three periods count, and no stretch is longer than one of them."""
    history = snapping(0.1, StepControls(), 1.0)
    total, longest = history.line_slack_time(), history.line_longest_slack()
    assert longest < 6.0 < total < 18.0
    # A bar that was slack once only would have both the same.
    assert total > 2.0 * longest
    assert (history.longest_slack <= history.slack_time + 1e-9).all()


def test_a_slack_bar_that_goes_taut_asks_for_two_transits() -> None:
    """A bar of 2.5 m, 1 MN and 4 kg/m: a wave passes it in 2.5 sqrt(4/1e6) = 5 ms."""
    simulation = plain_simulation(((0.0,) * 3, (10.0, 0.0, 0.0)), 10.0, 4, EA=1e6, mass=4.0)
    room, before = simulation._room, simulation.state
    room.highest[0] = 100e3
    room.now.tension[:] = [0.0, 50e3, 0.5e3, 0.0]
    room.loose[:] = [True, True, True, False]
    seen = compare_tensions(0.1, 2.0, simulation.lines, before, room)
    assert seen.longest == pytest.approx(0.010)
    assert seen.passes == pytest.approx(20 * 0.005)
    assert seen.surprise == 50e3
    assert seen.least == pytest.approx(0.005)
    room.loose[1] = False  # it was taut; half a per cent of the largest makes no bar taut
    seen = compare_tensions(0.1, 2.0, simulation.lines, before, room)
    assert (seen.longest, seen.passes) == (math.inf, 0.0)


WIRE = Line([Segment(68.4125, 264.569, EA=3.29003e8, mass=32.4932)])
"""Line of seed 1248 of benchmarks/slack.py, to six digits."""


@cache
def snapping_wire(heave: float) -> list[float]:
    """Peaks of ten cycles of a wire that snaps every 7 s, but for the first two, N."""
    period = 7.0076
    history = run_dynamics(
        WIRE,
        TimeStepping(14.0 * period, period / 60.0, ramp_time=1.5 * period),
        height=22.3207,
        horizontal_force=10230.0,
        motion=Harmonic(period, (0.622606, 0.0, heave), (5.97612, 0.0, 0.0)),
        properties=LineProperties(
            [MorisonSection(0.0902422, 1.2, 0.0, 1.0)],
            LineDamping(critical_ratio=1.0),
            seabed=Seabed(friction=0.067),
        ),
    )
    course = history.course("fairlead_tension")
    cycle = ((course.time - course.time[0]) / period).astype(int)
    return [float(course.value[cycle == k].max()) for k in range(2, 12)]


@pytest.mark.slow
def test_snaps_are_no_draws_from_rounding() -> None:
    """Peaks scatter by less than 1 %, and 1e-9 of the heave changes their mean by no more."""
    one, other = (snapping_wire(3.20798 * more) for more in (1.0, 1.0 + 1e-9))
    for peaks in (one, other):
        assert np.std(peaks) < 0.01 * np.mean(peaks)
    assert np.mean(one) == pytest.approx(np.mean(other), rel=0.01)
