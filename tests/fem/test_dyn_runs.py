"""Whole runs: slow ones against rest, waves against their loads, samples, refusals, Ctrl-C."""

from __future__ import annotations

import math
import os
import signal
import sys
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from catopt.errors import InputError, NotConvergedError
from catopt.fem import (
    Bed,
    BodyInertia,
    Fluid,
    Harmonic,
    Leg,
    LineDamping,
    LineProperties,
    MorisonSection,
    Sampled,
    Seabed,
    StepControls,
    TimeStepping,
    line_frequencies,
    mesh_line,
    run_dynamics,
    run_system_dynamics,
    solve_line,
    solve_system,
    weibull_tail,
)
from catopt.fem.series import fill_series, series_rows
from catopt.model import Line, PointLoad, Segment
from catopt.waves import Sea, TableCurrent, jonswap, random_waves, regular_wave
from tests.fem import rang_dong

CHAIN = Line([Segment(300.0, 1000.0, EA=5e8, mass=117.0)])
SECTION = MorisonSection(0.13, 1.3, 0.5, 1.0, 0.2)
STIFF_BED = Seabed(1e6)
WET = LineProperties([SECTION], LineDamping(critical_ratio=0.5), seabed=STIFF_BED)


def test_slow_motion_passes_through_states_at_rest() -> None:
    """Fairlead moved by 4 m in 400 s: the tension is always that of the line at rest there."""
    motion = Harmonic(800.0, (2.0, 0.0, 0.0), (math.pi, 0.0, 0.0))
    history = run_dynamics(
        CHAIN, TimeStepping(800.0, 0.5, ramp_time=200.0, output_interval=20.0), height=80.0,
        span=275.0, motion=motion, properties=WET, elements=40,
    )  # fmt: skip
    for at in (0, 15, 20, 30):
        span = history.fairlead[at, 0, 0]
        rest = solve_line(
            CHAIN, height=80.0, span=float(span), elements=40, bed=Bed(normal_stiffness=1e6)
        )
        # Drag at 2 cm/s, and a bed that shares a bar's weight otherwise: (bar/length)^2.
        assert history.fairlead_tension[at, 0] == pytest.approx(rest.fairlead.tension, rel=2e-3)
        assert history.grounded_length[at, 0] == pytest.approx(rest.grounded_length, abs=7.5)


def _legs() -> list[Leg]:
    angles = [math.radians(a) for a in (0.0, 120.0, 240.0)]
    return [Leg(CHAIN, (280.0 * math.cos(a), 280.0 * math.sin(a), 0.0)) for a in angles]


def test_slow_force_on_a_body_passes_through_states_at_rest() -> None:
    """Force of 100 kN that comes and goes in 1,000 s, in the body's mean force of 200 kN."""
    history = run_system_dynamics(
        _legs(), TimeStepping(1000.0, 1.0, ramp_time=300.0, output_interval=50.0), height=80.0,
        mean_force=(-2e5, 0.0), force=Harmonic(1000.0, (1e5, 0.0, 0.0)),
        body=BodyInertia(1e6, 2e5), properties=WET, elements=20,
    )  # fmt: skip
    for at in (0, 10):
        ramp = 1.0 if history.time[at] >= 300.0 else 0.0
        force = -2e5 + ramp * 1e5 * math.cos(2.0 * math.pi * history.time[at] / 1000.0)
        rest = solve_system(
            _legs(), height=80.0, force=(force, 0.0), elements=20, bed=Bed(normal_stiffness=1e6)
        )
        x = history.fairlead[at, :, 0]
        # All lines end in the body.
        assert np.ptp(x) < 1e-9
        # Drag and the body's own period of some tens of seconds: (50/1000)^2, in 20 m of travel.
        assert x[0] == pytest.approx(rest.position[0], abs=0.05)
        assert np.abs(history.fairlead[at, :, 2] - 80.0).max() < 1e-9


