"""S3, Table 1, beside the closed form of a line with its touchdown written out here."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import catopt
from catopt.reproduce import Item, Study, reproduce

CASES = Path(__file__).parents[2] / "cases"

DEPTH, LENGTH, WEIGHT, FORCE = 20.0, 55.0, 2.1, 100.0  # m, m, kN/m, kN

A = FORCE / WEIGHT
HANGING = math.sqrt(DEPTH * (DEPTH + 2.0 * A))  # L_min
HANGING_SPAN = A * math.acosh(1.0 + DEPTH / A)
SPARE = LENGTH - HANGING
UPLIFT = 0.5 * WEIGHT * (LENGTH**2 / DEPTH - DEPTH)  # H_1
UPLIFT_SPAN = UPLIFT / WEIGHT * math.acosh(1.0 + DEPTH * WEIGHT / UPLIFT)

ROWS = [
    ("minimum_suspended_length_m", HANGING, "48.01"),
    ("spare_length_m", SPARE, "6.9921"),
    ("span_suspended_m", HANGING_SPAN, "42.24"),
    ("span_total_m", HANGING_SPAN + SPARE, "49.24"),
    ("fairlead_tension_kN", FORCE + WEIGHT * DEPTH, "142.0"),
    ("uplift_horizontal_force_kN", UPLIFT, "137.81"),
    ("uplift_added_force_kN", UPLIFT - FORCE, "37.81"),
    ("uplift_span_m", UPLIFT_SPAN, "50.0"),
    ("uplift_offset_m", UPLIFT_SPAN - HANGING_SPAN - SPARE, "0.78"),
    ("uplift_fairlead_tension_kN", UPLIFT + WEIGHT * DEPTH, "179.81"),
    ("permissible_tension_tf", 770.0 / 5.0, "154"),
]


@pytest.fixture(scope="module")
def study() -> Study:
    return reproduce("tanker_20m").studies[0]


def pick(study: Study, quantity: str) -> Item:
    (item,) = [item for item in study.items if item.quantity == quantity]
    return item


@pytest.mark.parametrize(("quantity", "expected", "published"), ROWS, ids=lambda row: str(row)[:12])
def test_all_eleven_numbers_reproduce(
    study: Study, quantity: str, expected: float, published: str
) -> None:
    item = pick(study, quantity)
    # Double precision of lengths up to 55 m, forces up to 180 kN and their differences.
    assert item.computed == pytest.approx(expected, abs=1e-11)
    assert item.printed.text == item.judgement.computed_text == published
    assert item.verdict == "reproduces"
    assert len(study.items) == 11


def test_sums_and_differences_come_from_unrounded_numbers(study: Study) -> None:
    """From the printed ones they would print differently."""
    assert f"{55.0 - 48.01:.4f}" == "6.9900"
    assert f"{42.24 + 6.9921:.2f}" == "49.23"
    assert f"{50.0 - 49.24:.2f}" == "0.76"
    assert f"{UPLIFT_SPAN:.2f}" == "50.02"
    assert pick(study, "spare_length_m").note == (
        "from unrounded lengths; 55 - 48.01 would be 6.9900"
    )
    assert pick(study, "span_total_m").note == (
        "from unrounded parts; 42.24 + 6.9921 would be 49.23"
    )
    assert pick(study, "uplift_offset_m").note == (
        "from unrounded spans; 50.0 - 49.24 would be 0.76"
    )
    assert pick(study, "uplift_span_m").note == "to two decimals it is 50.02"
    assert study.findings[0].startswith("Of the 10 numbers of Table 1 10 have every printed digit")


def test_the_largest_tension_is_within_the_permissible_one(study: Study) -> None:
    in_tonnes_force = (UPLIFT + WEIGHT * DEPTH) / 9.80665
    assert in_tonnes_force < 154.0
    assert f"{in_tonnes_force:.1f}" == "18.3"
    note = pick(study, "permissible_tension_tf").note
    assert note == "the largest tension of Table 1, 18.3 tf, is within it"


def test_the_case_file_is_the_published_case() -> None:
    solution = catopt.solve_case(catopt.read_case(CASES / "tanker-20m" / "case.toml"))
    # The residual is below 1e-9 of the line's 55 m.
    assert solution.span == pytest.approx(HANGING_SPAN + SPARE, abs=1e-7)
    assert solution.grounded_length == pytest.approx(SPARE, abs=1e-7)
    assert solution.fairlead.tension == pytest.approx(142e3, rel=1e-9)
    used = solution.segments[0].utilisation(solution.safety_factor)
    assert used == pytest.approx(142.0 / (154.0 * 9.80665), rel=1e-9)
