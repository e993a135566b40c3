"""What comes and goes between two samples is in every figure."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from catopt.casefile import read_case
from catopt.checks.fatigue import count_cycles
from catopt.fem.extremes import FOLLOWED, STATE, course_of, follow, peaks_above_mean
from catopt.model import Case, Dynamics, Line, Load, Motion, Segment, Site, WaveState
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicPart

CASES = Path(__file__).parents[2] / "cases"


@pytest.fixture(scope="module")
def raos(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Give the response of a buoy that follows the waves."""
    path = tmp_path_factory.mktemp("peaks") / "rao.csv"
    path.write_text(
        "period,surge,surge_phase,heave,heave_phase\n3,0.8,90,0.9,0\n6,1,90,1,0\n12,1.1,90,1,0\n",
        encoding="utf-8",
    )
    return path


@cache
def snapping(raos: Path, interval: float | None) -> DynamicPart:
    """60 m of 38 mm chain, led by a buoy in a random sea, with which it snaps."""
    segment = Segment(
        60.0, 245.0, EA=1.23e8, mass=28.8, drag_diameter=0.038, drag_normal=2.4, drag_axial=0.366,
        added_mass_normal=1.0, added_mass_axial=0.5,
    )  # fmt: skip
    case = Case(
        site=Site(20.0, seabed_friction=0.5),
        line=Line([segment]),
        fairlead_height=20.0,
        load=Load(horizontal_force=20e3),
        waves=WaveState("jonswap", 3.0, 7.0, components=60, direction=math.pi),
        motion=Motion(rao_file=str(raos)),
        dynamics=Dynamics(280.0, ramp=20.0, output_interval=interval, elements=30),
    )
    (part,) = verify_dynamic(case, convergence_check="none").parts
    return part


@pytest.mark.parametrize("interval", [0.042, 0.5, 2.0])
def test_any_output_interval_gives_the_same_figures(raos: Path, interval: float) -> None:
    """Nothing but the samples hangs on it: the same steps, to the last digit."""
    often, seldom = snapping(raos, None), snapping(raos, interval)
    assert seldom.slack_time > 0.0
    for one, other in zip(often.quantities, seldom.quantities, strict=True):
        assert one == other
    first, second = (each.runs[0].history for each in (often, seldom))
    for quantity in FOLLOWED:
        assert np.array_equal(first.course(quantity).value, second.course(quantity).value)


def test_the_most_probable_maximum_is_not_below_the_largest_of_the_run(raos: Path) -> None:
    part = snapping(raos, 2.0)
    fairlead = part.of("fairlead_tension")
    sampled = part.runs[0].history.fairlead_tension[part.runs[0].counted, 0]
    assert fairlead.maximum > 1.1 * sampled.max()  # the samples miss the snap
    assert fairlead.maximum == part.runs[0].history.max_end_force[0, 1]
    assert fairlead.most_probable_maximum is not None
    assert fairlead.most_probable_maximum >= fairlead.maximum


def _followed(values: np.ndarray, step: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    state, turns = np.zeros((1, STATE)), np.zeros((1, values.size, 2))
    count = np.zeros(1, dtype=np.int64)
    for k, value in enumerate(values):
        follow(0, k * step, float(value), state, turns, count)
    return state[0], turns[0], count


def test_turning_points_have_the_peaks_and_the_cycles_of_the_series() -> None:
    draw = np.random.default_rng(7)
    values = 5.0 + np.convolve(draw.standard_normal(4000), np.ones(9) / 9.0, mode="same")
    state, turns, count = _followed(values, 0.1)
    course = course_of(state, turns, int(count[0]))
    assert course.value.size < 0.6 * values.size
    assert course.mean == pytest.approx(np.trapezoid(values, dx=0.1) / 399.9, rel=1e-12)
    square = np.trapezoid((values - course.mean) ** 2, dx=0.1) / 399.9
    assert course.std == pytest.approx(math.sqrt(square), rel=1e-9)
    assert (course.maximum, course.minimum) == (values.max(), values.min())
    assert course.time_of_maximum == pytest.approx(0.1 * values.argmax())
    peaks = peaks_above_mean(values, course.mean)
    assert peaks_above_mean(course.value, course.mean).tolist() == peaks.tolist()
    # Miner's sum with slope 3: ranges below the least turn are all that differs.
    one, other = (count_cycles(each, 1.0) for each in (values, course.value))
    sums = [float(np.sum(each.counts * each.ranges**3)) for each in (one, other)]
    assert sums[1] == pytest.approx(sums[0], rel=1e-5)


def test_nothing_followed_has_no_statistics() -> None:
    course = course_of(np.zeros(STATE), np.zeros((4, 2)), 0)
    assert course.duration == 0.0
    assert math.isnan(course.maximum)


_SHIPPED = sorted(
    path
    for path in CASES.glob("*/*.toml")
    if "[dynamics]" in (text := path.read_text(encoding="utf-8"))
    and not any(header in text for header in ("[[lines", "[floater.ship]"))
)


@pytest.mark.slow
@pytest.mark.parametrize("path", _SHIPPED, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_no_sample_is_above_the_largest_of_every_step(path: Path) -> None:
    """In every shipped case that is run in time, for its first minute."""
    case = read_case(path)
    assert case.dynamics is not None
    given = case.dynamics
    short = min(given.duration, 60.0)
    ramp = None if given.ramp is None else min(given.ramp, 0.5 * short)
    dynamics = replace(
        given, duration=short, ramp=ramp, runs=1, broken_line=None, broken_at=None,
        broken_end="fairlead",
    )  # fmt: skip
    found = verify_dynamic(replace(case, dynamics=dynamics), convergence_check="none")
    for part in found.parts:
        history = part.runs[0].history
        at = history.counted
        for k, tension in enumerate((history.anchor_tension, history.fairlead_tension)):
            # The sums of squares are taken in another order.
            assert tension[at, 0].max() <= history.max_end_force[0, k] * (1.0 + 1e-12)
