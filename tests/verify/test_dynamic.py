"""Lines in motion against quasi-statics, against the closed form, and against what stops them."""

from __future__ import annotations

import json
import math
from dataclasses import fields, replace
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

from catopt import schemas
from catopt.casefile import parse_case, read_case
from catopt.catenary.solve import solve
from catopt.errors import InputError
from catopt.fem.simulation import Simulation
from catopt.figures.motion import peaks_above
from catopt.model import (
    Case,
    CurrentProfile,
    Dynamics,
    Line,
    Load,
    LoadCase,
    Motion,
    Segment,
    Site,
    WaveState,
)
from catopt.model.dynamics import INITIAL_FRICTION
from catopt.verify.case import verify_case
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
from catopt.verify.dynamic_setup import Excitation, read_drive
from catopt.verify.motion_words import dynamic_sentences
from catopt.waves import Waves
from catopt.words import is_said

EXAMPLE = Path(__file__).parents[2] / "cases" / "dynamic-chain-56m" / "case.toml"

CHAIN = Segment(
    120.0, 1110.0, EA=4.0e8, mass=130.0, drag_diameter=0.076, drag_normal=2.4, drag_axial=0.4,
    added_mass_normal=1.0, added_mass_axial=0.5,
)  # fmt: skip


RUN = {field.name for field in fields(Dynamics)}


def chain(motion: Motion | None, duration: float = 60.0, **changes: Any) -> Case:
    """Build a chain in 20 m of water; changes are of its run or of the case."""
    of_run = {key: changes.pop(key) for key in list(changes) if key in RUN}
    return replace(
        Case(
            site=Site(20.0, seabed_friction=0.5),
            line=Line([CHAIN]),
            load=Load(horizontal_force=300e3),
            fairlead_height=20.0,
            motion=motion,
            waves=changes.pop("waves", None),
            dynamics=Dynamics(duration, **({"elements": 40, "ramp": duration / 4.0} | of_run)),
        ),
        **changes,
    )


def run(case: Case) -> DynamicPart:
    (part,) = verify_dynamic(case).parts
    return part


MODEL_TEST = """
title = "Lindahl's chain of 33 m"
[site]
water_depth = "3 m"
water_density = 1000
seabed_friction = 0.3
[line]
fairlead_height = "3.3 m"
[[line.segments]]
length = "33 m"
submerged_weight = 0.69958
mass = 0.0818
EA = "10 kN"
drag_diameter = "2.2 mm"
drag_normal = 2.5
drag_axial = 0.5
added_mass_normal = 2.8
[load]
span = "32.554 m"
[motion]
period = "{period} s"
surge = "0.2 m"
heave = "0.2 m"
heave_phase = "90 deg"
[dynamics]
duration = "{duration} s"
ramp = "{ramp} s"
elements = 80
damping_time = 2e-4
"""
"""Lindahl (1984) in Bergdahl, Palm, Eskilsson and Lindahl, J. Mar. Sci. Eng. 3 (2015): fairlead
on a circle of 0.2 m, CM 3.8, internal damping of 2 N s over an EA of 1e4 N."""


def model_test(period: float) -> DynamicPart:
    text = MODEL_TEST.format(period=period, duration=6.0 * period, ramp=2.0 * period)
    return run(parse_case(text))


@pytest.mark.slow
def test_a_model_test_has_its_measured_maximum() -> None:
    """51.4 N were measured at 3.5 s; 3 % is what untuned codes reach (MoorDyn: 52.1 N)."""
    assert model_test(3.5).of("fairlead_tension").maximum == pytest.approx(51.4, rel=0.03)


@pytest.mark.slow  # two models of 33 m of chain, snapping
def test_a_model_test_goes_slack_in_every_cycle_as_measured() -> None:
    history = model_test(1.25).runs[0].history
    tension = history.fairlead_tension[history.counted, 0]
    cycles = np.array_split(tension, 4)  # six periods less two of the ramp
    # Slack: what is left is the weight and inertia of the end bar's half, against 70 N at most.
    assert all(cycle.min() < 0.03 * cycle.max() for cycle in cycles)


