"""Wind, current, waves and levels: limits, and hand calculations."""

from __future__ import annotations

import math

import pytest

from catopt.errors import InputError
from catopt.loads import SeaState, SurfaceCurrent, WaterLevels, Wind

from . import ROUNDING


def test_hmax_is_1_85_hs_and_back() -> None:
    assert SeaState(8.0, significant_height=2.0).hmax == pytest.approx(3.7, rel=ROUNDING)
    assert SeaState(8.0, maximum_height=3.7).hs == pytest.approx(2.0, rel=ROUNDING)


def test_given_heights_are_kept() -> None:
    sea = SeaState(8.0, 2.0, 3.5)
    assert (sea.hs, sea.hmax) == (2.0, 3.5)


@pytest.mark.parametrize(
    ("period", "depth", "limit"),
    [
        (4.0, 50.0, 0.14 * 1.56 * 16.0),  # steepness: 3.494 m, depth: 39 m
        (12.0, 5.0, 0.78 * 5.0),  # depth: 3.9 m, steepness: 31.4 m
    ],
)
def test_breaking_is_the_lower_of_steepness_and_depth(
    period: float, depth: float, limit: float
) -> None:
    sea = SeaState(period, maximum_height=10.0)
    assert sea.breaking_height(depth) == pytest.approx(limit, rel=ROUNDING)
    assert sea.height_in(depth) == pytest.approx(limit, rel=ROUNDING)
    low = SeaState(period, maximum_height=0.5 * limit)
    assert low.height_in(depth) == pytest.approx(0.5 * limit, rel=ROUNDING)


def test_surface_velocity_in_deep_water() -> None:
    """In deep water tanh(k d) = 1: u = pi H/T = pi x 4/8 = 1.5708 m/s."""
    sea = SeaState(8.0, maximum_height=4.0)
    assert sea.surface_velocity(5000.0) == pytest.approx(math.pi / 2.0, rel=ROUNDING)


def test_surface_velocity_in_shallow_water() -> None:
    """In shallow water u = (H/2) sqrt(g/d), to the order (k d)^2/3.

    T = 30 s in 2 m: omega = 0.20944, k = omega/sqrt(g d) = 0.0473, (k d)^2/3 = 0.003.
    """
    sea = SeaState(30.0, maximum_height=0.1)
    shallow = 0.05 * math.sqrt(9.80665 / 2.0)
    assert sea.surface_velocity(2.0) == pytest.approx(shallow, rel=0.003)


def test_surface_velocity_between_satisfies_dispersion() -> None:
    """The speed is (pi H/T)/tanh(k d) with g k tanh(k d) = omega^2, solved here by bisection."""
    sea = SeaState(6.0, maximum_height=3.7)
    omega = 2.0 * math.pi / 6.0
    low, high = 1e-6, 10.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if 9.80665 * middle * math.tanh(middle * 12.0) < omega**2:
            low = middle
        else:
            high = middle
    by_hand = math.pi * 3.7 / 6.0 / math.tanh(low * 12.0)
    # Both roots are good to double precision, some ten operations follow.
    assert sea.surface_velocity(12.0) == pytest.approx(by_hand, rel=1e-12)


def test_no_waves_no_velocity() -> None:
    assert SeaState(8.0, 0.0).surface_velocity(10.0) == 0.0


def test_wind_at_height() -> None:
    """20 m/s at 10 m is 20 x 2^0.12 = 21.7347 m/s at 20 m."""
    assert Wind(20.0).at(20.0) == pytest.approx(21.7347, abs=5e-5)  # printed digits
    assert Wind(20.0).at(10.0) == 20.0


def test_depth_under_the_crest() -> None:
    levels = WaterLevels(8.0, 12.0)
    assert levels.deepest(SeaState(8.0, maximum_height=3.0)) == pytest.approx(13.5, rel=ROUNDING)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Wind(200.0), "more than any design wind: km/h or knots intended"),
        (lambda: Wind(-1.0), "speed: found -1.0; must be 0 m/s or more"),
        (lambda: Wind(20.0, 0.0), "height"),
        (lambda: SurfaceCurrent(25.0), "faster than any tide"),
        (lambda: SeaState(8.0), "it or maximum_height is required"),
        (lambda: SeaState(0.0, 1.0), "period"),
        (lambda: SeaState(8.0, 2.0, 1.0), "below the significant height of 2 m"),
        (lambda: SeaState(8.0, 50.0), "must be 40 m or less"),
        (lambda: WaterLevels(12.0, 8.0), "below low water"),
        (lambda: WaterLevels(0.0, 8.0), "low"),
    ],
)
def test_what_cannot_be_is_refused(make: object, words: str) -> None:
    assert callable(make)
    with pytest.raises(InputError, match=words):
        make()


def test_every_problem_is_reported_at_once() -> None:
    with pytest.raises(InputError) as caught:
        SeaState(-1.0, -1.0, -1.0)
    assert len(caught.value.problems) == 3
