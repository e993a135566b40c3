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
from catopt.loads.ship_coefficients import pressure_centre
from catopt.loads.ship_loads import AIR_DENSITY
from catopt.loads.tanker_20m import CURRENT, SEA, WATER_DEPTH, WIND, tanker
from catopt.loads.ufc import transverse_coefficient
from catopt.loads.weathervane import ShipStreams

from . import ROUNDING

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


@pytest.mark.parametrize("degrees", [0.0, 40.0, -135.0, 179.5, 179.9, -179.9])
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


def wave_number() -> float:
    """Of 8 s in 20 m, 1/m: omega^2 = g k tanh(k d), by turns."""
    k = 0.07
    for _ in range(200):
        k = (2.0 * math.pi / 8.0) ** 2 / 9.80665 / math.tanh(k * 20.0)
    return k


WAVE_NUMBER = wave_number()


def moment(heading: float, directions: Headings, lever: float) -> float:
    """Moment about the mooring point of S3's tanker, N m, from the formulas of docs/loads.md.

    Sum of Y (e - x): wind by Blendermann's "tanker loaded" (CDt 0.70, CDl 0.90 and 0.55, delta
    0.40) and CN, current by UFC with series 60 (-0.291, 0.00353), the drift of the box amidships.
    """
    length, breadth, draught = 234.0, 31.3, 12.4
    waterline = 0.97 * length
    frontal, lateral = breadth * (3.6 + 15.0), length * 3.6 + 15.0 * 25.0
    house = -375.0 * 0.5 * (length - 25.0) / lateral
    wind, current, waves = (
        math.atan2(math.sin(each - heading), math.cos(each - heading))
        for each in (directions.wind, directions.current, directions.waves)
    )
    along = 0.90 if abs(wind) < 0.5 * math.pi else 0.55
    D = 1.0 - 0.2 * (1.0 - along * frontal / (0.70 * lateral)) * math.sin(2.0 * wind) ** 2
    of_wind = 0.5 * 1.221 * 20.0**2 * lateral * 0.70 * math.sin(wind) / D
    of_wind *= house - 0.18 * (abs(wind) - 0.5 * math.pi) * length - lever
    chi = waterline**2 * 0.98 * breadth * draught / (breadth * 0.8 * waterline * breadth * draught)
    deep = 0.22 * math.sqrt(chi)
    across = deep + (3.2 - deep) * (draught / 20.0) ** 2
    of_current = 0.5 * 1025.0 * 1.2**2 * waterline * draught * across * math.sin(current)
    theta = 180.0 - abs(math.degrees(current))
    of_current *= (-0.291 + 0.00353 * theta) * waterline - lever
    k = WAVE_NUMBER
    per_metre = 1025.0 * 9.80665 * (3.5 / 1.85) ** 2 / 16.0
    per_metre *= 1.0 + 40.0 * k / math.sinh(40.0 * k)
    width = waterline * abs(math.sin(waves)) + breadth * abs(math.cos(waves))
    return of_wind + of_current - per_metre * width * math.sin(waves) * lever


@pytest.mark.parametrize("point", [None, 60.0])
@pytest.mark.parametrize(
    "directions", [Headings(0.0, 1.0, 0.2), Headings(0.3, -2.0, -0.4), Headings(-1.0, 1.2, 2.8)]
)
def test_at_every_heading_the_moments_written_out_here_cancel(
    directions: Headings, point: float | None
) -> None:
    """Moments are of the size of 1e8 N m; the heading is halved to double precision."""
    lever = 0.5 * 0.97 * 234.0 if point is None else point
    turning = Turning(YAW_TYPES["series-60"], point)
    found = headings(tanker(), WIND, CURRENT, SEA, directions, turning)
    assert found
    for each in found:
        assert moment(each, directions, lever) == pytest.approx(0.0, abs=1.0)
        # a small turn is turned back: the moment rises through zero
        assert moment(each - 0.01, directions, lever) < 0.0 < moment(each + 0.01, directions, lever)
    # and nowhere else: each other fall through zero lies between two of these
    samples = [moment(-math.pi + (k + 0.5) * math.tau / 720, directions, lever) for k in range(720)]
    rises = sum(a < 0.0 <= b for a, b in zip(samples, samples[1:] + samples[:1], strict=True))
    assert rises == len(found)


def test_the_bow_is_the_mooring_point_unless_another_is_given() -> None:
    turning = Turning(AMIDSHIPS)
    assert turning.lever(tanker()) == pytest.approx(0.5 * 0.97 * 234.0, rel=ROUNDING)
    assert Turning(AMIDSHIPS, -3.0).lever(tanker()) == -3.0
    assert BOX.lateral_centre == 0.0
    assert not AMIDSHIPS.recalled


def test_without_turning_the_directions_are_angles_from_the_bow() -> None:
    """At both depths; the current on the beam is the stronger in the shallower water."""
    beam = Headings(current=0.5 * math.pi)
    found = every_lying(
        [Afloat("", BOX, "tanker loaded")],
        STILL,
        SurfaceCurrent(1.0),
        CALM,
        [20.0, 10.0],
        [beam],
        methods=["UFC-Blendermann"],
    )
    assert [(each.heading, each.depth, each.headings) for each in found] == [
        (0.0, 20.0, beam),
        (0.0, 10.0, beam),
    ]
    # chi = 100^2 x 98/(20 x 7000) = 7; Cyc = 0.582065 + 2.617935 (5/d)^2: 0.745686 and 1.236549
    across = [each.loads.along("sway") for each in found]
    by_hand = [512.5 * 500.0 * 0.745686, 512.5 * 500.0 * 1.236549]
    assert across == pytest.approx(by_hand, rel=1e-6)  # printed digits
    assert all("yaw moments are not balanced" in each.loads.assumptions[0] for each in found)


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
    with pytest.raises(InputError, match="a load on"):
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


def test_streams_along_a_ship_without_tables_of_her_own() -> None:
    """By hand 1/2 rho A_F CX V^2 with Blendermann's 0.90 ahead, 0.55 astern; none abeam."""
    ship = tanker()
    streams = ShipStreams(ship, WATER_DEPTH, 1025.0, "tanker loaded")
    whole = 0.5 * AIR_DENSITY * ship.frontal_area * 20.0**2
    ahead, abeam, astern = (
        streams.wind_along(20.0, angle) for angle in (0.0, 0.5 * math.pi, math.pi)
    )
    assert ahead == pytest.approx(-0.90 * whole, rel=ROUNDING)
    assert abeam == pytest.approx(0.0, abs=1e-9 * whole)
    assert astern == pytest.approx(0.55 * whole, rel=ROUNDING)
    assert streams.current_along(1.0, 0.0) < 0.0 < streams.current_along(1.0, math.pi)
