"""The sea of a line in motion: recorded, of several trains, short-crested."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catopt.answers.note_motion import drive_facts
from catopt.errors import InputError
from catopt.model import CurrentProfile, Motion, WaveState, WaveTrain
from catopt.notes.motion import InMotion
from catopt.render.values import as_text
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicVerification
from catopt.verify.dynamic_setup import Excitation, read_drive
from catopt.waves import repetition_warning
from catopt.words import Language, Message, say

from .test_dynamic import chain, run

SWELL = WaveTrain("jonswap", 1.2, 14.0, 5.0, direction=-2.4, components=40)
WIND_SEA = WaveTrain("jonswap", 2.5, 7.0, direction=math.pi, components=60, spreading_exponent=3.0)


def written(folder: Path, eta: Any, step: float = 0.5, head: str = "time (s),elevation (m)") -> str:
    path = folder / "elevation.csv"
    rows = "\n".join(f"{step * k:.4f},{value:.12f}" for k, value in enumerate(eta))
    path.write_text(f"# made up\n{head}\n{rows}\n", encoding="utf-8")
    return str(path)


def of_a_wave(length: float, T: float = 8.0, a: float = 1.0, step: float = 0.5) -> Any:
    return a * np.cos(2.0 * math.pi / T * step * np.arange(round(length / step)))


def test_a_recorded_regular_wave_moves_the_line_as_the_regular_wave(tmp_path: Path) -> None:
    """Once by its height and once by 80 s of samples, which have 12 decimals in the file."""
    path = written(tmp_path, of_a_wave(80.0))
    recorded = chain(None, 40.0, waves=WaveState(elevation_file=path), time_step=0.1)
    regular = chain(None, 40.0, waves=WaveState("regular", 2.0, 8.0), time_step=0.1)
    a, b = (run(case).runs[0].history.fairlead_tension for case in (recorded, regular))
    assert np.abs(a / b - 1.0).max() < 1e-9
    assert np.ptp(b) > 100.0


def test_the_surface_at_its_place_is_the_record(tmp_path: Path) -> None:
    """At x = 90 m, of waves that go towards the anchor; centimetres and minutes in the file."""
    eta = np.random.default_rng(5).normal(0.0, 1.0, 121)
    path = written(tmp_path, 100.0 * eta, 0.5 / 60.0, "time (min),elevation (cm)")
    text = Path(path).read_text("utf-8")
    rows = [f"{0.5 * k / 60.0!r},{100.0 * float(v)!r}" for k, v in enumerate(eta)]
    Path(path).write_text("\n".join([*text.splitlines()[:2], *rows]), encoding="utf-8")
    state = WaveState(elevation_file=path, elevation_x=90.0, direction=math.pi, shortest_period=1.0)
    drive = read_drive(chain(None, 60.0, waves=state))
    sea = drive.sea(0)
    found = sea.elevation(0.5 * np.arange(121), 90.0)
    # Rounding of the sum, and of the phases k x, up to 250 rad.
    assert np.abs(found - (eta - eta.mean())).max() < 1e-11
    assert (drive.is_random, sea.waves is not None and sea.waves.repeats_after) == (False, 60.5)


def test_what_was_done_to_the_record_is_remarked_on(tmp_path: Path) -> None:
    path = written(tmp_path, 3.0 + of_a_wave(40.0))
    part = run(chain(None, 16.0, waves=WaveState(elevation_file=path), time_step=0.2))
    assert (
        "the waves are the 5 of the recorded surface with periods down to 8 s; 0.00% of its "
        "variance is left out, and its mean of 3 m is subtracted"
    ) in part.remarks
    assert part.of("fairlead_tension").most_probable_maximum is None


@pytest.mark.parametrize(
    ("head", "length", "message"),
    [
        ("time (s),elevation (m)", 30.0, "time: found 29.5 s from the first row to the last; the"),
        ("time,elevation (m)", 80.0, "headings: found time; its unit in brackets is required"),
        ("time (s),height (m)", 80.0, "found height \\(m\\); one of time, elevation is required"),
        ("time (s),elevation (s)", 80.0, r"found elevation \(s\); its unit in brackets"),
    ],
)
def test_a_wrong_record_is_refused(head: str, length: float, message: str, tmp_path: Path) -> None:
    path = written(tmp_path, of_a_wave(length), head=head)
    with pytest.raises(InputError, match=message):
        verify_dynamic(chain(None, 60.0, waves=WaveState(elevation_file=path)))


def test_runs_of_a_record_are_refused(tmp_path: Path) -> None:
    waves = WaveState(elevation_file=written(tmp_path, of_a_wave(80.0)))
    with pytest.raises(InputError, match=r"dynamics.runs: found 3; without a random sea all runs"):
        verify_dynamic(chain(None, 60.0, waves=waves, runs=3))


def listed(drive: Excitation, language: Language = "en") -> list[tuple[str, str]]:
    """List what a note has as driving the line."""
    moved = InMotion(DynamicVerification(drive.case, (), True), drive, (), ())
    return [
        (say(each.name, language), say(as_text(each.value, each.quantity, unit=True), language))
        for each in drive_facts(moved)
    ]


def test_a_note_lists_the_record(tmp_path: Path) -> None:
    waves = WaveState(elevation_file=written(tmp_path, of_a_wave(80.0)), elevation_x=90.0)
    drive = read_drive(chain(None, 60.0, waves=waves))
    assert listed(drive) == [
        ("Waves", "surface as recorded in elevation.csv"),
        ("Length of the recorded surface", "79.5 s"),
        ("Recorded at, along x from the anchor", "90 m"),
        ("Significant wave height Hs", "2.828 m"),
        ("Waves travel towards (from the axis anchor to fairlead)", "0 deg"),
        ("Regular waves that make up the sea", "10"),
        ("Shortest period kept", "8 s"),
        ("Part of the variance left out", "0.00 %"),
        ("Mean level subtracted", "0 m"),
        ("Water kinematics above still water", "as at still water"),
    ]
    assert all(isinstance(remark, Message) for remark in drive.remarks)
    in_vietnamese = listed(drive, "vi")
    assert all(a[0] != b[0] for a, b in zip(listed(drive), in_vietnamese, strict=True))


def test_evened_times_are_remarked_on(tmp_path: Path) -> None:
    path = written(tmp_path, of_a_wave(80.0))
    lines = Path(path).read_text("utf-8").splitlines()
    del lines[40]
    Path(path).write_text("\n".join(lines), encoding="utf-8")
    drive = read_drive(chain(None, 60.0, waves=WaveState(elevation_file=path)))
    # 159 rows over 79.5 s.
    said = (
        "the times of the recorded surface are not evenly spaced: it was interpolated linearly at "
        "steps of 0.5032 s"
    )
    assert said in drive.remarks
    repeated = repetition_warning(drive.recorded_waves, 100.0)
    assert repeated is not None
    found = next(each for each in drive.remarks if each == said)
    assert all(say(each, "vi") != each for each in (found, repeated))


def test_a_note_lists_every_train() -> None:
    drive = Excitation(chain(None, waves=WaveState(trains=(WIND_SEA, SWELL))))
    rows = listed(drive)
    assert [text for name, text in rows if name.startswith("Significant")] == ["2.5 m", "1.2 m"]
    assert ("Spreading over the direction", "cos^3 of the angle, 20 directions") in rows
    assert ("Seeds of the runs", "(1, 0)") in rows


def test_trains_add_up_and_the_first_is_what_it_is_alone() -> None:
    both = Excitation(chain(None, waves=WaveState(trains=(WIND_SEA, SWELL)))).sea(1).waves
    alone = Excitation(chain(None, waves=WaveState(trains=(WIND_SEA,)))).sea(1).waves
    assert both is not None
    assert alone is not None
    assert both.omega[:60].tobytes() == alone.omega.tobytes()
    assert both.significant_height == pytest.approx(math.hypot(2.5, 1.2), rel=1e-3)  # 0.1 % left
    assert set(both.direction[60:]) == {-2.4}
    assert np.unique(both.direction[:60]).size == 20


def test_the_step_follows_the_fastest_of_the_energy() -> None:
    """A sixtieth of the period that 99 % of the energy is slower than, over trains of any size."""
    drive = Excitation(chain(None, waves=WaveState(trains=(WIND_SEA, SWELL))))
    sea = drive.sea(0)
    assert sea.waves is not None
    period = 60.0 * drive.stepping(sea, []).step
    faster = sea.waves.omega > 2.0 * math.pi / period * (1.0 + 1e-9)
    energy = sea.waves.amplitude**2
    # One wave in sixty of the wind sea holds 1.4 % of the whole.
    assert energy[faster].sum() / energy.sum() == pytest.approx(0.01, abs=0.014)
    alone = Excitation(chain(None, waves=WaveState("jonswap", 2.0, 8.0, components=50)))
    found = alone.sea(0).waves
    assert found is not None
    expected = 2.0 * math.pi / np.quantile(found.omega, 0.99) / 60.0
    assert alone.stepping(alone.sea(0), []).step == pytest.approx(float(expected), rel=1e-9)


def test_a_line_in_a_wind_sea_and_a_swell_runs() -> None:
    waves = WaveState(trains=(WIND_SEA, SWELL))
    part = run(chain(None, 20.0, waves=waves, time_step=0.2, elements=20))
    assert part.drive.is_random
    assert np.ptp(part.runs[0].history.fairlead_force[:, 0, 1]) > 10.0  # waves from the side


TURNING = CurrentProfile(
    "table", depths=(0.0, 20.0), speeds=(1.0, 0.5), directions=(0.5 * math.pi, math.pi)
)


def series(folder: Path, rows: str, head: str = "time (min),speed (m/s),direction (deg)") -> str:
    path = folder / "current.csv"
    path.write_text(f"{head}\n{rows}\n", encoding="utf-8")
    return str(path)


def test_a_steady_series_is_the_steady_current(tmp_path: Path) -> None:
    """One row a start and one an end, alike: the same run to rounding."""
    file = series(tmp_path, "0,0.8,90\n1,0.8,90")
    over_time = CurrentProfile("power", series_file=file)
    steady = CurrentProfile("power", speed=0.8, direction=0.5 * math.pi)
    motion = Motion(period=8.0, surge=0.1)
    a, b = (
        run(chain(motion, 16.0, current=each, time_step=0.1)).runs[0].history.fairlead_force
        for each in (over_time, steady)
    )
    assert np.abs(a - b).max() < 1e-6 * np.abs(b).max()
    assert abs(b[0, 0, 1]) > 100.0


def test_a_slow_series_takes_the_line_from_one_rest_to_another(tmp_path: Path) -> None:
    """From still water to 1 m/s across in 400 s: then as in a steady current, but for its drag.

    Of the side force the rate of 2.5 mm/s² leaves inertia, below a hundredth.
    """
    file = series(tmp_path, "0,0,90\n400,1,90\n500,1,90", "time (s),speed (m/s),direction (deg)")
    motion = Motion(period=100.0, surge=0.01)
    settings = {"time_step": 0.5, "elements": 20}
    grown = run(chain(motion, 480.0, current=CurrentProfile("power", series_file=file), **settings))
    steady = CurrentProfile("power", speed=1.0, direction=0.5 * math.pi)
    still = run(chain(motion, 10.0, current=steady, **settings))
    side = grown.runs[0].history.fairlead_force[:, 0, 1]
    assert abs(side[0]) < 1e-3 * abs(side[-1])
    assert side[-1] == pytest.approx(still.runs[0].history.fairlead_force[0, 0, 1], rel=0.01)


def test_a_current_that_turns_pushes_both_ways() -> None:
    """Across at the surface, back along the line at the bed."""
    drive = Excitation(chain(Motion(period=8.0, surge=0.1), current=TURNING))
    u = drive.sea(0).kinematics(0.0, [[0.0, 0.0, 20.0], [0.0, 0.0, 10.0], [0.0, 0.0, 0.0]])
    wanted = [[0.0, 1.0, 0.0], [-0.25, 0.5, 0.0], [-0.5, 0.0, 0.0]]
    np.testing.assert_allclose(u.velocity, wanted, atol=1e-15)
    assert listed(drive) == [
        ("Current", "table over the depth"),
        ("Speeds by depth", "1 m/s at 0 m; 0.5 m/s at 20 m"),
        ("Directions by depth", "90° at 0 m; 180° at 20 m"),
        ("Motion of the fairlead", "harmonic, a cos(2πt/T + phase)"),
        ("Period of the motion", "8 s"),
        ("Surge: amplitude", "0.1 m"),
        ("Surge: phase", "0 deg"),
    ]


def test_a_note_lists_the_series(tmp_path: Path) -> None:
    file = series(tmp_path, "0,0.2,170\n1,0.9,185")
    case = chain(None, current=replace(TURNING, series_file=file), waves=WaveState(trains=(SWELL,)))
    rows = listed(read_drive(case))
    expected = [
        ("Current at the surface over time",
         "as in current.csv, by which the profile is scaled and turned"),
        ("Its speeds", "0.2 … 0.9 m/s"),
        ("Its directions", "170° … 185°"),
    ]  # fmt: skip
    assert [row for row in rows if row in expected] == expected
    assert len(listed(read_drive(case), "vi")) == len(rows)


@pytest.mark.parametrize(
    ("rows", "head", "message"),
    [
        ("0,1,0\n0.5,1,0", "time (min),speed (m/s),direction (deg)", "found 30 s from the first"),
        ("0,1\n2,1", "time (min),speed", "found speed; its unit in brackets is required"),
        ("0,1\n2,1", "time (min),direction (deg)", "headings: speed is missing"),
        ("0,1\n0,1", "time (min),speed (kn)", "found 0 s after 0 s; must rise"),
        ("0,1,0\n2,1,0", "time (min),speed (kn),direction (rad)", "current.direction: found 57"),
    ],
)
def test_a_wrong_series_is_refused(rows: str, head: str, message: str, tmp_path: Path) -> None:
    current = CurrentProfile("power", direction=1.0, series_file=series(tmp_path, rows, head))
    with pytest.raises(InputError, match=message):
        verify_dynamic(chain(Motion(period=8.0, surge=0.1), current=current))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"directions": (0.0,)}, "2 depths, 1 directions"),
        ({"directions": (0.0, 1.6)}, "a turn of 91.67 deg; more than a right angle"),
        ({"directions": (-3.0, 3.0), "direction": 0.1}, "direction: found 0.1; goes with one"),
        ({"speeds": (-1.0, 1.0)}, r"speeds\[0\]: found -1.0; must be 0 m/s or more"),
        ({"speeds": (0.0, 1.0), "series_file": "c.csv"}, "scales the table by its first speed"),
        ({"profile": "power", "depths": (), "speeds": (), "directions": (), "speed": 1.0,
          "series_file": "c.csv"}, "speed: found 1.0; is given in the series_file; leave it out"),
        ({"profile": "wind", "depths": (), "speeds": (), "depth": 3.0, "speed": 1.0},
         "not applicable to the profile wind"),
    ],
)  # fmt: skip
def test_a_current_that_contradicts_itself_is_refused(
    changes: dict[str, Any], message: str
) -> None:
    with pytest.raises(InputError, match=message):
        replace(TURNING, **changes)
