"""Mean wave drift: hand calculations, limits, and the two means of a wave height."""

from __future__ import annotations

import math

import pytest

from catopt.errors import InputError
from catopt.loads import SeaState
from catopt.loads.ship_loads import depth_factor, flat_side_drift, ship_drift

from . import ROUNDING

RHO, G = 1025.0, 9.80665
SEA = SeaState(8.0, maximum_height=3.7)
"""Hs 2 m."""

DEEP = 5000.0


def drift(**changes: object) -> float:
    arguments: dict[str, object] = {"water_density": RHO, **changes}
    return flat_side_drift(SEA, arguments.pop("depth", DEEP), **arguments)  # type: ignore[arg-type]


def test_of_a_regular_wave_by_hand() -> None:
    """1/2 rho g a^2 with a = 1.85 m: 17201 N/m."""
    by_hand = 0.5 * RHO * G * 1.85**2
    assert by_hand == pytest.approx(17201.0, abs=0.5)  # printed digits
    assert drift(of="largest wave") == pytest.approx(by_hand, rel=ROUNDING)


def test_of_a_sea_by_hand() -> None:
    """The mean is rho g Hs^2/16 = 2513 N/m: 2 x integral of S times 1/2 rho g, m0 being Hs^2/16."""
    assert drift() == pytest.approx(RHO * G * 4.0 / 16.0, rel=ROUNDING)


def test_reflection_counts_squared() -> None:
    assert drift(reflection=0.5) == pytest.approx(0.25 * drift(), rel=ROUNDING)
    assert drift(reflection=0.0) == 0.0


def test_depth_factor_from_1_to_2() -> None:
    assert depth_factor(1.0, 1000.0) == 1.0
    # 2 - (2kh)^2/6 and more for small k h: 1e-8 away.
    assert depth_factor(1e-4, 1.0) == pytest.approx(2.0, abs=1e-8)
    assert depth_factor(1.0, 0.5) == pytest.approx(1.0 + 1.0 / math.sinh(1.0), rel=ROUNDING)


def test_a_breaking_wave_pushes_no_more_than_its_breaking_height() -> None:
    """In 2 m of water a wave is 1.56 m high."""
    by_hand = 0.5 * RHO * G * 0.78**2 * depth_factor(SEA.wave_number(2.0), 2.0)
    assert drift(depth=2.0, of="largest wave") == pytest.approx(by_hand, rel=ROUNDING)


def test_a_ship_shows_its_breadth_and_its_length() -> None:
    def forces(angle: float) -> list[float]:
        parts = ship_drift(SEA, 200.0, 30.0, DEEP, angle=angle, water_density=RHO)
        return [part.force for part in parts]

    per_metre = drift()
    near = 1e-6  # N: sin(pi) is 1e-16
    assert forces(0.0) == pytest.approx([-30.0 * per_metre, 0.0], rel=ROUNDING, abs=near)
    assert forces(math.pi) == pytest.approx([30.0 * per_metre, 0.0], rel=ROUNDING, abs=near)
    assert forces(0.5 * math.pi) == pytest.approx([0.0, 200.0 * per_metre], rel=ROUNDING, abs=near)
    assert forces(-0.5 * math.pi) == pytest.approx(
        [0.0, -200.0 * per_metre], rel=ROUNDING, abs=near
    )


def test_off_the_bow_a_box_shows_both_and_is_pushed_along_the_waves() -> None:
    """30 deg: 200 x 0.5 + 30 x 0.866025 = 125.980762 m, cos 30 of it aft and half of it aside."""
    along, across = ship_drift(SEA, 200.0, 30.0, DEEP, angle=math.radians(30.0), water_density=RHO)
    whole = RHO * G * 4.0 / 16.0 * 125.980762
    assert along.force == pytest.approx(-whole * math.sqrt(0.75), rel=1e-8)  # printed digits
    assert across.force == pytest.approx(0.5 * whole, rel=1e-8)


def test_the_numbers_of_a_drift_give_its_force_again() -> None:
    """Rho g R^2 m D W is the whole force; head on it is all along the ship."""
    part, _ = ship_drift(SEA, 200.0, 30.0, 10.0, angle=0.0, reflection=0.6, water_density=RHO)
    of = {number.symbol: number.value for number in part.numbers}
    again = of["rho"] * G * of["R"] ** 2 * of["m"] * of["D"] * of["W"]
    assert part.force == pytest.approx(-again, rel=ROUNDING)
    assert part.formula == "rho g R^2 m D W"


def test_what_is_out_of_range() -> None:
    with pytest.raises(InputError, match="reflection"):
        drift(reflection=1.5)
    with pytest.raises(InputError, match="one of sea state, largest wave"):
        drift(of="mean")
