"""``catopt design``: its document, its result directory, and how it ends."""

from __future__ import annotations

import json
from contextlib import nullcontext
from pathlib import Path

import pytest

import catopt
from catopt.casefile.design_directory import read_design
from catopt.cli.output import Output
from catopt.design.document import design_document
from catopt.design.enumeration import enumerate_designs

from .conftest import DESIGN, Run, changed, read_document, words

IMPOSSIBLE = ('"12 kN"', '"0.5 kN"')


def test_the_document(run: Run) -> None:
    ran = run("design", DESIGN, "--json")
    assert ran.status == 0
    assert "designs" in ran.err  # how many there are, before the search begins
    document = read_document(ran.out)
    assert document == design_document(catopt.design_case(catopt.read_case(DESIGN)))
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


def test_a_design_is_a_case_of_its_own(run: Run, tmp_path: Path) -> None:
    ran = run("design", DESIGN, "--json", "--out", tmp_path)
    front = json.loads(ran.out)["front"]
    for number in (1, len(front)):
        design = front[number - 1]
        case = read_design(tmp_path, number)
        assert case.design is None
        assert case.line.mass == pytest.approx(design["mass_kg"], rel=1e-15)  # one rounding
        of_it = (tmp_path, "--design", number, "--json")
        for state, span in zip(case.load_cases, design["spans_m"], strict=True):
            solved = run("solve", *of_it, "--load-case", state.name)
            # The same solver on the same numbers.
            assert json.loads(solved.out)["span_m"] == span
        assert json.loads(run("check", *of_it).out)["checks"] == design["checks"]


def test_no_design_passes(run: Run, tmp_path: Path) -> None:
    ran = run("design", changed(DESIGN, tmp_path, IMPOSSIBLE), "--out", tmp_path / "out")
    assert (ran.status, ran.out) == (3, "")
    assert "vertical pull on the buoy" in words(ran.err)
    assert not (tmp_path / "out").exists()


def test_an_interrupted_search_keeps_its_front(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Ctrl-C in the middle of the search, at the fifth report of its progress."""
    calls = []

    def tell(done: int, wanted: int) -> None:
        calls.append((done, wanted))
        if len(calls) == 5:
            raise KeyboardInterrupt

    monkeypatch.setattr(Output, "progress", lambda _self, _what: nullcontext(tell))
    swarm = ("--method", "swarm", "--evaluations", "6000")
    ran = run("design", DESIGN, *swarm, "--json", "--out", tmp_path)
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

    def stopped(*args: object, **_: object) -> object:
        def stop(*_: int) -> None:
            raise KeyboardInterrupt

        return enumerate_designs(args[0], chunk=100, progress=stop)  # type: ignore[arg-type]

    monkeypatch.setattr("catopt.design.search.enumerate_designs", stopped)
    ran = run("design", changed(DESIGN, tmp_path, IMPOSSIBLE), "--json")
    assert (ran.status, ran.out) == (130, "")
    assert "interrupted: none of 100 designs evaluated, out of 6,111, passes" in words(ran.err)


def test_a_part_without_a_name_has_a_number_in_vietnamese(run: Run, inside: Path) -> None:
    assert run("new", "design", inside / "design.toml").status == 0
    ran = run("design", "design.toml", "--lang", "vi")
    assert ran.status == 0
    assert "đoạn 1: " in ran.out
    assert "segment" not in ran.out
