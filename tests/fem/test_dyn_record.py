"""What a recorded motion asks of the step: its own periods, not how densely it was sampled."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import catopt
from catopt.errors import InputError
from catopt.fem import LineDamping, LineProperties, Sampled, Seabed, TimeStepping, run_dynamics

CHAIN = catopt.Line([catopt.Segment(length=300.0, submerged_weight=1000.0, EA=5e8, mass=117.0)])
PROPERTIES = LineProperties(damping=LineDamping(critical_ratio=1.0), seabed=Seabed(1e5))


def sine(period: float, every: float, duration: float = 120.0, amplitude: float = 2.0) -> Sampled:
    """Sample a motion that begins at its mean."""
    t = np.arange(0.0, duration + 0.5 * every, every)
    return Sampled(t, np.outer(np.sin(2.0 * math.pi * t / period), [amplitude, 0.0, 0.0]))


def is_about(found: float, period: float, duration: float) -> bool:
    """Whether it is the period but for the width of a wave's line in a spectrum of the record.

    Under Hann's window a sine is off by one line between lines, and has 0.04 % two and a half away.
    """
    lines = duration / period
    return duration / (lines + 2.0) <= found <= duration / (lines - 1.0)


@pytest.mark.parametrize("every", [0.05, 0.1, 0.5])
@pytest.mark.parametrize("period", [9.0, 27.0])
def test_a_sine_has_its_own_period_however_it_is_sampled(period: float, every: float) -> None:
    assert is_about(sine(period, every).shortest_period, period, 120.0)


def test_the_period_is_the_one_that_99_percent_of_the_acceleration_exceeds() -> None:
    """Two sines, the faster with 2 % and then with 0.5 % of the acceleration's variance."""
    t = np.arange(0.0, 600.01, 0.1)
    slow, fast = 12.0, 3.0
    for part, wanted in ((0.02, fast), (0.005, slow)):
        sizes = [math.sqrt(1.0 - part) * slow**2, math.sqrt(part) * fast**2]
        x = sizes[0] * np.sin(2 * math.pi * t / slow) + sizes[1] * np.sin(2 * math.pi * t / fast)
        found = Sampled(t, np.outer(x, [0.0, 0.0, 1.0])).shortest_period
        assert is_about(found, wanted, 600.0)


def test_the_axis_that_moves_fastest_counts_by_its_acceleration() -> None:
    """0.5 and 5 % of the amplitude at a third of the period: 0.2 and 17 % of the variance."""
    t = np.arange(0.0, 600.01, 0.1)
    x, z = np.sin(2 * math.pi * t / 9.0), np.sin(2 * math.pi * t / 3.0)
    for size, wanted in ((0.005, 9.0), (0.05, 3.0)):
        motion = Sampled(t, np.stack([x, 0.0 * t, size * z], axis=1))
        assert is_about(motion.shortest_period, wanted, 600.0)


def test_a_record_that_stands_or_goes_steadily_has_no_short_period() -> None:
    t = np.arange(0.0, 50.01, 0.1)
    for x in (0.0 * t, 0.3 + 0.01 * t):
        assert Sampled(t, np.outer(x, [1.0, 0.0, 0.0])).shortest_period == pytest.approx(50.0)


def test_unequal_steps_are_allowed() -> None:
    rng = np.random.default_rng(3)
    t = np.cumsum(rng.uniform(0.05, 0.15, 1200))
    motion = Sampled(t, np.outer(np.sin(2 * math.pi * t / 9.0), [1.0, 0.0, 0.0]))
    assert is_about(motion.shortest_period, 9.0, float(t[-1] - t[0]))


def run(motion: Sampled, step: float, ramp: float = 5.0, **how: Any) -> Any:
    stepping = TimeStepping(how.pop("duration", 20.0), step, ramp_time=ramp)
    return run_dynamics(
        CHAIN, stepping, height=80.0, span=280.0, motion=motion, properties=PROPERTIES,
        elements=10,
    )  # fmt: skip


def test_a_slow_motion_finely_sampled_runs_at_the_step_of_its_period() -> None:
    """0.4 s are 1/68 of 27 s; a step of the samples' 0.05 s would be refused above it."""
    history = run(sine(27.0, 0.05), 0.4)
    assert not any("shortest period" in each for each in history.warnings)


def test_a_step_too_long_for_the_record_is_still_refused() -> None:
    with pytest.raises(InputError, match=r"step: found 4 s; .* periods down to"):
        run(sine(9.0, 0.5), 4.0)


def test_samples_that_do_not_resolve_their_acceleration_are_warned_of() -> None:
    """Rounded to cm, samples 0.1 s apart have accelerations of cm/0.01 s2: noise."""
    smooth = sine(27.0, 0.1)
    rough = Sampled(smooth.times, np.round(smooth.values, 2))
    text = "\n".join(run(rough, 0.02, duration=5.0).warnings)
    assert "steps of 0.1 s" in text
    assert "acceleration" in text
    assert not any("acceleration" in each for each in run(smooth, 0.4, duration=5.0).warnings)


def test_a_record_that_sets_off_at_speed_takes_its_line_along() -> None:
    """2 m in 8 s sets off at 2 pi 2/8 = 1.57 m/s: times sqrt(5e8 117), a jump of 380 kN at once.

    The line moves with its end from the first moment: its tension begins where it rests, but for
    what bends and lifts it, and no bar is torn at.
    """
    history = run(sine(8.0, 0.1), 0.1, ramp=0.0)
    rest = run(sine(8.0, 0.1), 0.1, ramp=5.0).fairlead_tension[0, 0]
    assert abs(history.fairlead_tension[0, 0] / rest - 1.0) < 0.01
    assert abs(np.diff(history.fairlead_tension[:6, 0])).max() < 0.1 * 380e3
    assert not any("m/s" in each for each in history.warnings)


def test_a_record_that_begins_elsewhere_is_refused_with_its_distance() -> None:
    t = np.arange(0.0, 30.01, 0.1)
    motion = Sampled(t, np.outer(0.5 * np.cos(2 * math.pi * t / 8.0), [1.0, 0.0, 0.0]))
    with pytest.raises(InputError, match=r"ramp_time: found 0 s; the motion begins 0.5 m away"):
        run(motion, 0.1, ramp=0.0)
