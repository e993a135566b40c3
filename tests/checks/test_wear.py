"""Wear by zone, from a table that is asked for by name; rates as printed, in mm a year."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catopt import check_case
from catopt.casefile import parse_case
from catopt.casefile.writing import write_case
from catopt.checks.criteria import strength_of
from catopt.constants import YEAR
from catopt.errors import InputError
from catopt.model import Case, Line, Load, Segment, Service, Site
from catopt.model.service import WEAR_TABLES
from catopt.words import say

PRINTED = {
    "E301": {"splash": 0.4, "catenary": 0.3, "bottom": 0.4},
    "E301-inspected": {"splash": 0.2, "catenary": 0.2, "bottom": 0.3},
    "E301-Norway": {"splash": 0.8, "catenary": 0.2, "bottom": 0.2},
    "S4": {"splash": 1.0, "catenary": 1.0, "bottom": 0.3, "wire": 0.3},
    "tropical": {"splash": 1.0, "catenary": 0.3, "bottom": 0.4},
}
CHAIN = Segment(
    80.0, 1000.0, component="chain studless R3", nominal_diameter=0.089, wear_zone="bottom"
)
BY_S4 = Service(life=10.0 * YEAR, wear_table="S4")
CASE = """
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "60 m"
component = "chain studless R3"
diameter = "89 mm"
wear_zone = "bottom"
[load]
horizontal_force = "100 kN"
[service]
life = "10 years"
wear_table = "S4"
"""


def test_the_rates_are_those_of_the_sheets() -> None:
    rates = {
        name: {zone: pytest.approx(rate * 1e-3 / YEAR, rel=1e-15) for zone, rate in zones.items()}
        for name, zones in PRINTED.items()
    }
    assert {name: dict(table.rates) for name, table in WEAR_TABLES.items()} == rates
    assert [table.confidence for table in WEAR_TABLES.values()] == ["C", "C", "C", "A", "R"]


def test_ground_chain_of_s4_after_ten_years() -> None:
    """89 mm less 10 x 0.3 mm: 0.0223 * 86^2 * (44 - 0.08 * 86) = 6122.23 kN."""
    worn = strength_of(CHAIN, BY_S4)
    assert worn.end_diameter == pytest.approx(0.086, rel=1e-12)
    assert worn.MBL == pytest.approx(6122.23e3, rel=1e-6)
    assert say(worn.note, "en") == (
        "89 mm worn to 86 mm: 0.3 mm a year, on the bottom, by S4, Table 4.3 (A)"
    )
    assert "nằm trên đáy" in say(worn.note, "vi")


def test_a_recalled_table_says_so() -> None:
    worn = strength_of(CHAIN, replace(BY_S4, wear_table="tropical"))
    assert worn.end_diameter == pytest.approx(0.085, rel=1e-12)
    assert "RECALLED" in say(worn.note, "en")


def test_a_recalled_table_is_among_the_warnings() -> None:
    for table, count in (("tropical", 1), ("S4", 0)):
        text = CASE.replace('"S4"', f'"{table}"') + "[checks]\nsafety_factor = 2.0\n"
        case = parse_case(text)
        told = [str(each) for each in check_case(case).warnings if "wear_table" in each]
        assert len(told) == count
        assert all("tropical waters are RECALLED, read in no document" in each for each in told)


def test_a_rate_of_wear_is_written_in_mm_a_year() -> None:
    text = CASE.replace('wear_table = "S4"', 'wear_rate = "0.4 mm/year"').replace(
        'wear_zone = "bottom"', ""
    )
    written = write_case(parse_case(text))
    assert 'wear_rate = "0.4 mm/year"' in written
    assert parse_case(written) == parse_case(text)


def test_steel_without_zone_or_rate_of_its_own_is_refused() -> None:
    with pytest.raises(InputError, match=r"segment\.wear_zone: wear_table S4 has splash, cat"):
        strength_of(replace(CHAIN, wear_zone=None), BY_S4)
    own = replace(CHAIN, wear_zone=None, wear_rate=0.5e-3 / YEAR)
    assert strength_of(own, BY_S4).end_diameter == pytest.approx(0.084, rel=1e-12)


def test_rope_keeps_its_strength_under_a_table() -> None:
    rope = Segment(60.0, 10.0, component="rope polyester 8-strand", MBL=1e6, nominal_diameter=0.05)
    assert strength_of(rope, BY_S4).MBL == 1e6


def test_every_misfit_is_told_with_its_key() -> None:
    text = CASE.replace('wear_table = "S4"', 'wear_table = "tropical"\nwear_rate = "0.1 mm/year"')
    with pytest.raises(InputError) as caught:
        parse_case(text.replace('"bottom"', '"wire"'))
    assert sorted((each.key, each.allowed) for each in caught.value.problems) == [
        ("line.segments[0].wear_zone", "tropical has splash, catenary, bottom"),
        ("service.wear_rate", "one of wear_rate and wear_table"),
    ]
    with pytest.raises(InputError, match=r"goes with service\.wear_table, not given"):
        parse_case(CASE.replace('wear_table = "S4"', ""))
    both = CASE.replace('wear_zone = "bottom"', 'wear_zone = "bottom"\nwear_rate = "1 mm/year"')
    with pytest.raises(InputError, match="one of wear_rate and wear_zone"):
        parse_case(both)
    with pytest.raises(InputError, match=r"wear_table: found .*one of E301"):
        parse_case(CASE.replace('"S4"', '"S5"'))


def test_a_case_in_python_is_held_to_the_same() -> None:
    with pytest.raises(InputError, match=r"line\.segments\[0\]\.wear_zone"):
        Case(Site(20.0), Line([CHAIN]), Load(horizontal_force=1e5), 20.0)


def test_a_written_case_keeps_table_and_zone() -> None:
    case = parse_case(CASE)
    assert parse_case(write_case(case)) == case
