"""What ``catopt size`` says of mistakes in a file: broken_sizing/NAME.txt, word for word.

Beside it stands ``NAME.toml``, whose name begins with the command.
"""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pytest

from .conftest import BROKEN, Run, refused

NAMES = sorted({path.stem for path in BROKEN.iterdir()})
assert len(NAMES) >= 20


@pytest.mark.parametrize("name", NAMES)
def test_the_message_is_exactly_this(run: Run, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(BROKEN)
    ran = refused(run, "size", name.partition("-")[0], f"{name}.toml")
    assert ran.err == (BROKEN / f"{name}.txt").read_text(encoding="utf-8")


def test_a_form_is_sized_and_its_answer_stands_beside_it(run: Run, inside: Path) -> None:
    """Filled in it is the same question as options are."""
    made = run("new", "buoy", "--out", "form.xlsx")
    assert (made.status, "catopt size form.xlsx" in made.out) == (0, True)
    book = openpyxl.load_workbook("form.xlsx")
    filled: dict[str, str | int] = {"buoy.name": "pillar 1.8 m", "site.water_depth": 12}
    for row in book["Form"].iter_rows(min_row=4):
        row[1].value = filled.get(f"{row[4].value}")
    book.save("form.xlsx")
    by_form = run("size", "form.xlsx", "--at-rest")
    assert (by_form.status, by_form.out) == (
        0,
        run("size", "buoy", "pillar 1.8 m", "--depth", "12 m", "--at-rest").out,
    )
    assert (inside / "form-answer.xlsx").stat().st_size > 0
