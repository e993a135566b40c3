"""The heading of a ship on one point: moments written out here, directions, draughts."""

from __future__ import annotations

import math
from typing import Any

import pytest

from catopt.errors import InputError, NoAnswerError
from catopt.loads import (
    YAW_TYPES,
    Afloat,
    CurrentYaw,
    Headings,
    SeaState,
    Ship,
    SurfaceCurrent,
    Turning,
    Wind,
    equilibrium_headings,
    every_lying,
)
from catopt.loads.blendermann import pressure_centre
from catopt.loads.tanker_20m import CURRENT, SEA, WATER_DEPTH, WIND, tanker
from catopt.loads.ufc_current import transverse_coefficient

ROUNDING = 1e-12
"""Relative, of some ten operations in double precision."""

BOX = Ship("box", 100.0, 100.0, 20.0, 5.0, 7000.0, 98.0, 800.0, 300.0)
AMIDSHIPS = CurrentYaw(0.0, 0.0)
STILL, SLACK, CALM = Wind(0.0), SurfaceCurrent(0.0), SeaState(5.0, 0.0)
SERIES_60 = Turning(YAW_TYPES["series-60"])


def headings(
    ship: Ship = BOX,
    wind: Wind = STILL,
    current: SurfaceCurrent = SLACK,
    sea: SeaState = CALM,
    directions: Headings | None = None,
    turning: Turning | None = None,
) -> tuple[float, ...]:
    return equilibrium_headings(
        ship,
        wind,
        current,
        sea,
        20.0,
        directions or Headings(),
        turning or Turning(AMIDSHIPS),
        wind_on="tanker loaded",
    )


@pytest.mark.parametrize(
    ("depth_over_draught", "coefficient"),
    [(1.1, 2.79), (1.2, 2.48), (1.5, 1.89), (2.0, 1.44), (3.0, 1.11)],
)
def test_the_current_across_in_shallow_water(depth_over_draught: float, coefficient: float) -> None:
    """0.85 + (3.2 - 0.85) (T/d)^2: at d/T 2 0.85 + 2.35/4 = 1.4375, 1.69 times deep water's."""
    found = transverse_coefficient(1.0 / depth_over_draught, 0.85)
    assert found == pytest.approx(coefficient, abs=0.005)  # printed digits


def test_where_the_wind_acts() -> None:
    """On 200 m: 0.18 x 200 x pi/2 = 56.55 m forward of the centre ahead, at it abeam, and aft."""
    assert pressure_centre(0.0, 200.0, -10.0) == pytest.approx(46.5487, abs=5e-5)
    assert pressure_centre(0.5 * math.pi, 200.0, -10.0) == pytest.approx(-10.0, rel=ROUNDING)
    assert pressure_centre(-math.pi, 200.0, -10.0) == pytest.approx(-66.5487, abs=5e-5)


@pytest.mark.parametrize("degrees", [0.0, 40.0, -135.0])
def test_one_cause_alone_is_met_head_on(degrees: float) -> None:
    angle = math.radians(degrees)
    sea = SeaState(5.0, 2.0)
    for found in (
        headings(wind=Wind(20.0), directions=Headings(wind=angle)),
        headings(current=SurfaceCurrent(1.0), directions=Headings(current=angle)),
        headings(sea=sea, directions=Headings(waves=angle)),
    ):
        # Halved to double precision.
        assert found == pytest.approx([angle], abs=1e-12)


