"""CALMAR's test buoy: every printed digit, beside a calculation written out here."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import pytest

from catopt.reproduce import reproduce
from catopt.reproduce.calmar import buoy_of, moored, releases
from catopt.reproduce.items import published

G = 9.80665
RHO = 1025.0
FLOAT = ((0.7, 0.4, 0.4, 0.6), (1.1, 0.3, 0.6, 0.6), (1.4, 0.6, 0.6, 0.4))
"""Foot above the pole's foot, height, lower and upper diameter, m."""


def solid(level: float) -> float:
    """Volume below a level above the pole's foot, m3: the pole fills the float's hole."""
    total = math.pi / 4.0 * 0.15**2 * min(level, 0.7)
    for foot, height, low, up in FLOAT:
        h = min(max(level - foot, 0.0), height)
        d = low + (up - low) * h / height
        total += math.pi / 12.0 * h * (low * low + low * d + d * d)
    return total


def seen(low: float, high: float) -> float:
    """Area between two levels, m2, of float and pole, both counted: trapezia by slice."""
    area = 0.15 * (high - low)
    for foot, height, lower, upper in FLOAT:
        start, end = (min(max(level - foot, 0.0), height) for level in (low, high))
        slope = (upper - lower) / height
        area += (end - start) * (lower + 0.5 * slope * (start + end))
    return area


@dataclass(frozen=True)
class ByHand:
    """The buoy in equilibrium by bisection and the formulas of a tangent catenary."""

    draught: float
    force: float
    length: float
    radius: float
    tension: float


def by_hand(tide: float, steel: float) -> ByHand:
    weight = 3.7 * G * (1.0 - RHO / steel)
    pull = 0.0
    for _ in range(30):
        volume = (178.9 + pull / G) / RHO - 50.0 / 7320.0
        low, high = 0.0, 2.0
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if solid(middle) < volume else (low, middle)
        draught = low
        hull = 0.5 * RHO * 1.2 * seen(0.0, draught) * (tide + 0.165 + math.pi * 0.09) ** 2
        air = 0.5 * 1.29 * 1.2 * seen(draught, 2.0) * 121.0
        height = 7.0 - draught + 0.05
        force = hull + air + 0.5 * RHO * 1.2 * 2.65 * 0.014 * height * tide**2
        length = height * math.sqrt(1.0 + 2.0 * force / (weight * height))
        pull = weight * length
    a = force / weight
    return ByHand(draught, force, length, a * math.asinh(length / a), force + weight * height)


def test_every_printed_digit_of_both_releases() -> None:
    (study,) = reproduce("calmar").studies
    assert [item.verdict for item in study.items] == ["reproduces"] * 28


@pytest.mark.parametrize(("index", "tide", "steel"), [(0, 0.50, 7850.0), (1, 0.51, 7320.0)])
def test_the_equilibrium_by_hand(index: int, tide: float, steel: float) -> None:
    """The study stops where the pull changes by 1e-10; all else is of double precision."""
    source = published("calmar")
    of, hand = moored(source, releases(source)[index]), by_hand(tide, steel)
    assert of.floating.keel_depth == pytest.approx(hand.draught, rel=1e-9)
    assert of.horizontal_force == pytest.approx(hand.force, rel=1e-9)
    assert of.length == pytest.approx(hand.length, rel=1e-9)
    assert of.radius == pytest.approx(hand.radius, rel=1e-9)
    assert of.tension == pytest.approx(hand.tension, rel=1e-9)
    assert of.factor == pytest.approx(4890.0 * G / hand.tension, rel=1e-9)
    # 45 deg of friction, a factor of 1.5 and concrete of 2400 kg/m3.
    sinker = 1.5 * hand.force / G / (1.0 - RHO / 2400.0)
    assert of.sinker == pytest.approx(sinker, rel=1e-9)


def test_other_readings_miss_the_print() -> None:
    """The newer release prints 13.5 m and 78.5; these are beside it by more than a digit."""
    source = published("calmar")
    newer = releases(source)[0]
    for how in (
        {"wave_height": "hmax"},
        {"chain_waves": True},
        {"wave_height": "hmax", "chain_waves": True},
    ):
        of = moored(source, newer, **how)
        assert not (13.45 <= of.length < 13.55 and 78.45 <= of.factor < 78.55)
    iron = replace(buoy_of(source), ballast_density=1e4)
    assert not 78.45 <= moored(source, newer, iron).factor < 78.55


def test_what_is_above_water_stands_open_and_is_said() -> None:
    """Pylon 0.1 x 0.4 and topmark 0.1 x 0.4/2: 0.060 m2, or the pole's 0.473 x 0.15 = 0.071."""
    (study,) = reproduce("calmar").studies
    said = study.findings[2]
    for words in ("without the 0.060 m2", "the 0.071 m2 of the pole", "0.357 m2"):
        assert words in said
    rows = {str(row[0]): row[1:] for row in study.side_by_side[0].rows}
    assert rows["float and pole"][3:] == ("78.53", "0.297")
    assert rows["float, pylon and topmark"][3:] == ("78.67", "0.287")
    assert rows["float, pole, pylon and topmark"][3:] == ("77.78", "0.357")


def test_the_buoy_has_the_printed_volumes() -> None:
    """Digits of a double on the manual's screens."""
    buoy = buoy_of(published("calmar"))
    assert sum(each.displaced(each.height) for each in buoy.hull) == pytest.approx(
        0.260817640094903, rel=1e-13
    )
    assert buoy.volume == pytest.approx(0.260817640094903 + 0.0353429173528852, rel=1e-13)
