"""Which of several values alike counts as the largest does not hang on the last digit."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import permutations

import pytest

from catopt.checks.kinds import CheckSource
from catopt.checks.result import CheckReport, CheckResult
from catopt.largest import first_largest, largest
from catopt.mooring.restoring import watch_circle
from catopt.verify.comparison import Compared
from catopt.verify.result import StaticComparison, least_agreeing
from tests.mooring.layouts import spread

ALIKE = tuple(permutations((1.0, 1.0 + 1e-15, 1.0 - 1e-12)))
"""Factors by which rounding, on one processor or another, may tell three equal values apart."""


def test_the_first_of_those_alike_is_the_largest() -> None:
    assert first_largest([1.0, 2.0 - 1e-10, 2.0]) == 1
    assert first_largest([1.0, 2.0 - 1e-6, 2.0]) == 2
    assert first_largest([-2.0, -1.0 - 1e-12, -1.0]) == 1
    assert first_largest([0.0, 1e-7]) == 1
    assert first_largest([0.0, 1e-7], resolved=1e-6) == 0
    assert first_largest([1.0, math.inf]) == 1
    assert first_largest([-math.inf, -math.inf]) == 0
    assert largest(["a", "bb", "cc"], len) == "bb"


def compared(quantity: str, gap: float) -> Compared:
    closed = 40.0
    return Compared(quantity, "m", closed, (closed + gap * 750.0,) * 3, 750.0, 1e-4)


def comparison(*gaps: float) -> StaticComparison:
    quantities = tuple(compared(f"q{index}", gap) for index, gap in enumerate(gaps))
    return StaticComparison("load", "line", quantities, (), (), 1e-4)


@pytest.mark.parametrize("last", ALIKE)
@pytest.mark.parametrize("gap", [6.7e-5, 3e-9])
def test_of_differences_alike_the_first_is_the_worst(last: tuple[float, ...], gap: float) -> None:
    assert comparison(1e-9, *(gap * each for each in last)).worst.quantity == "q1"
    parts = [comparison(gap * each) for each in last]
    assert least_agreeing(parts) is parts[0]


@pytest.mark.parametrize("noise", tuple(permutations((0.0, 3e-14, 2e-11))))
def test_of_differences_that_are_all_rounding_the_first_is_the_worst(
    noise: tuple[float, ...],
) -> None:
    assert comparison(*noise).worst.quantity == "q0"


def checked(name: str, utilisation: float) -> CheckResult:
    return CheckResult(
        name,
        "tension",
        "storm",
        utilisation * 7e3,
        7e3,
        "N",
        utilisation - 1.0,
        CheckSource("user"),
    )


@pytest.mark.parametrize("last", ALIKE)
@pytest.mark.parametrize("used", [0.73, 1.21])
def test_of_checks_alike_the_first_governs(last: tuple[float, ...], used: float) -> None:
    results = tuple(checked(f"check {k}", used * each) for k, each in enumerate(last))
    report = CheckReport("", (checked("other", 0.5), *results), ())
    assert report.governing == results[0]
    assert report.tightest("tension") == results[0]
    assert report.failed == (results if used > 1.0 else ())


def test_of_directions_alike_the_first_is_the_hardest() -> None:
    circle = watch_circle(spread(6), force=2e5, directions=6)
    for last in permutations((1.0, 1.0 + 1e-15, 1.0 - 1e-12, 1.0, 1.0 - 1e-14, 1.0 + 1e-13), 6):
        turned = replace(circle, responses=tuple(
            replace(each, offset=each.offset * by, largest_tension=each.largest_tension * by)
            for each, by in zip(circle.responses, last, strict=True)
        ))  # fmt: skip
        assert (turned.farthest, turned.hardest) == (0, 0)
