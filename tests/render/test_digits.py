"""How many digits a number has: what is not zero is never printed as zero, whatever its size."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from catopt.answers.blocks import Answer, Column, Facts, Section, Table, fact, measured
from catopt.quantities import QUANTITIES
from catopt.render.terminal import show
from catopt.render.values import UNITS
from catopt.render.workbook import workbook
from catopt.words import Measure, Message
from catopt.words.message import number


class Paper:
    """Keeps the cells of tables."""

    def __init__(self) -> None:
        self.rows: list[list[str]] = []

    def text(self, text: str, *, bold: bool = False) -> None:
        pass

    def line(self) -> None:
        pass

    def table(self, columns: Sequence[str], rows: Sequence[Sequence[str]], **_: object) -> None:
        assert all(len(columns) == len(row) for row in rows)
        self.rows += map(list, rows)


def shown(*columns: Column) -> list[list[str]]:
    """Cells of a table of these columns, by rows."""
    paper = Paper()
    title = Message("captions.results")
    show(paper, Answer("any", title, (Section(title, (Table("any", columns),)),)))
    return paper.rows


@pytest.mark.parametrize("size", [10.0**k for k in range(-3, 8)])
def test_a_force_has_its_digits_from_millinewtons_to_meganewtons(size: float) -> None:
    ((said,),) = shown(measured("tension", [0.41394 * size]))
    assert float(said) * 1e3 == pytest.approx(0.41394 * size, rel=2e-3)


def test_a_small_number_beside_a_large_one_keeps_two_digits() -> None:
    column = [6343.35, 4.5032, 0.0, -0.0123]
    assert [row[0] for row in shown(measured("tension", column))] == [
        "6.343", "0.0045", "0.000", "-0.000012",
    ]  # fmt: skip


def test_what_rounding_leaves_beside_large_numbers_is_zero() -> None:
    """Newton's method stops at some 1e-9 of the forces; alone the same number is none."""
    assert [row[0] for row in shown(measured("tension", [4281e3, 1.8e-3]))] == ["4281.000", "0.000"]
    assert [row[0] for row in shown(measured("tension", [1.8e-3]))] == ["0.0000018"]


def test_numbers_of_the_usual_size_have_the_digits_of_the_table() -> None:
    assert QUANTITIES["tension"].format(540347.43) == "540.347"
    assert QUANTITIES["tension"].format(50.0) == "0.050"
    assert QUANTITIES["angle"].format(0.0) == "0.00"
    assert QUANTITIES["utilisation"].format(0.048236) == "0.048"
    assert QUANTITIES["cost"].format(3.0) == "3"
    assert QUANTITIES["span"].format(-1e-12) == "0.000"


def test_units_do_not_make_a_number_zero() -> None:
    """In N forces of a harbour have no digits behind the point; 0.41394 N printed as 0."""
    held = UNITS.set("si")
    try:
        rows = shown(measured("horizontal_force", [0.41394]), measured("tension", [0.65609]))
    finally:
        UNITS.reset(held)
    assert rows == [["0.41394", "0.65609"]]


def test_sentences_have_no_zero_for_what_is_not() -> None:
    assert number(0.00412, ".1f") == "0.0041"
    assert number(0.0, ".1f") == "0.0"
    assert f"{Measure('tension', 0.0042)}" == "0.0000042 kN"


def test_a_workbook_shows_as_many_digits() -> None:
    import io

    import openpyxl

    title = Message("captions.results")
    facts = Facts("any", (fact("tension", 0.41394), fact("span", 11.0704)), title)
    table = Table("t", (measured("tension", [6343.35, 4.5032]),))
    book = openpyxl.load_workbook(
        io.BytesIO(workbook(Answer("any", title, (Section(title, (facts, table)),))))
    )
    formats = {
        cell.value: cell.number_format
        for sheet in book
        for row in sheet
        for cell in row
        if isinstance(cell.value, float)
    }
    assert formats[0.00041394] == "0.00000000"
    assert formats[11.0704] == "0.000"
    assert formats[6.34335] == "0.000"
    assert formats[0.0045032] == "0.0000"


def test_columns_of_the_same_numbers_stand_beside_each_other_in_any_units() -> None:
    """At the bed H is the tension: in N the second of the two was taken for the first one again."""
    held = UNITS.set("si")
    try:
        rows = shown(measured("horizontal_force", [5e3]), measured("tension", [5e3]))
    finally:
        UNITS.reset(held)
    assert rows == [["5000", "5000"]]
