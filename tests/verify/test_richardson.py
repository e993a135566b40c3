"""Order and extrapolation, on numbers worked out by hand."""

from __future__ import annotations

import math

import pytest

from catopt.verify.comparison import Compared, extrapolated, observed_order


def by(values: tuple[float, ...], **changes: object) -> Compared:
    given = {
        "quantity": "span", "unit": "m", "closed_form": 10.0, "fem": values, "scale": 100.0,
        "tolerance": 1e-4,
    }  # fmt: skip
    return Compared(**{**given, **changes})  # type: ignore[arg-type]


@pytest.mark.parametrize("order", [1.0, 2.0, 4.0])
def test_an_error_c_n_to_minus_p_shows_p_and_its_limit(order: float) -> None:
    values = [10.0 + 3.0 * 2.0 ** (-order * k) for k in range(3)]
    assert observed_order(values, 0.0) == pytest.approx(order, rel=1e-12)
    # Sums of numbers of order 10 in double precision.
    assert extrapolated(values, order) == pytest.approx(10.0, rel=1e-14)


def test_what_is_rounding_has_no_order() -> None:
    assert observed_order([10.0, 10.0, 10.0 + 1e-12], 1e-10) is None
    assert observed_order([10.0, 10.1], 0.0) is None


def test_a_smooth_error_is_extrapolated() -> None:
    each = by((11.6, 10.4, 10.1))
    assert each.order == pytest.approx(2.0, rel=1e-12)
    assert each.is_smooth
    assert each.difference_before == pytest.approx(0.1)
    assert each.difference == pytest.approx(0.0, abs=1e-14)
    assert each.agrees


@pytest.mark.parametrize("values", [(10.4, 10.2, 10.1), (10.1, 10.1, 10.05), (10.0, 10.2, 10.1)])
def test_a_rough_error_is_not(values: tuple[float, ...]) -> None:
    """Orders 1, minus infinity (as far as rounding lets one see) and 1: the finest mesh stands."""
    each = by(values)
    assert not each.is_smooth
    assert each.extrapolated == values[-1]
    assert each.difference == pytest.approx(values[-1] - 10.0)
    assert each.left == pytest.approx(abs(values[-1] - values[-2]))
    assert not each.agrees  # 0.05 or 0.1 of 100 is more than 1e-4


def test_a_rough_order_is_a_number() -> None:
    order = by((10.1, 10.1, 10.05)).order
    assert order is not None
    assert math.isfinite(order)
