"""Points and lines in motion, from their file to what is answered."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from catopt import InputError
from catopt.casefile import write_case
from catopt.casefile.reading import parse_mooring, parse_network
from catopt.checks.case import check_strengths
from catopt.model.network import Network
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_out import each_line_out
from catopt.notes.motion import checks_in_motion
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_setup import check_for_motion

SEGMENT = """
[[lines.segments]]
length = "{length} m"
submerged_weight = "{weight} N/m"
mass = "{mass} kg/m"
EA = "{EA} MN"
MBL = "400 kN"
drag_diameter = "40 mm"
drag_normal = 1.6
"""
LEG = SEGMENT.format(length=105, weight=300, mass=35.2, EA=30)
PENNANT = SEGMENT.format(length=58, weight=200, mass=23.5, EA=20)
POINTS = """
title = "Bridle"
[site]
water_depth = "60 m"
[[points]]
name = "port"
kind = "anchor"
x = "-80 m"
y = "40 m"
height = "0 m"
[[points]]
name = "starboard"
kind = "anchor"
x = "-80 m"
y = "-40 m"
height = "0 m"
[[points]]
name = "buoy"
kind = "joint"
submerged_weight = "-8 kN"
mass = "300 kg"
drag_area = "1 m^2"
drag_coefficient = 0.8
added_mass_coefficient = 0.5
[[points]]
name = "bow"
kind = "fairlead"
x = "60 m"
y = "0 m"
height = "55 m"
"""
LINES = f"""
[[lines]]
name = "leg"
start = "port"
end = "buoy"
{LEG}
[[lines]]
start = "buoy"
end = "starboard"
{LEG}
[[lines]]
name = "pennant"
start = "buoy"
end = "bow"
{PENNANT}
"""
MOTION = """
[motion]
period = "8 s"
surge = "0.6 m"
heave = "0.4 m"
heave_phase = "90 deg"
"""
DYNAMICS = """
[dynamics]
duration = "24 s"
elements = 10
"""
CHECKS = """
[checks]
safety_factor = 2.0
max_anchor_uplift_angle = "60 deg"
"""
SINKER = """
[anchor]
kind = "sinker"
mass = "4 t"
submerged_weight = "20 kN"
friction = 0.5
max_slide = "1 m"
"""
FILE = POINTS + LINES + MOTION + DYNAMICS + CHECKS


def test_bridle_moves_about_its_rest() -> None:
    network = parse_network(FILE)
    found = verify_dynamic(network)
    assert found.verdict == "converged"
    rest = at_rest(network)
    # Of 10 bars, whose ends are a part of the length in a hundred off: 0.1 %.
    for part, line in zip(found.parts, rest.lines, strict=True):
        (run,) = part.runs
        assert run.history.anchor_tension[0, 0] == pytest.approx(line.anchor.tension, rel=2e-3)
        assert run.history.fairlead_tension[0, 0] == pytest.approx(line.fairlead.tension, rel=2e-3)
        assert part.of("fairlead_tension").maximum > 1.05 * line.fairlead.tension
        assert part.slack_time == 0.0
    assert [part.shown for part in found.parts] == ["leg", "2", "pennant"]
    (buoy,) = found.joints
    assert buoy.rest == pytest.approx(rest.place_of("buoy"), abs=0.05)
    assert buoy.least[2] < buoy.rest[2] < buoy.largest[2]
    # A bridle that is alike on either side, given from either end, stays in its plane.
    assert buoy.least[1] == pytest.approx(0.0, abs=1e-6)
    port, starboard, pennant = (part.of("fairlead_tension") for part in found.parts)
    assert port.maximum == pytest.approx(starboard.maximum, rel=1e-6)
    assert pennant.maximum > port.maximum
    assert found.governing.shown == "pennant"


def test_anchors_are_judged_and_joints_are_not() -> None:
    report = checks_in_motion(verify_dynamic(parse_network(FILE), convergence_check="none"))
    judged = {(each.place.line, each.name.split(",")[0]) for each in report.results}
    tension = {(line, "tension") for line in (1, 2, 3)}
    assert {each for each in judged if each[1] == "tension"} == tension
    assert {line for line, name in judged if name != "tension"} == {1, 2}


def test_waves_move_lines_whose_ends_are_held() -> None:
    waves = '[waves]\nspectrum = "regular"\nheight = "3 m"\nperiod = "8 s"\n'
    found = verify_dynamic(
        parse_network(POINTS + LINES + waves + DYNAMICS), convergence_check="none"
    )
    (buoy,) = found.joints
    assert buoy.way > 0.05
    (run,) = found.parts[2].runs
    assert np.ptp(run.history.fairlead[:, 0, 0]) == 0.0


def test_a_motion_of_a_file_counts_from_the_folder(tmp_path: Path) -> None:
    times = np.arange(0.0, 24.1, 0.5)
    rows = [f"{t},{0.3 * (1 - np.cos(t)):.6f},0,0" for t in times]
    (tmp_path / "bow.csv").write_text("t,x,y,z\n" + "\n".join(rows))
    text = POINTS + LINES + '[motion]\nfile = "bow.csv"\n' + DYNAMICS
    network = parse_mooring(text, folder=str(tmp_path))
    assert isinstance(network, Network)
    found = verify_dynamic(network, convergence_check="none")
    (run,) = found.parts[2].runs
    assert np.ptp(run.history.fairlead[:, 0, 0]) == pytest.approx(0.6, abs=0.01)


def test_written_and_read_again_it_is_the_same() -> None:
    network = parse_network(FILE)
    assert parse_network(write_case(network)) == network


def test_at_rest_its_motion_makes_no_difference() -> None:
    drag = 'drag_area = "1 m^2"\ndrag_coefficient = 0.8\n'
    moving, still = parse_network(FILE), parse_network(POINTS.replace(drag, "") + LINES)
    assert at_rest(moving).joints == at_rest(still).joints
    for one, other in zip(each_line_out(moving), each_line_out(still), strict=True):
        assert one.to_dict() == other.to_dict()


def refused(text: str) -> str:
    def read() -> None:
        network = parse_network(text)
        check_for_motion(network)
        check_strengths(network)

    with pytest.raises(InputError) as caught:
        read()
    return str(caught.value)


def test_what_lines_in_motion_lack_is_named_at_once() -> None:
    bare = FILE.replace('mass = "35.2 kg/m"\n', "").replace('mass = "300 kg"\n', "")
    said = refused(bare.replace("drag_normal = 1.6\n", ""))
    for key in ("points[2].mass", "lines[0].segments[0].mass", "lines[2].segments[0].drag_normal"):
        assert key in said
    assert "lines[1].segments[0].MBL" in refused(FILE.replace('MBL = "400 kN"\n', ""))


@pytest.mark.parametrize(
    ("text", "key"),
    [
        (POINTS + LINES + MOTION, "motion"),
        (POINTS + LINES + DYNAMICS, "dynamics"),
        (FILE.replace('"24 s"', '"24 s"\nramp = "30 s"'), "dynamics.ramp"),
        (FILE + SINKER, "anchor.max_slide"),
        (FILE.replace('"24 s"', '"24 s"\nbroken_line = 9\nbroken_at = "12 s"'), "broken_line"),
        (FILE.replace('kind = "fairlead"', 'kind = "anchor"'), "motion"),
        (FILE.replace('period = "8 s"\n', ""), "motion"),
        (FILE.replace('kind = "anchor"', 'kind = "anchor"\nmass = "3 kg"', 1), "points[0].mass"),
    ],
    ids=lambda each: each if len(each) < 20 else "",
)  # fmt: skip
def test_what_does_not_go_together_is_refused(text: str, key: str) -> None:
    assert key in refused(text)
