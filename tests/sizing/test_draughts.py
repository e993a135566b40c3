"""Of a ship in ballast the fairlead is higher, and the water is where it was."""

from __future__ import annotations

import pytest

import catopt
from catopt.answers.blocks import Figure, Verdict
from catopt.answers.note_size import size_note_answer
from catopt.casefile import parse_case, write_case
from catopt.errors import InputError
from catopt.model import LoadCase
from catopt.notes.directory import Asked
from catopt.notes.size import Given, size_note
from catopt.render.page import page
from catopt.sizing.result import Sizing
from catopt.words import say


@pytest.fixture(scope="module")
def sizing() -> Sizing:
    """By the table the ship has a depth of 16.4 m and draws 12.6 m: its deck is 3.8 m high."""
    return catopt.size_tanker(
        dwt="50000 t", depth="20 m", low_water="18 m", ballast_draught="6.1 m"
    )


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
    name, _ = sizing.hardest
    assert name == "ballast, low water"
    answer = size_note_answer(size_note(sizing, Given(), Asked(verify=False)))
    drawing = next(
        block.chart
        for section in answer.sections
        for block in section.blocks
        if isinstance(block, Figure) and block.chart.name == "line"
    )
    assert [level.at for level in drawing.levels] == [18.0, 0.0]


def test_a_written_case_keeps_the_rise(sizing: Sizing) -> None:
    text = write_case(sizing.case)
    assert text.count("fairlead_rise = ") == 2
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


def verdict(of: Sizing) -> Verdict:
    summary = size_note_answer(size_note(of, Given(), Asked(verify=False))).sections[0]
    return next(block for block in summary.blocks if isinstance(block, Verdict))


def test_the_verdict_says_what_fails_in_motion_and_is_not_green(sizing: Sizing) -> None:
    """1.2 times a utilisation of 0.9 is more than is allowed."""
    assert sizing.point.checks.passes
    used = max(each.utilisation or 0.0 for each in sizing.point.checks.results)
    assert 1.0 / 1.2 < used < 1.0
    found = verdict(sizing)
    assert found.kind == "reserve"
    assert found.words.startswith("All 20 checks pass.")
    assert "with the allowance for motion of 1.2 it FAILS by tension" in found.words
    assert "với hệ số động 1.2 thì KHÔNG ĐẠT về lực căng" in say(found.words, "vi")
    shown = page(size_note_answer(size_note(sizing, Given(), Asked(verify=False))), "en").decode()
    assert '<p class="verdict reserve">' in shown


def test_a_line_that_passes_in_motion_too_has_a_green_verdict() -> None:
    """Without an allowance nothing is beyond the checks."""
    found = verdict(catopt.size_tanker(dwt="50000 t", depth="20 m", dynamic_factor=1))
    assert found.kind == "passes"
    assert "FAILS" not in found.words


@pytest.mark.parametrize(
    ("passes", "reserve", "kind"),
    [(None, "", ""), (True, "", "passes"), (True, "but", "reserve"), (False, "but", "fails")],
)
def test_the_kinds_of_a_verdict(passes: bool | None, reserve: str, kind: str) -> None:
    assert Verdict("said", passes, reserve).kind == kind
