"""S3's and S4's forces by every method, each sum beside arithmetic written out here."""

from __future__ import annotations

import math

import pytest

from catopt.reproduce import reproduce
from catopt.reproduce.items import published
from catopt.reproduce.ship_loads import fso, fso_loads, fso_lyings


def rows(name: str) -> dict[str, tuple[str, ...]]:
    (study,) = reproduce(name).studies
    table = study.side_by_side[0]
    return {str(row[0]): tuple(map(str, row[1:])) for row in table.rows}


def test_s3_s_tanker_by_three_methods_beside_the_print() -> None:
    """22TCN: 0.59 x 388.12 x 1.44 = 329.7; 49.0e-5 x 582.18 x 400 x 0.9496 = 108.4 kN."""
    found = rows("tanker_20m_loads")
    assert found == {
        "UFC-Blendermann": ("128.0", "66.1", "94.0", "288.0", "C"),
        "UFC-4-159-03": ("99.5", "66.1", "94.0", "259.6", "R"),
        "22TCN-222-95": ("108.4", "329.7", "-", "438.1", "R"),
        "S3": ("-", "-", "-", "450", "-"),
    }
    (study,) = reproduce("tanker_20m_loads").studies
    said = "438 kN with 330 kN of current and 108 kN of wind alone, 2.6 % below the print"
    assert said in study.findings[0]


def test_s4_s_fso_by_hand() -> None:
    """In ballast, T = 6.1 m, all from ahead.

    Wind: 1/2 x 1.221 x 37.4^2 = 853.94 Pa x 798 m2 x 0.75 = 511.1 kN; UFC 0.70: 477.0 kN;
    22TCN: xi at 32 m 1 - 0.2 x 7/25 = 0.944; 49.0e-5 x 798 x 1398.76 x 0.944 = 516.3 kN.
    Current: 1/2 x 1025 x 1.47^2 = 1107.46 Pa; form x 32 x 6.1 x 0.1 = 21.62 kN; S = 1.7 x 6.1 x 186
    + 0.72 x 186 x 32 = 6214.3 m2, Rn = 1.47 x 186/1.19e-6 = 2.298e8, C = 0.075/6.3613^2 =
    0.0018534, 12.76 kN; propeller 186 x 32/270/0.838 = 26.306 m2, 29.13 kN; together 63.5 kN.
    22TCN: 0.59 x 195.2 x 2.1609 = 248.9 kN.
    Waves: m = 8.48^2/16 = 4.4944 m2; k tanh(56 k) = 0.040257, k = 0.041062; 2 k d = 4.599,
    D = 1 + 4.599/sinh(4.599) = 1.0925; 1025 x g x 4.4944 x 1.0925 x 32 = 1579 kN.
    """
    found = rows("fso_rang_dong_loads")
    assert found["UFC-Blendermann, ballast"] == ("511.1", "63.5", "1579.3", "2153.9", "C")
    assert found["UFC-4-159-03, ballast"] == ("477.0", "63.5", "1579.3", "2119.9", "R")
    assert found["22TCN-222-95, ballast"] == ("516.3", "248.9", "-", "765.2", "R")
    assert found["S4"] == ("-", "-", "-", "4281", "-")
    assert len(found) == 7


def test_s4_s_fso_when_the_current_comes_from_another_side() -> None:
    """At the heading that was found the moments about the bow cancel, each worked out here.

    Loaded, current 60 deg off wind and waves, everything 93 m aft of the turret: wind at
    0.18 x 186 x (pi/2 - |g|), current at 186 (-0.291 + 0.00353 (180 - |theta|)), drift amidships.
    """
    source = published("fso_rang_dong_loads")
    loaded, ballast = fso_lyings(source, 60.0)
    seen = loaded.headings
    moments = []
    for kind, angle in (("wind", seen.wind), ("current", seen.current), ("wave drift", seen.waves)):
        (sway,) = (
            each.force
            for each in loaded.loads.components
            if each.kind == kind and each.axis == "sway"
        )
        at = {
            "wind": 0.18 * 186.0 * (0.5 * math.pi - abs(angle)),
            "current": 186.0 * (-0.291 + 0.00353 * (180.0 - abs(math.degrees(angle)))),
            "wave drift": 0.0,
        }[kind]
        moments.append(sway * (at - 93.0))
    # Double precision of the heading, and of moments of some 1e8 N m.
    assert abs(sum(moments)) < 1e-9 * max(map(abs, moments))
    assert 0.0 < loaded.heading < math.radians(60.0)
    assert ballast.heading < loaded.heading
    collinear = [each.loads.horizontal_force for each in fso_lyings(source, 0.0)]
    # The headings come by halving, to double precision.
    sums = [
        found.horizontal_force
        for found in (fso_loads(source, each, "UFC-Blendermann") for each in ("loaded", "ballast"))
    ]
    assert collinear == pytest.approx(sums, rel=1e-12)
    (study,) = reproduce("fso_rang_dong_loads").studies
    assert len(study.side_by_side[1].rows) == 14


def test_the_second_weather_does_not_reach_the_printed_force_either() -> None:
    """0.74 m/s from 0 to 180 deg: 3,171 kN at 90 deg, at most 3,277; Table 4.7 has 4,281."""
    (study,) = reproduce("fso_rang_dong_loads").studies
    table = {row[0]: float(row[-1]) for row in study.side_by_side[1].rows}
    assert table["loaded, 90 deg"] == pytest.approx(3171.0, abs=0.5)
    assert max(table.values()) == table["loaded, 120 deg"] < 4281.0
    assert "at most, at 120 deg" in study.findings[0]
    assert "not at hand" not in study.findings[0]
    assert {item.method for item in study.items} == {"Table 4.7"}


def test_the_lateral_area_of_the_loaded_fso_is_not_the_misprint() -> None:
    """2973 - 186 x (12.5 - 6.1) = 1782.6 m2."""
    source = published("fso_rang_dong_loads")
    # Double precision of a sum of four digits.
    assert fso(source, "loaded").lateral_area == pytest.approx(1782.6, abs=1e-9)
    (study,) = reproduce("fso_rang_dong_loads").studies
    assert "1783 m2 is taken" in study.findings[1]
    (item,) = study.items
    assert (item.printed.text, item.judgement.computed_text) == ("4281", "2154")
