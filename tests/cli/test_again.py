"""An old note beside one of the same file made now: ``catopt report NOTE --again``."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from catopt.notes.note_comparison import read_written_note

from .conftest import Run

ROOT = Path(__file__).parents[2]
NOTES = ROOT / "reports" / "notes"


@pytest.fixture
def old(run: Run, tmp_path: Path) -> Path:
    """Note of the 9.5 m buoy as an older version wrote it: one number was another there."""
    place = tmp_path / "old.html"
    run("report", str(ROOT / "cases" / "buoy-9.5m" / "case.toml"), "--out", str(place))
    page = re.sub('content="catopt [^"]*"', 'content="catopt 0.9.0"', place.read_text("utf-8"))
    # The span on the first page and its way of saying it, 1 % above what it is.
    page, count = re.subn(
        r'<data value="17\.4299\d+">17\.43 m</data>',
        '<data value="17.6042684">17.60 m</data>',
        page,
        count=1,
    )
    assert count == 1
    place.write_text(page, "utf-8")
    return place


def test_a_number_that_changed_is_named_with_what_it_was(run: Run, old: Path) -> None:
    document = json.loads(run("report", str(old), "--again", "--json").out)
    (found,) = document["otherwise"]
    assert (found["section"], found["row"], found["then"]) == ("summary", "Span", "17.60 m")
    # S1 prints 17.430 m.
    assert found["now_SI"] == pytest.approx(17.430, abs=5e-4)
    assert document["written_by"] == "0.9.0"
    assert document["same"] > 200
    assert (document["gone"], document["new"]) == (0, 0)


def test_the_screen_has_each_of_them(run: Run, old: Path) -> None:
    ran = run("report", str(old), "--again")
    assert "gives 1 numbers that differ from this note" in " ".join(ran.out.split())
    assert "17.60 m" in ran.out


def test_a_sizing_by_options_is_sized_again(run: Run, tmp_path: Path) -> None:
    """Two values of one input, a flag, and the buoy's name, which is no option."""
    typed = ("pillar 1.8 m", "--depth", "12 m", "--at-rest", "--hs", "1 m")
    assert run("size", "buoy", *typed, "--out", str(tmp_path)).status == 0
    note = tmp_path / "note.html"
    document = json.loads(run("report", str(note), "--again", "--json").out)
    assert (document["otherwise"], document["gone"], document["new"]) == ([], 0, 0)
    assert document["same"] > 200
    # Of another depth each line is another one.
    note.write_text(note.read_text("utf-8").replace(">12 m</td>", ">14 m</td>"), "utf-8")
    document = json.loads(run("report", str(note), "--again", "--json").out)
    assert len(document["otherwise"]) > 50
    note.write_text(note.read_text("utf-8").replace(">--depth<", ">--deepness<"), "utf-8")
    assert "--deepness" in run("report", str(note), "--again").err


def test_numbers_with_the_same_name_are_told_apart_by_their_order() -> None:
    page = (NOTES / "size-buoy.html").read_text("utf-8")
    read = read_written_note(page, "note")
    assert len(read.numbers) == len(re.findall("<data value=", page))


def test_what_is_no_note_is_refused(run: Run, tmp_path: Path) -> None:
    (place := tmp_path / "page.html").write_text("<html><p>a page</p></html>")
    ran = run("report", str(place), "--again")
    assert ran.status == 2
    assert "a calculation note" in ran.err


def test_a_note_whose_file_was_changed_is_refused(run: Run, old: Path) -> None:
    text = old.read_text("utf-8")
    assert "0.343 tf" in text
    old.write_text(text.replace("0.343 tf", "0.344 tf"), "utf-8")
    ran = run("report", str(old), "--again")
    assert ran.status == 2
    assert "SHA-256" in ran.err


def test_a_note_of_a_front_says_the_way_out(run: Run) -> None:
    ran = run("report", str(NOTES / "design-buoy-9.5m.html"), "--again")
    assert ran.status == 2
    assert "catopt design" in ran.err
