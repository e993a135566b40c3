"""All lines of a moored body in motion: led, or moving under forces."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.fem import Leg
from catopt.fem.series import Harmonic, Sampled, Together, series_rows, series_values
from catopt.model import (
    Body,
    Case,
    Dynamics,
    Line,
    Load,
    Motion,
    Segment,
    Site,
    System,
    WaveState,
    WaveTrain,
)
from catopt.mooring.solution import solve_system
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_lines import LinesOfABody, lines_at_rest
from catopt.verify.dynamic_result import DynamicVerification
from catopt.verify.dynamic_setup import read_drive
from catopt.verify.motion_file import read_vessel_raos

CHAIN = Line([Segment(120.0, 1110.0, EA=5e8, mass=130.0, drag_normal=1.0, drag_diameter=0.1)])
DEPTH, RADIUS = 20.0, 117.0
FEW = Dynamics(duration=12.0, ramp=4.0, time_step=0.1, elements=8)


def moored(
    *,
    motion: Motion | None = None,
    body: Body | None = None,
    waves: WaveState | None = None,
    azimuths: tuple[float, ...] = (180.0, 60.0, -60.0),
    force: tuple[float, float] = (3e4, 0.0),
    fairlead_radius: float = 0.0,
    dynamics: Dynamics = FEW,
) -> Case:
    """Three chains around a body in 20 m."""
    system = System.around(
        CHAIN,
        azimuths=[math.radians(each) for each in azimuths],
        anchor_radius=RADIUS,
        fairlead_radius=fairlead_radius,
        fairlead_height=DEPTH,
        force=force,
    )
    return Case(
        Site(DEPTH), CHAIN, None, DEPTH,
        system=system, motion=motion, body=body, waves=waves, dynamics=dynamics,
    )  # fmt: skip


def run(case: Case) -> DynamicVerification:
    return verify_dynamic(case, convergence_check="none")


# ------------------------------------------------------------------ a body that is led


def test_a_line_of_a_led_body_is_that_line_by_itself() -> None:
    """Its anchor lies at -x, so that the fairlead is seen from it along x as in a case of one."""
    motion = Motion(period=6.0, surge=0.2, sway=0.1, heave=0.3, heave_phase=1.0)
    case = moored(motion=motion)
    assert case.system is not None
    span = RADIUS + solve_system(case.system).position.x
    alone = Case(
        case.site, CHAIN, Load(span=span), DEPTH, motion=motion, dynamics=case.dynamics
    )  # fmt: skip
    first, *_ = run(case).parts
    (single,) = run(alone).parts
    of_body, of_line = first.runs[0].history, single.runs[0].history
    size = float(of_line.fairlead_tension.max())
    assert np.allclose(of_body.fairlead_tension, of_line.fairlead_tension, atol=1e-7 * size)
    assert np.allclose(first.runs[0].quasi_static, single.runs[0].quasi_static, rtol=1e-9)
    assert first.dynamic_amplification == pytest.approx(single.dynamic_amplification, rel=1e-6)


def test_a_drift_moves_the_place_about_which_a_body_is_led() -> None:
    still = Motion(period=5.0, heave=1e-3)
    case = moored(motion=replace(still, drift=(-2.0, 0.5)))
    assert case.system is not None
    at = solve_system(case.system).position
    (x, y, _) = lines_at_rest(read_drive(case)).place  # type: ignore[union-attr]
    assert (x, y) == (at.x - 2.0, at.y + 0.5)


def test_a_slow_drift_adds_to_a_harmonic_motion(tmp_path: Path) -> None:
    path = tmp_path / "drift.csv"
    path.write_text("t,x\n" + "".join(f"{t},{0.1 * t}\n" for t in range(13)))
    found = run(moored(motion=Motion(period=4.0, surge=0.5, drift_file=str(path))))
    track = found.parts[0].runs[0].track
    assert track is not None
    after = found.parts[0].runs[0].history.time >= 4.0
    t = found.parts[0].runs[0].history.time[after]
    expected = track[0, 0] + 0.1 * t + 0.5 * np.cos(2.0 * np.pi * t / 4.0)
    assert np.allclose(track[after, 0], expected, atol=1e-9)
    place = found.parts[0].runs[0].history.fairlead[after, 0, 0]
    assert np.allclose(place, track[after, 0], atol=1e-12)


def test_what_is_led_and_what_comes_on_top_are_added() -> None:
    """A way at constant speed has no acceleration, whose periods would count."""
    times = np.linspace(0.0, 10.0, 41)
    slow = Sampled(times, np.column_stack([times, 2.0 * times, 0.0 * times]))
    both = Together(Harmonic(3.0, (1.0, 0.0, 2.0)), slow)
    values = series_values(series_rows(np.zeros((1, 3)), [both], 0.0), np.array([1.3]))
    wave = math.cos(2.0 * math.pi * 1.3 / 3.0)
    assert values[0] == pytest.approx([1.3 + wave, 2.6, 2.0 * wave], abs=1e-12)
    assert both.shortest_period == 3.0


# ------------------------------------------------------------------ RAOs of six degrees of freedom

HEADS = "heading (deg),period (s),surge (m/m),surge_phase (deg),heave (m/m),heave_phase (deg),"
HEADS += "pitch (deg/m),pitch_phase (deg),yaw (deg/m),roll (deg/m)\n"
GIVEN = Motion(
    rao_file="rao.csv",
    rao_phase="lag",
    rao_reference=(2.0, 0.0, 30.0),
    rao_rotation="deg/m",
    rao_per="amplitude",
)


def raos(tmp_path: Path, rows: str, **other: object) -> Motion:
    path = tmp_path / "rao.csv"
    path.write_text(HEADS + rows)
    return replace(GIVEN, rao_file=str(path), **other)  # type: ignore[arg-type]


def test_a_fairlead_goes_as_the_body_carries_it(tmp_path: Path) -> None:
    """By hand: heave - pitch x, surge + pitch z - yaw y, and yaw x - roll z, right-handed."""
    motion = raos(tmp_path, "180,10,0.5,-90,0.8,20,2,-70,0.5,1.5\n")
    response = read_vessel_raos(motion).of_point(math.pi, (52.0, 7.0, 36.0)).response[0]
    x, y, z = 50.0, 7.0, 6.0

    def phasor(size: float, lag: float = 0.0) -> complex:
        return size * complex(math.cos(math.radians(lag)), math.sin(math.radians(lag)))

    pitch, yaw, roll = phasor(math.radians(2.0), -70.0), math.radians(0.5), math.radians(1.5)
    assert response[0] == pytest.approx(phasor(0.5, -90.0) + pitch * z - yaw * y)
    assert response[1] == pytest.approx(yaw * x - roll * z)
    assert response[2] == pytest.approx(phasor(0.8, 20.0) + roll * y - pitch * x)


@pytest.mark.parametrize(("said", "ahead"), [({}, 2.0), ({"rao_crest": (9.0, 1.0)}, 9.0)])
def test_a_body_under_raos_goes_through_the_crest_as_they_say(
    tmp_path: Path, said: dict[str, object], ahead: float
) -> None:
    """The crest is counted at the reference point, or where it is said to be.

    A phase of 0 puts the body up with it.
    """
    motion = raos(tmp_path, "0,6,0,0,1,30,0,0,0,0\n", **said)
    waves = WaveState("regular", 1.0, 6.0)
    dynamics = replace(FEW, duration=18.0, ramp=6.0)
    found = run(moored(motion=motion, waves=waves, dynamics=dynamics))
    history, track = found.parts[0].runs[0].history, found.parts[0].runs[0].track
    assert track is not None
    case = moored(motion=motion, waves=waves)
    drive = read_drive(case)
    sea, place = drive.sea(0), lines_at_rest(drive).place  # type: ignore[union-attr]
    assert sea.waves is not None
    k, w = sea.wave_numbers[0], 2.0 * math.pi / 6.0
    after = history.time >= 6.0
    crest = w * history.time - k * (place[0] + ahead) - sea.waves.phase[0]
    heave = 0.5 * np.cos(crest - math.radians(30.0))
    assert np.allclose(track[after, 2] - DEPTH, heave[after], atol=1e-9)


def test_a_ship_that_is_turned_with_its_waves_moves_as_before_but_turned(tmp_path: Path) -> None:
    """Place, arm and waves turned by the yaw: the same motion, turned by it."""
    motion = raos(tmp_path, "150,6,0.5,-90,0.8,20,2,-70,0.5,1.5\n")
    yaw, heading = math.radians(35.0), math.radians(150.0)
    turn = np.array([[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]])
    found = []
    for angle, place, arm in (
        (0.0, np.array([3.0, -4.0]), np.array([20.0, 6.0])),
        (yaw, turn @ [3.0, -4.0], turn @ [20.0, 6.0]),
    ):
        waves = WaveState("regular", 2.0, 6.0, direction=heading + angle)
        drive = read_drive(moored(motion=motion, waves=waves))
        sea, leg = drive.sea(0), Leg(CHAIN, (0.0, 0.0, 0.0), (*arm, 1.0))
        lines = LinesOfABody(drive, (leg,), (*place, DEPTH), angle)
        (series,) = lines.driven_by(sea)
        assert isinstance(series, Harmonic)
        found.append(np.asarray(series.amplitude) * np.exp(1j * np.asarray(series.phase)))
    straight, turned = found[0][0], found[1][0]
    assert turned[:2] == pytest.approx(turn @ straight[:2])
    assert turned[2] == pytest.approx(straight[2])


def test_waves_of_several_directions_each_move_the_ship_by_their_own_heading(
    tmp_path: Path,
) -> None:
    """Wind sea and swell together: what each does by itself."""
    rows = "150,6,0.5,-90,0.8,20,2,-70,0.5,1.5\n200,6,0.1,30,0.3,-10,1,15,0,3\n"
    motion = raos(tmp_path, rows)
    trains = [
        WaveTrain("regular", height, period, direction=math.radians(heading))
        for height, period, heading in ((2.0, 6.0, 150.0), (1.0, 9.0, 200.0))
    ]
    found = []
    for given in (trains, trains[:1], trains[1:]):
        drive = read_drive(moored(motion=motion, waves=WaveState(trains=tuple(given))))
        leg = Leg(CHAIN, (0.0, 0.0, 0.0), (20.0, 6.0, 1.0))
        lines = LinesOfABody(drive, (leg,), (3.0, -4.0, DEPTH), 0.0)
        (series,) = lines.driven_by(drive.sea(0))
        assert isinstance(series, Harmonic)
        found.append(np.asarray(series.amplitude) * np.exp(1j * np.asarray(series.phase)))
    both, first, second = found
    assert np.allclose(both, [first[0], second[0]], rtol=1e-12)


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("90,8,0.5,-40,0,0,2,-10,0,0\n", {"rao_phase": "lead"}),
        ("90,8,0.25,40,0,0,1,10,0,0\n", {"rao_per": "height"}),
    ],
)
def test_the_conventions_of_raos_are_followed(
    tmp_path: Path, row: str, said: dict[str, object]
) -> None:
    """The same ship, as another program would print it."""
    point = (2.0, 0.0, 36.0)
    first = read_vessel_raos(raos(tmp_path, "90,8,0.5,40,0,0,2,10,0,0\n"))
    other = read_vessel_raos(raos(tmp_path, row, **said))
    expected = first.of_point(math.pi / 2, point).response
    assert other.of_point(math.pi / 2, point).response == pytest.approx(expected)


def test_between_two_headings_the_response_is_in_proportion(tmp_path: Path) -> None:
    rows = "0,8,1,0,0,0,0,0,0,0\n90,8,0,0,1,0,0,0,0,0\n"
    vessel = read_vessel_raos(raos(tmp_path, rows))
    response = vessel.of_point(math.radians(30.0), (2.0, 0.0, 30.0)).response[0]
    assert response == pytest.approx([2.0 / 3.0, 0.0, 1.0 / 3.0])
    with pytest.raises(InputError, match="give rows around it"):
        vessel.of_point(math.radians(91.0), (2.0, 0.0, 30.0))


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("0,8,1,0,0,0,0,0,0,0\n90,9,0,0,1,0,0,0,0,0\n", "every heading has the same ones"),
        ("0,8,1,0,0,0,0,0,0,0\n0,8,0,0,1,0,0,0,0,0\n", "one row per heading and period"),
        ("0,-8,1,0,0,0,0,0,0,0\n", "must be above 0"),
    ],
)
def test_tables_of_raos_that_say_no_one_thing_are_refused(
    tmp_path: Path, rows: str, message: str
) -> None:
    with pytest.raises(InputError, match=message):
        read_vessel_raos(raos(tmp_path, rows))


def test_the_unit_of_every_column_is_wanted(tmp_path: Path) -> None:
    motion = raos(tmp_path, "0,8,1,0,0,0,0,0,0,0\n", rao_rotation="rad/m")
    with pytest.raises(InputError, match=r"one of rad/m"):
        read_vessel_raos(motion)


# ------------------------------------------------------------------ a body that moves

TAUT = Line([Segment(100.0, 1.0, EA=1e7, mass=1.0, drag_normal=0.0)])


def on_taut_lines(body: Body, **other: object) -> Case:
    """Between two lines along x, stretched by 2 %, in the middle of 40 m of water."""
    system = System.around(
        TAUT,
        azimuths=[0.0, math.pi],
        anchor_radius=102.0,
        anchor_height=20.0,
        fairlead_height=20.0,
    )
    return Case(Site(40.0), TAUT, None, 20.0, anchor_height=20.0, system=system, body=body, **other)  # type: ignore[arg-type]


def pulse(tmp_path: Path, duration: float) -> str:
    """Write a push along x in the first four seconds."""
    path = tmp_path / "force.csv"
    times = 0.5 * np.arange(2.0 * duration + 1.0)
    push = np.where(times < 4.0, 10.0 * np.sin(np.pi * times / 4.0) ** 2, 0.0)
    rows = "".join(f"{t:.1f},{fx},0,0\n" for t, fx in zip(times, push, strict=True))
    path.write_text("t (s),Fx (kN),Fy (kN),Fz (kN)\n" + rows)
    return str(path)


def test_a_mass_on_taut_lines_has_its_natural_period(tmp_path: Path) -> None:
    """Two springs EA/L of 1e5 N/m each; the lines' 100 kg each move by a third of them."""
    mass, added = 4e4, 1e4
    dynamics = Dynamics(duration=40.0, ramp=0.0, time_step=0.02, elements=6, line_damping=0.0)
    body = Body(mass, added, force_file=pulse(tmp_path, 40.0))
    found = run(on_taut_lines(body, dynamics=dynamics))
    one = found.parts[0].runs[0]
    assert one.track is not None
    x, t = one.track[:, 0], one.history.time
    up = np.flatnonzero((x[:-1] <= 0.0) & (x[1:] > 0.0) & (t[1:] > 4.5))
    crossings = t[up] - x[up] * (t[up + 1] - t[up]) / (x[up + 1] - x[up])
    period = float(np.diff(crossings).mean())
    moving = mass + added + 2.0 * 100.0 / 3.0
    assert period == pytest.approx(2.0 * math.pi * math.sqrt(moving / 2e5), rel=1e-3)