@cache
def slow() -> DynamicPart:
    return run(chain(Motion(period=1000.0, surge=0.6, heave=0.3), 1000.0, time_step=0.5))


def test_a_slow_motion_is_quasi_static() -> None:
    """At 1000 s inertia is (1/1000)^2 of what it is at 1 s; 40 bars are off by less than 1 %.

    The closed form is second order away by (L/n)^2, here about 3e-4 of the tension.
    """
    part = slow()
    history = part.runs[0].history
    still = part.runs[0].quasi_static
    assert np.abs(history.fairlead_tension[:, 0] / still - 1.0).max() < 2e-3
    assert part.dynamic_amplification == pytest.approx(1.0, abs=1e-3)
    assert part.slack_time == 0.0


def test_the_quasi_static_tension_is_that_of_a_line_held_there() -> None:
    """Independent of the batch: one closed form for the outermost place."""
    run_ = slow().runs[0]
    at = int(np.nanargmax(run_.quasi_static))
    x, _, z = run_.history.fairlead[at, 0]
    held = solve(Line([CHAIN]), height=float(z), span=float(x), seabed_friction=0.5)
    # Both solve the same equations to rounding.
    assert run_.quasi_static[at] == pytest.approx(held.fairlead.tension, rel=1e-9)


def test_a_fast_motion_of_a_deep_line_is_amplified() -> None:
    """The line's own drag holds it in place, so that it has to stretch."""
    deep = chain(
        Motion(period=6.0, surge=1.0, heave=1.0, heave_phase=math.pi / 2.0),
        site=Site(56.0),
        line=Line([replace(CHAIN, length=300.0)]),
        load=Load(horizontal_force=500e3),
        fairlead_height=56.0,
    )
    assert (run(deep).dynamic_amplification or 0.0) > 1.05
    without = replace(deep, line=Line([replace(CHAIN, length=300.0, drag_normal=0.0,
                                               drag_axial=0.0)]))  # fmt: skip
    assert run(without).dynamic_amplification != run(deep).dynamic_amplification


def test_statistics_are_those_of_the_series() -> None:
    part = slow()
    history = part.runs[0].history
    tension = np.linalg.norm(history.fairlead_force[:, 0], axis=1)[history.time >= 250.0]
    found = part.of("fairlead_tension")
    # Over time, by the trapezium rule: every step is a sample here.
    time = tension.size - 1.0
    mean = np.trapezoid(tension) / time
    assert found.mean == pytest.approx(mean, rel=1e-12)
    square = np.trapezoid((tension - mean) ** 2) / time
    assert found.std == pytest.approx(math.sqrt(square), rel=1e-9)
    assert (found.maximum, found.minimum) == (tension.max(), tension.min())
    assert found.most_probable_maximum is None  # nothing is random
    assert part.of("offset").maximum == pytest.approx(0.6, abs=1e-3)  # the amplitude, sampled


def test_a_recorded_motion_is_the_harmonic_one_it_samples(tmp_path: Path) -> None:
    t = np.arange(0.0, 31.0, 0.1)
    x = 0.6 * np.cos(2.0 * np.pi * t / 8.0)
    rows = "\n".join(f"{a:.6f},{b:.12f}" for a, b in zip(t, x, strict=True))
    (tmp_path / "m.csv").write_text(f"# recorded\nt (s), x (m)\n{rows}\n", encoding="utf-8")
    settings = {"time_step": 0.02}
    recorded = run(chain(Motion(file=str(tmp_path / "m.csv")), 30.0, **settings))
    harmonic = run(chain(Motion(period=8.0, surge=0.6), 30.0, **settings))
    a, b = (each.runs[0].history.fairlead_tension for each in (recorded, harmonic))
    # A cubic spline through 80 points a period is off by (2 pi/80)^4/384 = 1e-7; it starts with
    # another end condition.
    assert np.abs(a / b - 1.0).max() < 1e-4


