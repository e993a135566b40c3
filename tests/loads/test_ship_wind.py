"""Wind on ships: Blendermann's coefficients, UFC's shapes, recalled figures only when asked for."""

from __future__ import annotations

import math

import pytest

from catopt.errors import InputError
from catopt.loads import Ship, UfcWind, Wind
from catopt.loads.ship_coefficients import TYPES, blendermann_loads, coefficients
from catopt.loads.ufc import (
    Superstructure,
    longitudinal_shape,
    transverse_shape,
    ufc_wind_loads,
)

from . import ROUNDING

SHIP = Ship("plain", 105.0, 100.0, 20.0, 5.0, 7000.0, 98.0, 800.0, 300.0)
CASES: tuple[Superstructure, ...] = ("single", "distributed")


def test_blendermann_head_beam_and_stern() -> None:
    """1/2 x 1.25 x 20^2 = 250 Pa: 0.9 x 300 and 0.55 x 300 m2 along, 0.7 x 800 m2 across."""
    ahead, beam, astern = (
        [
            part.force
            for part in blendermann_loads(
                SHIP, Wind(20.0), "tanker loaded", angle=math.radians(deg), air_density=1.25
            )
        ]
        for deg in (0, 90, 180)
    )
    assert ahead == pytest.approx([-67500.0, 0.0], rel=ROUNDING, abs=1e-9)
    assert beam == pytest.approx([0.0, 140000.0], rel=ROUNDING, abs=1e-9)
    assert astern == pytest.approx([41250.0, 0.0], rel=ROUNDING, abs=1e-9)


def test_blendermann_at_45_degrees_by_hand() -> None:
    """Tanker loaded, AF/AL = 0.375: CDl/CDt = 0.9 x 0.375/0.7 = 0.482143.

    D = 1 - 0.2 x 0.517857 = 0.896429; CX = -0.9 x 0.707107/D = -0.709924; CY = 0.552163.
    """
    cx, cy = coefficients(TYPES["tanker loaded"], math.radians(45.0), 0.375)
    assert (cx, cy) == pytest.approx((-0.709924, 0.552163), abs=5e-7)  # printed digits


def test_blendermann_changes_from_bow_to_stern_on_the_beam() -> None:
    """Tanker loaded, AF/AL = 0.375, 4 deg on either side of the beam: sin^2(2 gamma) = sin^2 8 deg.

    Ahead of it CDl/CDt = 0.9 x 0.375/0.7 = 0.482143, D = 1 - 0.2 x 0.517857 x 0.0193692 = 0.997994;
    CX = -0.9 x 0.0697565/D = -0.0629070. Abaft 0.55 x 0.375/0.7 = 0.294643, D = 0.997268;
    CX = 0.55 x 0.0697565/D = 0.0384712.
    """
    of = TYPES["tanker loaded"]
    assert coefficients(of, math.radians(86.0), 0.375)[0] == pytest.approx(-0.0629070, abs=5e-8)
    assert coefficients(of, math.radians(94.0), 0.375)[0] == pytest.approx(0.0384712, abs=5e-8)


@pytest.mark.parametrize("kind", TYPES)
def test_blendermann_is_symmetrical_and_continuous(kind: str) -> None:
    of = TYPES[kind]
    for angle in (0.3, 1.2, 2.5):
        cx, cy = coefficients(of, angle, 0.3)
        mirrored = coefficients(of, -angle, 0.3)
        assert mirrored == pytest.approx((cx, -cy), rel=ROUNDING)
    below, above = (coefficients(of, 0.5 * math.pi + step, 0.3) for step in (-1e-9, 1e-9))
    # Coefficients change by less than 10 per rad.
    assert below == pytest.approx(above, abs=2e-8)


def test_no_wind_no_force() -> None:
    parts = blendermann_loads(SHIP, Wind(0.0), "tanker loaded", angle=0.7, air_density=1.221)
    assert [abs(part.force) for part in parts] == [0.0, 0.0]