def test_source_s4_at_rest() -> None:
    """FSO Rang Dong as its source ran it, nodes held down: the printed static figures, and still.

    S4's static table: turret offset 6.071 m, largest fairlead tension 1,918 kN.
    """
    mass = (34.9, 157.7, 178.7, 178.7)
    rested = []
    for leg in rang_dong.legs():
        segments = [replace(s, mass=m) for s, m in zip(leg.line.segments, mass, strict=True)]
        rested.append(replace(leg, line=Line(segments)))
    history = run_system_dynamics(
        rested, TimeStepping(10.0, 0.1), height=rang_dong.TURRET_HEIGHT,
        mean_force=rang_dong.FORCE, body=BodyInertia(1e8), elements=[5] * 4,
        properties=LineProperties(seabed=rang_dong.AS_RUN),
    )  # fmt: skip
    # Half of the last printed digit; tension to 0.05 %.
    assert history.fairlead[0, 0, 0] == pytest.approx(-6.071, abs=5e-4)
    assert history.bar_tension[0, :, 1].max() == pytest.approx(1918e3, rel=5e-4)
    assert history.fairlead[-1, 0, 0] == pytest.approx(history.fairlead[0, 0, 0], abs=1e-4)


def test_led_body_and_led_line_are_the_same() -> None:
    """One leg of a system with a led body is the line with a led fairlead."""
    motion = Harmonic(8.0, (1.0, 0.0, 0.5))
    stepping = TimeStepping(20.0, 0.1, ramp_time=8.0, controls=StepControls(tolerance=1e-11))
    one = run_dynamics(
        CHAIN, stepping, height=80.0, span=280.0, motion=motion, properties=WET, elements=20
    )
    mirrored = Harmonic(8.0, (-1.0, 0.0, 0.5))
    three = run_system_dynamics(
        _legs(), stepping, height=80.0, position=(0.0, 0.0), motion=mirrored, properties=WET,
        elements=20,
    )  # fmt: skip
    # Rounding, which grows wherever a node touches down.
    assert three.fairlead_tension[:, 0] == pytest.approx(one.fairlead_tension[:, 0], rel=1e-6)
    assert three.fairlead_tension[:, 1] == pytest.approx(three.fairlead_tension[:, 2], rel=1e-6)


@pytest.mark.slow
def test_waves_on_a_taut_line() -> None:
    """Reactions of a string that hardly moves: the integral of Morison's load over it."""
    depth, length, EA = 60.0, 50.0, 1e9
    line = Line([Segment(length, 0.0, EA=EA, mass=50.0)])
    sea = Sea(depth, regular_wave(4.0, 9.0, direction=0.4), [TableCurrent([0.0], [0.5])])
    section = MorisonSection(0.5, 1.1, 0.0, 0.9)
    fluid = Fluid(1025.0)
    history = run_dynamics(
        line, TimeStepping(60.0, 0.05, ramp_time=20.0), height=length * 1.01, span=1e-3,
        properties=LineProperties(
            [section], LineDamping(mass_factor=2.0), fluid, None
        ),
        sea=sea, elements=40,
    )  # fmt: skip
    late = history.time > 45.0
    total = (history.fairlead_force + history.anchor_force)[late, 0]
    z = np.linspace(0.0, length * 1.01, 401)
    points = np.column_stack([np.zeros((401, 2)), z])
    expected = []
    for t in history.time[late]:
        water = sea.kinematics(float(t), points)
        u, a = water.velocity[:, :2], water.acceleration[:, :2]
        speed = np.linalg.norm(u, axis=1)[:, np.newaxis]
        load = 0.5 * 1025.0 * 0.5 * 1.1 * speed * u + 50.0 * 1.9 * a
        expected.append(np.trapezoid(load, z, axis=0) / 1.01)
    size = np.abs(expected).max()
    # It gives way by millimetres at 3 Hz and more, and is inclined by as little.
    assert total[:, :2] == pytest.approx(np.array(expected), abs=0.01 * size)


def test_current_before_the_start() -> None:
    """The first sample is at rest in the current: nothing happens without waves or motion."""
    sea = Sea(90.0, None, [TableCurrent([0.0, 90.0], [1.0, 0.4], direction=math.pi / 2)])
    history = run_dynamics(
        CHAIN, TimeStepping(10.0, 0.1, nodes=(10,)), height=80.0, span=280.0, properties=WET,
        sea=sea, elements=20,
    )  # fmt: skip
    tension = history.fairlead_tension[:, 0]
    # Newton's tolerance.
    assert tension == pytest.approx(tension[0], rel=1e-6)
    assert history.nodes[0, 0, 1] > 0.1
    assert history.nodes[:, 0] == pytest.approx(np.tile(history.nodes[0, 0], (101, 1)), abs=1e-4)


