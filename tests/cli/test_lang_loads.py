"""``catopt loads --lang vi``: what is said."""

from __future__ import annotations

import pytest

from catopt.loads.blendermann import TYPES
from catopt.loads.holding_data import SOILS
from catopt.loads.ship import PROPELLER_AREA_RATIOS
from catopt.loads.sinker import SOIL_FRICTION

from .conftest import Run
from .vietnamese import in_vietnamese

SEA = ("--wind", "25 m/s", "--current", "1 m/s", "--hs", "7 m", "--period", "12 s")
SHIP = (
    *("loads", "ship", "--length", "234 m", "--breadth", "31.3 m", "--draught", "12.4 m"),
    *("--frontal-area", "580 m^2", "--lateral-area", "1200 m^2", "--depth", "14 m"),
)
ASKED: dict[str, tuple[str, ...]] = {
    "buoy": (
        *("loads", "buoy", "pillar 1.8 m", "--depth", "12 m", *SEA),
        *("--chain", "25 mm", "--growth", "20 mm", "--pull", "3 kN"),
    ),
    "still": ("loads", "buoy", "spar 0.8 m", "--depth", "12 m", "--wind", "25 m/s"),
    "head on": (*SHIP, *SEA, "--propeller", "tanker"),
    "askew": (
        *(*SHIP, *SEA, "--current", "2 m/s", "--kind", "tanker ballast", "--drift", "largest-wave"),
        *("--wind-angle", "30 deg", "--current-angle", "45 deg", "--wave-angle", "20 deg"),
    ),
    "estimated": ("loads", "ship", "ship.toml"),
}


def test_the_words_of_loads(run: Run) -> None:
    shown = " ".join(run(*ASKED["buoy"], "--lang", "vi").out.split())
    for part in (
        "pillar 1.8 m, gió 25 m/s, dòng triều 1 m/s, Hmax 13 m",
        "dòng chảy lên xích: 1/2 rho V^2 A Cd",
        "IALA CALMAR technical reference, 27 February 2014, 5.2.1 [A]",
        "Cảnh báo: Sóng lớn nhất 12.95 m vỡ ở độ sâu 12 m với chu kỳ 12 s",
    ):
        assert part in shown
    shown = " ".join(run(*ASKED["askew"], "--lang", "vi").out.split())
    assert "gió ngang tàu" in shown
    assert "tàu dầu chạy dằn, gió lệch mũi tàu 30°" in shown


@pytest.mark.parametrize(
    "name", sorted({*TYPES, *PROPELLER_AREA_RATIOS, *SOIL_FRICTION, *SOILS, "sea state"})
)
def test_kinds_of_ship_and_soil_have_their_vietnamese(name: str) -> None:
    assert in_vietnamese(name) != name
