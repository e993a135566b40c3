"""Every figure of the tables that loads are made of, once more as their sources have it."""

from __future__ import annotations

import itertools
import math

import pytest

from catopt.errors import NoAnswerError
from catopt.loads.drag_anchor import CURVES, HoldingCurve
from catopt.loads.ship import PROPELLER_AREA_RATIOS, SINKER_MASSES, next_size
from catopt.loads.ship_coefficients import TYPES, coefficients
from catopt.loads.sinker import DENSITIES
from catopt.loads.weathervane import YAW_TYPES

TF, KIP = 9806.65, 4448.2216152605

# Blendermann (1994) as the MSS toolbox lists it (blendermann94.m): CDt, CDl on the frontal area
# from ahead and from astern, delta.
BLENDERMANN = """
car carrier               .95 .55 .60 .80
cargo loaded              .85 .65 .55 .40
cargo containers on deck  .85 .55 .50 .40
container ship loaded     .90 .55 .55 .40
destroyer                 .85 .60 .65 .65
diving support vessel     .90 .60 .80 .55
ferry                     .90 .45 .50 .80
fishing vessel            .95 .70 .70 .40
LNG tanker                .70 .60 .65 .50
offshore supply vessel    .90 .55 .80 .55
passenger liner           .90 .40 .40 .80
research vessel           .85 .55 .65 .60
tanker loaded             .70 .90 .55 .40
tanker ballast            .70 .75 .55 .40
tender                    .85 .55 .55 .65
"""


@pytest.mark.parametrize("line", BLENDERMANN.split("\n")[1:-1])
def test_wind_on_a_kind_of_ship(line: str) -> None:
    name, figures = line[:26].strip(), line[26:].split()
    across, ahead, astern, delta = map(float, figures)
    kind = TYPES[name]
    assert coefficients(kind, 0.0, 0.3)[0] == pytest.approx(-ahead)
    assert coefficients(kind, math.pi, 0.3)[0] == pytest.approx(astern)
    assert coefficients(kind, math.pi / 2.0, 0.3)[1] == pytest.approx(across)
    # At 45 deg sin(2 gamma) is 1: D = 1 - delta/2 (1 - 0.3 CDl/CDt).
    D = 1.0 - 0.5 * delta * (1.0 - 0.3 * ahead / across)
    assert coefficients(kind, math.pi / 4.0, 0.3)[1] == pytest.approx(across * math.sqrt(0.5) / D)


def test_no_kind_of_ship_is_left_out() -> None:
    assert len(TYPES) == len(BLENDERMANN.split("\n")[1:-1])


def curve_of(*key: str) -> HoldingCurve:
    """Find the one curve of an anchor, a soil and a data set."""
    (found,) = [each for each in CURVES if (each.anchor, each.soil, each.data) == key]
    return found


# DTOcean's moorings: tonne-force = A (t)^b, in soft clay and in sand.
DTOCEAN = """
stockless             5.5  .92  11.1 .80
Danforth, LWT, AC-14  10.5 .92  20.0 .80
Moorfast              10.5 .92  20.0 .80
Bruce cast            3.9  .92  39.6 .80
Stevin                16.0 .92  31.0 .94
Stevpris Mk5          42.5 .92  70.0 .92
Bruce FFTS Mk4        42.5 .92  47.0 .94
fixed flukes          5.5  .92  11.1 .80
Danforth              10.5 .92  20.0 .80
LWT                   10.5 .92  20.0 .80
AC-14                 10.5 .92  20.0 .80
Bruce FFTS GP         65.0 .92  76.0 .92
"""
FULL_NAMES = {"fixed flukes": "stockless, fixed flukes"}


def name_of(line: str) -> str:
    """Name of the anchor at the head of a row."""
    name = line[:22].strip()
    return FULL_NAMES.get(name, name)


@pytest.mark.parametrize("line", DTOCEAN.split("\n")[1:-1])
def test_what_an_anchor_holds(line: str) -> None:
    anchor, figures = name_of(line), [float(cell) for cell in line[22:].split()]
    for soil, (A, b) in (("soft clay", figures[:2]), ("sand", figures[2:])):
        curve = curve_of(anchor, soil, "DTOcean")
        assert curve.capacity(1000.0) == pytest.approx(A * TF)
        assert curve.capacity(10e3) == pytest.approx(A * 10.0**b * TF)


