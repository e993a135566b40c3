"""S2's worked example, beside S2's formulas written out here."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import catopt
from catopt.reproduce import Item, Study, reproduce

CASES = Path(__file__).parents[2] / "cases"

DEPTH, LENGTH, WEIGHT = 200.0, 600.0, 1.0  # m, m, kN/m
FIRST, LOADED = 300.0, 800.0  # kN
SINKER, POSITION = 50.0, 200.0  # kN, m

# S2 (1): 200 sqrt(2 x 300/200 + 1) = 400 m hang, 200 m lie on the bed. asinh(4/3) = ln 3.
FIRST_SPAN = 200.0 + 300.0 * math.log(3.0)
# S2 (1): 200 sqrt(2 x 800/200 + 1) = 600 m hang: all of it. asinh(3/4) = ln 2.
LOADED_SPAN = 800.0 * math.log(2.0)

# S2 (28) to (41), theta0 = 0: the slope is 200/800 below the sinker and 250/800 above it.
BELOW, ABOVE = POSITION * WEIGHT / LOADED, (POSITION * WEIGHT + SINKER) / LOADED
A = LOADED / WEIGHT
Z_OC = DEPTH + A * (math.sqrt(1.0 + ABOVE**2) - math.sqrt(1.0 + BELOW**2))
L_OC = math.sqrt(Z_OC**2 + 2.0 * A * Z_OC)
X_B1, X_B2, X_OC = A * math.asinh(BELOW), A * math.asinh(ABOVE), A * math.acosh(1.0 + Z_OC / A)

COMPUTED = {
    ("plain line", "grounded_length_m"): 200.0,
    ("plain line", "suspended_length_m"): 400.0,
    ("plain line", "span_initial_m"): FIRST_SPAN,
    ("plain line", "span_loaded_m"): LOADED_SPAN,
    ("plain line", "offset_m"): LOADED_SPAN - FIRST_SPAN,
    ("plain line", "fairlead_tension_kN"): LOADED + WEIGHT * DEPTH,  # S2 (4)
    ("line with the sinker", "span_m"): X_B1 + X_OC - X_B2,  # S2 (40)
    ("line with the sinker", "suspended_length_m"): L_OC - POSITION - SINKER / WEIGHT,
    ("line with the sinker", "fairlead_tension_kN"): LOADED + WEIGHT * Z_OC,  # S2 (41)
    ("line with the sinker", "length_saved_m"): LENGTH - (L_OC - SINKER / WEIGHT),
}


@pytest.fixture(scope="module")
def study() -> Study:
    return reproduce("ship_200m").studies[0]


def pick(study: Study, method: str, quantity: str) -> Item:
    (item,) = [i for i in study.items if (i.method, i.quantity) == (method, quantity)]
    return item


def test_each_computed_number_is_that_of_the_formulas(study: Study) -> None:
    assert {(item.method, item.quantity) for item in study.items} == set(COMPUTED)
    for item in study.items:
        # Double precision of lengths up to 600 m and their sums: 1e-13 of 600 m is 6e-11 m.
        expected = COMPUTED[item.method, item.quantity]
        assert item.computed == pytest.approx(expected, abs=6e-11), item.quantity


@pytest.mark.parametrize(
    ("method", "quantity", "published", "computed", "verdict"),
    [
        ("plain line", "grounded_length_m", "200", "200", "reproduces"),
        ("plain line", "suspended_length_m", "400", "400", "reproduces"),
        ("plain line", "span_initial_m", "529.5", "529.6", "differs"),
        ("plain line", "span_loaded_m", "554.5", "554.5", "reproduces"),
        ("plain line", "offset_m", "25.0", "24.9", "differs"),
        ("plain line", "fairlead_tension_kN", "1000", "1000", "reproduces"),
        ("line with the sinker", "span_m", "524.0", "524.1", "differs"),
        ("line with the sinker", "suspended_length_m", "372.3", "372.3", "reproduces"),
        ("line with the sinker", "fairlead_tension_kN", "1013.5", "1013.5", "reproduces"),
        ("line with the sinker", "length_saved_m", "27.7", "27.7", "reproduces"),
    ],
)
def test_every_printed_number_has_its_verdict(
    study: Study, method: str, quantity: str, published: str, computed: str, verdict: str
) -> None:
    item = pick(study, method, quantity)
    assert item.printed.text == published
    assert item.judgement.computed_text == computed
    assert item.verdict == verdict
    assert len(study.items) == 10


def test_what_differs_says_why(study: Study) -> None:
    assert pick(study, "plain line", "span_initial_m").note == (
        "differs by +0.084 m (+0.02 %); printed as if cut off after one decimal, see below"
    )
    assert pick(study, "plain line", "offset_m").note == (
        "differs by -0.066 m (-0.26 %); 554.5 - 529.5 of the printed spans; "
        "to whole metres it is 25"
    )
    assert pick(study, "line with the sinker", "span_m").note == (
        "differs by +0.10 m (+0.02 %); rounding on the way, see below"
    )


def test_cutting_off_after_one_decimal_gives_both_printed_spans(study: Study) -> None:
    """And the offset between them; rounding gives none of the three."""

    def cut(value: float) -> int:
        return math.floor(10.0 * value)  # in tenths of a metre, so that sums are exact

    assert (cut(FIRST_SPAN), round(10.0 * FIRST_SPAN)) == (5295, 5296)
    assert (cut(LOADED_SPAN), round(10.0 * LOADED_SPAN)) == (5545, 5545)
    assert cut(LOADED_SPAN) - cut(FIRST_SPAN) == 250
    assert (cut(X_B1), cut(X_OC), cut(X_B2)) == (1979, 5722, 2461)
    assert cut(X_B1) + cut(X_OC) - cut(X_B2) == 5240
    assert round(10.0 * X_B1) + round(10.0 * X_OC) - round(10.0 * X_B2) == 5241
    assert cut(X_B1 + X_OC - X_B2) == 5241  # the sum must not be cut, but its parts
    first, second = study.findings
    assert "200 + 300 ln 3 = 529.584 m" in first
    assert "Rounded to one decimal it is 529.6 m, cut off after one decimal" in first
    assert "the printed 529.5 m" in first
    assert "800 ln 2 = 554.518 m" in first
    assert "unrounded it is 24.934 m" in first
    assert "197.973 + 572.232 - 246.100 = 524.105 m" in second
    assert "it is 198.0 + 572.2 - 246.1 = 524.1 m" in second
    assert "197.9 + 572.2 - 246.1 = 524.0 m, the print" in second


def test_cutting_off_is_not_shown_to_be_what_s2_did(study: Study) -> None:
    """372.29 m is printed rounded, 372.3 m; and whole metres end at 524 m as well."""
    beyond = L_OC - POSITION - SINKER / WEIGHT
    assert math.floor(10.0 * beyond) == 3722
    assert f"{beyond:.1f}" == "372.3"
    assert round(X_B1) + round(X_OC) - round(X_B2) == 524
    second = study.findings[1]
    assert "372.3 m of line beyond the sinker is rounded, for cut off it would be 372.2" in second
    assert "rounded to whole metres, 198 + 572 - 246 = 524 m, end there too" in second


def test_the_case_files_are_the_published_cases() -> None:
    plain = catopt.solve_case(catopt.read_case(CASES / "ship-200m" / "case.toml"))
    # The residuals of both are below 1e-9 of the line's 600 m.
    assert plain.span == pytest.approx(LOADED_SPAN, abs=1e-6)
    assert plain.fairlead.tension == pytest.approx(1000e3, rel=1e-9)
    with_sinker = catopt.solve_case(catopt.read_case(CASES / "ship-200m-sinker" / "case.toml"))
    assert with_sinker.found is not None
    assert with_sinker.found.value == pytest.approx(L_OC - SINKER / WEIGHT, abs=1e-6)
    assert with_sinker.span == pytest.approx(X_B1 + X_OC - X_B2, abs=1e-6)
