"""A buoy afloat by its case file: what is refused, what is run, and what the answer holds."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from catopt.answers.motion import motion_answer
from catopt.casefile import parse_case, read_case, write_case
from catopt.errors import InputError
from catopt.floater.hulls import buoy_hull
from catopt.hydro.build import FloatingHull
from catopt.model.dynamics import JudgedBy
from catopt.notes.motion import checks_in_motion
from catopt.render.files import csv_files
from catopt.report.bundle import motion_pictures
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicVerification
from catopt.verify.hulls import hull_of
from catopt.verify.linear import linear_lines
from catopt.words import is_said

FREEDOMS = ("x", "y", "z", "roll", "pitch", "yaw")

CASE = """
title = "Buoy afloat"

[site]
water_depth = "12 m"
seabed_friction = 0.5

[line]
fairlead_height = "10 m"

[[line.segments]]
component = "chain studless R3"
diameter = "30 mm"
length = "40 m"

[load]
horizontal_force = "5 kN"

[waves]
spectrum = "regular"
height = "0.6 m"
period = "8 s"

[floater]
buoy = "pillar 2.4 m"
wind_speed = "15 m/s"
centre_of_gravity = "0.4 m"
pitch_radius = "0.8 m"

[dynamics]
duration = "12 s"
ramp = "4 s"
time_step = "0.1 s"
elements = 8
"""


def test_it_is_written_and_read_again() -> None:
    case = parse_case(CASE)
    assert case.floater is not None
    assert case.floater.wind_speed == 15.0
    assert parse_case(write_case(case)) == case


def test_buoy_and_line_in_a_long_wave() -> None:
    """It rises with the wave, leans from the wind to the line, and nothing of it is led."""
    found = verify_dynamic(parse_case(CASE), convergence_check="none")
    (part,) = found.parts
    (run,) = part.runs
    hull = run.hull
    assert hull is not None
    late = run.history.time > 4.0
    rise = hull.place[late, 2] - hull.place[0, 2]
    assert rise.max() == pytest.approx(hull.surface[late].max(), abs=0.05)
    assert hull.place[0, 4] > 0.0
    by_name = {each.quantity: each for each in found.body}
    assert set(by_name) == {"floater_x", "floater_z", "floater_pitch", "floater_wet"}
    assert by_name["floater_z"].maximum >= hull.place[late, 2].max() - 1e-12
    # At rest the buoy's own mass, the line's pull and the water displaced are one.
    volume = hull.wet[0] * 1025.0 * 9.80665
    lift = -hull.lines[0, 2]
    assert volume == pytest.approx(2000.0 * 9.80665 + lift, rel=1e-5)
    assert run.history.balance.numerical_part < 1e-2
    said = " ".join(str(each) for each in part.remarks)
    assert "pillar 2.4 m" in said
    assert "pitch damping beyond" in said
    assert "centre of gravity" not in said
    table = csv_files(motion_answer(found, with_series=False))
    assert table


@pytest.mark.parametrize(
    ("change", "key"),
    [
        (("[waves]\nspectrum = \"regular\"\nheight = \"0.6 m\"\nperiod = \"8 s\"\n", ""), "waves"),
        (("[dynamics]", '[motion]\nperiod = "8 s"\nheave = "1 m"\n\n[dynamics]'), "motion"),
        (("time_step = ", "broken_line = 2\nbroken_at = \"5 s\"\ntime_step = "), "broken_line"),
    ],
)  # fmt: skip
def test_what_does_not_go_with_it(change: tuple[str, str], key: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_case(CASE.replace(*change))
    assert any(key in each.key for each in caught.value.problems)


FOUR = Path(__file__).parents[1] / "cli" / "cases" / "buoy-four-lines.toml"


@pytest.mark.slow
def test_a_buoy_on_four_lines() -> None:
    """Mirrored lines carry the same, those ahead of the weather the most; sums are the buoy's."""
    case = read_case(FOUR)
    assert parse_case(write_case(case)) == case
    assert case.dynamics is not None
    case = replace(case, dynamics=replace(case.dynamics, duration=60.0))
    found = verify_dynamic(case, convergence_check="none", compares_at_rest=False)
    mean = [part.of("fairlead_tension").mean for part in found.parts]
    assert mean[1] == pytest.approx(mean[2], rel=1e-6)
    assert mean[0] == pytest.approx(mean[3], rel=1e-6)
    assert mean[1] > 2.0 * mean[0]
    (run,) = found.parts[0].runs
    hull = run.hull
    assert hull is not None
    assert hull.scene is not None
    assert len(hull.scene.lines) == 4
    assert hull.scene.towards == 0.0
    # At rest buoyancy carries the buoy and what its lines pull down.
    volume = hull.wet[0] * 1025.0 * 9.80665
    # The drag of the current on what leans pushes it down, too.
    assert volume + hull.lines[0, 2] == pytest.approx(1353.7 * 9.80665, rel=0.05)
    assert {each.quantity for each in found.body} >= {"floater_x", "floater_pitch"}