# UFC 4-159-03, table 5-3, recalled (engineering facts, drag anchors): kips for 10 000 lbf and b, in
# soft clay and in sand; stockless as ships carry it, with movable flukes, and with fixed ones.
UFC = """
stockless             24  .92  44  .80
fixed flukes          46  .92  70  .80
Danforth              87  .92  126 .80
LWT                   87  .92  126 .80
AC-14                 87  .92  126 .80
Danforth, LWT, AC-14  87  .92  126 .80
Bruce cast            32  .92  250 .80
Stevin                139 .92  165 .80
Moorfast              117 .92  60  .80
NAVMOOR               210 .94  270 .94
"""


@pytest.mark.parametrize("line", UFC.split("\n")[1:-1])
def test_what_an_anchor_holds_after_ufc(line: str) -> None:
    anchor, figures = name_of(line), [float(cell) for cell in line[22:].split()]
    for soil, (kips, b) in (("soft clay", figures[:2]), ("sand", figures[2:])):
        curve = curve_of(anchor, soil, "UFC")
        assert curve.capacity(4536.0) == pytest.approx(kips * KIP, rel=1e-12)
        assert curve.capacity(45360.0) == pytest.approx(kips * 10.0**b * KIP)
        assert curve.mass(kips * 10.0**b * KIP) == pytest.approx(45360.0)
        assert curve.source.confidence == "R"


def test_no_anchor_is_left_out() -> None:
    """Two soils each, and three of Stevpris Mk6."""
    rows = [each for table in (DTOCEAN, UFC) for each in table.split("\n")[1:-1]]
    assert len(CURVES) == 2 * len(rows) + 3


def test_a_stevpris_mk6_of_one_and_of_ten_tonnes() -> None:
    """As MoorPy has it from Vryhof: kN = A (t)^b."""
    for soil, A, b in (("soft clay", 509.96, 0.93), ("medium clay", 701.49, 0.93),
                       ("sand", 904.21, 0.92)):  # fmt: skip
        curve = curve_of("Stevpris Mk6", soil, "Vryhof")
        assert curve.capacity(1e3) == pytest.approx(A * 1e3, rel=1e-12)
        assert curve.capacity(10e3) == pytest.approx(A * 10.0**b * 1e3)
        assert curve.source.confidence == "C"


def test_a_mass_that_is_not_sold_says_by_how_much() -> None:
    with pytest.raises(NoAnswerError, match="the largest is 30 t") as caught:
        next_size(31.5e3, (10e3, 30e3), "anchor")
    assert "1.5 t too light" in str(caught.value)
    assert "31.5 t" in str(caught.value)


def test_the_masses_that_are_offered() -> None:
    """In t; the list is catopt's own, and is written here once more."""
    sinkers = [
        *(0.25, 0.5, 0.75, 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60),
    ]
    assert list(SINKER_MASSES) == pytest.approx([1e3 * each for each in sinkers])


def test_masses_rise_by_no_more_than_a_half_of_themselves_or_double() -> None:
    pairs = list(itertools.pairwise(SINKER_MASSES))
    assert all(a < b <= 2.0 * a for a, b in pairs)
    assert all(b <= 1.7 * a for a, b in pairs if a >= 750.0)


@pytest.mark.parametrize(
    ("kind", "ratio"),
    [
        ("destroyer", 100.0), ("cruiser", 160.0), ("carrier", 125.0), ("cargo", 240.0),
        ("tanker", 270.0), ("submarine", 125.0),
    ],
)  # fmt: skip
def test_propellers_of_ufc(kind: str, ratio: float) -> None:
    """LwL B over the propellers' projected area, page 92."""
    assert PROPELLER_AREA_RATIOS[kind] == ratio
    assert len(PROPELLER_AREA_RATIOS) == 6


def test_where_the_current_acts_after_ufc_s_table_4_10() -> None:
    """Recalled (engineering facts, second sheet): ec/LwL = a + b theta, in degrees."""
    assert {name: tuple(each) for name, each in YAW_TYPES.items()} == {
        "series-60": (-0.291, 0.00353, True),
        "FFG": (-0.201, 0.00221, True),
    }


def test_what_sinkers_are_made_of() -> None:
    """kg/m3: steel and cast iron of CALMAR 7.2; concrete recalled."""
    concrete = {"concrete": 2400.0, "concrete cast in place": 2400.0}
    assert dict(DENSITIES) == concrete | {"steel": 7850.0, "cast iron": 7320.0}