@pytest.mark.parametrize("every", [0.05, 0.1, 0.5])
def test_the_step_goes_by_the_recorded_motion_not_by_its_sampling(
    every: float, tmp_path: Path
) -> None:
    """9 s at 10 Hz was run at 0.0067 s; a sixtieth of 9 s is 0.15 s."""
    t = np.arange(0.0, 120.0 + 0.5 * every, every)
    x = 0.6 * np.sin(2.0 * np.pi * t / 9.0)
    rows = "\n".join(f"{a:.6f},{b:.12f}" for a, b in zip(t, x, strict=True))
    (tmp_path / "m.csv").write_text(f"t,x\n{rows}\n", encoding="utf-8")
    drive = read_drive(chain(Motion(file=str(tmp_path / "m.csv")), 120.0))
    sea = drive.sea(0)
    # 120 s tell periods apart by one part in 13.
    motion = drive.motion(sea, 110.0)
    assert motion is not None
    assert drive.stepping(sea, [motion]).step == pytest.approx(0.15, rel=2 / 13)


def test_raos_of_one_wave_make_the_harmonic_motion(tmp_path: Path) -> None:
    """The crest passes the fairlead first, and the answer comes by its phase later."""
    (tmp_path / "rao.csv").write_text(
        "period,surge,surge_phase,heave\n4,0.3,90,0.8\n20,0.3,90,0.8\n", encoding="utf-8"
    )
    waves = WaveState("regular", 2.0, 8.0)
    case = chain(Motion(rao_file=str(tmp_path / "rao.csv")), 30.0, waves=waves)
    drive = read_drive(case)
    sea, span = drive.sea(0), 110.0
    motion = drive.motion(sea, span)
    assert motion is not None
    t = 3.7
    k = float(sea.wave_numbers[0])
    omega = 2.0 * math.pi / 8.0
    omega_, *amplitudes = motion.rows[0]  # type: ignore[union-attr]
    cos, sin = math.cos(omega_ * t), math.sin(omega_ * t)
    x, _, z = (amplitudes[i] * cos - amplitudes[3 + i] * sin for i in range(3))
    assert x == pytest.approx(0.3 * math.cos(omega * t - k * span - math.pi / 2.0), abs=1e-12)
    assert z == pytest.approx(0.8 * float(sea.elevation(t, span)), abs=1e-9)


@pytest.mark.parametrize("spreading", [None, 4.0])
def test_raos_without_a_heading_say_so_in_a_spread_sea(
    tmp_path: Path, spreading: float | None
) -> None:
    (tmp_path / "rao.csv").write_text("period,surge\n2,0.1\n30,0.1\n", encoding="utf-8")
    waves = WaveState("jonswap", 1.0, 7.0, components=20, spreading_exponent=spreading)
    motion = Motion(rao_file=str(tmp_path / "rao.csv"))
    case = chain(motion, 4.0, waves=waves, ramp=2.0, elements=10)
    (part,) = verify_dynamic(case, convergence_check="none").parts
    said = [is_said(each, "motion.raos_of_one_heading") for each in part.remarks]
    assert any(said) == (spreading is not None)


@pytest.mark.parametrize("state", INITIAL_FRICTION)
def test_both_bounds_of_the_anchor_by_friction_stand_in_the_answer(state: str) -> None:
    """H = 300 kN, and what lies of 120 m times 0.5 w more or less; bars of 3 m."""
    case = chain(Motion(period=8.0, surge=0.01), 8.0, initial_friction=state)
    (part,) = verify_dynamic(case, convergence_check="none").parts
    lies = 120.0 - 20.0 * math.sqrt(1.0 + 2.0 * 300e3 / (1110.0 * 20.0))
    for key, sense in (("pulled", -1.0), ("none", 0.0), ("laid", 1.0)):
        expected = 300e3 + sense * 0.5 * 1110.0 * lies
        assert part.anchor_at_rest[key] == pytest.approx(expected, abs=0.5 * 1110.0 * 3.0), key  # type: ignore[index]
    began = part.runs[0].history.anchor_tension[0, 0]
    assert began == pytest.approx(part.anchor_at_rest[state], rel=1e-6)  # type: ignore[index]


