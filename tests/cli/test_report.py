"""``catopt report``: where the page goes, what is told of it, and what stops it."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import jsonschema
import openpyxl
import pytest

from catopt import schemas
from catopt.errors import NotConvergedError
from tests.report.page_cases import design_directory
from tests.report.page_reader import read_page
from tests.report.system_page_cases import system_path

from .conftest import BUOY, CASES, Run


@pytest.fixture(autouse=True)
def _inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_the_page_is_written_beside_the_user_and_its_place_printed(run: Run) -> None:
    ran = run("report", BUOY)
    assert (ran.status, ran.err) == (0, "")
    assert ran.out == "buoy-9.5m.html\n"
    page = read_page(Path("buoy-9.5m.html").read_bytes())
    assert page.tagged("h1")[0].text == "Marker buoy, 9.5 m"
    assert [path.name for path in Path().iterdir()] == ["buoy-9.5m.html"]


@pytest.mark.parametrize(
    ("arguments", "written"),
    [
        (["--out", "note.html"], ["note.html"]),
        (["--out", "notes/note.HTML"], ["notes/note.HTML"]),
        (["--out", "notes/note.HTML", "--xlsx"], ["notes/note.HTML", "notes/note.xlsx"]),
        (["--xlsx"], ["buoy-9.5m.html", "buoy-9.5m.xlsx"]),
        (["--out", "notes"], ["notes/buoy-9.5m.html", "notes/buoy-9.5m.xlsx"]),
        (["--out", "notes.v2"], ["notes.v2/buoy-9.5m.html", "notes.v2/buoy-9.5m.xlsx"]),
    ],
)
def test_out_names_a_file_or_a_directory(
    run: Run, arguments: list[str], written: list[str]
) -> None:
    ran = run("report", BUOY, *arguments)
    assert ran.status == 0
    assert ran.out.splitlines() == written
    made = sorted(str(path) for path in Path().rglob("*.*") if path.is_file())
    assert made == sorted(written)
    assert Path(written[0]).read_bytes().startswith(b"<!DOCTYPE html>")
    for workbook in written[1:]:
        assert openpyxl.load_workbook(workbook).sheetnames[0] == "The answer"


def test_a_directory_may_end_like_a_page(run: Run) -> None:
    Path("odd.html").mkdir()
    assert run("report", BUOY, "--out", "odd.html").out.splitlines()[0] == (
        "odd.html/buoy-9.5m.html"
    )


def test_json_tells_of_the_workbook(run: Run) -> None:
    document = json.loads(run("report", BUOY, "--json", "--out", "notes").out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.report/1")).validate(document)
    content = Path(document["workbook"]["path"]).read_bytes()
    assert document["workbook"]["bytes"] == len(content)
    assert document["workbook"]["sha256"] == hashlib.sha256(content).hexdigest()
    assert json.loads(run("report", BUOY, "--json").out)["workbook"] is None


def test_json_tells_what_was_written(run: Run) -> None:
    case = CASES / "tanker-20m-sinker" / "case.toml"
    ran = run("report", case, "--json", "--lang", "vi", "--date", "21.11.2026")
    assert (ran.status, ran.err) == (0, "")
    document = json.loads(ran.out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.report/1")).validate(document)
    page = Path(document["path"]).read_bytes()
    assert document["bytes"] == len(page)
    assert document["sha256"] == hashlib.sha256(page).hexdigest()
    assert (document["language"], document["date"]) == ("vi", "21.11.2026")
    digest = hashlib.sha256(case.read_bytes()).hexdigest()
    assert document["sources"] == [{"name": "case.toml", "sha256": digest}]
    assert document["sections"] == list(read_page(page).sections)
    assert document["passes"] is True
    assert document["governing"].startswith("tension, segment 1")


def test_json_tells_of_the_verification(run: Run) -> None:
    verified = json.loads(run("verify", BUOY, "--json").out)
    worst = verified["static"]["worst"]
    told = json.loads(run("report", BUOY, "--json").out)["verification"]
    assert told == {
        "verdict": verified["verdict"],
        "worst": {key: worst[key] for key in ("quantity", "unit", "gap")},
        "failure": "",
    }


def test_the_verification_may_be_left_out(run: Run) -> None:
    document = json.loads(run("report", BUOY, "--no-verify", "--json").out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.report/1")).validate(document)
    assert document["verification"] is None
    assert "verification" not in document["sections"]


def test_a_truss_without_an_answer_is_told_and_the_note_written(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError("it stopped short")

    monkeypatch.setattr("catopt.verify.case.verify_case", stops)
    ran = run("report", BUOY, "--json")
    document = json.loads(ran.out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.report/1")).validate(document)
    told = {"verdict": "no answer", "worst": None, "failure": "it stopped short"}
    assert (ran.status, document["verification"]) == (0, told)
    assert any("not verified" in warning for warning in document["warnings"])


def test_a_design_is_named_or_recommended(run: Run, tmp_path: Path) -> None:
    directory = design_directory(tmp_path)
    document = json.loads(run("report", directory, "--json").out)
    assert (document["design"], document["path"]) == (2, "result-design-2.html")
    assert [each["name"] for each in document["sources"]] == ["case.toml", "design.json"]
    assert "front" in document["sections"]
    document = json.loads(run("report", directory, "--design", 3, "--json").out)
    assert (document["design"], document["path"]) == (3, "result-design-3.html")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["gone.toml"], "there is no such file"),
        (["result", "--design", "4"], "the front has the designs 1 to 3"),
        (["result", "--design", "0"], "the front has the designs 1 to 3"),
        ([str(BUOY), "--design", "1"], "a directory that catopt design --out wrote"),
        ([str(CASES)], "a directory with a case.toml is wanted"),
        ([str(BUOY), "--lang", "fr"], "'fr' is not one of"),
        ([str(BUOY), "--out", "result/case.toml"], "is a file; give a directory"),
    ],
)
def test_wrong_input_ends_with_2_and_writes_nothing(
    run: Run, tmp_path: Path, arguments: list[str], told: str
) -> None:
    design_directory(tmp_path)
    before = sorted(tmp_path.rglob("*"))
    ran = run("report", *arguments)
    assert (ran.status, ran.out) == (2, "")
    assert told in ran.err
    assert sorted(tmp_path.rglob("*")) == before


def test_a_line_without_equilibrium_ends_with_3_and_writes_nothing(
    run: Run, too_short: Path
) -> None:
    ran = run("report", too_short)
    assert (ran.status, ran.out) == (3, "")
    assert list(Path().glob("*.html")) == []


def test_a_strength_that_a_check_needs_is_asked_for(run: Run, chain_and_wire: Path) -> None:
    """As by ``catopt check``: a note without a check that was asked for would mislead."""
    ran = run("report", chain_and_wire)
    assert ran.status == 2
    assert "line.segments[1].MBL: missing" in ran.err


TURRET = CASES / "fso-rang-dong" / "case.toml"


def test_a_moored_body_has_a_page_and_a_workbook(run: Run) -> None:
    ran = run("report", TURRET, "--out", "notes", "--lang", "vi", "--no-verify")
    assert (ran.status, ran.err) == (0, "")
    written = ["notes/fso-rang-dong.html", "notes/fso-rang-dong.xlsx"]
    assert ran.out.splitlines() == written
    page = read_page(Path(written[0]).read_bytes())
    assert page.tagged("html")[0].attributes["lang"] == "vi"
    assert "system_elevation" in page.sections
    assert openpyxl.load_workbook(written[1]).sheetnames[0] == "Kết quả chính"


def test_json_tells_of_a_moored_body(run: Run) -> None:
    """With the keys of any other note; what does not apply is null or empty."""
    document = json.loads(run("report", TURRET, "--json").out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.report/1")).validate(document)
    line = json.loads(run("report", BUOY, "--json", "--no-verify").out)
    assert list(document) == list(line)
    assert document["title"] == "FSO Rang Dong, nine-line turret"
    assert (document["design"], document["load_case"], document["passes"]) == (None, "", True)
    assert document["verification"]["verdict"] == "agrees"
    assert document["sections"] == list(read_page(Path(document["path"]).read_bytes()).sections)


@pytest.mark.slow
def test_json_tells_which_line_of_a_body_governs(run: Run, tmp_path: Path) -> None:
    path = system_path(tmp_path, "pulled")
    document = json.loads(run("report", path, "--json").out)
    jsonschema.Draft202012Validator(schemas.schema("catopt.report/1")).validate(document)
    assert document["passes"] is False
    assert document["governing"] == "tension, segment 1 (line 1, line 2 out)"


@pytest.mark.slow
def test_what_catopt_system_wrote_has_a_note(run: Run) -> None:
    """The same as that of its case file."""
    assert run("system", TURRET, "--out", "fso").status == 0
    assert run("report", "fso", "--no-verify").out == "fso.html\n"
    run("report", TURRET, "--no-verify")
    pages = [read_page(Path(name).read_bytes()) for name in ("fso.html", "fso-rang-dong.html")]
    first, second = ([[c.value for c in r] for r in p.table("system_lines").rows] for p in pages)
    assert first == second


@pytest.mark.parametrize(
    ("option", "told"),
    [
        (["--design", "1"], "--design: found 1"),
        (["--method", "pso"], "--method: found pso"),
    ],
)
def test_what_is_for_one_line_is_refused_for_a_body(run: Run, option: list[str], told: str) -> None:
    ran = run("report", TURRET, *option)
    assert (ran.status, ran.out) == (2, "")
    assert told in " ".join(ran.err.split())
    assert "for one line with a load" in " ".join(ran.err.split())
    assert list(Path().glob("*.html")) == []


def test_a_body_without_equilibrium_ends_with_3_and_writes_nothing(
    run: Run, tmp_path: Path
) -> None:
    path = system_path(tmp_path, "raised")
    path.write_text(path.read_text("utf-8").replace('"260 m"', '"235 m"'), "utf-8")
    ran = run("report", path)
    assert (ran.status, ran.out) == (3, "")
    assert list(Path().glob("*.html")) == []
