"""Studies of points and lines: nine legs as a system has them, joints one by one."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from catopt import InputError, read_case
from catopt.answers.study import study_answer
from catopt.casefile import write_case
from catopt.checks.system import check_network
from catopt.model import Checks
from catopt.model.network import Network
from catopt.mooring.fixed_body import at_rest
from catopt.study.file import read_study
from catopt.study.member import read_member
from catopt.study.result import StudyResult
from catopt.study.run import run_study
from catopt.study.statics import points_at_rest, system_of
from catopt.verify.dynamic import verify_dynamic
from tests.mooring.test_bodies import as_points, barge, unequal
from tests.verify.test_network_in_motion import FILE as BRIDLE

FSO = Path(__file__).parents[2] / "cases" / "fso-rang-dong" / "case.toml"
WEATHER = "-4281,0\n1000,-2500\n0,10\n-300,40000\n"


def run(folder: Path, case: str, compute: str, text: str) -> StudyResult:
    (folder / "case.toml").write_text(case, encoding="utf-8")
    head = f'case = "case.toml"\ncompute = "{compute}"\n'
    (folder / "study.toml").write_text(head + text, encoding="utf-8")
    return run_study(folder / "study.toml", workers=1)


def weather(folder: Path, of: str) -> str:
    heads = f"{of}.force[0] (kN),{of}.force[1] (kN)\n"
    (folder / "weather.csv").write_text(heads + WEATHER, encoding="utf-8")
    return '[[vary]]\ntable = "weather.csv"\n'


def member(found: StudyResult, number: int) -> Network:
    network = read_member(found.study.base, found.study.values_of(number))
    assert isinstance(network, Network)
    return network


def test_nine_legs_have_the_digits_of_the_system(tmp_path: Path) -> None:
    case = read_case(FSO)
    assert case.system is not None
    points = as_points(case.system, case.site.water_depth)
    found = run(tmp_path, write_case(points), "statics", weather(tmp_path, "bodies[0]"))
    other = tmp_path / "system"
    other.mkdir()
    known = run(other, FSO.read_text("utf-8"), "statics", weather(other, "system"))
    assert found.reasons == known.reasons
    for each in found.study.base.kept:
        ours, theirs = found.values(each.name), known.values(each.name)
        assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-6, nan_ok=True), each.name


def test_in_bulk_they_are_as_one_by_one() -> None:
    network = as_points(unequal(), 90.0, (120.0, -35.0))
    system = system_of(network)
    assert system is not None
    back = points_at_rest(at_rest(as_points(system, 90.0)))
    for name, value in points_at_rest(at_rest(network)).items():
        assert back[name] == pytest.approx(value, rel=1e-9, abs=1e-6), name
    assert system_of(barge()) is None


def test_a_body_whose_lines_split(tmp_path: Path) -> None:
    text = weather(tmp_path, "bodies[0]").replace("weather", "gusts")
    heads = "bodies[0].force[0] (kN),bodies[0].moment (kN m)\n"
    (tmp_path / "gusts.csv").write_text(heads + "100,0\n-60,50\n20,1e9\n", encoding="utf-8")
    text += '[[vary]]\nkey = "points[3].submerged_weight"\nvalues = ["10 kN", "25 kN"]\n'
    found = run(tmp_path, write_case(barge()), "statics", text)
    assert found.study.pieces == 1
    assert set(found.reasons) == {4, 5}  # which no lines can carry
    assert "turns over" in found.reasons[4]
    for number in range(4):
        for name, value in points_at_rest(at_rest(member(found, number))).items():
            assert found.values(name)[number] == pytest.approx(value, rel=1e-8), name


def test_checks_are_those_of_the_network(tmp_path: Path) -> None:
    case = write_case(barge(checks=Checks(safety_factor=3.0)))
    found = run(tmp_path, case, "checks", weather(tmp_path, "bodies[0]"))
    report = check_network(member(found, 1))
    assert report.governing is not None
    assert found.values("utilisation")[1] == report.governing.utilisation


def test_motion_is_that_of_verify_dynamic(tmp_path: Path) -> None:
    text = 'proof = "none"\n[[vary]]\nkey = "motion.surge"\nvalues = ["0.2 m", "0.6 m"]\n'
    found = run(tmp_path, BRIDLE, "motion", text)
    alone = verify_dynamic(member(found, 1), convergence_check="none")
    tensions = [part.of("fairlead_tension").maximum for part in alone.parts]
    assert found.values("fairlead_tension")[1] == max(tensions)
    anchored = [part.of("anchor_tension").maximum for part in alone.parts if part.is_anchored]
    assert found.values("anchor_tension")[1] == max(anchored)
    assert np.isfinite(found.values("utilisation")).all()


@pytest.mark.parametrize(
    ("compute", "key", "said"),
    [
        ("linear", "motion.surge", '"motion" runs them in time'),
        ("statics", "load.horizontal_force", "no such key"),
        ("statics", "bodies[1].moment", "the file has 0 of them"),
    ],
)
def test_what_points_do_not_have_is_refused(
    compute: str, key: str, said: str, tmp_path: Path
) -> None:
    text = f'[[vary]]\nkey = "{key}"\nvalues = [1.0, 2.0]\n'
    (tmp_path / "case.toml").write_text(BRIDLE, encoding="utf-8")
    head = f'case = "case.toml"\ncompute = "{compute}"\n'
    (tmp_path / "study.toml").write_text(head + text, encoding="utf-8")
    with pytest.raises(InputError, match=said):
        read_study(tmp_path / "study.toml")


def test_fairlead_heights_that_stay_as_the_depth_varies_are_named(tmp_path: Path) -> None:
    depth = barge().site.water_depth
    ends = [k for k, point in enumerate(barge().points) if point.kind == "fairlead"]
    text = f'[[vary]]\nkey = "site.water_depth"\nvalues = [{depth}, {depth + 1.0}]\n'
    found = run(tmp_path, write_case(barge()), "statics", text)
    stay = [f"points[{k}].height" for k in ends]
    assert found.study.heights_that_stay == tuple(stay)
    said = " ".join(f"{each}" for each in study_answer(found).blocks[:2])
    assert f"these fairlead heights above the bed do not: {', '.join(stay)}." in said
    heads = ",".join(["site.water_depth (m)", *(f"{key} (m)" for key in stay)])
    rows = "".join(",".join([f"{depth + up}"] * (1 + len(ends))) + "\n" for up in (0.0, 1.0))
    (tmp_path / "levels.csv").write_text(f"{heads}\n{rows}", encoding="utf-8")
    found = run(tmp_path, write_case(barge()), "statics", '[[vary]]\ntable = "levels.csv"\n')
    assert found.study.heights_that_stay == ()
