"""Linear motion beside the run in time of the same model in the same waves."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import catopt
from catopt.errors import InputError
from catopt.fem import LineProperties, MorisonSection, TimeStepping, run_dynamics
from catopt.fem.dynamics import line_at_rest
from catopt.fem.linear_model import linear_model
from catopt.fem.linear_motion import LinearMotion, linear_motion
from catopt.fem.mesh import mesh_line
from catopt.fem.seabed import Seabed
from catopt.fem.series import Harmonic
from catopt.model import Case, Line, Motion, Segment, WaveState
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_lines import OneLine, lines_at_rest
from catopt.verify.dynamic_setup import read_drive
from catopt.verify.linear import linear_lines
from catopt.waves import PowerLawCurrent, Sea, Waves

CHAIN = Path(__file__).parents[2] / "cases" / "dynamic-chain-56m" / "case.toml"
LINE = Line([Segment(200.0, 900.0, EA=4e8, mass=110.0)])
PLACE: Any = {"height": 40.0, "horizontal_force": 8e5}


def wave(amplitude: float, omega: float = 0.8) -> Waves:
    return Waves(
        np.array([amplitude]), np.array([omega]), np.array([0.3]), np.array([math.radians(20.0)])
    )


def both(
    amplitude: float,
    properties: LineProperties,
    *,
    line: Line = LINE,
    place: Any = PLACE,
    currents: tuple[PowerLawCurrent, ...] = (),
) -> tuple[LinearMotion, np.ndarray]:
    """Linear motion of a led line in one wave, and its tension in time after the ramp."""
    period = 2.0 * math.pi / 0.8
    motion = Harmonic(period, (amplitude, 0.3 * amplitude, 0.7 * amplitude), (0.2, -0.4, 1.1))
    sea = Sea(60.0, wave(amplitude), currents)
    mesh = mesh_line(line, 30)
    rest = line_at_rest(mesh, properties=properties, sea=replace(sea, waves=None), **place)
    found = linear_motion(linear_model(rest), sea, motion.amplitudes[np.newaxis])
    stepping = TimeStepping(12.0 * period, period / 400.0, ramp_time=6.0 * period)
    history = run_dynamics(
        line, stepping, motion=motion, properties=properties, sea=sea, mesh=mesh, **place
    )
    time = history.time[history.counted]
    assert found.series(time).shape == (time.size, 30)
    return found, np.stack([time, history.bar_tension[history.counted, 0, 1]])


@pytest.mark.slow
def test_a_small_motion_without_drag_is_linear() -> None:
    """Amplitude and phase, off the bed: to what is left of how the run set off."""
    section = MorisonSection(0.12, 0.0, added_mass_normal=1.0)
    found, (time, tension) = both(0.002, LineProperties([section], seabed=Seabed(friction=0.0)))
    ours = found.series(time)[:, -1]
    assert found.deviation[-1] > 10.0
    assert np.abs(ours - tension).max() < 0.01 * np.ptp(tension)
    assert found.zero_crossing_period[-1] == pytest.approx(2.0 * math.pi / 0.8)


@pytest.mark.slow
@pytest.mark.parametrize("exponent", [1e-9, 1.0], ids=["even", "sheared"])
def test_in_a_current_drag_goes_with_the_line(exponent: float) -> None:
    """Amplitude and phase to 1 %: steady drag turns with the bars, and grows as they rise.

    Without that they were off by 3 and 5 %.
    """
    section = MorisonSection(0.05, 1.2, 0.1, added_mass_normal=1.0)
    properties = LineProperties([section], seabed=Seabed(friction=0.0))
    currents = (PowerLawCurrent(1.5, direction=1.0, exponent=exponent),)
    line, place = Line([Segment(70.0, 170.0, EA=5e7, mass=18.0)]), {"height": 40.0, "span": 50.0}
    found, (time, tension) = both(0.002, properties, line=line, place=place, currents=currents)
    assert np.abs(found.series(time)[:, -1] - tension).max() < 0.01 * np.ptp(tension)


def test_drag_hangs_on_the_size_of_the_motion() -> None:
    """Twice the motion has more than twice the tension, in time and here: both by as much."""
    section = MorisonSection(0.12, 2.0, added_mass_normal=1.0)
    properties = LineProperties([section], seabed=Seabed(friction=0.0))
    small, (_, slow) = both(0.25, properties)
    large, (_, fast) = both(0.5, properties)
    ours = large.deviation[-1] / small.deviation[-1]
    assert ours > 2.2
    assert ours == pytest.approx(fast.std() / slow.std(), rel=0.05)


def in_sea(height: float, period: float, duration: float) -> Case:
    case: catopt.Case = catopt.read_case(CHAIN)
    assert case.waves is not None
    assert case.dynamics is not None
    waves = replace(case.waves, height=height, period=period)
    return replace(case, waves=waves, dynamics=replace(case.dynamics, duration=duration))


@pytest.mark.slow
@pytest.mark.parametrize(("height", "period"), [(1.0, 8.0), (2.0, 11.0), (3.0, 9.5), (4.0, 12.5)])
def test_the_deviation_is_that_of_a_run_in_time(height: float, period: float) -> None:
    """Within 5 % over the same half hour; twenty sea states: benchmarks/results/linear.md."""
    case = in_sea(height, period, 1800.0)
    drive = read_drive(case)
    lines, sea = lines_at_rest(drive), drive.sea(0)
    assert isinstance(lines, OneLine)
    motion = drive.motion(sea, lines.span)
    assert isinstance(motion, Harmonic)
    model = linear_model(lines.simulation())
    found = linear_motion(model, sea, motion.amplitudes[np.newaxis])
    (part,) = verify_dynamic(
        case, convergence_check="none", workers=1, compares_at_rest=False
    ).parts
    history = part.runs[0].history
    at = history.counted
    assert part.slack_time == 0.0
    ours = found.series(history.time[at])[:, -1].std()
    assert ours == pytest.approx(history.bar_tension[at, 0, 1].std(), rel=0.05)


def test_the_lines_of_a_case() -> None:
    """Rising seas: more tension, less reserve, and the word where a line may go slack."""
    found = [linear_lines(in_sea(height, 9.0, 60.0))[0] for height in (1.0, 3.0, 6.0)]
    small, _, large = found
    assert [each.deviation for each in found] == sorted(each.deviation for each in found)
    assert small.holds
    assert not large.holds
    assert small.mean == large.mean
    storm = small.mean + small.deviation * math.sqrt(2.0 * math.log(3600.0 / small.period))
    assert small.most_probable(3600.0) == pytest.approx(storm)


def test_what_has_no_linear_form_is_refused_with_all_of_it() -> None:
    case = in_sea(2.0, 9.0, 60.0)
    case = replace(case, waves=WaveState("regular", 1.0, 8.0), motion=Motion(surge=0.5, period=8.0))
    with pytest.raises(InputError) as refused:
        linear_lines(case)
    assert [each.key for each in refused.value.problems] == ["waves", "motion"]
