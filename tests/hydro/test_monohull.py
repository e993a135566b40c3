"""Closed forms of a monohull's motions: by hand, long waves, and integrals over the hull."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad

from catopt.errors import InputError
from catopt.hydro.coefficients import Coefficients
from catopt.hydro.hull import monohull_response

HULL = {"length": 180.0, "breadth": 30.0, "draught": 12.0, "block": 0.8}
DEEP = 50_000.0
G = 9.80665


def test_heave_and_pitch_by_hand() -> None:
    """Jensen et al. (2004) in a head sea of 11 s, the formulas written out anew."""
    omega = 2.0 * math.pi / 11.0
    k, B, T, L = omega**2 / G, 24.0, 12.0, 180.0
    A = 2.0 * math.sin(omega**2 * B / (2.0 * G)) * math.exp(-(omega**2) * T / G)
    f = math.sqrt((1.0 - k * T) ** 2 + (A**2 / (k * B)) ** 2)
    eta = 1.0 / math.sqrt((1.0 - 2.0 * k * T) ** 2 + (A**2 / (k * B)) ** 2)
    F = math.exp(-k * T) * f * 2.0 / (k * L) * math.sin(0.5 * k * L)
    G5 = math.exp(-k * T) * f * 24.0 / ((k * L) ** 2 * L)
    G5 *= math.sin(0.5 * k * L) - 0.5 * k * L * math.cos(0.5 * k * L)
    found = monohull_response(np.array([omega]), np.array([math.pi]), DEEP, **HULL)[0, 0]
    assert abs(found[2]) == pytest.approx(abs(eta * F), rel=1e-6)
    assert abs(found[4]) == pytest.approx(abs(eta * G5), rel=1e-6)


def test_long_waves_carry_the_ship() -> None:
    """It goes where the surface goes, and lies in its slope; signs by a head and a beam sea."""
    omega = np.array([0.05])
    headings = np.array([0.0, 0.5 * math.pi, math.pi, 0.6])
    found = monohull_response(omega, headings, DEEP, **HULL, roll_period=6.0)[0]
    k = omega[0] ** 2 / G
    assert found[:, 2] == pytest.approx(1.0, abs=0.02)
    for heading, row in zip(headings.tolist(), found, strict=True):
        assert row[0] == pytest.approx(1j * math.cos(heading), abs=0.02)
        assert row[1] == pytest.approx(1j * math.sin(heading), abs=0.02)
        # Bow down is positive: the slope along x has the other sign; port up is positive.
        assert row[4] == pytest.approx(-1j * k * math.cos(heading), abs=0.02 * k)
        assert row[3] == pytest.approx(1j * k * math.sin(heading), abs=0.02 * k)
        both = math.sin(heading) * math.cos(heading)
        assert row[5] == pytest.approx(-k * both, abs=0.02 * k)


def test_the_waters_way_in_the_hulls_place() -> None:
    """Surge, sway and yaw in 40 m of water beside quadrature of the water's own displacement."""
    depth, period, heading = 40.0, 9.0, 2.2
    omega = 2.0 * math.pi / period
    k = omega**2 / G
    for _ in range(200):
        k = omega**2 / (G * math.tanh(k * depth))
    c, s = math.cos(heading), math.sin(heading)
    L, B, T = 180.0, 30.0, 12.0
    level = quad(lambda z: math.cosh(k * (z + depth)) / math.sinh(k * depth), -T, 0.0)[0] / T
    aside = quad(lambda y: math.cos(k * s * y), -B / 2, B / 2)[0] / B
    mean = quad(lambda x: math.cos(k * c * x), -L / 2, L / 2)[0] / L
    moment = quad(lambda x: -x * math.sin(k * c * x), -L / 2, L / 2, epsabs=1e-6)[0] / (L**3 / 12)
    found = monohull_response(np.array([omega]), np.array([heading]), depth, **HULL)[0, 0]
    assert found[0] == pytest.approx(1j * level * aside * mean * c, abs=1e-9)
    assert found[1] == pytest.approx(1j * level * aside * mean * s, abs=1e-9)
    assert found[5] == pytest.approx(level * aside * moment * s, abs=1e-10)


def test_roll_at_resonance() -> None:
    """Half the slope over the damping ratio, a quarter period later than the slope."""
    omega = np.array([2.0 * math.pi / 14.0])
    found = monohull_response(
        omega, np.array([0.5 * math.pi]), DEEP, **HULL, roll_period=14.0, roll_damping=0.1
    )[0, 0, 3]
    k = float(omega[0]) ** 2 / G
    slope = k * math.exp(-0.5 * k * 12.0) * math.sin(0.5 * k * 30.0) / (0.5 * k * 30.0)
    assert found == pytest.approx(1j * slope / (-0.2j), rel=1e-6)


def test_refused() -> None:
    with pytest.raises(InputError) as error:
        monohull_response(np.ones(1), np.zeros(1), 10.0, **HULL | {"block": 1.2, "length": 0.0})
    assert [each.key for each in error.value.problems] == ["length", "depth", "block"]


def table() -> Coefficients:
    response = np.zeros((2, 3, 6), dtype=complex)
    response[0, :, 2] = [1.0, 2.0j, 3.0]
    response[1, :, 2] = [3.0, 4.0j, 5.0]
    return Coefficients(np.array([0.5, 1.5]), np.array([0.0, 1.0, 2.0]), response=response)


def test_between_rows_of_a_table() -> None:
    found = table().at("response", np.array([0.5, 1.0, 9.0]), np.array([0.5, 2.0, 1.0 + math.tau]))
    assert found[:, 2] == pytest.approx([0.5 + 1.0j, 4.0, 4.0j])


def test_beyond_a_table() -> None:
    with pytest.raises(InputError, match="heading"):
        table().at("response", np.array([1.0]), np.array([3.0]))
    with pytest.raises(InputError, match="mean_drift"):
        table().at("mean_drift", np.array([1.0]), np.array([1.0]))
