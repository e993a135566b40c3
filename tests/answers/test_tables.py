"""Tables hold the results' numbers, in the unit that their heading says."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import pandas as pd
import pytest

from catopt.answers.blocks import Answer, named
from catopt.answers.check import check_answer
from catopt.answers.loads import loads_answer
from catopt.answers.size import size_answer
from catopt.answers.solution import (
    given_facts,
    given_tables,
    marks_table,
    points_table,
    result_facts,
    solution_answer,
    swarm_tables,
)
from catopt.answers.system import system_answer
from catopt.casefile import read_case
from catopt.catenary.case_curve import CaseCurve, Stepped, curve_case
from catopt.catenary.solution import FoundQuantity, Solution
from catopt.checks.case import check_case
from catopt.checks.kinds import CHECK_KINDS, QUANTITY_OF
from catopt.checks.result import CheckReport
from catopt.loads import compare_tanker
from catopt.model import Checks, Line, Load, Segment
from catopt.mooring.case import SystemReport, report_system
from tests.cli.conftest import FSO
from tests.figures.kinds import leg

from .results import CURVED, around, buoy_case, by_force, solved, swarm
from .tables import tables_of

Held = tuple[Answer, Mapping[str, Mapping[str, Sequence[Any]]]]
"""An answer, and what the columns of some of its tables must hold."""


@cache
def checked() -> CheckReport:
    """Check the buoy of S1: T = 4.377 kN and 230 kN / 5 = 46 kN; lifted off its bed."""
    checks = Checks(5.0, max_anchor_uplift_angle=0.0, max_span=20.0)
    return check_case(buoy_case(checks=checks))


@cache
def moored() -> SystemReport:
    return report_system(
        read_case(FSO),
        with_line_out=True,
        with_circle=True,
        directions=[math.pi, 0.5 * math.pi],
        levels=[-2.0, 2.0],
    )


@cache
def curve_over(over: Stepped) -> CaseCurve:
    return curve_case(CURVED, over=over, points=20)


def rounded(values: Iterable[float]) -> list[Any]:
    """Allow numbers one rounding of a conversion either way."""
    return [pytest.approx(value, rel=1e-15) for value in values]


def degrees(angles: Iterable[float]) -> list[Any]:
    return rounded(math.degrees(angle) for angle in angles)


def _checks() -> Held:
    assert set(QUANTITY_OF) == set(CHECK_KINDS)
    tension, angle, span = checked().results
    demands = [tension.demand / 1e3, *degrees([angle.demand]), span.demand]
    return check_answer(checked()), {
        "checks": {
            "Unit": ["kN", "deg", "m"],
            "Demand (unit of the row)": demands,
            "Capacity (unit of the row)": [46.0, 0.0, 20.0],
            "Passes": ["yes", "no", "yes"],
            "Source": ["case file"] * 3,
            "Code": ["user"] * 3,
        },
        "load_cases": {"Load case": ["load"], "Kind": ["extreme"]},
    }


def _system() -> Held:
    lines = moored().solution.lines
    return system_answer(moored(), check_case(moored().case)), {
        "body": {"Offset along x (m)": [moored().solution.offset[0]]},
        "lines": {"Fairlead tension T (kN)": rounded(line.tension / 1e3 for line in lines)},
        "shapes": {"Lowest point, height (m)": [0.0] * 9},
        "line_out": {"Line out": range(1, 10)},
        "watch_circle": {},
        "restoring_1": {"Direction (deg)": [180.0] * 41},
        "restoring_2": {},
        "water_levels": {"Water level (m)": [-2.0, 2.0]},
    }


def _pattern() -> Held:
    of = around()
    assert of.pattern is not None
    return size_answer(of), {
        "pattern": {
            "Force off that line (deg)": degrees(each.direction for each in of.pattern.states),
            "Pull of all lines (kN)": [each.pull / 1e3 for each in of.pattern.states],
        }
    }


def _by_force() -> Held:
    return size_answer(by_force()), {"forces": {"Force F, given (kN)": rounded([3.3637] * 2)}}


@pytest.mark.parametrize("held_by", [_checks, _system, _pattern, _by_force])
def test_columns_hold_the_numbers_in_the_unit_of_their_heading(held_by: Callable[[], Held]) -> None:
    answer, held = held_by()
    made = tables_of(answer)
    for name, columns in held.items():
        assert made[name].columns.is_unique
        for heading, values in columns.items():
            assert list(made[name][heading]) == list(values)


def test_what_is_not_known_is_empty_and_not_zero() -> None:
    frame = next(given_tables(Line([Segment(20.0, 93.0)]))).to_dataframe()
    for heading in ("Mass per length m (kg/m)", "Minimum breaking load MBL (kN)"):
        assert frame[heading].isna().all()
    assert frame["Axial stiffness EA (MN)"].iloc[0] == float("inf")
    row = of_a_line(solved())["inputs"].iloc[0]
    assert pd.isna(row["Allowed inclination at the anchor (deg)"])
    assert row["Safety factor SF (-)"] == 5.0
    assert math.isnan(tables_of(check_answer(checked()))["checks"]["Utilisation (-)"][1])


# ------------------------------------------------------------------ a line


def of_a_line(solution: Solution) -> dict[str, pd.DataFrame]:
    """Tables of the answer, of a case that is none of its business."""
    return tables_of(solution_answer(buoy_case(), solution))


def test_the_buoy_is_as_s1_prints_it() -> None:
    row = of_a_line(solved())["summary"].iloc[0]
    assert row["Inclination at the anchor theta0 (rad)"] == pytest.approx(0.272, abs=0.5e-3)
    assert row["Span S (m)"] == pytest.approx(17.430, abs=0.5e-3)
    assert row["Fairlead tension T (tf)"] == pytest.approx(0.446, abs=0.5e-3)
    # 1 tf is 9.80665 kN, so that both columns are the same force.
    kN, tf = row["Fairlead tension T (kN)"], row["Fairlead tension T (tf)"]
    assert kN == pytest.approx(9.80665 * tf, rel=1e-15)
    assert row["Line mass in air (t)"] == pytest.approx(0.218, rel=1e-15)  # 20 m of 10.9 kg/m
    assert (row["Title"], row["Method"], row["Regime"]) == ("Buoy", "closed-form", "suspended")
    load_case = tables_of(check_answer(checked()))["load_cases"].iloc[0]
    assert round(load_case["Span S (m)"], 2) == 17.43
    assert round(load_case["Fairlead tension T (kN)"] / 9.80665, 4) == 0.4463


def test_swarm_tables() -> None:
    by_swarm = swarm()
    assert by_swarm.swarm is not None
    history, runs = (each.to_dataframe() for each in swarm_tables(by_swarm.swarm))
    assert list(history["Iteration"]) == [1, 2, 3, 4, 5, 6, 7]
    assert list(history["Best objective f (m)"]) == [1.0, 0.3, 1e-3, 1e-8, 3.55e-15, 0.0, 0.0]
    assert runs.to_dict("records") == [
        {"Run": 1, "Objective f (m)": 0.0, "Iterations flown": 7, "Best run": "yes"}
    ]
    assert of_a_line(by_swarm)["swarm_settings"].iloc[0]["Particles"] == 200


@pytest.mark.parametrize(
    ("load", "heading"),
    [
        (Load(horizontal_force=1e3), "Given horizontal force H (kN)"),
        (Load(span=17.0), "Given span S (m)"),
        (Load(fairlead_tension=1e4), "Given fairlead tension T (kN)"),
    ],
)
def test_only_the_load_that_is_given_is_listed(load: Load, heading: str) -> None:
    facts = given_facts(buoy_case(load=load))
    laid = [column.said_heading() for fact in facts for column in fact.columns()]
    listed = [name for name in laid if name.startswith("Given") and "(tf)" not in name]
    assert listed == [heading]


@pytest.mark.parametrize(
    ("quantity", "value", "heading", "shown"),
    [
        ("length", 17.5, "Found length of segment 2 L (m)", 17.5),
        ("clump_weight", 5e4, "Found weight of point load 2 W (kN)", 50.0),
        ("horizontal_force", 5e4, "Found horizontal force H (kN)", 50.0),
    ],
)
def test_what_was_found_comes_with_its_condition(
    quantity: Any, value: float, heading: str, shown: float
) -> None:
    found = FoundQuantity(quantity, value, "inclination at the anchor 0 deg", 0.0, number=2)
    row = of_a_line(replace(solved(), found=found))["summary"].iloc[0]
    assert row[heading] == shown
    assert row["Condition"] == "inclination at the anchor 0 deg"
    assert "Condition" not in of_a_line(solved())["summary"]


def test_no_two_facts_share_a_heading() -> None:
    headings = [column.said_heading() for fact in result_facts(leg()) for column in fact.columns()]
    assert len(set(headings)) == len(headings)


def test_a_force_in_tf() -> None:
    force = named("tension").in_units("tf")
    assert force.field_unit == "tf"
    assert force.format(9806.65, unit=True) == "1.0000 tf"


# ------------------------------------------------------------------ a load curve


@pytest.mark.parametrize("over", ["force", "span", "offset"])
def test_a_curve_has_its_points_and_its_marks(over: Stepped) -> None:
    result = curve_over(over)
    curve, frame = result.curve, points_table(result).to_dataframe()
    for heading, values in {
        "Span S (m)": curve.span.tolist(),
        "Horizontal force H (kN)": (curve.horizontal_force / 1e3).tolist(),
        "Inclination at the anchor theta0 (deg)": degrees(curve.anchor_angle.tolist()),
        "Stiffness k (kN/m)": rounded((curve.stiffness / 1e3).tolist()),
        "Regime": curve.regime,
    }.items():
        assert list(frame[heading]) == list(values)
    zero = result.reference.span
    assert frame["Offset (m)"].to_numpy() == pytest.approx(curve.span - zero, abs=1e-12)
    marks = marks_table(result).to_dataframe()
    assert Counter(marks["Kind"]) == {"clump_weight": 4, "regime": 1, "limit": 2}
    assert marks["Span S (m)"].is_monotonic_increasing
    assert marks["Horizontal force H (kN)"].is_monotonic_increasing
    plain = replace(CURVED, line=Line([Segment(80.0, 2100.0)]))
    without = marks_table(curve_case(plain, stop=1e3, start=1e2)).to_dataframe()
    assert without.empty
    assert list(without.columns) == list(marks.columns)


def test_a_stiffness_without_end_is_empty() -> None:
    flat = replace(CURVED, line=Line(CURVED.line.segments), fairlead_height=0.0)
    frame = points_table(curve_case(flat, points=3)).to_dataframe()
    assert frame["Stiffness k (kN/m)"].isna().all()


# ------------------------------------------------------------------ checks, and a moored body


def test_a_moored_body_has_the_tables_of_what_was_computed() -> None:
    answer, held = _system()
    made = tables_of(answer)
    assert list(made) == list(held)
    azimuths = [-3, 0, 3, 117, 120, 123, 237, 240, 243]
    assert made["lines"]["Azimuth (deg)"].tolist() == pytest.approx(azimuths, abs=1e-12)
    # The rule of practice is listed only where it applies.
    assert not any("rule" in str(heading) for heading in made["body"])


# ------------------------------------------------------------------ loads, and a sizing


def test_the_last_row_of_loads_is_the_force_that_the_mooring_holds() -> None:
    of = compare_tanker().loads
    made = tables_of(loads_answer(of))
    forces, axes = made["loads"]["Force F (kN)"], made["loads"]["Axis"][:-1]
    surge, sway = (forces[:-1][axes == axis].sum() for axis in ("surge", "sway"))
    # Relative: a few roundings of double precision.
    assert forces.iloc[-1] == pytest.approx((surge**2 + sway**2) ** 0.5, rel=1e-14)
    assert len(made["numbers"]) == sum(len(each.numbers) for each in of.components)


def test_a_sizing_and_its_candidates_are_in_the_units_of_the_field() -> None:
    of = around()
    found = tables_of(size_answer(of))
    rows = found["sizing"].set_index("What")
    value, unit = rows["Value (unit of the row)"], rows["Unit"]
    diameter = of.point.line.segments[0].nominal_diameter
    assert diameter is not None
    assert (unit["Chain"], value["Chain"]) == ("mm", pytest.approx(diameter * 1e3, rel=1e-15))
    # A shot of chain is 27.5 m.
    assert unit["Length in shots"] == "shots"
    assert value["Length in shots"] == value["Length"] / 27.5
    assert (unit["Lines, evenly spaced"], value["Lines, evenly spaced"]) == ("-", 4.0)
    assert unit["Tension at the fairlead"] == "kN"
    assert value["Tension at the fairlead"] == of.hardest[1].fairlead.tension / 1e3
    frame = found["candidates"]
    best = frame[frame["Which"] == "recommended"].iloc[0]
    mass, anchor = of.point.line.mass, of.point.anchor
    assert mass is not None
    assert anchor is not None
    assert anchor.mass is not None
    assert best["Mass in air (t)"] == pytest.approx(mass / 1e3, rel=1e-15)
    assert best["Anchor, mass in air (t)"] == pytest.approx(anchor.mass / 1e3, rel=1e-15)
    assert best["Largest span S (m)"] == of.point.objectives["offset_m"]


def test_checks_and_loads_of_a_sizing_are_those_of_the_commands() -> None:
    of = around()
    found = tables_of(size_answer(of))
    checks = tables_of(check_answer(of.point.checks))["checks"]
    pd.testing.assert_frame_equal(found["checks"], checks, check_exact=True)
    for each in of.settled.posed.loads:
        for part in each.parts:
            alone = tables_of(loads_answer(part))
            for name, same in (("forces", "loads"), ("numbers", "numbers")):
                frame = found[name]
                own = frame[(frame["Load case"] == each.load_case) & (frame["On"] == part.title)]
                own = own.drop(columns=["Load case", "On"]).reset_index(drop=True)
                pd.testing.assert_frame_equal(own, alone[same], check_exact=True, check_dtype=False)


def test_a_force_that_was_given_stands_alone() -> None:
    found = tables_of(size_answer(by_force()))
    assert found["numbers"].empty
    assert "Symbol" in found["numbers"]
    assert "pattern" not in found
