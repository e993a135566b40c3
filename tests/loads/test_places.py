"""Design winds of places in Viet Nam, by hand."""

from __future__ import annotations

import math

import pytest

from catopt.constants import YEAR
from catopt.errors import InputError
from catopt.loads.design_wind import FACTORS, PLACES, ZONES, wind_of_place


def test_speeds_of_zones_follow_from_their_pressures() -> None:
    """A gust of 20 years is sqrt(W0/0.613); of 50 years sqrt(1.2) more; 10 min are gust/1.4.

    QCVN 02:2009 prints 30.12 m/s for zone II.B, 0.95 kN/m2; the new table rounds it up to 31.
    """
    for pressure, speed in ZONES.values():
        gust = math.sqrt(1.20 * pressure / 0.613)
        assert speed == pytest.approx(gust / 1.4, rel=0.025)
    assert math.sqrt(1.20 * 950.0 / 0.613) / 1.4318 == pytest.approx(30.12, abs=0.01)


def test_a_return_period_scales_the_pressure() -> None:
    """Vung Tau, zone II: 31 m/s in 50 years, 31 sqrt(0.87/1.20) = 26.4 m/s in ten."""
    found = wind_of_place("Vung Tau", 10.0 * YEAR)
    assert found.speed == pytest.approx(26.395, abs=1e-3)
    assert (found.zone, found.confidence) == ("II", "C")
    assert wind_of_place("zone iii").speed == 36.0


def test_accents_are_not_asked_for() -> None:
    assert wind_of_place("Vũng Tàu") == wind_of_place("vung tau")
    assert wind_of_place("Đà Nẵng", recalled=True).zone == "II"


@pytest.mark.parametrize(
    ("name", "years", "key"),
    [("Atlantis", 50, "place"), ("Vung Tau", 33, "return_period"), ("Hai Phong", 50, "place"),
     ("Vung Tau", 100, "return_period"), ("zone VI", 50, "place")],
)  # fmt: skip
def test_what_is_not_known_or_only_recalled_is_refused(name: str, years: int, key: str) -> None:
    with pytest.raises(InputError) as error:
        wind_of_place(name, years * YEAR)
    assert error.value.problems[0].key == key


def test_what_is_recalled_counts_where_it_is_asked_for() -> None:
    assert wind_of_place("Hai Phong", recalled=True).confidence == "R"
    found = wind_of_place("Vung Tau", 100.0 * YEAR, recalled=True)
    assert found.speed == pytest.approx(31.0 * math.sqrt(1.37 / 1.20))


def test_all_places_have_a_zone_and_factors_rise() -> None:
    assert {zone for zone, _ in PLACES.values()} <= set(ZONES)
    assert [each for each, _ in FACTORS.values()] == sorted(each for each, _ in FACTORS.values())
