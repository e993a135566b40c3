"""Comparing a number with what was printed."""

from __future__ import annotations

import pytest

from catopt.reproduce.items import Printed, by_digits, by_order, interval


@pytest.mark.parametrize(
    ("text", "decimals", "digits"),
    [
        ("17.430", 3, 5),
        ("0.272", 3, 3),
        ("0.00", 2, 2),
        ("31", 0, 2),
        ("0", 0, 1),
        ("3.55e-15", 17, 3),
    ],
)
def test_the_digits_of_a_print(text: str, decimals: int, digits: int) -> None:
    assert (Printed(text).decimals, Printed(text).digits) == (decimals, digits)


def test_the_bounds_of_a_print_lie_half_a_digit_to_either_side() -> None:
    assert Printed("17.430").bounds == (17.4295, 17.4305)
    assert Printed("17.43").bounds == (17.425, 17.435)


@pytest.mark.parametrize(
    ("text", "computed", "verdict"),
    [
        ("17.430", 17.42997, "reproduces"),
        ("17.430", 17.4306, "differs"),
        ("17.43", 17.4306, "reproduces"),
        ("0.450", 0.4463, "differs"),
        ("0.00", 0.0049, "reproduces"),
        ("0.00", 0.0051, "differs"),
        ("31", 31.4, "reproduces"),
        ("31", 30.4, "differs"),
    ],
)
def test_every_printed_digit_counts(text: str, computed: float, verdict: str) -> None:
    assert by_digits(Printed(text), computed, "m").verdict == verdict


def test_a_difference_is_told_in_the_unit_and_in_percent() -> None:
    judged = by_digits(Printed("0.450"), 0.4463, "tf")
    assert judged.computed_text == "0.446"
    assert judged.reason == "differs by -0.0037 tf (-0.82 %)"
    assert by_digits(Printed("0.00"), 0.12, "%").reason == "differs by +0.12 %"


@pytest.mark.parametrize(
    ("computed", "verdict"), [(0.0, "reproduces"), (7.1e-15, "reproduces"), (1e-12, "differs")]
)
def test_a_number_that_is_zero_but_for_rounding_is_judged_by_its_order(
    computed: float, verdict: str
) -> None:
    assert by_order(Printed("3.55e-15"), computed, 1e-12, "m").verdict == verdict


def test_a_print_above_the_order_is_not_reproduced_by_zero() -> None:
    assert by_order(Printed("3.55e-3"), 0.0, 1e-12, "m").verdict == "differs"


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_interval_of_an_input_for_a_print(sign: float) -> None:
    """2 x prints as 3.0 for x in 1.475 to 1.525; falling functions likewise."""
    found = interval(lambda x: sign * 2.0 * x, Printed(f"{sign * 3.0:.1f}"), (1.0, 2.0))
    # 4e-16 is two steps of double precision near 1.5.
    assert found.least == pytest.approx(1.475, abs=4e-16)
    assert found.largest == pytest.approx(1.525, abs=4e-16)
    assert found.ends(2) == ("1.48", "1.52")


def test_an_interval_outside_the_range_is_an_error() -> None:
    with pytest.raises(ValueError, match=r"does not pass 2\.95 between 5 and 6"):
        interval(lambda x: x, Printed("3.0"), (5.0, 6.0))


@pytest.mark.parametrize(
    ("text", "computed", "unit", "reason"),
    [
        ("183.8", 506.148, "kN", "differs by +322 kN (+175.38 %)"),
        ("47.03", 62.715, "m", "differs by +16 m (+33.35 %)"),
        ("46.09", 47.208, "m", "differs by +1.1 m (+2.43 %)"),
        ("1.5", 1.6, "", "differs by +0.10 (+6.67 %)"),
    ],
)
def test_a_difference_has_two_digits_and_no_power_of_ten(
    text: str, computed: float, unit: str, reason: str
) -> None:
    assert by_digits(Printed(text), computed, unit).reason == reason
