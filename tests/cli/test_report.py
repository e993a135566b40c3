"""``catopt report``: where the page goes, and what is told of it."""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pytest

from catopt.errors import NotConvergedError
from tests.report.notes import RESULT, case_path

from .conftest import BUOY, FSO, TANKER, Run, document_of, sheets
from .notes import digest, note_of, page_at

pytestmark = pytest.mark.usefixtures("inside")


def test_the_page_is_written_beside_the_user_and_its_place_printed(run: Run) -> None:
    ran = run("report", BUOY)
    assert (ran.status, ran.err, ran.out) == (0, "", "buoy-9.5m.html\n")
    assert page_at("buoy-9.5m.html").tagged("h1")[0].text == "Marker buoy, 9.5 m"
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
    assert (ran.status, ran.out.splitlines()) == (0, written)
    made = sorted(str(path) for path in Path().rglob("*.*") if path.is_file())
    assert made == sorted(written)
    assert Path(written[0]).read_bytes().startswith(b"<!DOCTYPE html>")
    for workbook in written[1:]:
        assert openpyxl.load_workbook(workbook).sheetnames[0] == "The answer"


def test_a_directory_may_end_like_a_page(run: Run) -> None:
    Path("odd.html").mkdir()
    ran = run("report", BUOY, "--out", "odd.html")
    assert ran.out.splitlines()[0] == "odd.html/buoy-9.5m.html"


def test_json_tells_what_was_written(run: Run) -> None:
    asked = (TANKER, "--lang", "vi", "--date", "21.11.2026")
    document, _ = note_of(run, *asked)
    assert document["workbook"] is None
    assert (document["language"], document["date"]) == ("vi", "21.11.2026")
    assert document["sources"] == digest(TANKER)
    assert document["passes"] is True
    assert document["governing"].startswith("tension, segment 1")
    assert note_of(run, *asked, "--out", "notes")[0]["workbook"]


def test_json_tells_of_the_verification(run: Run) -> None:
    verified = document_of(run, "verify", BUOY)
    worst = verified["static"]["worst"]
    assert note_of(run, BUOY)[0]["verification"] == {
        "verdict": verified["verdict"],
        "worst": {key: worst[key] for key in ("quantity", "unit", "gap")},
        "failure": "",
    }


def test_a_truss_without_an_answer_is_told_and_the_note_written(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError("it stopped short")

    monkeypatch.setattr("catopt.verify.case.verify_case", stops)
    document, _ = note_of(run, BUOY)
    told = {"verdict": "no answer", "worst": None, "failure": "it stopped short"}
    assert document["verification"] == told
    assert any("not verified" in warning for warning in document["warnings"])


def test_a_design_is_named_or_recommended(run: Run) -> None:
    document, page = note_of(run, RESULT)
    assert (document["design"], document["path"]) == (2, "result-design-2.html")
    assert [each["name"] for each in document["sources"]] == ["case.toml", "design.json"]
    assert "front" in page.sections
    document, _ = note_of(run, RESULT, "--design", 3)
    assert (document["design"], document["path"]) == (3, "result-design-3.html")


def test_a_moored_body_has_a_page_and_a_workbook(run: Run) -> None:
    ran = run("report", FSO, "--out", "notes", "--lang", "vi", "--no-verify")
    assert (ran.status, ran.err) == (0, "")
    page, workbook = ran.out.splitlines()
    assert (page, workbook) == ("notes/fso-rang-dong.html", "notes/fso-rang-dong.xlsx")
    assert "system_elevation" in page_at(page).sections
    assert next(iter(sheets(Path(workbook)))) == "Kết quả chính"


def test_json_tells_of_a_moored_body(run: Run) -> None:
    """With the keys of any other note; what does not apply is null or empty."""
    document, _ = note_of(run, FSO)
    line, page = note_of(run, BUOY, "--no-verify")
    assert (line["verification"], "verification" in page.sections) == (None, False)
    assert list(document) == list(line)
    assert document["title"] == "FSO Rang Dong, nine-line turret"
    assert (document["design"], document["load_case"], document["passes"]) == (None, "", True)
    assert document["verification"]["verdict"] == "agrees"


@pytest.mark.slow
def test_json_tells_which_line_of_a_body_governs(run: Run) -> None:
    document, _ = note_of(run, case_path("pulled"))
    assert document["passes"] is False
    assert document["governing"] == "tension, segment 1 (line 1, line 2 out)"


@pytest.mark.slow
def test_what_catopt_system_wrote_has_a_note(run: Run) -> None:
    """The same as that of its case file."""
    assert run("system", FSO, "--out", "fso").status == 0
    assert run("report", "fso", "--no-verify").out == "fso.html\n"
    run("report", FSO, "--no-verify")
    tables = (page_at(name).table("system_lines") for name in ("fso.html", "fso-rang-dong.html"))
    first, second = ([[cell.value for cell in row] for row in table.rows] for table in tables)
    assert first == second


def test_a_body_without_equilibrium_ends_with_3_and_writes_nothing(
    run: Run, tmp_path: Path
) -> None:
    path = tmp_path / "raised.toml"
    text = case_path("raised-anchors").read_text("utf-8")
    path.write_text(text.replace('"260 m"', '"235 m"'), "utf-8")
    ran = run("report", path)
    assert (ran.status, ran.out) == (3, "")
    assert list(Path().glob("*.html")) == []
