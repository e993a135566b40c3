"""``catopt export``: where the file goes, its document, and of which line it is."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest

from .conftest import BUOY, FSO, Run, document_of, read_document


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
    assert run("export", case, "--to", form, *further).out == document["text"]
    assert form != "moordyn" or max(map(len, document["text"].splitlines())) <= 100
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


def test_lines_between_points_go_out(run: Run) -> None:
    raft = BUOY.parents[1] / "raft-four-lines" / "case.toml"
    document = document_of(run, "export", raft, "--to", "dxf")
    assert [each["name"] for each in document["lines"]] == [f"line {k}" for k in range(1, 5)]
    assert "the raft is not in the file" in run("export", raft, "--to", "moordyn").err
    refused = run("export", raft, "--to", "dxf", "--load-case", "storm")
    assert refused.status == 2
    assert '--load-case: found "storm"; the case has no' in refused.err


def test_a_case_needs_no_import(run: Run) -> None:
    for language, said in (("en", "a case file already"), ("vi", "đã là tệp bài toán")):
        refused = run("import", BUOY, "--lang", language)
        assert refused.status == 2
        assert said in refused.err
        assert f"catopt solve {BUOY}" in refused.err


def test_a_drawing_has_still_water_apart_from_that_of_the_load_case(
    run: Run, tmp_path: Path
) -> None:
    states = '[[load_cases]]\nname = "{}"\nhorizontal_force = "60 kN"\nwater_level = "{} m"\n'
    case = tmp_path / "case.toml"
    text = BUOY.parents[1].joinpath("tanker-20m", "case.toml").read_text("utf-8")
    text = text.replace("[load]", "[old]").partition("[old]")[0]
    case.write_text(text + states.format("high", 1.5) + states.format("low", -1), "utf-8")
    drawn = run("export", case, "--to", "dxf").out
    assert "still water, 20 m deep" in drawn
    assert "water of this load case, 21.5 m deep (+1.5 m)" in drawn
    assert ", low" in run("export", case, "--to", "dxf", "--load-case", "high").out
