"""``catopt check``: what it prints and writes, what it refuses, and how it ends."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import openpyxl
import pytest

import catopt

from .conftest import CASES, Run, without_digest
from .test_json import document_of
from .test_out import column, names, rows

FILES = {"case.toml", "check.json", "check.xlsx", "checks.csv", "load_cases.csv"}

CASE = """
title = "Chain of 1000 N/m"
[site]
water_depth = "20 m"
[line]
[[line.segments]]
name = "chain"
length = "60 m"
submerged_weight = "1 kN/m"
MBL = "200 kN"
[[load_cases]]
name = "storm"
horizontal_force = "30 kN"
[[load_cases]]
name = "day"
horizontal_force = "10 kN"
water_level = "5 m"
kind = "reference"
[checks]
codes = ["LR-linkspans-2022"]
max_anchor_uplift_angle = "0 deg"
"""
"""T = H + w h: 30 + 20 = 50 kN of 200 / 2 in the storm; 10 + 25 = 35 kN of 200 / 3 by day."""


@pytest.fixture
def case(tmp_path: Path) -> Path:
    path = tmp_path / "case.toml"
    path.write_text(CASE, encoding="utf-8")
    return path


def words(text: str) -> str:
    return " ".join(text.split())


def test_the_document(run: Run, case: Path) -> None:
    document = document_of(run, "check", case)
    assert (document["schema"], document["passes"]) == ("catopt.check/1", True)
    tensions = [each for each in document["checks"] if each["kind"] == "tension"]
    # Six digits, far above rounding, for numbers done by hand.
    assert [round(each["demand"], 6) for each in tensions] == [50e3, 35e3]
    assert [round(each["utilisation"], 6) for each in tensions] == [0.5, 0.525]
    assert document["checks"][document["governing"]] == tensions[1]
    assert [each["utilisation"] for each in document["checks"] if each["unit"] == "rad"] == [
        None,
        None,
    ]


def test_it_prints_what_python_gives(run: Run, case: Path) -> None:
    assert document_of(run, "check", case) == catopt.check_case(catopt.read_case(case)).to_dict()


def test_the_page(run: Run, case: Path) -> None:
    ran = run("check", case)
    assert (ran.status, ran.err) == (0, "")
    text = words(ran.out)
    assert "Load case storm (extreme): horizontal force 30.000 kN, fairlead height 20 m" in text
    assert "Load case day (reference): horizontal force 10.000 kN, fairlead height 25 m" in text
    assert "50.000 kN 100.000 kN 0.500 passes" in text
    assert "0.00 deg 0.00 deg - passes" in text
    assert "All 4 checks pass." in text
    assert "Governing: tension, segment 1 (chain) in load case day, utilisation 0.525" in text
    assert "Confidence: A read in the document itself" in text
    assert max(len(line) for line in ran.out.splitlines()) <= 80


def test_a_failed_check_is_an_answer_unless_strict(run: Run, case: Path) -> None:
    """A fifth of 200 kN is 40 kN, less than the storm's 50."""
    plain = run("check", case, "--code", "break/5")
    strict = run("check", case, "--code", "break/5", "--strict")
    assert (plain.status, plain.err) == (0, "")
    assert (strict.status, strict.err) == (3, "catopt: 1 of 4 checks fails.\n")
    assert strict.out == plain.out
    assert "50.000 kN 40.000 kN 1.250 FAILS" in words(plain.out)
    assert "Governing: tension, segment 1 (chain) in load case storm" in words(plain.out)
    assert run("check", case, "--strict").status == 0


def test_codes_of_the_option_take_the_place_of_the_case_s(run: Run, case: Path) -> None:
    document = document_of(run, "check", case, "--code", "break/5", "--code", "API-RP-2SK")
    assert {each["code"] for each in document["checks"]} == {"user", "break/5", "API-RP-2SK"}
    assert {each["confidence"] for each in document["checks"]} == {None, "A", "B"}


def test_recalled_codes_need_an_option_and_are_marked(run: Run, case: Path) -> None:
    refused = run("check", case, "--code", "ISO-19901-7")
    assert (refused.status, refused.out) == (2, "")
    assert "--code: found" in refused.err
    assert "recalled, read in no document" in refused.err
    ran = run("check", case, "--code", "ISO-19901-7", "--recalled")
    assert "ISO-19901-7 [R]" in words(ran.out)
    assert "Warning: ISO-19901-7: recalled, read in no document: its line" in words(ran.out)


def test_a_misspelt_code_is_told_with_the_nearest(run: Run, case: Path) -> None:
    ran = run("check", case, "--code", "UFC-4-159-3")
    assert (ran.status, ran.out) == (2, "")
    assert "did you mean UFC-4-159-03? there are break/5," in ran.err


def test_what_is_missing_is_2(run: Run, case: Path) -> None:
    case.write_text(CASE.replace('MBL = "200 kN"', ""), encoding="utf-8")
    ran = run("check", case, "--json")
    assert (ran.status, ran.out) == (2, "")
    assert "line.segments[0].MBL: missing; give it" in ran.err


