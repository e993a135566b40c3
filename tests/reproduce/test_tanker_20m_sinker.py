"""S3, Table 2: the true equilibria beside it, and what was found about its columns.

All formulas are S2's and S3's, written out here once more.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import catopt
from catopt.reproduce import Study, reproduce

CASES = Path(__file__).parents[2] / "cases"

DEPTH, WEIGHT, POSITION, FORCE = 20.0, 2.1, 7.0, 450.0  # m, kN/m, m, kN
SINKERS = (100.0, 150.0, 200.0, 250.0, 300.0)  # kN
LENGTHS = ("47.03", "46.55", "46.09", "45.64", "45.20")  # m, printed
TENSIONS = ("183.8", "187.79", "193.05", "199.57", "207.32")  # kN, printed


def height_above_vertex(a: float, equivalent: float) -> float:
    """z_OC of S2 (35) with z_b = sqrt(a2 + L2) - a, m."""
    upper = POSITION + equivalent
    return DEPTH + math.sqrt(a * a + upper * upper) - math.sqrt(a * a + POSITION * POSITION)


def line_length(a: float, equivalent: float) -> float:
    """L_OC of S2 (36) less the equivalent length, m."""
    z = height_above_vertex(a, equivalent)
    return math.sqrt(z * z + 2.0 * a * z) - equivalent


@pytest.fixture(scope="module")
def study() -> Study:
    return reproduce("tanker_20m_sinker").studies[0]


def computed(study: Study, quantity: str) -> list[float | None]:
    return [item.computed for item in study.items if item.quantity == quantity]


def test_every_row_is_the_equilibrium_under_450_kN(study: Study) -> None:
    a = FORCE / WEIGHT
    lengths = [line_length(a, sinker / WEIGHT) for sinker in SINKERS]
    tensions = [FORCE + WEIGHT * height_above_vertex(a, P / WEIGHT) for P in SINKERS]
    # Double precision of sums of lengths up to 150 m (L_eq) and forces up to 600 kN.
    assert computed(study, "line_length_m") == pytest.approx(lengths, abs=1e-10)
    assert computed(study, "fairlead_tension_kN") == pytest.approx(tensions, abs=1e-10)
    assert [f"{length:.2f}" for length in lengths] == ["62.72", "53.56", "47.21", "42.73", "39.50"]
    assert [f"{tension:.2f}" for tension in tensions] == [
        "506.15",
        "520.95",
        "540.35",
        "563.84",
        "590.88",
    ]


def test_every_printed_number_differs(study: Study) -> None:
    printed = [
        text
        for length, tension in zip(LENGTHS, TENSIONS, strict=True)
        for text in (length, tension)
    ]
    assert [item.printed.text for item in study.items] == printed
    assert [item.verdict for item in study.items] == ["differs"] * 10
    assert study.items[1].note == "differs by +322 kN (+175.38 %)"
    assert study.items[4].note == "differs by +1.1 m (+2.43 %)"


def test_the_printed_tensions_are_below_the_load(study: Study) -> None:
    assert max(map(float, TENSIONS)) < FORCE
    assert "the largest printed tension is 207.32 kN" in study.findings[0]


def test_no_common_force_gives_the_printed_lengths(study: Study) -> None:
    """With P submerged each row needs its own H, which is above its printed tension."""
    needed = []
    for sinker, text, tension in zip(SINKERS, LENGTHS, TENSIONS, strict=True):
        low, high = 100.0, 1000.0
        assert line_length(low / WEIGHT, sinker / WEIGHT) < float(text)
        assert line_length(high / WEIGHT, sinker / WEIGHT) > float(text)
        for _ in range(100):
            force = 0.5 * (low + high)
            longer = line_length(force / WEIGHT, sinker / WEIGHT) > float(text)
            low, high = (low, force) if longer else (force, high)
        needed.append(force)
        assert force > float(tension)
    assert [round(force) for force in needed] == [273, 353, 432, 507, 580]
    assert "need H = 273, 353, 432, 507, 580 kN, row by row" in study.findings[1]


def test_the_lengths_follow_from_100_kN_and_a_fortieth_of_the_sinker(study: Study) -> None:
    """All five, digit for digit, with L_eq = 0.0126 P."""
    made = [line_length(100.0 / WEIGHT, 0.0126 * sinker) for sinker in SINKERS]
    assert tuple(f"{length:.2f}" for length in made) == LENGTHS
    # The print leaves little room: a percent of the force or 0.0001 of the ratio off, and it fails.
    for force, ratio in [(99.0, 0.0126), (101.0, 0.0126), (100.0, 0.0125), (100.0, 0.0127)]:
        other = [line_length(force / WEIGHT, ratio * sinker) for sinker in SINKERS]
        assert tuple(f"{length:.2f}" for length in other) != LENGTHS
    finding = study.findings[2]
    assert "give 5 of the 5 printed lengths in every digit with H = 100 kN" in finding
    assert "0.0126 m for each kN of sinker, as if 0.0265 of its weight" in finding


def made_tensions(force: float) -> list[float]:
    """Compute q z_OC + 137.81 kN with a from another force and 0.59 of the sinker's weight."""
    a = force / WEIGHT
    return [WEIGHT * height_above_vertex(a, 0.59 * P / WEIGHT) + 137.81 for P in SINKERS]


def worst(made: list[float]) -> float:
    return max(abs(value - float(text)) for value, text in zip(made, TENSIONS, strict=True))


def test_the_tensions_follow_from_two_other_forces_and_more_of_the_sinker(study: Study) -> None:
    """To 0.01 kN with a from 650 kN, but not with a from the force that is added."""
    assert 1.0 - 1.025 / 2.5 == pytest.approx(0.59, abs=1e-15)
    assert worst(made_tensions(650.0)) < 0.01
    assert worst(made_tensions(649.0)) > 0.01
    assert worst(made_tensions(651.0)) > 0.01
    assert worst(made_tensions(137.81)) > 10.0
    finding = study.findings[3]
    assert f"to {worst(made_tensions(650.0)):.3f} kN or better" in finding
    assert "T = q z_OC + 137.81 kN" in finding
    assert "from H = 650 kN, and 0.59 of the sinker's weight" in finding


def test_neither_column_fits_with_what_fits_the_other() -> None:
    """So that the two columns do not belong to one line."""
    lengths = [line_length(650.0 / WEIGHT, 0.59 * P / WEIGHT) for P in SINKERS]
    assert min(abs(x - float(y)) for x, y in zip(lengths, LENGTHS, strict=True)) > 10.0
    a = 100.0 / WEIGHT
    tensions = [WEIGHT * height_above_vertex(a, 0.0126 * P) + 100.0 for P in SINKERS]
    assert min(abs(x - float(y)) for x, y in zip(tensions, TENSIONS, strict=True)) > 10.0


def test_the_case_file_is_the_row_of_200_kN() -> None:
    solution = catopt.solve_case(catopt.read_case(CASES / "tanker-20m-sinker" / "case.toml"))
    # 47.21 m are 2 mm longer than the exact length, which lie on the bed below the sinker and
    # change the tension by less than 0.01 kN.
    assert solution.line.length == 47.21
    assert solution.fairlead.tension == pytest.approx(540.35e3, abs=10.0)
    assert 0.0 < solution.grounded_length < 0.01