def test_lines_that_x_does_not_mirror() -> None:
    """Linear motion refuses them; in time the buoy moves in all freedoms, and says so."""
    text = FOUR.read_text(encoding="utf-8")
    with pytest.raises(InputError) as refused:
        linear_lines(parse_case(text.replace('"45 deg"', '"40 deg"')))
    assert [each.key for each in refused.value.problems] == [
        "system.lines[0].azimuth",
        "system.lines[3].azimuth",
    ]
    assert "in time on any lines" in str(refused.value)
    # Two beside one another, and one across from them.
    twice = text.replace('"135 deg", "225 deg"', '"45 deg", "180 deg"')
    with pytest.raises(InputError) as refused:
        linear_lines(parse_case(twice))
    assert len(refused.value.problems) == 3


@pytest.mark.slow
def test_four_lines_in_weather_from_three_sides() -> None:
    """The lines that come up against it carry the most; the buoy rolls, sways and yaws."""
    text = FOUR.read_text(encoding="utf-8")
    text = text.replace('"25 m/s"', '"25 m/s"\nwind_direction = "60 deg"')
    text = text.replace("components = 100", 'components = 100\ndirection = "30 deg"')
    text = text.replace('"1 m/s"', '"1 m/s"\ndirection = "80 deg"')
    case = parse_case(text)
    assert parse_case(write_case(case)) == case
    assert case.dynamics is not None
    case = replace(case, dynamics=replace(case.dynamics, duration=60.0))
    found = verify_dynamic(case, convergence_check="none", compares_at_rest=False)
    mean = [part.of("fairlead_tension").mean for part in found.parts]
    assert max(mean) == mean[2]  # at 225 deg, with the weather towards 55 deg or so
    assert min(mean) == mean[0]
    by_name = {each.quantity: each for each in found.body}
    assert set(by_name) == {f"floater_{each}" for each in FREEDOMS} | {"floater_wet"}
    (run,) = found.parts[0].runs
    hull = run.hull
    assert hull is not None
    assert hull.place[0, 0] > 0.2
    assert hull.place[0, 1] > 0.2
    assert by_name["floater_y"].maximum > by_name["floater_y"].std > 0.0
    assert by_name["floater_roll"].mean < 0.0 < by_name["floater_pitch"].mean
    assert hull.numerical_part < 1e-2
    said = " ".join(str(each) for each in found.parts[0].remarks)
    assert "the force of [system], 8 kN, applies to the results at rest" in said
    # On the plane of the line with the largest tension every eye is as far off as the hull leans.
    scene = hull.scene
    assert scene is not None
    loaded, worst = scene.lines[scene.loaded], scene.worst
    assert loaded[worst, 0, 0] < loaded[worst, -1, 0]
    arm = math.hypot(*(loaded[worst, -1] - scene.place[worst, :2]))
    laid = hull_of(case)
    assert isinstance(laid, FloatingHull)
    x, y, height = laid.eyes[scene.loaded]
    assert laid.centre - height < arm <= math.hypot(x, y, laid.centre - height) + 1e-9
    assert "film.html" in motion_pictures(found, "en")
    assert "all six degrees of freedom" in said
    assert csv_files(motion_answer(found, with_series=False))


def test_a_buoy_that_is_not_there() -> None:
    case = parse_case(CASE.replace("pillar 2.4 m", "pillar 2.5 m"))
    with pytest.raises(InputError, match=r"floater\.buoy"):
        verify_dynamic(case, convergence_check="none")


@pytest.mark.parametrize(
    ("change", "key"),
    [
        (('period = "8 s"', 'period = "8 s"\ndirection = "20 deg"'), "waves.direction"),
        (
            (
                "[floater]",
                '[current]\nprofile = "power"\nspeed = 1.0\ndirection = 0.3\n\n[floater]',
            ),
            "current.direction",
        ),
        (('"15 m/s"', '"15 m/s"\nwind_direction = 0.1'), "floater.wind_direction"),
    ],
)
def test_weather_across_the_line_is_not_linear(change: tuple[str, str], key: str) -> None:
    random = CASE.replace('"regular"', '"jonswap"').replace(*change, 1)
    with pytest.raises(InputError) as caught:
        linear_lines(parse_case(random))
    assert [each.key for each in caught.value.problems] == [key]


def test_a_wide_buoy_is_said_to_be_so() -> None:
    """Waves of 2.5 s are 9.8 m long in deep water: a fifth is 1.95 m, and the buoy has 2.4."""
    text = CASE.replace('period = "8 s"', 'period = "2.5 s"').replace("0.6 m", "0.1 m")
    text = text.replace('duration = "12 s"', 'duration = "1 s"').replace('"4 s"', '"0.5 s"')
    (part,) = verify_dynamic(parse_case(text), convergence_check="none").parts
    assert 0.2 * 9.80665 * 2.5**2 / (2.0 * math.pi) < 2.4
    assert any("above a fifth" in str(each) for each in part.remarks)


