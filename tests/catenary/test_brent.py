"""Brent's method, beside scipy's own."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from scipy.optimize import brentq

from catopt.catenary.roots import root
from catopt.errors import NotConvergedError

FUNCTIONS: dict[str, tuple[Callable[[float], float], float, float]] = {
    "cubic": (lambda x: x**3 - 2.0 * x - 5.0, 2.0, 3.0),
    "level far off": (lambda x: math.atan(20.0 * (x - 1.0)), 0.0, 50.0),
    "steep": (lambda x: math.expm1(50.0 * (x - 0.3)), -1.0, 1.0),
    "kink": (lambda x: min(x - 0.7, 100.0 * (x - 0.7)), -3.0, 10.0),
    "falling": (lambda x: math.cos(x) - x, 2.0, 0.0),
    "at an end": (lambda x: x - 3.0, 1.0, 3.0),
}


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("tolerance", [1e-6, 4.0 * 2.0**-52])
def test_the_digits_of_scipy(name: str, tolerance: float) -> None:
    function, low, high = FUNCTIONS[name]
    expected = brentq(function, low, high, xtol=tolerance, rtol=4.0 * 2.0**-52)
    assert root(function, low, high, xtol=tolerance, rtol=4.0 * 2.0**-52) == expected


def test_the_start_may_be_the_root() -> None:
    assert root(lambda x: x - 1.0, 1.0, 3.0, xtol=1e-9, rtol=1e-9) == 1.0


def test_what_is_no_function_is_refused() -> None:
    with pytest.raises(NotConvergedError, match="no root within"):
        root(lambda x: math.nan if x > 0.0 else -1.0, -1.0, 1.0, xtol=0.0, rtol=0.0)
