"""The calculation note of a sizing by ``catopt report FILE`` and by ``catopt size ... --out``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from catopt.casefile.reading import moored_in
from catopt.documents import parse_toml
from catopt.sizing.file import read_file, sized

from .conftest import CASES, Run
from .notes import page_at

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
    for moored in ("buoy", "tanker"):
        path = CASES / f"size-{moored}" / "sizing.toml"
        ran = run("size", moored, path, "--at-rest", "--json")
        found = sized(read_file(path, "buoy" if moored == "buoy" else "tanker"))
        assert json.loads(ran.out) == json.loads(json.dumps(found.to_dict()))


@pytest.mark.slow
def test_options_beside_a_file_are_named_as_going_before_it(run: Run) -> None:
    assert run("size", "tanker", SIZE_TANKER, "--lines", 6, "--out", "out", "--json").status == 0
    page = page_at("out/note.html")
    (option,) = page.table("size_options").rows
    assert [cell.text for cell in option] == ["--lines", "6"]
    of_file = parse_toml(SIZE_TANKER.read_text("utf-8"), SIZE_TANKER.name).values()
    tables = [each for each in of_file if isinstance(each, dict)]
    assert len(page.table("inputs").rows) == sum(map(len, tables))
    assert "These options overrode the file." in page.sections["size_inputs"]
    assert "size_pattern" in page.sections