def test_current_and_waves_at_a_right_angle_by_hand() -> None:
    """Waves from 0, current from 90 deg; both act amidships, so their forces across cancel.

    At a heading of 30 deg: current C cos 30 = drift D (L sin 30 + B cos 30) sin 30 per metre D:
    C = D (100 x 0.25 + 20 x 0.43301)/0.86603 = 38.8675 D.
    D = 1025 g Hs^2/16 (1 + 2kd/sinh 2kd); T 5 s in 20 m: k tanh(20 k) = 0.161029, k = 0.161535,
    2kd = 6.4614, factor 1 + 6.4614/319.98 = 1.020193; Hs = 2 m: 2512.954 x 1.020193 = 2563.70 N/m.
    C = 99644.6 N = 512.5 V^2 x 500 x Cyc; chi = 100^2 x 98/(20 x 7000) = 7, C0 = 0.22 x 2.645751 =
    0.582065, Cyc = 0.582065 + 2.617935/16 = 0.745686; V = sqrt(99644.6/191082.0) = 0.722138 m/s.
    """
    found = headings(
        current=SurfaceCurrent(0.722138),
        sea=SeaState(5.0, 2.0),
        directions=Headings(current=0.5 * math.pi),
    )
    assert [math.degrees(each) for each in found] == pytest.approx([30.0], abs=0.002)  # 6 digits


def test_it_is_symmetrical_and_turns_with_everything() -> None:
    case: dict[str, Any] = {"ship": tanker(), "wind": WIND, "current": CURRENT, "sea": SEA}
    (one,) = headings(**case, directions=Headings(0.0, 1.0, 0.2), turning=SERIES_60)
    (mirrored,) = headings(**case, directions=Headings(0.0, -1.0, -0.2), turning=SERIES_60)
    (turned,) = headings(**case, directions=Headings(0.7, 1.7, 0.9), turning=SERIES_60)
    assert mirrored == pytest.approx(-one, abs=1e-12)
    assert turned == pytest.approx(one + 0.7, abs=1e-12)


def test_a_heading_is_stable_about_it_and_not_where_it_lies_stern_to() -> None:
    """A current on a ship held at the stern: the bow points away from it."""
    held = Turning(AMIDSHIPS, -50.0)
    (found,) = headings(current=SurfaceCurrent(1.0), turning=held)
    assert abs(found) == pytest.approx(math.pi, abs=1e-12)


def test_held_amidships_it_lies_across_or_not_at_all() -> None:
    """By series 60 ec is zero at 0.291/0.00353 = 82.4363 deg, which is 97.5637 deg off the bow."""
    held = Turning(YAW_TYPES["series-60"], 0.0)
    found = headings(current=SurfaceCurrent(1.0), turning=held)
    degrees = [math.degrees(each) for each in found]
    assert degrees == pytest.approx([-97.5637, 97.5637], abs=5e-5)
    with pytest.raises(NoAnswerError, match="no stable heading"):
        headings(sea=SeaState(5.0, 2.0), turning=Turning(AMIDSHIPS, 0.0))


def test_what_is_wrong() -> None:
    with pytest.raises(InputError, match="something has to push"):
        headings()
    with pytest.raises(InputError, match="mooring_point"):
        headings(current=SurfaceCurrent(1.0), turning=Turning(AMIDSHIPS, 51.0))


def test_every_direction_and_draught_counts() -> None:
    """Of S3's tanker the ballast draught governs head on, the loaded one across."""
    ships = [Afloat(each, tanker(each), f"tanker {each}") for each in ("loaded", "ballast")]
    both = [Headings(), Headings(current=math.radians(60.0))]
    found = every_lying(
        ships,
        WIND,
        CURRENT,
        SEA,
        [WATER_DEPTH],
        both,
        methods=["UFC-Blendermann"],
        turning=SERIES_60,
    )
    assert [each.afloat.condition for each in found] == ["loaded", "loaded", "ballast", "ballast"]
    forces = [each.loads.horizontal_force / 1e3 for each in found]
    assert forces[0] == pytest.approx(288.0, abs=0.05)  # by hand in test_ship_loads.py
    assert forces[2] > forces[0]
    assert forces[1] > forces[3] > forces[2]
    assert "Weathervaning: at this heading" in found[1].loads.assumptions[0]
    assert "Collinear" in found[0].loads.assumptions[0]


def test_the_house_at_the_stern_draws_the_windage_aft() -> None:
    """S3's: -15 x 25 x (234 - 25)/2 over 234 x 3.6 + 375 = 1217.4 m2: -32.19 m."""
    assert tanker().lateral_centre == pytest.approx(-32.19, abs=0.005)
