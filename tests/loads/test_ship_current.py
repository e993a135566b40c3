"""Current on ships after UFC 4-159-03: its example, its own remarks, hand calculations, limits."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt.errors import InputError
from catopt.loads import Ship
from catopt.loads.ufc import (
    deep_coefficient,
    friction_coefficient,
    longitudinal_loads,
    propeller_area,
    ship_parameter,
    transverse_coefficient,
    transverse_load,
    wetted_surface,
    yaw_moment,
)

from . import ROUNDING

RHO = 1025.0
LENGTH, DRAUGHT = 124.4, 4.39
"""FFG-7; the length is recalled, the draught is T/d times d of table 4-6."""

FRIGATE = Ship(
    "FFG-7",
    length_overall=136.0,
    length_waterline=LENGTH,
    breadth=13.7,
    draught=DRAUGHT,
    displacement=3590.0 / 1.025,
    midship_area=50.0,
    lateral_area=1500.0,
    frontal_area=220.0,
    propeller="destroyer",
)
"""Breadth, displacement and areas are recalled, and matter to no printed number."""

TABLE_4_6 = [
    (150.0, 0.096, 0.55),
    (50.0, 0.288, 0.66),
    (25.0, 0.576, 1.03),
    (20.0, 0.72, 1.30),
    (15.0, 0.96, 1.90),
]
"""UFC 4-159-03 of 2005, table 4-6, page 87: depth (ft), T/d, force (MN) at 1.5 m/s."""


@pytest.mark.parametrize(("feet", "ratio", "printed"), TABLE_4_6)
def test_the_ffg_7_of_table_4_6(feet: float, ratio: float, printed: float) -> None:
    """C0 = 0.849, that of chi = 14.9, is the one number fitted to the five that are printed."""
    depth = 0.3048 * feet
    assert DRAUGHT / depth == pytest.approx(ratio, abs=5e-4)  # printed digits
    coefficient = transverse_coefficient(DRAUGHT / depth, deep_coefficient(14.9))
    force = 0.5 * RHO * 1.5**2 * LENGTH * DRAUGHT * coefficient
    assert force / 1e6 == pytest.approx(printed, abs=5e-3)  # printed digits


@pytest.mark.parametrize(
    ("ratio", "coefficient"),
    [(0.096, 0.871), (0.288, 1.044), (0.576, 1.629), (0.72, 2.068), (0.96, 3.016)],
)
def test_coefficients_of_the_example_by_hand(ratio: float, coefficient: float) -> None:
    """0.849 + 2.351 (T/d)^2, to the digits that are written here."""
    assert transverse_coefficient(ratio, 0.849) == pytest.approx(coefficient, abs=6e-4)


def test_the_root_of_the_ship_parameter() -> None:
    """0.22 sqrt(14.9) = 0.8492; without the root 3.28, above C1 = 3.2."""
    assert deep_coefficient(14.9) == pytest.approx(0.8492, abs=5e-5)  # printed digits
    with pytest.raises(InputError, match="C0"):
        transverse_coefficient(0.5, 0.22 * 14.9)


def test_ship_parameter_by_hand() -> None:
    """100^2 x 50/(10 x 5000) = 10."""
    assert ship_parameter(100.0, 50.0, 10.0, 5000.0) == pytest.approx(10.0, rel=ROUNDING)


def test_coefficient_at_its_ends_and_with_k_3() -> None:
    assert transverse_coefficient(0.0, 0.8) == 0.8
    assert transverse_coefficient(1.0, 0.8) == pytest.approx(3.2, rel=ROUNDING)
    assert transverse_coefficient(0.5, 0.8, exponent=3.0) == pytest.approx(1.1, rel=ROUNDING)


def test_the_propeller_is_about_two_thirds_for_a_destroyer() -> None:
    """What page 92 says of its destroyer at 1.544 m/s, bow-on: about, so to a tenth."""
    along = longitudinal_loads(FRIGATE, 1.544, angle=0.0, water_density=RHO)
    parts = {each.name: each.force for each in along}
    share = parts["current along the ship, propeller"] / sum(parts.values())
    assert share == pytest.approx(2.0 / 3.0, rel=0.1)


def test_longitudinal_by_hand() -> None:
    """A ship of 100 x 20 x 5 m, 7000 m3, at 1 m/s, bow-on, nu = 1e-6.

    Form: 512.5 x 100 x 0.1 = 5125 N. Friction: S = 1.7 x 5 x 100 + 7000/5 = 2250 m2, Rn = 1e8,
    C = 0.075/36, 512.5 x 2250 x 0.0020833 = 2402.34 N. Propeller: 100 x 20/240/0.838 = 9.94431 m2,
    512.5 x 9.94431 = 5096.46 N.
    """
    ship = Ship("plain", 105.0, 100.0, 20.0, 5.0, 7000.0, 98.0, 800.0, 300.0, "cargo")
    form, friction, propeller = longitudinal_loads(
        ship, 1.0, angle=0.0, water_density=RHO, viscosity=1e-6
    )
    assert form.force == pytest.approx(-5125.0, rel=ROUNDING)
    assert friction.force == pytest.approx(-2402.34, abs=5e-3)  # printed digits
    assert propeller.force == pytest.approx(-5096.46, abs=5e-3)  # printed digits
    assert {each.source.confidence for each in (form, friction, propeller)} == {"A"}


def test_pieces_by_hand() -> None:
    assert wetted_surface(5.0, 100.0, 7000.0) == pytest.approx(2250.0, rel=ROUNDING)
    assert friction_coefficient(1e8) == pytest.approx(0.075 / 36.0, rel=ROUNDING)
    assert propeller_area(83.8, 10.0, 10.0) == pytest.approx(100.0, rel=ROUNDING)
    # a pitch of half the diameter: 1.067 - 0.1145 = 0.9525
    assert propeller_area(95.25, 10.0, 10.0, 0.5) == pytest.approx(100.0, rel=ROUNDING)
    assert yaw_moment(1e6, 100.0, 0.1, -0.001, 90.0) == pytest.approx(1e6, rel=ROUNDING)
    assert yaw_moment(1e6, 100.0, 0.1, -0.001, 270.0) == pytest.approx(1e6, rel=ROUNDING)


BLOCK = Ship("block", 100.0, 100.0, 20.0, 5.0, 10e3, 100.0, 800.0, 300.0)


@pytest.mark.parametrize(
    ("exponent", "force"),
    [(2.0, 0.5 * RHO * 500.0 * 0.661189), (3.0, 0.5 * RHO * 500.0 * 0.534249)],
)
def test_the_current_across_a_block_by_hand(exponent: float, force: float) -> None:
    """At 1 m/s, 20 m: chi = 100^2 x 100/(20 x 10,000) = 5, C0 = 0.22 sqrt 5 = 0.491935.

    Cyc = 0.491935 + 2.708065 (5/20)^K: 0.661189 with K = 2, 0.534249 with K = 3. At 2 m/s, 30 deg
    off the bow, it is 4 sin 30 = 2 times as much.
    """
    how = {"water_density": RHO, "exponent": exponent}
    beam = transverse_load(BLOCK, 1.0, 20.0, angle=0.5 * math.pi, **how)
    oblique = transverse_load(BLOCK, 2.0, 20.0, angle=math.radians(30.0), **how)
    assert beam.force == pytest.approx(force, rel=1e-6)  # printed digits
    assert oblique.force == pytest.approx(2.0 * beam.force, rel=ROUNDING)


def test_what_goes_into_the_current_across_is_told() -> None:
    """Cyc/C0 = 0.661189/0.491935 = 1.34."""
    of = transverse_load(BLOCK, 1.0, 20.0, angle=1.0, water_density=RHO)
    assert str(of.note) == (
        "chi = 5.00, C0 = 0.492, C1 = 3.2, K = 2, T/d = 0.250, Cyc = 0.661, "
        "1.34 times that of deep water"
    )


def test_off_the_bow_the_friction_is_that_of_the_speed_along() -> None:
    """60 deg off: Rn = 2 x 100 x 0.5/1e-6 = 1e8, C = 0.075/36; 1/2 rho 2^2 S C cos 60.

    S = 1.7 x 5 x 100 + 10,000/5 = 2850 m2.
    """
    angle = math.radians(60.0)
    form, friction = longitudinal_loads(BLOCK, 2.0, angle=angle, water_density=RHO, viscosity=1e-6)
    assert form.force == pytest.approx(-0.5 * RHO * 4.0 * 100.0 * 0.1 * 0.5, rel=ROUNDING)
    by_hand = -0.5 * RHO * 4.0 * 2850.0 * 0.075 / 36.0 * 0.5
    assert friction.force == pytest.approx(by_hand, rel=ROUNDING)
    assert str(friction.note) == "Rn = 1e+08"


def test_where_the_friction_ends() -> None:
    """At Rn = 1e5 it is 0.075/9; below, where its pole at Rn = 100 lies, there is none."""
    assert friction_coefficient(1e5) == pytest.approx(0.075 / 9.0, rel=ROUNDING)
    assert friction_coefficient(0.999e5) == 0.0


def test_the_yaw_of_a_current_from_both_sides_is_one_at_the_bow() -> None:
    """Theta counts to 180 deg and back: 180 and 180 of 360, 181 as 179 deg."""
    assert yaw_moment(1.0, 1.0, 0.1, -0.001, 180.0) == pytest.approx(-0.08, rel=1e-9)
    assert yaw_moment(1.0, 1.0, 0.1, -0.001, 181.0) == pytest.approx(-0.079, rel=1e-9)
    assert yaw_moment(1.0, 1.0, 0.1, -0.001, 179.0) == pytest.approx(-0.079, rel=1e-9)


def test_bow_and_stern_are_opposite_and_the_beam_has_none() -> None:
    ahead, astern, beam = (
        sum(p.force for p in longitudinal_loads(FRIGATE, 1.5, angle=a, water_density=RHO))
        for a in (0.0, math.pi, 0.5 * math.pi)
    )
    assert ahead < 0.0
    assert astern == pytest.approx(-ahead, rel=ROUNDING)
    # cos(pi/2) is 6e-17 in double precision; the friction formula's pole at Rn = 100 is not met.
    assert beam == pytest.approx(0.0, abs=1e-9)


def test_transverse_is_none_ahead_and_symmetrical() -> None:
    ship = replace(FRIGATE, midship_area=50.0)
    forces = [
        transverse_load(ship, 1.5, 20.0, angle=a, water_density=RHO).force
        for a in (0.0, 0.5, math.pi - 0.5, -0.5, 0.5 * math.pi)
    ]
    assert forces[0] == 0.0
    assert forces[1] == pytest.approx(forces[2], rel=ROUNDING)
    assert forces[3] == pytest.approx(-forces[1], rel=ROUNDING)
    assert forces[4] == max(forces)


def test_no_current_no_force() -> None:
    parts = longitudinal_loads(FRIGATE, 0.0, angle=0.0, water_density=RHO)
    assert [abs(each.force) for each in parts] == [0.0, 0.0, 0.0]
    assert transverse_load(FRIGATE, 0.0, 20.0, angle=1.0, water_density=RHO).force == 0.0


def test_a_draught_deeper_than_the_water_is_refused() -> None:
    with pytest.raises(InputError, match=r"the water is 4 m deep: the ship would be aground"):
        transverse_load(FRIGATE, 1.5, 4.0, angle=1.0, water_density=RHO)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"displacement": 3590e3}, "it is a volume"),
        ({"length_waterline": 140.0}, "longer than the ship"),
        ({"propeller": "tug"}, "one of destroyer, cruiser"),
        ({"midship_area": 90.0}, "above breadth x draught"),
        ({"draught": 20.0}, "above the breadth"),
    ],
)
def test_what_no_ship_is_is_refused(change: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        replace(FRIGATE, **change)  # type: ignore[arg-type]
