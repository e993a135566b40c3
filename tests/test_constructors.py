"""Constructors take text with units in the place of numbers in SI."""

from __future__ import annotations

import math
from typing import Any

import pytest

import catopt
from catopt.errors import InputError
from catopt.model import (
    Anchor,
    Body,
    Buoy,
    Checks,
    ClumpWeightChoice,
    CurrentProfile,
    Design,
    DesignLoad,
    Dynamics,
    LoadCase,
    SegmentChoice,
    Service,
    SinkerChoice,
    WaveTrain,
)

UNTYPED: Any = catopt
"""The package as to those who do not check types: arguments are annotated as numbers."""
TF = 9806.65
"""N in a tonne-force."""

TAKEN: list[tuple[Any, dict[str, Any], dict[str, Any]]] = [
    (
        catopt.Segment,
        {"length": "200 m", "submerged_weight": "9.5 kgf/m", "EA": "80 MN", "mass": "10.9 kg/m",
         "MBL": "343 kN", "nominal_diameter": "95 mm", "price": "120 USD/m",
         "wear_rate": "0.4 mm/year"},
        {"length": 200.0, "submerged_weight": 9.5 * 9.80665, "EA": 8e7, "mass": 10.9,
         "MBL": 343e3, "nominal_diameter": 0.095, "price": 120.0,
         "wear_rate": 0.4e-3 / (365.25 * 86400.0)},
    ),
    (
        catopt.PointLoad,
        {"position": "7 m", "submerged_weight": "2 tf", "mass": "3 t"},
        {"position": 7.0, "submerged_weight": 2.0 * TF, "mass": 3000.0},
    ),
    (catopt.Site, {"water_depth": "9,5 m"}, {"water_depth": 9.5}),
    (catopt.Load, {"horizontal_force": "0.343 tf"}, {"horizontal_force": 0.343 * TF}),
    (catopt.Load, {"span": "17.4 m"}, {"span": 17.4}),
    (
        LoadCase,
        {"name": "storm", "horizontal_force": "450 kN", "water_level": "-50 cm"},
        {"horizontal_force": 450e3, "water_level": -0.5},
    ),
    (
        DesignLoad,
        {"name": "storm", "force": "100 tf", "direction": "30 deg", "fairlead_rise": "2 m"},
        {"force": 100.0 * TF, "direction": math.pi / 6.0, "fairlead_rise": 2.0},
    ),
    (
        SegmentChoice,
        {"lengths": ("50 m", 60.0), "diameters": ("70 mm", "76 mm"), "diameter_max": "80 mm"},
        {"lengths": (50.0, 60.0), "diameters": (0.07, 0.076), "diameter_max": 0.08},
    ),
    (
        ClumpWeightChoice,
        {"masses": ("5 t",), "density": "2400 kg/m^3", "positions": ("7 m",)},
        {"masses": (5000.0,), "density": 2400.0, "positions": (7.0,)},
    ),
    (
        SinkerChoice,
        {"masses": ("5 t",), "density": "2400 kg/m^3", "friction": 0.5},
        {"masses": (5000.0,), "density": 2400.0},
    ),
    (
        Anchor,
        {"kind": "drag", "holding_capacity": "900 kN"},
        {"holding_capacity": 900e3},
    ),
    (Buoy, {"reserve_buoyancy": "12 kN"}, {"reserve_buoyancy": 12e3}),
    (
        Checks,
        {"max_anchor_uplift_angle": "3 deg", "min_grounded_length": "5 m"},
        {"max_anchor_uplift_angle": math.radians(3.0), "min_grounded_length": 5.0},
    ),
    (Service, {"life": "10 years"}, {"life": 10.0 * 365.25 * 86400.0}),
    (
        CurrentProfile,
        {"profile": "table", "depths": ("0 m", "20 m"), "speeds": ("2 kn", "1 m/s")},
        {"depths": (0.0, 20.0), "speeds": (2.0 * 1852.0 / 3600.0, 1.0)},
    ),
    (Dynamics, {"duration": "10 min", "ramp": "20 s"}, {"duration": 600.0, "ramp": 20.0}),
    (Body, {"mass": "5 t"}, {"mass": 5000.0}),
    (
        WaveTrain,
        {"spectrum": "regular", "height": "2 m", "period": "8 s"},
        {"height": 2.0, "period": 8.0},
    ),
]  # fmt: skip