def test_a_force_of_the_waves_moves_a_body_by_hand() -> None:
    """Amplitude F/|k - m w^2 + i c w| of the steady answer; what else there was has died away."""
    mass, damping = 5e4, 2e5
    waves = WaveState("regular", 2.0, 4.0)
    dynamics = Dynamics(duration=40.0, ramp=8.0, time_step=0.04, elements=6, line_damping=0.0)
    body = Body(mass, damping=damping, wave_force=(1.5e4, 0.0))
    found = run(on_taut_lines(body, waves=waves, dynamics=dynamics))
    one = found.parts[0].runs[0]
    assert one.track is not None
    w = 2.0 * math.pi / 4.0
    moving = mass + 2.0 * 100.0 / 3.0
    expected = 1.5e4 / abs(complex(2e5 - moving * w * w, damping * w))
    late = one.track[one.history.time > 32.0]
    assert 0.5 * float(np.ptp(late[:, 0])) == pytest.approx(expected, rel=2e-3)
    assert float(np.abs(late[:, 1]).max()) < 1e-9


def test_what_is_symmetric_stays_so(tmp_path: Path) -> None:
    body = Body(2e5, force_file=pulse(tmp_path, 12.0))
    found = run(moored(body=body, force=(3e4, 0.0)))
    _, left, right = (part.runs[0] for part in found.parts)
    size = float(left.history.fairlead_tension.max())
    other = right.history.fairlead_tension
    assert np.allclose(left.history.fairlead_tension, other, atol=1e-8 * size)
    assert left.track is not None
    assert float(np.abs(left.track[:, 1]).max()) < 1e-8


