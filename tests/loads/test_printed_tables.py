"""Every figure of the tables that loads are made of, once more as their sources have it."""

from __future__ import annotations

import itertools
import math

import pytest

from catopt.errors import NoAnswerError
from catopt.loads.blendermann import TYPES, coefficients
from catopt.loads.holding_data import CURVES
from catopt.loads.ship import PROPELLER_AREA_RATIOS
from catopt.loads.sizes import ANCHOR_MASSES, SINKER_MASSES, next_size

TF = 9806.65

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


# DTOcean's moorings: tonne-force = A (t)^b, in soft clay and in sand.
DTOCEAN = """
stockless             5.5  .92  11.1 .80
Danforth, LWT, AC-14  10.5 .92  20.0 .80
Moorfast              10.5 .92  20.0 .80
Bruce cast            3.9  .92  39.6 .80
Stevin                16.0 .92  31.0 .94
Stevpris Mk5          42.5 .92  70.0 .92
Bruce FFTS Mk4        42.5 .92  47.0 .94
"""


@pytest.mark.parametrize("line", DTOCEAN.split("\n")[1:-1])
def test_what_an_anchor_holds(line: str) -> None:
    anchor, figures = line[:22].strip(), [float(cell) for cell in line[22:].split()]
    for soil, (A, b) in (("soft clay", figures[:2]), ("sand", figures[2:])):
        (curve,) = [
            each
            for each in CURVES
            if (each.anchor, each.soil, each.data) == (anchor, soil, "DTOcean")
        ]
        assert curve.capacity(1000.0) == pytest.approx(A * TF)
        assert curve.capacity(10e3) == pytest.approx(A * 10.0**b * TF)


def test_a_stevpris_mk6_of_ten_tonnes() -> None:
    """As MoorPy has it from Vryhof: kN = A (t)^b."""
    for soil, A, b in (("soft clay", 509.96, 0.93), ("medium clay", 701.49, 0.93),
                       ("sand", 904.21, 0.92)):  # fmt: skip
        (curve,) = [each for each in CURVES if (each.anchor, each.soil) == ("Stevpris Mk6", soil)]
        assert curve.capacity(10e3) == pytest.approx(A * 10.0**b * 1e3)


def test_a_mass_that_is_not_sold_says_by_how_much() -> None:
    with pytest.raises(NoAnswerError, match="the largest is 30 t") as caught:
        next_size(31.5e3, ANCHOR_MASSES, "anchor")
    assert "lacks 1.5 t" in str(caught.value)


def test_masses_rise_by_no_more_than_a_half_of_themselves_or_double() -> None:
    for series in (ANCHOR_MASSES, SINKER_MASSES):
        assert all(a < b <= 2.0 * a for a, b in itertools.pairwise(series))
        assert all(b <= 1.7 * a for a, b in itertools.pairwise(series) if a >= 750.0)


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