def test_every_run_has_its_own_seed_and_the_same_seed_the_same_sea() -> None:
    waves = WaveState("jonswap", 2.0, 8.0, components=30)
    drive = Excitation(chain(None, 60.0, waves=waves, runs=3))

    def phases(run: int) -> list[float]:
        found = drive.sea(run).waves
        assert isinstance(found, Waves)
        return [float(phase) for phase in found.phase]

    assert phases(0) == phases(0)
    assert phases(0) != phases(1)


@cache
def two_runs() -> DynamicPart:
    waves = WaveState("jonswap", 2.0, 6.0, components=20)
    return run(chain(Motion(period=6.0, surge=0.2), 40.0, waves=waves, runs=2, time_step=0.1))


def test_runs_in_a_random_sea_are_taken_together() -> None:
    part = two_runs()
    each = [run.statistics("fairlead_tension") for run in part.runs]
    found = part.of("fairlead_tension")
    assert len(part.runs) == 2
    assert found.maximum == max(one.maximum for one in each)
    assert found.mean == pytest.approx(np.mean([one.mean for one in each]), rel=1e-12)
    # 10 cycles in all: too few for a tail, and two maxima for Gumbel.
    assert (found.tail, found.gumbel) == (None, None)


@cache
def storm(runs: int = 1, duration_of_interest: float = 10800.0) -> DynamicPart:
    """Run a random sea of 280 s that counts, in which the fairlead is led as prescribed."""
    waves = WaveState("jonswap", 2.0, 6.0, components=40)
    motion = Motion(period=7.0, surge=0.5)
    case = chain(
        motion, 300.0, waves=waves, ramp=20.0, runs=runs, time_step=0.1, elements=8,
        duration_of_interest=duration_of_interest,
    )  # fmt: skip
    (part,) = verify_dynamic(case, convergence_check="none").parts
    return part


def test_extremes_are_of_the_duration_of_interest() -> None:
    """Not of the run's own length, and higher in a longer storm."""
    short, long = (storm(1, hours * 3600.0).of("fairlead_tension").tail for hours in (3.0, 12.0))
    assert short is not None
    assert long is not None
    assert storm().of("fairlead_tension").tail == short  # 3 h unless said
    assert (short.extreme.duration, long.extreme.duration) == (10800.0, 43200.0)
    assert short.extreme.most_probable < long.extreme.most_probable
    assert short.extreme.low < short.extreme.most_probable < short.extreme.high
    assert short.extreme.most_probable < short.extreme.expected
    assert short.time == pytest.approx(280.0, abs=0.2)
    # One peak in 280 s has been as high as the largest; in 39 times as long more are.
    assert short.expected_above(storm().of("fairlead_tension").maximum) > 5.0


def test_what_is_prescribed_has_no_most_probable_maximum() -> None:
    """The fairlead goes 0.5 m whatever the sea: 1.522 m were given for 1.5 m prescribed."""
    offset = storm().of("offset")
    assert offset.maximum == pytest.approx(0.5, abs=1e-3)
    assert offset.most_probable_maximum is None
    told = " ".join(dynamic_sentences(storm()))
    assert "offset" not in told
    assert "In 3 h the most probable maximum of the fairlead tension is " in told
    assert "(90% interval " in told
    regular = " ".join(dynamic_sentences(slow()))
    assert "Nothing is random here: the largest values are those of this run" in regular
    assert "most probable" not in regular