@pytest.mark.parametrize(
    ("kind", "text", "wanted"), TAKEN, ids=[f"{each[0].__name__}-{each[1]}" for each in TAKEN]
)
def test_text_with_a_unit_is_read_as_the_number_it_is(
    kind: Any, text: dict[str, Any], wanted: dict[str, Any]
) -> None:
    made = kind(**text)
    for key, value in wanted.items():
        assert getattr(made, key) == pytest.approx(value, rel=1e-14), key
    assert made == kind(**{**text, **{key: getattr(made, key) for key in wanted}})


def test_a_system_is_made_of_text() -> None:
    chain, clump = UNTYPED.Segment("200 m", "1.5 kN/m"), UNTYPED.PointLoad("10 m", "20 kN")
    system = UNTYPED.System.around(
        catopt.Line([chain], [clump]),
        azimuths=["0 deg", "120 deg", "240 deg"],
        anchor_radius="180 m",
        fairlead_height="30 m",
        force=("100 kN", "-5 tf"),
        seabed_friction=0.5,
    )
    assert system.force == pytest.approx((100e3, -5.0 * TF), rel=1e-15)
    assert system.legs[1].azimuth == pytest.approx(2.0 * math.pi / 3.0, rel=1e-15)
    assert system.legs[1].fairlead_azimuth == system.legs[1].azimuth
    assert (system.legs[0].anchor_radius, system.seabed_friction) == (180.0, 0.5)


@pytest.mark.parametrize(
    ("kind", "given", "told"),
    [
        (
            catopt.Segment,
            {"length": "200 kg", "submerged_weight": "-", "MBL": "-3 kN", "mass": "1 t"},
            {"length": "a mass", "submerged_weight": "a weight per length", "MBL": "above 0",
             "mass": "a mass per length"},
        ),
        (SegmentChoice, {"lengths": ("50 m", "long")}, {"lengths[1]": "a length"}),
        (DesignLoad, {"name": "s", "force": "100 t", "headings": "12"},
         {"force": "a mass", "headings": "a whole number"}),
        (
            Design,
            {"segments": (SegmentChoice((20.0,)),), "lines": ("6",)},
            {"lines[0]": "a number"},
        ),
        (catopt.Load, {"horizontal_force": "50.000 kN"}, {"horizontal_force": "50"}),
        (CurrentProfile, {"profile": "table", "depths": (-1.0, "x")},
         {"depths[0]": "0 m or more", "depths[1]": "a length", "speeds": "missing"}),
        (CurrentProfile, {"profile": "table", "depths": ("x",), "speeds": ("y",)},
         {"depths[0]": "a length", "speeds[0]": "a speed"}),
    ],
)  # fmt: skip
def test_all_that_is_wrong_in_text_is_told_at_once(
    kind: Any, given: dict[str, Any], told: dict[str, str]
) -> None:
    with pytest.raises(InputError) as caught:
        kind(**given)
    found = {problem.key: f"{problem.found} {problem.allowed}" for problem in caught.value.problems}
    assert set(found) == set(told)
    for key, words in told.items():
        assert words in found[key]


def test_solve_takes_text_with_units() -> None:
    line = catopt.Line([UNTYPED.Segment("20 m", "9.5 kgf/m")])
    said = UNTYPED.solve(line, height="9.5 m", horizontal_force="343 kgf")
    assert said.span == catopt.solve(line, height=9.5, horizontal_force=343.0 * 9.80665).span
    with pytest.raises(InputError) as caught:
        UNTYPED.solve(line, height="9.5 kg", seabed_friction="rough", horizontal_force=1.0)
    assert [each.key for each in caught.value.problems] == ["height", "seabed_friction"]


def test_a_component_is_named_with_its_diameter_as_text() -> None:
    chain = UNTYPED.component("chain studless R4", "76 mm")
    assert chain == catopt.component("chain studless R4", 0.076)
    assert chain.segment("300 m") == chain.segment(300.0)
    with pytest.raises(InputError, match="a length is required"):
        UNTYPED.component("chain studless R4", "76 kg")
