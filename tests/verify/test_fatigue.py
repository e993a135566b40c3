"""Fatigue of the example, against a count and a sum of the test's own."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import numpy.typing as npt
import pytest

from catopt import schemas
from catopt.answers.blocks import Verdict
from catopt.answers.verification import fatigue_answer, fatigue_sentence
from catopt.casefile import parse_case, read_case, write_case
from catopt.errors import InputError
from catopt.model import Case, FatigueSeaState, LoadCase
from catopt.verify.dynamic_lines import lines_at_rest
from catopt.verify.dynamic_setup import read_drive
from catopt.verify.fatigue import FatigueReport, sea_states, verify_fatigue
from catopt.words import say
from tests.checks.test_fatigue import four_points

EXAMPLE = Path(__file__).parents[2] / "cases" / "fatigue-chain-20m" / "case.toml"


def example() -> Case:
    found: Case = read_case(EXAMPLE)
    return found


def with_fatigue(**changes: Any) -> Case:
    case = example()
    assert case.fatigue is not None
    return replace(case, fatigue=replace(case.fatigue, **changes))


@cache
def report() -> FatigueReport:
    return verify_fatigue(example(), convergence_check="none")


def damage_by_bar(height: float, period: float) -> npt.NDArray[np.float64]:
    """Miner's sum in a year of nothing but this wave, by four points, of every bar.

    At 72 mm (76 mm less half of 20 years of 0.4 mm): A = 2 pi 72^2/4 = 8143 mm2; N = 6e10 s^-3.
    """
    case = example()
    assert case.waves is not None
    waves = replace(case.waves, height=height, period=period)
    drive = replace(read_drive(replace(case, waves=waves)), counts_cycles=True)
    lines, sea = lines_at_rest(drive), drive.sea(0)
    stepping = drive.stepping(sea, lines.driven_by(sea))
    history, _ = lines.run(sea, stepping, 20, lambda _: None)
    at = history.time >= 16.0 - 1e-9
    area = 2.0 * math.pi * 72.0**2 / 4.0
    time = history.time[at][-1] - history.time[at][0]
    sums = [
        sum(count * (size / area) ** 3 for size, count in four_points(series.tolist())) / 6.0e10
        for series in history.tension[at].T
    ]
    a_year: npt.NDArray[np.float64] = np.array(sums) * 365.25 * 86400.0 / time
    return a_year


def test_the_example_has_the_damage_of_another_count() -> None:
    first = 0.7 * damage_by_bar(1.0, 6.0)
    second = 2000.0 / 8766.0 * damage_by_bar(2.0, 8.0)  # hours of the Julian year
    (segment,) = report().segments
    worst = int((first + second).argmax())
    assert segment.arc == pytest.approx((worst + 0.5) * 120.0 / 20, rel=1e-12)
    assert segment.damage == pytest.approx((first + second)[worst], rel=1e-9)
    assert [each.damage for each in segment.states] == pytest.approx(
        [first[worst], second[worst]], rel=1e-9
    )
    assert segment.worst == int(second[worst] > first[worst])
    assert segment.utilisation == pytest.approx(20.0 * 8.0 * segment.damage, rel=1e-12)
    assert segment.years == pytest.approx(1.0 / segment.damage, rel=1e-12)
    assert report().passes == (segment.utilisation <= 1.0)


def test_what_was_run_once_is_not_proven_and_passes_nothing() -> None:
    found = report()
    assert found.verdict == "not proven"
    (verdict,) = (b for b in fatigue_answer(found).blocks if isinstance(b, Verdict))
    assert verdict.passes is False
    assert "NOT PROVEN" in fatigue_sentence(found)
    assert "CHƯA ĐƯỢC CHỨNG MINH" in say(fatigue_sentence(found), "vi")


def test_half_the_step_shows_how_far_the_damage_hangs_on_it() -> None:
    """One sea state; doubled ranges at half the step would be a change of 1."""
    found = verify_fatigue(with_fatigue(sea_states=(FatigueSeaState(2.0, 8.0, 1.0),)))
    (segment,) = found.segments
    (state,) = segment.states
    assert state.at_half_step is not None
    expected = abs((state.at_half_step / state.damage) ** (1.0 / 3.0) - 1.0)
    assert segment.change == pytest.approx(expected, rel=1e-12)
    assert expected < 0.05
    assert found.verdict == "converged"
    worse = replace(segment, states=(replace(state, at_half_step=8.0 * state.damage),))
    assert worse.change == pytest.approx(1.0, rel=1e-12)


def test_the_document_is_as_its_schema_has_it() -> None:
    document = json.loads(json.dumps(report().to_dict()))
    jsonschema.validate(document, schemas.schema("catopt.fatigue/1"))
    assert document["share_of_year"] == pytest.approx(0.7 + 2000.0 / 8766.0, rel=1e-12)


def test_the_case_is_written_and_read_back() -> None:
    case = example()
    assert parse_case(write_case(case), folder=str(EXAMPLE.parent)) == case


def test_sea_states_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "states.csv").write_text(
        "height (m),period (s),time (h),direction (deg)\n1,6,6136.2,180\n2,8,2000,90\n"
    )
    case = with_fatigue(sea_states=(), sea_states_file=str(tmp_path / "states.csv"))
    first, second = sea_states(case)
    assert (first.height, first.period, second.height, second.period) == (1.0, 6.0, 2.0, 8.0)
    assert (first.share, second.share) == pytest.approx((0.7, 2000.0 / 8766.0), rel=1e-12)
    assert (first.direction, second.direction) == pytest.approx((math.pi, math.pi / 2.0))
    (tmp_path / "states.csv").write_text("height (m),period (s),share\n1,6,0.7\n-2,8,0.7\n")
    with pytest.raises(InputError) as caught:
        sea_states(case)
    assert [each.key for each in caught.value.problems] == ["sea_states", "line 3, height"]


CELLS = "# Hs by Tp of a year\nheight (m),period (s),{}\n\n1,6,{}\n2,8,{}\n"


def of_cells(folder: Path, heading: str, first: str, second: str) -> tuple[FatigueSeaState, ...]:
    path = folder / "scatter.csv"
    path.write_text(CELLS.format(heading, first, second))
    return sea_states(with_fatigue(sea_states=(), sea_states_file=str(path)))


@pytest.mark.parametrize(
    ("heading", "first", "second"),
    [
        ("occurrences (of 1000)", "700", "250.5"),
        ("occurrences (of 8000)", "5600", "2004"),
        ("share (%)", "70", "25.05"),
        ("share (-)", "0.7", "0.2505"),
    ],
)
def test_a_scatter_table_has_its_total_in_the_heading(
    tmp_path: Path, heading: str, first: str, second: str
) -> None:
    """700 and 250.5 of 1000 are 0.7 and 0.2505 of the year, whatever the total."""
    states = of_cells(tmp_path, heading, first, second)
    assert [(each.height, each.period) for each in states] == [(1.0, 6.0), (2.0, 8.0)]
    assert [each.share for each in states] == pytest.approx([0.7, 0.2505], rel=1e-12)


@pytest.mark.parametrize(
    ("heading", "first", "second", "told"),
    [
        ("occurrences", "700", "250", "found occurrences; the total that"),
        ("occurrences (of 0)", "700", "250", "as in (of 1000)"),
        ("occurrences (of 1e3)", "700", "250", "as in (of 1000)"),
        ("occurrences (%)", "70", "25", "as in (of 1000)"),
        ("share (ppt)", "700", "250", "one of -, %"),
        (
            "occurrences (of 1000)",
            "800",
            "250",
            "sea_states: found 1.05; the shares add up",
        ),
        ("occurrences (of 1000)", "700", "-1", "line 5, share"),
        ("occurrences (of 1000)", "700", "many", "line 5, occurrences: found many"),
    ],
)
def test_a_scatter_table_that_does_not_add_up_is_refused(
    tmp_path: Path, heading: str, first: str, second: str, told: str
) -> None:
    with pytest.raises(InputError) as caught:
        of_cells(tmp_path, heading, first, second)
    assert told in str(caught.value)


def test_one_column_says_how_long_a_sea_state_lasts(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="found share and occurrences; one of them is required"):
        of_cells(tmp_path, "share,occurrences (of 1000)", "0.7,700", "0.2,200")


def test_several_load_cases_need_a_name() -> None:
    states = (LoadCase("storm", 3e5), LoadCase("calm", 1e5))
    with pytest.raises(InputError, match="--load-case: one of storm, calm"):
        verify_fatigue(replace(example(), load=None, load_cases=states))


def broken(text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        parse_case(text, folder=str(EXAMPLE.parent))
    return [f"{each.key}: {each.found}: {each.allowed}" for each in caught.value.problems]


def test_all_that_is_wrong_is_told_at_once() -> None:
    text = EXAMPLE.read_text()
    text = text.replace('code = "DNV-OS-E301-2008"', 'sea_states_file = "a.csv"')
    text = text.replace("share = 0.7", "share = 0.9").replace('spectrum = "regular"\n', "")
    text += '\n[[fatigue.curves]]\nsegment = 2\nname = "E301 stud"\nK = 5.0\n'
    told = broken(text)
    assert any(each.startswith("fatigue: sea_states and sea_states_file") for each in told)
    assert any(each.startswith("fatigue.design_factor: : missing") for each in told)
    assert any(each.startswith("fatigue.sea_states: 1.12") for each in told)
    assert any(each.startswith("fatigue.curves[0]: name and K") for each in told)
    assert any(each.startswith("fatigue.curves[0].segment: 2: the line has 1") for each in told)
    assert any(each.startswith("waves: no spectrum: [fatigue] needs") for each in told)


@pytest.mark.parametrize("section", ["service", "dynamics", "waves"])
def test_what_fatigue_needs_is_named(section: str) -> None:
    head, _, rest = EXAMPLE.read_text().partition(f"[{section}]\n")
    _, _, tail = rest.partition("\n[")
    told = broken(f"{head}[{tail}")
    assert any(each.startswith(f"fatigue: : needs [{section}]") for each in told)


def test_a_sea_state_needs_one_way_of_saying_how_long() -> None:
    told = broken(EXAMPLE.read_text().replace("share = 0.7", 'share = 0.7\ntime_per_year = "1 h"'))
    (only,) = told
    assert only.startswith("fatigue.sea_states[0]: share and time_per_year: exactly one of")