def test_the_figure_draws_the_peaks_where_there_is_a_tail() -> None:
    part = storm()
    tail = part.of("fairlead_tension").tail
    assert tail is not None
    assert peaks_above(slow()) is None
    chart = peaks_above(part)
    assert chart is not None
    assert chart.y.label == "Peaks above T in 3 h"
    assert [point.x for point in chart.points] == list(tail.clusters)
    (level,) = chart.levels
    assert (level.start, level.end) == (max(tail.extreme.low, tail.threshold), tail.extreme.high)
    assert chart.marks[-1][:3] == ("probable", tail.extreme.most_probable, 1.0)


@pytest.mark.slow
def test_gumbel_is_fitted_from_five_runs_on() -> None:
    assert storm(2).of("anchor_tension").gumbel is None
    part = storm(5)
    found = part.of("anchor_tension").gumbel
    assert found is not None
    assert (found.runs, found.extreme.duration) == (5, 10800.0)
    maxima = [run.statistics("anchor_tension").maximum for run in part.runs]
    scale = np.std(maxima, ddof=1) * math.sqrt(6.0) / math.pi
    mode = np.mean(maxima) - 0.57721566490 * scale
    assert found.run == pytest.approx(280.0, abs=0.2)
    moved = mode + scale * math.log(10800.0 / found.run)
    assert found.extreme.most_probable == pytest.approx(moved, rel=1e-9)
    assert "By a Gumbel distribution of the maxima of 5 runs" in " ".join(dynamic_sentences(part))


def test_the_document_has_the_extremes_with_their_interval() -> None:
    part = storm(5)
    case = chain(Motion(period=8.0, surge=0.1))
    quantities = DynamicVerification(case, (part,), is_complete=True).to_dict()
    tension, _, grounded, offset = quantities["load_cases"][0]["quantities"]
    tail = part.of("fairlead_tension").tail
    assert tail is not None
    assert tension["most_probable_max"] == tail.extreme.most_probable
    told = tension["tail"]
    assert (told["duration_s"], told["confidence"]) == (10800.0, 0.9)
    assert (told["low"], told["high"]) == (tail.extreme.low, tail.extreme.high)
    assert (told["threshold"], told["shape"]) == (tail.threshold, tail.shape)
    assert tension["gumbel"]["runs"] == 5
    for each in (grounded, offset):
        assert (each["most_probable_max"], each["tail"], each["gumbel"]) == (None, None, None)
    whole = schemas.schema("catopt.verify/1")
    item = {
        "$defs": whole["$defs"],
        **whole["$defs"]["dynamic_verification"]["properties"]["load_cases"],
    }
    jsonschema.Draft202012Validator(item).validate(quantities["load_cases"])


def test_the_document_fits_its_schema() -> None:
    case = chain(Motion(period=8.0, surge=0.2), 16.0)
    static = verify_case(case, elements=20).to_dict()
    document = static | {"dynamic": verify_dynamic(case).to_dict()}
    text = json.dumps(document, allow_nan=False)
    jsonschema.Draft202012Validator(schemas.schema("catopt.verify/1")).validate(json.loads(text))


def test_every_load_case_or_one() -> None:
    states = (LoadCase("a", 300e3), LoadCase("b", 200e3, water_level=1.0))
    case = chain(Motion(period=8.0, surge=0.2), 8.0, load=None, load_cases=states)
    assert [part.name for part in verify_dynamic(case).parts] == ["a", "b"]
    (part,) = verify_dynamic(case, load_case="b").parts
    assert part.runs[0].history.fairlead[0, 0, 2] == 21.0


