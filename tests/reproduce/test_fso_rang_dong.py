"""S4's turret: every printed static figure as run, and both models on a bed that only pushes."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import catopt
from catopt.figures.studies import models_from_above, models_from_the_side, models_near
from catopt.reproduce import Study, book, reproduce
from catopt.reproduce.fso_rang_dong import as_run, free_bed, turret
from catopt.reproduce.items import published

ROOT = Path(__file__).parents[2]
BY_SOURCE = ("MOORING_2017", "MOORING_2017, line 1", "MOORING_2017, line 2")


@pytest.fixture(scope="module")
def study() -> Study:
    return reproduce("fso_rang_dong").studies[0]


def test_every_printed_figure_of_the_source_s_program_reproduces(study: Study) -> None:
    """To the last printed digit, which is at most 0.03 % of each tension."""
    items = [item for item in study.items if item.method in BY_SOURCE]
    assert len(items) == 25
    assert {item.verdict for item in items} == {"reproduces"}
    offset = items[0]
    assert (offset.quantity, offset.published) == ("turret_offset_m", 6.071)
    assert offset.computed == pytest.approx(6.071, abs=0.0005)
    for item in items:
        assert item.computed == pytest.approx(item.published, rel=4e-4)


def test_the_six_digits_of_the_leeward_lines_are_missed_in_the_fourth(study: Study) -> None:
    """All 66 are low alike, by some 0.0175 %: by the weight of what hangs, so much too small here.

    With 9.81 m/s2, 0.034 % more, they are high by as much; between lies the run that was printed.
    """
    names = [f"MOORING_2017, line {n}" for n in range(4, 10)]
    items = [item for item in study.items if item.method in names]
    assert len(items) == 66
    assert {item.verdict for item in items} == {"differs"}
    for item in items:
        assert item.computed is not None
        assert item.computed / item.published - 1.0 == pytest.approx(-1.75e-4, abs=2e-5)
    # S4's symmetry about the x axis: lines 4 and 9 alike, 5 and 8, 6 and 7.
    prints = [[item.published for item in items if item.method == name] for name in names]
    assert prints == prints[::-1]
    told = study.findings[1]
    assert "none of these 66 tensions" in told
    assert "0.018 % low" in told
    assert "58 of the 66" in told


def test_orcaflex_is_near_the_run_and_differs(study: Study) -> None:
    items = [item for item in study.items if item.method == "OrcaFlex"]
    assert [item.verdict for item in items] == ["differs"] * 3
    for item in items:
        assert item.computed == pytest.approx(item.published, rel=0.05)
    assert "with a bed that only pushes and the printed EA it is 21.738 m" in items[0].note


def test_with_a_bed_that_only_pushes_the_models_agree_to_a_hundredth_of_a_percent() -> None:
    found = free_bed()
    assert found.verdict == "agrees"
    assert found.tolerance == 1e-4
    offset = found.of("position_x")
    assert offset.closed_form == pytest.approx(-21.738, abs=0.001)
    assert offset.extrapolated == pytest.approx(offset.closed_form, rel=1e-6)
    for k in range(9):
        for quantity in ("fairlead_tension", "anchor_tension", "horizontal_force"):
            each = found.of(quantity, k)
            assert each.extrapolated == pytest.approx(each.closed_form, rel=1e-4)


def test_the_forces_of_the_lines_balance_the_printed_one_in_both() -> None:
    """At the truss's offset, the closed form's horizontal forces too: to 0.01 %."""
    source = published("fso_rang_dong")
    system = turret(source)
    x = free_bed().of("position_x").extrapolated
    total = 0.0
    for leg in system.legs:
        to_x, to_y = leg.anchor[0] - x, leg.anchor[1]
        span = math.hypot(to_x, to_y)
        line = catopt.solve(leg.line, height=leg.fairlead_height, span=span)
        total += line.horizontal_force * to_x / span
    assert total == pytest.approx(4281e3, rel=1e-4)


def test_the_held_bed_pulls() -> None:
    """What the hanging 138 m lift at the second joint, against what their weight alone allows."""
    line = as_run().lines[1]
    assert line.bed_reaction.min() < -800e3
    assert line.nodes[:11, 2].tolist() == [0.0] * 11


def test_the_two_choices_one_at_a_time(study: Study) -> None:
    table, models = study.side_by_side
    offsets = {row[0]: float(row[1]) for row in table.rows}
    assert offsets["printed, MOORING_2017"] == offsets["as run: held both ways, 100 EA"] == 6.071
    rising = [
        offsets[name]
        for name in (
            "as run: held both ways, 100 EA",
            "held both ways, printed EA",
            "pushes only, 100 EA",
            "pushes only, printed EA",
        )
    ]
    assert rising == sorted(rising)
    assert rising[-1] == pytest.approx(21.738, abs=0.0005)
    assert {row[-1] for row in models.rows} == {"yes"}
    assert len(models.rows) == 1 + 2 * 9


def test_the_finding_is_told_with_its_numbers(study: Study) -> None:
    told = " ".join(study.findings)
    for words in (
        "held at the bed in height both ways",
        "100 times as large as printed",
        "21.738 m from the origin under 4,281 kN instead of 6.071 m",
        "504 m lie on the bed, not 944 m",
        "3 degrees apart",
    ):
        assert words in told


def test_with_the_azimuths_of_the_text_the_tensions_do_not_come_out() -> None:
    lines = as_run(azimuths="azimuth_printed_deg").lines
    assert abs(lines[0].tension[-1] / 1e3 - 1828) > 10
    assert abs(lines[1].tension[-1] / 1e3 - 1918) > 10


def test_the_case_file_is_the_published_case() -> None:
    case = catopt.read_case(ROOT / "cases" / "fso-rang-dong" / "case.toml")
    system = turret(published("fso_rang_dong"))
    assert case.system is not None
    assert case.system.force == system.force
    for own, other in zip(case.system.legs, system.legs, strict=True):
        # Products of the same decimal numbers, in either order.
        assert own.azimuth == pytest.approx(other.azimuth, rel=1e-15)
        assert (own.anchor_radius, own.fairlead_height) == pytest.approx(
            (other.anchor_radius, other.fairlead_height), rel=1e-15
        )
        for a, b in zip(own.line.segments, other.line.segments, strict=True):
            assert (a.length, a.submerged_weight, a.EA) == pytest.approx(
                (b.length, b.submerged_weight, b.EA), rel=1e-15
            )


def test_the_page_shows_the_tables_and_both_views() -> None:
    page = book(reproduce("fso_rang_dong"))
    assert "**What the two choices make**" in page
    for view in ("plan", "elevation"):
        assert f"](fso_rang_dong_{view}.svg)" in page
        assert (ROOT / "reports" / f"fso_rang_dong_{view}.svg").exists()


def test_the_plan_shows_both_moorings_and_the_elevation_the_loaded_line(study: Study) -> None:
    of = study.moorings
    for chart in (models_from_above(of), models_near(of)):
        assert len(chart.series) == 2 * 9
        assert {series.label for series in chart.series} == {mooring.name for mooring in of}
    near = models_near(of)
    assert near.x.low < -21.7 < -6.1 < near.x.high
    run, free = models_from_the_side(of, study.loaded_line).series
    assert max(run.x) == pytest.approx(1056.0 + 6.071, abs=0.01)
    assert max(free.x) == pytest.approx(1056.0 + 21.738, abs=0.01)
    assert max(free.y) == 71.4
