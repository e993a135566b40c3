"""``catopt export``: where the file goes, its document, and of which line it is."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

from .conftest import BUOY, DESIGN, FSO, OWN, Run, document_of, names, read_document, refused, words

STATES = OWN / "buoy-states.toml"


def test_without_a_place_the_file_is_printed(run: Run) -> None:
    ran = run("export", FSO, "--to", "moordyn")
    assert ran.status == 0
    assert ran.out.startswith("MoorDyn v2 input file")
    assert ran.out.endswith("--- END ---\n")
    assert "note: the body is not in the file" in ran.err
    assert max(map(len, ran.out.splitlines())) <= 100


def test_a_file_or_a_directory(run: Run, tmp_path: Path) -> None:
    printed = run("export", BUOY, "--to", "dxf").out
    named, drawings = tmp_path / "deep" / "line.dxf", tmp_path / "drawings"
    ran = run("export", BUOY, "--to", "dxf", "--out", named)
    assert (ran.status, words(ran.out)) == (0, words(str(named)))
    assert named.read_bytes() == printed.encode("ascii")
    run("export", BUOY, "--to", "dxf", "--out", drawings)
    run("export", FSO, "--to", "moordyn", "--out", drawings)
    assert names(drawings) == {"buoy-9.5m.dxf", "fso-rang-dong.txt"}
    assert names(named.parent) == {"line.dxf"}


def test_a_place_that_cannot_be_written_leaves_nothing(run: Run, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    ran = refused(run, "export", BUOY, "--to", "dxf", "--out", tmp_path / "file" / "line.dxf")
    assert "--out" in ran.err
    assert (tmp_path / "file").read_text() == "mine"


@pytest.mark.parametrize("form", ["moordyn", "dxf", "map", "moorpy", "ontology", "orcaflex"])
@pytest.mark.parametrize("case", [FSO, BUOY], ids=["body", "line"])
def test_the_document(run: Run, tmp_path: Path, case: Path, form: str) -> None:
    further = ("--EA", "20 MN") if case == BUOY and form != "dxf" else ()
    ran = run("export", case, "--to", form, *further, "--json")
    document = read_document(ran.out)
    assert (document["schema"], document["format"]) == ("catopt.export/1", form)
    assert (document["path"], len(document["lines"])) == (None, 9 if case == FSO else 1)
    assert document["sources"] == [
        {"name": "case.toml", "sha256": hashlib.sha256(case.read_bytes()).hexdigest()}
    ]
    content = document["text"].encode("ascii")
    assert document["sha256"] == hashlib.sha256(content).hexdigest()
    assert document["bytes"] == len(content)
    assert [f"note: {remark}" for remark in document["remarks"]] == ran.err.splitlines()
    written = tmp_path / "out.txt"
    again = run("export", case, "--to", form, *further, "--json", "--out", written)
    assert read_document(again.out) == {**document, "path": str(written), "text": None}
    assert written.read_bytes() == content


def test_it_expects_what_solve_finds(run: Run) -> None:
    (line,) = document_of(run, "export", BUOY, "--to", "dxf")["lines"]
    solved = document_of(run, "solve", BUOY)
    for key in ("span_m", "horizontal_force_N", "grounded_length_m"):
        assert line[key] == solved[key]
    assert line["fairlead_tension_N"] == solved["fairlead"]["tension_N"]
    assert line["anchor_vertical_force_N"] == solved["anchor"]["vertical_force_N"]


@pytest.mark.usefixtures("inside")
def test_a_design_of_a_result_directory(run: Run) -> None:
    assert run("design", DESIGN, "--out", "front").status == 0
    front = json.loads(Path("front/design.json").read_text("utf-8"))["front"]
    exported = run("export", "front", "--design", 2, "--to", "moordyn", "--json")
    document = json.loads(exported.out)
    assert [file["name"] for file in document["sources"]] == ["case.toml", "design.json"]
    rows = document["text"].split("--- LINES ---")[1].split("--- OPTIONS ---")[0].splitlines()[3:]
    length = sum(float(row.split()[4]) for row in rows if row)
    assert length == pytest.approx(sum(s["length_m"] for s in front[1]["segments"]), rel=1e-9)
    placed = run("export", "front", "--design", 2, "--to", "dxf", "--out", "d")
    assert (placed.status, Path(words(placed.out)).name) == (0, "front-design-2.dxf")


def test_the_water_above_which_a_line_reaches(run: Run) -> None:
    def depth(*further: str) -> str:
        text = run("export", FSO, "--to", "moordyn", *further).out
        return next(line for line in text.splitlines() if " WtrDpth " in line).split()[0]

    assert (depth(), depth("--true-depth")) == ("71.4", "56")
