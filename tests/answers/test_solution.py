"""Tables hold the solution's numbers, in the unit that their heading says."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pandas as pd
import pytest

from catopt.answers.blocks import named
from catopt.answers.solution import (
    given_facts,
    given_tables,
    result_facts,
    solution_answer,
    swarm_tables,
)
from catopt.catenary.solution import FoundQuantity, Solution
from catopt.model import Line, Load, Segment
from tests.figures.kinds import leg

from .results import buoy_case, solved, swarm
from .tables import tables_of


def tables(solution: Solution) -> dict[str, pd.DataFrame]:
    """Tables of the answer, of a case that is none of its business."""
    return tables_of(solution_answer(buoy_case(), solution))


def test_summary_of_the_buoy_as_s1_prints_it() -> None:
    row = tables(solved())["summary"].iloc[0]
    assert row["Inclination at the anchor theta0 (rad)"] == pytest.approx(0.272, abs=0.5e-3)
    assert row["Span S (m)"] == pytest.approx(17.430, abs=0.5e-3)
    assert row["Fairlead tension T (tf)"] == pytest.approx(0.446, abs=0.5e-3)
    # 1 tf is 9.80665 kN, so that both columns are the same force.
    kN, tf = row["Fairlead tension T (kN)"], row["Fairlead tension T (tf)"]
    assert kN == pytest.approx(9.80665 * tf, rel=1e-15)
    assert row["Line mass in air (t)"] == pytest.approx(0.218, rel=1e-15)  # 20 m of 10.9 kg/m
    assert (row["Title"], row["Method"], row["Regime"]) == ("Buoy", "closed-form", "suspended")


def test_what_is_not_known_is_empty_and_not_zero() -> None:
    unknown = Line([Segment(20.0, 93.0)])
    frame = next(given_tables(unknown)).to_dataframe()
    for heading in ("Mass per length m (kg/m)", "Minimum breaking load MBL (kN)"):
        assert frame[heading].isna().all()
    assert frame["Axial stiffness EA (MN)"].iloc[0] == float("inf")
    row = tables(solved())["inputs"].iloc[0]
    assert pd.isna(row["Allowed inclination at the anchor (deg)"])
    assert row["Safety factor SF (-)"] == 5.0


def test_swarm_tables() -> None:
    by_swarm = swarm()
    assert by_swarm.swarm is not None
    history, runs = (each.to_dataframe() for each in swarm_tables(by_swarm.swarm))
    assert list(history["Iteration"]) == [1, 2, 3, 4, 5, 6, 7]
    assert list(history["Best objective f (m)"]) == [1.0, 0.3, 1e-3, 1e-8, 3.55e-15, 0.0, 0.0]
    assert runs.to_dict("records") == [
        {"Run": 1, "Objective f (m)": 0.0, "Iterations flown": 7, "Best run": "yes"}
    ]
    settings = tables(by_swarm)["swarm_settings"].iloc[0]
    assert settings["Particles"] == 200


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
    laid = [column.heading for fact in facts for column in fact.columns()]
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
    row = tables(replace(solved(), found=found))["summary"].iloc[0]
    assert row[heading] == shown
    assert row["Condition"] == "inclination at the anchor 0 deg"
    assert "Condition" not in tables(solved())["summary"]


def test_no_two_facts_share_a_heading() -> None:
    headings = [column.heading for fact in result_facts(leg()) for column in fact.columns()]
    assert len(set(headings)) == len(headings)


def test_a_force_in_tf() -> None:
    force = named("tension").in_units("tf")
    assert force.field_unit == "tf"
    assert force.format(9806.65, unit=True) == "1.0000 tf"