def test_sampled_motion_is_the_harmonic_one() -> None:
    """A cubic through 40 points a period brings the same force as the harmonic itself."""
    period, t = 8.0, np.arange(0.0, 40.01, 0.2)
    wave = np.cos(2.0 * math.pi * t / period)
    sampled = Sampled(t, np.outer(wave, [0.4, 0.0, 0.2]))
    harmonic = Harmonic(period, (0.4, 0.0, 0.2))
    stepping = TimeStepping(30.0, 0.1, ramp_time=8.0)
    tensions = [
        run_dynamics(
            CHAIN, stepping, height=80.0, span=280.0, motion=motion, properties=WET, elements=20
        ).fairlead_tension[:, 0]
        for motion in (harmonic, sampled)
    ]
    # (w h)^4/384 in place, (w h)^2/12 = 2e-3 in acceleration.
    assert tensions[0] == pytest.approx(tensions[1], abs=1e-3 * np.ptp(tensions[0]))


@pytest.mark.parametrize("kind", ["harmonic", "sampled"])
def test_velocity_and_acceleration_go_with_the_motion(kind: str) -> None:
    """Differences of the led place over time, ramp included."""
    rng = np.random.default_rng(1)
    series: Any = Harmonic((5.0, 9.0), rng.standard_normal((2, 3)), rng.standard_normal((2, 3)))
    if kind == "sampled":
        series = Sampled(np.arange(0.0, 20.0, 0.5), rng.standard_normal((40, 3)))
    rows = series_rows(np.zeros((1, 3)), [series], 12.0)
    out = np.zeros((3, 3, 3))
    d = 1e-4
    for t in (0.3, 3.14, 11.71, 15.2):
        for i, at in enumerate((t - d, t, t + d)):
            fill_series(at, rows, 0, out[i])
        # Second differences of rounding 1e-16 over (1e-4)^2; third derivatives times d^2.
        assert out[1, 1] == pytest.approx((out[2, 0] - out[0, 0]) / (2 * d), abs=1e-6)
        assert out[1, 2] == pytest.approx((out[2, 1] - out[0, 1]) / (2 * d), abs=1e-5)


def test_point_load_and_raised_anchor() -> None:
    """A clump weight with its mass, on a line that hangs free: it only has to run and balance."""
    line = Line([Segment(120.0, 500.0, EA=1e8, mass=60.0)], [PointLoad(60.0, 8e3, mass=1e3)])
    history = run_dynamics(
        line, TimeStepping(20.0, 0.05, ramp_time=5.0), height=60.0, span=95.0, anchor_height=40.0,
        motion=Harmonic(5.0, (0.5, 0.0, 0.0)),
        properties=LineProperties([SECTION], LineDamping(critical_ratio=0.5)), elements=30,
    )  # fmt: skip
    vertical = (history.fairlead_force + history.anchor_force)[0, 0, 2]
    # At rest both ends carry the whole weight.
    assert vertical == pytest.approx(-(120.0 * 500.0 + 8e3), rel=1e-6)
    heavier = Line([line.segments[0]], [PointLoad(60.0, 8e3)])
    with pytest.raises(InputError, match=r"point_loads\[0\]\.mass"):
        run_dynamics(heavier, TimeStepping(1.0, 0.1), height=60.0, span=95.0, anchor_height=40.0)


def test_frequencies_of_a_moored_line() -> None:
    """Lowest of a catenary line between those of a string with its least and largest tension."""
    found = line_frequencies(
        mesh_line(CHAIN, 60), 2, height=80.0, span=285.0,
        properties=LineProperties(seabed=Seabed(1e6, friction=0.6)),
    )  # fmt: skip
    rest = solve_line(CHAIN, height=80.0, span=285.0, elements=60)
    hanging = 300.0 - rest.grounded_length
    low, high = (math.pi / hanging * math.sqrt(T / 117.0) for T in
                 (rest.horizontal_force, rest.fairlead.tension))  # fmt: skip
    assert low < found[0] < high