STORM = (
    CASE.replace('spectrum = "regular"', 'spectrum = "jonswap"\nseed = 3')
    .replace('height = "0.6 m"\nperiod = "8 s"', 'height = "0.8 m"\nperiod = "4 s"')
    .replace('duration = "12 s"\nramp = "4 s"', 'duration = "100 s"\nramp = "8 s"')
    + 'judged_by = "largest"\n[checks]\nmax_span = "60 m"\ncodes = ["API-RP-2SK"]\n'
    '[buoy]\nreserve_buoyancy = "30 kN"\n'
)


@pytest.fixture(scope="module")
def storm() -> DynamicVerification:
    return verify_dynamic(parse_case(STORM), convergence_check="none", workers=1)


@pytest.mark.parametrize(
    ("judged_by", "end"), [("most-probable", "most_probable"), ("upper", "high")]
)
def test_checks_are_held_against_what_the_case_says(
    storm: DynamicVerification, judged_by: JudgedBy, end: str
) -> None:
    """The storm's maxima by the tail of the same run take the place of its largest values."""
    (part,) = storm.parts
    by_largest = _by_kind(storm)
    drive = part.drive
    dynamics = replace(drive.dynamics, judged_by=judged_by)
    case = replace(storm.case, dynamics=dynamics)
    other = replace(part, drive=replace(drive, case=replace(drive.case, dynamics=dynamics)))
    by_storm = _by_kind(replace(storm, case=case, parts=(other,)))
    ends = {}
    for quantity in ("fairlead_tension", "anchor_tension"):
        of = part.of(quantity)
        assert of.tail is not None
        ends[of.maximum] = max(getattr(of.tail.extreme, end), of.maximum)
    # Bars rise as the end with the larger tension does.
    bars = float(part.runs[0].history.max_tension.max()) * ends[max(ends)] / max(ends)
    judged = max(bars, *ends.values())
    assert judged > by_largest["tension"]
    assert by_storm["tension"] == pytest.approx(judged, rel=1e-12)
    assert by_storm["span"] >= by_largest["span"]
    # The pull on a buoy afloat is the mean one by either: far below its peaks.
    assert by_storm["buoyancy"] == by_largest["buoyancy"]
    history = part.runs[0].history
    assert by_largest["buoyancy"] == pytest.approx(history.course("fairlead_vertical").mean)
    said = checks_in_motion(replace(storm, case=case, parts=(other,))).warnings
    key = f"checks.motion_by_{judged_by.replace('-', '_')}"
    assert any(is_said(each, key) for each in said)


def _by_kind(found: DynamicVerification) -> dict[str, float]:
    return {each.kind: each.demand for each in checks_in_motion(found).results}


def test_waves_that_are_not_random_have_no_storm() -> None:
    case = parse_case(CASE + 'judged_by = "upper"\n')
    with pytest.raises(InputError, match=r'dynamics.judged_by: found "upper"; only a random sea'):
        verify_dynamic(case)


def test_the_scene_holds_together() -> None:
    """The line ends at the buoy's eye at every moment; the worst one has the largest tension."""
    found = verify_dynamic(parse_case(CASE), convergence_check="none")
    run = found.governing.governing
    assert run.hull is not None
    scene = run.hull.scene
    assert scene is not None
    hull = buoy_hull(found.case.floater, 12.0, 1025.0, 0.0)  # type: ignore[arg-type]
    across, _, height = hull.eyes[0]
    for k in range(scene.time.size):
        x, z, pitch = scene.place[k]
        arm = height - hull.centre
        eye = (
            x + across * math.cos(pitch) + arm * math.sin(pitch),
            z + arm * math.cos(pitch) - across * math.sin(pitch),
        )
        assert scene.lines[0][k, -1] == pytest.approx(eye, abs=1e-9)
        assert scene.lines[0][k, 0] == pytest.approx((0.0, 0.0), abs=1e-9)
    counted = run.history.fairlead_tension[run.counted, 0]
    assert scene.tension[scene.worst] == counted.max()
    # A wave of 0.6 m about still water, after the ramp.
    assert np.abs(scene.surface[scene.worst] - 12.0).max() == pytest.approx(0.3, rel=0.02)

    files = motion_pictures(found, "vi")
    assert {"moment.png", "moment.svg", "film.html"} <= set(files)
    text = files["film.html"].decode()
    data = json.loads(re.search(r'id="scene">(.*?)</script>', text).group(1))  # type: ignore[union-attr]
    assert max(data["tension"]) == pytest.approx(scene.tension.max() / 1e3, abs=1e-3)
    assert len(data["lines"][0]) == len(data["surface"]) == len(data["time"])
    assert "Chạy" in text
    assert not re.search(r"(src|href)=", text)
