"""Natural frequencies against their formulas, with the order in the bar length."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import jn_zeros

from catopt.fem.dynamic_model import MassMatrix
from catopt.fem.linear_model import natural_frequencies
from tests.fem.strings import G, free_body, orders, plain_simulation

LENGTH = 100.0


def _taut(elements: int, mass_matrix: MassMatrix = "consistent") -> tuple[np.ndarray, float]:
    """Frequencies of a weightless string under 1 kN, 1 kg/m; and its lowest by the formula."""
    EA, strain = 1e8, 1e-5
    simulation = plain_simulation(
        ((0.0, 0.0, 50.0), (LENGTH * (1.0 + strain), 0.0, 50.0)), LENGTH, elements, EA=EA,
        mass_matrix=mass_matrix,
    )  # fmt: skip
    # T over the mass per stretched length, over the stretched length.
    speed = math.sqrt(EA * strain * (1.0 + strain))
    return natural_frequencies(simulation, 8), math.pi * speed / (LENGTH * (1.0 + strain))


@pytest.mark.parametrize("mass_matrix", ["consistent", "lumped"])
@pytest.mark.parametrize("mode", [1, 3])
def test_taut_string(mass_matrix: MassMatrix, mode: int) -> None:
    """omega_n = n pi/L sqrt(T/m), twice each; second order in the bar."""
    errors = []
    for elements in (20, 40, 80):
        found, lowest = _taut(elements, mass_matrix)
        pair = found[2 * mode - 2 : 2 * mode]
        # Both directions across alike; the eigenvalue solver's rounding, over the stiffest mode.
        assert pair[0] == pytest.approx(pair[1], rel=1e-6)
        errors.append(pair.mean() / (mode * lowest) - 1.0)
    # The next term of the error is of the fourth order in the bar's part of the wave.
    assert orders(errors) == pytest.approx(2.0, abs=0.02)
    # Linear bars: consistent mass is too high by (k h)^2/24, lumped mass too low by it.
    sign = 1.0 if mass_matrix == "consistent" else -1.0
    assert errors[-1] == pytest.approx(sign * (mode * math.pi / 80) ** 2 / 24.0, rel=0.01)


@pytest.mark.parametrize("mode", [0, 1, 2])
def test_hanging_chain(mode: int) -> None:
    """omega_n = j_n/2 sqrt(g/L), j_n the zeros of J0 (Daniel Bernoulli); both directions."""
    errors = []
    # Stretch (5e-8) and the eigenvalue solver's rounding (1e-6) must stay below the first mode's.
    for elements in (5, 10, 20) if mode == 0 else (20, 40, 80):
        simulation = plain_simulation(
            ((0.0, 0.0, LENGTH), (0.0, 0.0, 0.0)), LENGTH, elements, EA=1e9, weight=G,
            body=free_body(),
        )  # fmt: skip
        simulation.settle()
        found = natural_frequencies(simulation, 6)
        exact = 0.5 * jn_zeros(0, 3)[mode] * math.sqrt(G / LENGTH)
        errors.append(found[2 * mode] / exact - 1.0)
    # At the free end tension goes to 0, where the error's next term is larger than elsewhere.
    assert orders(errors) == pytest.approx(2.0, abs=0.1)


def test_axial_bar() -> None:
    """omega_n = n pi/L sqrt(EA/m) of a bar held at both ends; the order is 2 for either mass."""
    EA = 1e6
    for mass_matrix, sign in (("consistent", 1.0), ("lumped", -1.0)):
        errors = []
        for elements in (10, 20, 40):
            strain = 1e-10  # enough for the bars to be taut
            simulation = plain_simulation(
                ((0.0, 0.0, 50.0), (LENGTH * (1.0 + strain), 0.0, 50.0)), LENGTH, elements, EA=EA,
                pushes=True, mass_matrix=mass_matrix,  # type: ignore[arg-type]
            )  # fmt: skip
            found = natural_frequencies(simulation, 3 * (elements - 1))
            # Those across the bar are 1e-5 of these, and come first.
            lowest = found[2 * (elements - 1)]
            errors.append(lowest / (math.pi / LENGTH * math.sqrt(EA)) - 1.0)
        assert orders(errors) == pytest.approx(2.0, abs=0.02)
        assert errors[-1] == pytest.approx(sign * (math.pi / 40) ** 2 / 24.0, rel=0.01)


def test_sagging_cable() -> None:
    """Irvine and Caughey (1974): tan(x/2) = x/2 - 4/lambda^2 (x/2)^3 in the plane, symmetric."""
    H, mass = 5e4, 10.0
    weight, EA = mass * G, 2e7
    sag = weight * LENGTH**2 / (8.0 * H)
    arc = LENGTH * (1.0 + 8.0 / 3.0 * (sag / LENGTH) ** 2)
    stretched = LENGTH * (1.0 + 8.0 * (sag / LENGTH) ** 2)
    unstretched = arc - H * (1.0 + 16.0 / 3.0 * (sag / LENGTH) ** 2) * LENGTH / EA
    squared = (weight * LENGTH / H) ** 2 * EA / H * LENGTH / stretched
    simulation = plain_simulation(
        ((0.0, 0.0, 50.0), (LENGTH, 0.0, 50.0)), unstretched, 160, EA=EA, mass=mass, weight=weight
    )
    part = np.linspace(0.0, 1.0, 161)
    simulation.state.x[:, 2] -= 4.0 * sag * part * (1.0 - part)
    simulation.settle()
    found = natural_frequencies(simulation, 4)
    unit = math.sqrt(H / mass) / LENGTH

    def symmetric(x: float) -> float:
        return math.tan(0.5 * x) - 0.5 * x + 4.0 / squared * (0.5 * x) ** 3

    in_plane = brentq(symmetric, 1.0001 * math.pi, 2.9 * math.pi)
    # Out of the plane pi, antisymmetric 2 pi; the theory leaves out (sag/span)^2 = 6e-4.
    assert 1.0 * math.pi < in_plane < 1.9 * math.pi
    expected = unit * np.sort([math.pi, 2.0 * math.pi, 2.0 * math.pi, in_plane])
    assert found == pytest.approx(expected, rel=8 * (sag / LENGTH) ** 2)


def test_body_on_a_string() -> None:
    """A heavy body on a light string swings as sqrt(g/L), L with the string's stretch."""
    M, EA = 1e4, 1e8
    simulation = plain_simulation(
        ((0.0, 0.0, LENGTH), (0.0, 0.0, 0.0)), LENGTH, 10, EA=EA, mass=1e-2, body=free_body(M)
    )
    simulation.load.base[0, 2] = -M * G
    simulation.settle()
    found = natural_frequencies(simulation, 2)
    stretched = LENGTH * (1.0 + M * G / EA)
    # The string's mass is 1e-4 of the body's: a third of it swings along, (1/3 - 1/2)/2 in omega
    # for its weight is not there.
    assert found == pytest.approx(math.sqrt(G / stretched), rel=3e-5)
