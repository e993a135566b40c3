"""The calculation note of a sizing by ``catopt report FILE`` and by ``catopt size ... --out``."""

from __future__ import annotations

import json
from pathlib import Path

import openpyxl
import pytest

from catopt.casefile.sizing_file import moored_in
from catopt.documents import parse_toml
from catopt.sizing.file import read_file, sized

from .conftest import CASES, Run
from .notes import digest, note_of, page_at

SIZE_BUOY = CASES / "size-buoy" / "sizing.toml"
SIZE_TANKER = CASES / "size-tanker" / "sizing.toml"

pytestmark = pytest.mark.usefixtures("inside")


def test_a_sizing_file_is_told_from_a_case_file() -> None:
    found = {path.parent.name: moored_in(path) for path in CASES.glob("*/*.toml")}
    sizings = {name: moored for name, moored in found.items() if moored is not None}
    assert sizings == {"size-buoy": "buoy", "size-tanker": "tanker"}
    assert len(found) > 10


@pytest.mark.parametrize(
    ("text", "moored"),
    [
        ("[ship]\nlength = 200", "tanker"),
        ('[buoy]\nname = "pillar 1.8 m"', "buoy"),
        ("[buoy]\nhorizontal_force = 5e3", "buoy"),
        ("[environment]\nwind = 20", "buoy"),
        ("[buoy]\nreserve_buoyancy = 5e3", None),
        ("[environment]\nwind = 20\n[load]\nhorizontal_force = 5e3", None),
        ("[ship]\n[[line.segments]]\nlength = 20", None),
        ("line = 3\n[ship]", "tanker"),
        ("", None),
        ("no toml", None),
    ],
)
def test_what_a_file_is_for_follows_from_what_is_in_it(text: str, moored: str | None) -> None:
    path = Path("some.toml")
    path.write_text(text, encoding="utf-8")
    assert moored_in(path) == moored
    assert moored_in(Path("gone.toml")) is None
    assert moored_in(Path()) is None


def test_a_sizing_out_of_a_file_is_that_of_the_command(run: Run) -> None:
    for path, moored in ((SIZE_BUOY, "buoy"), (SIZE_TANKER, "tanker")):
        ran = run("size", moored, path, "--json")
        found = sized(read_file(path, "buoy" if moored == "buoy" else "tanker"))
        assert json.loads(ran.out) == json.loads(json.dumps(found.to_dict()))


def test_report_takes_a_sizing_file(run: Run) -> None:
    ran = run("report", SIZE_TANKER)
    assert (ran.status, ran.err, ran.out) == (0, "", "size-tanker.html\n")
    page = page_at("size-tanker.html")
    assert page.styled("kind")[0].text == "Calculation note: sizing of a mooring"
    assert page.tagged("h1")[0].text == "Tanker of 50,000 DWT in 20 m"


def test_page_and_workbook_in_vietnamese(run: Run) -> None:
    document, page = note_of(run, SIZE_BUOY, "--lang", "vi", "--out", "notes", "--no-verify")
    assert document["path"] == "notes/size-buoy.html"
    assert "verification" not in page.sections
    assert "Tải trọng" in openpyxl.load_workbook("notes/size-buoy.xlsx").sheetnames


def test_the_document_says_what_was_written(run: Run) -> None:
    document, page = note_of(run, SIZE_BUOY, "--xlsx", "--date", "today", "--method", "pso")
    assert document["workbook"]["path"] == "size-buoy.xlsx"
    assert "The line by particle swarm" in openpyxl.load_workbook("size-buoy.xlsx").sheetnames
    assert document["passes"] is True
    assert document["governing"] == "sliding of the sinker (storm, high water)"
    assert document["verification"]["verdict"] == "agrees"
    assert document["sources"] == digest(SIZE_BUOY)
    assert "swarm" in page.sections
    assert page.table("identity").row("Date")[1].text == "today"


def test_size_writes_the_note_of_its_file_among_the_others(run: Run) -> None:
    assert run("size", "buoy", SIZE_BUOY, "--out", "out", "--json").status == 0
    assert run("report", SIZE_BUOY).status == 0
    assert Path("out/note.html").read_bytes() == Path("size-buoy.html").read_bytes()


def test_without_a_file_the_note_has_the_options_as_typed(run: Run) -> None:
    shown = {
        "BUOY": "pillar 2.4 m", "--depth": "12 m", "--hs": "1.5 m", "--recalled": "",
        "--chain": "chain open-link 4D Q2",
    }  # fmt: skip
    typed = [word for words in shown.items() for word in words if word not in ("", "BUOY")]
    ran = run("size", "buoy", *typed, "--lang", "vi", "--out", "out", "--json")
    page = page_at("out/note.html")
    assert {row[0].text: row[1].text for row in page.table("size_options").rows} == shown
    assert "size_file" not in page.sections
    assert page.tagged("html")[0].attributes["lang"] == "vi"
    chain = page.table("size_found").rows[0][1].value
    assert chain == json.loads(ran.out)["chain"]["nominal_diameter_m"]


@pytest.mark.slow
def test_options_beside_a_file_are_named_as_going_before_it(run: Run) -> None:
    assert run("size", "tanker", SIZE_TANKER, "--lines", 6, "--out", "out", "--json").status == 0
    page = page_at("out/note.html")
    (option,) = page.table("size_options").rows
    assert [cell.text for cell in option] == ["--lines", "6"]
    assert len(page.table("inputs").rows) == len(values_of(SIZE_TANKER)) - 2
    assert "These options went before what the file says." in page.sections["size_inputs"]
    assert "size_pattern" in page.sections


def values_of(path: Path) -> list[str]:
    """Every value of a file whose tables hold values only, by its key."""
    document = parse_toml(path.read_text("utf-8"), path.name)
    return [
        key
        for name, value in document.items()
        for key in (value if isinstance(value, dict) else [name])
    ]