def test_an_unknown_kind_of_ship() -> None:
    with pytest.raises(InputError, match="one of car carrier"):
        blendermann_loads(SHIP, Wind(20.0), "VLCC", angle=0.0, air_density=1.221)


# ------------------------------------------------------------------ UFC


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("zero", [70.0, 90.0, 120.0])
def test_the_longitudinal_shape_at_its_three_angles(case: Superstructure, zero: float) -> None:
    theta = math.radians(zero)
    # A handful of operations on numbers of the size of 1.
    assert longitudinal_shape(0.0, theta, case) == pytest.approx(1.0, abs=1e-12)
    assert longitudinal_shape(theta, theta, case) == pytest.approx(0.0, abs=1e-12)
    assert longitudinal_shape(math.pi, theta, case) == pytest.approx(-1.0, abs=1e-12)
    assert longitudinal_shape(-0.7, theta, case) == pytest.approx(
        longitudinal_shape(0.7, theta, case), abs=1e-12
    )


def test_the_longitudinal_shapes_by_hand() -> None:
    """At theta 60, theta_x 120 deg: phi = 45, cos 0.707107; gamma = 135.

    (sin 135 - sin 675/10)/0.9 with sin 675 = sin(-45) = -0.707107, so 0.777817/0.9 = 0.864242.
    At 150 deg phi = 135 deg.
    """
    zero = math.radians(120.0)
    sixty, more = math.radians(60.0), math.radians(150.0)
    half = math.sqrt(0.5)
    assert longitudinal_shape(sixty, zero, "single") == pytest.approx(half, abs=1e-12)
    assert longitudinal_shape(more, zero, "single") == pytest.approx(-half, abs=1e-12)
    by_hand = 1.1 * half / 0.9
    assert longitudinal_shape(sixty, zero, "distributed") == pytest.approx(by_hand, abs=1e-12)
    assert longitudinal_shape(more, zero, "distributed") == pytest.approx(-by_hand, abs=1e-12)


def test_the_recalled_transverse_shape_is_1_on_the_beam() -> None:
    """(1 - 0.05)/0.95."""
    assert transverse_shape(0.5 * math.pi, allow_recalled=True) == pytest.approx(1.0, abs=1e-12)
    assert transverse_shape(0.0, allow_recalled=True) == 0.0


def test_the_recalled_transverse_shape_off_the_bow_by_hand() -> None:
    """30 deg: (0.5 - 0.05 x 0.5)/0.95 = 0.5; 54 deg: sin 270 = -1, (0.809017 + 0.05)/0.95."""
    at_30, at_54 = (
        transverse_shape(math.radians(each), allow_recalled=True) for each in (30.0, 54.0)
    )
    assert at_30 == pytest.approx(0.5, rel=ROUNDING)
    assert at_54 == pytest.approx(0.904228, abs=5e-7)  # printed digits


def test_the_wind_turns_from_ahead_to_astern_where_the_shape_is_zero() -> None:
    """theta_x = 100 deg is 80 deg off the bow; 250 Pa x 300 m2 = 75 kN. Case I, by phi.

    60 deg off the bow theta = 120: phi = 90 + 90 x 20/80 = 112.5, cos = -0.382683, x 0.5 ahead:
    -14.3506 kN. At 90 deg theta = 90: phi = 81, cos = 0.156434, x 0.6 astern: 7.03955 kN; at 84 deg
    phi = 86.4, cos = 0.0627905: 2.82557 kN.
    """
    own = UfcWind(0.9, 0.5, 0.6, math.radians(100.0), "single")
    for degrees, kilonewtons in ((60.0, -14.3506), (90.0, 7.03955), (84.0, 2.82557)):
        along, _ = ufc_wind_loads(
            SHIP,
            Wind(20.0),
            own,
            angle=math.radians(degrees),
            air_density=1.25,
            allow_recalled=True,
        )
        assert along.force / 1e3 == pytest.approx(kilonewtons, abs=5e-5)  # printed digits


