"""What a file says of a clump weight or a buoy."""

from __future__ import annotations

import pytest

from catopt.casefile import parse_case

CASE = """
[site]
water_depth = "20 m"
water_density = "1000 kg/m^3"
[line]
[[line.segments]]
length = "60 m"
submerged_weight = "500 N/m"
[[line.point_loads]]
position = "20 m"
{keys}
[load]
horizontal_force = "20 kN"
"""


def test_mass_and_volume_give_the_weight_in_water() -> None:
    """300 kg that take the place of 500 kg of water lift with 200 kgf."""
    (load,) = parse_case(CASE.format(keys='mass = 300\nvolume = "0.5 m^3"')).line.point_loads
    assert load.submerged_weight == pytest.approx(-200.0 * 9.80665, rel=1e-12)
    assert load.mass == 300.0


def test_drag_and_added_mass_are_read() -> None:
    keys = 'mass = 300\nvolume = 0.5\ndrag_area = "8000 cm^2"\ndrag_coefficient = 1.1\n'
    text = CASE.format(keys=keys + "added_mass_coefficient = 0.5")
    (load,) = parse_case(text).line.point_loads
    assert load.drag_product == pytest.approx(0.88, rel=1e-12)
    assert load.added_mass_coefficient == 0.5
