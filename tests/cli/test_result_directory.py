"""Directories that ``--out`` wrote: each has its case; ``catopt report`` makes the note of it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from catopt.casefile import read_case, write_case

from .conftest import BUOY, CASES, DESIGN, FSO, OWN, SOUGHT, Run, document_of, names, refused, typed
from .notes import note_of, page_at

OF_REPORT = Path(__file__).parents[1] / "report" / "cases"
CHAIN, MOVING, STATES = (OF_REPORT / f"{name}.toml" for name in ("swarm", "harmonic", "states"))

pytestmark = pytest.mark.usefixtures("inside")


def report(run: Run, *arguments: object) -> dict[str, Any]:
    return note_of(run, *arguments, "--no-verify")[0]


@pytest.mark.parametrize("path", sorted(CASES.glob("*/case.toml")), ids=lambda p: p.parent.name)
def test_every_case_comes_back_the_same(run: Run, path: Path) -> None:
    command = "system" if "[system]" in path.read_text("utf-8") else "check"
    assert run(command, path, "--out", "out").status == 0
    assert read_case("out/case.toml") == read_case(path)


@pytest.mark.parametrize("command", ["solve", "check", "curve", "verify"])
def test_each_command_leaves_a_directory_that_can_be_reported_on(run: Run, command: str) -> None:
    assert run(command, BUOY, "--out", "result").status == 0
    document = report(run, "result")
    assert document["path"] == "result.html"
    assert document["title"] == "Marker buoy, 9.5 m"
    assert [each["name"] for each in document["sources"]] == ["case.toml"]
    assert (document["swarm"], document["motion"]) == (None, None)


@pytest.mark.slow
def test_a_body_and_a_line_that_is_sought_can_be_reported_on(run: Run) -> None:
    assert run("system", FSO, "--out", "body").status == 0
    assert "system_elevation" in report(run, "body")["sections"]
    assert run("solve", SOUGHT, "--out", "found").status == 0
    results = page_at(report(run, "found")["path"]).table("results")
    length = results.row("Found length of segment 1 L")
    assert length[1].value == document_of(run, "solve", SOUGHT)["found"]["value"]


@pytest.mark.slow
def test_what_the_options_changed_is_in_the_case(run: Run) -> None:
    assert run("solve", CHAIN, "--method", "pso", "--runs", 2, "--out", "a").status == 0
    swarm = read_case("a/case.toml").swarm
    assert (swarm.runs, swarm.particles, swarm.seed) == (2, 40, 7)
    assert run("check", STATES, "--code", "UFC-4-159-03", "--out", "b").status == 0
    assert read_case("b/case.toml") == read_case(STATES)
    assert run("solve", STATES, "--load-case", "everyday", "--out", "c").status == 0
    case = read_case("c/case.toml")
    assert case.load is not None
    assert (case.load.horizontal_force, case.load_cases) == (5e3, ())
    # Without the option no load case is lost, although only the first was solved.
    assert run("solve", STATES, "--out", "d").status == 0
    assert read_case("d/case.toml") == read_case(STATES)


@pytest.mark.slow
def test_the_swarm_of_a_directory_is_in_its_note(run: Run) -> None:
    ran = run("solve", CHAIN, "--method", "pso", "--runs", 2, "--json", "--out", "out")
    told = json.loads(ran.out)["pso"]
    document = report(run, "out")
    assert "swarm" in document["sections"]
    keys = ("objective", "evaluations", "runs", "converged_runs", "closed_form_difference")
    assert document["swarm"] == {key: told[key] for key in keys}
    assert told["runs"] == 2
    assert report(run, "out", "--method", "closed-form")["swarm"] is None
    assert report(run, CHAIN)["swarm"] is None
    assert report(run, CHAIN, "--method", "pso")["swarm"]["runs"] == 3


@pytest.mark.slow
def test_the_motion_of_a_directory_is_in_its_note(run: Run) -> None:
    ran = run("verify", MOVING, "--dynamic", "--json", "--out", "out")
    (told,) = json.loads(ran.out)["dynamic"]["load_cases"]
    document = report(run, "out")
    assert "in_motion" in document["sections"]
    motion = document["motion"]
    for key in ("max_tension_N", "amplification", "slack_time_s"):
        assert motion[key] == told[key]
    assert motion["max_fairlead_tension_N"] == told["quantities"][0]["max"]
    assert motion["utilisation"] == told["max_tension_N"] / 1e6  # 3000 kN over 3
    assert report(run, "out", "--no-dynamic")["motion"] is None
    assert report(run, MOVING)["motion"] is None
    assert report(run, MOVING, "--dynamic")["motion"] == motion


@pytest.mark.slow
def test_both_go_together(run: Run) -> None:
    for arguments in (["solve", MOVING, "--method", "pso"], ["verify", MOVING, "--dynamic"]):
        assert run(*arguments, "--out", "out").status == 0
    sections = report(run, "out")["sections"]
    assert [key for key in sections if key in {"swarm", "in_motion"}] == ["swarm", "in_motion"]


def test_documents_of_another_program_ask_for_nothing(run: Run) -> None:
    assert run("solve", BUOY, "--out", "out").status == 0
    Path("out/verify.json").write_text('{"dynamic": {}}', encoding="utf-8")
    Path("out/solution.json").write_text("[]", encoding="utf-8")
    ran = refused(run, "report", "out")
    assert "solution.json: 1 error\n  file: an object in braces is wanted" in ran.err
    Path("out/solution.json").write_text('{"schema": "other/1"}', encoding="utf-8")
    document = report(run, "out")
    assert (document["swarm"], document["motion"]) == (None, None)


def test_a_document_that_was_tampered_with_is_refused_with_its_place(run: Run) -> None:
    assert run("solve", BUOY, "--out", "out").status == 0
    document = json.loads(Path("out/solution.json").read_text("utf-8"))
    document["segments"] = 3
    document["fairlead"]["tension_N"] = "strong"
    Path("out/solution.json").write_text(json.dumps(document), encoding="utf-8")
    ran = refused(run, "report", "out")
    assert "  segments: found 3; an array is wanted\n" in ran.err
    assert "  fairlead.tension_N: found 'strong'; a number is wanted\n" in ran.err


def test_a_directory_of_two_cases_is_refused(run: Run) -> None:
    """As a power cut leaves it, or a document copied from elsewhere."""
    assert run("solve", BUOY, "--out", "one").status == 0
    assert run("check", CHAIN, "--out", "two").status == 0
    assert report(run, "one")["path"] == "one.html"
    Path("one/check.json").write_bytes(Path("two/check.json").read_bytes())
    ran = refused(run, "report", "one")
    assert "check.json: it is of another case than case.toml beside it" in ran.err
    assert "solution.json" not in ran.err
    # The same case, whoever wrote it down, is the same case.
    Path("one/check.json").unlink()
    Path("one/case.toml").write_bytes(BUOY.read_bytes())
    assert report(run, "one")["path"] == "one.html"


@pytest.mark.slow
def test_a_case_of_the_users_own_is_never_replaced(run: Run) -> None:
    own = BUOY.read_text("utf-8")
    Path("case.toml").write_text(own, encoding="utf-8")
    ran = run("solve", "case.toml", "--out", ".")
    assert ran.status == 0
    assert ran.err.count("\n") == 1, "nothing to be told: it is of the same case"
    assert Path("case.toml").read_text("utf-8") == own
    ran = run("solve", "case.toml", "--method", "pso", "--seed", 5, "--out", ".")
    assert "case.toml in . stays as it is, for catopt did not write it" in ran.err
    assert Path("case.toml").read_text("utf-8") == own


@pytest.mark.parametrize(
    ("line", "own"), [("design case.toml", DESIGN.read_text("utf-8")), ("SIZE_OWN", "# my own\n")]
)
def test_a_search_and_a_sizing_refuse_to_replace_it(run: Run, line: str, own: str) -> None:
    Path("case.toml").write_text(own, encoding="utf-8")
    ran = refused(run, *typed(line), "--out", ".")
    assert "--out: found .; has a case.toml that catopt did not write" in ran.err
    assert names(Path()) == {"case.toml"}
    assert Path("case.toml").read_text("utf-8") == own


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["buoy", "tanker"])
def test_a_sizing_is_written_over_its_own_and_reported_on(run: Run, kind: str) -> None:
    asked = ("size", kind, CASES / f"size-{kind}" / "sizing.toml", "--out", "out")
    for _ in range(2):
        ran = run(*asked)
        assert ran.status == 0, ran.err
    assert report(run, "out")["path"] == "out.html"
    text = Path("out/case.toml").read_text("utf-8")
    assert write_case(read_case("out/case.toml")) == text


@pytest.mark.slow
def test_a_case_that_catopt_wrote_is_replaced(run: Run) -> None:
    for path in (BUOY, CHAIN):
        ran = run("solve", path, "--out", "out")
        assert (ran.status, "stays" in ran.err) == (0, False)
    assert read_case("out/case.toml") == read_case(CHAIN)


@pytest.mark.slow
def test_the_case_of_a_design_search_stays_with_its_front(run: Run) -> None:
    assert run("design", OWN / "design-in-motion.toml", "--out", "front").status == 0
    before = Path("front/case.toml").read_bytes()
    ran = run("solve", "front", "--design", 1, "--out", "front")
    assert "stays as it is, for the front in design.json goes with it" in ran.err
    assert Path("front/case.toml").read_bytes() == before
    assert report(run, "front")["design"] is not None
    # A design on its own is a case like any other.
    assert run("verify", "front", "--design", 1, "--dynamic", "--out", "one").status == 0
    document = report(run, "one")
    assert (document["design"], document["title"]) == (None, "A chain in motion, design 1")
    assert document["motion"]["load_case"] == "storm"
    # All of them take the front along.
    assert run("verify", "front", "--all", "--out", "all").status == 0
    assert report(run, "all", "--design", 2)["design"] == 2
    assert run("solve", MOVING, "--out", "all").status == 0
    assert Path("all/case.toml").read_bytes() == before


@pytest.mark.parametrize(
    ("files", "told"),
    [((), "nothing in it"), (("loads.json", "loads.csv"), "there is loads.csv, loads.json")],
)
def test_a_directory_without_a_case_says_what_is_there(
    run: Run, files: tuple[str, ...], told: str
) -> None:
    Path("some").mkdir()
    for name in files:
        Path("some", name).write_text("{}", encoding="utf-8")
    ran = refused(run, "report", "some")
    assert "a directory with a case.toml is wanted" in ran.err
    assert told in ran.err
    assert "Give a case file, or run the command with --out once more" in ran.err
    assert list(Path().glob("*.html")) == []


def test_the_swarm_takes_the_first_load_case(run: Run) -> None:
    assert report(run, STATES, "--method", "pso")["load_case"] == "storm (high water)"
    assert [path.name for path in Path().glob("*.html")] == ["states.html"]


@pytest.mark.usefixtures("stopped")
def test_ctrl_c_writes_no_note_and_says_so(run: Run) -> None:
    """An older note stays: one of half a run must not take its place."""
    assert run("report", MOVING).status == 0
    older = Path("harmonic.html").read_bytes()
    ran = run("report", MOVING, "--dynamic", "--json")
    assert (ran.status, ran.out) == (130, "")
    assert "stopped in load case load, run 1 of 1, after " in ran.err
    assert "no note was written" in ran.err
    assert "catopt verify CASE --dynamic --out DIR keeps" in ran.err
    assert Path("harmonic.html").read_bytes() == older
