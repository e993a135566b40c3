"""A case's ship on two time scales: what is run, judged and refused, and what the answer holds."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catopt import read_case, solve_system
from catopt.answers.motion import ship_answer
from catopt.casefile import parse_case, write_case
from catopt.errors import InputError, NoEquilibriumError
from catopt.fem.extremes import Extreme
from catopt.floater.scales import Scales
from catopt.floater.two_scales import MooredShip
from catopt.model import Case, Motion, System
from catopt.render.card import card_lines
from catopt.render.files import csv_files
from catopt.schemas import schema
from catopt.schemas.validation import inconsistencies
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.result import Verification
from catopt.verify.ship_result import LineOfShip, ShipVerification, drift_csv, led_case, raos_csv
from catopt.verify.two_scales import moored_ship, verify_ship
from catopt.words import Message

LOADED = Path(__file__).parents[2] / "cases" / "fso-rang-dong-ship" / "loaded.toml"
TEXT = LOADED.read_text("utf-8")


def shorter(of: Case, duration: float = 240.0, ramp: float = 40.0, runs: int = 1) -> Case:
    assert of.dynamics is not None
    dynamics = replace(of.dynamics, duration=duration, ramp=ramp, runs=runs)
    return replace(of, dynamics=dynamics)


@cache
def loaded() -> ShipVerification:
    return verify_ship(shorter(read_case(LOADED), runs=2))


def test_the_mean_weather_by_hand() -> None:
    """Wind 1/2 rho V^2 0.90 AF; drift rho g Hs^2/16 B (1 + 2kd/sinh 2kd), by waves of the sea."""
    wind, current, drift = loaded().rest.parts
    assert wind[0] == pytest.approx(-0.5 * 1.221 * 37.4**2 * 588.0 * 0.90, rel=1e-6)
    assert abs(wind[1]) < 1.0
    # UFC's form and friction of 1.46 m/s, the mean over the draught: 0.1 B T and 0.0017 S or so.
    form = 0.5 * 1025.0 * 1.46**2 * 32.0 * 12.5 * 0.1
    assert -current[0] > form
    assert -current[0] < 2.0 * form
    longest = 2.0 * 1025.0 * 9.80665 * 8.48**2 / 16.0 * 32.0  # the factor is between 1 and 2
    whole = verify_ship(reflecting(shorter(read_case(LOADED), 60.0, 10.0), 1.0)).rest.parts[2]
    assert 0.5 * longest < -whole[0] < 0.75 * longest
    # By her form she takes half of that: the bow is no wall, and she moves with the longer waves.
    assert 0.4 < drift[0] / whole[0] < 0.7


def reflecting(case: Case, part: float) -> Case:
    assert case.floater is not None
    assert case.floater.ship is not None
    ship = replace(case.floater.ship, reflection=part)
    return replace(case, floater=replace(case.floater, ship=ship))


def test_it_rests_where_its_lines_have_it() -> None:
    found = loaded()
    assert found.case.system is not None
    solved = solve_system(found.case.system.under(found.rest.force))
    assert found.rest.place[:2] == pytest.approx((solved.position.x, solved.position.y), abs=1e-6)
    assert found.heading == pytest.approx(0.0, abs=math.radians(1.0))


def test_runs_have_seeds_of_their_own_and_the_same_digits_again() -> None:
    first, second = loaded().runs
    assert np.abs(first.slow - second.slow).max() > 0.1
    again = verify_ship(shorter(read_case(LOADED), runs=2)).runs[1]
    assert np.array_equal(again.tension, second.tension)
    assert first.time[0] == 40.0


def test_checks_are_of_the_largest_by_quasi_static_factors() -> None:
    found = loaded()
    tensions = [
        each
        for each in found.checks.results
        if each.kind == "tension" and each.place.state == "intact"
    ]
    assert {each.place.line for each in tensions} == set(range(1, 10))
    at_fairlead = [
        each for each in tensions if each.place.segment == 4 and each.source.code == "API-RP-2SK"
    ]
    for each, line in zip(at_fairlead, found.lines, strict=True):
        most = max(line.fairlead.combined, line.fairlead.seen)
        assert each.demand == pytest.approx(most, rel=1e-9)
        assert each.capacity == pytest.approx(6140e3 / 2.0)  # quasi-static: 2.0, dynamic: 1.67


def test_lines_are_out_whose_loss_is_felt_at_rest() -> None:
    """Each of the three to windward, the hardest first: by the equilibrium of what is left."""
    found = loaded()
    system = found.case.system
    assert system is not None

    def most(of: System) -> float:
        return max(line.tension for line in solve_system(of.under(found.rest.force)).lines)

    whole = most(system)
    left = {k + 1: most(system.without([k])) for k in range(9)}
    harder = {number for number, tension in left.items() if tension > whole}
    assert harder == {1, 2, 3}
    assert {each.missing for each in found.lost} == harder
    assert found.lost[-1].missing == min(harder, key=lambda number: left[number])
    said = next(e for e in found.remarks if e.key == "floater.lines_out_needless")
    assert said.values["numbers"] == "4, 5, 6, 7, 8, 9"


def test_with_a_line_out_it_is_the_ship_on_the_others_in_the_same_seas() -> None:
    """Judged by the factor for one line damaged, 1.43, where it was 2.0 with all there."""
    found = loaded()
    lost = next(each for each in found.lost if each.missing == 2)
    assert found.case.system is not None
    left = replace(found.case, system=found.case.system.without([1]))
    alone = verify_ship(left)
    assert [each.number for each in lost.lines] == [1, 3, 4, 5, 6, 7, 8, 9]
    for each, own in zip(lost.lines, alone.lines, strict=True):
        assert each.fairlead == own.fairlead
        assert each.anchor == own.anchor
    # Counted from where all nine lines have it, no load on it: a metre or some off that of eight.
    apart = math.dist(found.rest.zero, alone.rest.zero)
    assert lost.offset is not None
    assert 0.0 < abs(lost.offset.mean - alone.offset.mean) <= apart
    judged = [
        each
        for each in found.checks.results
        if each.place.missing == 2 and each.place.segment == 4 and each.source.code == "API-RP-2SK"
    ]
    assert len(judged) == 8
    for check, line in zip(judged, lost.lines, strict=True):
        assert check.place.line == line.number
        assert check.demand == pytest.approx(max(line.fairlead.combined, line.fairlead.seen))
        assert check.capacity == pytest.approx(6140e3 / 1.43)


def test_where_nothing_asks_for_it_no_line_is_out() -> None:
    """By a code without factors for it, by the case, and of a ship on one line."""
    case = shorter(read_case(LOADED), 60.0, 10.0)
    assert case.system is not None
    spm = replace(case.checks, codes=("DNV-OS-E301-2008-CC1-SPM",))
    one = replace(case.system, legs=case.system.legs[1:2])
    for changed, key in (
        (replace(case, checks=spm), "checks.line_out_not_judged"),
        (replace(case, system=replace(case.system, judged_line_out=False)), "line_out_not_asked"),
        (replace(case, system=one), "checks.one_line"),
    ):
        found = verify_ship(changed)
        assert found.lost == ()
        assert {each.place.state for each in found.checks.results} == {"intact"}
        assert any(each.key.endswith(key) for each in found.remarks)
        assert found.to_dict()["lines_out"] == []
        assert "ship_lines_out.csv" not in csv_files(ship_answer(found))


def test_where_the_others_do_not_hold_the_ship_that_is_a_failed_check(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    run = MooredShip.run

    def refused(self: MooredShip, *of: Any, **more: Any) -> Any:
        if len(self.system.legs) == 9:
            return run(self, *of, **more)
        raise NoEquilibriumError(Message("floater.line_out_of_reach", number=1, time=9.0), "", 0.0)

    monkeypatch.setattr(MooredShip, "run", refused)
    found = verify_ship(shorter(read_case(LOADED), 60.0, 10.0))
    failed = [each for each in found.checks.results if each.kind == "equilibrium"]
    assert {each.place.missing for each in failed} == {1, 2, 3}
    assert not any(each.passes for each in failed)
    assert "floater.line_out_refused" in {each.key for each in found.remarks}
    document = Verification(found.case, ()).to_dict() | {"ship": found.to_dict()}
    assert list(inconsistencies(document, schema("catopt.verify/1"))) == []
    assert document["ship"]["lines_out"][0]["lines"] == []
    assert "ship_lines_out.csv" not in csv_files(ship_answer(found))


def test_the_excursion_is_checked_by_the_span_of_the_largest_tension() -> None:
    case = shorter(read_case(LOADED), 60.0, 10.0)
    strict = replace(case, checks=replace(case.checks, max_span=1060.0))
    found = verify_ship(strict)
    spans = {e.place.line: e for e in found.checks.results if e.kind == "span"}
    assert not spans[2].passes
    assert spans[2].demand > 1056.0 - found.rest.place[0]
    assert spans[5].passes


def test_the_document_fits_its_schema() -> None:
    found = loaded()
    document = Verification(found.case, ()).to_dict() | {"ship": found.to_dict()}
    assert list(inconsistencies(document, schema("catopt.verify/1"))) == []
    lines = document["ship"]["lines"]
    assert lines[1]["fairlead_tension_N"]["combined"] == found.lines[1].fairlead.combined
    assert document["ship"]["since_s"] == 40.0
    gone = document["ship"]["lines_out"]
    assert [each["missing_line"] for each in gone] == [each.missing for each in found.lost]
    assert [each["line"] for each in gone[0]["lines"]] == [e.number for e in found.lost[0].lines]


def test_the_answer_has_every_line_and_remark() -> None:
    found = loaded()
    answer = ship_answer(found)
    table = csv_files(answer)["ship_lines.csv"].decode().splitlines()
    assert len(table) == 10
    gone = csv_files(answer)["ship_lines_out.csv"].decode().splitlines()
    assert len(gone) == 4
    card = " ".join(each.text for each in card_lines(answer, "en"))
    assert f"Without line {found.lost[0].missing}: " in card
    points = [each for each in answer.blocks if type(each).__name__ == "Points"]
    keys = {each.key for each in points[0].said}  # type: ignore[union-attr]
    assert "floater.few_cycles" in keys  # of 200 s
    wanted = "drift_by_form shallow_drift closed_raos no_roll quasi_static_lines slow_damping"
    assert {f"floater.{each}" for each in wanted.split()} <= keys
    assert "floater.wide_hull" not in keys


def test_where_it_does_not_hold_it_says_so() -> None:
    case = shorter(read_case(LOADED), 60.0, 10.0)
    assert case.waves is not None
    short = replace(case, waves=replace(case.waves, height=8.0, period=6.0))
    keys = {each.key for each in verify_ship(short).remarks}
    assert "floater.wide_hull" in keys
    assert "motion.waves_break" in keys
    assert "floater.shallow_drift" not in keys


def test_the_case_is_written_as_it_was_read() -> None:
    case = read_case(LOADED)
    assert parse_case(write_case(case), folder=str(LOADED.parent)) == case


RAOS = """heading (deg),period (s),surge (m/m),surge_phase (deg),heave (m/m)
180,4,0.1,-90,0.0
180,30,0.9,-90,1.0
190,4,0.1,-90,0.0
190,30,0.9,-90,1.0
170,4,0.1,-90,0.0
170,30,0.9,-90,1.0
"""


def test_raos_and_drift_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "rao.csv").write_text(RAOS)
    rows = [
        f"{per} {beta} {beta} {i} {mod} {phs} {re} 0.0\n"
        for per in (4, 30)
        for beta in (0, 90, 180, 270, 360)
        for i, mod, phs, re in ((1, 0.3, 180, -0.3), (6, 0.0, 0, 0.0))
    ]
    (tmp_path / "ship.8").write_text("".join(rows))
    text = TEXT.replace(
        'wind_direction = "180 deg"',
        f'wind_direction = "180 deg"\ndrift_file = "{tmp_path}/ship.8"\nulen = "100 m"',
    ).replace(
        "[dynamics]",
        f"""[motion]
