"""The energy balance of a run against what is known in closed form, and that it closes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.fem import (
    BodyInertia,
    Harmonic,
    Leg,
    LineDamping,
    LineProperties,
    MorisonSection,
    Sampled,
    Scheme,
    Seabed,
    TimeStepping,
    run_dynamics,
    run_system_dynamics,
)
from catopt.model import Line, PointLoad, Segment
from catopt.waves import Sea, TableCurrent, regular_wave

LENGTH, EA = 50.0, 1e6
STRING = Line([Segment(LENGTH, 0.0, EA=EA, mass=5.0)])
SECTION = MorisonSection(0.3, 1.2, 0.0, 0.0)


def test_work_of_the_ends_is_stored_as_strain() -> None:
    """A string stretched slowly from 1 % to 2 %: k (x1^2 - x0^2)/2."""
    t = np.linspace(0.0, 400.0, 401)
    way = 0.25 * (1.0 - np.cos(math.pi * t / 400.0))
    history = run_dynamics(
        STRING, TimeStepping(400.0, 0.5), height=50.5, span=1e-6,
        motion=Sampled(t, np.column_stack([0 * t, 0 * t, way])),
        properties=LineProperties(seabed=None), elements=10,
    )  # fmt: skip
    stored = 0.5 * EA / LENGTH * (1.0**2 - 0.5**2)
    balance = history.balance
    # The trapezoidal rule over 800 steps of a force that goes with the way.
    assert balance.ends == pytest.approx(stored, rel=1e-5)
    assert balance.elastic == pytest.approx(stored, rel=1e-5)
    assert balance.numerical_part < 1e-5


@pytest.mark.slow
def test_line_damping_takes_what_a_dashpot_does() -> None:
    """A string stretched evenly, a sin(w t): pi c w a^2 in every cycle, c = C/L."""
    period, a, C, cycles = 8.0, 0.1, 2e5, 10
    history = run_dynamics(
        STRING, TimeStepping((cycles + 2) * period, period / 200, ramp_time=2 * period),
        height=50.5, span=1e-6, motion=Harmonic(period, (0.0, 0.0, a)),
        properties=LineProperties(damping=LineDamping(internal=C), seabed=None), elements=10,
    )  # fmt: skip
    per_cycle = math.pi * C / LENGTH * 2.0 * math.pi / period * a**2
    # Over the two of the ramp, (1 - cos)/2 squared has the mean 3/8; its own speed adds 1/256.
    expected = per_cycle * (cycles + 2 * (3 / 8 + 1 / 128))
    assert history.balance.damping == pytest.approx(expected, rel=0.005)
    assert history.balance.numerical_part < 1e-3


def test_drag_takes_what_a_swaying_string_gives() -> None:
    """A taut string, its top swaying: 0.5 rho D C L/4 (w a)^3 4/(3 pi) on average."""
    period, a, cycles = 8.0, 0.3, 8
    rho = 1025.0
    history = run_dynamics(
        Line([Segment(LENGTH, 0.0, EA=1e8, mass=0.5)]),
        TimeStepping((cycles + 2) * period, period / 100, ramp_time=2 * period),
        height=50.5, span=1e-6, motion=Harmonic(period, (0.0, a, 0.0)),
        properties=LineProperties(
            [MorisonSection(0.05, 1.2, 0.0, 0.0)], LineDamping(critical_ratio=1.0), seabed=None
        ),
        elements=40,
    )  # fmt: skip
    speed = 2.0 * math.pi / period * a
    power = 0.5 * rho * 0.05 * 1.2 * LENGTH / 4.0 * speed**3 * 4.0 / (3.0 * math.pi)
    ramp = 0.5 * (1.0 - np.cos(math.pi * np.linspace(0.0, 1.0, 1001)))
    whole = power * period * (cycles + 2 * float(np.trapezoid(ramp**3, dx=1e-3)))
    # 40 bars: (1/40)^2; the ramp's own speed adds to the first two cycles.
    assert history.balance.drag == pytest.approx(whole, rel=0.01)
    assert history.balance.numerical_part < 1e-3


@pytest.mark.parametrize("scheme", [Scheme.average_acceleration(), Scheme.generalised_alpha(0.5)])
def test_balance_closes_in_waves_on_the_bed(scheme: Scheme) -> None:
    """Chain with a clump weight in waves and current on a rough bed: less than 1e-3 is numerical.

    Added mass turns with the bars, the upper end leaves the water, friction slips, Rayleigh damps.
    """
    line = Line([Segment(150.0, 500.0, EA=2e8, mass=58.0)], [PointLoad(60.0, 4e3, mass=600.0)])
    sea = Sea(40.0, regular_wave(2.0, 7.0), [TableCurrent([0.0], [0.5])])
    history = run_dynamics(
        line, TimeStepping(56.0, 0.05, ramp_time=14.0, scheme=scheme), height=41.0, span=135.0,
        motion=Harmonic(7.0, (0.5, 0.2, 0.4)), sea=sea, elements=40,
        properties=LineProperties(
            [MorisonSection(0.1, 2.0, 0.4, 1.0, 0.5)],
            LineDamping(critical_ratio=1.0, mass_factor=0.01, stiffness_factor=0.002),
            seabed=Seabed(friction=0.4),
        ),
    )  # fmt: skip
    balance = history.balance
    assert balance.numerical_part < 1e-3
    for taken in (balance.drag, balance.bed, balance.friction, balance.damping):
        assert taken > 0.0


def test_a_body_puts_in_what_its_lines_take() -> None:
    """Lines of a body under a force: their ends' work is the line's, and it closes."""
    line = Line([Segment(300.0, 1000.0, EA=5e8, mass=117.0)])
    legs = [
        Leg(line, (280.0 * math.cos(a), 280.0 * math.sin(a), 0.0))
        for a in (0.0, 2 * math.pi / 3, 4 * math.pi / 3)
    ]
    history = run_system_dynamics(
        legs, TimeStepping(200.0, 0.2, ramp_time=50.0), height=80.0,
        force=Harmonic(25.0, (2e5, 0.0, 0.0)), body=BodyInertia(1e6, 2e5),
        properties=LineProperties([MorisonSection(0.13, 1.3, 0.5)], seabed=Seabed(friction=0.3)),
        elements=20,
    )  # fmt: skip
    assert history.balance.put_in > 0.0
    assert history.balance.numerical_part < 1e-3


def test_what_a_long_step_loses_is_shown() -> None:
    """The part that is numerical falls with the square of the step."""
    parts = []
    for step in (0.4, 0.2, 0.1):
        history = run_dynamics(
            STRING, TimeStepping(80.0, step, ramp_time=16.0), height=50.5, span=1e-6,
            motion=Harmonic(8.0, (0.0, 1.0, 0.05)),
            properties=LineProperties([SECTION], seabed=None), elements=20,
        )  # fmt: skip
        parts.append(history.balance.numerical_part)
    assert parts[0] > parts[1] > parts[2]
    assert parts[1] / parts[2] > 2.0