def test_fz_is_not_used_and_that_is_said(tmp_path: Path) -> None:
    path = tmp_path / "force.csv"
    path.write_text("t (s),Fz (kN)\n" + "".join(f"{t},{t}\n" for t in range(13)))
    found = run(moored(body=Body(2e5, force_file=str(path))))
    assert any(each.startswith("Fz of the force file") for each in found.parts[0].remarks)


def test_a_force_without_its_unit_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "force.csv"
    path.write_text("t (s),Fx\n" + "".join(f"{t},{t}\n" for t in range(13)))
    with pytest.raises(InputError, match="one of N, kN, MN, kgf, tf"):
        read_drive(moored(body=Body(2e5, force_file=str(path))))


def test_a_body_is_proven_as_a_line_is(tmp_path: Path) -> None:
    body = Body(2e5, force_file=pulse(tmp_path, 12.0))
    found = verify_dynamic(moored(body=body))
    assert found.is_complete
    assert [part.line for part in found.parts] == [1, 2, 3]
    assert found.verdict == "converged"
    for part in found.parts:
        assert [again.way for again in part.runs[0].again] == ["step"]
    document = found.to_dict()
    assert [each["line"] for each in document["load_cases"]] == [1, 2, 3]
    assert [each["quantity"] for each in document["body"]] == ["body_x", "body_y", "body_offset"]
    assert document["body"][2]["max"] > 0.0


