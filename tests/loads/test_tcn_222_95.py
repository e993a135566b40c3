"""22TCN 222-95 by hand, on S3's tanker and off the bow."""

from __future__ import annotations

import math

import pytest

from catopt.errors import InputError
from catopt.loads import HEAD_ON, Headings, SeaState, SurfaceCurrent, Wind
from catopt.loads.tanker_20m import tanker
from catopt.loads.tcn_222_95 import (
    silhouette_factor,
    tcn_loads,
    wave_height,
    wave_length_factor,
)

from . import ROUNDING


def forces(
    headings: Headings = HEAD_ON, chi: float | None = None, depth: float = 20.0
) -> dict[str, float]:
    sea = SeaState(8.0, maximum_height=3.5)
    components = tcn_loads(
        tanker(),
        Wind(20.0),
        SurfaceCurrent(1.2),
        sea,
        depth,
        headings=headings,
        wave_coefficient=chi,
        water_density=1025.0,
    )
    assert {each.source.confidence for each in components} == {"R"}
    return {str(each.name): each.force for each in components}


@pytest.mark.parametrize(
    ("size", "factor"),
    [(10.0, 1.0), (25.0, 1.0), (37.5, 0.9), (75.0, 0.725), (150.0, 0.575), (234.0, 0.5)],
)
def test_the_silhouette_s_factor_is_linear_between_its_rows(size: float, factor: float) -> None:
    """Halfway from 25 to 50 m: (1.0 + 0.8)/2 = 0.9; from 100 to 200 m: (0.65 + 0.50)/2 = 0.575."""
    assert silhouette_factor(size) == pytest.approx(factor, rel=ROUNDING)


@pytest.mark.parametrize(
    ("ratio", "factor"),
    [(0.2, 1.0), (0.75, 0.865), (1.0, 0.73), (2.5, 0.46), (3.5, 0.41), (9.0, 0.40)],
)
def test_the_wave_length_s_factor(ratio: float, factor: float) -> None:
    """Halfway from 0.5 to 1: (1 + 0.73)/2 = 0.865; from 2 to 3: (0.50 + 0.42)/2 = 0.46."""
    assert wave_length_factor(ratio) == pytest.approx(factor, rel=ROUNDING)


def test_s3_s_tanker_head_on() -> None:
    """The standard's own constants, for kN.

    Current: 0.59 x (31.3 x 12.4 = 388.12 m2) x 1.2^2 = 329.75 kN.
    Wind: xi at 31.3 m is 1 - 0.2 x 6.3/25 = 0.9496; 49.0e-5 x 582.18 m2 x 20^2 x 0.9496 =
    108.36 kN.
    """
    of = forces()
    assert of["current along the ship"] / 1e3 == pytest.approx(-329.75, abs=0.005)  # printed digits
    assert of["wind along the ship"] / 1e3 == pytest.approx(-108.36, abs=0.005)
    assert of["wind across the ship"] == of["current across the ship"] == 0.0
    assert len(of) == 4


def test_off_the_bow_each_component_of_the_speed_counts() -> None:
    """Wind 30 deg, current -90 deg off the bow.

    Wind: V cos = 17.3205, V sin = 10 m/s; along -49.0e-5 x 582.18 x 300 x 0.9496 = -81.27 kN;
    the lateral area is 234 x 3.6 + 15 x 25 = 1217.4 m2 with xi = 0.5 of 234 m, across
    73.6e-5 x 1217.4 x 100 x 0.5 = 44.80 kN.
    Current across: -0.59 x (226.98 x 12.4 = 2814.55 m2) x 1.44 = -2391.24 kN.
    """
    of = forces(Headings(math.radians(30.0), math.radians(-90.0)))
    assert of["wind along the ship"] / 1e3 == pytest.approx(-81.27, abs=0.005)
    assert of["wind across the ship"] / 1e3 == pytest.approx(44.80, abs=0.005)
    assert of["current across the ship"] / 1e3 == pytest.approx(-2391.24, abs=0.01)
    # A cosine of 90 deg in double precision, squared.
    assert of["current along the ship"] == pytest.approx(0.0, abs=1e-20)


def test_the_factors_are_told_as_the_standard_prints_them() -> None:
    """49.0e-5, 73.6e-5 and 0.59, which are for a load in kN."""
    components = tcn_loads(
        tanker(),
        Wind(20.0),
        SurfaceCurrent(1.2),
        SeaState(8.0, 1.0),
        20.0,
        headings=HEAD_ON,
        wave_coefficient=None,
        water_density=1025.0,
    )
    told = [str(each.numbers[0].meaning) for each in components]
    assert told == [f"{k} for a load in kN" for k in ("0.00049", "0.000736", "0.59", "0.59")]
    assert [each.kind for each in components] == ["wind", "wind", "current", "current"]
    assert [each.axis for each in components] == ["surge", "sway", "surge", "sway"]


def test_from_astern_it_pushes_forwards() -> None:
    astern = forces(Headings(math.pi, math.pi, math.pi), chi=0.1)
    ahead = forces(chi=0.1)
    for name in ("wind along the ship", "current along the ship", "waves along the ship"):
        assert astern[name] == pytest.approx(-ahead[name], rel=ROUNDING)
        assert ahead[name] < 0.0


def test_the_waves_by_a_coefficient_that_is_given() -> None:
    """The height h of 5 % in the system: Hs = 3.5/1.85 = 1.8919 m, x sqrt(ln 20/2 = 1.49787).

    h = 1.8919 x 1.22387 = 2.3154 m. Along, chi = 0.1: 0.1 x 1.025 x 9.80665 x 2.3154 x 388.12 =
    903.3 kN. Across: k = 0.07078/m at 8 s in 20 m, a_l/lambda = 226.98 x 0.07078/(2 pi) = 2.557,
    gamma1 = 0.50 - 0.08 x 0.557 = 0.4554; x 2814.55 m2: 2983 kN.
    """
    assert wave_height(SeaState(8.0, maximum_height=3.5)) == pytest.approx(2.3154, abs=5e-5)
    along = forces(chi=0.1)
    assert along["waves along the ship"] / 1e3 == pytest.approx(-903.3, abs=0.05)
    assert along["waves across the ship"] == 0.0
    across = forces(Headings(waves=math.radians(90.0)), chi=0.1)
    # Four digits of k, and so of gamma1.
    assert across["waves across the ship"] / 1e3 == pytest.approx(2983.0, rel=3e-4)
    assert across["waves along the ship"] == 0.0


def test_waves_off_the_bow_are_refused() -> None:
    askew = Headings(waves=math.radians(30.0))
    with pytest.raises(InputError, match="from ahead, from astern or from the beam"):
        forces(askew, chi=0.1)
    assert forces(askew, chi=0.0)["waves along the ship"] == 0.0
    for nearly in (0.01, 0.5 * math.pi - 0.01):
        with pytest.raises(InputError, match="from ahead, from astern or from the beam"):
            forces(Headings(waves=nearly), chi=0.1)
    with pytest.raises(InputError, match="wave_coefficient"):
        forces(chi=-0.1)
