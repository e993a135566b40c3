"""``catopt design``: what it prints and writes, what it refuses, and how it ends."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import catopt
from catopt.casefile.design_directory import read_design

from .conftest import BUOY, CASES, Run
from .test_json import validate

DESIGN = CASES / "design-buoy-9.5m" / "case.toml"
FILES = {
    "case.toml", "checks.csv", "components.csv", "design.json", "design.xlsx", "front.csv",
    "front.png", "front.svg", "neighbours.csv", "search.csv",
}  # fmt: skip


def words(text: str) -> str:
    return " ".join(text.split())


def test_the_document(run: Run) -> None:
    ran = run("design", DESIGN, "--json")
    assert ran.status == 0
    assert "designs" in ran.err  # how many there are, before the search begins
    document = json.loads(ran.out)
    validate(document)
    assert document["objectives"] == ["mass_kg", "offset_m"]
    masses = [point["mass_kg"] for point in document["front"]]
    offsets = [point["offset_m"] for point in document["front"]]
    assert masses == sorted(masses)
    assert offsets == sorted(offsets, reverse=True)
    assert all(point["feasible"] for point in document["front"])
    assert 0 <= document["recommended"] < len(masses)


def test_the_same_seed_gives_the_same_bytes(run: Run) -> None:
    arguments = ("design", DESIGN, "--method", "nsga2", "--evaluations", "600", "--seed", "3")
    first, second = run(*arguments, "--json"), run(*arguments, "--json")
    assert first.status == second.status == 0
    assert first.out == second.out
    assert json.loads(first.out)["evaluations"] <= 600


def test_the_page(run: Run) -> None:
    ran = run("design", DESIGN)
    assert ran.status == 0
    text = words(ran.out)
    assert "are on the exact front" in text
    assert "Recommended: design" in text
    assert "One size or one step up or down from it" in text
    assert max(map(len, ran.out.splitlines())) <= 80


def test_a_design_is_a_case_of_its_own(run: Run, tmp_path: Path) -> None:
    ran = run("design", DESIGN, "--json", "--out", tmp_path)
    assert ran.status == 0
    assert {path.name for path in tmp_path.iterdir()} == FILES
    front = json.loads(ran.out)["front"]
    for number in (1, len(front)):
        design = front[number - 1]
        case = read_design(tmp_path, number)
        assert case.design is None
        assert case.line.mass == pytest.approx(design["mass_kg"], rel=1e-15)  # one rounding
        for state, span in zip(case.load_cases, design["spans_m"], strict=True):
            ran = run("solve", tmp_path, "--design", number, "--load-case", state.name, "--json")
            assert ran.status == 0
            # The same solver on the same numbers.
            assert json.loads(ran.out)["span_m"] == span
        checked = json.loads(run("check", tmp_path, "--design", number, "--json").out)
        assert checked["checks"] == design["checks"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("solve", "{result}"), "a result directory; add --design K"),
        (("solve", "{result}", "--design", "0"), "the front has the designs 1 to"),
        (("check", "{result}", "--design", "999"), "the front has the designs 1 to"),
        (("solve", "{empty}", "--design", "1"), "a directory that catopt design --out wrote"),
        (("design", BUOY), "a table [design] says what may vary"),
        (("design", BUOY), f"catopt: {BUOY}: 1 error"),
        (("design", DESIGN, "--evaluations", "0"), "--evaluations: found 0; must be 1 or more"),
        (("design", DESIGN, "--seed", "-1"), "--seed: found -1; must be 0 or more"),
    ],
)
def test_what_it_refuses(
    run: Run, tmp_path: Path, arguments: tuple[object, ...], message: str
) -> None:
    result, empty = tmp_path / "result", tmp_path / "empty"
    empty.mkdir()
    if "{result}" in arguments:
        assert run("design", DESIGN, "--out", result).status == 0
    places = {"{result}": result, "{empty}": empty}
    ran = run(*(places.get(str(each), each) for each in arguments))
    assert (ran.status, ran.out) == (2, "")
    assert message in words(ran.err)


def test_no_design_passes(run: Run, tmp_path: Path) -> None:
    case = tmp_path / "case.toml"
    text = DESIGN.read_text("utf-8").replace('"12 kN"', '"0.5 kN"')
    case.write_text(text, encoding="utf-8")
    ran = run("design", case, "--out", tmp_path / "out")
    assert (ran.status, ran.out) == (3, "")
    assert "vertical pull on the buoy" in words(ran.err)
    assert not (tmp_path / "out").exists()


def test_an_interrupted_search_keeps_its_front(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Ctrl-C in the middle of the search, at the fifth report of its progress."""
    from catopt.cli.output import Output

    calls = []

    def tell(done: int, wanted: int) -> None:
        calls.append((done, wanted))
        if len(calls) == 5:
            raise KeyboardInterrupt

    class Watched:
        def __enter__(self) -> object:
            return tell

        def __exit__(self, *_: object) -> None:
            return None

    monkeypatch.setattr(Output, "progress", lambda _self, _what: Watched())
    ran = run(
        "design", DESIGN, "--method", "swarm", "--evaluations", "6000", "--json", "--out", tmp_path
    )
    assert ran.status == 130
    document = json.loads(ran.out)
    assert document["interrupted"] is True
    assert document["front"]
    assert all(point["feasible"] for point in document["front"])
    assert ran.err.count("catopt: interrupted") == 1
    assert (tmp_path / "design.json").exists()


def test_interrupted_before_any_design_passes(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Not status 3: that no design passes is not known."""
    import catopt.design.search
    from catopt.design.enumeration import enumerate_designs

    def stopped(*args: object, **_: object) -> object:
        def stop(*_: int) -> None:
            raise KeyboardInterrupt

        return enumerate_designs(args[0], chunk=100, progress=stop)  # type: ignore[arg-type]

    monkeypatch.setattr(catopt.design.search, "enumerate_designs", stopped)
    case = tmp_path / "case.toml"
    text = DESIGN.read_text("utf-8").replace('"12 kN"', '"0.5 kN"')
    case.write_text(text, encoding="utf-8")
    ran = run("design", case, "--json")
    assert (ran.status, ran.out) == (130, "")
    assert "interrupted: none of 100 designs evaluated, out of 6,111, passes" in words(ran.err)


def test_python_gives_what_the_command_prints(run: Run) -> None:
    from catopt.design.document import design_document

    result = catopt.design_case(catopt.read_case(DESIGN))
    assert json.loads(run("design", DESIGN, "--json").out) == design_document(result)
