"""``catopt design``: its document, and how it ends."""

from __future__ import annotations

import json
from contextlib import nullcontext
from pathlib import Path

import pytest

import catopt
from catopt.cli.output import Printer
from catopt.design.search import enumerate_designs

from .conftest import DESIGN, Run, changed, read_document, words


def test_the_document_is_what_python_gives(run: Run) -> None:
    document = read_document(run("design", DESIGN, "--json").out)
    assert document == catopt.design_case(catopt.read_case(DESIGN)).to_dict()


def test_an_interrupted_search_keeps_its_front(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Ctrl-C in the middle of the search, at the fifth report of its progress."""
    calls = []

    def tell(done: int, wanted: int) -> None:
        calls.append((done, wanted))
        if len(calls) == 5:
            raise KeyboardInterrupt

    monkeypatch.setattr(Printer, "progress", lambda _self, _what: nullcontext(tell))
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
    ran = run("design", changed(DESIGN, tmp_path, ('"12 kN"', '"0.5 kN"')), "--json")
    assert (ran.status, ran.out) == (130, "")
    assert "interrupted: none of 100 designs evaluated, out of 6,111, passes" in words(ran.err)
