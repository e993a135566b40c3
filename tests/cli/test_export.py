"""``catopt export``: where the file goes, its document, and what is refused."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

from .conftest import BUOY, CASES, Run
from .test_json import validate

FSO = CASES / "fso-rang-dong" / "case.toml"
SOUGHT = CASES / "ship-200m-sinker" / "case.toml"

STATES = """
[[load_cases]]
name = "high water"
horizontal_force = "4 kN"
water_level = "1 m"

[[load_cases]]
name = "low water"
horizontal_force = "3 kN"
"""


@pytest.fixture
def states(tmp_path: Path) -> Path:
    """Write the buoy's case with two load cases in the place of its load."""
    path = tmp_path / "states.toml"
    text = BUOY.read_text("utf-8").replace('[load]\nhorizontal_force = "0.343 tf"\n', STATES)
    path.write_text(text, encoding="utf-8")
    return path


def words(text: str) -> str:
    return " ".join(text.split())


# ------------------------------------------------------------------ where it goes


def test_without_a_place_the_file_is_printed(run: Run) -> None:
    ran = run("export", FSO, "--to", "moordyn")
    assert ran.status == 0
    assert ran.out.startswith("MoorDyn v2 input file")
    assert ran.out.endswith("--- END ---\n")
    assert "note: the body is not in the file" in ran.err
    assert max(map(len, ran.out.splitlines())) <= 100


def test_a_file_or_a_directory(run: Run, tmp_path: Path) -> None:
    printed = run("export", BUOY, "--to", "dxf").out
    named = tmp_path / "deep" / "line.dxf"
    ran = run("export", BUOY, "--to", "dxf", "--out", named)
    assert (ran.status, words(ran.out)) == (0, words(str(named)))
    assert named.read_bytes() == printed.encode("ascii")
    run("export", BUOY, "--to", "dxf", "--out", tmp_path / "drawings")
    run("export", FSO, "--to", "moordyn", "--out", tmp_path / "drawings")
    assert sorted(path.name for path in (tmp_path / "drawings").iterdir()) == [
        "buoy-9.5m.dxf",
        "fso-rang-dong.txt",
    ]
    assert sorted(path.name for path in named.parent.iterdir()) == ["line.dxf"]


