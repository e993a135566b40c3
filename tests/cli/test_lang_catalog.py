"""``catopt catalog --lang vi``: what is said."""

from __future__ import annotations

import re
from pathlib import Path

import openpyxl
import pytest

from catopt import catalogue
from catopt.words import Message, is_term, say
from tests.catalogue.test_user_families import GOOD

from .conftest import Run

FAMILIES = [family.name for family in catalogue.families()]
MORE = [
    ("show", "wire 6-strand wire-core", "--diameter", "0.09"),
    ("show", "chain stud-link U2", "--diameter", "60 mm", "--variant", "all=orcaflex-old"),
    ("search", "--mbl", "500 kN", "--recalled"),
    *(("show", name) for name in FAMILIES if name != "chain stud-link"),
]


def test_the_answer_in_words(run: Run, tmp_path: Path) -> None:
    ran = run(
        "catalog", "show", "nylon", "--diameter", "60 mm", "--lang", "vi", "--out", tmp_path
    )  # fmt: skip
    shown = " ".join(ran.out.split())
    for part in (
        "Cáp nylon: nylon 60 mm",
        "Lực kéo đứt tối thiểu MBL 794.9 kN C MP",
        "585 d^2 kg/m, d tính bằng m; 20 mm đến 200 mm. C, MP: nylon.mass_d2",
        "Lực cản dọc dây: chưa biết; danh mục không có số liệu.",
        "MP: NREL MoorPy, fits to makers' catalogues.",
    ):
        assert part in shown
    assert openpyxl.load_workbook(tmp_path / "catalog.xlsx").sheetnames == [
        "Cấu kiện", "Số liệu", "Các họ", "Nguồn",
    ]  # fmt: skip


@pytest.mark.parametrize("name", FAMILIES)
def test_all_that_the_data_say_of_a_family_is_said(name: str) -> None:
    """Its title and notes, and formula, reason and note of every figure, recalled ones included."""
    family = catalogue.standard().family(name)
    told = [family.title, family.note]
    told += [text for figure in family.figures for text in (figure.reason, figure.note)]
    assert [text for text in told if text and say(text, "vi") == text] == []
    formulas = [say(figure.text, "vi") for figure in family.figures]
    english = re.compile(r"d in mm?|both legs|table of|times|volume-equivalent|tension")
    assert [text for text in formulas if english.search(text)] == []


def test_what_is_cited_is_in_no_table() -> None:
    """Titles of documents and places in them; what is reckoned or recalled is in no document."""
    standard = catalogue.standard()
    figures = [figure for family in standard.families for figure in family.figures]
    cited = {figure.place for figure in figures if figure.confidence != "R"}
    cited |= {s.title for figure in figures for s in figure.sources if s.key != "RECALLED"}
    assert cited
    assert not [text for text in cited if is_term(text) or isinstance(text, Message)]


def test_a_users_own_texts_stay(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(GOOD, encoding="utf-8")
    (own,) = catalogue.read_families(path).families
    ran = run("catalog", "list", "--families", path, "--lang", "vi")
    assert own.name in ran.out
    ran = run("catalog", "show", own.name, "--families", path, "--lang", "vi")
    assert ran.status == 0, ran.err
    assert own.title in " ".join(ran.out.split())