def test_refusals_name_what_is_wrong() -> None:
    stepping = TimeStepping(10.0, 0.1)
    bare = Line([Segment(300.0, 1000.0)])
    with pytest.raises(InputError) as caught:
        run_dynamics(bare, stepping, height=80.0, span=280.0)
    assert {p.key for p in caught.value.problems} == {
        "lines[0].segments[0].mass",
        "lines[0].segments[0].EA",
    }
    light = Line([Segment(300.0, 1000.0, EA=1e8, mass=50.0, accept=["weight_in_water"])])
    with pytest.raises(InputError, match="more in air than in water"):
        run_dynamics(light, stepping, height=80.0, span=280.0)
    with pytest.raises(InputError, match="must rise"):
        Sampled([0.0, 1.0, 1.0, 2.0, 3.0], np.zeros((5, 3)))
    with pytest.raises(InputError, match="nothing between 3 s and 13 s"):
        Sampled([0.0, 1.0, 2.0, 3.0, 13.0, 14.0, 15.0, 16.0], np.zeros((8, 3)))
    with pytest.raises(InputError, match="row 2"):
        Sampled(range(5), [[0, 0, 0]] * 2 + [[0, math.nan, 0]] + [[0, 0, 0]] * 2)
    with pytest.raises(InputError, match="longer than the run"):
        TimeStepping(1.0, 2.0)
    with pytest.raises(InputError, match="multiple of the step"):
        TimeStepping(10.0, 0.1, output_interval=0.25)
    with pytest.raises(InputError, match=r"periods down to 2 s: 0\.1 s or less"):
        run_dynamics(
            CHAIN, TimeStepping(10.0, 0.6), height=80.0, span=280.0, motion=Harmonic(2.0, (1, 0, 0))
        )
    with pytest.raises(InputError, match="begins 1 m away from rest"):
        run_dynamics(CHAIN, stepping, height=80.0, span=280.0, motion=Harmonic(8.0, (1, 0, 0)))
    with pytest.raises(InputError, match="not both"):
        run_system_dynamics(
            _legs(), stepping, height=80.0, position=(0.0, 0.0), mean_force=(1.0, 0.0)
        )


def test_warnings_carry_their_numbers() -> None:
    """Too long a step, and too few waves for the duration."""
    waves = random_waves(jonswap(3.0, 8.0), 3, np.random.default_rng(1))
    history = run_dynamics(
        CHAIN, TimeStepping(600.0, 0.4, ramp_time=8.0, output_interval=4.0), height=80.0,
        span=280.0, motion=Harmonic(6.0, (0.3, 0.0, 0.0)), properties=WET, sea=Sea(90.0, waves),
        elements=10,
    )  # fmt: skip
    text = "\n".join(history.warnings)
    assert (
        "the step of 0.4 s gives 15 steps in the shortest period of the motion or force, 6 s"
        in text
    )
    assert "waves" in text
    assert history.time.size == 151


def test_a_step_that_does_not_close_is_named() -> None:
    """One iteration, no halving, and a fairlead in haste: time, node and force are said."""
    controls = StepControls(tolerance=1e-11, max_iterations=1, max_halvings=1)
    with pytest.raises(
        NotConvergedError, match=r"at t = .* s did not converge: .* node \d+ of line 1"
    ):
        run_dynamics(
            CHAIN, TimeStepping(10.0, 0.2, 4.0, controls=controls), height=80.0, span=280.0,
            motion=Harmonic(4.0, (3.0, 0.0, 0.0)), properties=WET, elements=20,
        )  # fmt: skip


