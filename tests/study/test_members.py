"""What is computed of members, against the single answer of each."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import catopt
from catopt.answers.blocks import Table, Verdict, Warnings
from catopt.answers.study import study_answer
from catopt.checks.case import check_case
from catopt.constants import YEAR
from catopt.study.file import read_study
from catopt.study.member import read_member, with_changes
from catopt.study.result import StudyResult
from catopt.study.run import run_into, run_study
from catopt.study.statics import one_at_rest
from catopt.study.store import Store
from catopt.verify.linear import linear_lines
from tests.sizing.at_rest import size_buoy

CASES = Path(__file__).parents[2] / "cases"
EXACT = 1e-9


def run(folder: Path, text: str) -> StudyResult:
    (folder / "study.toml").write_text(text, encoding="utf-8")
    return run_study(folder / "study.toml", workers=1)


def head(case: str, compute: str) -> str:
    return f'case = "{(CASES / case).as_posix()}"\ncompute = "{compute}"\n'


def check_against_single(found: StudyResult, members: list[int]) -> None:
    for member in members:
        case = read_member(found.study.base, found.study.values_of(member))
        assert isinstance(case, catopt.Case)
        for name, value in one_at_rest(case).items():
            ours = found.values(name)[member]
            assert ours == pytest.approx(value, rel=EXACT, abs=1e-9 * abs(value) + 1e-6), name


def test_a_line_under_loads_lengths_and_depths(tmp_path: Path) -> None:
    text = head("buoy-9.5m/case.toml", "statics")
    text += '[[vary]]\nkey = "site.water_depth"\nvalues = ["9 m", "9.5 m"]\n'
    text += '[[vary]]\nkey = "line.segments[0].length"\nvalues = ["20 m", "30 m", "9 m"]\n'
    text += '[[vary]]\nkey = "load.horizontal_force"\nmin = "0.1 tf"\nmax = "1 tf"\ncount = 4\n'
    found = run(tmp_path, text)
    assert found.is_complete
    solved = [k for k in range(24) if k not in found.reasons]
    assert sorted(found.reasons) == [*range(8, 12), *range(20, 24)]  # 9 m of chain in 9 m or more
    assert "short" in found.reasons[20] or "reach" in found.reasons[20]
    check_against_single(found, solved)


def test_a_body_of_nine_lines(tmp_path: Path) -> None:
    rows = ["system.force[0] (kN),system.force[1] (kN)", "-4281,0", "1000,-2500", "0,10"]
    (tmp_path / "t.csv").write_text("\n".join(rows) + "\n")
    text = head("fso-rang-dong/case.toml", "statics") + '[[vary]]\ntable = "t.csv"\n'
    found = run(tmp_path, text)
    check_against_single(found, [0, 1, 2])


def test_a_drawn_load_out_of_its_range_is_a_member_without_an_answer(tmp_path: Path) -> None:
    text = head("buoy-9.5m/case.toml", "statics") + "samples = 50\n"
    text += '[[vary]]\nkey = "load.horizontal_force"\ndistribution = "normal"\n'
    text += 'mean = "1 kN"\ndeviation = "1 kN"\n'
    found = run(tmp_path, text)
    drawn = found.study.axes[0].columns["load.horizontal_force"]
    assert sorted(found.reasons) == np.flatnonzero(np.asarray(drawn) <= 0.0).tolist()
    assert found.reasons
    assert set(found.reasons.values()) == {"load.horizontal_force: must be above 0 N"}
    assert np.isnan(found.values("span")[sorted(found.reasons)]).all()


def test_a_member_whose_file_is_wrong_says_what(tmp_path: Path) -> None:
    text = head("dynamic-chain-56m/case.toml", "statics")
    text += '[[vary]]\nkey = "site.seabed_slope"\nvalues = ["0 deg", "1 deg"]\n'
    found = run(tmp_path, text)
    assert list(found.reasons) == [1]
    assert found.reasons[1].startswith("site.seabed_slope: found 1 deg; must be 0 or left out")


def test_a_line_with_a_buoy_is_held_below_the_surface(tmp_path: Path) -> None:
    text = (CASES / "buoy-9.5m/case.toml").read_text()
    text += '\n[[line.point_loads]]\nposition = "10 m"\nsubmerged_weight = "-2500 N"\n'
    (tmp_path / "case.toml").write_text(text)
    study = 'case = "case.toml"\ncompute = "statics"\n[[vary]]\nkey = "load.horizontal_force"\n'
    found = run(tmp_path, study + 'values = ["30 kN", "0.01 kN"]\n')
    assert list(found.reasons) == [1]
    assert "surface" in found.reasons[1]
    check_against_single(found, [0])


def test_checks_of_each_member(tmp_path: Path) -> None:
    text = head("tanker-20m/case.toml", "checks")
    text += '[[vary]]\nkey = "line.segments[0].length"\nvalues = ["200 m", "250 m"]\n'
    found = run(tmp_path, text)
    for member in (0, 1):
        document = with_changes(found.study.base, found.study.values_of(member))
        case = catopt.casefile.reading.case_of(document, "", folder=found.study.base.folder)
        governing = check_case(case).governing
        assert governing is not None
        assert found.values("utilisation")[member] == governing.utilisation
        assert found.store.words([member]) == [(str(governing.in_case),)]


WEARING = """
[site]
water_depth = "20 m"