def test_no_equilibrium_is_3_and_names_the_load_case(run: Run, case: Path) -> None:
    case.write_text(CASE.replace('"5 m"', '"45 m"'), encoding="utf-8")
    ran = run("check", case)
    assert (ran.status, ran.out) == (3, "")
    assert 'load case "day"' in ran.err


def test_the_files(run: Run, case: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    ran = run("check", case, "--json", "--out", out)
    assert (ran.status, ran.err) == (0, f"{len(FILES)} files written to {out}\n")
    assert names(out) == FILES
    assert without_digest(out / "check.json") == json.loads(ran.out)
    document = json.loads(ran.out)
    table = rows(out / "checks.csv")
    assert [row["Passes"] for row in table] == ["yes"] * 4
    assert [row["Unit"] for row in table] == ["kN", "deg", "kN", "deg"]
    for row, each in zip(table, document["checks"], strict=True):
        assert row["Check"] == each["name"]
        assert row["Source"] == each["source"]
    assert float(table[0]["Demand (unit of the row)"]) == document["checks"][0]["demand"] / 1e3
    book = openpyxl.load_workbook(out / "check.xlsx")
    assert book.sheetnames == ["Checks", "Load cases"]
    assert column(book["Load cases"], "Load case") == ["storm", "day"]


# ------------------------------------------------------------------ a body with several lines


def test_a_body_is_judged_intact_and_with_every_line_out_by_two_codes(
    run: Run, tmp_path: Path
) -> None:
    """API: 1585.434 * 2.00 / 6140 = 0.516 intact, 2333.375 * 1.43 / 6140 = 0.543 without line 1.

    E301, class 1: 1585.434 * 1.70 / (0.95 * 6140) = 0.462, 2333.375 * 1.10 / (0.95 * 6140) = 0.440.
    """
    fso = CASES / "fso-rang-dong" / "case.toml"
    ran = run("check", fso, "--out", tmp_path / "out")
    shown = words(ran.out)
    assert ran.status == 0
    assert "intact 0.516 0.462 passes" in shown
    assert "line 1 out 0.543 0.440 passes" in shown
    assert "line 9 out" in shown
    # 9 lines and 9 times 8, each of 4 segments, by two codes.
    assert f"All {(9 + 9 * 8) * 4 * 2} checks pass." in shown
    assert "line 2, line 1 out: utilisation 0.543 (API RP 2SK (3rd edition, 2005)" in shown
    with (tmp_path / "out" / "checks.csv").open(encoding="utf-8", newline="") as file:
        assert len(list(csv.reader(file))) == 1 + 648


def test_a_line_that_cannot_be_lost_fails_by_the_code_for_that(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "one.toml"
    path.write_text(ONE_LEG, encoding="utf-8")
    for language, said in (("en", "no line is left"), ("vi", "không còn dây nào")):
        ran = run("check", path, "--strict", "--lang", language)
        assert (ran.status, said in ran.out) == (3, True)
    assert json.loads(run("check", path, "--json").out)["checks"][-1]["kind"] == "equilibrium"


def test_a_wrong_code_stops_the_equilibrium_of_a_body_too(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "one.toml"
    path.write_text(ONE_LEG.replace("DNV-OS-E301-2008-CC1", "NONSENSE"), encoding="utf-8")
    ran = run("system", path)
    assert (ran.status, ran.out) == (2, "")
    assert 'checks.codes[0]: found "NONSENSE"' in ran.err


ONE_LEG = """
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "60 m"
submerged_weight = "1 kN/m"
MBL = "200 kN"
[system]
anchor_radius = "40 m"
azimuths = ["0 deg"]
force = ["-60 kN", "0 kN"]
[checks]
codes = ["DNV-OS-E301-2008-CC1"]
"""


@pytest.mark.parametrize("command", ["solve", "curve", "verify", "export --to moordyn"])
def test_a_code_that_is_none_is_refused_by_every_command(
    run: Run, tmp_path: Path, command: str
) -> None:
    case = tmp_path / "case.toml"
    text = (CASES / "buoy-9.5m" / "case.toml").read_text("utf-8")
    case.write_text(text + '[checks]\ncodes = ["NONSENSE"]\n', encoding="utf-8")
    ran = run(*command.split(), case)
    assert ran.status == 2
    assert 'checks.codes[0]: found "NONSENSE"; there are break/5, IALA-CALMAR' in ran.err


def test_the_language_may_be_set_once_for_all(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    case = "cases/buoy-9.5m/case.toml"
    english, vietnamese = run("solve", case).out, run("solve", case, "--lang", "vi").out
    monkeypatch.setenv("CATOPT_LANG", "vi")
    assert run("solve", case).out == vietnamese
    assert run("solve", case, "--lang", "en").out == english
    monkeypatch.setenv("CATOPT_LANG", "fr")
    refused = run("solve", case)
    assert refused.status == 2
    assert "CATOPT_LANG" in refused.err