def test_all_that_a_line_in_motion_lacks_is_told_at_once() -> None:
    with pytest.raises(InputError) as caught:
        verify_dynamic(chain(Motion(period=8.0), runs=2, line=Line([Segment(120.0, 1110.0)])))
    assert str(caught.value) == (
        "--dynamic: 4 errors\n"
        "  dynamics.runs: found 2; without a random sea all runs are the same; leave it out\n"
        "  line.segments[0].mass: missing; a line in motion needs it\n"
        "  line.segments[0].EA: missing; a line in motion needs its axial stiffness\n"
        "  line.segments[0].drag_normal: missing; a line in motion needs it; 0 for no drag"
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("t,x\n0,0\n1,a\n2\n", "line 3, x: found a; a number is required\n  line 4: found 1 cell;"),
        ("t,u\n0,0\n", "found u; one of t, x, y, z is required\n  headings: one of x, y, z"),
        ("x,x\n0,0\n", "headings: t is missing\n  headings: found x; twice"),
        ("t,x\n0,0\n1,0\n2,0\n3,0\n", "found 3 s from the first row to the last; the run of 60 s"),
        ("t,x\n" + "".join(f"{k},0\n" for k in range(70) if k < 20 or k > 30), "a gap"),
        ("", "rows: found 0"),
        (None, "there is no such file"),
    ],
)
def test_a_wrong_record_is_refused_with_its_place(
    text: str | None, message: str, tmp_path: Path
) -> None:
    path = tmp_path / "m.csv"
    if text is not None:
        path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        verify_dynamic(chain(Motion(file=str(path))))
    assert message in str(caught.value)
    assert str(path) in str(caught.value)


def test_a_step_too_long_for_the_motion_is_refused() -> None:
    with pytest.raises(InputError, match=r"dynamics.time_step: found 3 s; .*periods down to 8 s"):
        verify_dynamic(chain(Motion(period=8.0, surge=0.1), time_step=3.0))


def test_what_was_computed_is_kept_when_it_is_stopped() -> None:
    """Ctrl-C in the second of three runs: the first is whole, the second short."""
    waves = WaveState("jonswap", 2.0, 6.0, components=20)
    case = chain(None, 60.0, waves=waves, runs=3, time_step=0.1)
    reached: list[float] = []

    def stop(done: int, total: int) -> None:
        reached.append(done / total)
        if done / total > 0.35:  # in the first half of the second, of which the proof is most
            raise KeyboardInterrupt

    found = verify_dynamic(case, progress=stop)
    (part,) = found.parts
    assert not found.is_complete
    assert [run.history.is_complete for run in part.runs] == [True, False]
    assert 0.0 < part.runs[1].history.time[-1] < 60.0
    assert "stopped in run 2 of 3" in part.remarks
    assert reached == sorted(reached)


def test_a_run_that_is_stopped_in_its_ramp_is_left_out() -> None:
    case = chain(Motion(period=8.0, surge=0.1), 60.0, ramp=50.0)

    def stop(done: int, _: int) -> None:
        if done:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        verify_dynamic(case, progress=stop, convergence_check="none")


def test_nothing_is_kept_of_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def stop(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Simulation, "settle", stop)
    with pytest.raises(KeyboardInterrupt):
        verify_dynamic(chain(Motion(period=8.0, surge=0.1)))


def test_the_current_and_its_profile_move_the_line() -> None:
    across = CurrentProfile("table", depths=(0.0, 20.0), speeds=(1.0, 0.5), direction=math.pi / 2)
    case = chain(Motion(period=8.0, surge=0.01), 8.0, current=across)
    part = run(case)
    # Drag across the line turns the fairlead's force to the side, y.
    assert abs(part.runs[0].history.fairlead_force[0, 0, 1]) > 100.0
    assert "the quasi-static tension is without current" in part.remarks


def test_the_example_reads_its_raos_from_its_own_folder() -> None:
    case = read_case(EXAMPLE)
    assert case.motion is not None
    assert Path(case.motion.rao_file) == EXAMPLE.parent.absolute() / "rao.csv"
    assert case.line.segments[0].drag_normal == 2.4  # catalogue: 2.4 on the nominal diameter
    # DNV-RP-C205-like 1.15 on d/pi, here on d; the volume-equivalent added mass as it is.
    assert case.line.segments[0].drag_axial == pytest.approx(1.15 / math.pi, rel=1e-12)
    assert case.line.segments[0].added_mass_normal == 1.0