[line]

[[line.segments]]
component = "chain studless R3"
diameter = "76 mm"
length = "300 m"

[load]
horizontal_force = "1500 kN"

[service]
life = "20 years"
wear_rate = "0.8 mm/year"

[checks]
safety_factor = 2.0
"""


def _member(found: StudyResult, member: int) -> catopt.Case:
    case = read_member(found.study.base, found.study.values_of(member))
    assert isinstance(case, catopt.Case)
    return case


def test_the_year_in_which_a_check_first_fails(tmp_path: Path) -> None:
    """The first member beyond a limit: the chain wears until a check fails."""
    (tmp_path / "case.toml").write_text(WEARING)
    text = 'case = "case.toml"\ncompute = "checks"\nlimits = { failing = 0 }\n'
    text += '[[vary]]\nkey = "service.life"\nmin = "0 years"\nmax = "40 years"\ncount = 41\n'
    found = run(tmp_path, text)
    failing = found.values("failing")
    first = found.statistics[1].first_beyond
    assert first is not None
    assert failing[first - 1] == 0.0 < failing[first]
    assert not check_case(_member(found, first)).passes
    assert check_case(_member(found, first - 1)).passes
    assert found.study.values_of(first)["service.life"] == pytest.approx(first * YEAR)
    (table,) = (
        block
        for block in study_answer(found).sections[0].blocks
        if isinstance(block, Table) and block.name == "study_limits"
    )
    assert str(table.columns[-1].values[0]) == f"{first} years"


def test_sizings_of_a_fleet() -> None:
    found = run_study(CASES / "study-fleet/study.toml", workers=1)
    for member, (buoy, depth, low, current, hs) in enumerate(
        [
            ("pillar 1.8 m", "8.5 m", "6.5 m", "2 kn", "0.8 m"),
            ("pillar 1.8 m", "9 m", "7 m", "2 kn", "0.8 m"),
        ]
    ):
        alone = size_buoy(
            buoy, depth=depth, low_water=low, current=current, hs=hs, wind="25 m/s", period="6 s",
            chain=["chain open-link 4D Q2"], prefer="balanced", soil="clean fine to medium sand",
            sinker="concrete", code="IALA-CALMAR", life="5 years", wear="0.4 mm/year",
        )  # fmt: skip
        assert found.values("mass")[member] == alone.point.objectives["mass_kg"]
        assert found.values("swing_radius")[member] == alone.swing.total
        assert alone.sinker is not None
        assert found.values("holding_mass")[member] == alone.sinker.mass


@pytest.mark.slow
def test_motion_is_that_of_verify_dynamic(tmp_path: Path) -> None:
    found = run_study(CASES / "study-chain-56m/study.toml", tmp_path, workers=2)
    case = read_member(found.study.base, found.study.values_of(5))
    assert isinstance(case, catopt.Case)
    assert case.waves is not None
    assert (case.waves.height, case.waves.period, case.waves.seed) == (6.0, 11.0, 2)
    alone = catopt.verify_dynamic(case, convergence_check="none", workers=1).parts[0]
    assert found.values("fairlead_tension")[5] == alone.of("fairlead_tension").maximum
    assert found.values("fairlead_deviation")[5] == alone.of("fairlead_tension").std
    assert found.values("grounded_length")[5] == alone.of("grounded_length").minimum
    here = run_study(CASES / "study-chain-56m/study.toml", workers=1)
    assert np.array_equal(found.values("anchor_tension"), here.values("anchor_tension"))


@pytest.mark.slow
def test_linear_motion_is_that_of_the_case(tmp_path: Path) -> None:
    """By member; those that may go slack are said to, and in the answer, too."""
    text = head("dynamic-chain-56m/case.toml", "linear")
    text += '[[vary]]\nkey = "waves.height"\nvalues = ["1 m", "3 m", "7 m"]\n'
    found = run(tmp_path, text)
    for member in range(3):
        case = read_member(found.study.base, found.study.values_of(member))
        assert isinstance(case, catopt.Case)
        (line,) = linear_lines(case)
        assert found.values("fairlead_deviation")[member] == line.deviation
        assert found.values("fairlead_probable")[member] == line.most_probable(3 * 3600.0)
    assert found.store.words([0, 1, 2]) == [("yes",), ("yes",), ("no",)]
    blocks = study_answer(found).sections[0].blocks
    said = [str(each) for block in blocks if isinstance(block, Warnings) for each in block.said]
    assert said[0].startswith("Of the members, 1 may go slack")


@pytest.mark.slow
def test_a_thousand_hours_on_nine_lines_are_those_of_the_single_solver(tmp_path: Path) -> None:
    rng = np.random.default_rng(40)
    force, heading = 3000.0 * rng.weibull(2.0, 1000), rng.uniform(0.0, 2.0 * np.pi, 1000)
    table = np.column_stack([force * np.cos(heading), force * np.sin(heading)])
    heads = "system.force[0] (kN),system.force[1] (kN)"
    np.savetxt(tmp_path / "hours.csv", table, "%.3f", ",", header=heads, comments="")
    text = head("fso-rang-dong/case.toml", "statics") + '[[vary]]\ntable = "hours.csv"\n'
    found = run(tmp_path, text)
    check_against_single(found, [k for k in range(1000) if k not in found.reasons])


@pytest.mark.slow
def test_what_is_there_is_not_computed_again(
    tmp_path: Path,
) -> None:
    text = head("tanker-20m/case.toml", "checks")
    text += '[[vary]]\nkey = "line.segments[0].length"\nmin = "200 m"\nmax = "300 m"\ncount = 150\n'
    (tmp_path / "study.toml").write_text(text)
    study = read_study(tmp_path / "study.toml")
    assert study.pieces == 2
    store = Store(study, tmp_path / "out")
    told: list[int] = []

    def stop(done: int, _: int) -> None:
        told.append(done)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_into(study, store, progress=stop)
    assert told == [100]
    assert StudyResult(study, store).done == 100
    store.close()
    again = Store(study, tmp_path / "out")
    run_into(study, again, progress=lambda done, _: told.append(done))
    assert told == [100, 150]
    whole = run_study(tmp_path / "study.toml")
    ours = StudyResult(study, again)
    assert np.array_equal(ours.values("utilisation"), whole.values("utilisation"))


def test_statistics_say_of_how_many_they_are_and_what_fails_without_them(tmp_path: Path) -> None:
    """An uplift where none is allowed has no utilisation: the member is in no mean of it.

    100 m of chain in 20 m of water lie on the bed up to w (s^2 - h^2) / 2 h, some 300 kN.
    """
    case = WEARING.replace("300 m", "100 m")
    (tmp_path / "case.toml").write_text(f"{case}max_anchor_uplift_angle = 0\n")
    text = 'case = "case.toml"\ncompute = "checks"\n[[vary]]\nkey = "load.horizontal_force"\n'
    found = run(tmp_path, f'{text}values = ["100 kN", "200 kN", "600 kN"]\n')
    used, failing = found.values("utilisation"), found.values("failing")
    assert np.isnan(used).tolist() == [False, False, True]
    assert failing[:2].tolist() == [0.0, 0.0]
    assert failing[2] > 0.0
    assert found.fails_unused == 1
    said = [f"{each.said}" for each in study_answer(found).blocks if isinstance(each, Verdict)]
    assert "Utilisation is over 2 of 3 members: the others have none." in said
    assert any(each.startswith("1 member fails a check that has no utilisation") for each in said)
    (table,) = (each for each in study_answer(found).blocks if getattr(each, "name", "") == "study")
    assert isinstance(table, Table)
    (members,) = (each for each in table.columns if f"{each.name}" == "Members")
    assert members.values == (2, 3)
    assert members.priority == 0  # it stays on the narrowest screen
    whole = run(tmp_path, f'{text}values = ["100 kN", "200 kN"]\n')
    assert whole.fails_unused == 0
    assert not any("no utilisation" in f"{each}" for each in study_answer(whole).blocks)
