"""The table of quantities: its factors, its headings and its way to print."""

from __future__ import annotations

import math
import sys

import pytest

from catopt.quantities import QUANTITIES
from catopt.units import UNITS
from catopt.words import heading


@pytest.mark.parametrize("key", QUANTITIES)
def test_the_factor_is_that_of_the_units(key: str) -> None:
    quantity = QUANTITIES[key]
    assert quantity.key == key
    if quantity.field_unit == quantity.si_unit:
        assert quantity.factor == 1.0
        return
    # Stiffnesses by turning, and of moments, are in units of the table by rad and by m.
    si, field = (
        unit.removesuffix("/rad").replace("*m/m", "*m")
        for unit in (quantity.si_unit, quantity.field_unit)
    )
    (units,) = [u for u in UNITS.values() if {field, si} <= set(u)]
    assert units[si] == 1.0
    # The table of units rounds its powers of ten once.
    assert quantity.factor == pytest.approx(units[field], rel=sys.float_info.epsilon)


def test_no_two_quantities_share_a_heading() -> None:
    headings = [heading(each.name, each) for each in QUANTITIES.values()]
    assert len(set(headings)) == len(headings)


def test_headings_carry_the_unit() -> None:
    for key, said in {
        "tension": "Tension T (kN)",
        "grounded_length": "Grounded length (m)",
        "utilisation": "Utilisation (-)",
    }.items():
        assert heading(QUANTITIES[key].name, QUANTITIES[key]) == said


@pytest.mark.parametrize(
    ("key", "si", "text", "with_unit"),
    [
        ("tension", 4376.84, "4.377", "4.377 kN"),
        ("span", 17.42997, "17.430", "17.430 m"),
        ("angle", math.pi / 2.0, "90.00", "90.00 deg"),
        ("angle_rad", 0.2717236, "0.2717", "0.2717 rad"),
        ("submerged_weight", 93.163175, "93.16", "93.16 N/m"),
        ("mass", 218.0, "0.218", "0.218 t"),
        ("EA", 8e7, "80.00", "80.00 MN"),
        ("EA", math.inf, "inf", "inf MN"),
        ("utilisation", 0.5, "0.500", "0.500"),
        ("objective", 3.55e-15, "3.55e-15", "3.55e-15 m"),
        ("objective", 0.0, "0.00", "0.00 m"),
        ("vertical_force", -0.2, "-0.0002", "-0.0002 kN"),
        ("MBL", None, "-", "-"),
    ],
)
def test_a_value_is_printed_in_the_field_unit(
    key: str, si: float | None, text: str, with_unit: str
) -> None:
    assert QUANTITIES[key].format(si) == text
    assert QUANTITIES[key].format(si, unit=True) == with_unit


def test_digits_can_be_asked_for() -> None:
    assert QUANTITIES["span"].format(17.4299687, digits=5) == "17.42997"


def test_conversion_goes_both_ways() -> None:
    assert QUANTITIES["tension"].to_field(4500.0) == 4.5
    assert QUANTITIES["tension"].to_si(4.5) == 4500.0


def test_a_file_has_no_rounding_noise_of_the_conversion() -> None:
    """60 deg in rad and back is 59.99999999999999 in double precision."""
    angle = QUANTITIES["angle"]
    assert angle.to_field(math.radians(60.0)) != 60.0
    assert angle.in_files(math.radians(60.0)) == 60.0
    assert QUANTITIES["wear_rate"].in_files(0.4e-3 / (365.25 * 86400.0)) == 0.4
    assert QUANTITIES["span"].in_files(0.1 + 0.2) == 0.1 + 0.2  # nothing is converted