def test_drag_along_the_line_on_the_circumference() -> None:
    """MoorDyn's and OrcaFlex's coefficient on pi D is pi times as much on D."""
    text = MODEL_TEST.format(period=3.5, duration=21.0, ramp=7.0)
    on_both = [
        parse_case(text.replace("drag_axial = 0.5", given)).line.segments[0].drag_axial
        for given in (
            'drag_axial = 0.5\ndrag_axial_area = "pi D"', 'drag_axial = 0.5\ndrag_axial_area = "D"'
        )
    ]  # fmt: skip
    assert on_both == [pytest.approx(0.5 * math.pi, rel=1e-15), 0.5]
    with pytest.raises(InputError, match="goes with drag_axial, which is missing"):
        parse_case(text.replace("drag_axial = 0.5", 'drag_axial_area = "pi D"'))


def test_a_line_whose_lower_end_is_led_or_lost() -> None:
    """Led in heave it says that nothing is quasi-static; lost, its anchor holds nothing more."""
    prescribed_motion = chain(Motion(period=6.0), anchor_motion=Motion(period=6.0, heave=0.3))
    (part,) = verify_dynamic(prescribed_motion, convergence_check="none").parts
    assert np.ptp(part.runs[0].history.anchor_tension) > 0.0
    assert part.dynamic_amplification is None
    assert any(each.startswith("the lower end moves") for each in part.remarks)

    lost = chain(Motion(period=6.0, surge=0.2), broken_line=1, broken_at=10.0, broken_end="anchor")
    (part,) = verify_dynamic(lost, convergence_check="none").parts
    history = part.runs[0].history
    after = history.time > 10.1
    assert not history.anchor_tension[after].any()
    assert history.anchor_tension[history.time < 9.9].min() > 0.0
    assert np.isnan(part.runs[0].quasi_static[after]).all()
    assert "the line is lost at its anchor at 10 s" in part.remarks


CASES = Path(__file__).parents[2] / "cases"
MOVING = sorted(
    path
    for path in CASES.glob("*/*.toml")
    if "[dynamics]" in (text := path.read_text(encoding="utf-8")) and "[floater.ship]" not in text
)


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, marks=[pytest.mark.slow] * ("[system]" in path.read_text("utf-8")))
        for path in MOVING
    ],
    ids=lambda path: f"{path.parent.name}/{path.stem}",
)
def test_less_than_a_thousandth_of_the_work_is_numerical_in_what_is_shipped(path: Path) -> None:
    found = verify_dynamic(read_case(path), convergence_check="none")
    assert max(part.numerical_part for part in found.parts) < 1e-3


def test_what_a_line_at_rest_would_do_is_left_out_where_it_is_not_asked() -> None:
    """The run is the same, digit by digit; what is compared with it is not there."""
    motion = Motion(surge=0.5, heave=0.3, period=8.0)
    case = chain(motion, 8.0, ramp=2.0, elements=10)
    (whole,) = verify_dynamic(case, convergence_check="none").parts
    (lean,) = verify_dynamic(case, convergence_check="none", compares_at_rest=False).parts
    assert lean.runs[0].maxima == whole.runs[0].maxima
    assert whole.dynamic_amplification is not None
    assert whole.quasi_static_max is not None
    assert whole.anchor_at_rest
    assert lean.dynamic_amplification is None
    assert lean.quasi_static_max is None
    assert not lean.anchor_at_rest


def test_the_old_name_of_the_amplification_warns_for_one_version() -> None:
    part = slow()
    with pytest.warns(DeprecationWarning, match="dynamic_amplification"):
        assert part.amplification == pytest.approx(1.0, abs=1e-3)
