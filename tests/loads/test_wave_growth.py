"""Seas raised by the wind over a fetch, beside the laws that hold in each limit and by hand."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from catopt.constants import STANDARD_GRAVITY as G
from catopt.errors import InputError
from catopt.loads.wave_growth import grown_sea


def test_over_a_lake_by_hand() -> None:
    """20 m/s over 10 km of water 5 m deep: d~ = 0.12258, F~ = 245.17.

    tanh(0.343 d~^1.14) = 0.03133, 4.41e-4 F~^0.79 = 0.03405, so H~ = 0.24 (0.03133 tanh
    1.0868)^0.572 = 0.02905; tanh(0.1 d~^2.01) = 0.001471, 2.77e-7 F~^1.45 = 0.000808, so T~ = 7.69
    (0.001471 tanh 0.5494)^0.187 = 1.9949.
    """
    sea = grown_sea(20.0, 10e3, 5.0)
    assert sea.hs == pytest.approx(0.02905 * 400.0 / G, rel=1e-3)
    assert sea.peak_period == pytest.approx(1.9949 * 20.0 / G, rel=1e-3)


@pytest.mark.parametrize("wind", [8.0, 20.0, 35.0])
@pytest.mark.parametrize("fetch", [2e3, 20e3])
def test_short_fetches_of_deep_water_are_kahma_and_calkoens(wind: float, fetch: float) -> None:
    """Their composite: m0 g^2/U^4 = 5.2e-7 F~^0.9, peak at 13.7 F~^-0.27 rad/s times g/U."""
    F = G * fetch / wind**2
    sea = grown_sea(wind, fetch, 2000.0)
    assert sea.hs == pytest.approx(4.0 * math.sqrt(5.2e-7 * F**0.9) * wind**2 / G, rel=0.02)
    assert sea.peak_period == pytest.approx(2.0 * math.pi / (13.7 * F**-0.27) * wind / G, rel=0.02)


def test_a_sea_that_nothing_limits_is_pierson_and_moskowitzs() -> None:
    """Hs = 0.24 U^2/g; the peak of that spectrum at 0.13 g/U Hz."""
    sea = grown_sea(10.0, 5e6, 2000.0)
    assert sea.hs == pytest.approx(0.24 * 100.0 / G, rel=0.01)
    assert sea.peak_period == pytest.approx(10.0 / (0.13 * G), rel=0.02)


def test_depth_and_fetch_each_limit_it() -> None:
    """More of either never lowers a sea; shallow water holds it below half of its depth."""
    seas = [[grown_sea(25.0, F, d) for F in (1e3, 1e4, 1e5)] for d in (2.0, 10.0, 50.0)]
    for row in seas:
        assert [each.hs for each in row] == sorted(each.hs for each in row)
        assert [each.peak_period for each in row] == sorted(each.peak_period for each in row)
    for column in zip(*seas, strict=True):
        assert [each.hs for each in column] == sorted(each.hs for each in column)
    assert 0.3 < grown_sea(30.0, 1e6, 2.0).hs / 2.0 < 0.5


@pytest.mark.parametrize("wrong", ["wind", "fetch", "depth"])
def test_nothing_grows_from_nothing(wrong: str) -> None:
    given = {"wind": 20.0, "fetch": 1e4, "depth": 5.0, wrong: 0.0}
    with pytest.raises(InputError) as error:
        grown_sea(**given)
    assert [each.key for each in error.value.problems] == [wrong]


def test_the_laws_beside_it_in_the_page_are_these() -> None:
    """JONSWAP: m0 g^2/U^4 = 1.6e-7 F~; CEM: g H/u*^2 = 0.0413 sqrt(g F/u*^2), u*^2 = Cd U^2."""
    wind, fetch = 20.0, 10e3
    shallow, deep = (grown_sea(wind, fetch, depth) for depth in (5.0, 2000.0))
    jonswap = 4.0 * math.sqrt(1.6e-7 * G * fetch / wind**2) * wind**2 / G
    friction = 0.001 * (1.1 + 0.035 * wind) * wind**2
    cem = 0.0413 * math.sqrt(G * fetch / friction) * friction / G
    rows = [
        f"| 20 m/s | 10 km | 5 m | {shallow.hs:.2f} m, {shallow.peak_period:.1f} s | | |",
        f"| 20 m/s | 10 km | deep | {deep.hs:.2f} m, {deep.peak_period:.1f} s | "
        f"{jonswap:.2f} m | {cem:.2f} m |",
    ]
    page = (Path(__file__).parents[2] / "docs" / "sizing.md").read_text("utf-8").splitlines()
    assert [row for row in rows if row not in page] == []
