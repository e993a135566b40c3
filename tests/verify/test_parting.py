"""A line parts in time: of a free body, a led one, a buoy, a ship and a network."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from catopt import InputError, read_case
from catopt.casefile import parse_case, write_case
from catopt.casefile.reading import parse_network
from catopt.fem.mesh import mesh_line
from catopt.floater.moored import moored_at_rest
from catopt.floater.slow_drift import SLOW_STEP
from catopt.model import Body, Case, Checks, Dynamics, Line, Motion, Segment, Site, System
from catopt.verify.convergence_check import Change
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_lines import LinesOfAFloater
from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
from catopt.verify.dynamic_setup import read_drive
from catopt.verify.two_scales import moored_ship, verify_ship
from catopt.verify.verdicts import check_parts, solutions_at_rest

DEPTH, LENGTH, EA, MASS = 20.0, 100.0, 2e6, 4e5
ROPE = Line([Segment(LENGTH, 0.5, EA=EA, mass=0.2, MBL=400e3, drag_normal=0.0)])
FORCE = 200e3


def silence(tmp_path: Path) -> str:
    path = tmp_path / "force.csv"
    path.write_text("t (s),Fx (kN)\n" + "".join(f"{t},0\n" for t in range(61)))
    return str(path)


def two_ropes(tmp_path: Path, **changes: object) -> Case:
    """Moor a body on two equal ropes side by side against a constant force along x."""
    dynamics = Dynamics(
        duration=40.0, ramp=0.0, time_step=0.02, elements=6, line_damping=0.0,
        **{"broken_line": 1, "broken_at": 2.0} | changes,  # type: ignore[arg-type]
    )  # fmt: skip
    system = System.around(
        ROPE,
        azimuths=[math.pi, math.pi],
        anchor_radius=100.0,
        fairlead_height=DEPTH,
        force=(FORCE, 0.0),
    )
    body = Body(MASS, force_file=silence(tmp_path))
    checks = Checks(codes=("API-RP-2SK",))
    return Case(
        Site(DEPTH), ROPE, None, DEPTH, system=system, body=body, dynamics=dynamics, checks=checks
    )


def run(case: Case) -> DynamicVerification:
    return verify_dynamic(case, convergence_check="none")


def stretched(x: float) -> float:
    """Tension of a straight rope from an anchor 100 m behind the origin to a body at x, N."""
    return EA * (math.hypot(100.0 + x, DEPTH) / LENGTH - 1.0)


def along(x: float) -> float:
    return stretched(x) * (100.0 + x) / math.hypot(100.0 + x, DEPTH)


def strain(x: float) -> float:
    return 0.5 * stretched(x) ** 2 * LENGTH / EA


def test_a_mass_on_two_springs_of_which_one_is_cut(tmp_path: Path) -> None:
    """By energy: from rest F (x - x0) is the strain that the rope left takes up to where it turns.

    Of linear springs that is twice the static change: 1.5 times the force where each had half.
    """
    case = two_ropes(tmp_path)
    found = run(case)
    lost, left = (part.runs[0] for part in found.parts)
    before = brentq(lambda x: 2.0 * along(x) - FORCE, 0.0, 40.0)
    turn = brentq(lambda x: FORCE * (x - before) - strain(x) + strain(before), before + 1.0, 60.0)
    still = brentq(lambda x: along(x) - FORCE, 0.0, 60.0)
    assert turn - before == pytest.approx(2.0 * (still - before), rel=0.05)
    history, track = left.history, left.track
    assert track is not None
    assert history.since == pytest.approx(2.0)
    assert left.max_fairlead_tension == pytest.approx(stretched(turn), rel=2e-3)
    assert float(track[:, 0].max() - track[0, 0]) == pytest.approx(turn - before, rel=2e-3)
    assert left.statistics("offset").maximum == pytest.approx(turn - before, rel=2e-3)
    assert lost.max_fairlead_tension < 0.01 * stretched(before)
    fallen, _ = found.parts
    assert fallen.has_parted
    assert not fallen.decides(Change("anchor_tension", "step", 12.0, 1e3))
    # Checked in the transient state, against 1.05, the rope that is left alone.
    checks = check_parts(case, found.parts, solutions_at_rest(case, found.parts))
    (tension,) = (each for each in checks.results if each.kind == "tension")
    assert tension.place.state == "transient"
    assert tension.utilisation == pytest.approx(1.05 * stretched(turn) / 400e3, rel=3e-3)


def test_it_swings_with_the_stiffness_that_is_left(tmp_path: Path) -> None:
    left = run(two_ropes(tmp_path)).parts[1].runs[0]
    time, x = left.history.time, left.history.fairlead[:, 0, 0]
    still = brentq(lambda x: along(x) - FORCE, 0.0, 60.0)
    slope = (along(still + 0.1) - along(still - 0.1)) / 0.2
    mean = 0.5 * (x[time > 2.0].max() + x[time > 2.0].min())
    over = np.flatnonzero((x[:-1] < mean) & (x[1:] >= mean))
    period = float(np.diff(time[over]).mean())
    assert period == pytest.approx(2.0 * math.pi * math.sqrt(MASS / slope), rel=0.02)


def test_the_anchor_lets_go_of_a_led_body_or_its_fairlead_does(tmp_path: Path) -> None:
    """A led body does not feel it: the others keep their tension, and the lost line falls."""
    base = two_ropes(tmp_path)
    assert base.dynamics is not None
    led = replace(
        base, body=None, motion=Motion(10.0, surge=0.3, surge_phase=0.5 * math.pi),
        dynamics=replace(base.dynamics, duration=8.0, broken_at=3.0),
    )  # fmt: skip
    lost, left = (part.runs[0] for part in run(led).parts)
    time = lost.history.time
    assert float(lost.history.fairlead_tension[time > 3.05].max()) < 1e3
    assert led.dynamics is not None
    whole = replace(led, dynamics=replace(led.dynamics, broken_line=None, broken_at=None))
    same = run(whole).parts[1].runs[0].history
    assert np.abs(left.history.fairlead_tension - same.fairlead_tension).max() < 1.0


def test_it_parts_by_its_own_strength(tmp_path: Path) -> None:
    """A led rope pulled up to 1.2 times its MBL parts where it passes that, and fails its check."""
    weak = Line([replace(ROPE.segments[0], MBL=150e3)])
    base = two_ropes(tmp_path)
    system = System.around(
        weak, azimuths=[math.pi, 0.0], anchor_radius=100.0, fairlead_height=DEPTH
    )
    dynamics = Dynamics(
        duration=12.0, ramp=0.0, time_step=0.02, elements=6, broken_line=1, broken_by="MBL"
    )
    led = replace(
        base,
        line=weak,
        system=system,
        body=None,
        motion=Motion(24.0, surge=6.0, surge_phase=-0.5 * math.pi),
        dynamics=dynamics,
    )
    found = run(led)
    lost = found.parts[0].runs[0]
    assert lost.history.parted is not None
    reached = brentq(lambda x: stretched(x) - 150e3, 0.0, 6.0)
    at = 24.0 / (2.0 * math.pi) * math.asin(reached / 6.0)
    assert lost.history.parted.time == pytest.approx(at, abs=0.05)
    report = check_parts(led, found.parts, solutions_at_rest(led, found.parts))
    by_line = {each.place.line: each for each in report.results if each.kind == "tension"}
    assert by_line[1].place.state == "intact"
    assert by_line[1].utilisation == pytest.approx(1.67, rel=1e-3)
    assert by_line[2].place.state == "transient"
    # One that never reaches it stays, and the mooring is judged as intact.
    calm = replace(led, motion=Motion(24.0, surge=0.5, surge_phase=0.5 * math.pi))
    stays = run(calm)
    assert stays.parts[0].runs[0].history.parted is None
    report = check_parts(calm, stays.parts, solutions_at_rest(calm, stays.parts))
    assert {each.place.state for each in report.results} == {"intact"}
    assert any("does not reach its MBL" in each for each in stays.parts[0].remarks)


SEGMENT = """\
[[lines.segments]]
length = "42.4 m"
submerged_weight = "0.5 N/m"
mass = "0.2 kg/m"
EA = "100 MN"
MBL = "900 kN"
drag_diameter = "1 mm"
drag_normal = 0
"""
HANGING = f"""
title = "A weight between two ropes"
[site]
water_depth = "60 m"
[[points]]
name = "left"
kind = "fairlead"
x = "-30 m"
y = "0 m"
height = "55 m"
[[points]]
name = "right"
kind = "fairlead"
x = "30 m"
y = "0 m"
height = "55 m"
[[points]]
name = "weight"
kind = "joint"
submerged_weight = "100 kN"
mass = "10.2 t"
[[lines]]
start = "left"
end = "weight"
{SEGMENT}[[lines]]
start = "right"
end = "weight"
{SEGMENT}[motion]
period = "10 s"
heave = "1 mm"
heave_phase = "90 deg"
[dynamics]
duration = "8 s"
ramp = "0 s"
time_step = "0.01 s"
elements = 4
broken_line = 1
broken_at = "1 s"
"""


def test_a_weight_between_two_ropes_becomes_a_pendulum() -> None:
    """Its rope carries W (3 - 2 cos theta) at the bottom, let go at theta from the vertical.

    At 45 degrees the rope that is left has the tension of the pendulum from the start: it does not
    ring.
    """
    network = parse_network(HANGING)
    found = verify_dynamic(network, convergence_check="none")
    left: DynamicPart = found.parts[1]
    run = left.runs[0]
    joint = run.history.nodes[:, 0]
    slope = math.atan2(30.0, 55.0 - joint[0, 2])
    most = max(run.maxima["anchor_tension"], run.maxima["fairlead_tension"])
    assert most == pytest.approx(100e3 * (3.0 - 2.0 * math.cos(slope)), rel=0.02)
    # It swings to the other side, as far as it came from.
    far = float((joint[:, 0] - 30.0).max())
    assert far == pytest.approx(30.0, rel=0.02)


def test_what_does_not_go_with_a_line_that_parts() -> None:
    for change, key in (
        (("broken_line = 1\n", ""), "dynamics.broken_line"),
        (("broken_line = 1\n", "broken_line = 3\n"), "dynamics.broken_line"),
        (('broken_at = "1 s"', 'broken_by = "MBL"\nbroken_at = "1 s"'), "dynamics.broken_at"),
        (('broken_at = "1 s"', 'broken_at = "1 s"\nbroken_end = "anchor"'), "dynamics.broken_end"),
    ):
        assert change[0] in HANGING
        with pytest.raises(InputError) as caught:
            parse_network(HANGING.replace(*change))
        assert key in {each.key for each in caught.value.problems}
    by_MBL = HANGING.replace('broken_at = "1 s"', 'broken_by = "MBL"')
    with pytest.raises(InputError, match="needs its MBL"):
        parse_network(by_MBL.replace('MBL = "900 kN"\n', "", 1))
    assert parse_network(by_MBL).dynamics.broken_by == "MBL"  # type: ignore[union-attr]


FOUR = Path(__file__).parents[1] / "cli" / "cases" / "buoy-four-lines.toml"


def parting_buoy(duration: float) -> Case:
    """Put the buoy on four lines, of which one parts, in waves of next to nothing."""
    case: Case = read_case(FOUR)
    assert case.waves is not None
    assert case.dynamics is not None
    dynamics = replace(
        case.dynamics, duration=duration, runs=1, ramp=0.0, broken_line=1, broken_at=2.0,
        time_step=0.05, output_interval=None,
    )  # fmt: skip
    waves = replace(
        case.waves, spectrum="regular", height=1e-3, period=8.0, peak_enhancement=None,
    )  # fmt: skip
    return replace(case, waves=waves, dynamics=dynamics)


def test_a_buoy_swings_about_where_it_rests_without_the_line() -> None:
    """Out of the plane of the weather, with less than twice the static change of its place."""
    case = parting_buoy(60.0)
    assert parse_case(write_case(case)) == case
    lost = run(case).parts[0].runs[0]
    assert lost.hull is not None
    drive = read_drive(case)
    lines = LinesOfAFloater.at_rest(drive)
    whole = lines.moored_at_rest().state.q
    eyes, legs = lines.hull.eyes[1:], lines.legs[1:]
    left = moored_at_rest(
        replace(lines.hull, eyes=eyes),  # type: ignore[type-var]
        legs,
        [mesh_line(leg.line, drive.dynamics.bars) for leg in legs],
        sea=drive.sea(0),
        properties=drive.properties,
    ).state.q
    change = left[:2] - whole[:2]
    time, place = lost.history.time, lost.hull.place[:, :2]
    assert np.abs(place[time < 1.9] - place[0]).max() < 0.01
    way = (place[time > 2.0] - place[0]) @ change / float(np.hypot(*change))
    static = float(np.hypot(*change))
    assert abs(change[1]) > 0.3 * static
    assert static < float(way.max()) < 2.0 * static
    assert float(way[-len(way) // 4 :].mean()) == pytest.approx(static, rel=0.1)
    assert lost.hull.numerical_part < 0.02
    assert lost.history.balance.numerical_part < 0.05


SHIP = Path(__file__).parents[2] / "cases" / "fso-rang-dong-ship" / "loaded.toml"


def short_ship(**changes: Any) -> Case:
    case: Case = read_case(SHIP)
    assert case.dynamics is not None
    return replace(
        case, dynamics=replace(case.dynamics, duration=400.0, ramp=40.0, runs=1, **changes)
    )


def test_a_ship_goes_on_from_where_a_line_parts() -> None:
    """Up to then as with all lines there, in the same seas; then without the one that parts."""
    case = short_ship(broken_line=1, broken_at=200.0)
    found = verify_ship(case, proven=False)
    assert found.transient is not None
    assert found.transient.parted == (200.0,)
    moored, drive = moored_ship(case)
    waves = drive.sea(0).waves
    assert waves is not None
    assert case.waves is not None
    whole = found.runs[0]
    parted = moored.run(
        waves,
        400.0,
        40.0,
        np.random.default_rng([case.waves.seed, 0, 1]),
        parts=(0, 200.0),
    )
    at = round(200.0 / SLOW_STEP)
    assert parted.course[: at + 1] == pytest.approx(whole.course[: at + 1], abs=1e-12)
    # The force that is gone over the inertia is by how much its acceleration changes.
    pull = moored.zero_load
    assert pull is not None
    assert parted.time[0] >= 200.0
    assert parted.tension.shape[1] == whole.tension.shape[1] - 1
    away = np.hypot(*(parted.course[-1, :2] - whole.course[-1, :2]))
    assert away > 0.01
    judged = [each for each in found.checks.results if each.place.state == "transient"]
    assert {each.place.missing for each in judged} == {1}
    largest = max(each.fairlead.seen for each in found.transient.lines)
    assert largest == pytest.approx(float(parted.tension[:, :, 0].max()), rel=1e-9)