# ------------------------------------------------------------------ what does not go together


@pytest.mark.parametrize(
    ("changes", "key", "message"),
    [
        ({}, "dynamics", r"needs \[motion\], which prescribes it, or \[body\]"),
        ({"body": Body(1e5)}, "body", "nothing moves: force_file"),
        (
            {"body": Body(1e5, force_file="f"), "motion": Motion(8.0)},
            "body",
            "either has prescribed motion or moves",
        ),
        ({"motion": Motion(8.0, rao_phase="lag")}, "motion.rao_phase", "goes with rao_file"),
        ({"motion": Motion(8.0, rao_crest=(0.0, 1.0))}, "motion.rao_crest", "goes with rao_file"),
        ({"motion": Motion(rao_file="r")}, "motion.rao_reference", "the RAOs of a body need it"),
        ({"motion": replace(GIVEN)}, "motion.rao_file", r"needs \[waves\]"),
        ({"motion": Motion(file="m", drift_file="d")}, "motion.drift_file", "add the drift"),
    ],
)
def test_what_a_body_in_motion_needs(changes: dict[str, object], key: str, message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        replace(moored(motion=Motion(8.0)), **{"motion": None} | changes)  # type: ignore[arg-type]
    assert key in [problem.key for problem in caught.value.problems]


def test_what_is_for_a_body_is_refused_of_a_line() -> None:
    alone = Case(Site(DEPTH), CHAIN, Load(span=115.0), DEPTH, motion=Motion(8.0), dynamics=FEW)
    for changes, key in (
        ({"body": Body(1e5)}, "body"),
        ({"motion": Motion(8.0, drift=(1.0, 0.0))}, "motion.drift"),
    ):
        with pytest.raises(InputError, match=r"goes with \[system\]") as caught:
            replace(alone, **changes)
        assert [problem.key for problem in caught.value.problems] == [key]


# ------------------------------------------------------------------ a line that breaks


def test_a_body_swings_about_its_new_place_when_a_line_breaks(tmp_path: Path) -> None:
    """Released by one of three pulls that balance, it leaves with that force over its mass."""
    dynamics = Dynamics(
        duration=30.0, ramp=0.0, time_step=0.05, elements=8, broken_line=1, broken_at=6.0
    )
    body = Body(2e6, force_file=silence(tmp_path))
    case = moored(body=body, force=(0.0, 0.0), azimuths=(0.0, 120.0, -120.0), dynamics=dynamics)
    found = run(case)
    broken, other, _ = (part.runs[0] for part in found.parts)
    t, track = broken.history.time, broken.track
    assert track is not None
    before, after = t < 5.9, t > 6.1
    assert float(np.abs(track[before, 0]).max()) < 1e-6
    tension = broken.history.fairlead_tension
    assert float(tension[after].max()) < 1e-6 * float(tension[before].min())
    assert np.isnan(broken.quasi_static[after]).all()
    assert np.isfinite(other.quasi_static).all()
    pull = float(broken.history.fairlead_force[0, 0, 0])
    soon = (t > 6.0) & (t < 6.6)
    fit = np.polyfit(t[soon] - 6.0, track[soon, 0] - track[0, 0], 2)
    assert -2.0 * fit[0] * 2e6 == pytest.approx(pull, rel=0.05)
    assert found.parts[0].numerical_part < 0.01
    assert any(each.startswith("line 1 breaks at its") for each in found.parts[0].remarks)


def silence(tmp_path: Path) -> str:
    path = tmp_path / "force.csv"
    path.write_text("t (s),Fx (kN)\n" + "".join(f"{t},0\n" for t in range(31)))
    return str(path)


@pytest.mark.slow
def test_a_body_without_a_line_comes_to_where_statics_have_it(tmp_path: Path) -> None:
    """6.5 m away; the closed form is met to 2 mm with 40 bars and to 0.3 mm with 80."""
    dynamics = Dynamics(
        duration=120.0, ramp=0.0, time_step=0.1, elements=40, broken_line=3, broken_at=1.0,
        output_interval=0.5,
    )  # fmt: skip
    path = tmp_path / "force.csv"
    path.write_text("t (s),Fx (kN)\n" + "".join(f"{t},0\n" for t in range(121)))
    body = Body(5e4, damping=5e4, force_file=str(path))
    case = moored(
        body=body, force=(1e4, 0.0), azimuths=(0.0, 90.0, 180.0, 270.0), dynamics=dynamics
    )
    assert case.system is not None
    expected = solve_system(case.system.without([2])).position
    track = run(case).parts[0].runs[0].track
    assert track is not None
    assert track[-1, 0] == pytest.approx(expected.x, abs=0.005)
    assert track[-1, 1] == pytest.approx(expected.y, abs=0.005)


def test_a_break_of_no_line_is_refused() -> None:
    broken = replace(FEW, broken_line=1, broken_at=5.0)
    body, beyond = Body(1e5, force_file="f"), replace(broken, broken_line=4)
    with pytest.raises(InputError, match="there are 3 lines"):
        moored(body=body, dynamics=beyond)
    with pytest.raises(InputError, match="go together"):
        replace(FEW, broken_line=1)
