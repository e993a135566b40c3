"""Of a ship in ballast the fairlead is higher, and the water is where it was."""

from __future__ import annotations

import pytest

from catopt.answers.blocks import Figure
from catopt.answers.note_size import size_note_answer
from catopt.casefile import parse_case, write_case
from catopt.errors import InputError
from catopt.model import LoadCase
from catopt.notes.line import Given, size_note
from catopt.notes.origin import Asked
from catopt.sizing.result import Sizing
from tests.sizing.at_rest import size_tanker


@pytest.fixture(scope="module")
def sizing() -> Sizing:
    """By the table the ship has a depth of 16.4 m and draws 12.6 m: its deck is 3.8 m high."""
    return size_tanker(dwt="50000 t", depth="20 m", low_water="18 m", ballast_draught="6.1 m")


@pytest.mark.parametrize(
    ("load_case", "depth", "fairlead"),
    [
        ("loaded, high water", 20.0, 20.0 + 3.8),
        ("loaded, low water", 18.0, 18.0 + 3.8),
        ("ballast, high water", 20.0, 20.0 + 16.4 - 6.1),
        ("ballast, low water", 18.0, 18.0 + 16.4 - 6.1),
    ],
)
def test_the_water_is_as_deep_in_ballast_and_the_fairlead_higher(
    sizing: Sizing, load_case: str, depth: float, fairlead: float
) -> None:
    state = next(each for each in sizing.case.load_cases if each.name == load_case)
    case = sizing.case.under(state)
    assert case.site.water_depth == depth
    assert case.fairlead_height == pytest.approx(fairlead, abs=1e-9)
    solution = dict(sizing.point.checks.solutions)[load_case]
    assert solution.fairlead_height == pytest.approx(fairlead, abs=1e-9)


def test_the_drawing_has_the_water_of_the_load_case(sizing: Sizing) -> None:
    """Of the load case of the largest tension: at high water the line hangs from higher up."""
    name, _ = sizing.hardest
    assert name == "ballast, high water"
    answer = size_note_answer(size_note(sizing, Given(), Asked(verify=False)))
    drawing = next(
        block.chart
        for section in answer.sections
        for block in section.blocks
        if isinstance(block, Figure) and block.chart.name == "line"
    )
    assert [level.at for level in drawing.levels] == [20.0, 0.0]


def test_a_written_case_keeps_the_rise(sizing: Sizing) -> None:
    """In ballast, at high and at low water, on the new line and on the worn one."""
    text = write_case(sizing.case)
    assert text.count("fairlead_rise = ") == 4
    rises = {each.name: each.fairlead_rise for each in sizing.case.load_cases}
    assert {name for name, rise in rises.items() if rise} == {
        "ballast, high water", "ballast, high water, worn chain",
        "ballast, low water", "ballast, low water, worn chain",
    }  # fmt: skip
    assert parse_case(text).load_cases == sizing.case.load_cases


def test_a_fairlead_that_would_be_in_the_bed_is_refused() -> None:
    text = """
[site]
water_depth = "10 m"
[line]
[[line.segments]]
length = "50 m"
submerged_weight = "500 N/m"
[[load_cases]]
name = "deep in the water"
horizontal_force = "5 kN"
water_level = "-1 m"
fairlead_rise = "-9 m"
"""
    with pytest.raises(InputError, match="above -1 m"):
        parse_case(text)
    with pytest.raises(InputError, match="fairlead_rise"):
        LoadCase("storm", 1e3, fairlead_rise=float("nan"))
