"""A buoy's chain by zone, against hand calculations."""

from __future__ import annotations

import math

import pytest

from catopt.constants import YEAR
from catopt.sizing.maintenance import (
    ChainZone,
    UpkeepInputs,
    published_rates,
    renewals,
    thrash_ends,
)
from tests.sizing.at_rest import size_buoy

MM_A_YEAR = 1e-3 / YEAR


def test_the_thrash_section_is_between_two_touchdowns() -> None:
    """Plumb from 9 m: 30 - 9 = 21 m; under 900 N from 12 m: 30 - sqrt(12^2 + 2 x 12 x 9) m."""
    low, high = thrash_ends(30.0, 100.0, 900.0, 9.0, 12.0)
    assert (low, high) == pytest.approx((30.0 - math.sqrt(360.0), 21.0))
    assert thrash_ends(15.0, 100.0, 900.0, 9.0, 12.0)[0] == 0.0  # it never lies whole


def test_rates_are_those_of_the_tables_that_were_read() -> None:
    """E301 (2008) has 0.2 and 0.3 mm a year hanging, 0.2, 0.3, 0.4 at the bottom; S4 1 and 0.3."""
    for zone, low, high in (("catenary", 0.2, 1.0), ("bottom", 0.2, 0.4)):
        assert published_rates(zone) == pytest.approx((low * MM_A_YEAR, high * MM_A_YEAR))


def test_a_zone_lasts_what_may_wear_over_its_rate() -> None:
    """38 mm down to 30.4 at 0.2, 0.4 and 2 mm a year: 38, 19 and 3.8 years."""
    mean, low, high = (each * MM_A_YEAR for each in (0.4, 0.2, 2.0))
    zone = ChainZone("thrash", 5.0, 12.0, 0.038, mean, low, high, 0.0304)
    lives = zone.longest_life, zone.life, zone.shortest_life
    assert [each / YEAR for each in lives if each] == pytest.approx([38.0, 19.0, 3.8])


def test_renewals_of_twenty_years() -> None:
    """After 5, 10 and 15 years; after 6, 12, 18; what lasts 20 years is not renewed."""
    assert [renewals(each * YEAR) for each in (5.0, 6.0, 19.9, 20.0)] == [3, 3, 1, 0]


def test_a_sizing_by_zone_with_its_cost() -> None:
    given = {"thrash_wear": "2 mm/year", "chain_price": 2000, "sinker_price": 100, "crane": "1 t"}
    found = size_buoy(
        "pillar 1.8 m", depth="12 m", low_water="10 m", hs="1 m", soil="sand", fittings_price=500,
        visit_price=4000, **given,
    )  # fmt: skip
    of = found.upkeep
    assert of is not None
    assert of.cost is not None
    line, first = found.point.line, found.point.line.segments[0]
    assert of.zones[0].start == 0.0
    assert of.zones[-1].end == line.length
    names = [each.name for each in of.zones]
    assert names == ["ground", "thrash", "riding"]
    thrash = of.zones[1]
    service = found.case.service
    assert service is not None
    # It lasts the service life: of d a fifth may wear, and 10 mm do in five years.
    assert thrash.life is not None
    assert thrash.life >= service.life * (1.0 - 1e-9)
    assert thrash.diameter >= 5.0 * 10e-3
    assert thrash.limit >= 0.8 * thrash.diameter
    # By hand: masses by length and square of size; what lasts 5.6, 5.0 and 5.6 years is renewed
    # three times in twenty, at the same visits.
    assert [round((z.life or 0.0) / YEAR, 1) for z in of.zones] == [5.6, 5.0, 5.6]
    size = first.nominal_diameter or 1.0
    mass = sum((first.mass or 0.0) * (z.end - z.start) * (z.diameter / size) ** 2 for z in of.zones)
    anchor = found.point.anchor
    assert anchor is not None
    by_hand = 4 * 2.0 * mass + 0.1 * (anchor.mass or 0.0) + 4 * (500 + 4000)
    assert of.cost.total == pytest.approx(by_hand)
    assert any("crane" in each for each in found.warnings)


def test_a_price_is_not_negative() -> None:
    with pytest.raises(Exception, match="visit_price"):
        UpkeepInputs(visit_price=-1.0)