@pytest.fixture
def heeds_ctrl_c() -> Iterator[None]:
    """Let Ctrl-C interrupt, also where the tests were started in the background."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.skipif(sys.platform == "win32", reason="a process cannot send itself Ctrl-C there")
@pytest.mark.usefixtures("heeds_ctrl_c")
def test_ctrl_c_waits_for_the_end_of_a_piece_and_stops_there() -> None:
    """An exception where compiled code takes over its arguments would end the process."""
    pressed_at: list[float] = []

    def press(t: float) -> None:
        if t > 3.0 and not pressed_at:
            pressed_at.append(t)
            assert signal.getsignal(signal.SIGINT) is not signal.default_int_handler
            os.kill(os.getpid(), signal.SIGINT)

    before = signal.getsignal(signal.SIGINT)
    history = run_dynamics(
        CHAIN, TimeStepping(1e5, 0.1, ramp_time=8.0), height=80.0, span=280.0,
        motion=Harmonic(8.0, (1.0, 0.0, 0.0)), properties=WET, elements=20, progress=press,
    )  # fmt: skip
    assert signal.getsignal(signal.SIGINT) is before
    assert not history.is_complete
    assert history.time[-1] == pytest.approx(pressed_at[0])


def test_the_digits_do_not_hang_on_how_fast_the_machine_is(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A run is computed in pieces, as long as the machine does them in a tenth of a second."""
    monkeypatch.setenv("CATOPT_COMPILE", "never")
    tensions = []
    for piece in (0.0, math.inf):
        monkeypatch.setattr("catopt.fem.simulation._PIECE", piece)
        history = run_dynamics(
            CHAIN, TimeStepping(4.0, 0.2, ramp_time=2.0), height=80.0, span=280.0,
            motion=Harmonic(8.0, (1.0, 0.0, 0.0)), properties=WET, elements=20,
        )  # fmt: skip
        tensions.append(history.fairlead_tension)
    assert np.array_equal(tensions[0], tensions[1])


def test_interruption_keeps_what_was_computed() -> None:
    """Ctrl-C, as it comes out of the call that reports progress."""
    reached = []

    def stop(t: float) -> None:
        reached.append(t)
        if t > 3.0:
            raise KeyboardInterrupt

    stepping = TimeStepping(1e5, 0.1, ramp_time=8.0)
    motion = Harmonic(8.0, (1.0, 0.0, 0.0))
    history = run_dynamics(
        CHAIN, stepping, height=80.0, span=280.0, motion=motion, properties=WET, elements=20,
        progress=stop,
    )  # fmt: skip
    assert not history.is_complete
    assert history.time[-1] == pytest.approx(reached[-1])
    assert history.fairlead_tension.shape[0] == history.time.size
    assert (history.fairlead_tension > 0.0).all()
    assert "stopped at" in history.warnings[-1]


def test_thinned_samples_are_those_of_every_step() -> None:
    """Samples of every fifth step are the same numbers; envelopes see all steps."""
    motion = Harmonic(8.0, (1.0, 0.0, 0.0))
    every, thinned = (
        run_dynamics(
            CHAIN,
            TimeStepping(20.0, 0.1, ramp_time=8.0, output_interval=interval),
            height=80.0,
            span=280.0,
            motion=motion,
            properties=WET,
            elements=20,
        )
        for interval in (0.1, 0.5)
    )
    assert np.array_equal(every.fairlead_tension[::5], thinned.fairlead_tension)
    assert np.array_equal(every.max_tension, thinned.max_tension)
    assert every.line_max_tension() >= every.bar_tension[every.counted].max()
    peak = every.tension_statistics().maximum
    assert every.dynamic_amplification(0.5 * peak) == pytest.approx(2.0)


@pytest.mark.slow
def test_three_hours_of_storm() -> None:
    """200 waves and a fairlead that follows them on one line: minutes, and thinned samples."""
    waves = random_waves(jonswap(8.0, 12.0), 200, np.random.default_rng(2), direction=math.pi)
    amplitude = np.zeros((200, 3))
    amplitude[:, 0] = 0.5 * waves.amplitude
    motion = Harmonic(tuple(2.0 * math.pi / waves.omega), amplitude)
    history = run_dynamics(
        CHAIN, TimeStepping(10800.0, 0.1, ramp_time=60.0, output_interval=0.5), height=80.0,
        span=275.0, motion=motion, properties=WET, sea=Sea(90.0, waves), elements=40,
    )  # fmt: skip
    assert history.time.size == 21601
    statistics = history.tension_statistics()
    assert statistics.peaks > 500
    tension = history.fairlead_tension[history.counted, 0]
    tail = weibull_tail([tension], statistics.duration, statistics.duration)
    assert tail is not None
    # The largest of a storm lies within a few of Gumbel's scales of the most probable one.
    extreme = tail.extreme
    spread = (extreme.expected - extreme.most_probable) / 0.5772
    assert abs(statistics.maximum - extreme.most_probable) < 4.0 * spread