rao_file = "{tmp_path}/rao.csv"
rao_phase = "lag"
rao_reference = ["-95 m", "0 m", "56 m"]
rao_rotation = "deg/m"
rao_per = "amplitude"

[dynamics]""",
    )
    case = parse_case(text)
    found = verify_ship(shorter(case, 60.0, 10.0))
    moored, drive = moored_ship(case)
    waves = drive.sea(0).waves
    assert waves is not None
    # -0.3 rho g ULEN a^2 of every wave.
    expected = -0.3 * 1025.0 * 9.80665 * 100.0 * float((waves.amplitude**2).sum())
    assert found.rest.parts[2][0] == pytest.approx(expected, rel=1e-6)
    assert moored.reference == (-95.0, 0.0, 56.0)
    keys = {each.key for each in found.remarks}
    assert "floater.drift_of_file" in keys
    assert "floater.closed_raos" not in keys


def without(text: str, *lines: str) -> str:
    for line in lines:
        assert line in text
        text = text.replace(line, "")
    return text


@pytest.mark.parametrize(
    ("change", "keys"),
    [
        (("[floater.ship]", '[floater.ship]\nulen = "1 m"'), {"floater.ship.drift_file"}),
        (('wind_speed = "37.4 m/s"', 'buoy = "pillar 2.4 m"'), {"floater.ship"}),
        (('wind_speed = "37.4 m/s"', "pitch_damping = 0.1"), {"floater.pitch_damping"}),
        (('draught = "12.5 m"\n', ""), {"floater.ship.draught"}),
        (("[dynamics]", '[body]\nmass = "1 t"\n[dynamics]'), {"body"}),
        (("[dynamics]", '[motion]\nperiod = "8 s"\n[dynamics]'), {"motion"}),
        (
            ('ramp = "10 min"', 'broken_line = 1\nbroken_at = "60 s"\nbroken_end = "anchor"'),
            {"dynamics.broken_end"},
        ),
    ],
)
def test_what_does_not_go_together(change: tuple[str, str], keys: set[str]) -> None:
    assert change[0] in TEXT
    with pytest.raises(InputError) as error:
        parse_case(TEXT.replace(*change))
    assert keys <= {each.key for each in error.value.problems}


def test_a_ship_without_its_lines_or_its_sea() -> None:
    table = TEXT[TEXT.index("[system]") : TEXT.index("[floater]")]
    lone = TEXT.replace(table, '[load]\nhorizontal_force = "1 MN"\n\n')
    with pytest.raises(InputError, match="system"):
        parse_case(lone)
    sea = TEXT[TEXT.index("[waves]") : TEXT.index("[current]")]
    with pytest.raises(InputError, match="waves"):
        parse_case(TEXT.replace(sea, ""))


def test_refusals_of_a_run(tmp_path: Path) -> None:
    case = read_case(LOADED)
    with pytest.raises(InputError, match="two time scales"):
        verify_dynamic(case)
    assert case.floater is not None
    assert case.floater.ship is not None
    deep = replace(case.floater, ship=replace(case.floater.ship, draught=17.0, moulded_depth=16.0))
    with pytest.raises(InputError, match=r"floater\.ship\.moulded_depth"):
        verify_ship(replace(case, floater=deep))
    with pytest.raises(InputError, match="a ship is required"):
        verify_ship(replace(case, floater=None, motion=Motion(period=8.0)))
    (tmp_path / "ship.8").write_text("8 0 0 1 0.2 180 0.2 0\n")
    other = replace(case.floater.ship, drift_file=str(tmp_path / "ship.8"), ulen=1.0)
    with pytest.raises(InputError, match=r"ship\.8, line 1"):
        verify_ship(replace(case, floater=replace(case.floater, ship=other)))


AT_SEA = Path(__file__).parents[1] / "answers" / "cases" / "ship-at-sea.toml"


@pytest.mark.parametrize("is_turret", [False, True])
def test_its_lines_in_the_truss_model_are_led_the_same_way(tmp_path: Path, is_turret: bool) -> None:
    """RAOs, drift and mean load of the files: path of the body, and tensions of light motions."""
    text = AT_SEA.read_text("utf-8")
    if is_turret:  # heading 20 deg off x: answers are turned into the axes of the lines
        text = text.replace('fairlead_radius = "4 m"', 'fairlead_radius = "0 m"')
        text = text.replace(
            'moulded_depth = "5 m"', 'moulded_depth = "5 m"\nmooring_point = "12 m"'
        )
        text = text.replace('anchor_radius = "117 m"', 'anchor_radius = "113 m"')
    ship = verify_ship(parse_case(text))
    (tmp_path / "ship_raos.csv").write_text(raos_csv(ship))
    (tmp_path / "ship_drift.csv").write_text(drift_csv(ship))
    prescribed_motion = parse_case(write_case(led_case(ship)), folder=str(tmp_path))
    parts = verify_dynamic(prescribed_motion, convergence_check="none").parts
    run, own = parts[0].runs[0], ship.runs[0]
    assert run.track is not None
    time = run.history.time
    at = (time > 22.0) & (time < 58.0)
    for axis in (0, 1):
        path = np.interp(time[at], own.time, own.whole[:, axis])
        assert run.track[at, axis] == pytest.approx(path, abs=2e-3)
    for part, line in zip(parts, ship.lines, strict=True):
        tension = part.runs[0].history.fairlead_tension[:, 0]
        assert tension.mean() == pytest.approx(line.fairlead.mean, rel=0.02)


def test_what_a_line_is_judged_by() -> None:
    """Largest values: 10 + max(6 + 2 x 2, 5 + 2 x 3) = 21, or what a run reached."""
    scales = Scales(10.0, 3.0, 6.0, 2.0, 5.0, seen=24.0)
    storm = Extreme(10800.0, most_probable=22.0, expected=23.0, low=20.0, high=27.0)
    line = LineOfShip(1, scales, scales, None, storm)
    assert scales.combined == 21.0
    assert [line.judged(by) for by in ("largest", "most-probable", "upper")] == [24.0, 22.0, 27.0]
    assert replace(line, storm=None).judged("upper") == 24.0
    calm = replace(line, fairlead=replace(scales, seen=20.0))
    assert calm.judged("largest") == 21.0


def test_the_checks_go_by_what_is_asked_for_and_say_so() -> None:
    """A ship of an hour of her slow motion has a tail: its upper end stands in every tension."""
    case = shorter(read_case(LOADED), 3600.0, 360.0)
    assert case.dynamics is not None
    asked = replace(case, dynamics=replace(case.dynamics, judged_by="upper"))
    found = verify_ship(asked)
    line = found.lines[found.most_loaded]
    assert line.storm is not None
    assert line.storm.low < line.storm.most_probable < line.storm.high
    demands = {e.demand for e in found.checks.results if e.place.line == line.number}
    assert any(each == pytest.approx(line.storm.high, rel=1e-9) for each in demands)
    assert "floater.judged_upper" in {each.key for each in found.remarks}
