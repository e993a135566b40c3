"""omega² = g k tanh(k d): residual, limits, and figures of others."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.compiled import compiled
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError
from catopt.waves import wave_number, wavelength
from catopt.waves.random_surface import fill_wave_numbers

g = STANDARD_GRAVITY
DEPTH = 56.0


def omegas(count: int) -> np.ndarray:
    """Frequencies from omega² d/g = 1e-12 to 1e4: from far too shallow to far too deep."""
    return np.sqrt(np.geomspace(1e-12, 1e4, count) * g / DEPTH)


def test_residual_is_rounding() -> None:
    """A dozen operations, each right to 1.1e-16: 1e-14 leaves them room."""
    worst = 0.0
    for omega in omegas(5000):
        k = wave_number(float(omega), DEPTH)
        worst = max(worst, abs(g * k * math.tanh(k * DEPTH) / omega**2 - 1.0))
    assert worst < 1e-14


def test_deep_and_shallow_limits() -> None:
    """Deep: k = omega²/g. Shallow: omega = k sqrt(g d)(1 - (k d)²/6 + ...)."""
    assert wave_number(3.0, 1000.0) == pytest.approx(9.0 / g, rel=1e-15)
    omega = 1e-3
    shallow = omega / math.sqrt(g * 10.0)
    assert wave_number(omega, 10.0) == pytest.approx(shallow, rel=(shallow * 10.0) ** 2 / 5.0)
    assert wave_number(omega, 10.0) > shallow


def test_no_step_where_the_deep_branch_begins() -> None:
    """Neighbouring frequencies 2e-9 apart give wave numbers 4e-9 apart, not more."""
    edge = math.sqrt(20.0 * g / DEPTH)
    below, above = (wave_number(edge * (1.0 + s * 1e-9), DEPTH) for s in (-1, 1))
    assert above / below - 1.0 == pytest.approx(4e-9, rel=1e-6)


def test_deepest_and_highest_do_not_overflow() -> None:
    assert wave_number(1e6, 1e5) == pytest.approx(1e12 / g, rel=1e-15)
    assert wave_number(1e-9, 1e-3) == pytest.approx(1e-9 / math.sqrt(g * 1e-3), rel=1e-12)


def test_wavelength_printed_in_s4() -> None:
    """153.02 m for T = 10 s and d = 56 m comes with g = 9.81; five digits are printed.

    A period longer by sqrt(9.81/g0) is under g0 what 10 s is under 9.81.
    """
    assert f"{wavelength(10.0 * math.sqrt(9.81 / g), DEPTH):.2f}" == "153.02"
    assert f"{wavelength(10.0, DEPTH):.2f}" == "152.97"


def test_compiled_equals_plain() -> None:
    """The same operations; a compiler may round the power and the tangent differently."""
    omega = omegas(200)
    fast = np.empty_like(omega)
    compiled(fill_wave_numbers)(omega, DEPTH, fast)
    plain = [wave_number(float(each), DEPTH) for each in omega]
    np.testing.assert_allclose(fast, plain, rtol=1e-15)


def test_wrong_input_is_named_all_at_once() -> None:
    with pytest.raises(InputError) as caught:
        wavelength(-1.0, 0.0)
    assert [p.key for p in caught.value.problems] == ["period", "depth"]