def test_a_place_that_cannot_be_written_leaves_nothing(run: Run, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    ran = run("export", BUOY, "--to", "dxf", "--out", tmp_path / "file" / "line.dxf")
    assert (ran.status, ran.out) == (2, "")
    assert "--out" in ran.err
    assert (tmp_path / "file").read_text() == "mine"


# ------------------------------------------------------------------ the document


@pytest.mark.parametrize(
    ("case", "further"),
    [
        (FSO, ("moordyn",)),
        (BUOY, ("moordyn", "--EA", "20 MN")),
        (BUOY, ("dxf",)),
        (FSO, ("dxf",)),
        (FSO, ("map",)),
        (FSO, ("moorpy",)),
        (FSO, ("ontology",)),
        (FSO, ("orcaflex",)),
    ],
)
def test_the_document(run: Run, tmp_path: Path, case: Path, further: tuple[str, ...]) -> None:
    ran = run("export", case, "--to", *further, "--json")
    document = json.loads(ran.out)
    validate(document)
    assert (document["schema"], document["format"]) == ("catopt.export/1", further[0])
    assert (document["path"], len(document["lines"])) == (None, 9 if case == FSO else 1)
    assert document["sources"] == [
        {"name": "case.toml", "sha256": hashlib.sha256(case.read_bytes()).hexdigest()}
    ]
    content = document["text"].encode("ascii")
    assert document["sha256"] == hashlib.sha256(content).hexdigest()
    assert document["bytes"] == len(content)
    assert [f"note: {remark}" for remark in document["remarks"]] == ran.err.splitlines()
    written = tmp_path / "out.txt"
    again = json.loads(run("export", case, "--to", *further, "--json", "--out", written).out)
    validate(again)
    assert again == {**document, "path": str(written), "text": None}
    assert written.read_bytes() == content


def test_it_expects_what_solve_finds(run: Run) -> None:
    document = json.loads(run("export", BUOY, "--to", "dxf", "--json").out)
    solved = json.loads(run("solve", BUOY, "--json").out)
    (line,) = document["lines"]
    for key in ("span_m", "horizontal_force_N", "grounded_length_m"):
        assert line[key] == solved[key]
    assert line["fairlead_tension_N"] == solved["fairlead"]["tension_N"]
    assert line["anchor_vertical_force_N"] == solved["anchor"]["vertical_force_N"]


# ------------------------------------------------------------------ which line


def test_a_load_case_by_name_or_the_first_with_a_note(run: Run, states: Path) -> None:
    named = run("export", states, "--to", "dxf", "--json", "--load-case", "low water")
    assert json.loads(named.out)["lines"][0]["horizontal_force_N"] == 3000.0
    assert named.err == ""
    first = run("export", states, "--to", "dxf", "--json")
    assert json.loads(first.out)["lines"][0]["horizontal_force_N"] == 4000.0
    assert 'note: solved under the first load case, "high water"' in first.err
    ran = run("export", states, "--to", "dxf", "--load-case", "ebb")
    assert ran.status == 2
    assert "one of high water, low water is wanted" in ran.err


def test_a_design_of_a_result_directory(run: Run, tmp_path: Path) -> None:
    case = CASES / "design-buoy-9.5m" / "case.toml"
    assert run("design", case, "--out", tmp_path / "front").status == 0
    front = json.loads((tmp_path / "front" / "design.json").read_text("utf-8"))["front"]
    exported = run("export", tmp_path / "front", "--design", 2, "--to", "moordyn", "--json")
    document = json.loads(exported.out)
    assert [file["name"] for file in document["sources"]] == ["case.toml", "design.json"]
    rows = document["text"].split("--- LINES ---")[1].split("--- OPTIONS ---")[0].splitlines()[3:]
    length = sum(float(row.split()[4]) for row in rows if row)
    assert length == pytest.approx(sum(s["length_m"] for s in front[1]["segments"]), rel=1e-9)
    placed = run(
        "export", tmp_path / "front", "--design", 2, "--to", "dxf", "--out", tmp_path / "d"
    )
    assert (placed.status, Path(words(placed.out)).name) == (0, "front-design-2.dxf")


def test_the_water_above_which_a_line_reaches(run: Run) -> None:
    def depth(*further: str) -> str:
        text = run("export", FSO, "--to", "moordyn", *further).out
        return next(line for line in text.splitlines() if " WtrDpth " in line).split()[0]

    assert (depth(), depth("--true-depth")) == ("71.4", "56")


# ------------------------------------------------------------------ what is refused


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([BUOY], "Missing option '--to'"),
        ([BUOY, "--to", "flexcom"], "'flexcom' is not one of 'moordyn', 'map', 'moorpy',"),
        (
            [BUOY, "--to", "moordyn"],
            "line.segments[0].EA: missing; --to moordyn wants it",
        ),
        (
            [BUOY, "--to", "moordyn", "--EA", "5 m"],
            '--EA: found "5 m", a length; a force is wanted',
        ),
        ([BUOY, "--to", "moordyn", "--EA", "0"], "--EA: found 0.0; must be above 0 N"),
        ([BUOY, "--to", "moordyn", "--EA", "inf"], "--EA"),
        ([FSO, "--to", "moordyn", "--EA", "1 GN"], "--EA"),
        ([FSO, "--to", "moordyn", "--EA", "900 MN"], "every segment has its own EA; leave it out"),
        ([FSO, "--to", "moordyn", "--elements", "1"], "--elements: found 1; must be 2 or more"),
        ([FSO, "--to", "moordyn", "--elements", "20000"], "--elements: found 20000; must be 10000"),
        ([FSO, "--to", "dxf", "--elements", "9"], "--elements: found 9; goes with --to moordyn"),
        ([FSO, "--to", "dxf", "--true-depth"], "--true-depth: goes with --to moordyn"),
        (["gone.toml", "--to", "dxf"], "there is no such file"),
        ([FSO, "--to", "dxf", "--load-case", "x"], "--load-case: found"),
        ([CASES, "--to", "dxf", "--design", "1"], "a directory that catopt design --out wrote"),
    ],
)
def test_wrong_use_is_2(run: Run, arguments: list[object], said: str) -> None:
    ran = run("export", *arguments)
    assert (ran.status, ran.out) == (2, "")
    assert said in words(ran.err)
    assert "Traceback" not in ran.err


def test_everything_wrong_with_the_options_is_told_at_once(run: Run) -> None:
    ran = run("export", FSO, "--to", "dxf", "--elements", "9", "--true-depth", "--EA", "x")
    assert [word in ran.err for word in ("--elements", "--true-depth", "--EA", "3 errors")] == (
        [True] * 4
    )
