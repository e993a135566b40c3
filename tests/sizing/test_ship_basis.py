"""What the note says of a ship's runs is enough to follow them by hand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from catopt.casefile import parse_case
from catopt.loads.environment import npd_spectrum
from catopt.sizing.ship_band import basis_of
from catopt.words import Message
from tests.sizing.test_ship_ranges import RIVER


def values(key: str) -> dict[str, Any]:
    """Take the numbers of one sentence of the basis."""
    every = [each for each in basis_of(parse_case(RIVER)) if isinstance(each, Message)]
    (found,) = (each for each in every if each.key == f"floater.{key}")
    return dict(found.values)


def test_the_numbers_are_those_of_a_hand() -> None:
    """Mass by the block coefficient, Clarke's added mass, and what damps by mass and stiffness."""
    mass = values("basis_mass")
    L, B, T = 0.97 * 210.0, 32.2, 12.6
    own = 1025.0 * 0.8 * L * B * T / 1e3
    assert mass["mass"] == pytest.approx(own)
    assert mass["surge"] == pytest.approx(0.1 * own)
    part = 1.0 + 0.16 * 0.8 * B / T - 5.1 * (B / L) ** 2
    assert mass["sway"] == pytest.approx(0.5 * 1025.0 * math.pi * T**2 * L * part / 1e3)
    stiff, damping = values("basis_stiffness"), values("basis_damping")
    moved = 1.1 * own
    assert damping["surge"] == pytest.approx(2.0 * 0.05 * math.sqrt(stiff["surge"] * moved))
    assert damping["period"] == pytest.approx(2.0 * math.pi * math.sqrt(moved / stiff["surge"]))
    assert values("basis_mean")["speed"] == pytest.approx(12.7)


def test_the_spectrum_that_is_written_out_is_the_one_that_is_drawn() -> None:
    """320 (U/10)^2/(1 + x^0.468)^3.561 at 0.01 Hz and 20 m/s, by hand."""
    x = 172.0 * 0.01 * 2.0**-0.75
    wanted = 320.0 * 4.0 / (1.0 + x**0.468) ** 3.561
    assert float(npd_spectrum(np.array([0.01]), 20.0)[0]) == pytest.approx(wanted, rel=1e-3)