def test_recalled_figures_are_refused_unless_asked_for() -> None:
    with pytest.raises(InputError, match="recalled \\(R\\), read in no document"):
        transverse_shape(1.0)


OWN = UfcWind(0.9, 0.5, 0.6, math.radians(100.0), "distributed")


def test_ufc_ahead_needs_no_recalled_shape() -> None:
    """250 Pa x 300 m2 x 0.5, backwards; from astern 0.6, forwards."""
    ahead = ufc_wind_loads(SHIP, Wind(20.0), OWN, angle=0.0, air_density=1.25)
    assert ahead[0].force == pytest.approx(-37500.0, rel=ROUNDING)
    assert ahead[0].source.confidence == "A"
    astern = ufc_wind_loads(SHIP, Wind(20.0), OWN, angle=math.pi, air_density=1.25)
    assert astern[0].force == pytest.approx(45000.0, rel=ROUNDING)
    assert abs(astern[1].force) == 0.0


def test_ufc_on_the_beam_is_recalled_and_says_so() -> None:
    beam = 0.5 * math.pi
    with pytest.raises(InputError, match="take Blendermann's"):
        ufc_wind_loads(SHIP, Wind(20.0), OWN, angle=beam, air_density=1.25)
    with pytest.raises(InputError, match="take Blendermann's"):
        ufc_wind_loads(SHIP, Wind(20.0), OWN, angle=0.01, air_density=1.25)
    parts = ufc_wind_loads(SHIP, Wind(20.0), OWN, angle=beam, air_density=1.25, allow_recalled=True)
    assert parts[1].force == pytest.approx(250.0 * 800.0 * 0.9, rel=ROUNDING)
    assert parts[1].source.recalled


def test_recalled_coefficients_are_refused_ahead_too() -> None:
    guessed = UfcWind(0.9, 0.7, 0.7, 1.5, "single", recalled=True)
    with pytest.raises(InputError, match="recalled"):
        ufc_wind_loads(SHIP, Wind(20.0), guessed, angle=0.0, air_density=1.25)
    with pytest.raises(InputError, match="single, distributed"):
        UfcWind(0.9, 0.7, 0.7, 1.5, "none")  # type: ignore[arg-type]


MSS = {
    "car carrier": (0.95, 0.55, 0.60, 0.80),
    "cargo loaded": (0.85, 0.65, 0.55, 0.40),
    "cargo containers on deck": (0.85, 0.55, 0.50, 0.40),
    "container ship loaded": (0.90, 0.55, 0.55, 0.40),
    "destroyer": (0.85, 0.60, 0.65, 0.65),
    "diving support vessel": (0.90, 0.60, 0.80, 0.55),
    "ferry": (0.90, 0.45, 0.50, 0.80),
    "fishing vessel": (0.95, 0.70, 0.70, 0.40),
    "LNG tanker": (0.70, 0.60, 0.65, 0.50),
    "offshore supply vessel": (0.90, 0.55, 0.80, 0.55),
    "passenger liner": (0.90, 0.40, 0.40, 0.80),
    "research vessel": (0.85, 0.55, 0.65, 0.60),
    "tanker loaded": (0.70, 0.90, 0.55, 0.40),
    "tanker ballast": (0.70, 0.75, 0.55, 0.40),
    "tender": (0.85, 0.55, 0.55, 0.65),
}
"""CD_t, CD_l_AF(0), CD_l_AF(pi), delta: BDATA of blendermann94.m in Fossen's MSS toolbox, read
there on 29 November 2026 (its rows 1 to 6, 8 to 13 and 15 to 17)."""


def test_blendermann_s_rows_are_those_of_the_toolbox() -> None:
    assert {name: tuple(row) for name, row in TYPES.items()} == MSS
